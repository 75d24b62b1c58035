#!/bin/sh
# share/schema/damage.schema.json is a valid schema, accepts damage files and what is found of them,
# and refuses what crumple damage refuses.
. "$SRC/tests/cli/cli.sh"
need_jsonschema
cat >"$tmp/check.py" <<'PY'
import copy, json, subprocess, sys
import jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft202012Validator.check_schema(schema)
valid = jsonschema.Draft202012Validator(schema)

def program(value):
    """What crumple damage says of a file: its findings, or None where it refuses."""
    open(sys.argv[3], "w").write(json.dumps(value))
    got = subprocess.run([sys.argv[2], "damage", sys.argv[3], "-f", "json"], capture_output=True)
    return json.loads(got.stdout) if got.returncode == 0 else None

def check(name, value, good):
    found = program(value)
    if (found is not None) != good:
        print("crumple damage:", name)
    if valid.is_valid(value) != good:
        print("schema:", name)
    for error in valid.iter_errors(found) if found else ():
        print("findings of", name, jsonschema.exceptions.best_match([error]).message[:200])

def put(new, *path):
    value = copy.deepcopy(pair)
    at = value
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = new
    return value

a = {"id": "A", "type": "sedan", "mass_kg": {"value": 1600, "tolerance": 20},
     "damage": {"face": "front", "field_length_m": 1.4, "crush_m": [0.2, 0.3], "pdof_deg": 10}}
b = {"id": "B", "car": "golf 2015", "damage": {"face": "rear", "crush_m": "unknown", "x_by": 1}}
pair = {"crumple_damage": 1, "name": "n", "vehicles": [a, b], "x_note": "n"}
check("a pair", pair, True)
check("one vehicle at a tree", {"crumple_damage": 1, "vehicles": [a], "object": {}}, True)
check("one vehicle alone", {"crumple_damage": 1, "vehicles": [a]}, True)
of_a = ("vehicles", 0, "damage")
check("an outline", put({"face": "front", "outline_m": [[-0.7, 0.1], [0.7, 0.2]]}, *of_a), True)
check("a known restitution", put({"value": 0.1, "tolerance": 0.05}, "restitution"), True)
check("heights", put([0.2, 0.9], *of_a, "height_m"), True)
check("an underride", put("under", *of_a, "ride"), True)
check("no version", put(2, "crumple_damage"), False)
check("an object beside two", put({}, "object"), False)
check("three vehicles", put([a, b, a], "vehicles"), False)
check("a key that is none", put(1, *of_a, "colour"), False)
check("a face that is none", put("top", *of_a, "face"), False)
check("a depth that is no number", put([0.1, "x"], *of_a, "crush_m"), False)
check("one station", put([0.1], *of_a, "crush_m"), False)
check("a negative tolerance", put({"value": 1, "tolerance": -1}, *of_a, "field_length_m"), False)
check("a ride that is none", put("beside", *of_a, "ride"), False)
check("no mass", put({k: v for k, v in a.items() if k != "mass_kg"}, "vehicles", 0), False)
check("restitution of one", put(1, "restitution"), False)
PY
schema=$SRC/share/schema/damage.schema.json
empty "schema, files and findings agree" \
    "$(python3 "$tmp/check.py" "$schema" "$crumple" "$tmp/d.json" 2>&1)"
finish
