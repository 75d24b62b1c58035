# tests of src/import
TESTS += tests/cli/import.sh
EXTRA_DIST += tests/cli/import.sh tests/cli/import_csv.sh tests/cli/import_edr.sh tests/cli/import_logs.sh \
	tests/cli/import_pcm.sh tests/cli/import_tests.sh tests/cli/import_xml.sh tests/cli/import_zip.sh \
	tests/data
check_PROGRAMS += test_import_text
TESTS += test_import_text
test_import_text_SOURCES = tests/unit/test_import_text.c tests/unit/refused.h
test_import_text_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_import_text_LDADD = libimport.a libresult.a libscene.a libsolver.a libmodel.a libbase.a $(CMOCKA_LIBS) $(CJSON_LIBS) \
	$(NETTLE_LIBS) $(CR_IMPORT_LIBS)
