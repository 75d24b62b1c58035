#!/bin/sh
# The manual pages are what the program says, and are sound roff.
. "$SRC/tests/tap.sh"
empty "crumple-commands(7) is that of the command table (else: make update-manual)" \
    "$("$BUILD/crumple-manual" | diff "$SRC/man/crumple-commands.7" - 2>&1)"
page=$(sh "$SRC/tests/lib_manual.sh" "$SRC/src/lib/crumple.h")
empty "libcrumple(3) is that of its header (else: make update-manual)" \
    "$(printf '%s\n' "$page" | diff "$SRC/man/libcrumple.3" - 2>&1)"
if command -v groff >/dev/null 2>&1; then
    for page in "$SRC"/man/*.[137]; do
        empty "$(basename "$page") is sound" "$(groff -man -Tutf8 -ww -z "$page" 2>&1)"
    done
else
    skip "the pages are sound" "no groff"
fi
version=$("$CRUMPLE" --version | sed -n "1s/, commit .*//p;1s/^\(crumple [0-9.]*\)$/\1/p")
has "the manual has the version of the program" "$(head -n 1 "$SRC/man/crumple.1")" "\"$version\""
finish
