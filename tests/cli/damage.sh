#!/bin/sh
# crumple damage: files of one and two vehicles, forms, intervals, faults with their place.
. "$SRC/tests/cli/cli.sh"

crush='"face": "front", "field_length_m": 1.4, "crush_m": [0.3, 0.32, 0.33, 0.33, 0.3, 0.25]'
# pair DAMAGE_OF_A REST: a damage file
pair() {
    cat <<END
{ "crumple_damage": 1, "vehicles": [
    { "id": "A", "type": "sedan", "mass_kg": 1600, "damage": { $1 } },
    { "id": "B", "type": "compact", "mass_kg": 1300,
      "damage": { "face": "rear", "field_length_m": {"value": 1.2, "tolerance": 0.1},
                  "crush_m": [0.1, 0.2, 0.2, 0.2, 0.2, 0.1] } } ]$2 }
END
}
pair "$crush" >"$tmp/pair.json"
run damage "$tmp/pair.json"
same "two vehicles" "$status:$errs" "0:"
empty "no number of them is without its interval" "$(printf '%s\n' "$out" |
    grep -E '^  [a-zA-Z]' | grep -vE ' 95 %: |^  crush |^  CDC |uncertain by')"
has "EES with its interval" "$out" '^  EES +[0-9.]+ km/h +95 %: [0-9.]+ to [0-9.]+$'
has "delta-v with its interval" "$out" '^  delta-v +[0-9.]+ km/h +95 %: [0-9.]+ to [0-9.]+$'
has "closing speed" "$out" '^  closing speed +[0-9.]+ km/h'
has "CDC" "$out" 'CDC +12FDEW[1-9]'
has "what the interval comes from" "$out" 'uncertain by type [0-9]+ %, tape'
run damage "$tmp/pair.json" --picture --width 80 --ascii
has "a picture from above" "$out" '^ A  sedan  top'
has "and from the side" "$out" '^ B  compact  side'
run damage "$tmp/pair.json" -f json
if command -v python3 >/dev/null 2>&1; then
    same "JSON keeps momentum" "$(printf '%s' "$out" | python3 -c 'import json, sys
d = json.load(sys.stdin); a, b = d["vehicles"]
j = [v["mass_kg"]["value"] * v["delta_v_kmh"]["value"] for v in (a, b)]
print(abs(j[0] - j[1]) < 1e-6 * j[0], a["ees_kmh"]["low"] < a["ees_kmh"]["value"],
      abs(sum(a["variance_shares"].values()) - 1) < 1e-9)')" "True True True"
else
    skip "JSON keeps momentum" "no python3"
fi

sed '/"id": "B"/,/\]/d; s/} },$/} } ] }/' "$tmp/pair.json" >"$tmp/one.json"
echo '{ "crumple_damage": 1, "vehicles": [ { "id": "A", "type": "sedan", "mass_kg": 1600,
  "damage": { '"$crush"' } } ] }' >"$tmp/one.json"
run damage "$tmp/one.json"
has "one vehicle alone has its EES" "$out" '^  EES +[0-9.]+'
has "and is told what is missing" "$out" 'delta-v needs its partner'
echo '{ "crumple_damage": 1, "object": {}, "vehicles": [ { "id": "A", "type": "sedan",
  "mass_kg": 1600, "damage": { "face": "right", "pdof_deg": 75, "field_offset_m": 0.3,
  "outline_m": [[-0.7, 0], [0, 0.35], [0.7, 0]], "height_m": [0.2, 1.2] } } ] }' >"$tmp/tree.json"
run damage "$tmp/tree.json"
has "an outline, at a tree" "$out" '^  delta-v +[0-9.]+'

cat >"$tmp/pair.csv" <<'END'
id,type,mass_kg,face,field_length_m,pdof_deg,c1_m,c2_m,c3_m
A,sedan,1600,front,1.4,0,0.3,0.33,0.3
B,compact,1300,rear,1.2,,0.1,0.2,0.1
END
run damage "$tmp/pair.csv"
has "a table, a row per vehicle" "$out" \
    '^B: compact 1300 \+- 39 kg, rear, field 1\.20 \+- 0\.05 m'
