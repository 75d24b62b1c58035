#!/bin/sh
# crumple stack: forms of input, order, faulty scenes, shards, resuming, pairs, threads.
. "$SRC/tests/cli/cli.sh"

# small N SPEED [EXTRA]: one scene on one line
small() {
    printf '{"crumple":1,"name":"s%s",%s' "$1" "$3"
    printf '"settings":{"voxel_mm":100,"dt_ms":2},"participants":['
    printf '{"id":"A","kind":"vehicle","type":"compact","mass_kg":1400,"position_m":[0,0],'
    printf '"heading_deg":0,"speed_kmh":%s},{"id":"wall","kind":"object","shape":"wall",' "$2"
    printf '"position_m":[4,0],"heading_deg":180}]}\n'
}
names() {
    printf '%s\n' "$out" | sed 's/.*"scene":"\([^"]*\)".*/\1/' | tr '\n' ' '
}
for i in 1 2 3 4 5 6 7 8 9 10 11 12; do small $i $((30 + i)); done >"$tmp/twelve.jsonl"

run stack "$tmp/twelve.jsonl"
same "JSON Lines are solved" "$status:$errs" "0:"
same "in input order" "$(names)" "s1 s2 s3 s4 s5 s6 s7 s8 s9 s10 s11 s12 "
cp "$tmp/out" "$tmp/one"
for jobs in 1 3 8; do
    run stack --jobs $jobs "$tmp/twelve.jsonl"
    same "the same bytes with $jobs threads" "$(cksum <"$tmp/out")" "$(cksum <"$tmp/one")"
done
{ printf '[\n'; sed '$!s/$/,/' "$tmp/twelve.jsonl"; printf ']\n'; } >"$tmp/array.json"
run stack "$tmp/array.json"
same "a JSON array gives the same" "$(cksum <"$tmp/out")" "$(cksum <"$tmp/one")"
"$crumple" stack - <"$tmp/twelve.jsonl" >"$tmp/out" 2>&1
same "standard input gives the same" "$(cksum <"$tmp/out")" "$(cksum <"$tmp/one")"
"$crumple" stack - <"$tmp/array.json" >"$tmp/out" 2>&1
same "an array on standard input too" "$(cksum <"$tmp/out")" "$(cksum <"$tmp/one")"

sed 's/"name":"s[0-9]*",//' "$tmp/twelve.jsonl" >"$tmp/unnamed.jsonl"
run stack "$tmp/unnamed.jsonl"
same "a scene without a name goes by file and line" "$(names | cut -c 1-33)" \
    "unnamed.jsonl:1 unnamed.jsonl:2 u"
for dir in C C.UTF-8 de_DE.UTF-8; do
    mkdir -p "$tmp/order"
    for i in b B a_1 a1; do small $i 40 >"$tmp/order/$i.json"; done
    LC_ALL=$dir run stack "$tmp/order"
    same "a folder is in the order of bytes with LC_ALL=$dir" "$(names)" "sB sa1 sa_1 sb "
done
mkdir "$tmp/folder"
wall_scene >"$tmp/folder/b.json"
small 7 40 >"$tmp/folder/c.json"
small 1 41 >"$tmp/folder/a.ndjson"
echo no >"$tmp/folder/readme.txt"
run stack "$tmp/folder" "$tmp/twelve.jsonl"
same "folders by name, then files" "$(names)" "s1 small s7 s1 s2 s3 s4 s5 s6 s7 s8 s9 s10 s11 s12 "
run stack "$demo"
same "a printed scene is one scene" "$(names)" "q7-fiat500 "
has "one line has the fields of a result" "$out" '^\{"crumple_result":2,.*"balance":\{.*\}\}$'
same "no resolved scene unless asked" "$(printf '%s' "$out" | grep -c '"resolved"')" 0
run stack --resolved --trace "$demo"
has "--resolved and --trace add them" "$out" '"resolved":\{.*"trace":\{'
run stack --set restitution=0 --set A.speed_kmh=20 "$tmp/twelve.jsonl"
same "--set works in every scene" "$(printf '%s\n' "$out" | grep -c '"restitution":0,')" 12

# faulty scenes
{
    small 1 40
    echo '{"crumple":1, broken'
    small 3 0
    small 4 40 '"pairs":"p",'
    small 5 40
} >"$tmp/bad.jsonl"
run stack "$tmp/bad.jsonl"
same "a bad scene gives status 1" "$status" 1
same "and the stack goes on" "$(names)" "s1 bad.jsonl:2 s3 s4 s5 "
same "each record has its number" \
    "$(printf '%s\n' "$out" | sed 's/.*"index":\([0-9]*\),.*/\1/' | tr '\n' ' ')" "0 1 2 3 4 "
