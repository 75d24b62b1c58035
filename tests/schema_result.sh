#!/bin/sh
# share/schema/result.schema.json is a valid schema, accepts every result of the tree's scenes and
# refuses results that are wrong in one place each.
. "$SRC/tests/tap.sh"
need_jsonschema
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
cat >"$tmp/check.py" <<'PY'
import copy, json, sys
import jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft202012Validator.check_schema(schema)
kind = {k: jsonschema.Draft202012Validator({**schema, "oneOf": [{"$ref": "#/$defs/" + k}]})
        for k in ("solved", "error", "pair")}
faults = []

def best(k, value):
    error = jsonschema.exceptions.best_match(kind[k].iter_errors(value))
    return error and "%s: %s" % ("/".join(map(str, error.absolute_path)), error.message[:200])

def accept(name, k, value):
    wrong = best(k, value)
    if wrong:
        faults.append("%s refused: %s" % (name, wrong))

def refuse(name, k, value):
    if kind[k].is_valid(value):
        faults.append("%s was accepted" % name)

def drop(value, *path):
    value = copy.deepcopy(value)
    at = value
    for key in path[:-1]:
        at = at[key]
    del at[path[-1]]
    return value

def put(value, new, *path):
    value = copy.deepcopy(value)
    at = value
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = new
    return value

seen = set()

def new(what, keys):
    """The keys of such an object that no scene before had: what demands them is the same list."""
    fresh = [k for k in keys if (what, k) not in seen]
    seen.update((what, k) for k in keys)
    return fresh

error = {"crumple_result": 2, "scene": "x",
         "error": {"code": "no-contact", "message": "m", "where": ""}}
accept("an error object", "error", error)
refuse("an error without a code", "error", drop(error, "error", "code"))
for line in open(sys.argv[2]):
    got = json.loads(line)
    accept("line of a stack", "error" if "error" in got else "pair" if "pair" in got
           and "scenes" in got else "solved", got)
for path in sys.argv[3:]:
    got = json.load(open(path))
    accept(path, "solved", got)
    got.pop("trace")  # optional, and by far the most to go through each time
    cars = [i for i, p in enumerate(got["participants"]) if "kind" not in p]
    for key in new("result", got):
        if key not in ("pair", "contacts"):
            refuse("%s without %s" % (path, key), "solved", drop(got, key))
    for i in cars[:1]:
        for key in new("car", got["participants"][i]):
            refuse("%s without %s of a car" % (path, key), "solved",
                   drop(got, "participants", i, key))
        refuse("negative EES", "solved", put(got, -1, "participants", i, "ees_kmh"))
        refuse("clock 13", "solved", put(got, 13, "participants", i, "pdof_clock"))
        refuse("CDC of nowhere", "solved", put(got, "12XDEW2", "participants", i, "cdc"))
        refuse("an unknown key", "solved", put(got, 1, "participants", i, "ess_kmh"))
    for i, impact in enumerate(got["impacts"][:1]):
        for key in new("impact", impact):
            refuse("%s without %s of an impact" % (path, key), "solved",
                   drop(got, "impacts", i, key))
        for key in new("car of an impact", impact["vehicles"][0]):
            refuse("%s without %s of a car in an impact" % (path, key), "solved",
                   drop(got, "impacts", i, "vehicles", 0, key))
        refuse("an outline of an impact", "solved",
               put(got, [], "impacts", i, "vehicles", 0, "deformation_outline_m"))
        if not impact["vehicles"]:
            faults.append("%s: an impact of nobody" % path)
    refuse("an unknown stop", "solved", put(got, "tired", "time", "stop"))
    refuse("a short hash", "solved", put(got, "abc", "input", "scene_sha256"))
print("\n".join(faults))
PY
for scene in "$SRC"/share/scenes/*.json; do
    [ -f "$scene" ] || continue
    name=$(basename "$scene")
    "$CRUMPLE" run --trace "$scene" >"$tmp/$name" 2>"$tmp/err"
    same "$name is solved" "$?:$(cat "$tmp/err")" "0:"
    [ -s "$tmp/$name" ] && set -- "$@" "$tmp/$name"
done
printf '%s\n' "{ \"crumple\": 1 }" >"$tmp/bad.json"
"$CRUMPLE" stack "$SRC/share/scenes" "$tmp/bad.json" >"$tmp/lines" 2>"$tmp/err"
same "a stack of them all" "$?:$(cat "$tmp/err")" 1:
same "with an error" "$(grep -c '"error"' "$tmp/lines")" 1
same "and a pair" "$(grep -c '"scenes"' "$tmp/lines")" 1
set -- "$tmp/lines" "$@"
empty "the schema takes good results and refuses bad ones" \
    "$(python3 "$tmp/check.py" "$SRC/share/schema/result.schema.json" "$@" 2>&1)"
finish
