#!/bin/sh
# crumple validate: the installed crash tests, own ones, forms of the table, targets that can fail.
. "$SRC/tests/cli/cli.sh"

run validate car-to-car pulse
same "the scenes of the tree are solved" "$status:$errs" "0:"
has "both methods side by side" "$out" 'paper +extended'
has "with the published figures" "$out" '^ delta-v +10 .* -1\.2 +14\.2 +10\.7'
has "pulses are rated" "$out" 'camry-10146 Camry, extended: RMS error [0-9.]+ g, ISO/TS 18571 0\.'
has "and have targets" "$out" '(met|missed) +camry-10146: ISO/TS 18571 rating'
cp "$tmp/out" "$tmp/first"
run validate --jobs 1 car-to-car pulse --picture "$tmp/points.svg"
same "the same bytes with one thread" "$(cksum <"$tmp/out")" "$(cksum <"$tmp/first")"
table=$(printf '%s\n' "$out" | sed -n 's/^ delta-v  *\([0-9]*\) .*/\1/p' |
    awk '{ n += $1 } END { print n }')
picture=$(sed -n 's/.*>delta-v, extended: \([0-9]*\) values<.*/\1/p' "$tmp/points.svg")
same "the picture has the tests of the table" "$picture" "$table"
has "each class by its own sign" "$(cat "$tmp/points.svg")" '>car-to-car<'
run validate pulse --fast --picture "$tmp/few.svg"
has "a picture of too few tests" "$errs" 'no picture: nothing was measured in 5 tests'
has "leaves the table" "$out" '^ delta-v  *1 '
refused "a picture in another form is told before" 2 'ends in .svg' validate --picture x.gif
run validate pulse --format json --cases
if command -v python3 >/dev/null 2>&1; then
    same "JSON is JSON" "$(printf '%s' "$out" | python3 -c 'import json, sys
d = json.load(sys.stdin); print(d["cases"][0]["id"], len(d["rows"]) > 5)')" "camry-10146 True"
else
    skip "JSON is JSON" "no python3"
fi
run validate pulse --format csv
has "CSV has a row per measure and method" "$out" '^pulse,all,ees_kmh,km/h,1,paper,1,'
run validate pulse --method paper
same "one method alone has no targets" "$(printf '%s' "$out" | grep -c target)" 0

# the tests of the paper: its method gives what it reports, as far as that is public
run validate paper --method paper
has "18 cars" "$out" 'the tests of the paper, by type: 18 measured'
has "what nobody can repeat stands alone" "$out" '^   offset +0 +- +- +- +- +\+14\.6'
run validate paper --method paper --format csv
paper() { # group, measure, field (8 MPE, 10 MAPE), from, to: whether the value is in that range
    printf '%s\n' "$out" | awk -F, -v g="$1" -v m="$2" -v f="$3" -v lo="$4" -v hi="$5" '
        $2 == g && $3 == m { n++; good = $f >= lo && $f <= hi } END { print n + 0, good + 0 }'
}
same "frontal delta-v within 6.0 % (MAPE)" "$(paper frontal delta_v_kmh 10 0 6)" "1 1"
same "EES of the Q7 at -5 %" "$(paper "Audi Q7 2006" ees_kmh 8 -9 -1)" "1 1"
same "EES of the Fiat between 0 and +20 %" "$(paper "Fiat 500 2007" ees_kmh 8 0 20)" "1 1"
same "full widths a tenth too shallow" "$(paper full-width face_depth_m 8 -14.6 -4.6)" "1 1"
same "poles much too deep" "$(paper pole face_depth_m 8 40 150)" "1 1"
run validate paper --cases --format json
if command -v python3 >/dev/null 2>&1; then
    same "JSON has them all" "$(printf '%s' "$out" | python3 -c 'import json, sys
d = json.load(sys.stdin)
q7 = [r["impactees"]["mpe"] for r in d["rows"] if r["group"] == "Audi Q7 2006"]
print(len(d["cases"]), q7)')" "18 [-5]"
    mkdir -p "$tmp/again/share/validation/paper" "$tmp/again/share"
    cp -R "$SRC/models" "$tmp/again/"
    cp -R "$SRC/share/calibration" "$tmp/again/share/"
    cp -R "$SRC/share/validation/data" "$tmp/again/share/validation/"
    cp "$SRC/share/validation/paper/make-scenes.py" "$tmp/again/share/validation/paper/"
    python3 "$tmp/again/share/validation/paper/make-scenes.py"
    cp "$SRC"/share/validation/paper/README.md "$SRC"/share/validation/paper/.gitignore \
        "$tmp/again/share/validation/paper/" 2>/dev/null
    same "the scenes are what their script makes" \
        "$(diff -r "$SRC/share/validation/paper" "$tmp/again/share/validation/paper")" ""
