#!/bin/sh
# Hostile input: readers that end, text that does not act, whatever a scene, folder or pipe holds.
. "$SRC/tests/cli/cli.sh"
cases=$SRC/tests/cases/hostile
cd "$tmp" || exit 99
cp "$cases/pole.json" . || exit 99

# ends NAME STATUS PATTERN COMMAND ...: within ten seconds, with that status and text in its output;
# 124 and more are those of timeout, which kills: some of these have outlived SIGTERM
ends() {
    ends_name=$1 ends_want=$2 ends_pattern=$3
    shift 3
    timeout -s KILL 10 "$@" >ends.out 2>&1
    ends_status=$?
    same "$ends_name: status" "$ends_status" "$ends_want"
    has "$ends_name: told" "$(cat ends.out)" "$ends_pattern"
}

# ---- readers end ----
mkdir -p folder/sub.json && cp pole.json folder
ends "a folder in a folder" 1 '"where":"folder/sub.json:"' "$crumple" stack folder
ends "a folder in a folder does not hide the scene" 1 '"scene":"pole","version"' \
    "$crumple" stack folder
mkdir other && cp pole.json other/z.json && mkfifo other/a.json && ln -s /dev/zero other/b.jsonl
ends "a pipe in a folder" 1 '"message":"this is a pipe, not a file.*"where":"other/a.json:"' \
    "$crumple" stack other
ends "a device in a folder" 1 '"message":"this is a device, not a file.*"where":"other/b.jsonl:"' \
    "$crumple" stack other
ends "neither hides the scene" 1 '"index":2,"scene":"pole","version"' "$crumple" stack other
ends "a closed input of a stack" 1 '"code":"io".*standard input' \
    sh -c 'exec "$0" stack - <&-' "$crumple"
ends "a closed input of a run" 2 'standard input: error: cannot read' \
    sh -c 'exec "$0" run - <&-' "$crumple"
ends "closed standard error is not the output file" 0 '' \
    sh -c 'exec "$0" run pole.json -o out.json 2>&-' "$crumple"
has "which is whole" "$(head -c 22 out.json | tr -d '\n')" 'crumple_result'
mkfifo pipe
sed 's/own2.csv/pipe/' "$cases/own.json" >own-pipe.json
ends "a pipe as own model" 2 'this is a pipe, not a file' "$crumple" run own-pipe.json
sed 's,own2.csv,/dev/zero,' "$cases/own.json" >own-zero.json
ends "a device as own model" 2 'this is a device, not a file' "$crumple" run own-zero.json
ends "a pipe for load" 2 'this is a pipe' "$crumple" -e 'load pipe'
ends "a device for source" 2 'this is a device' "$crumple" -e 'source /dev/zero'
ends "a device for compare" 2 'this is a device' \
    "$crumple" -e 'load pole.json' -e solve -e 'compare /dev/zero'
(sleep 0.2; cat pole.json) >pipe &
ends "a pipe with a writer is a stack" 0 '"scene":"pole"' "$crumple" stack pipe
ends "zeroes without end as a stack" 1 '"code":"syntax","message":"a NUL byte: this is no text"' \
    "$crumple" stack /dev/zero
ends "zeroes behind a scene" 1 '"scene":"pole",.*this is no text","where":"standard input:2:"' \
    sh -c '(tr -d "\n" <pole.json; echo; cat /dev/zero) 2>/dev/null | "$0" stack -j 1 - | tr -d "\n"
        exit 1' "$crumple"
ends "zeroes without end as a scene" 2 '/dev/zero: error: this is no text, it has NUL bytes' \
    "$crumple" run /dev/zero
ends "lines without end behind an array" 1 'text after the end of the array' \
    sh -c '(echo "[]"; yes) 2>/dev/null | "$0" stack -' "$crumple"
ends "a device as the part of a stack" 2 'this is a device' "$crumple" merge /dev/zero
mkdir -p data/share
cp -r "$SRC/models" data/ && cp -r "$SRC/share/irf" data/share/ && chmod -R u+w data
cp "$cases/recipe-nul-hang.json" data/models/sedan.json
ends "a NUL in a recipe" 3 'sedan.json:1:20: error' env CRUMPLE_DATA="$tmp/data" "$crumple" run \
    pole.json

