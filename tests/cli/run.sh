#!/bin/sh
# crumple run: forms of the result, overriding, standard input, the same bytes every time.
. "$SRC/tests/cli/cli.sh"
wall_scene >"$tmp/wall.json"

run run "$demo"
same "the demo is solved" "$status" 0
same "nothing on standard error" "$errs" ""
has "JSON is the default" "$out" '"crumple_result":[[:space:]]*2'
has "the resolved scene is in the result" "$out" '"resolved":[[:space:]]*\{'
same "no time series unless asked" "$(printf '%s' "$out" | grep -c '"trace"')" 0
first=$out
run run "$demo"
same "the same bytes twice" "$(printf '%s' "$out" | cksum)" "$(printf '%s' "$first" | cksum)"

run run --trace "$demo"
has "--trace adds the time series" "$out" '"trace":[[:space:]]*\{'
run run -f csv "$demo"
same "CSV has a header and a row per participant" "$(printf '%s\n' "$out" | wc -l)" 3
has "CSV names units in the header" "$(printf '%s\n' "$out" | head -n 1)" 'ees_kmh'

run run -f csv --per impact "$(cd "$(dirname "$demo")" && pwd)/three-cars.json"
same "--per impact: a row per impact and participant" \
    "$(printf '%s\n' "$out" | awk -F, 'NR == 1 { n = NF } NF != n { bad = 1 }
        NR > 1 { at[$2]++ } END { for (i in at) if (at[i] != 2) bad = 1
        print bad + 0, (NR > 4 ? "several" : NR) }')" "0 several"
run run -f text "$(cd "$(dirname "$demo")" && pwd)/three-cars.json"
has "text tells each impact" "$out" 'Impacts .*each by itself'
has "and whose risk it is" "$out" 'injury by the severest impact'
wall_scene '' '"model": { "stiffness": {
    "front": { "A_N_per_m": 174000, "B_N_per_m2": 20000 } } }' >"$tmp/ab.json"
run run "$tmp/ab.json"
has "own A, B that hide more energy than a crash has are told" "$out" \
    'its own A, B leave the front uncrushed up to an EES of [0-9]+ km/h'
sed 's/174000/62300/; s/20000/234000/' "$tmp/ab.json" >"$tmp/ab-2.json"
run run "$tmp/ab-2.json"
same "those of the table of CRASH3 are not" "$(printf '%s' "$out" | grep -c 'uncrushed')" 0
run run "$tmp/wall.json" --set A.mass_kg=3300
has "a mass in lb is doubted" "$out" '"implausible"'
has "with the guess" "$out" 'mass 3300 is far from .*if it is in lb it is 1497'
run run "$demo"
same "plausible masses are not" "$(printf '%s' "$out" | grep -c '"implausible"')" 0
# driven SPEED ROWS STEP: a car that follows rows, a second and STEP m apart, to a wall at 30 m
driven() {
    awk -v speed="$1" -v rows="$2" -v step="$3" 'BEGIN {
        print "{ \"crumple\": 1, \"participants\": [ { \"id\": \"A\", \"kind\": \"vehicle\","
        print "  \"type\": \"sedan\", \"mass_kg\": 1500, \"trajectory\": ["
        for (i = 0; i < rows; i++) {
            printf "  { \"t_s\": %d, \"x_m\": %g, \"y_m\": 0,", i, step * (i - rows + 1) + 30
            printf " \"heading_deg\": 0, \"speed_kmh\": %g }%s\n", speed, i < rows - 1 ? "," : "]"
        }
        print "  }, { \"id\": \"W\", \"kind\": \"object\", \"shape\": \"wall\","
        print "  \"position_m\": [30, 0], \"heading_deg\": 180 } ] }" }' >"$tmp/driven.json"
    run run "$tmp/driven.json"
}
driven 36 5 10
same "a trajectory that agrees with itself is not doubted" \
    "$(printf '%s' "$out" | grep -c '"trajectory-')" 0
