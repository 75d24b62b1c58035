#!/bin/sh
# Files: unreadable, unwritable, full, closed; an output is written whole or not at all.
. "$SRC/tests/cli/cli.sh"
cd "$tmp" || exit 99
wall_scene >wall.json

refused "a file that is not there" 2 '^nowhere.json: error: cannot open: No such file' \
    run nowhere.json
refused "a folder is no scene" 2 '^\.: error: .*directory' run .
refused "an empty name" 2 'error' run ""
if [ "$(id -u)" -eq 0 ]; then
    skip "a file without permission" "root may read everything"
    skip "a folder without permission" "root may write everything"
else
    cp wall.json closed.json && chmod 0 closed.json
    refused "a file without permission" 2 '^closed.json: error: .*ermission' run closed.json
    mkdir closed && chmod 555 closed
    refused "a folder without permission" 2 'closed/x.*ermission' run wall.json -o closed/x
fi
refused "output into a folder that is not there" 2 '^no/where.json: error: cannot write' \
    run wall.json -o no/where.json
refused "output onto a folder" 2 'error: cannot write' run wall.json -o .
refused "output to a full disk" 2 '^/dev/full: error: cannot write: No space' \
    run wall.json -o /dev/full

"$crumple" run wall.json >/dev/full 2>errs
same "standard output to a full disk" "$?" 2
has "and says so" "$(cat errs)" 'standard output: error: cannot write: No space'
"$crumple" run wall.json >&- 2>errs
same "standard output closed" "$?" 2
has "and says so" "$(cat errs)" 'standard output: error: cannot write'
{ # more than any pipe holds, so that it cannot all have been written before the reader went
    "$crumple" run "$demo" --trace --set dt_ms=0.05 2>errs
    echo $? >status
} | true
same "a reader that had enough, as head, is no failure" "$(cat status):$(cat errs)" 0:

run run wall.json -o out.json
same "-o succeeds" "$status" 0
same "-o leaves standard output alone" "$out" ""
same "-o writes what standard output gets" "$(cksum <out.json)" \
    "$("$crumple" run wall.json | cksum)"
before=$(ls)
echo old >kept.json
run run wall.json --set A.speed_kmh=-20 --set A.course_deg=0 -o kept.json
run run nowhere.json -o kept.json
same "a failed run leaves the old file" "$(cat kept.json)" old
(
    ulimit -f 1
    "$crumple" run wall.json --trace -o kept.json 2>errs
    echo $? >status
)
same "an output that does not fit" "$(cat status)" 2
same "leaves the old file whole" "$(cat kept.json)" old
ln -s kept.json link.json
run run wall.json -o link.json
same "a link leads to what is written" "$status:$(cksum <kept.json)" \
    "0:$("$crumple" run wall.json | cksum)"
[ -L link.json ]
report $? "and stays a link"
mkdir away
ln -s away/new.json dangling
ln -s dangling twice
run run wall.json -o twice
same "a link to what is not there yet makes it there" "$status:$(cksum <away/new.json)" \
    "0:$("$crumple" run wall.json | cksum)"
run stack wall.json -o twice
has "also piece by piece" "$status:$(cut -c 1-30 away/new.json)" '^0:.*"index":0'
[ -L dangling ] && [ -L twice ]
report $? "and both stay links"
rm -rf kept.json link.json dangling twice away
same "no temporary files stay behind" "$(ls)" "$before"
finish
