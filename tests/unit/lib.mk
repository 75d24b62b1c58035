# unit tests of src/lib
check_PROGRAMS += test_lib
TESTS += test_lib
test_lib_SOURCES = tests/unit/test_lib.c
test_lib_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_lib_LDADD = $(CR_LIB_LIBS) $(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS) $(CR_IMPORT_LIBS)
