#!/bin/sh
# Every kind of refusal of the system in turn: memory, open, read, write, sync, rename. Either the
# program says so and fails, or what it writes is what it always writes. And kill -9 at each step of
# saving: a file is the old one or the new one, and nothing else is left beside it.
#
# FAULTS_STEP=1 tries every single call; as it comes every 23rd allocation is tried. FAULTS_ONLY is
# a pattern of the shell for what is tried, as "stack: memory", "import*" or "*: sync"; then the
# rest of this script is left out.
. "$SRC/tests/cli/cli.sh"
fault=$BUILD/fault.so
[ -e "$fault" ] || {
    echo "1..0 # SKIP no library to refuse calls was built here"
    exit 0
}
"$crumple" --version | grep -q 'sanitizers: no' || {
    echo "1..0 # SKIP a sanitizer has its own allocations"
    exit 0
}
LD_PRELOAD=$fault "$crumple" --version >/dev/null 2>&1 || {
    echo "1..0 # SKIP it cannot be preloaded"
    exit 0
}
LC_ALL=C # a locale that cannot be read for want of memory would change the characters
export LC_ALL
cd "$tmp" || exit 99
cp "$SRC/tests/cases/hostile/pole.json" . || exit 99
for name in other third; do
    sed "s/\"name\": \"pole\"/\"name\": \"$name\", \"pair\": \"p\"/" pole.json | tr -d '\n'
    echo
done >two.jsonl
cat >pair.csv <<'END'
id,type,mass_kg,face,field_length_m,pdof_deg,c1_m,c2_m,c3_m
A,sedan,1600,front,1.4,0,0.3,0.33,0.3
B,compact,1300,rear,1.2,,0.1,0.2,0.1
END
cat >all.crumple <<'END'
load pole.json
solve
show
table
move A dx=-0.1
undo
export! result out.json
save! out2.json
END
cat >sweep.crumple <<'END'
load pole.json
sweep A.speed 30:34:2km/h jobs=1 out=sweep.csv
END
sed 's/"type": "sedan"/"car": "volkswagen golf 2016 hatchback"/' pole.json >car.json
sed 's/"participants"/"x_expect": {"A": {"ees_kmh": 20}}, "participants"/' pole.json >own.json
step=${FAULTS_STEP:-23}
input=/dev/null # of the program

# all_at_once STEP OUT ARG ...: every STEP-th allocation, all in one run (FAULT_EACH of fault.c),
# which takes a fifth of the time; sets f_bad, f_n
all_at_once() {
    a_step=$1 a_out=$2
    shift 2
    [ "$a_out" = - ] || {
        rm -f "$a_out" # what is there now nobody would miss
        export FAULT_OUT="$a_out"
    }
    LD_PRELOAD=$fault FAULT_KIND=memory FAULT_EACH=$tmp FAULT_STEP=$a_step FAULT_COUNT=9 \
        "$crumple" "$@" 9>tell.out >all.out 2>errs2.out <$input
    a_status=$?
    unset FAULT_OUT
    [ "$a_out" = - ] || cp "$a_out" all.out
    f_bad=$(sed 's/[0-9]*$//' tell.out) f_calls=$(sed 's/.* //' tell.out)
    [ $a_status -eq "$f_wanted" ] && cmp -s all.out want.out ||
        f_bad="$f_bad: and the program itself ended in another way"
    f_n=$(((${f_calls:-0} + a_step - 1) / a_step))
}

