#!/usr/bin/env python3
# Makes cars.csv, the catalogue of cars by name, from the public tables it is called with: dimensions
# by body and years, kerb masses of investigated cars, rollover ratings and side pole tests.
"""usage: make-catalogue.py vehicle_dimensions.csv curb_mass.csv static_stability.csv side_pole.csv types.json

A row of the catalogue is a generation: rows of one body whose years touch and whose wheelbase and
length differ by less than 40 and 120 mm are one, with the median of each measure. It is kept when
its kerb mass is known: the median of the investigated cars of that name and body in those years.
"""
import csv, json, re, statistics, sys, unicodedata

def rows(path):
    with open(path, encoding="utf-8") as f:
        return list(csv.DictReader(line for line in f if not line.startswith("#")))

def plain(s):
    s = unicodedata.normalize("NFKD", s).encode("ascii", "ignore").decode().lower()
    return re.sub(r"[^a-z0-9]", "", s)

MAKE = {"nissandatsun": "nissan", "datsun": "nissan", "chryslerdaimlerchrysler": "chrysler", "amgeneral": "hummer",
        "ram": "dodge"}
def make_of(s): return MAKE.get(plain(s), plain(s))

# body codes of NHTSA's investigators, and the words of the dimensions
BODY = {1: "Convertible", 2: "Coupe", 3: "Hatchback", 5: "Hatchback", 7: "Hatchback", 4: "Sedan", 6: "Wagon",
        14: "SUV", 15: "SUV", 16: "SUV", 19: "SUV", 20: "Van", 21: "Van", 22: "Van", 28: "Van", 29: "Van",
        30: "Pickup", 31: "Pickup", 39: "Pickup", 40: "Pickup"}
NEAR = {"Coupe": {"Coupe", "Hatchback", "Sedan"}, "Sedan": {"Sedan", "Coupe", "Hatchback"}, "Hatchback": {"Hatchback", "Coupe", "Sedan"},
        "Convertible": {"Convertible"}, "Wagon": {"Wagon", "SUV"}, "SUV": {"SUV", "Wagon"}, "Van": {"Van"}, "Pickup": {"Pickup"}}

def names(model):
    """every name that a coded model stands for: "Golf/Cabriolet/Cabrio/GTI/ GLI" """
    parts = {plain(p) for p in re.split(r"[/,(]", model)} | {plain(model)}
    return {p for p in parts if p}

def masses(path):
    table = {}
    for r in rows(path):
        body = BODY.get(int(r["body"])) if r["body"].isdigit() else None
        if body and r["curb_kg"]:
            for n in names(r["model"]):
                table.setdefault((make_of(r["make"]), n), []).append((int(r["model_year"]), body, float(r["curb_kg"]), float(r["min_kg"]), float(r["max_kg"]), int(r["n"])))
    return table

def mass_of(table, make, model, body, y0, y1):
    found = table.get((make_of(make), plain(model)), [])
    for wanted in ({body}, NEAR.get(body, {body})) if body else (set(NEAR),):
        inside = [m for m in found if y0 <= m[0] <= y1 and m[1] in wanted]
        if inside:
            n = sum(m[5] for m in inside)
            middle = statistics.median([m[2] for m in inside for _ in range(m[5])])
            return middle, min(m[3] for m in inside), max(m[4] for m in inside), n, inside[0][1]
    return None

def generations(dims):
    groups = {}
    for r in dims:
        if r["length_mm"] and r["width_mm"] and r["height_mm"] and r["wheelbase_mm"]:
            groups.setdefault((r["make"], r["model"], r["body"]), []).append(r)
    for key, group in groups.items():
        group.sort(key=lambda r: (int(r["year_from"]), int(r["wheelbase_mm"]), int(r["length_mm"])))
        open_ones = []
        for r in group:
            y0, y1, wb, length = int(r["year_from"]), int(r["year_to"]), int(r["wheelbase_mm"]), int(r["length_mm"])
            for g in open_ones:
                if y0 <= g["to"] + 1 and abs(wb - g["wb"]) < 40 and abs(length - g["len"]) < 120:
                    g["rows"].append(r); g["to"] = max(g["to"], y1); g["from"] = min(g["from"], y0)
                    break
            else:
                open_ones.append({"from": y0, "to": y1, "wb": wb, "len": length, "rows": [r]})
        for g in open_ones:
            yield key, g["from"], g["to"], g["rows"]

def middle(group, column):
    values = [float(r[column]) for r in group if r[column]]
    return statistics.median(values) / 1000 if values else None

def type_of(rules, body, test_mass, length):
    letter = {"SUV": "U", "Pickup": "U", "Van": "V", "Wagon": "W", "Sedan": "S", "Hatchback": "H", "Coupe": "C", "Convertible": "C"}.get(body, "S")
    for r in rules:
        if ("body" not in r or letter in r["body"]) and test_mass <= r.get("most_kg", 1e9) and length <= r.get("most_m", 1e9):
            return r["type"]

