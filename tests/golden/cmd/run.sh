#!/bin/sh
# Plays the blocks of tests/golden/cmd/*.test as command files and compares what they print.
#
# A block begins with "# name"; lines "| text" are the script (read as standard input); other lines
# are the expected output, standard error included. "~text" skips to the next line that reads so,
# where @ is any number and blanks do not count; anything else must be the very next line, until the
# first ~. "= N" is the exit status and ends the block. Numbers that come out of the models are
# matched by @: a better model does not break a test of the language.
# With the word "update" what no longer matches is written anew (make update-golden).
. "$SRC/tests/tap.sh"
verb=$1
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

# awk: the regular expression that an expected line stands for
pattern='
function pattern(text) {
    gsub(/[][\\.^$*+?(){}|]/, "\\\\&", text)
    gsub(/ +/, " +", text)
    gsub(/@/, "[-+]?[0-9]+([.][0-9]+)?(e[-+]?[0-9]+)?", text)
    gsub(/ \+\[/, " *[", text)
    return "^" text " *$"
}'

# matches GOT WANT: prints the first line of WANT that is not met
matches() {
    awk -v want="$2" '
        '"$pattern"'
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

# renewed GOT WANT: WANT with what GOT no longer says taken from GOT. Of a block with ~ each line
# that is not met becomes the line that shares the most words with it, numbers as @ where it had
# one, or goes when there is none.
renewed() {
    awk -v want="$2" '
        '"$pattern"'
        function words(text, set, list, m, k) {
            split("", set)
            m = split(text, list, /[^A-Za-z]+/)
            for (k = 1; k <= m; k++) set[list[k]] = list[k] != ""
            return m
        }
        function nearest(text, from, own, other, k, word, shared, most, best) {
            words(text, own)
            for (k = from; k <= g; k++) {
                words(got[k], other)
                shared = 0
                for (word in own) shared += own[word] && other[word]
                if (shared > most) { most = shared; best = k }
            }
            return best
        }
        function loosened(text, place, out) {
            gsub(/ +/, " ", text)
            if (match(text, /^stdin:[0-9]+:[0-9]+:/)) {
                place = substr(text, 1, RLENGTH)
                text = substr(text, RLENGTH + 1)
            }
            while (match(text, /[A-Za-z0-9]*[-+]?[0-9]+([.][0-9]+)?(e[-+]?[0-9]+)?/)) {
                word = substr(text, RSTART, RLENGTH)
                out = out substr(text, 1, RSTART - 1) (word ~ /^[A-Za-z]/ ? word : "@")
                text = substr(text, RSTART + RLENGTH)
            }
            return place out text
        }
        BEGIN {
            while ((getline line < want) > 0) {
                w[++m] = line
                loose = loose || substr(line, 1, 1) == "~"
            }
        }
        !/^ *$/ { got[++g] = $0 }
        END {
            j = 1
            for (k = 1; k <= g && !loose; k++) print got[k]
            for (k = 1; k <= m && loose; k++) {
                text = substr(w[k], 2)
                re = substr(w[k], 1, 1) == "~" ? pattern(text) : pattern(w[k])
                for (at = j; at <= g && got[at] !~ re; at++) continue
                if (at <= g) {
                    print w[k]
                } else if ((at = nearest(text, j)) > 0) {
                    found = text ~ /@/ ? loosened(got[at]) : got[at]
                    sub(/^ +/, " ", found)
                    sub(/ +$/, "", found)
                    print "~" found
                } else {
                    continue
                }
                j = at + 1
            }
        }' "$1"
}

# update FILE: its expected lines anew, from n.new and n.status
update() {
    awk '
        function take(file, line) { while ((getline line < file) > 0) print line; close(file) }
        /^# / { n++ }
        /^= / {
            take(n ".new")
            getline line < (n ".now")
            print "= " line
            next
        }
        n == 0 || /^#/ || /^\|/ || /^$/' "$1" >"$1.new" && cat "$1.new" >"$1" && rm "$1.new"
}

for file in "$folder"/*.test; do
    case $(basename "$file"):$("$CRUMPLE" --version) in
    study.test:*" no GSL"*)
        skip "draws and searches" "built without GSL"
        continue
        ;;
    esac
    blocks=$(split "$file")
    i=1
    while [ "$i" -le "$blocks" ]; do
        rm -rf mine.* empty.json sub/*
        "$CRUMPLE" <"$i.in" >"$i.got" 2>&1
        status=$?
        verdict=$(matches "$i.got" "$i.want")
        want=$(cat "$i.status")
        cp "$i.want" "$i.new"
        [ -z "$verdict" ] || renewed "$i.got" "$i.want" >"$i.new"
        echo "$status" >"$i.now"
        [ "$status" -eq "$want" ] || verdict="$verdict
status $status, want $want"
        if [ "$verb" != update ]; then
            empty "$(basename "$file" .test): $(cat "$i.name")" "$verdict"
        elif [ -n "$verdict" ]; then
            echo "$(basename "$file"): $(cat "$i.name")"
        fi
        i=$((i + 1))
    done
    [ "$verb" != update ] || update "$file"
    rm -f [0-9]*.in [0-9]*.want [0-9]*.name [0-9]*.status [0-9]*.got [0-9]*.new [0-9]*.now
done
[ "$verb" = update ] || finish
