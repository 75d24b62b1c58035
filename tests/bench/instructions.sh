#!/bin/sh
# Instructions of a whole run and of the solver alone, in millions, by callgrind: the same on every
# machine, however busy. Part of `make bench`; says so where there is no valgrind.
command -v valgrind >/dev/null 2>&1 || {
    echo "instructions: no valgrind here (apt-get install valgrind)"
    exit 0
}
CRUMPLE_DATA=$SRC
export CRUMPLE_DATA

# count SCENE [OPTION]: millions of instructions
count() {
    counted=$1
    shift
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" "$CRUMPLE" run "$counted" \
        2>&1 >/dev/null | awk '/Collected/ { printf "%.1f", $NF / 1e6; n++ } END { exit !n }'
}

printf '%-6s %18s %18s   (millions; aim 25 and 8, wall and pole 2)\n' instr. process solver
for name in demo wall pole; do
    scene=$SRC/tests/bench/$name.json
    [ "$name" = demo ] && scene=$SRC/share/scenes/q7-fiat500.json
    whole=$(count "$scene") && solver=$(count "$scene" --toggle-collect=cr_solver_run) || exit 1
    printf '%-6s %18s %18s\n' "$name" "$whole" "$solver"
done
