# unit tests of src/figure
check_PROGRAMS += test_figure
TESTS += test_figure
test_figure_SOURCES = tests/unit/test_figure.c
test_figure_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_figure_LDADD = libdouble.a libfigure.a librender.a libresult.a libscene.a libsolver.a libmodel.a libbase.a \
	$(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS) $(CAIRO_LIBS)
