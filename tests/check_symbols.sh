#!/bin/sh
# What the libraries export, keep and call: prefix cr_, no mutable globals, no output, exit,
# environment or clock below cmd, no files in the solver, no bits of one C library in a result.
. "$SRC/tests/tap.sh"
cd "$BUILD" || exit 99
NM=${NM:-nm}
core="base model solver scene result render figure"

if ! command -v "$NM" >/dev/null 2>&1 || ! command -v objdump >/dev/null 2>&1; then
    echo "1..0 # SKIP no nm or objdump here"
    exit 0
fi

for lib in $core process lib cmd repl tui cli trial; do
    lib=lib$lib.a
    foreign=$($NM -g --defined-only "$lib" 2>/dev/null |
        awk 'NF == 3 && $3 !~ /^(cr_|crumple_|_)/ { print $3 }')
    empty "exported names of $lib begin with cr_" "$foreign"
done

# libcrumple gives away the names of its header and nothing else
if [ -f libcrumple.so ]; then
    want=$(sed -n 's/^CRUMPLE_API .*[ *]\(crumple_[a-z_]*\)(.*/\1/p' "$SRC/src/lib/crumple.h")
    want=$(printf '%s\n' "$want" | sort)
    # those of sanitizers begin with _
    got=$($NM -D --defined-only libcrumple.so | awk '$NF !~ /^_/ { print $NF }' | sort)
    same "libcrumple.so exports what its header declares" "$got" "$want"
    needs=$(objdump -p libcrumple.so | awk '$1 == "NEEDED" { print $2 }')
    empty "libcrumple.so needs no terminal" \
        "$(printf '%s\n' "$needs" | grep -E 'curses|readline|tinfo')"
else
    skip "libcrumple.so exports what its header declares" "no shared library was built"
fi

# calls LIBRARY NAMES: undefined symbols among the names, fortified ones read as the plain ones
calls() {
    $NM -u -A "lib$1.a" 2>/dev/null | sed 's/ __\([a-z_]*\)_chk$/ \1/' |
        awk -v p="^($2)\$" '$NF ~ p { print $1, $NF }'
}

edge='printf|fprintf|vprintf|vfprintf|dprintf|puts|fputs|fputc|putc|putchar|fwrite|perror|exit'
edge="$edge|_exit|quick_exit|getenv|secure_getenv|setenv|time|clock|clock_gettime|gettimeofday"
edge="$edge|localtime|localtime_r|gmtime|rand|srand|random|drand48|setlocale|signal|sigaction"
for name in $core; do
    empty "$name neither prints nor exits nor asks environment or clock" "$(calls "$name" "$edge")"
done
empty "the solver opens no files" \
    "$(calls solver 'open|openat|read|write|fopen|fread|fscanf|mmap|socket')"

# What IEEE 754 does not round, and C libraries therefore each in their own way, are
# src/base/elementary.c's to compute (sqrt, fmod, remainder, floor and their like are exact). No
# result hangs on the exceptions: stats.o has a sign test, diff.o half of a last decimal, rating.o
# the progression of CORA.
inexact='a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p)?|pow|hypot|cbrt|erfc?|[lt]gamma'
for name in base model solver scene result; do
    empty "$name asks the C library for nothing that it rounds in its own way" \
        "$(calls "$name" "($inexact)[fl]?" | grep -vE '[:-](stats|diff|rating)\.o: (exp|log|pow)$')"
done

# symbols in sections that a program can write; those of sanitizers and gcov begin with _ or a dot
writable() {
    objdump -t "lib$1.a" 2>/dev/null |
        awk 'NF > 4 && $(NF - 2) ~ /^\.(data|bss|tdata|tbss)/ && $(NF - 2) !~ /\.ro/ &&
             $NF !~ /^[._*]/ { print $(NF - 2), $NF }'
}
for name in $core; do
    empty "$name has no mutable globals" "$(writable "$name")"
done
finish
