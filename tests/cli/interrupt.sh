#!/bin/sh
# ^C: status 130, no output file, no temporary file.
. "$SRC/tests/cli/cli.sh"
cd "$tmp" || exit 99
wall_scene >wall.json
# a caller may have had ^C ignored (nohup, a job in the background)
heard="env --default-signal=INT"
$heard true 2>/dev/null || heard=
if [ ! -r /proc/self/status ]; then
    echo "1..0 # SKIP no /proc here to tell when a program is ready for ^C"
    exit 0
fi
mkfifo pipe
exec 3<>pipe # to which nobody writes

# ready WHAT PROCESS: it is the program by now, and "catches" ^C, or "waits" for input
ready() {
    cmp -s "/proc/$2/exe" "$crumple" || return 1
    case $1 in
    catches) grep -q '^SigCgt:.*[2367abef]$' "/proc/$2/status" ;;
    waits) grep -q '^State:.*S' "/proc/$2/status" ;;
    esac
}

# stopped WHAT ARG ...: the program, with ^C a moment after it is ready for it
stopped() {
    what=$1
    shift
    rm -f pid
    {
        until [ -s pid ] && ready "$what" "$(cat pid)"; do
            sleep 0.05
        done
        sleep "$moment"
        kill -INT "$(cat pid)"
    } >/dev/null 2>&1 &
    $heard sh -c 'echo $$ >pid; exec "$@"' sh "$crumple" "$@" <pipe >out 2>errs
    status=$?
    kill $! 2>/dev/null
    rm -f pid
}
moment=0.5
before=$(ls)

# so many small slices that the signal arrives while it solves, on any machine
stopped catches run wall.json -o out.json --set voxel_mm=5 \
    --set dt_ms=0.001 --set elastic_ms=100 --set end=rest
same "^C while solving" "$status" 130
has "and says so" "$(cat errs)" 'interrupted'
rm -f out errs
same "nothing is left behind" "$(ls)" "$before"

# a script stops there, with what was solved told but not printed as a result
cat >slow.crumple <<'END'
vehicle A type=compact mass=1400kg speed=40km/h
object W kind=wall
place W facing A gap=0.01m
set dt=0.001ms voxel=5mm elastic=100ms end=rest
solve
table results
END
stopped catches slow.crumple
same "^C in a script" "$status" 130
has "where it was" "$(cat errs)" \
    'slow.crumple:5:1: error: interrupted (before|[0-9.]+ ms after the first contact)'
same "nothing after it runs" "$(grep -c 'EES' out)" 0

# a search keeps the best that it found by then
moment=3
stopped catches fit wall.json A.speed A.brake=0:0.8 to dv.A=50km/h ees.A=45km/h --starts 20 \
    --solves 100000
same "^C in a search" "$status" 130
has "tells the best so far" "$(cat out)" '^  A\.speed +[0-9.]+ km/h  95 %: [0-9.]+ to [0-9.]+'
has "as what it is" "$(cat out)" 'warning: interrupted; this is the best so far'
moment=0.5

stopped waits run -
same "^C while reading" "$status" 130
finish
