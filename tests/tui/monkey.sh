#!/bin/sh
# A monkey at the full screen, and every kind of end: tests/tui/monkey.py. CR_MONKEY_SECONDS=60 is a
# minute of it, CR_MONKEY_SEED=N the rounds of a seed that was told.
. "$SRC/tests/cli/cli.sh"
python3 -c 'import pty, fcntl, termios, os; os.waitstatus_to_exitcode' 2>/dev/null || {
    echo "1..0 # SKIP no python3 (3.9) with terminals here"
    exit 0
}
ulimit -c 0
cd "$tmp" || exit 99
cp "$SRC/tests/cases/hostile/pole.json" . && cp "$demo" crash.json || exit 99
CRUMPLE_DATA=$SRC LC_ALL=C.UTF-8 ASAN_OPTIONS=abort_on_error=1
export CRUMPLE_DATA LC_ALL ASAN_OPTIONS
unset NO_COLOR COLUMNS LINES ESCDELAY
# shellcheck disable=SC2086
python3 -B "$SRC/tests/tui/monkey.py" "$crumple" "${CR_MONKEY_SECONDS:-6}" $CR_MONKEY_SEED \
    >told 2>&1
same "whatever is typed, and however it ends, the terminal is whole" "$?" 0
explain <told
has "a good many things were done" "$(tail -n 1 told)" 'rounds from seed [0-9]+, [0-9]{2,} acts'

# what one session leaves behind, another takes over and is killed at each step of it: the scene is
# still there to be recovered
fault=$BUILD/fault.so
if [ -e "$fault" ] && "$crumple" --version | grep -q 'sanitizers: no' &&
    LD_PRELOAD=$fault "$crumple" --version >/dev/null 2>&1; then
    XDG_STATE_HOME=$tmp/left HOME=$tmp python3 -B "$SRC/tests/tui/monkey.py" --recover "$crumple" \
        "$fault" >told 2>&1
    same "killed at each step of load --recover, nothing is lost" "$?" 0
    explain <told
else
    skip "killed at each step of load --recover" "no library to kill it was built here"
fi
finish
