#!/bin/sh
# crumple mc: tolerances in the scene and on the command line, forms, bytes, faults.
. "$SRC/tests/cli/cli.sh"

hasnt() { ! printf '%s' "$2" | grep -q "$3"; report $? "$1"; }

run mc "$demo" --draws 10 --set A.speed_kmh=56+-3
few=$out
case $errs in
*"no GSL"*)
    skip "mc" "built without GSL"
    finish
    exit
    ;;
esac
same "a scene is drawn and solved" "$status:$errs" "0:"
has "too few to tell nine inputs apart" "$few" '^  effects of 9 inputs: take more draws$'
run mc "$demo" --draws 30 --set A.speed_kmh=56+-3
has "with its generator and seed" "$out" '^30 draws, latin hypercube by mt19937 of GSL, seed 1$'
has "the input" "$out" 'A\.speed_kmh +56 \+- 3 km/h normal$'
has "the scatter of the type" "$out" 'B\.model\.energy_factor .* scatter of the type$'
# [YAW-INERTIA]: of light trucks 0.11, of which 95 % lie within 1.96
has "what a rule assumed of it" "$out" \
    'A\.yaw_inertia_factor +1 times or by exp\(0\.22\), scatter of its rule, [0-9]{4} kgm2$'
has "results with quantiles" "$out" '^  A\.ees_kmh( +[0-9.]+){8}$'
has "ranked inputs" "$out" '^  A\.speed_kmh +[+-][0-9.]+ '

spread='{"value": 0, "tolerance": 5, "distribution": "uniform"}'
wall_scene '' "\"yaw_rate_deg_s\": $spread" >"$tmp/w.json"
for jobs in 1 3; do
    run mc "$tmp/w.json" --draws 30 --no-scatter --sampling sobol --seed 5 -f json --jobs $jobs
    cksum <"$tmp/out" >"$tmp/sum$jobs"
done
same "the same bytes for every number of jobs" "$(cat "$tmp/sum1")" "$(cat "$tmp/sum3")"
run mc "$tmp/w.json" --draws 30 --no-scatter --sampling sobol --seed 6 -f json
[ "$(cksum <"$tmp/out")" != "$(cat "$tmp/sum1")" ]
report $? "another seed gives others"
if command -v python3 >/dev/null 2>&1; then
    same "JSON has what was asked" "$(python3 -c 'import json, sys
d = json.load(open(sys.argv[1])); r = d["results"]["A"]["ees_kmh"]
print(d["class"], d["draws"], d["seed"], d["inputs"][0]["distribution"],
      sum(r["histogram"]["counts"]),
      r["q2_5"] <= r["q25"] <= r["q50"] <= r["q75"] <= r["q97_5"])' "$tmp/out")" \
        "mc 30 6 uniform 30 True"
else
    skip "JSON has what was asked" "no python3"
fi

# what was given is not drawn, and each input says by what it is
run mc "$demo" --draws 10 --set A.yaw_inertia_kgm2=5000 --set B.track_m=1.4+-0.02 -f json
same "with an inertia that is known" "$status:$errs" "0:"
hasnt "nothing is drawn of it" "$out" A.yaw_inertia
hasnt "nor by a rule what has a tolerance" "$out" B.track_factor
if command -v python3 >/dev/null 2>&1; then
    same "each input says what it is drawn by" "$(python3 -c 'import json, sys
for i in json.load(open(sys.argv[1]))["inputs"]:
    print(i["key"], i["drawn_by"], *([i["of"], round(i["assumed"], 2)] if "of" in i else []))' \
        "$tmp/out" | sort)" "A.cg.height_factor rule A.cg.height_m 0.72
A.model.energy_factor type
A.track_factor rule A.track_m 1.68
B.cg.height_factor rule B.cg.height_m 0.56
B.model.energy_factor type
B.track_m tolerance
B.yaw_inertia_factor rule B.yaw_inertia_kgm2 1251.43"
else
    skip "each input says what it is drawn by" "no python3"
fi
run -e "load $demo" -e 'mc A.yaw_inertia=5000+-300kgm2 draws=10'
hasnt "a tolerance on the line of a command says it too" "$out" A.yaw_inertia_factor
has "beside what else is assumed" "$out" 'B\.yaw_inertia_factor +1 times'

# many draws on coarse voxels, if the first say that they serve
for jobs in 1 3; do
    run mc "$tmp/w.json" --draws 240 --set A.speed_kmh=50+-5 -f json --jobs $jobs
    cksum <"$tmp/out" >"$tmp/sum$jobs"
