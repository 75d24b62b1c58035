#!/usr/bin/env python3
"""Makes the 14 scenes of the crash tests that Breitlauch et al. 2023 compare with, and their references.

Run it in its own folder: it writes the scenes beside itself, from the recipes in models/ and the
public tables in share/validation/data/. README.md says what is known of the tests and what is not.
"""

import csv
import json
import math
import os
import statistics

HERE = os.path.dirname(os.path.abspath(__file__))
SHARE = os.path.join(HERE, "..", "..")
TEST_LOAD = 180  # kg: two dummies and instruments, as everywhere in the program
GAP = 0.02  # m between the bodies at the start
WALL_E = 0.17  # restitution of full walls [WALL-RESTITUTION]
OVERLAP = 0.4  # of the narrower car
CAR_E = 0.10 * math.sqrt(OVERLAP)  # of whole ends above 10 m/s, by the width that is pressed
POLE_E = 0.16  # on a rigid pole above 10 m/s
POLE_RADIUS, POLE_ANGLE, HEAD = 0.127, 75, 0.52  # m, deg, share of the wheelbase
ENGAGED = 0.5  # m behind each front where the impulse of an offset crash acts

FULL_WIDTH = [
    ("suv", 2018, "suv"),
    ("sedan-1", 2019, "sedan"),
    ("sedan-2", 2019, "sedan"),
    ("station-wagon", 2019, "station-wagon"),
    ("compact-1", 2020, "compact"),
]
POLES = [
    ("suv", 2018, "suv"),
    ("sedan-1", 2019, "sedan"),
    ("compact-2", 2019, "compact"),
    ("station-wagon", 2019, "station-wagon"),
    ("compact-1", 2020, "compact"),
]
Q7 = {"type": "suv", "name": "Audi Q7 2006", "kerb": 2370, "length_m": 5.086,
      "width_m": 1.983, "height_m": 1.737, "wheelbase_m": 3.002}
FIAT = {"type": "super-compact", "name": "Fiat 500 2007", "kerb": 940, "length_m": 3.546,
        "width_m": 1.627, "height_m": 1.488, "wheelbase_m": 2.3}
# of the first pair the paper tells the cars, and its errors of their EES, %
OFFSETS = [
    ("q7-fiat500", Q7, FIAT, (-5, 10)),
    ("compact-2012-mini-1996", {"type": "compact"}, {"type": "mini-compact"}, None),
    ("compact-2015-super-2007", {"type": "compact"}, {"type": "super-compact"}, None),
    ("compact-2012-super-2007", {"type": "compact"}, {"type": "super-compact"}, None),
]


def rows(name):
    """Rows of a table; those with a type of their own are none of the paper's six."""
    with open(os.path.join(SHARE, "validation", "data", name), encoding="utf-8") as f:
        table = csv.DictReader(line for line in f if not line.startswith("#"))
        return [row for row in table if not row.get("type")]


RULES = json.load(open(os.path.join(SHARE, "calibration", "types.json"), encoding="utf-8"))


def type_of(body, mass, length):
    """Type that a test car counts as: share/calibration/types.json."""
    for rule in RULES["rules"]:
        if ("body" not in rule or body in rule["body"]) and mass <= rule.get("most_kg", 1e9) and (
                length is None or length <= rule.get("most_m", 1e9)):
            return rule["type"]
    raise ValueError(body)


def lent(kind):
    """Types whose tests stand for a type: its own, or those of the neighbour it borrows from."""
    return {kind} | {r["from"] for r in RULES["borrow"] if r["type"] == kind}


def line_at(points, x):
    """Value at x of the straight line through points (least squares)."""
    mx = statistics.mean(p[0] for p in points)
    my = statistics.mean(p[1] for p in points)
    slope = sum((p[0] - mx) * (p[1] - my) for p in points) / sum((p[0] - mx) ** 2 for p in points)
    return my + slope * (x - mx)


