#!/bin/sh
# crumple models: list, description, pictures, export and import, a deformation on the 3D model.
. "$SRC/tests/cli/cli.sh"

run models
same "the list succeeds" "$status" 0
types=$(find "$SRC/models" -name '*.json' | wc -l)
same "it names twelve models for each type" \
    "$(printf '%s\n' "$out" | grep -cE '^[a-z-]+/[0-9]+ ')" $((12 * types))
same "all fronts and sides of a type rest on tests of their own type" \
    "$(printf '%s\n' "$out" | awk '$1 ~ "/" && $2 ~ /^(front|side)$/ && $3 > 0' | wc -l)" \
    $((9 * types))
same "the rear says that it is an assumption" \
    "$(printf '%s\n' "$out" | awk '$2 == "rear"' | grep -c 'assumption')" $((3 * types))
run models --format=json
same "as JSON too" "$(printf '%s\n' "$out" | grep -c '"model":')" $((12 * types))
run models sedan
has "a type shows its faces" "$out" 'EES of a whole face'
has "and its structures" "$out" 'engine block'
has "and where it comes from" "$out" 'NHTSA'

for view in side top front slice; do
    run models suv/12 --view $view --ascii --width 70
    same "the $view view is drawn" "$status" 0
    same "within its width" "$(printf '%s\n' "$out" | tail -n +3 | grep -cE '^.{71}')" 0
    has "with a scale" "$out" '1 m +EES 0'
done

run models sedan/1 --flat --to "$tmp/flat.json"
same "the 2D model is exported" "$status$out$errs" 0
run models sedan/1 --voxel 100 --to "$tmp/full.csv"
same "the 3D model is exported as CSV" "$status$out$errs" 0
for file in flat.json full.csv; do
    run models "$tmp/$file" --to "$tmp/again-$file"
    same "$file is read" "$status$errs" 0
    grep -v '^"provenance"' "$tmp/$file" | cmp -s - "$tmp/again-$file"
    report $? "$file comes back with every byte"
done

# a wall scene with the type's own model and with its export: the same numbers, to the last digit
scene() {
    cat <<JSON
{ "crumple": 1, "name": "own", "participants": [
  { "id": "A", "kind": "vehicle", "type": "sedan", "mass_kg": 1666, "length_m": 4.857,
    "width_m": 1.833, "height_m": 1.454, "wheelbase_m": 2.791, "track_m": 1.56,
    "front_overhang_m": 0.97, "cg": { "behind_front_axle_m": 1.179, "height_m": 0.547 },
    "model": $1, "position_m": [-3.5, 0], "speed_kmh": 50 },
  { "id": "W", "kind": "object", "shape": "wall", "position_m": [0, 0], "heading_deg": 160 } ] }
JSON
}
scene '{ "pdof": 1 }' >"$tmp/type.json"
scene '{ "file": "flat.json" }' >"$tmp/own.json"
numbers() {
    "$crumple" run -f csv --trace "$1" 2>&1 | sed 's/sedan.1//; s/file[^,]*//'
}
same "an exported model solves like the type, digit by digit" \
    "$(numbers "$tmp/own.json" | cksum)" "$(numbers "$tmp/type.json" | cksum)"

# the example of the manual of models
sed -n '/^```json$/,/^```$/p' "$SRC/share/doc/models.md" | grep -v '^```' >"$tmp/barrier.json"
run models "$tmp/barrier.json"
same "the example of models.md is read" "$status$errs" 0
scene '{ "file": "barrier.json" }' >"$tmp/own.json"
run run "$tmp/own.json"
same "and solves" "$status" 0

run models --crash "$tmp/type.json" --view top --ascii --width 80
same "a crash is carried back" "$status" 0
has "deformed voxels show their depth" "$out" '[0-4]{3}'
has "with a legend" "$out" 'deformed, depth in dm'
run models --crash "$tmp/own.json" --view top
same "also onto voxels of its own, which lie beside the scene" "$status$errs" 0
run models --crash "$tmp/type.json" --id Z
same "no such participant" "$status" 3
has "is named" "$errs" 'no vehicle "Z"'

fails() { # NAME STATUS PATTERN ARGUMENTS
    name=$1 want=$2 pattern=$3
    shift 3
    run models "$@"
    same "$name: status" "$status" "$want"
    has "$name: message" "$errs" "$pattern"
}
fails "unknown type" 3 'did you mean sedan/12' sedam/12
fails "thirteen o'clock" 3 'sedan/1 to sedan/12' sedan/13
fails "no suffix" 2 'neither .json nor .csv' sedan/12 --to "$tmp/model"
fails "too many voxels" 3 'more than 50 million' suv/12 --voxel 5
fails "voxels of a file" 2 'leave out' "$tmp/flat.json" --voxel 20
fails "a side of a flat model" 3 'use the top view' "$tmp/flat.json" --view side
fails "a slice beside the car" 2 'up to 0.9' sedan/12 --view slice --at 2
fails "a picture of a type" 2 'name one, sedan/12' sedan --view side
fails "a picture of nothing" 2 'nothing is drawn' --flat
fails "a place without a slice" 2 'for --view slice' sedan/12 --view side --at 0.3
fails "a vehicle without a scene" 2 'for a scene .*--crash' sedan/12 --id A
fails "export without a name" 2 'wants the NAME' --to "$tmp/x.json"
fails "unwritable" 2 'cannot' sedan/12 --to "$tmp/none/x.json"
fails "not there" 2 'none.json' "$tmp/none.json"
echo '{ "crumple_voxels": 1, "edge_m": 0.05' >"$tmp/broken.json"
fails "broken file" 3 'broken.json:' "$tmp/broken.json"
finish
