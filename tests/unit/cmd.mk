# unit tests of src/cmd
cmd_test_libs = libcmd.a librender.a libresult.a libscene.a libsolver.a libmodel.a libbase.a \
	$(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
check_PROGRAMS += test_cmd
TESTS += test_cmd tests/golden/cmd/run.sh
test_cmd_SOURCES = tests/unit/test_cmd.c
test_cmd_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_cmd_LDADD = $(cmd_test_libs)
EXTRA_DIST += tests/golden/cmd/run.sh \
	tests/golden/cmd/scene.test \
	tests/golden/cmd/language.test \
	tests/golden/cmd/solve.test \
	tests/golden/cmd/pulse.csv \
	tests/golden/cmd/measured.json \
	tests/golden/cmd/bad.json \
	tests/golden/cmd/pair.crumple \
	tests/golden/cmd/bad.crumple \
	tests/golden/cmd/loop.crumple
