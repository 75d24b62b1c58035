# shellcheck shell=sh
# What the tests of the full screen share: the program in a terminal. Sourced.
. "$SRC/tests/terminal.sh"
cp "$SRC/share/scenes/q7-fiat500.json" crash.json
program="XDG_STATE_HOME='$tmp/state' HOME='$tmp' INPUTRC=/dev/null LC_ALL=C.UTF-8 \
    CRUMPLE_DATA='$SRC' ASAN_OPTIONS=abort_on_error=1"

# start WIDTH HEIGHT [SETTING=VALUE ...]: the program with $words, then its status and the
# terminal's modes
words=
start() {
    w=$1
    h=$2
    shift 2
    rm -f pid
    cat >start.sh <<END
cd '$tmp'
stty -a >before
sh -c 'echo \$\$ >pid; exec "\$@"' sh env TERM=screen-256color $program $* '$CRUMPLE' $words
echo status \$?
stty -a >after
cmp before after && echo modes kept
exec sleep 300
END
    terminal "$w" "$h" "sh '$tmp/start.sh'"
}

# a shell with job control, in which the program can be started by hand: ^Z and fg need one
start_shell() {
    cat >shell.sh <<END
cd '$tmp'
exec env TERM=screen-256color PS1='shell> ' $program sh -i
END
    terminal 80 24 "sh '$tmp/shell.sh'"
}

# given_back NAME: the terminal is as it was before the program ran
given_back() {
    shows "$1: the modes of the line are as before" "^modes kept"
    same "$1: main screen, no mouse, cursor" \
        "$(screen display -p '#{alternate_on} #{mouse_any_flag} #{cursor_flag}')" "0 0 1"
}
