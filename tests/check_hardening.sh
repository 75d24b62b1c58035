#!/bin/sh
# The program is built so that a fault of memory is hard to use: PIE, full RELRO, stack protector,
# FORTIFY, no stack that runs code.
. "$SRC/tests/tap.sh"
readelf --version >/dev/null 2>&1 || {
    echo "1..0 # SKIP no readelf here"
    exit 0
}
grep -q "^enable_hardening='yes'" "$BUILD/config.log" &&
    "$CRUMPLE" --version | grep -q 'sanitizers: no' &&
    ! grep -q -e '--coverage' "$BUILD/Makefile" || {
    echo "1..0 # SKIP built with sanitizers, for coverage or with --disable-hardening"
    exit 0
}
LC_ALL=C
export LC_ALL
cd "$BUILD" || exit 99

# hardened FILE
hardened() {
    readelf -hldW "$1" >told 2>&1
    readelf -sW "$1" >symbols 2>&1
    has "$1: its place in memory is not fixed" "$(grep 'Type:' told)" 'DYN'
    has "$1: relocations are read-only" "$(grep 'GNU_RELRO' told)" 'GNU_RELRO'
    has "$1: all of them, as all are bound at the start" "$(grep -E 'FLAGS|BIND_NOW' told)" 'NOW'
    has "$1: its stack runs no code" "$(grep 'GNU_STACK' told)" ' RW '
    has "$1: stacks are guarded" "$(grep '__stack_chk_fail' symbols)" '__stack_chk_fail'
    case $(grep '^CFLAGS = ' Makefile) in
    *-O[123s]*)
        has "$1: lengths are checked" "$(grep -E '__[a-z]+_chk' symbols)" '__(mem|v?sn?pr|str)'
        ;;
    *) skip "$1: lengths are checked" "nothing is optimised here" ;;
    esac
    rm -f told symbols
}
hardened crumple
for file in libcrumple.so.0.0.0 crumple-*.so; do
    [ ! -e "$file" ] || hardened "$file"
done
finish
