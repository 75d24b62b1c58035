# fuzz targets: make check replays the corpus, make fuzz mutates it with libFuzzer (clang)
fuzz_targets = fuzz_cmd fuzz_model fuzz_scene
fuzz_ldadd = libscene.a libsolver.a libmodel.a libprocess.a libbase.a $(CJSON_LIBS) $(NETTLE_LIBS)
EXTRA_PROGRAMS += fuzz_scene fuzz_model fuzz_cmd
fuzz_cmd_SOURCES = tests/fuzz/fuzz_cmd.c tests/fuzz/fuzz.h
fuzz_cmd_CFLAGS = $(CR_CFLAGS)
fuzz_cmd_LDADD = libcmd.a libstudy.a libfigure.a libdamage.a librender.a libresult.a $(fuzz_ldadd) $(GSL_LIBS) $(NLOPT_LIBS) \
	$(CAIRO_LIBS)
fuzz_scene_SOURCES = tests/fuzz/fuzz_scene.c tests/fuzz/fuzz.h
fuzz_scene_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
fuzz_scene_LDADD = $(fuzz_ldadd)
fuzz_model_SOURCES = tests/fuzz/fuzz_model.c tests/fuzz/fuzz.h tests/fuzz/scratch.h
fuzz_model_CFLAGS = $(CR_CFLAGS)
fuzz_model_LDADD = $(fuzz_ldadd)
# readers of files, results and whole solves
fuzz_files = fuzz_signal fuzz_table fuzz_feed fuzz_data fuzz_crash fuzz_import fuzz_records fuzz_folder fuzz_register
fuzz_files_ldadd = libtrial.a libcli.a libstudy.a libfigure.a libdamage.a librender.a libresult.a \
	$(fuzz_ldadd) $(GSL_LIBS) $(NLOPT_LIBS) $(CAIRO_LIBS)
EXTRA_PROGRAMS += $(fuzz_files)
fuzz_signal_SOURCES = tests/fuzz/fuzz_signal.c tests/fuzz/fuzz.h tests/fuzz/scratch.h
fuzz_signal_CFLAGS = $(CR_CFLAGS)
fuzz_signal_LDADD = $(fuzz_files_ldadd)
fuzz_table_SOURCES = tests/fuzz/fuzz_table.c tests/fuzz/fuzz.h tests/fuzz/scratch.h
fuzz_table_CFLAGS = $(CR_CFLAGS)
fuzz_table_LDADD = $(fuzz_files_ldadd)
fuzz_feed_SOURCES = tests/fuzz/fuzz_feed.c tests/fuzz/fuzz.h tests/fuzz/scratch.h
fuzz_feed_CFLAGS = $(CR_CFLAGS)
fuzz_feed_LDADD = $(fuzz_files_ldadd)
fuzz_data_SOURCES = tests/fuzz/fuzz_data.c tests/fuzz/fuzz.h tests/fuzz/scratch.h
fuzz_data_CFLAGS = $(CR_CFLAGS)
fuzz_data_LDADD = $(fuzz_files_ldadd)
fuzz_crash_SOURCES = tests/fuzz/fuzz_crash.c tests/fuzz/fuzz.h tests/fuzz/scratch.h
fuzz_crash_CFLAGS = $(CR_CFLAGS)
fuzz_crash_LDADD = $(fuzz_files_ldadd)
fuzz_import_SOURCES = tests/fuzz/fuzz_import.c tests/fuzz/fuzz.h tests/fuzz/scene.h tests/fuzz/scratch.h
fuzz_import_CFLAGS = $(CR_CFLAGS)
fuzz_import_LDADD = libimport.a $(fuzz_files_ldadd) $(CR_IMPORT_LIBS)
fuzz_records_SOURCES = tests/fuzz/fuzz_records.c tests/fuzz/fuzz.h
fuzz_records_CFLAGS = $(CR_CFLAGS)
fuzz_records_LDADD = libimport.a libresult.a $(fuzz_ldadd)
fuzz_folder_SOURCES = tests/fuzz/fuzz_folder.c tests/fuzz/fuzz.h tests/fuzz/scene.h tests/fuzz/scratch.h
fuzz_folder_CFLAGS = $(CR_CFLAGS)
fuzz_folder_LDADD = libimport.a libresult.a $(fuzz_ldadd) $(CR_IMPORT_LIBS)
fuzz_register_SOURCES = tests/fuzz/fuzz_register.c tests/fuzz/fuzz.h tests/fuzz/scratch.h
fuzz_register_CFLAGS = $(CR_CFLAGS)
fuzz_register_LDADD = $(fuzz_ldadd)
if FUZZING
fuzz_cmd_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_scene_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_model_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_signal_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_table_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_feed_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_data_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_crash_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_import_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_records_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_folder_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
fuzz_register_LDFLAGS = $(CR_LDFLAGS) -fsanitize=fuzzer
else
fuzz_cmd_SOURCES += tests/fuzz/replay.c
fuzz_scene_SOURCES += tests/fuzz/replay.c
fuzz_model_SOURCES += tests/fuzz/replay.c
fuzz_signal_SOURCES += tests/fuzz/replay.c
fuzz_table_SOURCES += tests/fuzz/replay.c
fuzz_feed_SOURCES += tests/fuzz/replay.c
fuzz_data_SOURCES += tests/fuzz/replay.c
fuzz_crash_SOURCES += tests/fuzz/replay.c
fuzz_import_SOURCES += tests/fuzz/replay.c
fuzz_records_SOURCES += tests/fuzz/replay.c
fuzz_folder_SOURCES += tests/fuzz/replay.c
fuzz_register_SOURCES += tests/fuzz/replay.c
check_PROGRAMS += $(fuzz_targets) $(fuzz_files)
TESTS += $(fuzz_targets) $(fuzz_files)
endif
EXTRA_DIST += tests/fuzz/corpus

# Seconds per target; what is found is kept in fuzzing/. Long inputs say little that short ones do not, and take long.
# FUZZ_BUILD: how the targets are built. For very many inputs, and an input that only breaks bounds may then pass:
#   make fuzz FUZZ_BUILD="CFLAGS='-O2 -fno-sanitize-coverage=trace-cmp'"    (after rm -r fuzzing)
FUZZ_SECONDS = 60
FUZZ_BYTES = 2000
FUZZ_BUILD = --enable-sanitizers
fuzz:
	$(MKDIR_P) fuzzing
	case '$(srcdir)' in /*) src='$(srcdir)' ;; *) src='../$(srcdir)' ;; esac; cd fuzzing && \
	    { test -f Makefile || "$$src/configure" -q CC=clang --enable-fuzzing $(FUZZ_BUILD); }
	cd fuzzing && $(MAKE) $(fuzz_targets) $(fuzz_files)
	cd fuzzing && for target in scene model cmd signal table feed data crash import records folder register; do \
	    $(MKDIR_P) corpus-$$target && \
	    SRC='$(abs_srcdir)' ./fuzz_$$target -max_total_time=$(FUZZ_SECONDS) -max_len=$(FUZZ_BYTES) -timeout=10 \
	        corpus-$$target '$(abs_srcdir)'/tests/fuzz/corpus/$$target || exit 1; \
	done
.PHONY: fuzz
