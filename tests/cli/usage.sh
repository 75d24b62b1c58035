#!/bin/sh
# Words, options and the texts about them.
. "$SRC/tests/cli/cli.sh"

# undocumented WORD: options of its help that its section of the manual does not name
undocumented() {
    sed -n "/^\.SS crumple $1/,/^\.S[SH]/p" "$SRC/man/crumple.1" | tr -d '\\' >"$tmp/section"
    printf '%s\n' "$out" | grep -oE -e '^ +(-[a-z], )?--[a-z-]+' | grep -oE -e '--[a-z-]+' |
        while read -r option; do
            [ "$option" = --help ] || grep -q -e "$option" "$tmp/section" || echo "$option"
        done
}

run --version
same "--version succeeds" "$status" 0
has "--version names the program and its libraries" "$out" '^built with ncurses .*readline .*cJSON'
for word in -v -V version; do
    run $word
    has "$word names the version" "$out" '^crumple [0-9]'
done
run help
has "crumple help is the help" "$out" '^usage: crumple '
run help run
has "of a word too" "$out" '^usage: crumple run '
run help sweep
has "or of a command" "$out" 'sweep: solve for'
run help nothing
has "help of nothing" "$errs" "there is no command or term 'nothing'"
run "$SRC/share/scenes/q7-fiat500.json"
same "a scene into a pipe is solved" "$status" 0
by_run=$(printf '%s' "$out" | cksum)
run run "$SRC/share/scenes/q7-fiat500.json"
same "as run does" "$by_run" "$(printf '%s' "$out" | cksum)"
run "$SRC/share/scenes/q7-fiat500.json" -e list
has "with commands behind it it is opened" "$out" 'A: suv'
run --help
same "--help succeeds" "$status" 0
has "--help names run" "$out" 'crumple run SCENE.json'
has "--help explains the exit status" "$out" 'Exit status: 0 done'
for word in run stack merge validate models schema calibrate; do
    run $word --help
    same "$word --help succeeds" "$status" 0
    has "$word --help begins with the usage" "$out" "^usage: crumple $word "
    empty "the manual has every option of $word" "$(undocumented "$word")"
done

run schema
same "schema lists the schemas" "$out" "$(printf 'scene\nresult\ndamage\nvoxel-model\nrecipe')"
for name in $out; do
    run schema "$name"
    same "schema $name is that file" "$(cksum <"$tmp/out")" \
        "$(cksum <"$SRC/share/schema/$name.schema.json")"
    has "which has an id" "$out" '"\$id":[[:space:]]*"urn:crumple:schema:'"$name\""
done
refused "no such schema" 2 "no schema 'sceen' .one of scene" schema sceen
refused "unknown word" 2 'unknown .*rnu.*did you mean run' rnu
refused "unknown option of the program" 2 'unknown option --versoin.*mean --version' \
    --versoin
refused "run without a scene" 2 'needs SCENE.json' run
refused "run with two scenes" 2 'takes 1 operand' run a.json b.json
refused "misspelt option" 2 'unknown option --fromat.*did you mean --format' run --fromat=csv x
refused "unknown format" 2 "'xml' is none of json|text|csv" run "$demo" --format xml
refused "option without its value" 2 '-*output needs a value' run "$demo" -o
refused "switch with a value" 2 '--trace takes no value' run "$demo" --trace=yes
refused "width out of range" 2 'width.*40\.\.400' run "$demo" --width=3
refused "--set without a value" 2 '--set dt_ms has no KEY=VALUE' run "$demo" --set dt_ms
finish
