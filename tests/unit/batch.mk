# unit tests of src/batch
check_PROGRAMS += test_options
TESTS += test_options
test_options_SOURCES = tests/unit/test_options.c
test_options_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_options_LDADD = libbatch.a libbase.a $(CMOCKA_LIBS) $(NETTLE_LIBS)
TESTS += tests/cli/stack.sh
EXTRA_DIST += tests/cli/stack.sh
check_PROGRAMS += test_verdict
TESTS += test_verdict
test_verdict_SOURCES = tests/unit/test_verdict.c
test_verdict_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_verdict_LDADD = libbatch.a librender.a libresult.a libscene.a libsolver.a libmodel.a libbase.a \
	$(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
TESTS += tests/cli/validate.sh
EXTRA_DIST += tests/cli/validate.sh
