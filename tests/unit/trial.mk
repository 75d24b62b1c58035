# unit tests of src/trial
check_PROGRAMS += test_verdict
TESTS += test_verdict
test_verdict_SOURCES = tests/unit/test_verdict.c tests/unit/refused.h
test_verdict_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_verdict_LDADD = libtrial.a libcli.a libfigure.a librender.a libresult.a libscene.a libsolver.a \
	libmodel.a libprocess.a libbase.a $(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS) $(CAIRO_LIBS)
TESTS += tests/cli/validate.sh
EXTRA_DIST += tests/cli/validate.sh
