#!/bin/sh
# crumple stack as a study: fields, CSV, summary, groups, pairs, plots; and crumple merge.
. "$SRC/tests/cli/cli.sh"

# small N TYPE SPEED PAIR
small() {
    printf '{"crumple":1,"name":"s%s","pair":"%s",' "$1" "$4"
    printf '"settings":{"voxel_mm":100,"dt_ms":2},"participants":['
    printf '{"id":"A","kind":"vehicle","type":"%s","mass_kg":1400,"position_m":[0,0],' "$2"
    printf '"heading_deg":0,"speed_kmh":%s},{"id":"wall","kind":"object","shape":"wall",' "$3"
    printf '"position_m":[4,0],"heading_deg":180}]}\n'
}
{
    echo '{"crumple":1}'
    for i in 1 2 3 4 5 6 7; do
        small "a$i" compact $((30 + 3 * i)) "p$i"
        small "b$i" sedan $((25 + 2 * i)) "p$i"
    done
} >"$tmp/s.jsonl"
run stack "$tmp/s.jsonl" -o "$tmp/all"
same "one scene of fifteen is none" "$status" 1

# tables
run stack "$tmp/s.jsonl" -f csv
same "CSV has a row per scene" "$status:$(wc -l <"$tmp/out" | tr -d ' ')" 1:16
same "its columns are those of the vehicles" "$(head -n 1 "$tmp/out")" \
    "index,scene,pair,A.ees_kmh,A.delta_v_kmh,A.pdof_deg,A.deformation_max_m,A.acceleration_max_g,\
A.olc_g,error"
has "a failed scene has its error" "$(sed -n 2p "$tmp/out")" \
    '^0,s.jsonl:1,,,,,,,,"?the scene has no'
# what a spreadsheet would take for a formula, it also takes within quotes
for name in '=1+1' '+1' '-1' '@SUM(A1)'; do
    small x compact 30 "$name" | sed "s/\"sx\"/\"$name\"/" >"$tmp/formula.json"
    run stack "$tmp/formula.json" -f csv
    has "no formula in a table: $name" "$(sed -n 2p "$tmp/out" | cut -d, -f1-3)" \
        "^0,'[$name]*,'[$name]*\$"
done
run stack "$tmp/s.jsonl" -f csv --fields A.speed_kmh,A.ees --fields A.cdc,friction
same "the fields that are asked for, of results and inputs" "$(sed -n '1p;3p' "$tmp/out" |
    sed 's/,[0-9]*\.[0-9]*,/,X,/')" \
    "index,scene,pair,A.speed_kmh,A.ees,A.cdc,friction,error
1,sa1,p1,33,X,12FDEW1,auto,"
run stack "$tmp/s.jsonl" --fields A.ees_kmh
has "as JSON" "$(sed -n 2p "$tmp/out")" \
    '^[{]"index":1,"scene":"sa1","pair":"p1","A.ees_kmh":[0-9.]+[}]$'
has "with the errors" "$(sed -n 1p "$tmp/out")" '"error":[{]"code":"missing"'
want=$(sed -n 2p "$tmp/all" | sed 's/.*"id":"A","ees_kmh":\([0-9.]*\),.*/\1/')
has "the numbers are those of the results" "$(sed -n 2p "$tmp/out")" "\"A.ees_kmh\":$want[}]"
run stack "$tmp/s.jsonl" --fields scene,A.ees_kmh,A.ees_kmh,index
has "a field that is there already comes once" "$(sed -n 2p "$tmp/out")" \
    '^[{]"index":1,"scene":"sa1","pair":"p1","A.ees_kmh":[0-9.]+[}]$'
refused "a field that is none" 2 "no value 'A.colour'" stack "$tmp/s.jsonl" --fields A.colour
refused "an empty field" 2 'a name is empty' stack "$tmp/s.jsonl" --fields A.ees,,A.cdc

