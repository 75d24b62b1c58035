#!/bin/sh
# The bash completion offers the words, the options of each word, and their values.
. "$SRC/tests/cli/cli.sh"
command -v bash >/dev/null 2>&1 || {
    echo "1..0 # SKIP no bash here"
    exit 0
}

# offers WORD ...: what is offered for the last word, in one line
offers() {
    bash -c '. "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _crumple; echo "${COMPREPLY[@]}"' \
        "$SRC/share/completions/crumple" "$@" 2>&1
}
same "the word run" "$(offers "$crumple" ru)" run
same "an option of run" "$(offers "$crumple" run --tr)" --trace
same "an option that takes a value" "$(offers "$crumple" run --form)" --format=
same "all values of --format" "$(offers "$crumple" run --format =)" "json text csv"
same "a value of --format" "$(offers "$crumple" run --format = te)" text
same "the words of --help" "$("$crumple" --completions "" | sort)" \
    "$("$crumple" --help | sed -n 's/^  *crumple \([a-z][a-z]*\) .*/\1/p' | sort -u)"
same "options of calibrate" "$(offers "$crumple" calibrate --wr)" --write=
same "classes of validate" "$(offers "$crumple" validate po)" pole
same "models" "$(offers "$crumple" models sedan/12)" sedan/12
same "schemas" "$(offers "$crumple" schema re)" "result recipe"
same "settings after -s" "$(offers "$crumple" run -s restit)" restitution=
same "keys of the scene on the line" "$(offers "$crumple" run "$demo" -s A.sp)" A.speed_kmh=
same "also with --set=" "$(offers "$crumple" run "$demo" --set = B.brak)" \
    "B.brake= B.brake_after.deceleration_mps2= B.brake_after.reaction_s="
same "no key of another kind" "$(offers "$crumple" run "$demo" -s A.radius)" ""
touch "$tmp/a.crumple" "$tmp/b.json"
same "command files" "$(offers "$crumple" "$tmp/a")" "$tmp/a.crumple"
same "files after a word" "$(offers "$crumple" run "$tmp/b")" "$tmp/b.json"

if command -v zsh >/dev/null 2>&1; then
    # what the function hands to the line editor
    shown() {
        zsh -f -c 'compadd() { while [ $# -gt 0 ]; do case $1 in
                -a) print -r -- ${(P)2}; shift ;; -S) shift ;; esac; shift; done }
            _files() { print files }
            words=("${@:2}"); CURRENT=$#words; source "$1"' \
            zsh "$SRC/share/completions/_crumple" "$@"
    }
    same "zsh: words" "$(shown "$crumple" ru | head -n 1)" run
    same "zsh: a value" "$(shown "$crumple" run --format=te)" --format=text
    same "zsh: files" "$(shown "$crumple" run x)" files
else
    skip "zsh" "no zsh here"
fi
if command -v fish >/dev/null 2>&1; then
    shown() {
        HOME=$tmp fish -N -c "source '$SRC/share/completions/crumple.fish'
            complete -c '$crumple' -a '(__crumple_complete)'; complete -C '$*'" 2>/dev/null |
            cut -f 1
    }
    same "fish: words" "$(shown "$crumple ru" | head -n 1)" run
    has "fish: a value" "$(shown "$crumple run --format=te")" 'text$'
    has "fish: keys" "$(shown "$crumple run $demo -s A.sp")" '^A.speed_kmh='
else
    skip "fish" "no fish here"
fi
finish
