noinst_LIBRARIES += libimport.a
libimport_a_SOURCES = \
	src/import/case.c \
	src/import/commonroad.c \
	src/import/contact.c \
	src/import/csv.c \
	src/import/edr.c \
	src/import/erg.c src/import/erg_info.c src/import/erg_priv.h \
	src/import/esmini.c \
	src/import/ev5.c \
	src/import/folder.c \
	src/import/formula.c src/import/formula.h \
	src/import/import.c src/import/import.h src/import/import_priv.h \
	src/import/mme.c \
	src/import/options.c \
	src/import/output.c \
	src/import/part.c \
	src/import/pcm.c src/import/pcm_csv.c src/import/pcm_csv.h \
	src/import/reader.h \
	src/import/scene.c \
	src/import/sql.c src/import/sql.h \
	src/import/sumo.c \
	src/import/xml.c src/import/xml.h src/import/xml_node.c \
	src/import/xosc.c src/import/xosc_catalogue.c src/import/xosc_entity.c src/import/xosc_motion.c \
	src/import/xosc_path.c src/import/xosc_priv.h src/import/xosc_story.c src/import/xosc_value.c \
	src/import/zip.c
libimport_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS) $(NETTLE_CFLAGS) $(EXPAT_CFLAGS) $(SQLITE3_CFLAGS) $(LIBZIP_CFLAGS)
