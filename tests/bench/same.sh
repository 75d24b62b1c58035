#!/bin/sh
# usage: same.sh OLD NEW [N]: whether two builds of crumple give the same results to the last digit,
# time series included, for all scenes of the tree and N random ones (200). For changes that shall only be faster.
src=$(cd "$(dirname "$0")/../.." && pwd)
CRUMPLE_DATA=$src
export CRUMPLE_DATA
old=$1 new=$2 count=${3:-200}
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM

# random crashes: everybody is about to be at the origin after 0.6 s; every fifth has an object,
# every seventh three cars
awk -v count="$count" -v to="$tmp" '
    function pick(list, a) { return a[1 + int(rand() * split(list, a, " "))] }
    function real(lo, hi) { return lo + rand() * (hi - lo) }
    function car(id, heading, speed, slip) {
        slip = rand() < 0.6
        heading = slip ? real(-180, 180) : 90 * int(real(0, 4)) - 180
        speed = rand() < 0.15 ? 0 : real(15, 90)
        return sprintf("{ \"id\": \"%s\", \"kind\": \"vehicle\", \"type\": \"%s\", \"mass_kg\": %d," \
            " \"position_m\": [%.3f, %.3f], \"heading_deg\": %.2f, \"course_deg\": %.2f," \
            " \"speed_kmh\": %.1f, \"yaw_rate_deg_s\": %.1f, \"brake\": %.2f }", id,
            pick("super-compact mini-compact compact station-wagon sedan suv"), real(900, 2500),
            real(-1, 1) - 0.6 * speed / 3.6 * cos(heading * rad),
            real(-1, 1) - 0.6 * speed / 3.6 * sin(heading * rad), heading + slip * real(-20, 20),
            heading, speed, rand() < 0.7 ? 0 : real(-60, 60), rand() < 0.5 ? 0 : real(0, 1))
    }
    function thing(shape) {
        size["pole"] = ", \"radius_m\": 0.2"
        size["box"] = ", \"length_m\": 2, \"width_m\": 1, \"mass_kg\": 900"
        shape = pick("wall pole box")
        return sprintf("{ \"id\": \"O\", \"kind\": \"object\", \"shape\": \"%s\"," \
            " \"position_m\": [%.3f, %.3f], \"heading_deg\": %.1f%s }", shape, real(-1, 1),
            real(-1, 1), real(-180, 180), size[shape])
    }
    BEGIN {
        srand(20231)
        rad = atan2(0, -1) / 180
        for (i = 1; i <= count; i++) {
            file = sprintf("%s/random-%04d.json", to, i)
            printf "{ \"crumple\": 1, \"name\": \"random-%d\", \"settings\": { \"method\": \"%s\"," \
                " \"voxel_mm\": %s, \"dt_ms\": %s, \"end\": \"%s\" },\n \"participants\": [ %s, %s%s ] }\n",
                i, pick("extended extended paper"), pick("25 25 40 50"), pick("0.5 0.5 1"),
                pick("separation separation separation rest"), car("A"),
                i % 5 ? car("B") : thing(), i % 7 ? "" : ", " car("C") >file
            close(file)
        }
    }'

scenes=0 other=0 solved=0
for scene in "$src"/share/scenes/*.json "$src"/share/validation/*/*.json "$src"/tests/bench/*.json \
    "$tmp"/random-*.json; do
    [ -e "$scene" ] || continue
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
        echo "differs: $(basename "$scene") $before $after $(cat "$tmp/why")"
        grep -E '^\t+"(ees_kmh|delta_v_kmh)":' "$tmp/old.bare" | tr -d '\n\t'
        echo
        grep -E '^\t+"(ees_kmh|delta_v_kmh)":' "$tmp/new.bare" | tr -d '\n\t'
        echo
    fi
done
echo "$scenes scenes, $solved solved, $other differ"
[ $other -eq 0 ]
