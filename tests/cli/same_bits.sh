#!/bin/sh
# The same bytes on every run, for every scene, and from its resolved form; $REFERENCE is a program
# that was built otherwise (make check-sanitizers: the build without sanitizers).
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
    # input.resolved is a scene that gives the same result to the last digit
    "$crumple" run "$scene" >"$tmp/a"
    awk '/^\t\t"resolved":/ { on = 1; print "{"; next }
        on && /^\t\t}/ { print "}"; exit }
        on { print }' "$tmp/a" >"$tmp/resolved.json"
    "$crumple" run "$tmp/resolved.json" >"$tmp/b" 2>"$tmp/why"
    for side in a b; do
        sed '/^\t"time"/,$!d' "$tmp/$side" >"$tmp/$side.rest"
    done
    [ -s "$tmp/a.rest" ] && cmp "$tmp/a.rest" "$tmp/b.rest" >>"$tmp/why" 2>&1
    report $? "$name, from its resolved scene"
    explain <"$tmp/why"
    empty "$name: no resolved number is longer than it must be" \
        "$(grep -E '[0-9]\.[0-9]{13}' "$tmp/resolved.json")"
done
finish
