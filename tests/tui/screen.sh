#!/bin/sh
# The full screen at 80x24, 100x30 and 200x50: solve, step, play, panes, resize, long answers.
. "$SRC/tests/tui/tui.sh"

start 80 24
shows "the first screen says how to begin" "Begin with: load"
keys "load crash.json" Enter
shows "the scene is drawn" "A  suv 2550 kg  56.0 km/h"
shows "the first contact is predicted" "First contact, predicted"
shows "with the overlap" "overlap +41 %"
keys "solve" Enter
shows "solve solves" "SOLVED  t [0-9.]+/[0-9.]+ ms  frame ([0-9]+)/\1 "
shows "EES of both beside the picture" "EES +[0-9.]+ +[0-9.]+ km/h"
shows "pulses as lines" "^A \|a\|.*peak [0-9.]+ g"
keys F7
shows "F7 is a command in the dialogue" "^crumple> show frame=-1$"
keys F7 F7
shows "which is counted, not repeated" "^crumple> show frame=-1   x 3"
keys "show frame=40" Enter
shows "the title tells the time" "frame 40/"
shows "and the results those of that instant" "force +[0-9]+ +[0-9]+ kN"
keys Right
shows "Right on an empty line is one slice on" "frame 41/"
keys Space
shows "Space plays" "frame ([5-9][0-9]|[1-9][0-9][0-9])/"
keys Space
shows "and pauses, by a command" "^crumple> show frame=([5-9][0-9]|[1-9][0-9][0-9])$"
keys "pulse B" Enter
shows "a pulse is drawn" "^┌ 1 Scene \[2 Pulse\]"
keys M-3
shows "Alt-3 is the energy" "energy, kJ"
keys M-4
shows "Alt-4 the table over the whole width" "type +suv +super-compact"
keys "show view=side" Enter
shows "the 3D model is an answer" "[█▓▒░]{12}"
shows "with its scale" " 1 m +EES 0"
keys "help place" Enter
shows "a long answer opens a sheet" "lines, PgUp PgDn; Esc closes"
shows "that begins with the question" "^crumple> help place"
keys Escape
gone "Esc closes it" "Esc closes"
keys "plaze A" Enter
shows "an error has its caret and the way out" "^         \^\^\^\^\^"
shows "in words" "Did you mean 'place'\?"
keys NPage PPage NPage
shows "which is seen as far as it goes" "Did you mean 'place'\?"
keys "place B fac" Tab "A ov" Tab
shows "Tab completes, the key bar explains" "overlap: lateral overlap"
keys C-c
shows "^C clears the line" "^crumple>$"
keys C-r "puls"
shows "^R searches the history" "reverse-i-search.*pulse B"
keys C-g C-c "vehicle Ärger mass=1" Left Left BSpace BSpace
shows "umlauts are edited whole" "^crumple> vehicle Ärger ma=1"
keys C-c F1
shows "F1 lists the keys" "Keys +\(any key closes\)"
keys x F9 swe
shows "F9 filters the commands" "sweep +solve for ranges of inputs"
keys Enter
shows "and types the chosen one" "^crumple> sweep"
keys C-c Tab Tab
shows "Tab Tab on an empty line is the palette too" "Commands +Enter chooses"
keys Escape
gone "Esc closes it" "Commands +Enter"
keys "lis"
shows "and the prompt has the keys" "^crumple> lis$"
keys C-c Tab
shows "one Tab goes to the pane" "^Up Down scroll"
keys C-c "view scene" Enter

screen resize-window -x 100 -y 30
shows "a larger window is used" "^F1 help.*F2 save"
same "every row of it" "$(text | grep -c '')" 30
screen resize-window -x 200 -y 50
shows "200x50 has all panes" "┌ Pulse .*┌ Energy "
shows "with the table" "delta-v"
screen resize-window -x 30 -y 8
shows "too small a window says what it needs" "80x24 shows the scene"
keys F1
shows "also for the keys" "40x12 shows this"
keys Escape
gone "Esc closes them" "40x12 shows this"
keys "list" Enter
shows "and still answers" "A: suv"
screen resize-window -x 80 -y 24
shows "and back" "SOLVED"
keys "show frame=3" Enter
shows "at a frame" "SOLVED .* frame 3/"
keys F5
shows "F5 solves and plays" "frame [1-9][0-9]/|^crumple> show frame=[1-9][0-9]+$"
keys C-c
# long on any machine: short slices of small voxels, and many more of them than the crash needs
keys "set dt=0.001ms voxel=5mm elastic=100ms end=rest" Enter "sweep A.speed 20:80:0.1" Enter
shows "long work shows its progress" "SWEEP [0-9]+ %  [0-9]+ of 601 runs"
shows "and the runs as they come" "[0-9]+ of 601 done, [1-9][0-9]* running"
keys C-c
shows "^C stops it" "interrupted"
keys "view scene" Enter F5
shows "a solve grows live" "SOLVING [0-9]+ %.*t [1-9][0-9.]* ms"
keys C-c
shows "^C keeps what was solved" "INTERRUPTED  t [0-9.]+/[0-9.]+ ms  frame ([1-9][0-9]*)/\1( |$)"
shows "and says so beside the picture" "stop: interrupted"
keys C-c "show frame=9" Enter
shows "its slices can be walked" "INTERRUPTED .*frame 9/"
keys "export report part.txt" Enter
shows "but are not written as a result by mistake" "the solve was interrupted"
keys C-c "set dt=0.5ms voxel=25mm elastic=auto end=separation" Enter F5
shows "solving begins anew" " SOLVED "
keys "quit!" Enter
shows "and it ends" "^status 0"

start 200 50
shows "200x50 from the start" "┌ Scene .*┌ Table "
# what the terminal answers to the question for its background (OSC 11) is no typing
answer() {
    screen send-keys -H 1b 5d 31 31 3b 72 67 62 3a $1 2f $1 2f $1 1b 5c
}
answer "66 66 66 66"
shows "a terminal that tells a light background has the light theme" "theme light"
answer "30 30 30 30"
shows "and one that tells a dark one the dark theme" "theme dark"
shows "nothing of it is typed" "^crumple>$"
keys "view theme=contrast" Enter
shows "a theme that was chosen stays" "theme contrast"
answer "66 66 66 66"
keys "load crash.json" Enter "solve" Enter
shows "solves" "SOLVED.*theme contrast"
keys "set rest"
shows "help for what is typed stands below it" "restitution"
keys C-c
is_full() {
    [ "$(text | grep -c .)" -ge 40 ]
}
until_ok is_full
report $? "the screen is full"

start 80 24 NO_COLOR=1 LC_ALL=C
shows "without colour and UTF-8" "^\+\[1 Scene\]"
keys "load crash.json" Enter "solve" Enter
shows "the scene in ASCII" "SOLVED"
same "no colours" "$(screen capture-pane -pe | grep -c '\[3[0-7]m\|38;5')" 0
same "no character above 126" "$(text | LC_ALL=C grep -c '[^ -~]')" 0

# a terminal that takes red, green and blue has the palette's colours all the same
if infocmp xterm-direct >/dev/null 2>&1; then
    start 80 24 TERM=xterm-direct
    until_ok on_screen "F1 help"
    keys "load crash.json" Enter
    coloured() {
        screen capture-pane -pe | grep -q '38;2;215;95;0mB  super-compact'
    }
    until_ok coloured
    report $? "colour 166 in red, green and blue"
fi
finish
