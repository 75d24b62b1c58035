# shellcheck shell=sh
# Tables of event data recorders: the speed with its accuracy, what a table lacks, and a result
# against a cumulative delta-v; sourced by import.sh.
sample edr "$data/edr-precrash.csv" --map "$data/edr-map.json"
run import --map "$data/edr-map.json" "$data/edr-precrash.csv"
printf '%s\n' "$out" >"$tmp/edr.json"
if "$crumple" --version | grep -q 'no GSL'; then
    skip "the speed and its accuracy are inputs of mc" "built without GSL"
else
    run mc -q -n 30 "$tmp/edr.json"
    same "the speed and its accuracy are inputs of mc" "$status" 0
    has "as what is not known exactly" "$out" 'A.speed_kmh'
fi
refused "a recorder alone" 1 'needs two participants, the case has A.*"objects"' \
    "$data/edr-precrash.csv"
refused "a delta-v has no speed before" 1 'deltav.csv:2:1: error: no speed .*compare FILE of=A' \
    --map "$data/edr-map.json" "$data/edr-deltav.csv"
sed '2s/(sec)//' "$data/edr-precrash.csv" >"$tmp/unit.csv"
refused "a time without unit" 1 'unit.csv:2:1: error: column "Time" has no unit' "$tmp/unit.csv"
sed '2s/Time (sec)/Frame/' "$data/edr-precrash.csv" >"$tmp/time.csv"
refused "no time" 1 'time.csv:2:1: error: no column of times' "$tmp/time.csv" --format edr
sed '2s/Speed, Vehicle Indicated (km.h)/Gear/' "$data/edr-precrash.csv" >"$tmp/speed.csv"
refused "no speed" 1 'speed.csv:2:1: error: no column of speeds' "$tmp/speed.csv" --format edr
sed '5s/60/fast/' "$data/edr-precrash.csv" >"$tmp/text.csv"
refused "a text for a speed" 1 "text.csv:5:6: error: 'fast'" "$tmp/text.csv"

printf 'load %s\nsolve\ncompare %s of=A\n' "$SRC/share/scenes/q7-fiat500.json" \
    "$data/edr-deltav.csv" >"$tmp/corridor.crumple"
run "$tmp/corridor.crumple"
same "a result is compared with a recorder" "$status" 0
has "inside of its accuracy, with a free shift" "$out" \
    'recorder: within \+-10 % .*at [0-4] of 4 times, its time 0 .* the first contact'
has "and the sign that was taken is told" "$out" 'sign: forward is positive, .*sign=minus turns it'
