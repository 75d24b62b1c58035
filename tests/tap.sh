# shellcheck shell=sh
# TAP for shell tests: sourced. A test says what it checks and the evidence when it fails.
exec </dev/null # whatever the caller's is: a terminal, closed
tap_n=0
tap_bad=0

# report STATUS NAME: one line of TAP
report() {
    tap_n=$((tap_n + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $tap_n - $2"
    else
        echo "not ok $tap_n - $2"
        tap_bad=1
    fi
}

# explain: standard input, its first lines, as TAP comments
explain() {
    head -n 60 | cut -c 1-200 | sed 's/^/# /'
}

# empty NAME TEXT: passes if the text is empty, else shows it
empty() {
    [ -z "$2" ]
    report $? "$1"
    [ -z "$2" ] || printf '%s\n' "$2" | explain
}

# same NAME GOT WANT
same() {
    [ "$2" = "$3" ]
    report $? "$1"
    [ "$2" = "$3" ] || printf 'got:  %s\nwant: %s\n' "$2" "$3" | explain
}

# has NAME TEXT PATTERN: TEXT contains the extended regular expression
has() {
    printf '%s\n' "$2" | grep -Eq -e "$3"
    tap_has=$?
    report $tap_has "$1"
    [ $tap_has -eq 0 ] || printf 'no match for: %s\nin: %s\n' "$3" "$2" | explain
}

# skip NAME REASON
skip() {
    tap_n=$((tap_n + 1))
    echo "ok $tap_n - $1 # SKIP $2"
}

# need_terminals: ends the test as skipped where tmux cannot open a terminal (not installed, or no
# pseudo-terminals: a container without devpts)
need_terminals() {
    if ! command -v tmux >/dev/null 2>&1; then
        echo "1..0 # SKIP tmux is not installed"
        exit 0
    fi
    if ! tap_why=$(tmux -L "cr-probe-$$" -f /dev/null new-session -d "exec sleep 9" 2>&1); then
        echo "1..0 # SKIP no pseudo-terminal here (is /dev/pts mounted?): $tap_why"
        exit 0
    fi
    tmux -L "cr-probe-$$" kill-server
}

# need_jsonschema: the test is left out where schemas cannot be tested
need_jsonschema() {
    python3 -c 'import jsonschema; jsonschema.Draft202012Validator' 2>/dev/null || {
        echo "1..0 # SKIP no python3 with jsonschema for drafts of 2020-12"
        exit 0
    }
}

# finish: the plan; last line of each test
finish() {
    echo "1..$tap_n"
    exit $tap_bad
}
