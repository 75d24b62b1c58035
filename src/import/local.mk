noinst_LIBRARIES += libimport.a
libimport_a_SOURCES = \
	src/import/case.c \
	src/import/contact.c \
	src/import/csv.c \
	src/import/edr.c \
	src/import/folder.c \
	src/import/import.c src/import/import.h src/import/import_priv.h \
	src/import/output.c \
	src/import/part.c \
	src/import/pcm.c src/import/pcm_csv.c src/import/pcm_csv.h \
	src/import/reader.h \
	src/import/scene.c \
	src/import/sql.c src/import/sql.h
libimport_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS) $(NETTLE_CFLAGS) $(SQLITE3_CFLAGS)
