# unit tests of src/catalogue
check_PROGRAMS += test_catalogue
TESTS += test_catalogue
test_catalogue_SOURCES = tests/unit/test_catalogue.c
test_catalogue_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_catalogue_LDADD = libresult.a libscene.a libsolver.a libmodel.a libbase.a \
	$(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
TESTS += tests/cli/catalogue.sh
EXTRA_DIST += tests/cli/catalogue.sh