# faults NAME KIND STEP OUT ARG ...: OUT is a file it writes, - for standard output
faults() {
    f_name=$1 f_kind=$2 f_step=$3 f_out=$4
    shift 4
    # shellcheck disable=SC2254 # it is a pattern
    case "$f_name: $f_kind" in ${FAULTS_ONLY:-*}) ;; *) return ;; esac
    rm -f "$f_out" f.part
    "$crumple" "$@" >want.out 2>/dev/null <$input
    f_wanted=$?
    [ $f_wanted -eq 0 ] || f_name="$f_name (fails by itself)"
    [ "$f_out" = - ] || cp "$f_out" want.out
    f_calls=$(LD_PRELOAD=$fault FAULT_KIND=$f_kind FAULT_COUNT=9 "$crumple" "$@" 9>&1 >/dev/null \
        2>&1 <$input)
    f_bad='' f_n=0 f_at=$((f_calls % f_step))
    [ "$f_step" -eq 1 ] && f_at=0
    case "$f_kind-$*" in
    memory-import*.zip) ;; # children would take away what is unpacked
    memory-*)
        all_at_once "$f_step" "$f_out" "$@"
        f_at=$f_calls
        ;;
    esac
    while [ "$f_at" -lt "$f_calls" ]; do
        [ "$f_out" = - ] || rm -f "$f_out"
        LD_PRELOAD=$fault FAULT_KIND=$f_kind FAULT_AT=$f_at timeout -s KILL 120 "$crumple" "$@" \
            >got.out 2>errs.out <$input
        f_status=$?
        [ "$f_out" = - ] || cp "$f_out" got.out 2>/dev/null
        if [ $f_status -ge 128 ] && [ $f_status -ne 130 ]; then
            f_bad="$f_bad $f_at:died($f_status)"
        elif [ $f_status -eq 0 ] && ! cmp -s got.out want.out; then
            f_bad="$f_bad $f_at:lost"
        elif [ $f_status -ne 0 ] && ! [ -s errs.out ] && ! grep -q '"error"' got.out; then
            f_bad="$f_bad $f_at:silent($f_status)"
        fi
        f_n=$((f_n + 1))
        f_at=$((f_at + f_step))
    done
    [ "$f_n" -gt 0 ] || f_bad="nothing was refused: $f_calls calls"
    empty "$f_name: $f_kind refused, $f_n of $f_calls" "$f_bad"
}

# some_memory N NAME OUT ARG ...: of a call that costs more every N times as many are tried, all of
# them with FAULTS_STEP=1
some_memory() {
    s_step=$((step == 1 ? 1 : step * $1)) s_name=$2 s_out=$3
    shift 3
    faults "$s_name" memory "$s_step" "$s_out" "$@"
}
"$crumple" stack -j1 two.jsonl >p.jsonl
some_memory 1 "merge with a summary" - merge --summary --group scene p.jsonl
"$crumple" merge -f csv p.jsonl >want.out
bad=''
for at in 0 1 2 3 4 5 6 7 8 9; do # among them those of the first line, which getline makes
    LD_PRELOAD=$fault FAULT_KIND=memory FAULT_AT=$at "$crumple" merge -f csv p.jsonl >got.out \
        2>errs.out && ! cmp -s got.out want.out && bad="$bad $at:lost"
done
empty "merge: a line that there is no memory for" "$bad"
import=$SRC/tests/data/import
some_memory 1 run - run pole.json
some_memory 13 "run with trace" - run pole.json --trace
some_memory 3 "run as text" - run pole.json --format text
some_memory 3 "run as CSV" - run pole.json --format csv
some_memory 5 stack - stack -j1 two.jsonl
some_memory 7 commands - all.crumple
input=all.crumple
some_memory 13 "commands by a pipe" out.json -
input=/dev/null
some_memory 31 sweep sweep.csv sweep.crumple
some_memory 31 validate - validate --fast own.json
some_memory 31 "a car by its name" - run car.json
some_memory 31 "text in US units" - run --units us -f text pole.json
some_memory 31 "picture in US units" us.svg run --units us pole.json --picture us.svg
some_memory 61 report r.html report --no-tests --draws 0 -q -o r.html own.json
some_memory 31 "models by text" - models
some_memory 3 picture pole.svg run pole.json --picture pole.svg
some_memory 11 mc - mc pole.json -n 10 -j3 -q --set A.speed_kmh=32+-3
some_memory 7 damage - damage -f json pair.csv
some_memory 31 "import of a table" - import "$import/long.csv"
some_memory 31 "import of XML" - import "$import/minimal.xosc"
some_memory 31 "import of a database" - import "$import/pcm5.db"
some_memory 31 "import of a ZIP file" - import "$import/wall.zip"
some_memory 31 "import of a folder" - import "$import/pcm5"
some_memory 31 "import of records" - import "$import/two.erg"
for kind in open read write; do
    faults run $kind 1 - run pole.json
    faults stack $kind 1 - stack -j1 two.jsonl
    faults commands $kind 1 out.json all.crumple
    faults damage $kind 1 - damage -f json pair.csv
    faults "import of a ZIP file" $kind 1 - import "$import/wall.zip"
