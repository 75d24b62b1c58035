# shellcheck shell=sh
# A terminal of tmux for tests of what is typed and shown. Sourced. Nothing sleeps for a fixed time:
# a test types only when the screen has shown that it is time, and waits for what must appear.
. "$SRC/tests/tap.sh"
tmp=$(mktemp -d) || exit 99
sessions=0
patience=600 # polls, half a minute and more; after a failure what follows is likely to fail too
# nothing of the caller's terminal or shell (fish, nologin) is that of the panes
SHELL=/bin/sh
export SHELL
unset TMUX TMUX_TMPDIR NO_COLOR COLORFGBG COLUMNS LINES ESCDELAY ENV
# sockets go with the folder; the path of one is at most 107 bytes long
[ "${#tmp}" -gt 60 ] || export TMUX_TMPDIR="$tmp"
screen() {
    tmux -L "cr-$$-$sessions" -f /dev/null "$@"
}
trap 'screen kill-server 2>/dev/null; rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
need_terminals
ulimit -c 0
cd "$tmp" || exit 99

# terminal WIDTH HEIGHT COMMAND: a new one, on a server of its own: the old one takes a while to go
terminal() {
    screen kill-server 2>/dev/null
    sessions=$((sessions + 1))
    screen new-session -d -x "$1" -y "$2" "$3"
}

keys() {
    screen send-keys "$@"
}

text() {
    screen capture-pane -p 2>/dev/null
}

# until_ok COMMAND ...: waits until it succeeds
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
    text >there && ! grep -Eq -e "$1" there
}

# gone NAME TEXT: waits until it is no longer there
gone() {
    until_ok not_on_screen "$2"
    report $? "$1"
}
