# checks of the tree as a whole
tree_checks = tests/check_bootstrap.sh tests/check_includes.sh tests/check_map.sh \
	tests/check_symbols.sh
cli_checks = tests/cli/bad_scene.sh tests/cli/completion.sh tests/cli/files.sh \
	tests/cli/install.sh tests/cli/interrupt.sh tests/cli/run.sh tests/cli/same_bits.sh \
	tests/cli/usage.sh
TESTS += $(tree_checks) $(cli_checks)
EXTRA_DIST += $(tree_checks) $(cli_checks) tests/tap.sh tests/check_examples.sh \
	tests/check_style.sh tests/cli/cli.sh

# the examples of README.md as the program prints them today; review the difference
update-examples: crumple$(EXEEXT)
	SRC='$(abs_srcdir)' BUILD='$(abs_builddir)' LC_ALL=C.UTF-8 \
	    $(SHELL) $(srcdir)/tests/check_examples.sh update
.PHONY: update-examples

# the unit tests, the fuzz corpora and the command line again in a build with sanitizers
sanitized_checks = $(check_PROGRAMS) tests/cli/bad_scene.sh tests/cli/files.sh \
	tests/cli/run.sh tests/cli/same_bits.sh \
	tests/cli/usage.sh
check-sanitizers: crumple$(EXEEXT)
	$(MKDIR_P) sanitizers
	case '$(srcdir)' in /*) src='$(srcdir)' ;; *) src='../$(srcdir)' ;; esac; cd sanitizers && \
	    { test -f Makefile || "$$src/configure" -q --enable-sanitizers CFLAGS='-g -O1'; }
	cd sanitizers && REFERENCE='$(abs_builddir)/crumple$(EXEEXT)' $(MAKE) -s check \
	    TESTS='$(sanitized_checks)'
.PHONY: check-sanitizers

clean-local:
	rm -rf sanitizers fuzzing
