noinst_LIBRARIES += libtui.a
libtui_a_SOURCES = \
	src/tui/tui.h
libtui_a_CFLAGS = $(CR_CFLAGS) $(NCURSES_CFLAGS) $(READLINE_CFLAGS)
