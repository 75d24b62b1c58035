# fuzz targets: make check replays the corpus, make fuzz mutates it with libFuzzer (clang)
fuzz_targets = fuzz_cmd fuzz_model fuzz_scene
fuzz_ldadd = libscene.a libsolver.a libmodel.a libbase.a $(CJSON_LIBS) $(NETTLE_LIBS)
EXTRA_PROGRAMS += fuzz_scene fuzz_model fuzz_cmd
fuzz_cmd_SOURCES = tests/fuzz/fuzz_cmd.c tests/fuzz/fuzz.h
fuzz_cmd_CFLAGS = $(CR_CFLAGS)
fuzz_cmd_LDADD = libcmd.a libfigure.a libstudy.a libdamage.a librender.a libresult.a $(fuzz_ldadd) $(GSL_LIBS) $(NLOPT_LIBS) \
	$(CAIRO_LIBS)
fuzz_scene_SOURCES = tests/fuzz/fuzz_scene.c tests/fuzz/fuzz.h
fuzz_scene_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
fuzz_scene_LDADD = $(fuzz_ldadd)
fuzz_model_SOURCES = tests/fuzz/fuzz_model.c tests/fuzz/fuzz.h
fuzz_model_CFLAGS = $(CR_CFLAGS)
fuzz_model_LDADD = $(fuzz_ldadd)
if FUZZING
fuzz_cmd_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_scene_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_model_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
else
fuzz_cmd_SOURCES += tests/fuzz/replay.c
fuzz_scene_SOURCES += tests/fuzz/replay.c
fuzz_model_SOURCES += tests/fuzz/replay.c
check_PROGRAMS += $(fuzz_targets)
TESTS += $(fuzz_targets)
endif
EXTRA_DIST += tests/fuzz/corpus

# seconds per target; what is found is kept in fuzzing/
FUZZ_SECONDS = 60
fuzz:
	$(MKDIR_P) fuzzing
	case '$(srcdir)' in /*) src='$(srcdir)' ;; *) src='../$(srcdir)' ;; esac; cd fuzzing && \
	    { test -f Makefile || "$$src/configure" -q CC=clang --enable-fuzzing --enable-sanitizers; }
	cd fuzzing && $(MAKE) fuzz_scene fuzz_model fuzz_cmd
	cd fuzzing && for target in scene model cmd; do \
	    $(MKDIR_P) corpus-$$target && \
	    ./fuzz_$$target -max_total_time=$(FUZZ_SECONDS) -max_len=20000 -timeout=10 \
	        corpus-$$target '$(abs_srcdir)'/tests/fuzz/corpus/$$target || exit 1; \
	done
.PHONY: fuzz
