#!/bin/sh
# Scenes that cannot be solved: each gets one line with its place and the way out, and its status.
. "$SRC/tests/cli/cli.sh"
cd "$tmp" || exit 99

# bad NAME STATUS PATTERN TEXT
bad() {
    scene bad.json "$4"
    refused "$1" "$2" "^bad\.json.*error: .*$3" run bad.json
}
# car NAME PATTERN MEMBERS: a car into a wall, with members that cannot be
car() {
    bad "$1" 3 "$2" "$(wall_scene "" "$3")"
}

bad "empty file" 3 '.' ''
bad "broken JSON has line and column" 3 '.' '{ "crumple": 1,
  "name": }'
has "and they are right" "$errs" '^bad\.json:2:11: '
bad "truncated JSON" 3 '.' '{ "crumple": 1, "participants": ['
bad "text after the scene" 3 '.' '{ "crumple": 1, "participants": [] } x'
bad "an array is no scene" 3 'object' '[1, 2]'
bad "no version" 3 'crumple' '{ "participants": [] }'
bad "version of the future" 3 'crumple' '{ "crumple": 2, "participants": [] }'
bad "no participants" 3 'participants' '{ "crumple": 1 }'
bad "nobody takes part" 3 'participants' '{ "crumple": 1, "participants": [] }'
bad "unknown key of the scene" 3 'setings.*settings' \
    '{ "crumple": 1, "setings": {}, "participants": [] }'
bad "unknown setting" 3 '/settings.*voxel_m.*voxel_mm' \
    '{ "crumple": 1, "settings": { "voxel_m": 25 }, "participants": [] }'
bad "a key given twice" 3 'name' '{ "crumple": 1, "name": "a", "name": "b", "participants": [] }'

car "misspelt key" '/participants/0.*masskg.*mass_kg' '"masskg": 1400'
has "a misspelt key has its line" "$errs" '^bad\.json:4:'
car "text for a number" '/participants/0/length_m' '"length_m": "long"'
car "a number for a text" '/participants/0/model' '"model": 5'
car "a car of 1 km" '/participants/0/length_m' '"length_m": 1000'
car "a number beyond all bounds" '/participants/0/height_m' '"height_m": 1e308'
car "a number that overflows" '.' '"height_m": 1e999'
car "NaN is no JSON" '.' '"height_m": NaN'
car "negative width" '/participants/0/width_m' '"width_m": -1.8'
car "brake beyond 1" '/participants/0/brake' '"brake": 3'
car "PDOF o'clock beyond 12" '/participants/0/model/pdof' '"model": { "pdof": "13 o clock" }'
scene file.json "$(wall_scene "" '"model": { "file": "own.json" }')"
refused "own model that is not there" 2 'own.json: error: .*No such file' run file.json
scene own.json '{ "voxels": "none" }'
refused "own model that is none" 3 'own.json:1:3: error: .*unknown key' run file.json
scene mass.json "$(wall_scene | sed 's/1400/0/')"
refused "mass 0" 3 '/participants/0/mass_kg' run mass.json
scene mass.json "$(wall_scene | sed 's/1400/-1400/')"
refused "negative mass" 3 '/participants/0/mass_kg' run mass.json
scene type.json "$(wall_scene | sed 's/"compact"/"compcat"/')"
refused "unknown type has the nearest" 3 '/participants/0/type.*compact' run type.json
scene twice.json "$(wall_scene | sed 's/"wall", "kind"/"A", "kind"/')"
refused "two of one name" 3 '/participants/1.*A' run twice.json
scene shape.json "$(wall_scene | sed 's/"shape": "wall"/"shape": "wal"/')"
refused "unknown shape" 3 '/participants/1/shape.*wall' run shape.json

pole='{ "id": "P", "kind": "object", "shape": "pole", "position_m":'
bad "overlap at the start" 3 'overlap' "$(wall_scene "$pole [1, 0], \"radius_m\": 0.2 }")"
# the way out that the message names leads out: a car sideways in another, and one along a wall
other='{ "id": "B", "kind": "vehicle", "type": "suv", "mass_kg": 2000, "speed_kmh": 40,
  "position_m":'
for clash in "$other [1.2, 3], \"heading_deg\": 250 }" "$other [-2.6, 0], \"heading_deg\": 0 }" \
    "$pole [1, 0], \"radius_m\": 0.2 }"; do
    scene clash.json "$(wall_scene "$clash")"
    refused "overlap: ids, pointer and way out" 3 \
        'clash.json:[0-9]+:[0-9]+: error: /participants/[01]/position_m: "A" and "B|P" .*move' \
        run clash.json
    to=$(sed -n 's/.*move "\(.\)".*to x=\(.*\) m y=\(.*\) m).*/\1.position_m=[\2,\3]/p' errs)
    run run clash.json --set "$to" -o out.json
    same "moved as it says ($to) it is solved" "$status$errs" 0
done
bad "they never meet" 4 'meet|contact' "$(wall_scene "$pole [-20, 9], \"radius_m\": 0.2 }")"
bad "a pole without a radius" 3 'radius_m' "$(wall_scene "$pole [5, 0] }")"
bad "nobody else there" 3 'at least two participants' \
    "$(wall_scene | sed '/"wall"/,$d; s/50 },/50 } ] }/')"
finish