has "line of a syntax error" "$(sed -n 2p "$tmp/out")" '"code":"syntax".*bad.jsonl:2:[0-9]+:'
has "scenes that never meet" "$(sed -n 3p "$tmp/out")" '"code":"no-contact"'
has "line and nearest key of a misspelt one" "$(sed -n 4p "$tmp/out")" \
    '"code":"unknown-key".*pair.*bad.jsonl:4:'
refused "a file that is not there is told before any work" 2 \
    'missing.json: error: cannot open: No such file' stack "$tmp/bad.jsonl" "$tmp/missing.json"
printf '[\n' >"$tmp/open.json"
small 1 40 >>"$tmp/open.json"
run stack "$tmp/open.json"
has "an array without end is told" "$status$(sed -n 2p "$tmp/out")" '^1.*has no end'
{ cat "$tmp/array.json"; echo x; } >"$tmp/more.json"
run stack "$tmp/more.json"
has "text after an array is told" "$(sed -n 13p "$tmp/out")" 'after the end.*more.json:15:'
: >"$tmp/empty.json"
run stack "$tmp/empty.json"
has "an empty file is told" "$status:$out" '^1:.*no scene'
mkdir "$tmp/nothing"
run stack "$tmp/nothing"
has "an empty folder is told" "$status:$out" '^1:.*no scenes.*jsonl'
"$crumple" stack --jobs 2 "$tmp/twelve.jsonl" >/dev/full 2>"$tmp/errs"
same "a full disk is status 2" "$?" 2
has "and is told" "$(cat "$tmp/errs")" 'standard output: error: cannot write'
refused "no input" 2 'INPUT' stack
refused "a shard that is none" 2 'I/N' stack --shard 3/2 "$demo"

# shards
for i in 1 2 3; do "$crumple" stack --shard $i/3 "$tmp/twelve.jsonl"; done >"$tmp/shards"
same "shards make up the whole" "$(sort "$tmp/shards" | cksum)" "$(sort "$tmp/one" | cksum)"
run stack --shard 2/3 "$tmp/twelve.jsonl"
same "a shard has every third scene" "$(names)" "s2 s5 s8 s11 "

# output file, resuming
refused "what is no result cannot be resumed" 3 'array.json:1:1: error: .*what crumple stack' \
    stack "$tmp/twelve.jsonl" --resume "$tmp/array.json"
run stack -o "$tmp/result.jsonl" "$tmp/twelve.jsonl"
same "-o writes the same" "$(cksum <"$tmp/result.jsonl")" "$(cksum <"$tmp/one")"
mkfifo "$tmp/pipe"
cat "$tmp/pipe" >"$tmp/through" &
run stack "$tmp/twelve.jsonl" -o "$tmp/pipe"
wait $!
same "-o into a pipe" "$status:$errs:$(cksum <"$tmp/through")" "0::$(cksum <"$tmp/one")"
[ -p "$tmp/pipe" ]
report $? "which is a pipe still"
refused "-o onto a folder, before any work" 2 'folder: error: cannot write: Is a directory' \
    stack "$tmp/twelve.jsonl" -o "$tmp/folder"
refused "-o onto a full disk" 2 'full: error: cannot write: No space' \
    stack "$tmp/twelve.jsonl" -o /dev/full
[ -c /dev/full ]
report $? "which is a device still"
same "and leaves nothing beside it" "$(ls "$tmp" | grep -c part)" 0
{ sed -n 1,7p "$tmp/one"; sed -n 8p "$tmp/one" | cut -c 1-500 | tr -d '\n'; } >"$tmp/cut"
# a mark that only a line taken over can carry
sed 's/"crumple_result":2,/&"x":"taken over",/' "$tmp/cut" >"$tmp/marked"
run stack --resume "$tmp/marked" "$tmp/twelve.jsonl"
same "whole lines are taken over" "$(grep -c 'taken over' "$tmp/out")" 7
same "and nothing else differs" "$(sed 's/"x":"taken over",//' "$tmp/out" | cksum)" \
    "$(cksum <"$tmp/one")"
