#!/bin/sh
# No circles: the files of a folder stand one upon the other, none calls one that calls it back,
# however many lie between; and headers do not include each other in a ring.
. "$SRC/tests/tap.sh"
cd "$BUILD" || exit 99
NM=${NM:-nm}

if ! command -v "$NM" >/dev/null 2>&1; then
    echo "1..0 # SKIP no nm here"
    exit 0
fi

# lines "FROM TO NAME": which object of a library uses a name that which other one defines
calls() {
    $NM -A "lib$1.a" 2>/dev/null | sed -n 's/^[^:]*:\([^:]*\)\.o:[0-9a-f ]*\([A-Za-z]\) /\1 \2 /p' |
        sed "s/^lib$1_a-//" | awk '
            $2 == "U" { use[++n] = $1 " " $3; next }
            $2 ~ /[A-Z]/ { home[$3] = $1 }
            END {
                for (i = 1; i <= n; i++) {
                    split(use[i], u, " ")
                    if (u[2] in home && home[u[2]] != u[1]) print u[1], home[u[2]], u[2]
                }
            }'
}

# lines "FROM TO include": headers of a folder that include each other
includes() {
    grep -o '^#include "[^"]*\.h"' "$SRC/src/$1"/*.h /dev/null |
        sed -n "s#^.*/\([a-z_0-9]*\.h\):.include \"$1/\(.*\)\"#\1 \2 include#p"
}

# Of a list of edges "FROM TO WHY" those that lie in a circle: what nobody above needs is taken
# away from the top, what needs nobody below from the bottom, until nothing more can be taken.
circle() {
    awk '
        { from[NR] = $1; to[NR] = $2; why[NR] = $3; there[NR] = 1 }
        END {
            do {
                split("", needs)
                split("", needed)
                for (i in there) { needs[from[i]] = 1; needed[to[i]] = 1 }
                gone = 0
                for (i in there)
                    if (!(to[i] in needs) || !(from[i] in needed)) { delete there[i]; gone = 1 }
            } while (gone)
            for (i = 1; i <= NR; i++) if (i in there) print from[i], "->", to[i] ":", why[i]
        }'
}

for dir in "$SRC"/src/*/; do
    name=$(basename "$dir")
    empty "no file of $name calls one that calls it back" "$(calls "$name" | circle | head -n 20)"
    empty "no header of $name includes one that includes it" "$(includes "$name" | circle)"
done

[ "$(calls cmd | wc -l)" -gt 100 ]
report $? "and the calls between files are seen"
same "a circle is found when there is one" "$(printf 'a b x\nb c x\nc b y\nc d x\n' | circle)" \
    "$(printf 'b -> c: x\nc -> b: y')"
finish
