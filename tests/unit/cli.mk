# unit tests of src/cli
check_PROGRAMS += test_options
TESTS += test_options
test_options_SOURCES = tests/unit/test_options.c
test_options_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_options_LDADD = libcli.a libprocess.a libbase.a $(CMOCKA_LIBS) $(NETTLE_LIBS)
TESTS += tests/cli/cluster.sh tests/cli/modules.sh tests/cli/stack.sh tests/cli/study.sh
EXTRA_DIST += tests/cli/cluster.sh tests/cli/modules.sh tests/cli/stack.sh tests/cli/study.sh
