# unit tests of src/cmd
cmd_test_libs = libcmd.a libstudy.a libfigure.a libdamage.a librender.a libresult.a libscene.a libsolver.a libmodel.a \
	libprocess.a libbase.a $(CMOCKA_LIBS) $(GSL_LIBS) $(NLOPT_LIBS) $(CJSON_LIBS) \
	$(NETTLE_LIBS) $(CAIRO_LIBS)
check_PROGRAMS += test_cmd
TESTS += test_cmd
test_cmd_SOURCES = tests/unit/test_cmd.c
test_cmd_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_cmd_LDADD = $(cmd_test_libs)
check_PROGRAMS += test_cmd_autosave
TESTS += test_cmd_autosave
test_cmd_autosave_SOURCES = tests/unit/test_cmd_autosave.c
test_cmd_autosave_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_cmd_autosave_LDADD = $(cmd_test_libs)
check_PROGRAMS += test_cmd_interrupt
TESTS += test_cmd_interrupt
test_cmd_interrupt_SOURCES = tests/unit/test_cmd_interrupt.c
test_cmd_interrupt_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_cmd_interrupt_LDADD = $(cmd_test_libs)
