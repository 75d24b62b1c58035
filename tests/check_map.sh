#!/bin/sh
# HACKING.md names every file of the tree once, and no file that is not there.
. "$SRC/tests/tap.sh"
cd "$SRC" || exit 99
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT

find src models share tests man -type f ! -name '*.o' ! -name '*.log' ! -name '*.trs' \
    ! -name '*.py[co]' ! -name .dirstamp ! -path '*/.deps/*' | sort >"$tmp/files"
# a list line of the map: - `path`, `path`: what it is
sed '1,/^# Map of the tree/d' HACKING.md | grep '^- `' >"$tmp/lines"
sed 's/: .*//' "$tmp/lines" | grep -o '`[^`]*`' | tr -d '`' |
    grep -E '^(src|models|share|tests|man)/' | sort >"$tmp/named"
grep -v '[*]' "$tmp/named" >"$tmp/exact"
grep '[*]' "$tmp/named" >"$tmp/patterns"

# patterns stand for rows of alike files
matches() {
    while read -r file; do
        # shellcheck disable=SC2254
        case $file in
        $1) echo "$file" ;;
        esac
    done <"$tmp/files"
}
while read -r pattern; do
    matches "$pattern" >"$tmp/now"
    [ -s "$tmp/now" ] || echo "$pattern" >>"$tmp/idle"
    cat "$tmp/now" >>"$tmp/covered"
done <"$tmp/patterns"
touch "$tmp/idle" "$tmp/covered"
sort -u "$tmp/exact" "$tmp/covered" >"$tmp/all"
sort -u "$tmp/exact" >"$tmp/once"

empty "every file is in the map" "$(comm -23 "$tmp/files" "$tmp/all")"
empty "every file of the map is there" "$(comm -13 "$tmp/files" "$tmp/once")"
empty "no file is named twice" "$(uniq -d "$tmp/named")"
empty "every pattern stands for files" "$(cat "$tmp/idle")"
empty "every line says what the file is for" "$(grep -v '`: .' "$tmp/lines")"
finish
