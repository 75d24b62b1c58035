#!/bin/sh
# share/schema/scene.schema.json is a valid schema, accepts every scene of the tree and refuses the
# bad ones that a schema can see; those that only the program can see are listed by name.
. "$SRC/tests/tap.sh"
need_jsonschema
check() {
    python3 - "$SRC/share/schema/scene.schema.json" "$@" <<'PY'
import json, sys
import jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for path in sys.argv[3:]:
    good = validator.is_valid(json.load(open(path)))
    if good != (sys.argv[2] == "accept"):
        print(path, "is accepted" if good else "is refused")
PY
}
cases=$SRC/tests/cases/scene
empty "good scenes are accepted" \
    "$(check accept "$SRC"/share/scenes/*.json "$SRC"/share/validation/*/*.json \
        "$SRC"/tests/bench/*.json 2>&1)"
# those that are listed, or are not
listed() {
    word=$1
    set --
    for case in "$cases"/*.json; do
        name=$(basename "$case" .json)
        case $name in syntax-*) continue ;; esac
        if grep -qx "$name" "$cases/schema-accepts"; then
            [ "$word" = refuse ] || set -- "$@" "$case"
        else
            [ "$word" = accept ] || set -- "$@" "$case"
        fi
    done
    check "$word" "$@" 2>&1
}
empty "bad scenes are refused" "$(listed refuse)"
empty "what is listed as out of reach is accepted" "$(listed accept)"
finish
