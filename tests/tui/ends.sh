#!/bin/sh
# Whatever ends the full screen, the terminal is given back whole.
. "$SRC/tests/tui/tui.sh"

ready="F1 help"

start 80 24
shows "the screen is there" "$ready"
same "with the alternate screen and the mouse" \
    "$(screen display -p '#{alternate_on} #{mouse_any_flag}')" "1 1"
keys F10
shows "F10 quits" "^status 0"
given_back "F10"

start 80 24
shows "again" "$ready"
keys "vehicle A type=suv" Enter
shows "a change" "A: suv"
keys C-d
shows "^D asks for unsaved changes" "\(s\)ave \(q\)uit \(c\)ancel"
keys c
shows "c goes on" "not quit"
keys C-d
shows "again" "\(s\)ave \(q\)uit"
keys q
shows "q quits" "^status 0"
given_back "^D"

# ended SIGNAL STATUS: by a signal from outside, with an unsaved scene
ended() {
    start 80 24
    until_ok on_screen "$ready"
    keys "vehicle A type=suv mass=2001kg" Enter
    until_ok on_screen "A: suv"
    kill -"$1" "$(cat pid)"
    shows "$1 ends with its own status" "^status $2"
    given_back "$1"
}
ended TERM 143
ended HUP 129
ended SEGV "(139|134)" # AddressSanitizer ends its report with SIGABRT
shows "a fault says where the scene is" "load --recover"
ended ABRT 134

start 80 24
shows "the next start offers the scene" "load --recover"
keys "load --recover" Enter
shows "and has it" "2001 kg"
keys "quit!" Enter
shows "quit! does not ask" "^status 0"

# ^Z and fg
start_shell
shows "a shell" "^shell>$"
keys "\"$CRUMPLE\"" Enter
shows "the screen from a shell" "$ready"
keys "load crash.json" Enter
shows "a scene is loaded" "crash.json  UNSOLVED"
keys C-z
shows "^Z goes back to the shell" "^shell>$"
same "with the terminal as a shell needs it" \
    "$(screen display -p '#{alternate_on} #{mouse_any_flag} #{cursor_flag}')" "0 0 1"
keys "echo a line" Enter
shows "which works" "^a line"
screen resize-window -x 100 -y 30
keys fg Enter
shows "fg brings the screen back" "crash.json  UNSOLVED"
shows "in the new size" "^F1 help.*F10 quit"
same "with the mouse" "$(screen display -p '#{alternate_on} #{mouse_any_flag}')" "1 1"
keys F10
shows "and it quits as ever" "^shell>$"

start 80 24 TERM=dumb
shows "on a dumb terminal a word and the plain prompt" "no full screen \(TERM is not set, or dumb\)"
shows "which works" "^crumple>"
keys "quit" Enter
shows "and ends" "^status 0"
finish
