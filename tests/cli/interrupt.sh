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

# a writer that never writes
sleep 3 >pipe &
timeout --foreground --preserve-status -s INT 0.3 "$crumple" run - <pipe >/dev/null 2>&1
same "^C while reading" "$?" 130
kill $! 2>/dev/null
finish
