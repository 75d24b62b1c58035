#!/bin/sh
# The schemas of recipes and voxel models are valid, accept what the tree and the program write,
# and refuse what is wrong in one place.
. "$SRC/tests/tap.sh"
need_jsonschema
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
cat >"$tmp/check.py" <<'PY'
import copy, glob, json, sys
import jsonschema
folder, out = sys.argv[1], sys.argv[2]
def validator(name):
    schema = json.load(open("%s/share/schema/%s.schema.json" % (folder, name)))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)
recipe, voxels = validator("recipe"), validator("voxel-model")
faults = []
def check(what, v, value, good):
    wrong = jsonschema.exceptions.best_match(v.iter_errors(value))
    if (wrong is None) != good:
        faults.append("%s: %s" % (what, wrong.message[:200] if wrong else "accepted"))
def put(value, new, *path):
    value = copy.deepcopy(value)
    at = value
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = new
    return value
for path in glob.glob(folder + "/models/*.json"):
    r, t = json.load(open(path)), path
    check(t, recipe, r, True)
    check(t + " unknown key", recipe, put(r, 1, "shape", "nose_m"), False)
    check(t + " word", recipe, put(r, "speed", "faces", "front", "between"), False)
    check(t + " weight", recipe, put(r, -1, "structures", 0, "lateral"), False)
    check(t + " knot", recipe, put(r, [1], "shape", "front_m", 0), False)
    for key in ("reference", "shape", "faces", "structures"):
        check(t + " without " + key, recipe, {k: v for k, v in r.items() if k != key}, False)
barrier = validator("barrier")
for b in "odb mpdb fmvss214 r95 ae-mdb".split():
    value = json.load(open("%s/share/barriers/%s.json" % (folder, b)))
    check(b, barrier, value, True)
    check(b + " strength", barrier, put(value, -1, "blocks", 0, "strength_MPa"), False)
    check(b + " unknown key", barrier, put(value, 1, "strenght"), False)
    check(b + " without blocks", barrier, {k: v for k, v in value.items() if k != "blocks"}, False)
for name in ("flat", "full"):
    m = json.load(open("%s/%s.json" % (out, name)))
    check(name, voxels, m, True)
    check(name + " energy", voxels, put(m, -1, "energy_J", 0), False)
    check(name + " fill", voxels, put(m, 1.5, "fill", 0), False)
    check(name + " count", voxels, put(m, [0, 1], "count"), False)
    check(name + " slopes", voxels, put(m, [1, 2, 3], "drag_slope"), False)
    check(name + " vehicle", voxels, put(m, {}, "vehicle"), False)
print("\n".join(faults))
PY
"$CRUMPLE" models sedan/1 --flat --to "$tmp/flat.json" &&
    "$CRUMPLE" models suv/9 --voxel 100 --to "$tmp/full.json"
report $? "models are exported"
empty "schemas and files agree" "$(python3 "$tmp/check.py" "$SRC" "$tmp" 2>&1)"
finish
