#!/bin/sh
# export channels, body and film, read back by readers that share no code with the program.
. "$SRC/tests/cli/cli.sh"
if ! python3 -c '' 2>/dev/null; then
    echo "1..0 # SKIP no python3 to read the files back"
    exit 0
fi
wall_scene >"$tmp/wall.json"
cd "$tmp" || exit 99
"$crumple" -e "load wall.json" -e solve -e "export channels crash.mme" -e "export channels c.gp" \
    -e "export body car.vtk of=A" -e "export body car.obj of=A" -e "export film crash.cast" \
    >said 2>errs
same "all are written" "$?$(cat errs)" 0
"$crumple" run wall.json --trace -o result.json
cat >read.py <<'END'
import json, math, sys
result = json.load(open("result.json"))
a = [p for p in result["participants"] if p["id"] == "A"][0]

def mme():
    head = dict(l.rstrip("\n").split(":", 1) for l in open("crash.mme"))
    head = {k.strip(): v for k, v in head.items()}
    assert head["Type of the test"] == "Simulation" and "computed" in head["Laboratory name"]
    chn = [l for l in open("Channel/crash.chn") if l.startswith("Name of channel")]
    codes = [l.split(":", 1)[1].split("/")[0].strip() for l in chn]
    assert all(len(c) == 16 for c in codes), codes
    lines = open("Channel/crash.%03d" % (codes.index("10VEHCCG0000ACX0") + 1)).read().split("\n")
    keys, values = {}, []
    for line in lines:
        if ":" in line:
            keys[line.split(":")[0].strip()] = line.split(":", 1)[1]
        elif line:
            values.append(float(line))
    assert int(keys["Number of samples"]) == len(values)
    dt = float(keys["Sampling interval"])
    # the impulse of the pulse is the velocity change
    dv = sum(values) * dt * 3.6
    assert abs(dv - a["delta_v_forward_kmh"]) < 0.02 * abs(dv), (dv, a["delta_v_forward_kmh"])
    v = [float(l) for l in open("Channel/crash.%03d" % (codes.index("10VEHCCG0000VEX0") + 1))
         if ":" not in l]
    assert abs(v[0] * 3.6 - 50) < 0.5, v[0]

def vtk():
    words = open("car.vtk").read().split("\n")
    assert words[0].startswith("# vtk DataFile") and words[2] == "ASCII"
    text = "\n".join(words[3:]).split()
    n = [int(text[text.index("DIMENSIONS") + k]) - 1 for k in (1, 2, 3)]
    step = float(text[text.index("SPACING") + 1])
    cells = n[0] * n[1] * n[2]
    assert int(text[text.index("CELL_DATA") + 1]) == cells
    field = {}
    for i, w in enumerate(text):
        if w == "SCALARS":
            field[text[i + 1]] = [float(x) for x in text[i + 6:i + 6 + cells]]
    assert set(field) == {"fill", "ees_kmh", "energy_J", "damage"}
    assert all(len(f) == cells for f in field.values())
    assert all(0 <= x <= 1 for x in field["damage"]) and max(field["damage"]) > 0.9
    part = [p for p in result["input"]["resolved"]["participants"] if p["id"] == "A"][0]
    assert abs(n[0] * step - part["length_m"]) < 2 * step
    # crushed voxels lie at the front: their mean x is beyond that of all material
    x = [(i % n[0]) * step for i in range(cells)]
    hurt = [i for i in range(cells) if field["damage"][i] > 0.5 and field["fill"][i] > 0]
    assert sum(x[i] for i in hurt) / len(hurt) > 0.75 * n[0] * step