# hears NAME SIGNAL STATUS ARG ...: the first signal ends what has opened the pipe and waits for it
hears() {
    hears_name=$1 hears_signal=$2 hears_want=$3
    shift 3
    "$crumple" "$@" >ends.out 2>&1 &
    hears_pid=$!
    hears_tries=100
    while [ $hears_tries -gt 0 ] &&
        ! ls -l "/proc/$hears_pid/fd" 2>/dev/null | grep -q " -> .*/pipe$"; do
        hears_tries=$((hears_tries - 1))
        sleep 0.1
    done
    sleep 0.2
    kill -s "$hears_signal" $hears_pid
    (sleep 10 && kill -s KILL $hears_pid) 2>/dev/null &
    hears_end=$!
    wait $hears_pid
    same "$hears_name" "$?" "$hears_want"
    kill $hears_end
}
hears "the first SIGTERM while a stack waits for a pipe" TERM 130 stack pipe
# and one that comes just before a call that would wait: before the output file, a pipe, is opened
if [ -e "$BUILD/fault.so" ] && "$crumple" --version | grep -q 'sanitizers: no' &&
    LD_PRELOAD=$BUILD/fault.so "$crumple" --version >/dev/null 2>&1; then
    for word in run "stack -j1"; do
        # after its output a stack opens the scene
        [ "$word" = run ] && back=1 || back=2
        # shellcheck disable=SC2086
        opens=$(LD_PRELOAD=$BUILD/fault.so FAULT_KIND=open FAULT_COUNT=9 \
            "$crumple" $word pole.json -o /dev/null 9>&1 >ends.out 2>&1)
        # shellcheck disable=SC2086
        ends "a SIGTERM just before crumple $word opens a pipe" 130 'interrupted' \
            env LD_PRELOAD="$BUILD/fault.so" FAULT_KIND=open FAULT_AT=$((opens - back)) \
            FAULT_SIGNAL=15 "$crumple" $word pole.json -o pipe
    done
else
    skip "a SIGTERM just before a wait" "no library to send it was built here"
fi

# ---- what a terminal gets ----
# quiet NAME COMMAND ...: nothing that acts on a terminal in what it writes
quiet() {
    quiet_name=$1
    shift
    timeout -s KILL 10 "$@" </dev/null >quiet.out 2>&1
    empty "$quiet_name" "$(python3 - quiet.out <<'END'
import sys
text = open(sys.argv[1], 'rb').read().decode('utf-8', 'surrogateescape')
if not text:
    print('no output')
for c in text:
    n = ord(c)
    if (n < 32 and c != '\n') or 0x7F <= n < 0xA0 or 0x200B <= n <= 0x200F or \
            0x2028 <= n <= 0x202E or 0x2060 <= n <= 0x206F or n == 0xFEFF or 0xDC80 <= n < 0xDD00:
        print('U+%04X in' % n, repr(text[max(0, text.index(c) - 40):][:80]))
        break
END
)"
}
ugly=$(printf 'x\033]0;pwn\007\302\233\342\200\256y')
cp pole.json "$ugly.json"
printf '%s\n' "list $ugly" >"$ugly.crumple"
printf 'set echo=on\n# %s\nlist\n' "$ugly" >echo.crumple
printf 'Test,%s\n1,2\n' "$ugly" >"$ugly.csv"
quiet "a scene with such names" "$crumple" run "$cases/c1-bidi-names.json"
quiet "the same in a stack" "$crumple" stack "$cases/c1-bidi-names.json"
quiet "such a key" "$crumple" run "$cases/esc-in-key.json"
quiet "such a key in a stack" "$crumple" stack "$cases/esc-in-key.json"
quiet "such names in a table of a stack" "$crumple" stack -f csv "$cases/c1-bidi-names.json"
# results that somebody has written, with such names, ids, values and errors
"$crumple" stack pole.json pole.json |
    UGLY='x\u001b]0;pwn\u0007\u009b\u202ey' awk '{ ugly = ENVIRON["UGLY"]
        gsub(/"(pole|A|10LPAN2)"/, "\"" ugly "\""); sub(/"index"/, "\"pair\":\"" ugly "\",&"); print
        sub(/"index":./, "\"index\":" NR + 1)
        sub(/"version"/, "\"error\":{\"code\":\"" ugly "\"},&")
        print }' >part.jsonl
quiet "such results put together" "$crumple" merge part.jsonl
quiet "in a table" "$crumple" merge -f csv part.jsonl
quiet "in a table of impacts" "$crumple" merge -f csv --per impact part.jsonl
quiet "in a summary" "$crumple" merge --summary --group scene part.jsonl
has "which has them" "$(tr '\n' ' ' <quiet.out)" 'failed 2 \(x.x1b.*pwn.*x.x1b.*ees_kmh by scene'
# an axis whose round steps are too small to be added to its numbers
"$crumple" stack pole.json pole.json | awk '{
    gsub(/"ees_kmh":[^,]*/, "\"ees_kmh\":" (NR == 1 ? "1e17" : "100000000000000016"))
    gsub(/"(delta_v|closing)_kmh":[^,]*/, "\"delta_v_kmh\":" 30 + NR)
    sub(/"index":./, "\"index\":" NR); print }' >narrow.jsonl
