# unit tests of src/scene, and of the readers of JSON and units below it
scene_tests = test_json test_units test_scene test_scene_bad test_scene_set test_scene_place \
	test_scene_compile
scene_test_help = tests/unit/scene_help.c tests/unit/scene_help.h
scene_test_libs = libscene.a libsolver.a libmodel.a libbase.a $(CMOCKA_LIBS) $(CJSON_LIBS) \
	$(NETTLE_LIBS)
check_PROGRAMS += $(scene_tests)
TESTS += $(scene_tests) tests/schema_scene.sh
EXTRA_DIST += tests/schema_scene.sh tests/cases/scene
test_json_SOURCES = tests/unit/test_json.c
test_json_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_json_LDADD = $(scene_test_libs)
test_units_SOURCES = tests/unit/test_units.c
test_units_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_units_LDADD = $(scene_test_libs)
test_scene_SOURCES = tests/unit/test_scene.c $(scene_test_help)
test_scene_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(CJSON_CFLAGS)
test_scene_LDADD = $(scene_test_libs)
test_scene_bad_SOURCES = tests/unit/test_scene_bad.c $(scene_test_help)
test_scene_bad_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(CJSON_CFLAGS)
test_scene_bad_LDADD = $(scene_test_libs)
test_scene_set_SOURCES = tests/unit/test_scene_set.c $(scene_test_help)
test_scene_set_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(CJSON_CFLAGS)
test_scene_set_LDADD = $(scene_test_libs)
test_scene_place_SOURCES = tests/unit/test_scene_place.c $(scene_test_help)
test_scene_place_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(CJSON_CFLAGS)
test_scene_place_LDADD = $(scene_test_libs)
test_scene_compile_SOURCES = tests/unit/test_scene_compile.c $(scene_test_help)
test_scene_compile_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(CJSON_CFLAGS)
test_scene_compile_LDADD = $(scene_test_libs)
