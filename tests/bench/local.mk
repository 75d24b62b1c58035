# benchmarks: make bench
EXTRA_PROGRAMS += crumple-bench
crumple_bench_SOURCES = tests/bench/bench.c
crumple_bench_CFLAGS = $(CR_CFLAGS)
crumple_bench_LDADD = libresult.a libscene.a libsolver.a libmodel.a libbase.a $(CJSON_LIBS) \
	$(NETTLE_LIBS)
EXTRA_DIST += tests/bench/wall.json tests/bench/pole.json tests/bench/same.sh \
	tests/bench/random.py tests/bench/mirror.py tests/bench/continuity.py \
	tests/bench/instructions.sh
CLEANFILES += crumple-bench

bench: crumple$(EXEEXT) crumple-bench$(EXEEXT)
	@CRUMPLE='$(abs_builddir)/crumple$(EXEEXT)' SRC='$(abs_srcdir)' ./crumple-bench
	@CRUMPLE='$(abs_builddir)/crumple$(EXEEXT)' SRC='$(abs_srcdir)' \
	    $(SHELL) $(srcdir)/tests/bench/instructions.sh
.PHONY: bench
