#!/bin/sh
# crumple fit: what a solve says of a scene gives its inputs back, whatever they are.
# shellcheck disable=SC2086
. "$SRC/tests/cli/cli.sh"
case $("$crumple" --version) in
*"no GSL"* | *"no NLopt"*)
    echo "1..0 # SKIP built without GSL or NLopt"
    exit 0
    ;;
esac
command -v python3 >/dev/null 2>&1 || {
    echo "1..0 # SKIP no python3"
    exit 0
}
# voxels and slices as coarse as a search bears
cat >"$tmp/pair.json" <<'END'
{ "crumple": 1, "settings": { "dt_ms": 1, "voxel_mm": 50, "end": "rest" }, "participants": [
    { "id": "A", "kind": "vehicle", "type": "sedan", "mass_kg": 1600, "position_m": [0, 0],
      "speed_kmh": 50, "brake_after": { "deceleration_mps2": 3 } },
    { "id": "B", "kind": "vehicle", "type": "compact", "mass_kg": 1350, "position_m": [4.18, 0.74],
      "heading_deg": 180, "speed_kmh": 40,
      "place": { "against": "A", "side": "left", "overlap_percent": 60 } } ] }
END
cat >"$tmp/evidence.py" <<'PY'
import json, sys
of = {p["id"]: p for p in json.load(sys.stdin)["participants"]}
keys = {"dv": "delta_v_kmh", "ees": "ees_kmh", "yaw": "yaw_rate_after_deg_s", "pdof": "pdof_deg"}
for name in sys.argv[1:]:
    what, i = name.split(".")
    p = of[i]
    print("%s=%s" % (name, "%.4f,%.4fm" % (p["rest"]["x_m"], p["rest"]["y_m"]) if what == "rest"
                     else ",".join("%.3f" % (100 * c) for c in p["crush_profile_m"]) + "cm"
                     if what == "crush" else "%.6f" % p[keys[what]]))
PY
# back NAME "EVIDENCE ..." "SET ..." KEY=VALUE:LO:HI:NEAR ...: a fit from another start finds VALUE
back() {
    name=$1 evidence=$2 sets=$3
    shift 3
    shown=
    for set in $sets; do
        shown="$shown --set $set"
    done
    "$crumple" run "$tmp/pair.json" $shown -f json >"$tmp/solved.json"
    said=$(python3 "$tmp/evidence.py" $evidence <"$tmp/solved.json")
    keys= off=
    for input in "$@"; do
        key=${input%%=*}
        keys="$keys $key=$(printf '%s' "$input" | cut -d: -f2,3)"
    done
    run fit "$tmp/pair.json" $shown $keys to $said --starts 2 --solves 300
    for input in "$@"; do
        key=${input%%=*} value=${input#*=}
        off="$off$(printf '%s\n' "$out" | awk -v key="$key" -v value="${value%%:*}" \
            -v near="${input##*:}" '$1 == key { d = $2 - value; found = (d < 0 ? -d : d) <= near }
            END { print found ? "" : key " " }')"
    done
    same "$name" "$status:$off" "0:"
}
back "two speeds" "dv.A ees.A ees.B yaw.A yaw.B" end=separation \
    A.speed=50:20:80:0.5 B.speed=40:20:80:0.5
back "an overlap" "dv.A ees.A dv.B yaw.A yaw.B" end=separation \
    A.speed=50:30:70:0.5 B.place.overlap_percent=60:30:80:1
back "a heading" "dv.A ees.A ees.B yaw.A yaw.B" "end=separation B.heading_deg=195" \
    A.speed=50:30:70:0.5 B.heading_deg=195:180:210:0.5
back "brakes after it, from the place of rest" "dv.A ees.A rest.A" "" \
    A.speed=50:30:70:0.5 A.brake_after.deceleration_mps2=3:0:8:0.3
back "a yaw before it, from that after it" "dv.A yaw.A yaw.B" \
    "end=separation A.yaw_rate_deg_s=15" A.yaw_rate=15:-30:40:0.5
back "a speed from both crush profiles" "crush.A crush.B" end=separation A.speed=50:30:70:0.5
finish
