noinst_LIBRARIES += libresult.a
libresult_a_SOURCES = \
	src/result/result.h
libresult_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