# summary
run stack "$tmp/s.jsonl" --summary --fields A.speed_kmh
same "counts" "$(head -n 1 "$tmp/out")" "Scenes: 15; solved 14, failed 1 (missing 1)"
# speeds: 27 29 31 33 33 35 36 37 39 39 42 45 48 51
has "quantiles" "$out" ' A.speed_kmh +14 +37\.5 +28\.3 +33 +36\.5 +41\.25 +49\.05$'
has "pairs: how many, sign test" "$out" ' A.ees_kmh +7 +7 +0 +-[0-9.]+ .* 0\.016$'
run stack "$tmp/s.jsonl" --summary --fields A.speed_kmh --group A.model
has "a group" "$out" '^  compact/12 +7 +42 '
has "another group" "$out" '^  sedan/12 +7 +33 '
refused "a group without a summary" 2 'add --summary' stack "$tmp/s.jsonl" --group A.model
run stack "$tmp/s.jsonl" --summary -o "$tmp/with"
same "with -o the records go there" "$(cksum <"$tmp/with")" "$(cksum <"$tmp/all")"
has "and the summary to standard output" "$out" '^Scenes: 15'

# plots
run stack "$tmp/s.jsonl" --plot 'x=A.speed_kmh y=A.ees_kmh' --ascii --width 60
has "points over axes" "$out" '^A.ees_kmh over A.speed_kmh'
n=$(printf '%s' "$out" | sed 1d | tr -cd '*' | wc -c)
[ "$n" -ge 10 ] && [ "$n" -le 14 ]
report $? "no more of them than scenes, hence no lines: $n"
run stack "$tmp/s.jsonl" --plot x=A.speed_kmh,y=A.mass_kg,z=A.speed_kmh --ascii
has "a heat map says what it shows" "$out" '^A.speed_kmh: A.mass_kg down, A.speed_kmh across .means'
has "of bins" "$out" '^     1400 '
run stack "$tmp/s.jsonl" --plot 'x=A.speed_kmh y=A.ees_kmh' --picture "$tmp/points.svg"
has "points as a picture" "$(cat "$tmp/points.svg")" '<title>A.ees_kmh over A.speed_kmh'
run stack "$tmp/s.jsonl" --plot 'x=A.speed_kmh y=A.mass_kg z=A.ees' --picture "$tmp/map.svg"
has "a heat map as a picture" "$(tr -d '\n' <"$tmp/map.svg")" '<svg.*A.mass_kg.*</svg>'
refused "a picture of another kind" 2 'ends in .svg, .pdf or .png' \
    stack "$tmp/s.jsonl" --plot 'x=A.ees y=A.ees' --picture "$tmp/x.gif"
refused "a picture of no plot" 2 'is the file of a --plot' stack "$tmp/s.jsonl" --picture x.svg
refused "a plot without y" 2 'x=NAME and y=NAME' stack "$tmp/s.jsonl" --plot x=A.ees
refused "a plot of what is none" 2 "no value 'A.colour'" \
    stack "$tmp/s.jsonl" --plot x=A.ees,y=A.colour
refused "axes that are none" 2 "'q=A.ees' is none of" stack "$tmp/s.jsonl" --plot q=A.ees

# merge
for i in 1 2 3 4; do "$crumple" stack --shard $i/4 "$tmp/s.jsonl" -o "$tmp/part$i"; done
run merge "$tmp/part3" "$tmp/part1" "$tmp/part4" "$tmp/part2" -o "$tmp/merged"
same "merge makes of shards what one stack writes" "$status:$(cksum <"$tmp/merged")" \
    "1:$(cksum <"$tmp/all")"
run merge "$tmp/part3" "$tmp/part1" "$tmp/part4"
has "what is missing is named" "$errs" '^crumple: missing: [0-9]+ scenes .index 1 to 2'
same "with status 1" "$status" 1
run merge --scenes 17 "$tmp/merged"
has "also at the end" "$errs" 'missing: 2 scenes .index 15 to 16.'
run merge "$tmp/merged" "$tmp/part1"
same "the same part twice is fine" "$(cksum <"$tmp/out")" "$(cksum <"$tmp/all")"
sed 's/"ees_kmh":[0-9]/"ees_kmh":9/' "$tmp/part2" >"$tmp/other"
run merge "$tmp/part2" "$tmp/other"
has "two results of one scene are not" "$status:$errs" \
    '^3:.*other: error: scene [0-9]+ is in .*part2'
