noinst_LIBRARIES += libcmd.a
libcmd_a_SOURCES = \
	src/cmd/cmd.h
libcmd_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
