#!/usr/bin/env python3
"""Solves random crashes and checks what must hold for each: energy and momentum, finite numbers, twins.

usage: random.py CRUMPLE [FIRST [COUNT]]   (scene numbers FIRST .. FIRST+COUNT-1; 0 and 300 by default)

Scene N is the same on every machine. Each is solved as it is, as its mirror image and with its
participants named in the opposite order, in one stack with one thread; again with two threads; and
every fiftieth by `crumple run` alone. What must hold, and is counted where it does not:
  balance   the residuals of energy, momentum and angular momentum are below 1e-9
  finite    no nan, no inf, every EES and energy is not negative
  budget    none is too expensive
  failed    solved, or a word that the participants never meet or overlap at the start
  jobs      the same bytes with one thread and with two
  run       the same values from `crumple run`
  mirror    EES, delta-v and yaw of the mirror image within 1e-6 of themselves
  swap      the same for the opposite order
Mirror images are other numbers in the last bit, and a crash in which a grid line lies exactly upon
another, or in which rubbing decides when it ends, can answer to that: those that differ are told
with their size where it is more than a hundredth, by profile and number of participants. Status 1
where anything but a mirror image is wrong.
"""
import collections
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile

TYPES = ["super-compact", "mini-compact", "compact", "station-wagon", "sedan", "suv"]
FLIPPED = ["heading_deg", "course_deg", "yaw_rate_deg_s", "steer_deg"]
OUTSIDE = ["ees_kmh", "delta_v_kmh", "yaw_rate_change_deg_s"]


def rounded(value, digits=3):
    return round(value, digits)


def car(rnd, name):
    """A car that is about to be near the origin after 0.6 s."""
    slips = rnd.random() < 0.6
    course = rnd.uniform(-180, 180) if slips else 90 * rnd.randrange(4) - 180
    speed = 0 if rnd.random() < 0.15 else rnd.uniform(5, 120)
    made = {"id": name, "kind": "vehicle", "type": rnd.choice(TYPES),
            "mass_kg": rounded(rnd.uniform(800, 2800), 1),
            "heading_deg": rounded(course + (rnd.uniform(-25, 25) if slips else 0)),
            "course_deg": rounded(course), "speed_kmh": rounded(speed),
            "position_m": [rounded(rnd.uniform(-1, 1) - speed / 6 * math.cos(math.radians(course)), 4),
                           rounded(rnd.uniform(-1, 1) - speed / 6 * math.sin(math.radians(course)), 4)]}
    if rnd.random() < 0.3:
        made["yaw_rate_deg_s"] = rounded(rnd.uniform(-90, 90))
    if rnd.random() < 0.5:
        made["brake"] = rounded(rnd.random())
    if rnd.random() < 0.2:
        made["steer_deg"] = rounded(rnd.uniform(-15, 15))
    return made


def thing(rnd):
    made = {"id": "O", "kind": "object", "shape": rnd.choice(["wall", "pole", "box"]),
            "heading_deg": rounded(rnd.uniform(-180, 180)),
            "position_m": [rounded(rnd.uniform(-1, 1), 4), rounded(rnd.uniform(-1, 1), 4)]}
    if made["shape"] == "pole":
        made["radius_m"] = rounded(rnd.uniform(0.05, 0.5))
    elif made["shape"] == "box":
        made["length_m"] = rounded(rnd.uniform(0.5, 4))
        made["width_m"] = rounded(rnd.uniform(0.3, 2))
        if rnd.random() < 0.5:
            made["mass_kg"] = rounded(rnd.uniform(200, 3000))
    return made


def scene(number):
    rnd = random.Random("crumple %d" % number)
    made = {"crumple": 1, "name": "r%d" % number,
            "settings": {"method": rnd.choice(["extended", "extended", "paper"]),
                         "voxel_mm": rnd.choice([100, 100, 100, 100, 100, 100, 100, 50, 50, 40]),
                         "dt_ms": rnd.choice([2, 2, 2, 1, 0.5]),
                         "end": rnd.choice(["separation"] * 39 + ["rest"])}}
    if rnd.random() < 0.2:
        made["settings"]["friction"] = rounded(rnd.uniform(0, 1.5))
    if rnd.random() < 0.2:
        made["settings"]["restitution"] = rounded(rnd.uniform(0, 0.6))
    parts = [car(rnd, "A"), car(rnd, "B") if rnd.random() < 0.75 else thing(rnd)]
    if rnd.random() < 0.12:
        parts.append(car(rnd, "C"))
    made["participants"] = parts
    return made


def mirrored(made):
    made = json.loads(json.dumps(made))
    made["name"] += "m"
    for part in made["participants"]:
        part["position_m"][1] *= -1
        for key in FLIPPED:
            if key in part:
                part[key] *= -1
    return made


