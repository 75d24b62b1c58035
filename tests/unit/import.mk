# tests of src/import
TESTS += tests/cli/import.sh
EXTRA_DIST += tests/cli/import.sh tests/cli/import_csv.sh tests/cli/import_edr.sh tests/cli/import_logs.sh \
	tests/cli/import_pcm.sh tests/cli/import_tests.sh tests/cli/import_xml.sh tests/data
