#!/bin/sh
# The map of the tree: every C file and script with the first sentence of its first comment.
# Run from the top of the tree: map.sh [FOLDER...]. A file that does not begin with a sentence
# stands there with nothing after its name.
set -u
[ $# -gt 0 ] || set -- src tests

# files of a folder first, then those of its subfolders
files=$(find "$@" -type f \( -name '*.[ch]' -o -name '*.sh' \) |
    sed 's#^\(.*/\)\([^/]*\)$#\1 \1\2#' | LC_ALL=C sort | cut -d ' ' -f 2)

# no file of the tree has a blank in its name
# shellcheck disable=SC2086
awk '
    function flush(   text, dir) {
        if (file == "") return
        text = comment
        gsub(/ +/, " ", text)
        gsub(/^ | $/, "", text)
        if (match(text, /[.?!] /)) text = substr(text, 1, RSTART)
        dir = file
        sub(/[^\/]*$/, "", dir)
        if (dir != folder) printf "%s## %s\n", folder == "" ? "" : "\n", dir
        folder = dir
        printf "- `%s`: %s\n", file, text
    }
    FNR == 1 {
        flush()
        file = FILENAME
        comment = ""
        done = FILENAME ~ /\.[ch]$/ && !/^\/\*/
    }
    done { next }
    FILENAME ~ /\.[ch]$/ { # a paragraph of a comment ends where the comment does, or with " *"
        line = $0
        done = sub(/ *\*\/.*/, "", line)
        sub(/^(\/| )\* ?/, "", line)
        done = done || line == ""
        comment = comment " " line
        next
    }
    /^#!/ || /^# shellcheck/ { next }
    /^# / { comment = comment " " substr($0, 3); next }
    { done = 1 }
    END { flush() }' $files
