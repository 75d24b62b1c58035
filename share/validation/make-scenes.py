#!/usr/bin/env python3
"""Writes the scenes of the validation classes rear, side-mdb, narrow and barriers, by the rules below.

usage: make-scenes.py FIELD_DIR
FIELD_DIR holds crush_edr.csv and struck_rear_side.csv (NHTSA CISS 2017-2018, public domain; the head of
crush_edr.csv says columns and signs). A scene has x_expect, what was measured, and x_group, what it is
judged with. Masses are kerb masses and one occupant of 75 kg.
"""
import csv
import json
import os
import sys

OCCUPANT = 75  # kg
SUVS = {14, 15, 16, 19, 20, 21, 22, 28, 29, 30, 31, 39, 40, 45, 48}  # NHTSA body codes


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def rows(folder, name):
    with open(os.path.join(folder, name)) as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def type_of(body, kerb):
    body = int(number(body) or 4)
    if body in SUVS:
        return "suv"
    if body == 6:
        return "station-wagon"
    limits = ((1050, "super-compact"), (1250, "mini-compact"), (1500, "compact"))
    return next((word for most, word in limits if kerb < most), "sedan")


def vehicle(id, type, mass, x=0.0, speed=0.0, **more):
    return {"id": id, "kind": "vehicle", "type": type, "mass_kg": round(mass),
            "position_m": [x, 0], "heading_deg": 0, "speed_kmh": round(speed, 2), **more}


def scene(name, title, group, expect, *participants, **settings):
    out = {"crumple": 1, "name": name}
    if settings:
        out["settings"] = settings
    out.update(participants=list(participants), x_title=title, x_group=group, x_expect=expect)
    return out


def write(name, about, scenes):
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w") as out:
        for one in scenes:
            out.write(json.dumps({**one, "x_source": about}) + "\n")


def mean6(c):
    return (c[0] / 2 + c[1] + c[2] + c[3] + c[4] + c[5] / 2) / 5


def rear_field(folder):
    """In-line hits: the closing speed from the struck car's recorder and both masses, e = 0.15."""
    bands = ((10, 16), (16, 24), (24, 32), (32, 60))
    restitution = 0.15
    for row in rows(folder, "struck_rear_side.csv"):
        dv, kerb, bullet = (number(row[k]) for k in ("edr_long", "curb_kg", "b_curb_kg"))
        pdof = number(row["pdof"]) or 180
        if row["plane"] != "B" or row["edr_complete"] != "1" or not 160 <= pdof <= 200:
            continue
        if dv is None or not 10 <= dv < 60 or not kerb or not bullet or bullet > 3500:
            continue
        mass, other = kerb + OCCUPANT, bullet + OCCUPANT
        closing = dv * (1 + mass / other) / (1 + restitution)
        if closing > 110:
            continue
        lo, hi = next(b for b in bands if b[0] <= dv < b[1])
        crush = [number(row["c%d" % i]) or 0 for i in range(1, 7)]
        yield scene("ciss-" + row["case"], "%s %s %s, delta-v %.0f km/h by its recorder"
                    % (row["my"], row["make"], row["model"], dv), "%d-%d km/h" % (lo, hi),
                    {"T": {"crush_mean_cm": round(mean6(crush), 2)}},
                    vehicle("T", type_of(row["body"], kerb), mass),
                    vehicle("B", type_of(row["b_body"], bullet), other, -6, closing),
                    restitution=restitution)


def rear_barrier():
    """FMVSS 301 research: 70 % overlap at 80 km/h; greatest static crush."""
    tests = (("Mazda Protege 1996", "compact", 1294, 0.359), ("Toyota RAV4 1997", "suv", 1557, 0.356),
             ("Honda Accord 1997", "sedan", 1544, 0.174), ("Mazda 626 1997", "compact", 1404, 0.199),
             ("Dodge Avenger 1998", "sedan", 1648, 0.207), ("VW Beetle 1998", "compact", 1557, 0.382),
             ("Buick Century 2000", "sedan", 1762, 0.358), ("Ford Contour 2000", "compact", 1557, 0.227),
             ("Toyota Camry 2000", "sedan", 1715, 0.313))
    for name, type, mass, depth in tests:
        width = {"compact": 1.74, "sedan": 1.80, "suv": 1.75}[type]
        # from the car's left edge 0.7 of its width meet the barrier's right part
        y = width / 2 - 0.7 * width + 0.838
        yield scene("301-" + name.lower().replace(" ", "-"), name + ", 80 km/h, 70 % overlap", "FMVSS 301",
                    {"T": {"face_depth_m": depth}},
                    vehicle("T", type, mass, width_m=width),
                    {"id": "M", "kind": "object", "shape": "barrier", "barrier": "fmvss214",
                     "height_m": [0.229, 0.788], "position_m": [-6, round(y, 3)], "heading_deg": 0,
                     "speed_kmh": 79.4})


def rear_deville():
    """1993 Cadillac De Ville into the rear of Jeeps, 1.524 m of the width."""
    tests = ((8549, "1998 Jeep", 1860, 56.58, 0.342), (8550, "1996 Jeep", 1830, 56.34, 0.428),
             (8551, "1996 Grand Cherokee", 1934, 56.59, 0.290), (8552, "1996 Jeep", 1852, 56.39, 0.235),
             (8554, "1996 Grand Cherokee", 1902, 55.67, 0.299))
    for test, name, mass, speed, mean in tests:
        yield scene("nhtsa-%d" % test, name + ", struck by a 1993 Cadillac De Ville", "De Ville into Jeep",
                    {"T": {"crush_mean_cm": round(100 * mean, 1)}},
                    vehicle("T", "suv", mass), vehicle("B", "sedan", 1755, -6, speed))