has "and its stations" "$out" '^  crush 10 20 10 \+- 3 cm$'
cat >"$tmp/full.csv" <<'END'
id,type,car,mass_kg,mass_tolerance_kg,face,field_length_m,field_length_tolerance_m,ride,c1_m,c2_m
A,sedan,,1600,25,front,1.4,0.02,under,0.3,0.33
B,,golf 2015,,,rear,,,,unknown,
END
run damage "$tmp/full.csv"
has "tolerances of a table" "$out" \
    '^A: sedan 1600 \+- 25 kg, front, field 1\.40 \+- 0\.02 m'
has "an underride" "$out" 'struck from 0\.51 m up$'
has "a car of the catalogue, and what was not measured of it" "$out" \
    '^  not measured: as deep as .* real crashes'
has "delta-v with a partner that was not measured" "$out" '^  delta-v +[0-9.]+ km/h +95 %'
sed '1s/$/,struck_low_m,struck_high_m/; 2s/$/,0.3,0.8/; 3s/$/,,/' \
    "$tmp/pair.csv" >"$tmp/heights.csv"
run damage "$tmp/heights.csv"
has "heights of a table" "$out" 'struck from 0\.30 m up to 0\.80 m$'
sed 's/,rear,/,roof,/' "$tmp/pair.csv" >"$tmp/bad.csv"
refused "a fault in a table has its line" 3 'bad\.csv:3.*front, left' damage "$tmp/bad.csv"

bad() { # NAME STATUS PATTERN DAMAGE [REST]
    pair "$4" "$5" >"$tmp/bad.json"
    refused "$1" "$2" "$3" damage "$tmp/bad.json"
}
bad "no face" 3 'bad\.json:[0-9]+:[0-9]+: .*no "face"' '"field_length_m": 1.4, "crush_m": [0, 0]'
bad "a face that is none" 3 'front, left, rear or right' '"face": "top"'
bad "one station" 3 'array of 2 to 64' '"face": "front", "crush_m": [0.1]'
bad "no length" 3 'no length' '"face": "front", "crush_m": [0.1, 0.2]'
bad "an outline outside the car" 3 'outside' "$crush, \"field_offset_m\": 1.5"
bad "depths in cm" 3 'C1 of 30' '"face": "front", "field_length_m": 1.4, "crush_m": [30, 20]'
bad "a force that pulls" 3 'pulls' "$crush, \"pdof_deg\": 170"
bad "an unknown key" 3 'bad\.json:[0-9]+:.*unknown key.*field_length_m' "$crush, \"width_m\": 1"
bad "two vehicles and an object" 3 'too many' "$crush" ', "object": {}'
echo '{ "crumple_damage": 1, "vehicles": [ { "id": "A", "type": "sedan", "mass_kg": 1600,
  "damage": { "face": "front", "crush_m": "unknown" } } ] }' >"$tmp/bad.json"
refused "nobody was measured" 3 'bad\.json:2:.*needs the other' damage "$tmp/bad.json"
bad "a ride that is none" 3 'under or over' "$crush, \"ride\": \"beside\""
bad "an outline that goes back" 3 'bad\.json:[0-9]+:.*does not go on' \
    '"face": "front", "outline_m": [[0, 0.1], [-1, 0.1]]'
bad "a depth beyond all measure" 3 'A: C1 of 1e\+308 m does not fit the vehicle of [0-9.]+ m \(' \
    '"face": "front", "field_length_m": 1.4, "crush_m": [1e308, 0.1]'
bad "a depth that may be anything" 3 'tolerance of 1e\+300 m is more than the vehicle' \
    "$crush, \"crush_tolerance_m\": 1e300"
bad "a tolerance below nothing" 3 'a tolerance is not negative' \
    "$crush, \"crush_tolerance_m\": -0.05"
