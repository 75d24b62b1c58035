#!/bin/sh
# The tables of share/doc/validation.md and man/crumple-validation.7, and the plot of real crashes,
# as the program prints them today; to be reviewed. Run by `make update-validation`.
set -e
table=$(mktemp) && field=$(mktemp) && page=$(mktemp)
trap 'rm -f "$table" "$field" "$page"' EXIT
"$CRUMPLE" validate --targets --worst=0 | sed -n '/^full-width rigid wall/,$p' >"$table"
test -s "$table"
"$CRUMPLE" validate field --plot >"$field"
test -s "$field"

# update FILE FIRST-LINE LAST-LINE TABLE HEADING: what stands between two lines after the heading
update() {
    awk -v first="$2" -v last="$3" -v table="$4" -v heading="$5" '
        tolower($0) ~ heading { there = 1 }
        skip && $0 == last { skip = 0; there = 0 }
        !skip { print }
        there && !skip && $0 == first {
            while ((getline line < table) > 0) print line
            skip = 1
        }' "$1" >"$page"
    cat "$page" >"$1"
}
update "$SRC/share/doc/validation.md" '```' '```' "$table" "what came out"
update "$SRC/share/doc/validation.md" '```' '```' "$field" "^## real crashes"
sed -i 's/-/\\-/g' "$table"
update "$SRC/man/crumple-validation.7" .nf .fi "$table" "what came out"
