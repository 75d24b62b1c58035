#!/bin/sh
# The table of share/doc/validation.md and man/crumple-validation.7 as the program prints it today;
# to be reviewed. Run by `make update-validation`.
set -e
table=$(mktemp) && page=$(mktemp)
trap 'rm -f "$table" "$page"' EXIT
"$CRUMPLE" validate --targets --worst=0 | sed -n '/^full-width rigid wall/,$p' >"$table"
test -s "$table"

# update FILE FIRST-LINE LAST-LINE: the table between two lines after the heading "What came out"
update() {
    awk -v first="$2" -v last="$3" -v table="$4" '
        tolower($0) ~ /what came out/ { there = 1 }
        skip && $0 == last { skip = 0; there = 0 }
        !skip { print }
        there && !skip && $0 == first {
            while ((getline line < table) > 0) print line
            skip = 1
        }' "$1" >"$page"
    cat "$page" >"$1"
}
update "$SRC/share/doc/validation.md" '```' '```' "$table"
sed -i 's/-/\\-/g' "$table"
update "$SRC/man/crumple-validation.7" .nf .fi "$table"