done
for kind in open write sync link rename; do
    : >o.json
    faults "run -o" $kind 1 o.json run pole.json -o o.json
done
for kind in open write sync rename; do
    faults "stack -o" $kind 1 o.jsonl stack -j1 two.jsonl -o o.jsonl
done

[ -z "$FAULTS_ONLY" ] || {
    finish
    exit
}

# ---- kill -9 at each step of saving ----
cat >save.crumple <<'END'
load pole.json
move A dx=-0.1
save! saved.json
export! scene exported.json
END
"$crumple" save.crumple >/dev/null && cp saved.json new.json
bad=''
for kind in open write sync link rename; do
    n=0
    while [ $n -lt 30 ]; do
        cp pole.json saved.json && cp pole.json exported.json && before=$(ls)
        LD_PRELOAD=$fault FAULT_KIND=$kind FAULT_AT=$n FAULT_KILL=1 "$crumple" save.crumple \
            >/dev/null 2>&1
        status=$?
        for file in saved.json exported.json; do
            cmp -s $file pole.json || cmp -s $file new.json || bad="$bad $kind/$n:$file"
        done
        # over a file that is there a rename goes, from a name it has for that moment
        [ "$(ls)" = "$before" ] || [ $kind = rename ] || bad="$bad $kind/$n:$(ls | grep '\.json\.')"
        rm -f ./*.json.*
        [ $status -eq 137 ] || break
        n=$((n + 1))
    done
done
empty "killed while saving: the old file or the new one, and no other" "$bad"
rm -f saved.json
LD_PRELOAD=$fault FAULT_KIND=sync FAULT_AT=0 FAULT_KILL=1 "$crumple" save.crumple >/dev/null 2>&1
same "a file that was never there before" "$(ls saved.json* 2>/dev/null)" ""

# ---- a link that somebody else has put there ----
echo precious >precious
ln -s precious o2.jsonl.part
run stack -j1 two.jsonl -o o2.jsonl
same "a link in place of FILE.part is not written through" "$status:$(cat precious)" 0:precious
echo old >target.jsonl && chmod 600 target.jsonl && ln -s target.jsonl link.jsonl
run stack -j1 two.jsonl -o link.jsonl
same "stack -o over a link" "$status" 0
same "keeps the link, and the mode of what it leads to" \
    "$([ -L link.jsonl ] && stat -c %a target.jsonl)" 600
has "and writes there" "$(head -c 20 target.jsonl)" crumple_result

# ---- --resume and results that broke off anywhere ----
"$crumple" stack -j1 two.jsonl >whole.jsonl
size=$(wc -c <whole.jsonl) bad='' cut=0
first=$(head -n 1 whole.jsonl | wc -c)
while [ $cut -le "$size" ]; do
    head -c $cut whole.jsonl >cut.jsonl
    "$crumple" stack -j1 two.jsonl --resume cut.jsonl >got.out 2>errs.out
    status=$?
    { [ $status -eq 0 ] && cmp -s got.out whole.jsonl; } || bad="$bad $cut:$status"
    cut=$((cut + 997))
done
empty "resumed from results cut anywhere" "$bad"
{
    head -c $((first / 2)) whole.jsonl
    cat whole.jsonl
} >torn.jsonl
refused "a line that begins in the middle of another" 3 'torn.jsonl:1:1: error: this is no result' \
    stack -j1 two.jsonl --resume torn.jsonl
finish
