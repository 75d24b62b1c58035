#!/bin/sh
# Every source that is cited is in the tree: [NAME-OF-IT] stands in share/doc/sources.md, and a page
# that is named is shipped.
. "$SRC/tests/tap.sh"
cd "$SRC" || exit 99
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
pages=share/doc/sources.md

sed -n 's/^### \([A-Z0-9-]*\)$/\1/p' $pages | LC_ALL=C sort >"$tmp/there"
empty "no source stands there twice" "$(uniq -d "$tmp/there")"
empty "and each says how sure it is" "$(awk '
    function flush() {
        sure = tolower(text) ~ /read|computed|memory|choice|derived|textbook/
        if (name != "" && !sure) print name
    }
    /^##/ { flush(); name = "" }
    /^### / { name = $2; text = ""; next }
    { text = text $0 }
    END { flush() }' $pages)"

# a name in brackets has two parts at least, so that no index of an array is one
grep -rnoE '\[[A-Z]{2,}[A-Z0-9]*(-[A-Z0-9]+)+\]' src tests models share man README.md HACKING.md |
    grep -v "^$pages:\|^tests/check_sources.sh:" >"$tmp/cited"
tr -d '[]' <"$tmp/cited" | while IFS=: read -r file line name; do
    grep -qx -e "$name" "$tmp/there" || echo "$file:$line: $name"
done >"$tmp/lost"
empty "every source that is cited stands in $pages" "$(cat "$tmp/lost")"
[ "$(wc -l <"$tmp/cited")" -gt 30 ]
report $? "and they are cited"

# pages by name, in whatever folder they lie once installed
grep -rnoE '[a-z_]+\.md\b' src tests models share man README.md HACKING.md NEWS |
    grep -v '^tests/check_sources.sh:' | while IFS=: read -r file line page; do
    [ -e "share/doc/$page" ] || [ -e "$(dirname "$file")/$page" ] ||
        echo "$file:$line: $page"
done >"$tmp/pages"
empty "every page that is named is in the tree" "$(cat "$tmp/pages")"
empty "and none by a number that it has not" "$(grep -rnE '(method|models|validation)\.md [0-9]' \
    src tests models share man README.md)"
finish
