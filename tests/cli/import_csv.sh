# shellcheck shell=sh
# Long tables: with the columns' own names, with a map, and what each lacks; sourced by import.sh.
sample long "$data/long.csv"
run import "$data/long.csv"
printf '%s\n' "$out" >"$tmp/long.jsonl"
run stack "$tmp/long.jsonl"
same "the scene solves" "$status" 0
# (the input of a test is closed)
out=$("$CRUMPLE" import - <"$data/long.csv")
same "standard input gives the same but for the name" \
    "$(printf '%s\n' "$out" | sed 's/standard input/long.csv/')" "$(cat "$data/long.jsonl")"

# other names, units and axes say the same crash
{
    echo 'Zeit;Wer;Ost;Nord;Kurs;v;L;B'
    sed 1d "$data/long.csv" | awk -F, -v OFS=';' '{ $1 = $1 * 1000; $5 = 90 - $5 } 1' | tr . ,
} >"$tmp/other.csv"
cat >"$tmp/map.json" <<'END'
{ "time": { "column": "Zeit", "unit": "ms" }, "participant": "Wer", "name": "csv",
  "x": { "column": "Ost", "unit": "m" }, "y": { "column": "Nord", "unit": "m" },
  "heading": { "column": "Kurs", "unit": "deg", "clockwise": true, "zero": "north" },
  "speed": { "column": "v", "unit": "kph" },
  "length": { "column": "L", "unit": "m" }, "width": { "column": "B", "unit": "m" } }
END
run import --map "$tmp/map.json" "$tmp/other.csv"
parts='s/.*"participants"//'
same "a map of the user's own names and axes: the same participants" \
    "$(printf '%s\n' "$out" | sed "$parts")" "$(sed "$parts" "$data/long.jsonl")"

for column in 'time:time \[s\]' 'participant:id' 'x:x \[m\]' 'y:y \[m\]' 'heading:heading \[deg\]' \
    'speed:speed \[km.h\]'; do
    sed "1s/${column#*:}/other/" "$data/long.csv" >"$tmp/less.csv"
    refused "without its ${column%%:*}" 3 "less.csv:1:.*known to be the ${column%%:*}.*--map" \
        "$tmp/less.csv"
done
sed '1s/ \[deg\]//' "$data/long.csv" >"$tmp/unit.csv"
refused "a heading without unit" 3 'unit.csv:1:.*"heading" has no unit.*heading \[deg\]' \
    "$tmp/unit.csv"
sed '4s/1.5/oops/' "$data/long.csv" >"$tmp/text.csv"
refused "a text for a number" 1 'text.csv:4:7: error: .*oops' "$tmp/text.csv"
has "gives an error object in its place" "$out" '^\{"crumple_result":2,.*"where":".*text.csv:4:7:'
sed '6s/0.2/0.1/' "$data/long.csv" >"$tmp/time.csv"
refused "a time that does not rise" 1 'time.csv:6:.*must rise.*0.1 s after 0.1 s' "$tmp/time.csv"
refused "an unknown --case" 3 'no case 7' "$data/long.csv" --case 7
# a map that says only what is added, or one column: the others are known by their names
echo '{ "vehicles": { "A": { "type": "suv" } }, "heading": { "column": "heading [deg]" } }' \
    >"$tmp/map.json"
run import "$data/long.csv" --map "$tmp/map.json"
same "a map of some keys leaves the others by name: status 0" "$status" 0
has "and adds what it says" "$out" '"id":"A","kind":"vehicle","type":"suv"'
refused "a --before of nothing" 2 '--before.*more than 0 s' "$data/long.csv" --before 0
printf 'nothing of the kind\n' >"$tmp/what.txt"
refused "no format" 3 'what.txt: error: no format' "$tmp/what.txt"
: >"$tmp/empty.csv"
refused "an empty file" 3 'empty.csv: error: an empty file' "$tmp/empty.csv"
printf '\377\376t\000' >"$tmp/wide.csv"
refused "UTF-16" 3 'wide.csv: error: UTF-16.*save it as UTF-8' "$tmp/wide.csv"
refused "no file" 2 'nowhere.csv: error: cannot open' "$tmp/nowhere.csv"

# A long file is read in constant memory: ten times the rows need no more address space than these.
long_table() { # ROWS
    awk -v n="$1" 'BEGIN { print "time [s],id,x [m],y [m],heading [deg],speed [km/h],length [m]"
        for (i = 0; i < n; i++) { d = 0.1 * (1 - i / n) * 40000
            printf "%.2f,A,%.4f,0,0,54,4\n", i / 100, -d - 1.9
            printf "%.2f,B,%.4f,0,180,54,4\n", i / 100, d + 1.9 }
        }'
}
within() { # KB FILE
    (ulimit -v "$1" && "$CRUMPLE" import "$2" >"$tmp/big.jsonl" 2>"$tmp/big.err") 2>/dev/null
}
if "$CRUMPLE" --version | grep -q 'sanitizers: no'; then
    long_table 25000 >"$tmp/small.csv"
    long_table 250000 >"$tmp/big.csv"
    kb=12000
    until within $kb "$tmp/small.csv" || [ $kb -ge 40000 ]; do
        kb=$((kb + 2000))
    done
    within $kb "$tmp/big.csv"
    same "half a million rows in the memory of fifty thousand, $kb kB: status 0" $? 0
    has "only the end is kept" "$(cat "$tmp/big.jsonl")" '"note":"only the last 2 s before '
else
    skip "a long file in little memory" "sanitizers reserve more"
fi

# in seconds of a calendar it is the same crash; what is said of it but that is the same
awk -F, -v OFS=, 'NR > 1 { $1 = sprintf("%.1f", $1 + 1764400000) } 1' "$data/long.csv" \
    >"$tmp/calendar.csv"
run import "$tmp/calendar.csv"
same "times of a calendar count from the first second that is kept" \
    "$(printf '%s\n' "$out" | sed "$parts")" "$(sed "$parts" "$data/long.jsonl")"
has "and it is noted" "$out" 'times less 1764400000 s'

# participants side by side, and a point of reference of the map's
cat >"$tmp/wide.csv" <<'END'
t [s];xA [m];yA [m];hA [deg];vA [km/h];xB [m];yB [m];hB [deg];vB [km/h]
0;0;0;0;54;8;0,5;180;54
0,1;1,5;0;0;54;6,5;0,5;180;54
END
cat >"$tmp/wide.json" <<'END'
{ "time": "t [s]", "reference": "front", "participants": {
    "A": { "x": "xA [m]", "y": "yA [m]", "heading": "hA [deg]", "speed": "vA [km/h]" },
    "B": { "x": "xB [m]", "y": "yB [m]", "heading": "hB [deg]", "speed": "vB [km/h]" } },
  "vehicles": { "*": { "type": "compact", "front_overhang_m": 0.8,
    "cg": { "behind_front_axle_m": 1.2 } } } }
END
run import --map "$tmp/wide.json" "$tmp/wide.csv"
same "side by side, from the front ends: the CG is 2 m behind each" \
    "$(printf '%s\n' "$out" | grep -o '"t_s":0,"x_m":[-0-9.]*' | tr '\n' ' ')" \
    '"t_s":0,"x_m":-2 "t_s":0,"x_m":10 '
echo '{ "tmie": "t [s]" }' >"$tmp/typo.json"
refused "a key that a map does not have" 3 'typo.json: error: .*"tmie".*did you mean "time"' \
    "$tmp/wide.csv" --map "$tmp/typo.json"
