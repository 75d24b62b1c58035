#!/bin/sh
# Every file says what it is for: C files and scripts in their first sentence, which make map
# prints; data by the folder they lie in, which HACKING.md names.
. "$SRC/tests/tap.sh"
cd "$SRC" || exit 99
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT

sh tests/map.sh >"$tmp/map"
empty "every .c, .h and .sh begins with a sentence that says what it is for" \
    "$(grep '^- ' "$tmp/map" | grep -vE '`: .*[.?!]$')"
empty "and with a short one" "$(grep '^- ' "$tmp/map" | grep -E '.{400,}' | cut -c 1-80)"

# lines "- `folder/`: what lies there"
sed -n 's#^- `\([^`]*/\)`: ..*#\1#p' HACKING.md | LC_ALL=C sort >"$tmp/folders"
find src models share tests man -type f ! -name '*.[cho]' ! -name '*.sh' ! -name '*.mk' \
    ! -name '*.log' ! -name '*.trs' ! -name '*.py[co]' ! -name .dirstamp ! -path '*/.deps/*' |
    while read -r file; do
        while read -r folder; do
            case $file in "$folder"*) continue 2 ;; esac
        done <"$tmp/folders"
        echo "$file"
    done >"$tmp/homeless"
empty "HACKING.md says what lies in each folder of data" "$(cat "$tmp/homeless")"
empty "and names none that is not there" \
    "$(while read -r folder; do [ -d "$folder" ] || echo "$folder"; done <"$tmp/folders")"
empty "and none twice" "$(uniq -d "$tmp/folders")"
finish
