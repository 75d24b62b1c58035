#!/bin/sh
# The full screen while it works: resize, ^Z, typing ahead, signals, a terminal that goes away.
. "$SRC/tests/tui/tui.sh"

rows() {
    text | grep -c ''
}
has_rows() {
    [ "$(rows)" -eq "$1" ] && text | tail -n 1 | grep -q "F1 help"
}
# ended PROCESS: also if nobody has asked for its status (a container whose first process does not)
ended() {
    ! kill -0 "$1" 2>/dev/null || grep -q '^State:.*Z' "/proc/$1/status"
}

# long on any machine: short slices of small voxels, and many more of them than the crash needs
long="set dt=0.001ms voxel=5mm elastic=100ms end=rest"

start_shell
until_ok on_screen "^shell>$"
keys "\"$CRUMPLE\"" Enter
until_ok on_screen "F1 help"
keys "load crash.json" Enter "$long" Enter F5
shows "a long solve" "SOLVING [0-9]+ %.*t [0-9.]+ ms"
screen resize-window -x 100 -y 30
until_ok has_rows 30
report $? "is drawn in a new size while it solves"
keys C-z
shows "^Z stops it" "^shell>$"
keys "stty -a" Enter
shows "with the line as a shell needs it" " icanon .* echo "
keys "fg" Enter
shows "fg goes on solving" "SOLVING [0-9]+ %"
keys "list"
keys C-c
shows "^C ends the solve" "INTERRUPTED"
shows "what was typed meanwhile is on the line" "^crumple> list$"
keys C-c "set dt=0.5ms voxel=25mm elastic=auto end=separation" Enter F5
shows "the crash is solved and played" \
    "SOLVED .* frame [1-9][0-9]?/|^crumple> show frame=[0-9]+$" # under way, or at its end
for size in "60 20" "200 50" "30 8" "80 24"; do
    # shellcheck disable=SC2086
    set -- $size
    screen resize-window -x "$1" -y "$2"
done
until_ok has_rows 24
report $? "resized four times while it plays"
shows "it plays on" "frame [1-9][0-9]+/"
keys C-c C-c "quit!" Enter
shows "and ends" "^shell>$"
same "with the terminal given back" \
    "$(screen display -p '#{alternate_on} #{mouse_any_flag} #{cursor_flag}')" "0 0 1"
screen kill-server

start 80 24
until_ok on_screen "F1 help"
keys "load crash.json" Enter "$long" Enter F5
shows "a long solve again" "SOLVING [0-9]+ %.*t [0-9.]+ ms"
kill -TERM "$(cat pid)"
shows "SIGTERM ends it while it solves" "^status 143"
given_back "SIGTERM while solving"

start 80 24
until_ok on_screen "F1 help"
keys "half a line"
until_ok on_screen "^crumple> half a line"
kill -INT "$(cat pid)"
shows "SIGINT is ^C: the line is given up" "^crumple>$"
if [ -w "/proc/$(cat pid)/fd/2" ]; then
    echo "a library complains" >"/proc/$(cat pid)/fd/2"
    keys "x"
    shows "standard error is a line of the dialogue" "^a library complains"
    keys C-c "view log" Enter
    shows "and not on the screen" "│ a library complains +│"
fi
rm -f state/crumple/autosave-* # of the session above: this test is not about which is newer
keys "vehicle A type=suv mass=2002kg" Enter
until_ok on_screen "A: suv"
pid=$(cat pid)
screen kill-server
until_ok ended "$pid"
report $? "it ends when the terminal goes away"
start 80 24
shows "and the next start has the scene" "load --recover"
keys "load --recover" Enter
shows "as it was" "2002 kg"
keys "quit!" Enter
shows "done" "^status 0"
finish
