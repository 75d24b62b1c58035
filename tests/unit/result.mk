# unit tests of src/result
check_PROGRAMS += test_result_pulse
TESTS += test_result_pulse
test_result_pulse_SOURCES = tests/unit/test_result_pulse.c
test_result_pulse_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_result_pulse_LDADD = libresult.a libbase.a $(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
