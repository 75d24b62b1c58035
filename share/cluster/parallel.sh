#!/bin/sh
# A stack over several machines, or processes of one, with GNU parallel:
#
#   SHARDS=16 sh parallel.sh OUT scenes/ more.jsonl
#   SHARDS=64 PARALLEL='--sshlogin node1,node2 --workdir .' sh parallel.sh OUT scenes/
#
# The machines must see the same folder and have crumple. OUT.log says what is through: started
# again, only the shards that are missing are run, and those that were stopped go on where they
# were. At the end all parts are merged into OUT.
# CRUMPLE_OPTIONS is handed to crumple stack, for example CRUMPLE_OPTIONS="--set restitution=0.1".
set -u
out=${1:?name of the output}
shift
[ $# -gt 0 ] || {
    echo "parallel.sh: scenes are wanted: files or folders" >&2
    exit 2
}
shards=${SHARDS:-$(nproc)}
crumple=${CRUMPLE:-crumple}

# a scene that fails is told in its record (status 1) and stops nothing
shard='out=$1 i=$2 n=$3 crumple=$4; shift 4; resume=
[ ! -e "$out.$i.part" ] || resume=--resume=$out.$i
"$crumple" stack --jobs=1 --shard=$i/$n --output="$out.$i" $resume $CRUMPLE_OPTIONS "$@"
[ $? -le 1 ]'
export CRUMPLE_OPTIONS="${CRUMPLE_OPTIONS:-}"
seq "$shards" | parallel --quote --env CRUMPLE_OPTIONS --resume-failed --joblog "$out.log" \
    --halt soon,fail=50% sh -c "$shard" sh "$out" {} "$shards" "$crumple" "$@" || {
    echo "parallel.sh: not all shards are through; the same command goes on with them" >&2
    exit 1
}
set --
for i in $(seq "$shards"); do
    set -- "$@" "$out.$i"
done
"$crumple" merge "$@" -o "$out"
status=$?
[ $status -le 1 ] && rm -f "$@" "$out.log"
exit $status
