noinst_LIBRARIES += librender.a
librender_a_SOURCES = \
	src/render/render.h
librender_a_CFLAGS = $(CR_CFLAGS)
