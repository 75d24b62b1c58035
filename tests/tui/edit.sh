#!/bin/sh
# Editing by hand with keys and mouse: every one is a command, marked stale, undone and redone.
# shellcheck disable=SC2046
. "$SRC/tests/tui/tui.sh"

# mouse BUTTON COLUMN ROW ...: events, 0-based, that arrive together: nobody waits between a press
# and what follows
mouse() {
    events=
    while [ $# -ge 3 ]; do
        case $1 in # as a terminal tells them in figures: button 3 is the release of the first
        3) event="0;$(($2 + 1));$(($3 + 1))m" ;;
        *) event="$1;$(($2 + 1));$(($3 + 1))M" ;;
        esac
        events="$events 1b 5b 3c $(printf %s "$event" | od -An -v -tx1 | tr -d '\n')"
        shift 3
    done
    # shellcheck disable=SC2086
    screen send-keys -H $events
}
# the same of a terminal that knows the old form alone
old_mouse() {
    screen send-keys -H 1b 5b 4d "$(printf %x $(($1 + 32)))" "$(printf %x $(($2 + 33)))" \
        "$(printf %x $(($3 + 33)))"
}
click() {
    mouse 0 "$1" "$2" 3 "$1" "$2"
}
# column and row of the first "TEXT": two words
find() {
    text | sed 's/[^ -~]/?/g' |
        awk -v t="$1" '{ i = index($0, t); if (i) { print i - 1, NR - 1; exit } }'
}

start 80 24 TERM=screen-256color
until_ok on_screen "F1 help"
keys "load crash.json" Enter "solve" Enter
shows "a solved scene" "SOLVED"

keys F6 b
shows "a letter in the scene chooses" "^crumple> show select=B"
keys Up
shows "an arrow moves" "^crumple> move B dy=0.1m"
shows "the result is marked stale" "STALE"
keys r r r
shows "r turns, and repeats are counted" "^crumple> move B turn=1deg   x 3"
keys '>'
shows "> is faster" "^crumple> move B speed=1km/h"
keys u
shows "u takes it back" "undone: move B speed=1km/h"
keys u u u u
shows "to the solved scene" "SOLVED"
keys U
shows "U brings it again" "done again: move B dy=0.1m"
keys v
shows "v asks for the speed" "^crumple> vehicle B speed="
keys "60km/h" Enter
shows "which is typed" "B: super-compact.*60.0 km/h"
keys F5
shows "F5 solves" "SOLVED"
keys C-c "undo 2" Enter
shows "undo of two" "undone: vehicle B speed=60km/h"
shows "and the way back to what was solved" "redo 2: back to the result"
keys F5
shows "this scene anew" "SOLVED"
keys C-c

set -- $(find "2 Pulse")
click "$1" "$2"
shows "a click on a tab is a command" "^crumple> view pulse"
shows "and shows the pane" "\[2 Pulse\]"
click 20 10
shows "a click in a plot goes to that time" "^crumple> show frame=[0-9]+$"
set -- $(find "1 Scene")
click "$1" "$2"
shows "back to the scene" "\[1 Scene\]"
keys "show select=none" Enter
shows "typing goes on after a click" "show select=none"
set -- $(find " A? ")
click "$1" "$2"
shows "a click chooses" "^crumple> show select=A"
mouse 0 "$1" "$2" 32 "$(($1 - 1))" "$2" 32 "$(($1 - 4))" "$2" 3 "$(($1 - 4))" "$2"
shows "a drag moves" "^crumple> move A dx=-[0-9.]+m dy=0.00m"
shows "and makes the result stale" "STALE|EDITED"
mouse 64 20 10
shows "the wheel changes the scale" "^crumple> show scale=[0-9.]+m$"
scale=$(text | sed -n 's/^crumple> show scale=//p' | tail -n 1)
other_scale() {
    text | grep '^crumple> show scale=' | grep -vq "=$scale\$"
}
old_mouse 65 20 10
until_ok other_scale
report $? "also when it is told in the old way"
set -- $(find "  F5 solve") # of the bar, not of the pane with the prediction
click "$(($1 + 2))" "$2"
shows "a click in the key bar is the key" "SOLVED"

keys C-c
shows "^C goes back to the prompt" "^crumple>$"
keys "history 9" Enter
shows "all of it is in the history" "show select=A"
keys C-c "quit!" Enter
shows "and it ends" "^status 0"
given_back "after all that"
finish
