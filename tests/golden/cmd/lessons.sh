#!/bin/sh
# The lessons run to their end, show every comment and command, and say the same twice.
. "$SRC/tests/tap.sh"
cd "$SRC" || exit 99
case $("$CRUMPLE" --version) in
*"no GSL"* | *"no NLopt"*)
    skip "the lessons" "built without GSL or NLopt, which two of them need"
    finish
    exit
    ;;
esac
for file in share/tutorial/*.crumple; do
    one=$("$CRUMPLE" "$file" 2>&1)
    same "$file: status" "$?" 0
    two=$("$CRUMPLE" "$file" 2>&1)
    [ "$one" = "$two" ]
    report $? "$file: the same output on every run"
    lines=$(sed -n '3,$p' "$file" | grep -c '^#')
    shown=$(printf '%s\n' "$one" | grep -c '^#')
    same "$file: every comment is shown" "$shown" "$lines"
    ascii=$("$CRUMPLE" --ascii "$file" 2>&1 | LC_ALL=C grep -c '[^ -~]')
    same "$file: --ascii prints nothing else" "$ascii" 0
done
# one after the other in a session that is at work: each begins with an empty scene
all=$("$CRUMPLE" -e 'vehicle B type=suv; object wall kind=pole' share/tutorial/*.crumple 2>&1)
same "all lessons in one session: status" "$?" 0
has "the last one to its end" "$all" 'Lesson 7'
finish