driven 72 5 10
has "a speed that contradicts the path is" "$out" 'trajectory-speed'
has "with both" "$out" 'gives 72.0 km/h at .* path runs at 36.0 km/h'
driven 10 5 10
has "m/s for km/h is guessed" "$out" 'as if it were in m/s'
driven 36 31 10
same "a contact later than 20 s is found" "$status" 0
driven 36 5 10
sed 's/\[30, 0\]/[60, 0]/' "$tmp/driven.json" >"$tmp/late.json"
run run "$tmp/late.json"
has "rows that end before the contact are told" "$out" 'trajectory ends .* s before its contact'
awk '/"t_s": 2/ { sub(/"t_s": 2/, "\"t_s\": 1.01") } { print }' "$tmp/driven.json" >"$tmp/jump.json"
run run "$tmp/jump.json"
has "a jump is told" "$out" 'trajectory jumps by 10.0 m within 0.01 s'
run run --check 3 "$tmp/wall.json"
has "--check tells the spread of each number" "$out" '"spread_percent"'
has "and how often it solved" "$out" '"solves":[[:space:]]*3'
run run --check 3 -f text "$tmp/wall.json"
has "in text too" "$out" 'Robustness'
run run --check 1 "$tmp/wall.json"
same "one solve more tells nothing" "$status" 2
has "and says so" "$errs" 'check.*3..100'
cat >"$tmp/objects.json" <<'JSON'
{ "crumple": 1, "participants": [
  { "id": "W", "kind": "object", "shape": "wall", "position_m": [0, 0] },
  { "id": "B", "kind": "object", "shape": "box", "length_m": 1, "width_m": 1, "mass_kg": 900,
    "position_m": [9, 0], "heading_deg": 180, "speed_kmh": 50 } ] }
JSON
refused "objects alone" 3 'no vehicle among the participants.*do not crush' run "$tmp/objects.json"
run run --per wheel "$demo"
same "--per knows what there is a row for" "$status" 2
has "and says so" "$errs" 'participant.impact'
run run --result-version=1 "$demo"
has "the first form of the result on request" "$out" '"crumple_result":[[:space:]]*1'
same "it knows no impacts" "$(printf '%s' "$out" | grep -c '"impacts"')" 0
run run --result-version=3 "$demo"
same "a third form is unknown" "$status" 2

run run --format=text "$demo"
same "text succeeds" "$status" 0
has "text has EES" "$out" 'EES'
has "text names the stop criterion" "$out" 'momentum|separation|no-overlap'
wide=$(printf '%s\n' "$out" | LC_ALL=C.UTF-8 grep -cE '^.{81}')
same "text keeps to 80 columns without a terminal" "$wide" 0
same "no colour without a terminal" "$(printf '%s' "$out" | grep -c "$(printf '\033')")" 0
has "text says that the elastic phases follow from the force" "$out" 'elastic auto'
run run --format=text --set restitution=auto --set elastic_ms=5 "$demo"
has "text says that the restitution follows from the speed" "$out" 'e auto'
same "elastic phases that were given are not" "$(printf '%s' "$out" | grep -c 'elastic auto')" 0
run run --set restitution=auto "$demo"
has "each contact has its restitution" "$out" '"restitution":[[:space:]]*0\.'
run run --format=text --ascii "$demo"
same "--ascii has nothing else" "$(printf '%s' "$out" | LC_ALL=C grep -c '[^ -~]')" 0
run run --format=text --color=always "$demo"
[ "$(printf '%s' "$out" | grep -c "$(printf '\033')")" -gt 0 ]
report $? "--color=always colours"
run run --format=text --width=120 "$demo"
wide=$(printf '%s\n' "$out" | LC_ALL=C.UTF-8 grep -cE '^.{121}')
same "--width is kept" "$wide" 0
utf=$(env LC_ALL=C "$crumple" run --format=text "$demo" | LC_ALL=C grep -c '[^ -~]')
same "a locale without UTF-8 gets ASCII" "$utf" 0

"$crumple" run - <"$demo" >"$tmp/stdin.json" 2>"$tmp/errs"
same "a scene from standard input gives the same result" "$(cksum <"$tmp/stdin.json")" \
    "$("$crumple" run "$demo" | cksum)"

