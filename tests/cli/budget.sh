#!/bin/sh
# Bombs: scenes and command files that would cost minutes or gigabytes end within their budget, with
# a word for what is expensive in them.
. "$SRC/tests/cli/cli.sh"
cases=$SRC/tests/cases/hostile
cd "$tmp" || exit 99
cp "$cases/pole.json" .

# bomb NAME SECONDS MEGABYTES STATUS PATTERN ARG ...: ends within so much processor time and memory,
# with the status, and says what the pattern wants. The memory is that of addresses, which is more
# than what is used; a sanitizer needs far more of those.
bomb() {
    bomb_name=$1 bomb_seconds=$2 bomb_mb=$3 bomb_want=$4 bomb_pattern=$5
    shift 5
    (
        ulimit -t "$bomb_seconds"
        "$crumple" --version | grep -q 'sanitizers: no' && ulimit -v $((bomb_mb * 1024))
        exec "$crumple" "$@"
    ) >bomb.out 2>&1 </dev/null
    same "$bomb_name: status" "$?" "$bomb_want"
    has "$bomb_name: told" "$(head -c 2000 bomb.out; tail -n 5 bomb.out)" "$bomb_pattern"
}

bomb "sixteen lorries of 5 mm" 5 300 4 'too expensive: it takes more than 1024 MB \(its vehicles' \
    run "$cases/mem16.json"
bomb "the same in a stack" 5 500 1 '"code":"too-expensive".*voxel_mm' stack "$cases/mem16.json"
bomb "the same with a smaller budget" 5 300 4 'more than 10 MB' \
    run "$cases/pole.json" --set voxel_mm=5 --max-memory 10
bomb "slices of 1 us until rest" 9 600 4 'not solved within 1 s.*until all stand still' \
    run "$cases/dtrest.json" --max-seconds 1
bomb "the same in a stack" 9 600 1 '"code":"too-expensive".*dt_ms' \
    stack "$cases/dtrest.json" --max-seconds 1
bomb "the same in a command file" 9 600 4 'error: too expensive.*1 s' \
    --max-seconds=1 -e "load $cases/dtrest.json" -e solve
bomb "the same in a report" 9 600 4 'too expensive.*1 s' \
    report "$cases/dtrest.json" --max-seconds 1 -o dtrest.html
bomb "the same drawn" 9 600 4 'too expensive.*1 s|no GSL' \
    mc "$cases/dtrest.json" --set A.speed_kmh=30+-1 --max-seconds 1
bomb "draws of too many voxels" 9 300 4 'too expensive.*10 MB|no GSL' \
    mc "$cases/pole.json" --set A.speed_kmh=30+-1 --set voxel_mm=5 --max-memory 10
bomb "a search with too many voxels" 9 300 4 'too expensive.*10 MB|no NLopt' \
    fit "$cases/pole.json" A.speed=20:40km/h to dv.A=20km/h --solves 20 \
    --set voxel_mm=5 --max-memory 10
bomb "a search that takes too long" 9 600 4 'too expensive.*1 s|no NLopt' \
    fit "$cases/dtrest.json" A.speed=20:40km/h to dv.A=20km/h --max-seconds 1
bomb "the same as the crash of a model" 9 600 4 'too expensive.*1 s' \
    models sedan --crash="$cases/dtrest.json" --max-seconds 1
printf '%s\n' id,type,mass_kg,face,field_length_m,pdof_deg,c1_m,c2_m,c3_m \
    A,sedan,1600,front,1.4,0,0.3,0.33,0.3 >crush.csv
bomb "the same beside a damage" 9 600 4 'too expensive.*1 s' \
    damage crush.csv --solved="$cases/dtrest.json" --max-seconds 1
sed 's/"crumple": 1,/&"x_expect": { "A": { "ees_kmh": 50 } },/' "$cases/dtrest.json" >own.json
bomb "the same as an own test" 15 900 0 'too expensive.*1 s' \
    validate own.json --cases --max-seconds 1
has "which has no numbers then" "$(cat bomb.out)" 'measured +50 km/h +paper +-  extended +-$'
# at_work PID: it has used a tenth of a second
at_work() {
    for _ in $(seq 60); do
        [ "$(cut -d ' ' -f 14 /proc/"$1"/stat 2>/dev/null || echo 99)" -ge 10 ] && return
        sleep 0.2
    done
}
# Processes that get no processor: their time runs out by the clock, before they have done the work
# that they may do, which would end them with another status here.
cp "$cases/dtrest.json" .
printf 'load dtrest.json\nsolve\n' >dtrest.crumple
pids=
for words in "run dtrest.json" "report dtrest.json -o dtrest.html" dtrest.crumple; do
    # words it is
    # shellcheck disable=SC2086
    (ulimit -t 3 && exec "$crumple" $words --max-seconds=3) >"${words%% *}.out" 2>&1 </dev/null &
    pids="$pids $!" && at_work $! && kill -STOP $!
done
sleep 9
for pid in $pids; do
    kill -CONT "$pid"
    wait "$pid"
    same "no processor: status" $? 4
done
for words in run report dtrest.crumple; do
    has "told by $words" "$(cat $words.out)" 'not solved within 3 s of work or 9 s by the clock'
done
bomb "and in its memory" 20 300 4 'too expensive: it takes more than 5 MB' \
    run "$cases/dtrest.json" --max-memory 5 --max-seconds 100
bomb "a trajectory from far before" 9 300 4 'too expensive.*trajectories last 1e\+04 s' \
    run "$cases/traj2.json" --max-seconds 1
# a flat array of five million numbers in an x_ key
python3 -c 'import sys; t = open("pole.json").read().rstrip()[:-1]
sys.stdout.write(t + ", \"x_a\": [" + "0," * 5000000 + "0] }")' >array.json
bomb "ten megabytes in an x_ key" 9 300 4 'too expensive: more than 3 million values' run array.json
bomb "the same in a stack" 9 300 1 '"code":"too-expensive"' stack array.json
for i in 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14; do
    for k in 1 2 3 4 5 6 7 8; do
        echo "source s$((i + 1)).crumple"
    done >s$i.crumple
done
echo list >s15.crumple
bomb "fifteen files that source the next eight times" 9 300 4 'leads to more than 1000 files' \
    s0.crumple
{
    echo "load pole.json"
    python3 -c 'print("move A dx=0.001\nmove A dx=-0.001\n" * 10000)'
} >undo.crumple
bomb "20,000 moves to undo" 40 300 0 'A: ' undo.crumple
for option in --max-seconds=0 --max-memory=x --max-hours=1 --max-seconds; do
    bomb "commands with $option" 5 300 2 '--max-seconds=N' $option -e list
done
bomb "run with no time" 5 300 2 'max-seconds' run pole.json --max-seconds 0
finish
