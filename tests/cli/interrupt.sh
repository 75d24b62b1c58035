#!/bin/sh
# ^C: status 130, no output file, no temporary file.
. "$SRC/tests/cli/cli.sh"
cd "$tmp" || exit 99
wall_scene >wall.json
command -v timeout >/dev/null 2>&1 || {
    echo "1..0 # SKIP no timeout here"
    exit 0
}
mkfifo pipe
before=$(ls)

# slow enough that the signal arrives while it solves
timeout --foreground --preserve-status -s INT 1 \
    "$crumple" run wall.json -o out.json --set voxel_mm=5 \
    --set dt_ms=0.001 --set elastic_ms=100 --set end=rest >out 2>errs
same "^C while solving" "$?" 130
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
timeout --foreground --preserve-status -s INT 1 "$crumple" slow.crumple >out 2>errs
same "^C in a script" "$?" 130
has "where it was" "$(cat errs)" \
    'slow.crumple:5:1: error: interrupted (before|[0-9.]+ ms after the first contact)'
same "nothing after it runs" "$(grep -c 'EES' out)" 0
rm -f out errs slow.crumple

# a writer that never writes
sleep 3 >pipe &
timeout --foreground --preserve-status -s INT 0.3 "$crumple" run - <pipe >/dev/null 2>&1
same "^C while reading" "$?" 130
kill $! 2>/dev/null
finish