def narrow_field(folder):
    """Trees and poles that stood, and such as gave way; impact speed = recorder / 1.1.

    The object stands in the middle of the direct contact (smash_d). Corners (CDC: distribution E) are left
    out: their profile is measured along a bumper that the tree passed by, 0 to 20 cm where the damage
    extends to the wheel (zones 3 to 5). So are recorders whose maximum lies at 250 ms or later.
    """
    here = os.path.dirname(os.path.abspath(__file__))
    after = {(row["case"], row["veh"]): row["object_after"] for row in rows(here, "narrow/objects.csv")}
    for row in rows(folder, "crush_edr.csv"):
        dv, kerb = number(row["edr_dv_long"]), number(row["curb_kg"])
        depth, y = number(row["cmax_cm"]), number(row["smash_d_cm"])
        if row["plane"] != "F" or row["veh_impacts"] != "1" or row["case_events"] != "1":
            continue
        if row["edr_complete"] != "1" or row["over_under"] != "0" or dv is None or dv >= -16 or not kerb:
            continue
        if row["object"] not in ("41", "42", "50", "51", "52", "53") or row["cdc"][5] == "E":
            continue
        if (number(row["edr_long_ms"]) or 0) >= 250 or depth < 15 or y is None:
            continue
        stood = after[row["case"], row["veh"]] == "1"
        radius = min(max((number(row["direct_w_cm"]) or 30) / 200, 0.06), 0.35)
        yield scene("ciss-" + row["case"], "%s %s %s, delta-v %.0f km/h by its recorder"
                    % (row["model_year"], row["make"], row["model"], -dv),
                    "trees and poles" if stood else "gave way", {"A": {"face_depth_m": depth / 100}},
                    vehicle("A", type_of(row["body"], kerb), kerb + OCCUPANT, 0, -dv / 1.1),
                    {"id": "P", "kind": "object", "shape": "pole", "radius_m": round(radius, 3),
                     "height_m": [0, 2.5], "position_m": [4.0, round(-y / 100, 3)]})


def side_mdb():
    """US NCAP: six types against the median of 603 cars."""
    sizes = (("super-compact", 1183, 3.6, 1.62, 2.40), ("mini-compact", 1240, 4.105, 1.693, 2.566),
             ("compact", 1417, 4.570, 1.783, 2.700), ("station-wagon", 1642, 4.703, 1.778, 2.736),
             ("sedan", 1666, 4.857, 1.833, 2.791), ("suv", 1856, 4.682, 1.863, 2.766))
    for type, mass, length, width, base in sizes:
        # the face's left edge 0.94 m ahead of the middle of the wheelbase at the moment of contact
        ahead = 0.42 * base - base / 2 + 0.94
        yield scene("ncap-" + type, type + " of median size, US NCAP side, 61.9 km/h, crabbed", type,
                    {"T": {"face_depth_m": 0.207, "deformation_area_m2": 0.311}},
                    vehicle("T", type, mass, length_m=length, width_m=width, wheelbase_m=base),
                    {"id": "M", "kind": "object", "shape": "barrier", "barrier": "fmvss214",
                     "position_m": [round(ahead - 0.838 + 0.02, 3), round(width / 2 + 2.27, 3)],
                     "heading_deg": -90, "course_deg": -117, "speed_kmh": 61.9})


def barriers():
    """Verification of UN R95's barrier, and the expected delta-v of IIHS' offset test."""
    wall = {"id": "W", "kind": "object", "shape": "wall", "position_m": [2.1, 0], "heading_deg": 180}
    yield scene("r95-wall-35", "barrier of UN R95 on a wall, 35 km/h: 330 +- 20 mm", "verification",
                {"M": {"face_depth_dynamic_m": 0.33}},
                {"id": "M", "kind": "object", "shape": "barrier", "barrier": "r95", "position_m": [0, 0],
                 "heading_deg": 0, "speed_kmh": 35}, wall)
    yield scene("iihs-odb-64", "sedan, 40 % on the ODB, 64.4 km/h: delta-v expected of 232 tests", "ODB",
                {"A": {"delta_v_forward_kmh": -60.8}},
                {"id": "A", "kind": "vehicle", "type": "sedan", "mass_kg": 1700, "width_m": 1.833,
                 "position_m": [2.3, 0.6833], "heading_deg": 180, "speed_kmh": 64.4},
                {"id": "W", "kind": "object", "shape": "barrier", "barrier": "odb", "position_m": [0, 0],
                 "heading_deg": 0})


def main():
    folder = sys.argv[1]
    ciss = "NHTSA CISS 2017-2018, event data recorders, public domain"
    write("rear/field.jsonl", ciss, rear_field(folder))
    write("rear/barrier.jsonl", "NHTSA Vehicle Crash Test Database, research for FMVSS 301", rear_barrier())
    write("rear/deville.jsonl", "NHTSA Vehicle Crash Test Database", rear_deville())
    write("narrow/field.jsonl", ciss, narrow_field(folder))
    write("side-mdb/ncap.jsonl", "NHTSA, US NCAP side: medians of 603 cars of 2011 and later", side_mdb())
    write("barriers/barriers.jsonl", "UN R95 Annex 5; Aylor et al. (IIHS)", barriers())


main()
