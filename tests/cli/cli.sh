# shellcheck shell=sh
# What the tests of the command line share: sourced.
. "$SRC/tests/tap.sh"
crumple=$CRUMPLE
demo=$SRC/share/scenes/q7-fiat500.json
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM

# run ARG ...: the program, with $out, $errs and $status; standard input is empty
run() {
    "$crumple" "$@" >"$tmp/out" 2>"$tmp/errs" </dev/null
    status=$?
    out=$(cat "$tmp/out")
    errs=$(cat "$tmp/errs")
}

# refused NAME STATUS PATTERN ARG ...: ends with the status, nothing on standard output, and one
# message line on standard error that the extended regular expression matches
refused() {
    refused_name=$1 refused_want=$2 refused_pattern=$3
    shift 3
    run "$@"
    lines=$(printf '%s' "$errs" | grep -c '')
    [ "$status" -eq "$refused_want" ] && [ -z "$out" ] && [ "$lines" -eq 1 ] &&
        printf '%s\n' "$errs" | grep -Eq -e "$refused_pattern"
    refused_ok=$?
    report $refused_ok "$refused_name"
    [ $refused_ok -eq 0 ] || {
        echo "status $status, want $refused_want; $lines lines; no match for: $refused_pattern"
        printf '%s\n' "$errs"
    } | explain
}

# scene NAME TEXT: a file in the scratch folder
scene() {
    printf '%s\n' "$2" >"$tmp/$1"
}

# a scene that solves at once: a car into a wall; $1 replaces the wall, $2 goes into the car
wall_scene() {
    wall='{ "id": "wall", "kind": "object", "shape": "wall",
      "position_m": [4, 0], "heading_deg": 180 }'
    cat <<END
{ "crumple": 1, "name": "small",
  "participants": [
    { "id": "A", "kind": "vehicle", "type": "compact", "mass_kg": 1400,
      ${2:+$2,}
      "position_m": [0, 0], "heading_deg": 0, "speed_kmh": 50 },
    ${1:-$wall} ] }
END
}
