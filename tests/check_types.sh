#!/bin/sh
# A vehicle type is one file of models/: the list of types comes from the folder, and no file of src
# names a type that was added to those of the paper.
. "$SRC/tests/tap.sh"
cd "$SRC" || exit 99
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT

types() { # FOLDER
    sh src/model/type_list.sh "$1" "$tmp/list" && sed -n 's/^ *X(\(.*\)).*/\1/p' "$tmp/list"
}
mkdir "$tmp/models"
cp models/*.json "$tmp/models/"
sed 's/"mass_kg": *[0-9.]*/"mass_kg": 1/' models/compact.json >"$tmp/models/road-ster.json"
same "a recipe that is added is a type, the lightest first" "$(types "$tmp/models")" \
    "$(echo 'ROAD_STER, "road-ster"' && types models)"

added=$(sed -n 's/.*"apart": \[\(.*\)\].*/\1/p' share/calibration/types.json | tr -d '",')
[ "$(printf '%s\n' "$added" | wc -w)" -ge 3 ]
report $? "types were added to those of the paper: $added"
for type in $added; do
    name=$(printf '%s' "$type" | tr 'a-z-' 'A-Z_')
    empty "no file of src names the type $type" \
        "$(grep -rnE --include='*.[ch]' "CR_TYPE_$name\\b|cr_type_find\\(\"$type\"" src)"
done
finish
