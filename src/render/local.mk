noinst_LIBRARIES += librender.a
librender_a_SOURCES = \
	src/render/render.h src/render/render_priv.h \
	src/render/assumed.c \
	src/render/axis.c \
	src/render/body_view.c \
	src/render/cells.c \
	src/render/dots.c \
	src/render/draw.c \
	src/render/field.c \
	src/render/glyph.c \
	src/render/heat.c \
	src/render/impacts.c \
	src/render/layout.c src/render/layout.h \
	src/render/map.c \
	src/render/marks.c \
	src/render/page.c \
	src/render/panes.c src/render/panes.h \
	src/render/picture.c src/render/picture.h \
	src/render/plot.c \
	src/render/project.c src/render/project.h \
	src/render/pulse.c \
	src/render/report.c src/render/report.h \
	src/render/report_phases.c \
	src/render/results_pane.c \
	src/render/robust.c \
	src/render/screen.c src/render/screen.h \
	src/render/state.c \
	src/render/table.c src/render/table.h \
	src/render/theme.c src/render/theme.h \
	src/render/words.c
librender_a_CFLAGS = $(CR_CFLAGS)
