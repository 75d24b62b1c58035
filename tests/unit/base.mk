# unit tests of src/base
check_PROGRAMS += test_base
TESTS += test_base
test_base_SOURCES = tests/unit/test_base.c
test_base_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(CJSON_CFLAGS)
test_base_LDADD = libbase.a $(CMOCKA_LIBS) $(NETTLE_LIBS) $(CJSON_LIBS)
check_PROGRAMS += test_stats
TESTS += test_stats
test_stats_SOURCES = tests/unit/test_stats.c
test_stats_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_stats_LDADD = libbase.a $(CMOCKA_LIBS)
check_PROGRAMS += test_csv
TESTS += test_csv
test_csv_SOURCES = tests/unit/test_csv.c
test_csv_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_csv_LDADD = libbase.a $(CMOCKA_LIBS)
