#!/bin/sh
# The bash completion offers the words, the options of each word, and their values.
. "$SRC/tests/cli/cli.sh"
command -v bash >/dev/null 2>&1 || {
    echo "1..0 # SKIP no bash here"
    exit 0
}

# offers WORD ...: what is offered for the last word, in one line
offers() {
    bash -c '. "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _crumple; echo "${COMPREPLY[@]}"' \
        "$SRC/share/completions/crumple" "$@" 2>&1
}
same "the word run" "$(offers "$crumple" ru)" run
same "an option of run" "$(offers "$crumple" run --tr)" --trace
same "an option that takes a value" "$(offers "$crumple" run --form)" --format=
same "all values of --format" "$(offers "$crumple" run --format =)" "json text csv"
same "a value of --format" "$(offers "$crumple" run --format = te)" text
touch "$tmp/a.crumple" "$tmp/b.json"
same "command files" "$(offers "$crumple" "$tmp/a")" "$tmp/a.crumple"
same "files after a word" "$(offers "$crumple" run "$tmp/b")" "$tmp/b.json"
finish
