noinst_LIBRARIES += libfigure.a
libfigure_a_SOURCES = \
	src/figure/axes.c \
	src/figure/body.c \
	src/figure/cairo.c \
	src/figure/cast.c \
	src/figure/channels.c \
	src/figure/forms.h src/figure/motion.c \
	src/figure/solid.c \
	src/figure/canvas.c src/figure/canvas.h src/figure/canvas_priv.h \
	src/figure/charts.c \
	src/figure/damage.c \
	src/figure/figure.h \
	src/figure/ink.c src/figure/ink.h \
	src/figure/pictures.c src/figure/pictures.h \
	src/figure/plan.c src/figure/plan.h \
	src/figure/plan_marks.c \
	src/figure/plot.c \
	src/figure/svg.c
libfigure_a_CFLAGS = $(CR_CFLAGS) $(CAIRO_CFLAGS)
