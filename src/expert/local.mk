noinst_LIBRARIES += libexpert.a
libexpert_a_SOURCES = \
	src/expert/audit.c \
	src/expert/expert.h \
	src/expert/recheck.c src/expert/recheck.h \
	src/expert/report.c \
	src/expert/validity.c src/expert/validity.h
libexpert_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
