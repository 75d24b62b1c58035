# unit tests of src/result
result_tests = test_result_pulse test_result_deform test_result_irf test_result_measure \
	test_result_rating test_result_run test_result_signal test_result_heights test_result_motion \
	test_result_planar test_result_impact test_barrier
result_test_libs = libresult.a libscene.a libsolver.a libmodel.a libbase.a \
	$(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
check_PROGRAMS += $(result_tests)
TESTS += $(result_tests)
test_barrier_SOURCES = tests/unit/test_barrier.c tests/unit/result_models.h tests/unit/model_lib.h
test_barrier_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_barrier_LDADD = $(result_test_libs)
test_result_planar_SOURCES = tests/unit/test_result_planar.c
test_result_planar_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_planar_LDADD = $(result_test_libs)
test_result_pulse_SOURCES = tests/unit/test_result_pulse.c
test_result_pulse_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_pulse_LDADD = $(result_test_libs)
test_result_deform_SOURCES = tests/unit/test_result_deform.c
test_result_deform_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_deform_LDADD = $(result_test_libs)
test_result_irf_SOURCES = tests/unit/test_result_irf.c
test_result_irf_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_irf_LDADD = $(result_test_libs)
test_result_measure_SOURCES = tests/unit/test_result_measure.c
test_result_measure_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_measure_LDADD = $(result_test_libs)
TESTS += tests/schema_result.sh
EXTRA_DIST += tests/schema_result.sh
test_result_rating_SOURCES = tests/unit/test_result_rating.c
test_result_rating_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_rating_LDADD = $(result_test_libs)
test_result_signal_SOURCES = tests/unit/test_result_signal.c
test_result_signal_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_signal_LDADD = $(result_test_libs)
test_result_run_SOURCES = tests/unit/test_result_run.c tests/unit/result_models.h tests/unit/model_lib.h
test_result_run_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(CJSON_CFLAGS)
test_result_run_LDADD = $(result_test_libs)
test_result_heights_SOURCES = tests/unit/test_result_heights.c tests/unit/result_models.h tests/unit/model_lib.h
test_result_heights_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_heights_LDADD = $(result_test_libs)
test_result_motion_SOURCES = tests/unit/test_result_motion.c tests/unit/result_models.h tests/unit/model_lib.h
test_result_motion_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_motion_LDADD = $(result_test_libs)
test_result_impact_SOURCES = tests/unit/test_result_impact.c
test_result_impact_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_impact_LDADD = $(result_test_libs)
