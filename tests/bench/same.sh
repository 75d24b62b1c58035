#!/bin/sh
# usage: same.sh OLD NEW [N]: whether two builds of crumple give the same results to the last digit,
# time series included, for all scenes of the tree and N random ones (200). For changes that shall
# only be faster.
src=$(cd "$(dirname "$0")/../.." && pwd)
CRUMPLE_DATA=$src
export CRUMPLE_DATA
old=$1 new=$2 count=${3:-200}
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM

# Random crashes: everybody is about to be at the origin after 0.6 s; every fifth has an object,
# every seventh three cars; @ stands for the quotes of JSON.
types=$(cd "$src/models" && echo *.json | sed 's/\.json//g')
awk -v count="$count" -v to="$tmp" -v types="$types" '
    function pick(list, a) { return a[1 + int(rand() * split(list, a, " "))] }
    function real(lo, hi) { return lo + rand() * (hi - lo) }
    function text(key, value) { return "@" key "@: @" value "@, " }
    function number(key, value) { return "@" key "@: " value ", " }
    function place(x, y) { return sprintf("@position_m@: [%.3f, %.3f]", x, y) }
    function car(id, heading, speed, slips, line) {
        slips = rand() < 0.6
        heading = slips ? real(-180, 180) : 90 * int(real(0, 4)) - 180
        speed = rand() < 0.15 ? 0 : real(15, 90)
        line = text("id", id) text("kind", "vehicle") text("type",
            pick(types))
        line = line number("mass_kg", int(real(900, 2500)))
        line = line number("heading_deg", heading + slips * real(-20, 20))
        line = line number("course_deg", heading) number("speed_kmh", speed)
        line = line number("yaw_rate_deg_s", rand() < 0.7 ? 0 : real(-60, 60))
        line = line number("brake", rand() < 0.5 ? 0 : rand())
        return "{ " line place(real(-1, 1) - speed / 6 * cos(heading * rad),
            real(-1, 1) - speed / 6 * sin(heading * rad)) " }"
    }
    function thing(line, shape) {
        size["pole"] = number("radius_m", 0.2)
        size["box"] = number("length_m", 2) number("width_m", 1) number("mass_kg", 900)
        shape = pick("wall pole box")
        line = text("id", "O") text("kind", "object") text("shape", shape) size[shape]
        line = line number("heading_deg", real(-180, 180))
        return "{ " line place(real(-1, 1), real(-1, 1)) " }"
    }
    BEGIN {
        srand(20231)
        rad = atan2(0, -1) / 180
        for (i = 1; i <= count; i++) {
            file = sprintf("%s/random-%04d.json", to, i)
            line = text("method", pick("extended extended paper"))
            line = line number("voxel_mm", pick("25 25 40 50"))
            line = line number("dt_ms", pick("0.5 0.5 1"))
            line = line text("end", pick("separation separation separation rest"))
            sub(/, $/, "", line)
            line = "{ " number("crumple", 1) "@settings@: { " line " }, @participants@: [ " car("A")
            line = line ", " (i % 5 ? car("B") : thing()) (i % 7 ? "" : ", " car("C")) " ] }"
            gsub(/@/, "\"", line)
            print line >file
            close(file)
        }
    }'

# the lines that tell what a crash was
severity() {
    grep -E '^[[:blank:]]+"(ees_kmh|delta_v_kmh)":' "$1" | tr -d '\t\n'
    echo
}

scenes=0 other=0 solved=0
for scene in "$src"/share/scenes/*.json "$src"/share/validation/*/*.json "$src"/tests/bench/*.json \
    "$tmp"/random-*.json; do
    "$old" run --trace "$scene" >"$tmp/old" 2>&1
    before=$?
    "$new" run --trace "$scene" >"$tmp/new" 2>&1
    after=$?
    scenes=$((scenes + 1))
    [ $after -eq 0 ] && solved=$((solved + 1))
    # versions and hashes of models may differ
    for side in old new; do
        sed '/^\t"version":/d; s/ sha256 [0-9a-f]*//' "$tmp/$side" >"$tmp/$side.bare"
    done
    if [ $before -ne $after ] || ! cmp "$tmp/old.bare" "$tmp/new.bare" >"$tmp/why" 2>&1; then
        other=$((other + 1))
        echo "differs: $(basename "$scene"), status $before, then $after: $(cat "$tmp/why")"
        severity "$tmp/old.bare"
        severity "$tmp/new.bare"
    fi
done
echo "$scenes scenes, $solved solved, $other differ"
[ $other -eq 0 ]
