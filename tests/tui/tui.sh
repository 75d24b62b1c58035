# shellcheck shell=sh
# What the tests of the full screen share: the program in a terminal of tmux, on a socket of its
# own. Sourced; nothing sleeps for a fixed time.
. "$SRC/tests/tap.sh"
tmp=$(mktemp -d) || exit 99
sessions=0
patience=200 # polls; after a failure what follows is likely to fail too
screen() {
    tmux -L "cr-tui-$$-$sessions" -f /dev/null "$@"
}
trap 'screen kill-server 2>/dev/null; rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
need_terminals
cd "$tmp" || exit 99
cp "$SRC/share/scenes/q7-fiat500.json" crash.json

# start WIDTH HEIGHT [SETTING=VALUE ...]: the program, then its status and the terminal's modes
start() {
    screen kill-server 2>/dev/null
    sessions=$((sessions + 1)) # a server of its own: the old one takes a while to go
    w=$1
    h=$2
    shift 2
    cat >"$tmp/start.sh" <<END
cd $tmp
stty -a >before
sh -c 'echo \$\$ >pid; exec env -u NO_COLOR ASAN_OPTIONS=abort_on_error=1 \\
    TERM=screen-256color XDG_STATE_HOME=$tmp/state \\
    HOME=$tmp INPUTRC=/dev/null LC_ALL=C.UTF-8 CRUMPLE_DATA=$SRC $* $CRUMPLE'
echo status \$?
stty -a >after
cmp before after && echo modes kept
exec sleep 60
END
    screen new-session -d -x "$w" -y "$h" "sh $tmp/start.sh"
}

# a shell with job control, in which the program can be started by hand: ^Z and fg need one
start_shell() {
    screen kill-server 2>/dev/null
    sessions=$((sessions + 1))
    cat >"$tmp/shell.sh" <<END
cd $tmp
export TERM=screen-256color XDG_STATE_HOME=$tmp/state HOME=$tmp INPUTRC=/dev/null LC_ALL=C.UTF-8 \\
    CRUMPLE_DATA=$SRC PS1='shell> ' ENV= ASAN_OPTIONS=abort_on_error=1
unset NO_COLOR
exec sh -i
END
    screen new-session -d -x 80 -y 24 "sh $tmp/shell.sh"
}

keys() {
    screen send-keys "$@"
}

text() {
    screen capture-pane -p 2>/dev/null
}

# until COMMAND ...: waits until it succeeds, at most 10 s
until_ok() {
    tries=0
    until "$@"; do
        tries=$((tries + 1))
        [ "$tries" -lt "$patience" ] || { patience=20; return 1; }
        sleep 0.05
    done
}

on_screen() {
    text | grep -Eq -e "$1"
}

# shows NAME TEXT: waits until the extended regular expression is on the screen
shows() {
    if until_ok on_screen "$2"; then
        report 0 "$1"
    else
        report 1 "$1"
        text | explain
    fi
}

not_on_screen() {
    ! on_screen "$1"
}

# gone NAME TEXT: waits until it is no longer there
gone() {
    until_ok not_on_screen "$2"
    report $? "$1"
}

# given_back NAME: the terminal is as it was before the program ran
given_back() {
    shows "$1: the modes of the line are as before" "^modes kept"
    same "$1: main screen, no mouse, cursor" \
        "$(screen display -p '#{alternate_on} #{mouse_any_flag} #{cursor_flag}')" "0 0 1"
}
