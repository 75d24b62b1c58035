# the full screen in a terminal
tui_checks = tests/tui/edit.sh tests/tui/ends.sh tests/tui/screen.sh
TESTS += $(tui_checks)
EXTRA_DIST += $(tui_checks) tests/tui/tui.sh
# unit tests of src/tui
check_PROGRAMS += test_tui_ground
TESTS += test_tui_ground
test_tui_ground_SOURCES = tests/unit/test_tui_ground.c
test_tui_ground_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_tui_ground_LDADD = libtui.a $(CMOCKA_LIBS)
check_PROGRAMS += test_tui_frame
TESTS += test_tui_frame
test_tui_frame_SOURCES = tests/unit/test_tui_frame.c
test_tui_frame_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_tui_frame_LDADD = libtui.a $(CMOCKA_LIBS)