def wall_depth(kind, speed):
    """Residual depth, greatest of six, on a wall: line of the type over speed, m."""
    points = []
    for r in rows("frontal_wall.csv"):
        if type_of(r["body"], float(r["mass_kg"]), None) in lent(kind):
            points.append((float(r["speed_kmh"]), max(float(r[f"c{i}"]) for i in range(1, 7))))
    return line_at(points, speed) / 1000


def wall_peak(speed):
    """Peak acceleration on a wall: line of all valid pulses over speed, g."""
    at = {r["test_no"]: float(r["speed_kmh"]) for r in rows("frontal_wall.csv")}
    points = [(at[r["test_id"]], float(r["calc_peak_g"])) for r in rows("frontal_wall_pulse.csv")
              if r["status"] == "Valid" and r["test_id"] in at and r["calc_peak_g"]
              and abs(float(r["energy_ratio"]) - 1) <= 0.05]
    return line_at(points, speed)


def pole_depth(kind):
    """Greatest residual depth of a flank on the pole: median of the type, m."""
    return statistics.median(
        float(r["crush_mm"]) / 1000 for r in rows("side_pole.csv")
        if type_of(r["body"], float(r["test_mass_kg"]), float(r["length_mm"]) / 1000) in lent(kind))


class Car:
    """A vehicle of a type, of its own size or a given one, by the rules of the program."""

    def __init__(self, given):
        with open(os.path.join(SHARE, "..", "models", given["type"] + ".json"),
                  encoding="utf-8") as f:
            ref = json.load(f)["reference"]
        self.given, self.type = given, given["type"]
        self.kerb = given.get("kerb", ref["mass_kg"] - TEST_LOAD)
        self.mass = self.kerb + TEST_LOAD
        self.length, self.width, self.height, self.base = (
            given.get(k, ref[k]) for k in ("length_m", "width_m", "height_m", "wheelbase_m"))
        share = ref["front_overhang_m"] / (ref["length_m"] - ref["wheelbase_m"])
        self.cg = self.base * min(max(0.308 + 7.7e-5 * self.mass, 0.36), 0.6)
        self.front = share * (self.length - self.base) + self.cg  # of the CG, m
        self.inertia = 0.137 * self.mass * self.length * self.base  # [YAW-INERTIA]

    def member(self, name, **placed):
        m = {"id": name, "kind": "vehicle", "type": self.type, "kerb_mass_kg": self.kerb,
             "load_kg": TEST_LOAD, "length_m": self.length, "width_m": self.width,
             "height_m": self.height, "wheelbase_m": self.base}
        if "name" in self.given:
            m["x_name"] = self.given["name"]
        return {**m, **placed}


def kmh(v):
    return round(v * 3.6, 1)


def compliance(mass, inertia, r):
    """Velocity of the point r from the CG per impulse: 2 x 2, 1/kg."""
    x, y = r
    return [[1 / mass + y * y / inertia, -x * y / inertia],
            [-x * y / inertia, 1 / mass + x * x / inertia]]


def planar(k, change):
    """Impulse that changes the relative velocity by `change` where the compliance is k."""
    (a, b), (c, d) = k
    x, y = change
    det = a * d - b * c
    return ((d * x - b * y) / det, (a * y - c * x) / det)


def full_width(name, year, kind):
    car, speed = Car({"type": kind}), 50
    return {
        "name": f"fw-{name}", "x_title": f"full width, {kind} {year}", "x_group": "full-width",
        "participants": [
            car.member("car", position_m=[0, 0], heading_deg=0, speed_kmh=speed),
            {"id": "wall", "kind": "object", "shape": "wall",
             "position_m": [round(car.front + GAP, 4), 0], "heading_deg": 180}],
        "x_expect": {"car": {
            "ees_kmh": round(speed * math.sqrt(1 - WALL_E**2), 1),
            "delta_v_kmh": round(speed * (1 + WALL_E), 1),
            "face_depth_m": round(wall_depth(kind, speed), 3),
            "acceleration_max_g": round(wall_peak(speed), 1)}}}