value() { # KEY: its first number in $out
    printf '%s\n' "$out" | sed -n "s/.*\"$1\":[[:space:]]*\([-0-9.e+]*\).*/\1/p" | head -n 1
}
run run "$tmp/wall.json"
slow=$(value ees_kmh)
run run "$tmp/wall.json" --set A.speed_kmh=70
fast=$(value ees_kmh)
awk -v a="$slow" -v b="$fast" 'BEGIN { exit !(a > 0 && b > 1.3 * a && b < 1.5 * a) }'
report $? "--set A.speed_kmh=70 raises EES in proportion ($slow, $fast)"
run run "$tmp/wall.json" --set A.speed_kmh=20 -s A.speed_kmh=70
same "the last --set wins" "$(value ees_kmh)" "$fast"
run run "$tmp/wall.json" --set method=paper
has "--set method=paper" "$out" '"method":[[:space:]]*"paper"'
refused "a fault of --set that only the solve finds" 3 \
    '^--set injury=nonsense: error: .*there is no injury risk function "nonsense"' \
    run "$demo" --set injury=all --set injury=nonsense
refused "and one of what it left as it was has its line" 3 \
    '^[^:]*json:[0-9]+:[0-9]+: error: .*load_kg' run "$demo" --set A.mass_kg=2000
refused "a group of keys" 3 'no key "model" \(set one of its keys, "A.model.KEY"\)' \
    run "$demo" --set A.model=suv
refused "unknown key of --set" 3 'dt_sm.*dt_ms' run "$demo" --set dt_sm=1
refused "value of --set out of range" 3 'restitution' run "$demo" --set restitution=7
refused "value of --set is no number" 3 'dt_ms' run "$demo" --set dt_ms=fast
refused "--set for nobody" 3 'Z' run "$demo" --set Z.speed_kmh=5

# the resolved scene is a scene: it gives the same result without assuming anything
if command -v python3 >/dev/null 2>&1; then
    cat >"$tmp/resolved.py" <<'END'
import json, sys
result = json.load(open(sys.argv[1]))
if sys.argv[2] == "scene":
    print(json.dumps(result["input"]["resolved"]))
else:
    keys = ("time", "participants", "contacts")
    digits = lambda text: float("%.9g" % float(text))
    some = json.dumps([result[k] for k in keys])
    print(json.dumps(json.loads(some, parse_float=digits), indent=1))
END
    "$crumple" run "$demo" -o "$tmp/1.json"
    python3 "$tmp/resolved.py" "$tmp/1.json" scene >"$tmp/resolved.json"
    run run "$tmp/resolved.json" -o "$tmp/2.json"
    same "the resolved scene is a valid scene" "$status $errs" "0 "
    has "and assumes nothing" "$(cat "$tmp/2.json")" '"assumed":[[:space:]]*\[\]'
    python3 "$tmp/resolved.py" "$tmp/1.json" result >"$tmp/1"
    python3 "$tmp/resolved.py" "$tmp/2.json" result >"$tmp/2"
    empty "and gives the same result to 9 digits" "$(diff "$tmp/1" "$tmp/2")"
else
    skip "the resolved scene" "no python3"
fi

# a recipe is read when a scene needs it, and a fault in it is told then
mkdir -p "$tmp/data/share"
cp -R "$SRC/models" "$tmp/data/models"
ln -s "$SRC/share/irf" "$tmp/data/share/irf"
sed 's/"mass_kg": [0-9]*/"mass_kg": -1/' "$SRC/models/compact.json" >"$tmp/data/models/compact.json"
broken='models/compact\.json:[0-9]+:[0-9]+: error: .*-1 is outside'
CRUMPLE_DATA=$tmp/data
export CRUMPLE_DATA
run run "$demo"
same "a broken recipe of another type does not matter" "$status $errs" "0 "
refused "a broken recipe of the scene" 3 "$broken" run "$tmp/wall.json"
refused "a list of all models reads all" 3 "$broken" models
refused "a stack reads all before it begins" 3 "$broken" stack "$demo"
rm "$tmp/data/models/compact.json"
refused "a recipe that is not there" 2 'models/compact\.json: .*No such file' run "$tmp/wall.json"
unset CRUMPLE_DATA

