noinst_LIBRARIES += libimport.a
libimport_a_SOURCES = \
	src/import/case.c \
	src/import/contact.c \
	src/import/csv.c \
	src/import/import.c src/import/import.h src/import/import_priv.h \
	src/import/output.c \
	src/import/part.c \
	src/import/reader.h \
	src/import/scene.c
libimport_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS) $(NETTLE_CFLAGS)
