#!/bin/sh
# crumple import: every sample gives the lines that must come out, to the byte; what is missing or
# wrong is told in one clear line.
. "$SRC/tests/cli/cli.sh"
data=$SRC/tests/data/import

# sample NAME OPTION...: the lines of tests/data/import/NAME.jsonl
sample() {
    want=$data/$1.jsonl
    name=$1
    shift
    run import "$@"
    same "import of $name: status 0" "$status" 0
    printf '%s\n' "$out" | diff - "$want" >"$tmp/diff"
    same "and the scenes that must come out" $? 0
    explain <"$tmp/diff"
}

# refused NAME STATUS PATTERN FILE OPTION...: one line on standard error that fits the pattern
refused() {
    name=$1 want=$2 pattern=$3
    shift 3
    run import "$@"
    same "$name: status $want" "$status" "$want"
    has "one line says it" "$errs" "$pattern"
    same "and it alone" "$(printf '%s\n' "$errs" | wc -l)" 1
}

. "$SRC/tests/cli/import_csv.sh"
. "$SRC/tests/cli/import_xml.sh"
. "$SRC/tests/cli/import_logs.sh"
. "$SRC/tests/cli/import_tests.sh"
. "$SRC/tests/cli/import_pcm.sh"
. "$SRC/tests/cli/import_edr.sh"
. "$SRC/tests/cli/import_zip.sh"
finish
