#!/bin/sh
# Random crashes: balances close, numbers are finite, and a stack with one thread, with two and run
# agree. tests/bench/random.py tries as many as one has time for.
. "$SRC/tests/cli/cli.sh"
python3 -c '' 2>/dev/null || {
    echo "1..0 # SKIP no python3"
    exit 0
}
python3 -B "$SRC/tests/bench/random.py" "$crumple" 0 40 >"$tmp/told" 2>&1
same "40 random scenes, their mirror images and those in the opposite order" "$?" 0
[ -s "$tmp/told" ] && explain <"$tmp/told"
has "were solved" "$(tail -n 1 "$tmp/told")" '"solved": [1-9][0-9]'
# a car that only turns: its momentum begins at zero, and what it gets is the measure
python3 -B "$SRC/tests/bench/random.py" "$crumple" 5076 1 >"$tmp/told" 2>&1
same "a car without speed that turns into a wall" "$?" 0
finish