plot='x=A.ees_kmh y=A.delta_v_kmh'
ends "a plot of great numbers" 1 '100000000000000016$' "$crumple" merge narrow.jsonl --plot "$plot"
ends "its picture" 1 'missing: 1 scene' "$crumple" merge narrow.jsonl --plot "$plot" \
    --picture narrow.svg
quiet "such a file of a run" "$crumple" run "$ugly"
quiet "such a file in a stack" "$crumple" stack "$ugly"
quiet "such a word" "$crumple" "$ugly"
quiet "such an option" "$crumple" run "--$ugly"
quiet "such an option of commands" "$crumple" "--$ugly"
quiet "such a setting" "$crumple" run pole.json --set "$ugly=1"
quiet "such a value" "$crumple" run pole.json --set "A.speed_kmh=$ugly"
quiet "such a name by a setting" "$crumple" run pole.json --set "name=$ugly"
quiet "such a command" "$crumple" -e "$ugly"
quiet "such a word of a command" "$crumple" -e "load $ugly"
quiet "such a word in quotes" "$crumple" -e "load \"$ugly\""
quiet "such a participant" "$crumple" -e "vehicle \"$ugly\" type=sedan"
quiet "such a command file" "$crumple" "$ugly.crumple"
quiet "an echo" "$crumple" echo.crumple
quiet "such a table of tests" "$crumple" validate "$ugly.csv"
printf 'test_no,make,model,year,body,mass_kg,speed_kmh,c1,c2,c3,c4,c5,c6\n' >named.csv
printf '%s,%s,%s,%s,S,1719,57,380,466,511,518,489,370\n' "$ugly" "$ugly" "$ugly" "$ugly" >>named.csv
for form in text csv json; do
    quiet "tests with such names as $form" \
        sh -c '"$0" validate named.csv --cases --fast -f $1 | tr -d "\t"' "$crumple" $form
    has "which are there" "$(cat quiet.out)" 'x\?]0;pwn\?[?]+y'
done
printf '%s' '{ "crumple": 1, "name": "t", "x_title": "UGLY", ' \
    '"x_expect": { "A": { "ees_kmh": 30 } },' |
    sed "s/UGLY/$(printf 'x\\\\u001b]0;pwn\\\\u0007y')/" >named.json
sed 's/.*"name": "pole",//' pole.json >>named.json
quiet "a scene with such a title as test" "$crumple" validate named.json --cases --fast
has "which is there" "$(cat quiet.out)" 'x\?]0;pwn\?y'
quiet "such a measured pulse" "$crumple" -e 'load pole.json' -e solve -e "compare \"$ugly.csv\""
quiet "such a model" "$crumple" models "$ugly"
quiet "such an earlier result" "$crumple" stack pole.json --resume "$ugly"
quiet "such an output" "$crumple" run pole.json -o "no/$ugly"
"$crumple" run pole.json -o result.json
for where in '"version":' '"cdc":' '"scene":'; do
    # the control characters that JSON lets through as they are, and those that it escapes
    WHERE=$where UGLY=$(printf 'x\\u001b]0;pwn\\u0007\302\233\342\200\256y') \
        awk 'i = index($0, ENVIRON["WHERE"]) {
        $0 = substr($0, 1, i - 1) ENVIRON["WHERE"] " \"" ENVIRON["UGLY"] "\"," } { print }' \
        result.json >other.json
    quiet "such a result with $where in audit" "$crumple" audit other.json
    quiet "and in diff" "$crumple" diff result.json other.json
    quiet "and in compare" "$crumple" -e 'load pole.json' -e solve -e 'compare other.json'
done
cp result.json "$ugly.result.json"
quiet "such a name of a result in diff" "$crumple" diff result.json "$ugly.result.json"
run audit other.json
has "and the difference is told" "$out" "differs first"

# a line of 30 KB is not echoed whole: what is wrong stays, with its caret below
awk 'BEGIN { printf "list "; while (n++ < 30000) printf "x"; print "" }' >long.crumple
awk 'BEGIN { while (n++ < 3000) printf "list; "; print "bogus" }' >many.crumple
for line in long:6 many:18001; do
    run "${line%:*}.crumple"
    same "a long line: ${line%:*}" "$status $(printf '%s\n' "$errs" | awk '
        NR == 1 { split($0, place, ":"); print place[3] } length($0) > 250 { print "long" }
        NR == 2 { text = $0 } NR == 3 { print substr(text, index($0, "^"), 3) }' | tr '\n' ' ')" \
        "3 ${line#*:} $([ "${line%:*}" = long ] && echo xxx || echo bog) "
done

"$crumple" run "$cases/esc-in-key.json" 2>errs
same "the place of a key with escapes" "$(cut -d: -f2-3 errs)" 1:2
run run "$cases/name-63-umlauts.json"
same "a name of 63 umlauts" "$status" 0
finish
