noinst_LIBRARIES += librepl.a
librepl_a_SOURCES = \
	src/repl/main.c \
	src/repl/options.c \
	src/repl/prompt.c \
	src/repl/repl.h src/repl/repl_priv.h \
	src/repl/terminal.c
librepl_a_CFLAGS = $(CR_CFLAGS) $(READLINE_CFLAGS)
