# unit tests of src/render
check_LIBRARIES += libdouble.a
libdouble_a_SOURCES = tests/unit/render_double.c tests/unit/render_double.h
libdouble_a_CFLAGS = $(CR_CFLAGS)
render_tests = test_render_cells test_render_layout test_render_picture \
	test_render_golden test_render_project
render_test_libs = libdouble.a librender.a libresult.a libscene.a libsolver.a libmodel.a libbase.a \
	$(CMOCKA_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS)
check_PROGRAMS += $(render_tests)
TESTS += $(render_tests)
test_render_cells_SOURCES = tests/unit/test_render_cells.c
test_render_cells_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_render_cells_LDADD = $(render_test_libs)
test_render_layout_SOURCES = tests/unit/test_render_layout.c
test_render_layout_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_render_layout_LDADD = $(render_test_libs)
test_render_picture_SOURCES = tests/unit/test_render_picture.c
test_render_picture_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_render_picture_LDADD = $(render_test_libs)
test_render_project_SOURCES = tests/unit/test_render_project.c
test_render_project_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_render_project_LDADD = $(render_test_libs)
test_render_golden_SOURCES = tests/unit/test_render_golden.c tests/unit/golden.h
test_render_golden_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_render_golden_LDADD = $(render_test_libs)
EXTRA_DIST += tests/golden/render/report-80.txt \
	tests/golden/render/report-80-ascii.txt \
	tests/golden/render/report-120.txt \
	tests/golden/render/report-160.txt \
	tests/golden/render/report-wall-80.txt \
	tests/golden/render/scene-ees.txt \
	tests/golden/render/scene-256.txt \
	tests/golden/render/scene-16-ascii.txt \
	tests/golden/render/scene-energy.txt \
	tests/golden/render/scene-depth.txt \
	tests/golden/render/scene-crush-ascii.txt \
	tests/golden/render/scene-none.txt \
	tests/golden/render/scene-start.txt \
	tests/golden/render/energy.txt \
	tests/golden/render/force-ascii.txt \
	tests/golden/render/table-instant.txt \
	tests/golden/render/screen-30x8.txt \
	tests/golden/render/screen-60x20.txt \
	tests/golden/render/screen-80x24.txt \
	tests/golden/render/screen-80x24-ascii.txt \
	tests/golden/render/screen-120x36.txt \
	tests/golden/render/screen-200x50.txt \
	tests/golden/render/screen-live-80x24.txt \
	tests/golden/render/screen-live-160x44.txt
golden_pictures = update-pictures
update-pictures: test_render_golden$(EXEEXT) test_tui_golden$(EXEEXT)
	for program in test_render_golden$(EXEEXT) test_tui_golden$(EXEEXT); do \
	    SRC='$(abs_srcdir)' LC_ALL=C.UTF-8 TERM=xterm-256color CRUMPLE_GOLDEN=update \
	        ./$$program || exit 1; \
	done