done
same "also of draws on two grids" "$(cat "$tmp/sum1")" "$(cat "$tmp/sum3")"
cp "$tmp/out" "$tmp/auto"
run mc "$tmp/w.json" --draws 240 --set A.speed_kmh=50+-5 -f json --grid=own
if command -v python3 >/dev/null 2>&1; then
    same "which are told, and the results are those of the own grid" "$(python3 -c 'import json, sys
auto, own = (json.load(open(f)) for f in sys.argv[1:])
print(*(d[k] for d in (auto, own) for k in ("voxel_mm", "own_voxel_mm", "on_both")))
for key in "ees_kmh", "delta_v_kmh", "deformation_max_m", "acceleration_max_g":
    a, o = (d["results"]["A"][key] for d in (auto, own))
    assert o["grid_sd"] == 0 <= a["grid_sd"], key
    for q in "mean", "q2_5", "q50", "q97_5":
        assert abs(a[q] - o[q]) < 0.1 * o["sd"], (key, q, a[q], o[q])' "$tmp/auto" "$tmp/out")" \
        "40 25 24 25 25 0"
else
    skip "which are told, and the results are those of the own grid" "no python3"
fi
run mc "$tmp/w.json" --draws 240 --set A.speed_kmh=50+-5
has "and said" "$out" '^solved on voxels of 40 mm, and moved by what the first 24, solved on 25 mm'
run mc "$SRC/share/scenes/sideswipe.json" --draws 240 --set A.speed_kmh=70+-0.3 --no-scatter
has "where the grid decides, all are on the own" "$out" \
    '^all solved on voxels of 25 mm: on coarse ones the first 24 differ$'
run mc "$tmp/w.json" --draws 12 --no-scatter -f csv
same "CSV has a row per draw" "$(printf '%s\n' "$out" | grep -c '^[0-9]')" 12
has "with inputs and results" "$out" '^draw,A\.yaw_rate_deg_s,A\.ees_kmh,'
hasnt "scatter can be left out" "$out" energy_factor

# pictures
run mc "$tmp/w.json" --draws 12 --no-scatter -q -p "$tmp/h.svg" -p "tornado=$tmp/t.svg" \
    --plot A.pdof
same "charts are drawn beside the table" "$status:$errs" "0:"
has "of the result that was asked for" "$(cat "$tmp/h.svg")" '>A: direction of force \(PDOF\)<'
has "with the quantiles of the table" "$(cat "$tmp/h.svg")" '>97\.5 % [0-9.]+<'
has "and each input" "$(cat "$tmp/t.svg")" '>A\.yaw_rate_deg_s<'
refused "a chart that is none" 2 "no chart 'pie'.*tornado=FILE" mc "$demo" -p pie=x.svg
refused "a picture in another form" 2 'ends in .svg, .pdf or .png' mc "$demo" -p tornado=x.gif

wall_scene >"$tmp/plain.json"
run mc "$demo" --draws 10 -p "tornado=$tmp/few.svg"
has "no tornado of too few draws" "$status:$errs" \
    '^3:.*10 draws are too few for effects of 8 inputs'
refused "nothing varies" 3 'nothing varies.*56\+-3km/h' mc "$tmp/plain.json" --no-scatter
refused "a result that is none, before anything is drawn" 2 'no such result' \
    mc "$demo" --draws 1000000 --plot A.colour
refused "too few draws" 2 'draws' mc "$demo" --draws 3
refused "a tolerance of another unit" 3 'kg' mc "$demo" --set A.speed_kmh=56+-3kg
wall_scene '' '"yaw_rate_deg_s": {"value": 0, "tolerance": -5}' >"$tmp/bad.json"
refused "a bad tolerance has its place" 3 'bad\.json:[0-9]+:[0-9]+: .*above zero' mc "$tmp/bad.json"
wall_scene '' '"yaw_rate_deg_s": {"value": 0, "width": 5}' >"$tmp/bad.json"
refused "a key that is none" 3 'unknown key "width"' mc "$tmp/bad.json"

# charts in US units
(cd "$tmp" && "$crumple" -e "load $demo" -e 'set units=us' \
    -e 'mc A.speed=56+-3km/h draws=12 scatter=off plot=A.ees' \
    -e 'export! histogram h.svg plot=A.depth' -e 'export! tornado t.svg plot=A.ees') >/dev/null 2>&1
same "commands draw the charts" "$?" 0
has "a histogram in inches" "$(cat "$tmp/h.svg")" '>in</text>'
has "a tornado in miles per hour" "$(cat "$tmp/t.svg")" '>mph</text>'
run mc "$demo" --set A.speed_kmh=56+-3 --no-scatter --draws 12 --units=us -q \
    -p "tornado=$tmp/u.svg"
same "the word takes units" "$status" 0
has "tells miles per hour" "$out" mph
has "and draws them" "$(cat "$tmp/u.svg")" '>mph</text>'
finish
