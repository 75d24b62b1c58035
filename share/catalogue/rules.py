#!/usr/bin/env python3
# Judges the rules of track and height of the CG on the cars of the catalogue that have them.
"""usage: rules.py cars.csv models

models is the folder of the recipes, which have the rules. Prints of each rule and type n, mean and
root mean square of the logarithm of the car's value over the rule's.
"""
import csv, json, math, sys

LOAD = {"track_m": 180, "cg_height_m": 75}  # kg beside the kerb mass: as tested; with a driver

def told(rule, key, car):
    x = rule[key] + rule[key + "_per_kg"] * (float(car["curb_kg"]) + LOAD[key])
    if key == "track_m":
        width = float(car["width_m"])
        return min(max(x, 0.7 * width), 0.9 * width)
    return min(x, 0.45 * float(car["height_m"]))

def main(table, models):
    with open(table, encoding="utf-8") as f:
        cars = list(csv.DictReader(line for line in f if not line.startswith("#")))
    rules = {t: json.load(open(f"{models}/{t}.json"))["rules"] for t in {c["type"] for c in cars}}
    for key in LOAD:
        off = {}
        for car in cars:
            if car[key]:
                x = math.log(float(car[key]) / told(rules[car["type"]], key, car))
                off.setdefault(car["type"], []).append(x)
                off.setdefault("all", []).append(x)
        for kind, x in sorted(off.items()):
            rms = math.sqrt(sum(e * e for e in x) / len(x))
            print(f"{key:12s} {kind:14s} n {len(x):3d}  mean {sum(x) / len(x):+.3f}  rms {rms:.3f}")

if len(sys.argv) != 3:
    sys.exit(__doc__)
main(*sys.argv[1:])
