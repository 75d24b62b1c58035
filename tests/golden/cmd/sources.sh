#!/bin/sh
# Where commands come from: files, pipes, -e; their order, their errors and their exit status.
. "$SRC/tests/cli/cli.sh"
unset COLUMNS
cd "$tmp" || exit 99
export CRUMPLE_DATA="$SRC"
car='vehicle A type=suv mass=2000kg'
echo "$car" >one.crumple
printf '#!/usr/bin/env crumple\nlist\n' >two.crumple
printf 'list\nfoo\nlist\n' >bad.crumple
empty='  the scene is empty; begin with: vehicle A type=compact'
suv='  A: suv 2000 kg  x=0.00 m y=0.00 m heading=0.0 deg  0.0 km/h'

run one.crumple two.crumple
same "files run in order in one session" "$out" "$suv
$suv"
run two.crumple -e "$car" two.crumple
same "and -e among them" "$out" "$empty
$suv
$suv"
same "standard input without arguments" "$(echo list | "$crumple" 2>&1)" "$empty"
same "standard input as -" "$(echo list | "$crumple" one.crumple - 2>&1)" "$suv
$suv"
same "more with -i after files" "$(echo list | "$crumple" -i one.crumple 2>&1)" "$suv
$suv"
same "a prompt needs a terminal; without one --repl reads a script" \
    "$(echo list | "$crumple" --repl 2>&1)" "$empty"
same "lines that end with CR LF" "$(printf '%s\r\nlist\r\n' "$car" | "$crumple" 2>&1)" "$suv
$suv"
same "a last line without its end" "$(printf 'list' | "$crumple" 2>&1)" "$empty"
same "a continued line on standard input" \
    "$(printf 'vehicle A \\\n type=suv \\\n mass=2000kg\n' | "$crumple" 2>&1)" "$suv"

run bad.crumple two.crumple
same "the first error ends the run" "$status:$out" "3:$empty"
has "with its file, line and column" "$errs" '^bad.crumple:2:1: error: there is no command'
run -e list -e foo
has "an error in -e" "$errs" '^-e:1:1: error: '
run -e 'assert 1'
same "status of an error in the language" "$status" 3
run -e "$car" -e 'assert A.mass == 1t'
same "status of a missed assertion" "$status" 1
run -e "$car; object tree kind=pole; place A heading=180deg speed=9m/s; solve"
same "status of a solve that fails" "$status" 4
run -e 'load no.json'
same "status of a file that is not there" "$status" 2
run -e 'quit; foo' -e foo
same "quit ends all" "$status$errs" 0

refused "a command file that is not there" 2 'no.crumple: error: cannot open' no.crumple
refused "a folder" 2 'error: cannot read' ./
run "$demo" -e list
has "a scene among commands is opened" "$out" 'A: suv'
refused "-e without a command" 2 'a command must follow' -e
refused "an unknown option" 2 'unknown option' -e list --fast
refused "a bad --color" 2 'always, auto or never' --color=pink
printf 'list\000list\n' >nul.crumple
refused "a NUL byte" 3 'nul.crumple:1:1: error: a NUL byte' nul.crumple
printf 'list\000list\n' | "$crumple" >/dev/null 2>errs
same "a NUL byte on standard input" "$?" 3
if [ -w /dev/full ]; then
    "$crumple" -e help >/dev/full 2>errs
    same "a full disk behind standard output" "$?" 2
fi

LC_ALL=C "$crumple" -e "$car; show" >plain 2>&1
same "no UTF-8, no other characters" "$(LC_ALL=C grep -c '[^ -~]' plain)" 0
"$crumple" -e "$car; show" >plain 2>&1
same "no colour in a file" "$(grep -c "$(printf '\033')" plain)" 0
"$crumple" --color=always -e "$car; show" >plain 2>&1
grep -q "$(printf '\033')" plain
report $? "unless it is asked for"
NO_COLOR=1 "$crumple" --color=auto -e "$car; show" >plain 2>&1
same "NO_COLOR" "$(grep -c "$(printf '\033')" plain)" 0
COLUMNS=60 "$crumple" --ascii -e "$car; show" >plain 2>&1
same "COLUMNS is the width of pictures" "$(sed 1d plain | awk 'length > 60' | wc -l | tr -d ' ')" 0

# another program may talk through pipes: each line is answered before the next is there
mkfifo to from
"$crumple" <to >from 2>&1 &
exec 3>to 4<from
echo list >&3
read -r answer <&4
same "an answer comes before the end of input" "  $answer" "$empty"
exec 3>&-
wait $!
wall_scene "" '"width_m": 1.8000000000000003, "x_note": [0.30000000000000004, 1e-7]' >exact.json
run -e 'load exact.json; save exact2.json; load exact2.json; save exact3.json'
same "numbers are saved to the last bit" "$(grep -cE \
    '"width_m":.1.8000000000000003,|"x_note":.\[0.30000000000000004, 1e-07\]' exact2.json)" 2
same "and saving is the inverse of loading" "$(cksum <exact3.json)" "$(cksum <exact2.json)"

printf '\357\273\277vehicle A type=suv\n' >"$tmp/bom.crumple"
"$CRUMPLE" "$tmp/bom.crumple" >"$tmp/out" 2>&1
same "a byte order mark is an error of the text" "$?" 3
has "with the way out" "$(cat "$tmp/out")" 'bom.crumple:1:1: error: .*byte order mark'
finish