run stack --resume "$tmp/marked" --set friction=0.4 "$tmp/twelve.jsonl"
same "changed scenes are solved anew" "$(grep -c 'taken over' "$tmp/out")" 0
sed 's/"version":"[^"]*"/"version":"0.0.0"/' "$tmp/marked" >"$tmp/old"
run stack --resume "$tmp/old" "$tmp/twelve.jsonl"
same "results of another version are not used" "$(grep -c 'taken over' "$tmp/out")" 0
run stack --resume "$tmp/marked" --trace "$tmp/twelve.jsonl"
same "nor results without the trace" "$(grep -c 'taken over' "$tmp/out")" 0
refused "a file to resume that is not there" 2 'nowhere' stack --resume "$tmp/nowhere" "$demo"
cp "$tmp/cut" "$tmp/r.part"
run stack -o "$tmp/r" --resume "$tmp/r.part" "$tmp/twelve.jsonl"
same "-o goes on with its unfinished output" "$status:$errs:$(cksum <"$tmp/r")" \
    "0::$(cksum <"$tmp/one")"
same "which is gone then" "$(ls "$tmp" | grep -c 'r\.part')" 0

# --resume FILE alone: what an interrupted -o FILE has left is gone on with
sed 's/"version":/"x":"taken over",&/' "$tmp/cut" >"$tmp/again.part"
head -n 9 "$tmp/marked" | tail -n 2 >"$tmp/again.part.1"
run stack --resume "$tmp/again" "$tmp/twelve.jsonl"
same "--resume FILE goes on with FILE.part" "$status:$errs:$out" "0::"
same "takes over what is whole in it" "$(grep -c 'taken over' "$tmp/again")" 7
same "and differs in nothing" "$(sed 's/"x":"taken over",//' "$tmp/again" | cksum)" \
    "$(cksum <"$tmp/one")"
same "the parts are gone then" "$(ls "$tmp" | grep -c 'again\.part')" 0
echo old >"$tmp/kept.part"
run stack -o "$tmp/kept" "$tmp/missing.json"
same "a stack that cannot begin leaves the part of another" "$(cat "$tmp/kept.part")" old

# links
mkdir "$tmp/real"
ln -s real/target "$tmp/link"
: >"$tmp/real/target"
run stack "$tmp/twelve.jsonl" -o "$tmp/link"
[ -L "$tmp/link" ]
report $? "an output that is a link stays one"
same "and its target is written" "$(cksum <"$tmp/real/target")" "$(cksum <"$tmp/one")"
ln -s ../elsewhere "$tmp/real/target.part"
run stack "$tmp/twelve.jsonl" -o "$tmp/link"
[ ! -e "$tmp/elsewhere" ]
report $? "a link that lies where the part goes is not followed"

{
    "$crumple" stack "$tmp/twelve.jsonl" "$tmp/twelve.jsonl" 2>"$tmp/errs"
    echo $? >"$tmp/status"
} | head -n 1 >"$tmp/out"
same "| head ends quietly" "$(cat "$tmp/status"):$(cat "$tmp/errs")" "0:"

for word in catalogue models "schema result" "validate --fast" "run --trace $demo"; do
    {
        # shellcheck disable=SC2086
        "$crumple" $word 2>"$tmp/errs"
        echo $? >"$tmp/status"
    } | true
    same "and so does $word" "$(cat "$tmp/status"):$(cat "$tmp/errs")" "0:"
done

# pairs
{
    small 1 50 '"pair":"p",'
    small 2 45
    small 3 40 '"pair":"p",'
    small 4 40 '"pair":"lonely",'
} >"$tmp/pairs.jsonl"
run stack "$tmp/pairs.jsonl"
same "a pair without its second is status 1" "$status" 1
has "the difference comes last" "$(sed -n 5p "$tmp/out")" \
    '"pair":"p","scenes":\["s1","s3"\],"difference":\[\{"id":"A","ees_kmh":-[0-9.]+,'
has "with injury probabilities" "$(sed -n 5p "$tmp/out")" '"probability":-'
has "the lonely one is told" "$(sed -n 6p "$tmp/out")" '"scene":"lonely".*1 scenes'
run stack --shard 1/2 "$tmp/pairs.jsonl"
same "shards keep pairs together" "$(names | cut -c 1-6)" "s1 s3 "

"$crumple" stack --progress --jobs 2 "$tmp/twelve.jsonl" >"$tmp/out" 2>"$tmp/errs"
has "--progress tells the count" "$(cat "$tmp/errs")" '^12 scenes, 0 failed'
finish
