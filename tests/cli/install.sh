#!/bin/sh
# The data folder: of the source tree in a build, of the installation once installed, never mixed.
. "$SRC/tests/cli/cli.sh"

MAKEFLAGS='' MFLAGS='' ${MAKE:-make} -s -C "$BUILD" install DESTDIR="$tmp/stage" \
    prefix=/opt/crumple >"$tmp/log" 2>&1
same "make install with DESTDIR" "$?" 0
prefix=$tmp/stage/opt/crumple
for file in bin/crumple share/man/man1/crumple.1 share/crumple/models/suv.json \
    share/crumple/scenes/q7-fiat500.json share/bash-completion/completions/crumple \
    share/man/man3/libcrumple.3 share/doc/crumple/method.md; do
    [ -f "$prefix/$file" ]
    report $? "installs $file"
done
missing=$(cd "$SRC" && find models share -type f ! -path 'share/completions/*' \
    ! -path 'share/desktop/*' |
    while read -r file; do
        part=${file#share/}
        [ -f "$prefix/share/crumple/$part" ] || [ -f "$prefix/share/doc/crumple/${part#doc/}" ] ||
            echo "$file"
    done)
empty "everything in models/ and share/ is installed" "$missing"

cd / || exit 99
want=$("$crumple" run "$demo" | cksum)
scene=$prefix/share/crumple/scenes/q7-fiat500.json
same "the installed program gives the same result" \
    "$("$prefix/bin/crumple" run "$scene" | cksum)" "$want"
same "a lesson is found by the name it has in the source tree" \
    "$("$prefix/bin/crumple" share/tutorial/1-first-crash.crumple | head -n 1 | cut -c 1-10)" \
    "# Lesson 1"
if [ -f "$BUILD/libcrumple.so" ]; then
    got=$(MAKEFLAGS='' MFLAGS='' ${MAKE:-make} -s -C "$BUILD" installcheck DESTDIR="$tmp/stage" \
        prefix=/opt/crumple 2>&1)
    same "make installcheck" "$?" 0
    has "a user of the installed library solves" "$got" '^crumple [0-9.]*: EES [0-9]+\.[0-9] km/h$'
else
    skip "make installcheck" "no shared library was built"
fi
if [ -e "$BUILD/crumple-import.so" ]; then
    same "the installed program finds its modules" \
        "$("$prefix/bin/crumple" import --help | head -n 1 | cut -c 1-21)" 'usage: crumple import'
fi
if strip -o "$tmp/stripped" "$prefix/bin/crumple" 2>/dev/null; then
    for file in "$prefix/bin/crumple" "$prefix"/libexec/crumple/*.so; do
        [ ! -e "$file" ] || strip -o "$tmp/stripped" "$file"
        empty "no path of the build is in ${file##*/}" "$(strings "$tmp/stripped" | grep -F "$SRC")"
    done
else
    skip "no path of the build is in the program" "no strip here"
fi
mv "$prefix/share/crumple/models" "$prefix/share/crumple/gone"
crumple=$prefix/bin/crumple
if [ -d /opt/crumple/share/crumple ]; then
    skip "an installation does not use the source tree" "crumple is installed in /opt"
else
    refused "an installation does not use the source tree" 2 'error: no models/ and irf/ in' \
        run "$demo"
fi
CRUMPLE_DATA=$SRC
export CRUMPLE_DATA
same "CRUMPLE_DATA names another folder" "$("$crumple" run "$demo" | cksum)" "$want"
CRUMPLE_DATA=$tmp
refused "CRUMPLE_DATA that is none" 2 "no models/ and irf/ in $tmp .CRUMPLE_DATA" run "$demo"
finish
