#!/bin/sh
# crumple diff: two results side by side, their inputs and numbers; scenes are solved.
. "$SRC/tests/cli/cli.sh"
"$crumple" run "$demo" >"$tmp/a.json" || exit 99
"$crumple" run --set A.speed_kmh=60 --set A.brake=0.5 "$demo" >"$tmp/b.json" || exit 99

run diff "$tmp/a.json" "$tmp/b.json"
same "what differs is told by the status" "$status" 1
has "which inputs differ" "$out" 'A.speed_kmh  *56  *60  *\+4$'
has "all of them" "$out" 'A.brake  *0  *0.5  *\+0.5$'
same "and no others" "$(printf '%s\n' "$out" | grep -c 'B.speed_kmh')" 0
# ees of A as the files have it, and the difference of the two
value() {
    sed -n 's/.*"ees_kmh":[[:space:]]*\([-0-9.]*\).*/\1/p' "$1" | head -1
}
want=$(awk -v a="$(value "$tmp/a.json")" -v b="$(value "$tmp/b.json")" \
    'BEGIN { printf "ees km/h %.1f %.1f %+.1f %+.1f %%", a, b, b - a, 100 * (b - a) / a }')
got=$(printf '%s\n' "$out" | awk '$1 == "ees" { $1 = $1; print; exit }')
same "the numbers, their difference and its share" "$got" "$want"

run diff "$tmp/a.json" "$tmp/a.json"
same "the same result" "$status" 0
has "says so of the inputs" "$out" '^all inputs are the same$'
same "and has no difference" "$(printf '%s\n' "$out" | grep -c '[0-9] %$')" 0
run diff "$demo" "$tmp/a.json"
same "a scene is solved" "$status" 0
run diff --units=us "$tmp/a.json" "$tmp/b.json"
has "in US units" "$out" 'ees  *mph'
has "depths in inches" "$out" 'deformation_max  *in '

printf '{"crumple":1}' >"$tmp/bad.json"
run diff "$tmp/a.json" "$tmp/bad.json"
same "a scene without participants" "$status" 3
run diff "$tmp/a.json" "$tmp/none.json"
same "a file that is not there" "$status" 2
has "is named" "$errs" 'none.json'
printf 'no json' >"$tmp/text.json"
run diff "$tmp/text.json" "$tmp/a.json"
same "no JSON" "$status" 3
sed 's/"id":\([[:space:]]*\)"\([AB]\)"/"id":\1"other\2"/' "$tmp/a.json" >"$tmp/others.json"
run diff "$tmp/a.json" "$tmp/others.json"
has "nobody in common" "$errs" 'no participant of the same name'
run diff "$tmp/a.json"
same "two files are wanted" "$status" 2
finish