def number(x, digits): return "" if x is None else ("%.*f" % (digits, x))

def main(dims_path, mass_path, ssf_path, pole_path, types_path):
    table, rules = masses(mass_path), json.load(open(types_path))["rules"]
    ssf, poles = rows(ssf_path), rows(pole_path)
    stable, pole = {}, {}
    for r in ssf:
        if r["ssf"] and r["year"]:
            stable.setdefault((make_of(r["make"]), plain(r["model"])), []).append((int(r["year"]), float(r["ssf"])))
    for r in poles:
        if r["cg_mm"] and r["wheelbase_mm"]:
            pole.setdefault((make_of(r["make"]), plain(r["model"])), []).append(r)
    out = []
    for (make, model, body), y0, y1, group in generations(rows(dims_path)):
        found = mass_of(table, make, model, body, y0, y1)
        if not found:
            continue
        curb, lo, hi, n, mass_body = found
        body = body or mass_body
        length, wb = middle(group, "length_mm"), middle(group, "wheelbase_mm")
        tf, tr = middle(group, "track_f_mm"), middle(group, "track_r_mm")
        track = (tf + tr) / 2 if tf and tr else tf or tr
        factors = [s for y, s in stable.get((make_of(make), plain(model)), []) if y0 <= y <= y1]
        height = middle(group, "height_mm")
        cg_height = track / (2 * statistics.median(factors)) if factors and track else None
        if cg_height and not 0.3 * height < cg_height < 0.45 * height:
            cg_height = None    # another body under the same name
        cgs = [float(r["cg_mm"]) / 1000 for r in pole.get((make_of(make), plain(model)), []) if y0 <= int(r["year"]) <= y1 and abs(float(r["wheelbase_mm"]) / 1000 - wb) < 0.03]
        source = "CVS by allcarsdb; mass CISS n %d" % n + ("; CG height NCAP rollover n %d" % len(factors) if cg_height else "") + ("; CG pole test n %d" % len(cgs) if cgs else "")
        out.append([make, model, y0, y1, body, type_of(rules, body, curb + 108, length), number(curb, 0), number(lo, 0), number(hi, 0), number(length, 3), number(middle(group, "width_mm"), 3),
                    number(height, 3), number(wb, 3), number(track, 3), number(statistics.median(cgs), 3) if cgs else "", number(cg_height, 3), source])
    seen = {(make_of(r[0]), plain(r[1])): r for r in out}
    for r in poles:
        covered = [o for o in out if (make_of(o[0]), plain(o[1])) == (make_of(r["make"]), plain(r["model"])) and o[2] <= int(r["year"]) <= o[3]]
        if not covered and r["curb_kg"] and r["length_mm"] and r["width_mm"] and r["wheelbase_mm"]:
            body = {"S": "Sedan", "H": "Hatchback", "W": "Wagon", "C": "Coupe", "U": "SUV", "V": "Van"}[r["body"]]
            length, curb = float(r["length_mm"]) / 1000, float(r["curb_kg"])
            out.append([r["make"], r["model"], int(r["year"]), int(r["year"]), body, type_of(rules, body, float(r["test_mass_kg"]), length), number(curb, 0), "", "", number(length, 3),
                        number(float(r["width_mm"]) / 1000, 3), "", number(float(r["wheelbase_mm"]) / 1000, 3), "", number(float(r["cg_mm"]) / 1000, 3) if r["cg_mm"] else "", "", "NHTSA test " + r["test_no"]])
    out.sort(key=lambda r: (plain(r[0]), plain(r[1]), r[4], r[2], r[9]))
    w = csv.writer(sys.stdout, lineterminator="\n")
    print("# Cars by name: a row is a generation of a body, from..to its model years (North America).")
    print("# LICENCE: Creative Commons Attribution-ShareAlike 4.0 International (CC BY-SA 4.0); see LICENSE beside this file.")
    print("# Dimensions: Canadian Vehicle Specifications (Transport Canada) by NHTSA vPIC, as collected in github.com/shifter907/allcarsdb @77f2b99 (CC BY-SA 4.0), changed: merged by generation, medians.")
    print("# Kerb mass: median, least and greatest of the cars in NHTSA CISS 2017-2024; CG height: NHTSA NCAP rollover ratings; CG, some rows: NHTSA crash tests (all public domain).")
    print("# Made by share/catalogue/make-catalogue.py. An empty field is not known and is assumed by rule.")
    w.writerow("make model from to body type curb_kg min_kg max_kg length_m width_m height_m wheelbase_m track_m cg_behind_front_axle_m cg_height_m source".split())
    w.writerows(out)

if __name__ == "__main__":
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    main(*sys.argv[1:])