def swapped(made):
    made = json.loads(json.dumps(made))
    made["name"] += "s"
    made["participants"].reverse()
    return made


def stack(crumple, jobs, path):
    done = subprocess.run([crumple, "stack", "-j%d" % jobs, path], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, check=False)
    if done.returncode not in (0, 1) or done.stderr:
        sys.exit("stack ended with %d: %s" % (done.returncode, done.stderr[:500]))
    return done.stdout.splitlines()


def apart(one, other):
    """By how much two results differ, of the greater; 2 where one has no result."""
    if "error" in one or "error" in other:
        return 0 if ("error" in one) == ("error" in other) else 2
    by_id = {p["id"]: p for p in other["participants"]}
    most = 0
    for part in one["participants"]:
        for key in OUTSIDE:
            if isinstance(part.get(key), (int, float)):
                a, b = abs(part[key]), abs(by_id[part["id"]][key])
                most = max(most, abs(a - b) / max(a, b, 1))
    return most


def look_at(line, count, told):
    result = json.loads(line)
    name = result["scene"]
    if re.search(rb"\b(nan|inf|NaN|Infinity)\b", line):
        told.append("%s: not finite" % name)
        count["finite"] += 1
    if "error" in result:
        code = result["error"]["code"]
        kinds = {"too-expensive": "budget", "no-contact": "never meet", "overlap-at-start": "overlap"}
        count[kinds.get(code, "failed")] += 1
        if code not in ("no-contact", "overlap-at-start"):
            told.append("%s: %s" % (name, result["error"]["message"]))
        return result
    count["solved"] += 1
    residual = max(result["balance"][k] for k in ("energy_residual", "momentum_residual",
                                                  "angular_residual"))
    count["worst residual"] = max(count["worst residual"], residual)
    if not residual < 1e-9:
        told.append("%s: residual %g" % (name, residual))
        count["balance"] += 1
    for part in result["participants"]:
        for key in ("ees_kmh", "energy_kJ", "delta_v_kmh"):
            if part.get(key) is not None and not part[key] >= 0:
                told.append("%s: %s %s of %s" % (name, key, part[key], part["id"]))
                count["finite"] += 1
    return result


def numbered(line):
    """A line without its place in the stack, which an error names too."""
    line = re.sub(rb'^(..crumple_result.:\d+),"index":\d+,', rb"\1,", line)
    return re.sub(rb'"where":"[^"]*jsonl:\d+:', rb'"where":"', line)


def by_run(crumple, made, line):
    """Whether `crumple run` gives the values of the stack's line."""
    done = subprocess.run([crumple, "run", "-"], input=json.dumps(made).encode(),
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    want = json.loads(numbered(line))
    if "error" in want:
        return done.returncode != 0
    got = json.loads(done.stdout)
    got["input"].pop("resolved")
    return got == want


def twins(kind, one, other, count, told):
    off = apart(one, other)
    count[kind] += off > 1e-6
    if "participants" in one:
        sort = "%s %s %d" % (kind, one["method"], len(one["participants"]))
        count[sort + " of"] += 1
        count[sort + " by 1 %"] += off > 0.01
    if off > 0.01:
        told.append("%s: %s differs by %.3g" % (one["scene"], kind, off))


def main(crumple, first=0, number=300):
    count, told = collections.Counter(), []
    with tempfile.TemporaryDirectory() as folder:
        path, alone = os.path.join(folder, "all.jsonl"), os.path.join(folder, "one.jsonl")
        for begin in range(first, first + number, 250):
            made = [scene(n) for n in range(begin, min(begin + 250, first + number))]
            with open(path, "w") as both, open(alone, "w") as single:
                for s in made:
                    print(json.dumps(s), file=single)
                    for twin in (s, mirrored(s), swapped(s)):
                        print(json.dumps(twin), file=both)
            lines, again = stack(crumple, 1, path), stack(crumple, 2, alone)
            for k, s in enumerate(made):
                one, mirror, swap = (look_at(x, count, told) for x in lines[3 * k:3 * k + 3])
                twins("mirror", one, mirror, count, told)
                twins("swap", one, swap, count, told)
                if numbered(lines[3 * k]) != numbered(again[k]):
                    told.append("%s: other bytes with two threads" % s["name"])
                    count["jobs"] += 1
                if (begin + k) % 50 == 0 and not by_run(crumple, s, lines[3 * k]):
                    told.append("%s: another result from run" % s["name"])
                    count["run"] += 1
                count["scenes"] += 1
    for line in told[:200]:
        print("#", line)
    print(json.dumps({"first": first, **count}))
    wrong = ("balance", "finite", "budget", "failed", "jobs", "run", "swap")
    return 1 if any(count[k] for k in wrong) else 0


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], *map(int, sys.argv[2:])))
