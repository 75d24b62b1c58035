# unit tests of src/damage, the word damage, and real crashes
damage_test_libs = libdamage.a librender.a libresult.a libscene.a libsolver.a libmodel.a libbase.a \
	$(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
check_PROGRAMS += test_damage
TESTS += test_damage tests/cli/damage.sh tests/cli/field.sh tests/schema_damage.sh
EXTRA_DIST += tests/cli/damage.sh tests/cli/field.sh tests/schema_damage.sh
test_damage_SOURCES = tests/unit/test_damage.c tests/unit/model_lib.h
test_damage_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_damage_LDADD = $(damage_test_libs)