bad "a height too many" 3 'expected \[lower, upper\]' "$crush, \"height_m\": [0, 1, 2]"
pair '"face": "front", "field_length_m": 1.4, "crush_m": [ { "value": 0.2, "tolerance": 0.01 },
    { "value": 0.3, "tolerance": 0.005 } ]' >"$tmp/fine.json"
run damage "$tmp/fine.json"
has "stations that were measured better than usual" "$out" 'crush 20 30 \+- 1 cm'
bad "a force from anywhere" 3 'more than half a turn' \
    "$crush, \"pdof_deg\": {\"value\": 0, \"tolerance\": 400}"
pair "$crush" | sed 's/1600/{"value": 1600, "tolerance": 2000}/' >"$tmp/bad.json"
refused "a mass that may be anything" 3 'more than the mass of 1600 kg' damage "$tmp/bad.json"
sed 's/"vehicles"/"object": {"mass_kg": 1e-300}, "vehicles"/' "$tmp/tree.json" |
    sed 's/"object": {}, //' >"$tmp/bad.json"
refused "an object of no mass" 3 'a mass is 0.1 to 10000000 kg' damage "$tmp/bad.json"
awk 'BEGIN { printf "id,type,mass_kg,face,field_length_m"
    for (i = 1; i < 66; i++) printf ",c%d_m", i
    printf "\nA,sedan,1600,front,1.4"; for (i = 1; i < 66; i++) printf ",0.3"; print "" }' \
    >"$tmp/bad.csv"
refused "more stations than are taken" 3 'bad.csv:2.*2 to 64' damage "$tmp/bad.csv"
bad "restitution" 3 'restitution must' "$crush" ', "restitution": 2'
pair "$crush" | sed 's/"mass_kg": 1600, //' >"$tmp/bad.json"
refused "a missing mass" 3 'mass_kg' damage "$tmp/bad.json"
echo '{ "crumple": 1 }' >"$tmp/bad.json"
refused "a scene is no damage file" 3 'no damage file' damage "$tmp/bad.json"
refused "no file" 2 'cannot open|No such' damage "$tmp/none.json"
# beside a solve: what it leaves is its own measured crush
cat >"$tmp/solved.json" <<'END'
{ "crumple": 1, "settings": { "voxel_mm": 50, "dt_ms": 1 }, "participants": [
    { "id": "A", "kind": "vehicle", "type": "sedan", "mass_kg": 1600, "position_m": [0, 0],
      "speed_kmh": 50 },
    { "id": "wall", "kind": "object", "shape": "wall", "position_m": [4, 0],
      "heading_deg": 180 } ] }
END
echo '{ "crumple_damage": 1, "object": {}, "vehicles": [ { "id": "A", "type": "sedan",
  "mass_kg": 1600, "damage": { "face": "front", "field_length_m": 1.2,
  "crush_m": [0.1, 0.2, 0.3] } } ] }' >"$tmp/w.json"
run damage "$tmp/w.json" --solved="$tmp/solved.json"
has "the difference by station" "$out" '^  C2  at +\+0\.00 m +20\.0 +[0-9.]+ +[+-][0-9.]+$'
has "and what it is in all" "$out" 'root mean square .* [0-3] of 3 within'
if command -v python3 >/dev/null 2>&1; then
    run damage "$tmp/w.json" --solved="$tmp/solved.json" -f json
    crush=$(printf '%s' "$out" | python3 -c 'import json, sys
print(json.load(sys.stdin)["vehicles"][0]["solved"]["crush_m"])')
    sed "s/\[0.1, 0.2, 0.3\]/$crush/" "$tmp/w.json" >"$tmp/same.json"
    run damage "$tmp/same.json" --solved="$tmp/solved.json"
    has "none against itself" "$out" 'differences 0\.0 cm; 3 of 3 within'
else
    skip "none against itself" "no python3"
fi
sed 's/"id": "A"/"id": "C"/' "$tmp/solved.json" >"$tmp/other.json"
refused "a scene of others" 3 "other\.json: .*has no 'A'" damage "$tmp/w.json" \
    --solved="$tmp/other.json"
finish
