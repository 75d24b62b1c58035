# checks of the tree as a whole
tree_checks = tests/check_includes.sh tests/check_symbols.sh
TESTS += $(tree_checks)
EXTRA_DIST += $(tree_checks) tests/check_map.sh tests/check_style.sh tests/tap.sh
