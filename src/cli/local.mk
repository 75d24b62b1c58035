noinst_LIBRARIES += libcli.a
libcli_a_SOURCES = \
	src/cli/catalogue.c \
	src/cli/cli.h \
	src/cli/complete.c \
	src/cli/damage.c \
	src/cli/data.c \
	src/cli/diff.c \
	src/cli/feed.c src/cli/feed.h \
	src/cli/fit.c \
	src/cli/import.c \
	src/cli/mc.c \
	src/cli/models.c src/cli/models.h src/cli/models_list.c \
	src/cli/options.c src/cli/options.h \
	src/cli/output.c \
	src/cli/merge.c \
	src/cli/pair.c src/cli/pair.h \
	src/cli/part.c src/cli/part.h \
	src/cli/record.c src/cli/record.h \
	src/cli/pictures.c src/cli/pictures.h \
	src/cli/resume.c src/cli/resume.h \
	src/cli/rows.c src/cli/rows.h \
	src/cli/run.c \
	src/cli/schema.c \
	src/cli/shared.c \
	src/cli/sink.c src/cli/sink.h \
	src/cli/solve.c \
	src/cli/stack.c \
	src/cli/study.c src/cli/study.h src/cli/study_priv.h \
	src/cli/study_picture.c \
	src/cli/study_plot.c \
	src/cli/word.h
# where the data are: of a build in its source tree, and once installed (data.c)
libcli_a_CPPFLAGS = $(AM_CPPFLAGS) -DPKGDATADIR='"$(pkgdatadir)"'
# tells a program that was not installed where its source tree is; no path is in the program itself
noinst_DATA = source-folder
CLEANFILES += source-folder
source-folder: Makefile
	$(AM_V_GEN)echo '$(CR_SRCDIR)' >$@
# the commit of the sources, where they are a checkout; written anew only when it changed
nodist_libcli_a_SOURCES = commit.c
CLEANFILES += commit.c commit.new
commit.c: always
	$(AM_V_at)commit=`cd '$(srcdir)' && test -e .git && git rev-parse --short=12 HEAD 2>/dev/null` || :; \
	if test -n "$$commit" && (cd '$(srcdir)' && ! git diff-index --quiet HEAD --) 2>/dev/null; then \
	    commit="$$commit-changed"; fi; \
	printf '%s\n' '#include "cli/cli.h"' "const char cr_commit[] = \"$$commit\";" >commit.new
	$(AM_V_at)cmp -s commit.new $@ || cp commit.new $@; rm -f commit.new
.PHONY: always
always:
libcli_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
clusterdir = $(pkgdatadir)/cluster
dist_cluster_SCRIPTS = share/cluster/parallel.sh share/cluster/slurm-array.sbatch
