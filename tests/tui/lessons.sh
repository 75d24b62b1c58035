#!/bin/sh
# What a lesson says at each of its pauses, on a small and on a large screen, as it was looked at:
# words, commands and keys that come into view, with # for numbers. Answers are left out: how many
# lines they take goes by the numbers. `make update-golden` writes it anew.
. "$SRC/tests/tui/tui.sh"
golden=$SRC/tests/golden/tui

# the rows of words: below the picture, or in the pane of the log
words_of() {
    text | case $1 in
    80x24) sed -n '/^└/,$p' | sed -n '2,$p' ;;
    *) sed -n '/┌ Log/,$p' | sed -n '2,$p' | sed 's/.*││//; s/│$//' ;;
    esac | sed 's/[0-9][0-9]*\.*[0-9]*/#/g; s/ *$//'
}

waits() {
    on_screen '^Enter (goes|reads) on' || on_screen '^crumple>$'
}

# the words are others than those in the file `said`, and no longer change
settled() {
    waits && words_of "$1" >now && ! cmp -s now said && sleep 0.2 && words_of "$1" | cmp -s - now
}

# lesson NAME COLUMNS ROWS: all its pages into the file `pages`
lesson() {
    start "$2" "$3"
    until_ok on_screen "F1 help"
    : >said
    : >seen
    : >pages
    keys "source share/tutorial/$1.crumple" Enter
    page=0
    until_ok on_screen '^Enter '
    while [ "$page" -lt 40 ] && until_ok settled "$2x$3"; do
        page=$((page + 1))
        grep -Ev '^  |^ ? ?$|^[└┌]' now | grep -vxFf seen >new
        [ ! -s new ] || { echo "---" && cat new; } >>pages
        cat new >>seen
        cp now said
        on_screen '^crumple>$' && break
        keys Enter
    done
    keys "quit!" Enter
    until_ok on_screen "^status 0"
}

for size in "80 24" "200 50"; do
    name=lesson-$(echo "$size" | tr ' ' x).txt
    # shellcheck disable=SC2086 # two words
    lesson 1-first-crash $size
    if [ "${1-}" = update ]; then
        cp pages "$golden/$name"
    elif cmp -s pages "$golden/$name"; then
        report 0 "$name"
    else
        report 1 "$name"
        diff "$golden/$name" pages | explain
    fi
done
finish
