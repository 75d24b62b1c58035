#!/bin/sh
# The same bytes on every run, for every scene; $REFERENCE is a program that was built otherwise
# (make check-sanitizers: the build without sanitizers).
. "$SRC/tests/cli/cli.sh"
reference=${REFERENCE:-$crumple}
for scene in "$SRC"/share/scenes/*.json; do
    name=$(basename "$scene")
    for form in "" --trace --format=csv --format=text; do
        # shellcheck disable=SC2086
        "$crumple" run "$scene" $form >"$tmp/a" 2>&1
        a=$?
        # shellcheck disable=SC2086
        "$reference" run "$scene" $form >"$tmp/b" 2>&1
        [ $a -eq 0 ] && [ $? -eq 0 ] && cmp "$tmp/a" "$tmp/b" >"$tmp/why" 2>&1
        report $? "$name $form"
        explain <"$tmp/why"
    done
done
finish