else
    skip "JSON has them all" "no python3"
    skip "the scenes are what their script makes" "no python3"
fi

# classes judged by the medians of groups
run validate rear narrow barriers --method extended --worst 0
has "real rear crashes are solved" "$out" '^struck from behind: 86 measured vehicles$'
has "by band of delta-v" "$out" '^ +16-24 km/h, cm +28 '
has "with a target for each band" "$out" '(met|missed) +rear, delta-v 24-32 km/h: median crush, cm'
has "trees and poles by their median" "$out" '(met|missed) +narrow, trees and poles: median ratio'
has "a barrier verifies itself" "$out" '^ met +barriers, UN R95 on a wall at 35 km/h: depth'

# the form of flanks under the US NCAP barrier: six types in the mean and each, and the area
run validate side-mdb --method extended --worst 0
has "flanks under a barrier" "$out" '^flank struck by the US NCAP barrier: 6 measured vehicles$'
same "depth in the mean, of each type, and area are as measured" \
    "$(printf '%s\n' "$out" | grep -c '^ met     side-mdb: ')" 3

# who takes how much: a movable barrier, its progressive face 1.75 m wide, meets the ODB with 40 %
# of it; BASt computed an EES of 44.5 km/h, which leaves 0.37 of the energy to the ODB [MPDB]
mkdir -p "$tmp/bast/share"
cp -R "$SRC/models" "$tmp/bast/"
cp -R "$SRC/share/irf" "$SRC/share/barriers" "$tmp/bast/share/"
sed 's/"mass_kg": 1400/"mass_kg": 1600/; s/"carriage_width_m": 1.5/"carriage_width_m": 1.75/
    s/\[-0.5, 0.5\]/[-0.875, 0.875]/; s/\[0.15, 0.718\]/[0.15, 0.85]/' \
    "$SRC/share/barriers/mpdb.json" >"$tmp/bast/share/barriers/mpdb.json"
scene bast.json '{ "crumple": 1, "participants": [
  { "id": "M", "kind": "object", "shape": "barrier", "barrier": "mpdb",
    "position_m": [2.6, 0.675], "heading_deg": 180, "speed_kmh": 56 },
  { "id": "W", "kind": "object", "shape": "barrier", "barrier": "odb",
    "position_m": [0, 0], "heading_deg": 0 } ] }'
CRUMPLE_DATA=$tmp/bast "$crumple" stack "$tmp/bast.json" >"$tmp/out" 2>"$tmp/errs"
ees=$(sed 's/.*"id":"M","kind":"object","ees_kmh":\([0-9.]*\).*/\1/' "$tmp/out")
share=$(sed 's/.*"barrier":{"name":"odb"[^}]*"energy_share":\([0-9.]*\).*/\1/' "$tmp/out")
awk -v e="$ees" -v s="$share" 'BEGIN { exit !(e > 42.2 && e < 46.8 && s > 0.32 && s < 0.42) }'
report $? "EES within 5 % of 44.5 km/h ($ees), share of the ODB 0.37 within 0.05 ($share)"

# own tests
cat >"$tmp/own.csv" <<'END'
# two cars like the Camry
test_no,make,model,year,body,mass_kg,speed_kmh,veh_width_mm,c1,c2,c3,c4,c5,c6
1,Toyota,Camry,2018,S,1719,57.09,1837,380,466,511,518,489,370
2,Toyota,Camry,2018,S,1719,40.2,1837,190,230,260,260,240,190
END
run validate "$tmp/own.csv" --cases
has "a table of own walls" "$out" 'own tests: 2 measured'
has "with its rows" "$out" '1 car \(2018 Toyota Camry, sedan, 57\.1 km/h\)'
run validate "$tmp/own.csv" --scenes "$tmp/scenes" --worst 1
has "scenes are written to be opened" "$out" 'scenes/[12]\.json'
run run "$tmp/scenes/1.json"
same "and can be solved" "$status" 0
sed 's/^2,/..\/2,/' "$tmp/own.csv" >"$tmp/bad.csv"
run validate "$tmp/bad.csv" --scenes "$tmp/scenes" --worst 1
same "and stay in their folder, whatever a test is called" \
    "$(ls "$tmp/scenes/..-2.json" "$tmp/2.json" 2>/dev/null)" "$tmp/scenes/..-2.json"
sed 's/^2,/"2"", ""x_a"": ""b",/' "$tmp/own.csv" >"$tmp/bad.csv"
run validate "$tmp/bad.csv" --scenes "$tmp/scenes" --worst 1
same "and say what they would, whatever a test is called" \
    "$status:$(grep -c x_a "$tmp/scenes"/2*x_a*.json)" 0:1
