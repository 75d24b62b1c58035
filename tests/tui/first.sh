#!/bin/sh
# What somebody does first: opens a scene, tries a lesson, pastes lines from a page.
. "$SRC/tests/tui/tui.sh"

words=crash.json
start 80 24
shows "a scene alone opens on the screen" "^ crumple  crash.json  UNSOLVED"
shows "and is predicted" "First contact, predicted"
keys "vehicle A speed=62" Enter
shows "a change is told" "crash.json\*  EDITED"
keys F2
shows "F2 saves where it came from" "crash.json  UNSOLVED"
keys "vehicle A speed=63" Enter
shows "a second change is told" "crash.json\*  EDITED"
keys F2
shows "and saved again" "  crash.json: 2 participants"
gone "nothing is left to be saved" "crash.json\*"
same "the file has it" "$(grep -c '"speed_kmh":[[:space:]]*63' crash.json)" 1
keys "solve" Enter
shows "solved" " SOLVED "
keys "vehicle A speed=64" Enter
shows "changed after the solve" " STALE "
gone "no values of another solve beside it" "EES +[0-9.]+ +[0-9.]+ km/h"
shows "but the way back" "undo 1: back to the result"
keys "undo" Enter
shows "which leads there" "EES +[0-9.]+ +[0-9.]+ km/h"
keys "show frame=0" Enter "solve --step" Enter
shows "a step has its sheet" "lines, PgUp PgDn; Esc closes"
shows "from its first line" "time slice 1 of"
keys NPage NPage NPage
shows "to its last" "heading [-0-9.]+ deg"
keys Escape
gone "Esc closes it" "Esc closes"
keys "solve; explain peak" Enter
shows "also when a solve stands before it" "time slice [0-9]+ of"
shows "as a sheet" "lines, PgUp PgDn; Esc closes"
keys Escape
gone "which goes" "Esc closes"
keys "vehicle new" Enter
shows "what to type is told as it is typed" "needs a type. type=sedan"
keys C-c "quit!" Enter
shows "and it ends" "^status 0"

words="-e 'load crash.json' -e solve -i"
start 80 24
shows "-e and -i lead to the full screen" " SOLVED "
keys "quit!" Enter
shows "and back" "^status 0"
words=none.json
start 80 24
shows "a scene that is not there is an error" "none.json: error"
shows "with its status" "^status 2"

# every word of a lesson is seen at 80x24, with the picture above it
words=
lesson=$SRC/share/tutorial/1-first-crash.crumple
start 80 24
until_ok on_screen "F1 help"
keys "source share/tutorial/1-first-crash.crumple" Enter
shows "a lesson waits" "^Enter (goes|reads) on"
shows "the key bar says so" "^Enter go on  \^C end here"
shows "its words are in view" "^Lesson 1: the first crash"
keys "list" F5
text >screens
steps=0
while [ "$steps" -lt 60 ] && text | grep -q "^Enter "; do
    text | md5sum >was
    keys Enter
    changed() {
        ! text | md5sum | cmp -s - was
    }
    until_ok changed
    text >>screens
    steps=$((steps + 1))
done
missing=$(sed -n '2,$s/^# *\(..*\)/\1/p' "$lesson" | while read -r line; do
    grep -qF -e "$line" screens || echo "$line"
done)
empty "every line of it was seen" "$missing"
same "keys that edit did nothing meanwhile" "$(grep -c '^crumple> list' screens)" 0
same "the scene was above the words" "$(grep -c '^┌.1 Scene\|^┌ 1 Scene' screens)" \
    "$(grep -c '^ crumple ' screens)"
shows "the prompt is back" "^crumple>$"
keys "source share/tutorial/4-pole.crumple" Enter
shows "another lesson" "^Lesson 4"
keys C-c
shows "^C ends it" "given up at this pause"
keys C-c "quit!" Enter
shows "and the program" "^status 0"
finish
