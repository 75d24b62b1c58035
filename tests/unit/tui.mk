# the full screen in a terminal
tui_checks = tests/tui/edit.sh tests/tui/ends.sh tests/tui/screen.sh
TESTS += $(tui_checks)
EXTRA_DIST += $(tui_checks) tests/tui/tui.sh
