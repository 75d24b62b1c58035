# tests of src/report and src/expert
TESTS += tests/cli/report.sh tests/cli/forms.sh
EXTRA_DIST += tests/cli/report.sh tests/cli/forms.sh