run run "$tmp/scenes"/2*x_a*.json
has "as its name" "$out" "\"scene\":	\"2', 'x_a': 'b\""
run validate "$SRC/share/validation/pulse/camry-10146.json"
has "an own scene with expectations" "$out" 'own tests: 1 measured'
sed 's/c1,/x1,/' "$tmp/own.csv" >"$tmp/bad.csv"
refused "a table of something else" 3 'bad.csv.*neither.*c1 to c6' validate "$tmp/bad.csv"
sed 's/57.09/fast/' "$tmp/own.csv" >"$tmp/bad.csv"
refused "a text where a number belongs" 3 'bad.csv:3:.*fast.*speed_kmh' validate "$tmp/bad.csv"
sed 's/1719,57/,57/' "$tmp/own.csv" >"$tmp/bad.csv"
refused "a missing mass" 3 'bad.csv:3:.*mass_kg' validate "$tmp/bad.csv"
refused "a scene without expectations" 3 'x_expect' validate "$demo"
refused "an unknown class" 2 'did you mean pole' validate poles

# side poles: every class at the depth of its median car, and the damaged area of all
"$crumple" validate pole --method extended --format csv --cases >"$tmp/pole.csv"
median() { # type, field: 10 measured, 11 computed
    awk -F, -v t="$1" -v f="$2" '$5 == t && $7 == "extended" && $8 == "face_depth_m" { print $f }' \
        "$tmp/pole.csv" | sort -n |
        awk '{ x[NR] = $1 }
             END { print (x[int((NR + 1) / 2)] + x[int((NR + 2) / 2)]) / 2 }'
}
for type in mini-compact compact sedan suv; do
    measured=$(median $type 10) computed=$(median $type 11)
    awk -v m="$measured" -v c="$computed" \
        'BEGIN { exit !(m > 0.2 && c > 0.95 * m && c < 1.05 * m) }'
    report $? "pole, $type: median depth $computed m, measured $measured m, within 5 %"
done
run validate pole --fast --method extended
area=$(printf '%s\n' "$out" | grep 'median damaged area')
has "pole:$(printf '%s' "$area" | tr -s ' ' | cut -d: -f2)" "$area" '^ met '

# a deliberately wrong model: with nothing dragged along the pole goes in much deeper
mkdir "$tmp/models"
for recipe in "$SRC"/models/*.json; do
    sed 's/"drag_slope": [0-9.]*/"drag_slope": 0/' "$recipe" \
        >"$tmp/models/$(basename "$recipe")"
done
run validate pole --fast --method extended --models "$tmp/models" --targets
same "a wrong model fails" "$status" 1
has "in the depth of the poles" "$out" 'missed +pole: MPE of depth residual'

# cross-validation, with a few poles of the tables
mkdir -p "$tmp/data/share/validation/data"
cp -R "$SRC/models" "$tmp/data/models"
cp -R "$SRC/share/irf" "$SRC/share/calibration" "$tmp/data/share/"
cp "$SRC"/share/validation/data/*_pulse.csv "$SRC"/share/validation/data/camry*.csv \
    "$tmp/data/share/validation/data/"
head -n 60 "$SRC/share/validation/data/frontal_wall.csv" \
    >"$tmp/data/share/validation/data/frontal_wall.csv"
head -n 14 "$SRC/share/validation/data/side_pole.csv" \
    >"$tmp/data/share/validation/data/side_pole.csv"
CRUMPLE_DATA=$tmp/data
export CRUMPLE_DATA
run validate pole --format csv
same "folds are solved" "$status:$errs" "0:"
fit=$(printf '%s\n' "$out" | grep '^pole,all,face_depth_m,m,1,extended,10,')
cross=$(printf '%s\n' "$out" | grep '^pole,all,face_depth_m,m,1,cross-validated,10,')
has "fit and cross-validation of the same tests" "$fit$cross" extended.*cross
[ "${fit#*extended}" != "${cross#*validated}" ]
report $? "with other numbers, as the models are others"

# a calibration with the same few tests: one sedan only has a spread that is none
run calibrate --write "$tmp/data/models"
same "the faces are fitted" "$status:$errs" "0:"
empty "numbers that are none are dashes" "$(printf '%s\n' "$out" | grep -wE 'nan|inf')"
cmp "$SRC/models/sedan.json" "$tmp/data/models/sedan.json" >"$tmp/why"
same "and the recipes written" $? 1
run run "$SRC/share/scenes/pole-side.json"
same "with which scenes are solved" "$status:$errs" "0:"
finish
