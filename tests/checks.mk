# checks of the tree as a whole
tree_checks = tests/check_bootstrap.sh tests/check_circles.sh tests/check_examples.sh \
	tests/check_hardening.sh \
	tests/check_includes.sh tests/check_manual.sh tests/check_map.sh tests/check_sources.sh \
	tests/check_style.sh tests/check_symbols.sh tests/check_types.sh
cli_checks = tests/cli/bad_scene.sh tests/cli/budget.sh tests/cli/completion.sh \
	tests/cli/diff.sh \
	tests/cli/faults.sh tests/cli/files.sh \
	tests/cli/hostile.sh tests/cli/install.sh tests/cli/interrupt.sh tests/cli/mirror.sh tests/cli/random.sh \
	tests/cli/run.sh \
	tests/cli/same_bits.sh \
	tests/cli/usage.sh
TESTS += $(tree_checks) $(cli_checks)
EXTRA_DIST += $(tree_checks) $(cli_checks) tests/cases/hostile tests/tap.sh tests/terminal.sh tests/cli/cli.sh

# the examples of README.md as the program prints them today; review the difference
update-examples: crumple$(EXEEXT)
	SRC='$(abs_srcdir)' BUILD='$(abs_builddir)' LC_ALL=C.UTF-8 \
	    $(SHELL) $(srcdir)/tests/check_examples.sh update
.PHONY: update-examples

# the expected lines of the command tests, and the pictures, as they are today; to be reviewed
update-golden: crumple$(EXEEXT) $(golden_pictures)
	SRC='$(abs_srcdir)' CRUMPLE='$(abs_builddir)/crumple$(EXEEXT)' LC_ALL=C.UTF-8 \
	    TERM=xterm-256color $(SHELL) $(srcdir)/tests/golden/cmd/run.sh update
	SRC='$(abs_srcdir)' CRUMPLE='$(abs_builddir)/crumple$(EXEEXT)' LC_ALL=C.UTF-8 \
	    $(SHELL) $(srcdir)/tests/tui/lessons.sh update
.PHONY: update-golden update-pictures

# the table of the validation page, 1 minute; to be reviewed
update-validation: crumple$(EXEEXT)
	SRC='$(abs_srcdir)' CRUMPLE='$(abs_builddir)/crumple$(EXEEXT)' LC_ALL=C.UTF-8 \
	    $(SHELL) $(srcdir)/tests/update_validation.sh
.PHONY: update-validation
EXTRA_DIST += tests/update_validation.sh

# the manual pages of the commands, from their table, and of the library, from its header
EXTRA_DIST += tests/lib_manual.sh tests/lib_user.c
TESTS += tests/bindings/bindings.sh
EXTRA_DIST += tests/bindings/bindings.sh tests/bindings/solve.py
check_PROGRAMS += crumple-manual
crumple_manual_SOURCES = tests/manual.c
crumple_manual_CFLAGS = $(CR_CFLAGS)
crumple_manual_LDADD = libcmd.a libstudy.a libfigure.a libdamage.a librender.a libresult.a libscene.a libsolver.a \
	libmodel.a libprocess.a libbase.a $(GSL_LIBS) $(NLOPT_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS) $(CAIRO_LIBS)
update-manual: crumple-manual$(EXEEXT)
	./crumple-manual$(EXEEXT) >$(srcdir)/man/crumple-commands.7
	$(SHELL) $(srcdir)/tests/lib_manual.sh $(srcdir)/src/lib/crumple.h >$(srcdir)/man/libcrumple.3
.PHONY: update-manual

# static analysis of each file by clang-tidy (.clang-tidy) and gcc -fanalyzer, an hour; what they say is to be judged
analyze_flags = -std=c11 $(DEFS) $(DEFAULT_INCLUDES) $(AM_CPPFLAGS) $(NCURSES_CFLAGS) $(CAIRO_CFLAGS) \
	-DPKGDATADIR='""' -DPKGLIBEXECDIR='""'
analyze: config.h
	for file in $(srcdir)/src/*.c $(srcdir)/src/*/*.c; do \
	    clang-tidy --quiet $$file -- $(analyze_flags); \
	    gcc $(analyze_flags) -O1 -fanalyzer -c -o /dev/null $$file; \
	done
.PHONY: analyze

# what each file is for, in its own words
map:
	cd $(srcdir) && $(SHELL) tests/map.sh
.PHONY: map
EXTRA_DIST += tests/map.sh

validate: crumple$(EXEEXT)
	./crumple$(EXEEXT) validate
	-CRUMPLE_DATA='$(abs_srcdir)' python3 $(srcdir)/tests/bench/continuity.py ./crumple$(EXEEXT) \
	    --n 400
.PHONY: validate

# the unit tests, the fuzz corpora and the command line again in a build with sanitizers
sanitized_checks = tests/cli/bad_scene.sh tests/cli/files.sh \
	tests/cli/run.sh tests/cli/same_bits.sh \
	tests/cli/usage.sh
check-sanitizers: crumple$(EXEEXT)
	$(MKDIR_P) sanitizers
	case '$(srcdir)' in /*) src='$(srcdir)' ;; *) src='../$(srcdir)' ;; esac; cd sanitizers && \
	    { test -f Makefile || "$$src/configure" -q --enable-sanitizers CFLAGS='-g -O1'; }
	tests='$(sanitized_checks)'; for name in $(check_PROGRAMS); do \
	    case $$name in test_* | fuzz_*) tests="$$tests $$name" ;; esac; \
	done; \
	cd sanitizers && REFERENCE='$(abs_builddir)/crumple$(EXEEXT)' $(MAKE) -s check TESTS="$$tests"
.PHONY: check-sanitizers

# the rule of threads of libcrumple: its tests under ThreadSanitizer, in a build of their own
check-threads:
	$(MKDIR_P) threads
	case '$(srcdir)' in /*) src='$(srcdir)' ;; *) src='../$(srcdir)' ;; esac; cd threads && \
	    { test -f Makefile || "$$src/configure" -q --enable-sanitizers=thread CFLAGS='-g -O1'; }
	cd threads && $(MAKE) -s test_lib && $(MAKE) -s check check_PROGRAMS=test_lib TESTS=test_lib
.PHONY: check-threads

clean-local:
	rm -rf sanitizers threads fuzzing

# the command language: each command with its success and its errors, the lessons, the prompt
golden_checks = tests/golden/cmd/run.sh tests/golden/cmd/lessons.sh tests/golden/cmd/prompt.sh \
	tests/golden/cmd/sources.sh tests/golden/cmd/update.sh
TESTS += $(golden_checks)
EXTRA_DIST += $(golden_checks) \
	tests/golden/cmd/scene.test \
	tests/golden/cmd/language.test \
	tests/golden/cmd/solve.test \
	tests/golden/cmd/study.test \
	tests/golden/cmd/pulse.csv \
	tests/golden/cmd/measured.json \
	tests/golden/cmd/bad.json \
	tests/golden/cmd/pair.crumple \
	tests/golden/cmd/bad.crumple \
	tests/golden/cmd/loop.crumple

# a library that refuses calls of the system, for tests/cli/faults.sh
check_DATA = fault.so
fault.so: $(srcdir)/tests/fault.c
	$(AM_V_CC)$(CC) $(CR_CPPFLAGS) -O1 -fPIC -shared -o $@ '$(srcdir)/tests/fault.c' -ldl || : >/dev/null
EXTRA_DIST += tests/fault.c
CLEANFILES += fault.so
