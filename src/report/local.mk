noinst_LIBRARIES += libreport.a
libreport_a_SOURCES = \
	src/report/document.c src/report/document.h \
	src/report/german.h \
	src/report/html.c src/report/order.h \
	src/report/pages.c \
	src/report/report.c src/report/report.h \
	src/report/section_annex.c \
	src/report/section_checks.c \
	src/report/section_head.c \
	src/report/section_inputs.c \
	src/report/section_pictures.c \
	src/report/sections.h \
	src/report/units.c \
	src/report/validity.h \
	src/report/warnings.c \
	src/report/words.c
libreport_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
