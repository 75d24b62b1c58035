#!/bin/sh
# Plays the blocks of tests/golden/cmd/*.test as command files and compares what they print.
#
# A block begins with "# name"; lines "| text" are the script (read as standard input); other lines
# are the expected output, standard error included. "~text" skips to the next line that reads so,
# where @ is any number and blanks do not count; anything else must be the very next line, until the
# first ~. "= N" is the exit status and ends the block. Numbers that come out of the models are
# matched by @: a better model does not break a test of the language.
. "$SRC/tests/tap.sh"
folder=$SRC/tests/golden/cmd
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
unset COLUMNS XDG_STATE_HOME
cp "$folder"/*.csv "$folder"/*.json "$folder"/*.crumple "$tmp" || exit 99
mkdir "$tmp/sub" || exit 99
cd "$tmp" || exit 99

# split FILE: n.in, n.want, n.name, n.status for each block
split() {
    awk '
        /^# / {
            n++
            print substr($0, 3) > (n ".name")
            printf "" > (n ".in")
            printf "" > (n ".want")
            next
        }
        /^= / { print $2 > (n ".status"); next }
        /^\|/ { print substr($0, 3) > (n ".in"); next }
        n > 0 && !/^$/ { print > (n ".want") }
        END { print n }' "$1"
}

# matches GOT WANT: prints the first line of WANT that is not met
matches() {
    awk -v want="$2" '
        function pattern(text) {
            gsub(/[][\\.^$*+?(){}|]/, "\\\\&", text)
            gsub(/ +/, " +", text)
            gsub(/@/, "[-+]?[0-9]+([.][0-9]+)?(e[-+]?[0-9]+)?", text)
            gsub(/ \+\[/, " *[", text)
            return "^" text " *$"
        }
        BEGIN { while ((getline line < want) > 0) w[++m] = line }
        !/^ *$/ { got[++g] = $0 }
        END {
            j = 1
            for (k = 1; k <= m; k++) {
                if (substr(w[k], 1, 1) == "~") {
                    re = pattern(substr(w[k], 2))
                    loose = 1
                    while (j <= g && got[j] !~ re) j++
                    if (j > g) { print "missing: " w[k]; exit }
                    j++
                } else if (j > g || got[j] != w[k]) {
                    print "want: " w[k]; print "got:  " (j <= g ? got[j] : "(end)"); exit
                } else j++
            }
            if (!loose && j <= g) print "more: " got[j]
        }' "$1"
}

for file in "$folder"/*.test; do
    blocks=$(split "$file")
    i=1
    while [ "$i" -le "$blocks" ]; do
        rm -f mine.* empty.json sub/*
        "$CRUMPLE" <"$i.in" >"$i.got" 2>&1
        status=$?
        verdict=$(matches "$i.got" "$i.want")
        want=$(cat "$i.status")
        [ "$status" -eq "$want" ] || verdict="$verdict
status $status, want $want"
        empty "$(basename "$file" .test): $(cat "$i.name")" "$verdict"
        rm -f "$i.in" "$i.want" "$i.name" "$i.status" "$i.got"
        i=$((i + 1))
    done
done
finish
