#!/bin/sh
# Momentum, angular momentum and energy to 1e-9 in every scene of the tree, with both methods, to
# separation and to rest.
. "$SRC/tests/cli/cli.sh"

# worst RESULT: its greatest residual
worst() {
    tr ',{}' '\n\n\n' <"$1" | awk -F: '
        /"(momentum|angular|energy)_residual"/ {
            n++
            if ($2 + 0 > worst || $2 !~ /^[ 0-9.e+-]+$/) worst = $2 + 0
        }
        END { if (n >= 3) printf "%g\n", worst; else print "no residuals" }'
}

scenes=0
missed=
for scene in "$SRC"/share/scenes/*.json "$SRC"/share/validation/*/*.json \
    "$SRC"/tests/bench/*.json; do
    grep -q '"participants"' "$scene" || continue
    scenes=$((scenes + 1))
    for setting in method=extended method=paper end=rest; do
        run run --set "$setting" "$scene"
        if [ "$status" -ne 0 ]; then
            missed="$missed$scene $setting: $errs
"
            continue
        fi
        got=$(worst "$tmp/out")
        case $(awk -v x="$got" 'BEGIN { print (x ~ /^[0-9]/ && x < 1e-9) ? "yes" : "no" }') in
        no) missed="$missed$scene $setting: $got
" ;;
        esac
    done
done
empty "momentum and energy close to 1e-9 in every scene" "$missed"
[ "$scenes" -ge 10 ]
report $? "these were $scenes scenes"
finish
