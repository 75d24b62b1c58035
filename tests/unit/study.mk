# unit tests of src/study, and the word mc
study_test_libs = libstudy.a libresult.a libscene.a libsolver.a libmodel.a libprocess.a libbase.a \
	$(CMOCKA_LIBS) $(GSL_LIBS) $(NLOPT_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
check_PROGRAMS += test_study
TESTS += test_study tests/cli/mc.sh tests/cli/fit.sh tests/cli/fit_back.sh
EXTRA_DIST += tests/cli/mc.sh tests/cli/fit.sh tests/cli/fit_back.sh
test_study_SOURCES = tests/unit/test_study.c $(scene_test_help)
test_study_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_study_LDADD = $(study_test_libs)
