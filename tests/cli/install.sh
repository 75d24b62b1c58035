#!/bin/sh
# The data folder: of the source tree in a build, of the installation once installed, never mixed.
. "$SRC/tests/cli/cli.sh"

MAKEFLAGS='' MFLAGS='' ${MAKE:-make} -s -C "$BUILD" install DESTDIR="$tmp/stage" \
    prefix=/opt/crumple >"$tmp/log" 2>&1
same "make install with DESTDIR" "$?" 0
prefix=$tmp/stage/opt/crumple
for file in bin/crumple share/man/man1/crumple.1 share/crumple/models/suv.json \
    share/crumple/share/scenes/q7-fiat500.json share/bash-completion/completions/crumple; do
    [ -f "$prefix/$file" ]
    report $? "installs $file"
done
missing=$(cd "$SRC" && find models share -type f ! -path 'share/completions/*' |
    while read -r file; do
        [ -f "$prefix/share/crumple/$file" ] || echo "$file"
    done)
empty "everything in models/ and share/ is installed" "$missing"

cd / || exit 99
want=$("$crumple" run "$demo" | cksum)
scene=$prefix/share/crumple/share/scenes/q7-fiat500.json
same "the installed program gives the same result" \
    "$("$prefix/bin/crumple" run "$scene" | cksum)" "$want"
mv "$prefix/share/crumple/models" "$prefix/share/crumple/gone"
crumple=$prefix/bin/crumple
if [ -d /opt/crumple/share/crumple ]; then
    skip "an installation does not use the source tree" "crumple is installed in /opt"
else
    refused "an installation does not use the source tree" 2 'error: no models/ and share/irf/ in' \
        run "$demo"
fi
CRUMPLE_DATA=$SRC
export CRUMPLE_DATA
same "CRUMPLE_DATA names another folder" "$("$crumple" run "$demo" | cksum)" "$want"
CRUMPLE_DATA=$tmp
refused "CRUMPLE_DATA that is none" 2 "no models/ and share/irf/ in $tmp .CRUMPLE_DATA" run "$demo"
finish
