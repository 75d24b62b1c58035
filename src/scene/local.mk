noinst_LIBRARIES += libscene.a
libscene_a_SOURCES = \
	src/scene/scene.h
libscene_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
