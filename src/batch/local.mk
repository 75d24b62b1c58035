noinst_LIBRARIES += libbatch.a
libbatch_a_SOURCES = \
	src/batch/batch.h \
	src/batch/batch_priv.h \
	src/batch/data.c \
	src/batch/feed.c src/batch/feed.h \
	src/batch/options.c src/batch/options.h \
	src/batch/output.c \
	src/batch/pair.c src/batch/pair.h \
	src/batch/pool.c src/batch/pool.h \
	src/batch/resume.c src/batch/resume.h \
	src/batch/run.c \
	src/batch/shared.c \
	src/batch/stack.c
# where the data are: of a build in its source tree, and once installed (data.c)
libbatch_a_CPPFLAGS = $(AM_CPPFLAGS) -DPKGDATADIR='"$(pkgdatadir)"' \
	-DSRCDIR='"$(CR_SRCDIR)"' -DBUILDDIR='"$(abs_builddir)"'
libbatch_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