echo before >"$tmp/o.part"
run merge "$tmp/part2" "$tmp/other" -o "$tmp/o"
same "nothing is left of what was begun" "$status:$(cd "$tmp" && ls | grep -c '^o$\|^o\.')" 3:1
same "and what lay there is as it was" "$(cat "$tmp/o.part")" before
rm "$tmp/o.part"
head -c 3000 "$tmp/part2" >"$tmp/short"
refused "a part that was cut" 3 'short:[0-9]+:1: error: the last line is cut' merge "$tmp/short"
for index in 1e300 -1; do
    head -n 1 "$tmp/part2" | sed "s/\"index\":[0-9]*/\"index\":$index/" >"$tmp/beyond"
    refused "an index of $index" 3 'beyond:1:1: error: an index that none can have' \
        merge "$tmp/beyond"
done
refused "a part that is none" 3 's.jsonl:1:1: error: this is no result' merge "$tmp/s.jsonl"
refused "a part that is not there" 2 'nowhere: error: cannot open' merge "$tmp/nowhere"
run merge "$tmp/part1" "$tmp/part2" "$tmp/part3" "$tmp/part4" --summary
has "a summary of parts" "$out" '^Scenes: 15; solved 14, failed 1'
has "with their pairs" "$out" '^Pairs: 7 of 7 compared'
{
    "$crumple" merge "$tmp/part1" "$tmp/part2" "$tmp/part3" "$tmp/part4" 2>"$tmp/errs"
    echo $? >"$tmp/status"
} | head -c 1 >"$tmp/out"
same "a reader that has had enough of it is no failure" "$(cat "$tmp/status" "$tmp/errs")" 0
run merge "$tmp/all" -f csv --fields A.ees
same "a table of parts" "$(wc -l <"$tmp/out" | tr -d ' ')" 16

# per impact: the rows of run --per=impact, of several scenes
fields=impact,id,partner,cdc,t_s,ees_kmh,delta_v_kmh,pulse_ms
names=$(echo "$fields" | tr ',' '|')
run run -f csv --per impact "$SRC/share/scenes/three-cars.json"
awk -F, -v "names=^($names)\$" '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i ~ names) column[++n] = i }
    { line = ""; for (i = 1; i <= n; i++) line = line "," $(column[i]); print line }' \
    "$tmp/out" >"$tmp/want"
run stack -f csv --per impact --fields "$fields" "$SRC/share/scenes/three-cars.json"
has "an impact has a row per vehicle" "$(wc -l <"$tmp/out")" '^ *[579]$'
same "as run tells them" "$(cut -d, -f 4-11 "$tmp/out")" "$(sed 's/^,//' "$tmp/want")"
run stack --per impact "$tmp/s.jsonl" -f csv
same "a wall has no row, a failed scene one" "$status:$(wc -l <"$tmp/out" | tr -d ' ')" 1:16
has "with the main results" "$(head -n 1 "$tmp/out")" \
    '^index,scene,pair,impact,id,partner,t_s,ees_kmh,delta_v_kmh,.*,error$'
has "a failed scene has its error" "$(sed -n 2p "$tmp/out")" '^0,s.jsonl:1,,,+"?the scene has no'
cp "$tmp/out" "$tmp/want"
run merge "$tmp/part1" "$tmp/part2" "$tmp/part3" "$tmp/part4" --per impact -f csv
same "merge makes the same of parts" "$(cksum <"$tmp/out")" "$(cksum <"$tmp/want")"
run stack --per impact "$tmp/s.jsonl"
has "as JSON without a form" "$(sed -n 2p "$tmp/out")" \
    '^[{]"index":1,"scene":"sa1","pair":"p1","impact":1,"id":"A","partner":"wall","t_s":'
refused "an impact has no such value" 2 "no value 'dlta_v'" \
    stack --per impact "$tmp/s.jsonl" --fields dlta_v
refused "version 1 tells no impacts" 2 'tells no impacts .*version 1' \
    stack --per impact "$tmp/s.jsonl" --result-version 1
refused "a summary counts scenes" 2 'count scenes, not impacts' \
    stack --per impact "$tmp/s.jsonl" --summary
finish
