noinst_LIBRARIES += libstudy.a
libstudy_a_SOURCES = \
	src/study/charts.c src/study/charts.h \
	src/study/draw.c src/study/draw.h \
	src/study/evidence.c \
	src/study/fit.c src/study/fit.h \
	src/study/fit_inputs.c \
	src/study/fit_text.c \
	src/study/inputs.c \
	src/study/limit.c src/study/limit.h \
	src/study/mc.c \
	src/study/mc_data.c src/study/mc_grid.c src/study/mc_grid.h \
	src/study/mc_text.c \
	src/study/ruled.c \
	src/study/study.h
libstudy_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS) $(GSL_CFLAGS) $(NLOPT_CFLAGS)

studydir = $(pkgdatadir)/study
dist_study_DATA = share/study/scatter.json
