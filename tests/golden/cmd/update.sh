#!/bin/sh
# make update-golden puts right what no longer matches, and leaves the rest alone.
. "$SRC/tests/tap.sh"
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
folder=$tmp/tests/golden/cmd
mkdir -p "$folder" || exit 99
cp "$SRC/tests/tap.sh" "$tmp/tests" || exit 99
cp "$SRC/tests/golden/cmd/run.sh" "$SRC"/tests/golden/cmd/*.csv "$SRC"/tests/golden/cmd/*.json \
    "$SRC"/tests/golden/cmd/*.crumple "$folder" || exit 99

cat >"$folder/right.test" <<'END'
what stands before the first block stays

# line by line
| vehicle A type=suv mass=2t length=5m
| list
  A: suv 2000 kg  x=0.00 m y=0.00 m heading=0.0 deg  0.0 km/h
  A: suv 2000 kg  x=0.00 m y=0.00 m heading=0.0 deg  0.0 km/h
= 0

# with gaps
| source pair.crumple
| solve
| solve --step

~ @ steps: EES A @ B @, delta-v A @ B @ km/h
~ all @ slices are shown; show frame=@ begins again
= 0

# an error
| place B facing A
~stdin:1:7: error: there is no participant 'B'
~ hint: the scene is empty; begin with: vehicle A type=compact
= 3
END
sed 's/2000 kg  x=0.00/1000 kg  x=9/; s/^~ all @ slices/~ at @ all slices/
    s/the scene is/this scene was/; s/stdin:1:7: error: there is/stdin:1:9: error: here is/
    s/^= 3/= 0/' \
    "$folder/right.test" >"$folder/wrong.test"
mv "$folder/right.test" "$tmp/right"

play() { # WORD
    SRC=$tmp sh "$folder/run.sh" "$@"
}
play >"$tmp/out" 2>&1
has "it fails before" "$(cat "$tmp/out")" '^not ok 3'
told=$(play update)
same "it says which blocks change" "$(printf '%s' "$told" | tr '\n' ' ')" \
    "wrong.test: line by line wrong.test: with gaps wrong.test: an error"
empty "and they are as the program speaks" "$(diff "$folder/wrong.test" "$tmp/right")"
play >"$tmp/out" 2>&1
same "it passes after" $? 0
play update >"$tmp/out"
same "a second time nothing changes" "$(cat "$tmp/out")" ""
empty "in the file either" "$(diff "$folder/wrong.test" "$tmp/right")"
finish
