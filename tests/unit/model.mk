# unit tests of src/model
check_PROGRAMS += test_model
TESTS += test_model
test_model_SOURCES = tests/unit/test_model.c tests/unit/model_lib.h
test_model_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_model_LDADD = libmodel.a libbase.a $(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
check_PROGRAMS += test_voxels
TESTS += test_voxels
test_voxels_SOURCES = tests/unit/test_voxels.c tests/unit/model_lib.h
test_voxels_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_voxels_LDADD = libmodel.a libbase.a $(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
model_checks = tests/cli/models.sh tests/schema_models.sh
TESTS += $(model_checks)
EXTRA_DIST += $(model_checks)
check_PROGRAMS += test_model_pdof
TESTS += test_model_pdof
test_model_pdof_SOURCES = tests/unit/test_model_pdof.c tests/unit/model_lib.h
test_model_pdof_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_model_pdof_LDADD = libresult.a libscene.a libsolver.a libmodel.a libbase.a $(CMOCKA_LIBS) \
	$(CJSON_LIBS) $(NETTLE_LIBS)
