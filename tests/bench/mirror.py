#!/usr/bin/env python3
"""Where a crash and its mirror image part: an asymmetry, or rounding that grows.

usage: mirror.py CRUMPLE [NUMBER|tie|SCENE.json ...]

Solves each scene (number N of random.py; `tie`: those below, in which grid lines, faces and forces
lie upon each other; else a file) and its mirror image with their traces, and pairs the slices. Per
scene a line is told: by how much the results differ, the first slice in which speeds, places or
energies differ by more than 1e-9, and by how much they did in all slices before. A difference that
comes from 1e-10 or less within one slice to 1e-4 is a decision that rounding takes; one that rises
slice by slice is rounding that a crash amplifies. Status 1 where results differ by more than 1e-9.
"""
import importlib.util
import json
import math
import os
import subprocess
import sys

SPEC = importlib.util.spec_from_file_location(
    "random_scenes", os.path.join(os.path.dirname(os.path.abspath(__file__)), "random.py"))
SCENES = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(SCENES)

# key of the trace, sign in the mirror, and what a difference is measured by
KEYS = [("x_m", 1, 1), ("y_m", -1, 1), ("vx_mps", 1, 10), ("vy_mps", -1, 10),
        ("yaw_rate_deg_s", -1, 100), ("energy_kJ", 1, 10)]
SAME = 1e-9


def ties():
    """Cars on the lines of the grid against flat faces, turned and straight, off their middle;
    wheels upon a line of the grid."""
    made = []
    for shape in ("wall", "box", "pole"):
        for angle in (180, 170, 150, 135, 120) if shape != "pole" else (180,):
            for aside in (0, 0.35, 0.7):
                thing = {"id": "O", "kind": "object", "shape": shape, "heading_deg": angle,
                         "position_m": [4.5, aside]}
                if shape == "box":
                    thing.update(length_m=1, width_m=1)
                elif shape == "pole":
                    thing["radius_m"] = 0.2
                car = {"id": "A", "kind": "vehicle", "type": "compact", "mass_kg": 1400,
                       "heading_deg": 0, "speed_kmh": 56, "position_m": [0, 0]}
                end = "separation"
                if shape == "pole" and angle == 180:
                    car["track_m"] = 1.4
                    thing["position_m"][1] += 0.3
                    end = "rest"
                made.append({"crumple": 1, "name": "%s %g %g" % (shape, angle, aside),
                             "settings": {"voxel_mm": 50, "dt_ms": 1, "end": end},
                             "participants": [car, thing]})
    return made


def solve(crumple, scene):
    done = subprocess.run([crumple, "run", "--trace", "-"], input=json.dumps(scene).encode(),
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    return json.loads(done.stdout) if done.returncode == 0 else {"error": done.stderr.decode()}


def apart(one, other, k, ids):
    """By how much slice k of two traces differs, and in what most."""
    most, what = 0, ""
    for name in ids:
        for key, sign, unit in KEYS:
            a, b = one[name].get(key), other[name].get(key)
            off = abs(a[k] - sign * b[k]) / unit if a and b else 0
            if off > most:
                most, what = off, name + "." + key
    return most, what


def look_at(crumple, scene):
    """The line of a scene, and whether it is as its mirror image."""
    one, other = solve(crumple, scene), solve(crumple, SCENES.mirrored(scene))
    off = SCENES.apart(one, other)
    if "error" in one or "error" in other:
        return "%s: no result" % scene["name"], off == 0
    a, b = one["trace"], other["trace"]
    ids = [p["id"] for p in scene["participants"] if p["id"] in a]
    before = 0
    for k in range(min(len(a["t_s"]), len(b["t_s"]))):
        most, what = apart(a, b, k, ids)
        if not math.isclose(a["t_s"][k], b["t_s"][k], abs_tol=1e-9):
            most, what = 1, "length of the slice"
        if most > SAME:
            return ("%s: results %.2g, at %g s %s %.2g, %.2g before"
                    % (scene["name"], off, a["t_s"][k], what, most, before)), off <= SAME
        before = max(before, most)
    return "%s: results %.2g, all slices %.2g" % (scene["name"], off, before), off <= SAME


def main(crumple, *names):
    wrong = 0
    for name in names:
        if name == "tie":
            made = ties()
        elif name.isdigit():
            made = [SCENES.scene(int(name))]
        else:
            with open(name, encoding="utf-8") as file:
                made = [{"name": name, **json.load(file)}]
        for scene in made:
            line, same = look_at(crumple, scene)
            print(line)
            wrong += not same
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
