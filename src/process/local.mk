noinst_LIBRARIES += libprocess.a
libprocess_a_SOURCES = \
	src/process/clock.c src/process/clock.h \
	src/process/signals.c src/process/signals.h
libprocess_a_CFLAGS = $(CR_CFLAGS)
