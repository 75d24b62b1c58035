#!/bin/sh
# Continuity, convergence and monotony of the solver on random and chosen crashes: each figure is as
# good as wanted, or a known miss that share/doc/validation.md tells, and no worse than there.
. "$SRC/tests/cli/cli.sh"
if ! command -v python3 >/dev/null 2>&1; then
    skip "the numbers are a property of the crash" "no python3"
    finish
fi
python3 "$SRC/tests/bench/continuity.py" "$crumple" >"$tmp/report"
report $? "the numbers are a property of the crash: no figure is worse than told"
grep -E 'WORSE|known' "$tmp/report" | explain
[ "$(grep -cE '^ (met|known miss|WORSE) ' "$tmp/report")" -eq 29 ]
report $? "all figures are there"
# a limit that is not met is seen
sed 's/"peak": ([0-9., ]*)/"peak": (0, 0, 0, 0)/' "$SRC/tests/bench/continuity.py" \
    >"$tmp/strict.py"
python3 "$tmp/strict.py" "$crumple" --only continuity --n 8 >"$tmp/report"
[ $? -eq 1 ] && grep -q 'WORSE.*peak' "$tmp/report"
report $? "what is worse fails"
finish
