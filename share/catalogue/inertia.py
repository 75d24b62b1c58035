#!/usr/bin/env python3
# Judges the two rules of yaw inertia on measured vehicles: k m L WB, and a straight line over the mass.
"""usage: inertia.py inertia.csv

Every vehicle is told by a rule that was fitted to all others of its class (cars, light trucks); the rule that
Crumple takes, 0.137 m L WB, is told beside it as it is. Prints n, mean error and root mean square error, %.
"""
import csv, sys

def rows(path):
    with open(path, encoding="utf-8") as f:
        for r in csv.DictReader(line for line in f if not line.startswith("#")):
            yield {k: float(v) if v and k not in ("make", "model", "body", "class") else v for k, v in r.items()}

def line(fleet):
    n, mx = len(fleet), sum(r["mass_kg"] for r in fleet) / len(fleet)
    my = sum(r["yaw_inertia_kgm2"] for r in fleet) / n
    b = (sum((r["mass_kg"] - mx) * (r["yaw_inertia_kgm2"] - my) for r in fleet)
         / sum((r["mass_kg"] - mx) ** 2 for r in fleet))
    left = sum((r["yaw_inertia_kgm2"] - my - b * (r["mass_kg"] - mx)) ** 2 for r in fleet)
    return my - b * mx, b, (left / (n - 2)) ** 0.5

def volume(r): return r["mass_kg"] * r["length_m"] * r["wheelbase_m"]

def told(rule, one, others):
    if rule == "kept":
        return 0.137 * volume(one)
    if rule == "line":
        a, b, _ = line(others)
        return a + b * one["mass_kg"]
    return volume(one) * sum(r["yaw_inertia_kgm2"] / volume(r) for r in others) / len(others)

def main(path):
    fleet = list(rows(path))
    for kind in ("car", "truck"):
        all_of = [r for r in fleet if r["class"] == kind]
        a, b, s = line(all_of)
        print(f"{kind}: {b:.3f} m {a:+.0f} kg m2, n {len(all_of)}, standard deviation {s:.0f} kg m2")
        sized = [r for r in all_of if r["length_m"]]
        for least in (0, 1997):
            for rule, name in (("line", "line over the mass"), ("share", "k m L WB"), ("kept", "0.137 m L WB")):
                e = [100 * (told(rule, r, [o for o in sized if o is not r]) / r["yaw_inertia_kgm2"] - 1)
                     for r in sized if r["year"] >= least]
                rms = (sum(x * x for x in e) / len(e)) ** 0.5
                print(f"  {'from 1997' if least else 'all':9s} n {len(e):2d}  {name:18s} mean {sum(e) / len(e):+5.1f} %  rms {rms:4.1f} %")

if len(sys.argv) != 2:
    sys.exit(__doc__)
main(sys.argv[1])
