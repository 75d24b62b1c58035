noinst_LIBRARIES += libbatch.a
libbatch_a_SOURCES = \
	src/batch/batch.h
libbatch_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
