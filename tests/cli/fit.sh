#!/bin/sh
# crumple fit: round trip, what is not determined, contradiction, forms, faults.
. "$SRC/tests/cli/cli.sh"

# voxels and slices as coarse as a search bears
wall_scene | sed '1s/$/ "settings": { "voxel_mm": 50, "dt_ms": 1 },/' >"$tmp/w.json"
case $("$crumple" --version) in
*"no GSL"* | *"no NLopt"*)
    refused "a build without a search says so" 2 'no NLopt or no GSL' \
        fit "$tmp/w.json" A.speed to dv.A=40km/h
    skip "the search" "built without GSL or NLopt"
    finish
    exit
    ;;
esac

# the results of a solve give its speed back, from another start
run run "$tmp/w.json"
value() {
    printf '%s' "$out" | sed -n "s/^.*\"$1\":[^0-9-]*\([-0-9.e]*\).*/\1/p" | head -n 1
}
dv=$(value delta_v_kmh)
ees=$(value ees_kmh)
run fit "$tmp/w.json" --set A.speed_kmh=30 A.speed to "dv.A=${dv}km/h" "ees.A=${ees}km/h" \
    --starts 1 --solves 80
same "a search ends" "$status:$errs" "0:"
near=$(printf '%s\n' "$out" | awk '/^  A.speed /{d = $2 - 50; print (d < 0 ? -d : d) < 0.5}')
same "with the speed of the solve, to 0.5 km/h" "$near" 1
has "its interval and what determines it" "$out" \
    '^  A\.speed +[0-9.]+ km/h  95 %: [0-9.]+ to [0-9.]+  by (dv|ees)\.A [0-9]+ %'
has "and each item of the evidence" "$out" '^  ees\.A +[0-9.]+ +[0-9.]+ +[0-9.]+ +[+-][0-9.]+  km/h'
run fit "$tmp/w.json" A.speed to "dv.A=${dv}km/h" --starts 1 --solves 40 -f json
if command -v python3 >/dev/null 2>&1; then
    same "JSON" "$(printf '%s' "$out" | python3 -c 'import json, sys
d = json.load(sys.stdin); i = d["inputs"][0]
print(d["class"], i["key"], i["low"] < i["value"] < i["high"], i["determined"])')" \
        "fit A.speed True True"
else
    skip "JSON" "no python3"
fi
run fit "$tmp/w.json" A.speed A.brake=0.1:0.9 to "dv.A=${dv}km/h" --starts 1 --solves 60
has "what the evidence does not tell is told" "$out" 'does not determine A\.brake'
run fit "$tmp/w.json" A.speed to dv.A=30km/h ees.A=70km/h --starts 1 --solves 40
has "evidence that contradicts itself" "$out" 'contradicts itself or the scene'
run fit "$tmp/w.json" A.speed=10:20km/h to dv.A=60km/h --starts 1 --solves 40
has "a target out of reach" "$out" 'lies at its bound'

refused "no evidence" 3 'no evidence' fit "$tmp/w.json" A.speed
refused "no input" 3 'no input is searched' fit "$tmp/w.json" to dv.A=40km/h
refused "evidence that is none" 3 'is no evidence.*dv\.A' fit "$tmp/w.json" A.speed to colour.A=4
refused "of nobody" 3 'is no evidence' fit "$tmp/w.json" A.speed to dv.C=4
refused "a value of another kind" 3 'kg' fit "$tmp/w.json" A.speed to dv.A=4kg
refused "five stations" 3 'six depths' fit "$tmp/w.json" A.speed to crush.A=1,2,3,4,5cm
refused "an input that is none" 3 'no key "colour"' fit "$tmp/w.json" A.colour to dv.A=40
refused "an input that is no number" 3 'no number' fit "$tmp/w.json" A.type to dv.A=40
refused "bounds that fall" 3 'does not rise' fit "$tmp/w.json" A.speed=60:40km/h to dv.A=40
refused "an input twice" 3 'A\.speed is given twice' fit "$tmp/w.json" A.speed A.speed to dv.A=40
for huge in dv.A=1e308km/h dv.A=43+-1e300km/h dv.A=43+-1e-300km/h rest.A=1e308,3m; do
    refused "evidence of $huge" 3 'A.*: [0-9.e+-]+ \+- [0-9.e+-]+ (km/h|m) is beyond all measure' \
        fit "$tmp/w.json" A.speed to $huge
done
refused "twice the same" 3 'given twice' fit "$tmp/w.json" A.speed to dv.A=40 dv.A=41
refused "nothing that meets" 4 'no place within the bounds' \
    fit "$tmp/w.json" A.speed=0:0.0001km/h to dv.A=40 --starts 1 --solves 20
finish