env LC_ALL=de_DE.UTF-8 "$crumple" run "$demo" 2>&1 | cksum >"$tmp/german"
same "a German locale changes nothing" "$(cat "$tmp/german")" "$("$crumple" run "$demo" | cksum)"
refused "an id that nobody has: all there are" 3 'no participant "C" .there is A, B' \
    run "$demo" --set C.speed=50
# pictures
run run "$demo" --picture "$tmp/o.svg" -p after="$tmp/a.svg" -p 40ms="$tmp/t.svg"
same "pictures alone print no result" "$status $out$errs" "0 "
has "a picture is SVG" "$(head -n 2 "$tmp/o.svg")" '<svg xmlns'
has "the overview has the pulse" "$(cat "$tmp/o.svg")" '>\|a\|, g<'
has "the scene at a time" "$(cat "$tmp/t.svg")" 'In the crash: 40.0 ms after first contact'
for what in before contact engagement pulse energy damage side top front risk; do
    "$crumple" run "$demo" -p "$what=$tmp/$what.svg" 2>"$tmp/errs" || break
    [ -s "$tmp/$what.svg" ] || break
done
same "every picture is drawn" "$what" risk
python3 - "$tmp"/*.svg <<'END' 2>"$tmp/errs"
import sys, xml.dom.minidom
for path in sys.argv[1:]:
    xml.dom.minidom.parse(path)
END
same "every picture is sound XML" "$?$(cat "$tmp/errs")" 0
run run "$demo" -p "$tmp/o2.svg" -o "$tmp/r.json"
cmp -s "$tmp/o.svg" "$tmp/o2.svg"
report $? "the same bytes on every run"
has "with -o the result is written too" "$(head -n 3 "$tmp/r.json")" crumple_result
refused "a picture that there is none of" 2 'no picture .pulses.*did you mean pulse=FILE' \
    run "$demo" -p "pulses=$tmp/x.svg"
refused "a picture in an unknown form" 2 'ends in .svg, .pdf or .png' run "$demo" -p "$tmp/x.gif"
refused "a picture that cannot be written" 2 'cannot write' run "$demo" -p "$tmp/no/x.svg"
if "$crumple" --version | grep -q cairo; then
    run run "$demo" -p "after=$tmp/a.pdf" -p "after=$tmp/a.png"
    same "PDF and PNG" "$(head -c 5 "$tmp/a.pdf") $(head -c 4 "$tmp/a.png" | tail -c 3)" "%PDF- PNG"
else
    skip "PDF and PNG" "a build without cairo"
fi


# what moves still at the end has no place of rest
run stack "$SRC/share/scenes/pole-side.json"
has "no rest without rest" "$out" \
    '"rest":\{"x_m":null,"y_m":null,"heading_deg":null,"t_s":null\}'
run run "$SRC/share/scenes/pole-side.json" --format csv
has "nor in the CSV" "$(printf '%s\n' "$out" | sed -n 2p)" '[0-9],,,,$'
run stack "$SRC/share/scenes/rest.json"
has "a place where there is one" "$out" '"rest":\{"x_m":-?[0-9.]+,"y_m":-?[0-9.]+,"heading_deg"'
# flanks differ by model year
run run "$SRC/share/scenes/pole-side.json"
has "a flank without a year is told" "$out" '"code":.*"side-year"'
sed 's/"kind": *"vehicle"/&, "built": 2012/' "$SRC/share/scenes/pole-side.json" >"$tmp/old.json"
run run "$tmp/old.json"
empty "not one whose year is given" "$(printf '%s\n' "$out" | grep side-year)"
wall_scene >"$tmp/wall.json"
has "explain tells how long an elastic phase lasts" \
    "$("$crumple" -e "load $tmp/wall.json" -e solve -e "explain last" 2>&1)" \
    'the elastic impulse of [0-9]+ N s works over [1-9][0-9]*\.[0-9] ms'
finish
