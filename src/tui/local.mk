noinst_LIBRARIES += libtui.a
libtui_a_SOURCES = \
	src/tui/frame.c src/tui/frame.h \
	src/tui/ground.c src/tui/ground.h \
	src/tui/history.c \
	src/tui/input.c \
	src/tui/keys.c \
	src/tui/lesson.c \
	src/tui/log.c \
	src/tui/look.c \
	src/tui/main.c \
	src/tui/mouse.c \
	src/tui/overlay.c \
	src/tui/paint.c \
	src/tui/paste.c \
	src/tui/play.c \
	src/tui/pointer.c \
	src/tui/preview.c \
	src/tui/prompt.c \
	src/tui/run.c \
	src/tui/screen.c \
	src/tui/stderr.c \
	src/tui/sweep.c \
	src/tui/term.c \
	src/tui/tui.h src/tui/tui_priv.h \
	src/tui/zoom.c
libtui_a_CFLAGS = $(CR_CFLAGS) $(NCURSES_CFLAGS) $(READLINE_CFLAGS)
