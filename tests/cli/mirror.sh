#!/bin/sh
# A crash and its mirror image are one crash: cars on the lines of the grid against faces that lie
# upon these lines, and random scenes that rounding once decided. tests/bench/mirror.py tells where
# others part.
. "$SRC/tests/cli/cli.sh"
python3 -c '' 2>/dev/null || {
    echo "1..0 # SKIP no python3"
    exit 0
}
told() {
    python3 -B "$SRC/tests/bench/mirror.py" "$crumple" "$@" >"$tmp/told" 2>&1
}
told tie
same "33 scenes in which lines, faces and forces lie upon each other" "$?" 0
grep ' at ' "$tmp/told" | explain
# a line held by the contact and towed to one depth: 0.2 to 80 % before that was no decision
told 80 205 714 1068 1111 1435 2404 2705 3489 3737 4556 5287
same "random scenes in which a face is dragged along by a flat one" "$?" 0
grep ' at ' "$tmp/told" | explain
# what rounding took of a structure that hardly gives way opened contacts: 0.1 to 33 % before
told 1668 1978 4163
same "random scenes in which one structure gives way by all" "$?" 0
grep ' at ' "$tmp/told" | explain
# what is no mirror image is seen: of a road that slopes the image must slope, too
cat >"$tmp/slope.json" <<'SCENE'
{"crumple": 1, "settings": {"road_friction": 0.7, "slope_percent": 5, "downhill_deg": 90},
 "participants": [
 {"id": "A", "kind": "vehicle", "type": "compact", "position_m": [0, 0], "heading_deg": 0,
  "speed_kmh": 50},
 {"id": "W", "kind": "object", "shape": "wall", "position_m": [8, 0], "heading_deg": 170}]}
SCENE
told "$tmp/slope.json"
same "what is no mirror image is seen" "$?" 1
finish
