# the full screen in a terminal
tui_checks = tests/tui/busy.sh tests/tui/edit.sh tests/tui/ends.sh tests/tui/first.sh \
	tests/tui/lessons.sh tests/tui/monkey.sh tests/tui/screen.sh
TESTS += $(tui_checks)
EXTRA_DIST += $(tui_checks) tests/tui/tui.sh tests/tui/monkey.py
# unit tests of src/tui
check_PROGRAMS += test_tui_ground
TESTS += test_tui_ground
test_tui_ground_SOURCES = tests/unit/test_tui_ground.c
test_tui_ground_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_tui_ground_LDADD = libtui.a libprocess.a $(CMOCKA_LIBS)
check_PROGRAMS += test_tui_pointer
TESTS += test_tui_pointer
test_tui_pointer_SOURCES = tests/unit/test_tui_pointer.c
test_tui_pointer_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(NCURSES_CFLAGS)
test_tui_pointer_LDADD = $(tui_test_libs)
check_PROGRAMS += test_tui_frame
TESTS += test_tui_frame
test_tui_frame_SOURCES = tests/unit/test_tui_frame.c
test_tui_frame_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_tui_frame_LDADD = libtui.a libprocess.a $(CMOCKA_LIBS)
tui_test_libs = libdouble.a libtui.a libcmd.a libstudy.a libfigure.a libdamage.a librender.a libresult.a libscene.a libsolver.a \
	libmodel.a libprocess.a libbase.a $(CMOCKA_LIBS) $(GSL_LIBS) $(NLOPT_LIBS) $(NCURSES_LIBS) $(READLINE_LIBS) \
	 $(CJSON_LIBS) $(NETTLE_LIBS) $(CAIRO_LIBS)
tui_double = tests/unit/tui_double.c tests/unit/tui_double.h
check_PROGRAMS += test_tui_golden
TESTS += test_tui_golden
test_tui_golden_SOURCES = tests/unit/test_tui_golden.c tests/unit/golden.h $(tui_double)
test_tui_golden_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(NCURSES_CFLAGS)
test_tui_golden_LDADD = $(tui_test_libs)
check_PROGRAMS += test_tui_keys
TESTS += test_tui_keys
test_tui_keys_SOURCES = tests/unit/test_tui_keys.c $(tui_double)
test_tui_keys_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS) $(NCURSES_CFLAGS)
test_tui_keys_LDADD = $(tui_test_libs)
tui_golden = tests/golden/tui/compared-100x30.txt \
	tests/golden/tui/compared-200x50.txt \
	tests/golden/tui/complete-100x30.txt \
	tests/golden/tui/end-200x50.txt \
	tests/golden/tui/end-80x24.txt \
	tests/golden/tui/energy-100x30.txt \
	tests/golden/tui/error-80x24.txt \
	tests/golden/tui/frame-100x30.txt \
	tests/golden/tui/frame-120x36.txt \
	tests/golden/tui/frame-200x50.txt \
	tests/golden/tui/frame-80x24-ascii.txt \
	tests/golden/tui/frame-80x24.txt \
	tests/golden/tui/ghost-100x30.txt \
	tests/golden/tui/help-200x50.txt \
	tests/golden/tui/help-80x24.txt \
	tests/golden/tui/interrupted-80x24.txt \
	tests/golden/tui/swept-80x24.txt \
	tests/golden/tui/other.json \
	tests/golden/tui/lesson-80x24.txt \
	tests/golden/tui/lesson-200x50.txt \
	tests/golden/tui/compare-80x24.txt \
	tests/golden/tui/compare-200x50.txt \
	tests/golden/tui/frame-80x24-dark.txt \
	tests/golden/tui/frame-80x24-light.txt \
	tests/golden/tui/frame-200x50-dark.txt \
	tests/golden/tui/frame-200x50-light.txt \
	tests/golden/tui/pulse-80x24-dark.txt \
	tests/golden/tui/pulse-80x24-light.txt \
	tests/golden/tui/energy-80x24-dark.txt \
	tests/golden/tui/energy-80x24-light.txt \
	tests/golden/tui/table-80x24-dark.txt \
	tests/golden/tui/table-80x24-light.txt \
	tests/golden/tui/map-80x24-dark.txt \
	tests/golden/tui/map-80x24-light.txt \
	tests/golden/tui/map-200x50-dark.txt \
	tests/golden/tui/map-200x50-light.txt \
	tests/golden/tui/start-80x24-dark.txt \
	tests/golden/tui/start-80x24-light.txt \
	tests/golden/tui/stale-80x24-dark.txt \
	tests/golden/tui/stale-80x24-light.txt \
	tests/golden/tui/compare-80x24-dark.txt \
	tests/golden/tui/compare-80x24-light.txt \
	tests/golden/tui/map-80x24.txt \
	tests/golden/tui/map-80x24-ascii.txt \
	tests/golden/tui/map-200x50.txt \
	tests/golden/tui/map-of-four-100x30.txt \
	tests/golden/tui/draws-80x24.txt \
	tests/golden/tui/log-80x24.txt \
	tests/golden/tui/narrow-60x20.txt \
	tests/golden/tui/palette-100x30.txt \
	tests/golden/tui/prompt-30x8.txt \
	tests/golden/tui/pulse-100x30.txt \
	tests/golden/tui/question-80x24.txt \
	tests/golden/tui/sheet-80x24.txt \
	tests/golden/tui/solving-80x24.txt \
	tests/golden/tui/stale-200x50.txt \
	tests/golden/tui/stale-80x24.txt \
	tests/golden/tui/start-80x24.txt \
	tests/golden/tui/sweep-80x24.txt \
	tests/golden/tui/sweeping-200x50.txt \
	tests/golden/tui/sweeping-80x24.txt \
	tests/golden/tui/table-100x30.txt \
	tests/golden/tui/zoom-100x30.txt
EXTRA_DIST += $(tui_golden)
