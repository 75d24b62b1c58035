#!/bin/sh
# The plain prompt on a terminal: tmux with a socket of its own types, and waits for what must
# appear. Nothing sleeps for a fixed time.
. "$SRC/tests/terminal.sh"

# start ARG ...: the program in a terminal of 80 x 24 (^C is for the program: dash
# would end with it)
start() {
    rm -f pid
    cat >start.sh <<END
cd '$tmp'
trap : INT
sh -c 'echo \$\$ >pid; exec "\$@"' sh env XDG_STATE_HOME='$tmp/state' INPUTRC=/dev/null \\
    LC_ALL=C.UTF-8 CRUMPLE_DATA='$SRC' '$CRUMPLE' $*
echo status \$?
exec sleep 300
END
    terminal 80 24 "sh '$tmp/start.sh'"
}

start --repl
shows "the prompt greets" "^crumple> *$"
keys "veh" Tab "A type=s" Tab Tab
shows "Tab completes a command and lists values" "^  station-wagon"
keys "uv mass=2000kg speed=50" Enter
shows "a command answers" "^  A: suv 2000 kg"
keys "place A ov" Tab Tab "=" C-a C-k "help rem" Enter
shows "a line can be edited away" "^  remove NAME"
keys "vehicle C car=volks" Tab "golf 2015" Tab
shows "Tab completes make, model and year of a car" \
    "^crumple> vehicle C car=\"volkswagen golf 2015\" *$"
keys C-a C-k "vehicle A masss=5" Enter
shows "the caret is below the word at fault" "^                   \^\^\^\^\^\^\^$"
shows "and the message names the way out" "Did you mean 'mass'\?"
keys "half a line"
shows "a line is typed" "^crumple> half a line$"
keys C-c
shows "^C gives the line up" "^crumple> half a line\^C"
keys "object wall kind=wall" Enter "place wall facing A" Enter
shows "the session goes on" "^  wall: fixed wall  x=2"
keys "set dt=0.001ms voxel=5mm" Enter "sweep A.speed 10:100:0.1" Enter
shows "long work shows its progress" "SWEEP \[[#.]*\] [0-9]+ of 901"
keys C-c
shows "^C stops long work" "interrupted after [0-9]+ of 901 runs"
keys "set elastic=100ms end=rest" Enter "solve" Enter
shows "a solve shows its progress" "SOLVING [0-9]+ % of the approach  t [0-9.]+ ms"
keys C-c
shows "^C keeps what was solved" "error: interrupted [0-9.]+ ms after the first contact"
keys "assert A.ees > 1km/h" Enter
shows "which is no result" "there are no final values"
keys "show frame=1" Enter
shows "but can be looked at" "frame 1 of [0-9]+, 0.0 ms after the first contact"
keys "vehicle A \\" Enter "speed=30" Enter "li" Enter
shows "a line can be continued" "30\.0 km/h"
keys "quit" Enter
shows "quit asks when changes are unsaved" "unsaved changes: \(s\)ave \(q\)uit \(c\)ancel"
keys "c" Enter
shows "and can be called off" "^  not quit"
kill -KILL "$(cat "$tmp/pid")"
shows "a session is killed" "status 137"

start --repl
shows "the next start says so" "load --recover"
keys "load --recover" Enter "list" Enter
shows "and has the scene" "^  A: suv 2000 kg .* 30\.0 km/h"
keys Up Up Up
shows "the history outlives the session" "^crumple> quit"
keys C-a C-k "save there.json" Enter
shows "the scene is saved" "there.json: 2 participants"
keys C-d
shows "^D ends" "status 0"
same "a session that ends in order leaves no autosave" \
    "$(ls "$tmp/state/crumple" | grep -c autosave)" 0
grep -q "^vehicle A    *speed=30$" "$tmp/state/crumple/history"
report $? "a continued line is one line of history"

start "-e 'load there.json' -i"
shows "-i stays after a script" "^crumple> *$"
keys "quit" Enter
shows "nothing unsaved, nothing asked" "status 0"
finish
