noinst_LIBRARIES += librepl.a
librepl_a_SOURCES = \
	src/repl/repl.h
librepl_a_CFLAGS = $(CR_CFLAGS) $(READLINE_CFLAGS)