def obj():
    v, f = [], []
    for line in open("car.obj"):
        w = line.split()
        if w[0] == "v":
            v.append(tuple(map(float, w[1:])))
        elif w[0] == "f":
            f.append([int(i) - 1 for i in w[1:]])
    # a closed surface: every edge is run through once in each direction as often as in the other
    edges = {}
    for face in f:
        for p, q in zip(face, face[1:] + face[:1]):
            edges[p, q] = edges.get((p, q), 0) + 1
    assert all(edges.get((q, p), 0) == k for (p, q), k in edges.items())
    # its volume, by the divergence theorem, is that of the voxels that are left, and positive
    volume = 0.0
    for a, b, c, d in f:
        for p, q, r in ((a, b, c), (a, c, d)):
            (x1, y1, z1), (x2, y2, z2), (x3, y3, z3) = v[p], v[q], v[r]
            volume += (x1 * (y2 * z3 - y3 * z2) - y1 * (x2 * z3 - x3 * z2)
                       + z1 * (x2 * y3 - x3 * y2)) / 6
    words = open("car.vtk").read().split()
    n = [int(words[words.index("DIMENSIONS") + k]) - 1 for k in (1, 2, 3)]
    step, cells = float(words[words.index("SPACING") + 1]), n[0] * n[1] * n[2]
    at = [i for i, w in enumerate(words) if w == "SCALARS"]
    fill = [float(x) for x in words[at[0] + 6:at[0] + 6 + cells]]
    gone = [float(x) for x in words[at[3] + 6:at[3] + 6 + cells]]
    # six digits do not tell on which side of a half a voxel lies that holds just a half
    least, most = (sum(fill[i] >= 0.5 + e and gone[i] < 0.5 - e for i in range(cells)) * step ** 3
                   for e in (1e-6, -1e-6))
    assert least - 1e-9 <= volume <= most + 1e-9 and most < 1.01 * least, (least, volume, most)

def cast():
    lines = open("crash.cast", encoding="utf-8").read().rstrip("\n").split("\n")
    head = json.loads(lines[0])
    assert head["version"] == 2 and head["width"] == 100
    events = [json.loads(l) for l in lines[1:]]
    times = [e[0] for e in events]
    assert len(events) > 20 and times == sorted(times) and all(e[1] == "o" for e in events)

def gnuplot():
    rows = [list(map(float, l.split())) for l in open("c.dat") if l[0] not in "#\n"]
    steps = {round(q[0] - p[0], 6) for p, q in zip(rows, rows[1:])}
    assert len(steps) == 1, steps
    assert 'plot "c.dat"' in open("c.gp").read()

def motion():
    import csv
    rows = {f: list(csv.DictReader(open(f))) for f in ("m.csv", "s.csv")}
    for f in rows.values():
        for r in f:
            r.update((k, float(v)) for k, v in r.items() if k != "id")
    both = list(zip(rows["m.csv"], rows["s.csv"]))
    assert len(both) == len(rows["m.csv"]) == len(rows["s.csv"])
    assert {r["id"] for r, _ in both} == {"A", "B"}
    for m, s in both:  # y to the right, and turned the other way
        assert all(m[k] == s[k] for k in ("t_s", "id", "x_m", "vx_m_s"))
        assert all(m[k] == -s[k] for k in ("y_m", "heading_deg", "vy_m_s", "yaw_rate_deg_s"))
    a = [m for m, _ in both if m["id"] == "A"]
    assert {round(q["t_s"] - p["t_s"], 6) for p, q in zip(a, a[1:])} == {0.005}
    assert abs(a[0]["vx_m_s"] * 3.6 - 50) < 0.01 and a[0]["t_s"] < 0 < a[-1]["t_s"]
    a = [m for m in a if m["t_s"] > 0]
    for p, q in zip(a, a[1:]):  # places are those of the velocities between them
        assert abs(q["x_m"] - p["x_m"] - 0.0025 * (p["vx_m_s"] + q["vx_m_s"])) < 1e-3, (p, q)
    after = [p for p in json.load(open("pair.json"))["participants"] if p["id"] == "A"][0]
    speed = math.hypot(a[-1]["vx_m_s"], a[-1]["vy_m_s"]) * 3.6
    assert abs(speed - after["speed_after_kmh"]) < 1, (speed, after["speed_after_kmh"])

globals()[sys.argv[1]]()
END
pair=$SRC/share/scenes/offset-car.json
"$crumple" run "$pair" -o pair.json
"$crumple" -e "load $pair" -e solve -e "export motion m.csv every=5ms" \
    -e "export motion s.csv every=5ms axes=sae" >said 2>errs
has "the step of the motion is told" "$(cat said errs)" 'every 5 ms, axes of SAE J670'
for form in mme vtk obj cast gnuplot motion; do
    python3 read.py "$form" >errs 2>&1
    same "$form is read back, with its numbers" "$?$(cat errs)" 0
done
if command -v gnuplot >/dev/null 2>&1; then
    gnuplot c.gp >errs 2>&1
    same "gnuplot draws its pair" "$?$(head -c 5 c.svg)" "0<?xml"
else
    skip "gnuplot draws its pair" "no gnuplot here"
fi
"$crumple" -e "load wall.json" -e "export film x.cast" >said 2>errs
has "a film wants a result" "$(cat errs)" 'nothing has been solved yet'
finish