def pole(name, year, kind):
    car, speed, a = Car({"type": kind}), 32, math.radians(POLE_ANGLE)
    depth = pole_depth(kind)
    ahead = car.cg - HEAD * car.base
    v = (speed / 3.6 * math.cos(a), speed / 3.6 * math.sin(a))
    k = compliance(car.mass, car.inertia, (ahead, car.width / 2 - depth))
    j = planar(k, (-v[0], -(1 + POLE_E) * v[1]))  # the pole hooks: it does not slide along
    dv = math.hypot(*j) / car.mass
    lost = -(j[0] * v[0] + j[1] * v[1]) - 0.5 * sum(
        j[i] * k[i][n] * j[n] for i in range(2) for n in range(2))
    off = car.width / 2 + POLE_RADIUS + GAP
    return {
        "name": f"po-{name}", "x_title": f"oblique pole, {kind} {year}", "x_group": "pole",
        "participants": [
            car.member("car", position_m=[0, 0], heading_deg=0, course_deg=POLE_ANGLE,
                       speed_kmh=speed),
            {"id": "pole", "kind": "object", "shape": "pole", "radius_m": POLE_RADIUS,
             "position_m": [round(ahead + GAP / math.tan(a), 4), round(off, 4)]}],
        "x_expect": {"car": {
            "ees_kmh": kmh(math.sqrt(2 * lost / car.mass)), "delta_v_kmh": kmh(dv),
            "face_depth_m": round(depth, 3)}}}


def offset(name, given_a, given_b, errors):
    a, b, speed = Car(given_a), Car(given_b), 56
    overlap = OVERLAP * min(a.width, b.width)
    side = (a.width + b.width) / 2 - overlap  # of B's axis to the left of A's, m
    middle = a.width / 2 - overlap / 2
    ra = (a.front - ENGAGED, middle)
    rb = (-(b.front - ENGAGED), middle - side)
    ka, kb = compliance(a.mass, a.inertia, ra), compliance(b.mass, b.inertia, rb)
    k = [[ka[i][n] + kb[i][n] for n in range(2)] for i in range(2)]
    close = 2 * speed / 3.6
    j = planar(k, ((1 + CAR_E) * close, 0))  # the structures hook: they do not slide past
    lost = j[0] * close - 0.5 * sum(j[i] * k[i][n] * j[n] for i in range(2) for n in range(2))
    impulse = math.hypot(*j)
    expect = {"A": {"delta_v_kmh": kmh(impulse / a.mass)},
              "B": {"delta_v_kmh": kmh(impulse / b.mass)}}
    if errors is not None:
        # EES that, with the paper's errors, take up the same energy as with none: `lost`
        grown = [(1 + e / 100) ** 2 for e in errors]
        ratio = a.mass * (1 - grown[0]) / (b.mass * (grown[1] - 1))  # (EES_B / EES_A)^2
        ees = math.sqrt(2 * lost / (a.mass + b.mass * ratio))
        expect["A"]["ees_kmh"] = kmh(ees)
        expect["B"]["ees_kmh"] = kmh(ees * math.sqrt(ratio))
    return {
        "name": f"v2v-{name}", "x_title": f"40 % offset, {a.type} - {b.type}",
        "x_group": "offset",
        "participants": [
            a.member("A", position_m=[0, 0], heading_deg=0, speed_kmh=speed),
            b.member("B", position_m=[round(a.front + b.front + GAP, 4), round(side, 4)],
                     heading_deg=180, speed_kmh=speed)],
        "x_expect": expect}


def main():
    for scene in ([full_width(*x) for x in FULL_WIDTH] + [pole(*x) for x in POLES]
                  + [offset(*x) for x in OFFSETS]):
        whole = {"crumple": 1, "settings": {"restitution": "auto"}, **scene}
        with open(os.path.join(HERE, scene["name"] + ".json"), "w", encoding="utf-8") as f:
            json.dump(whole, f, indent=2)
            f.write("\n")


if __name__ == "__main__":
    main()
