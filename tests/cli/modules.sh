#!/bin/sh
# The words load no library of the screen, of pictures or of import before they need it; a module
# that is missing, broken or of another version is told.
. "$SRC/tests/cli/cli.sh"
[ -e "$BUILD/crumple-screen.so" ] && LD_DEBUG=files "$crumple" --version 2>&1 | grep -q libc.so || {
    echo "1..0 # SKIP built with --disable-shared, or the loader does not tell"
    exit 0
}

# loaded ARG ...: names of the libraries that the program comes to map
loaded() {
    LD_DEBUG=files LD_DEBUG_OUTPUT=$tmp/loader "$crumple" "$@" >"$tmp/out" 2>&1 </dev/null
    cat "$tmp"/loader.* | sed -n 's/.*calling init: .*\/\([^/]*\)$/\1/p'
    rm -f "$tmp"/loader.*
}
large='curses|tinfo|readline|cairo|sqlite|libzip|expat|crumple-'
wall_scene >"$tmp/small.json"
has "what is loaded is seen" "$(loaded --version)" '^libm\.so'
cd "$tmp" || exit 99
for words in --version models 'run small.json' 'stack small.json' 'mc --draws 2 small.json' \
    'run -p crash.svg small.json'; do
    # shellcheck disable=SC2086
    empty "crumple $words loads no large library" "$(loaded $words | grep -E "$large")"
done
echo 'load small.json; solve' >small.crumple
empty "nor does a command file" "$(loaded small.crumple | grep -E "$large")"
if "$crumple" --version | grep -q 'cairo [0-9]'; then
    got=$(loaded run -p crash.png small.json)
    has "a PNG loads cairo" "$got" '^libcairo'
    empty "and no terminal" "$(printf '%s\n' "$got" | grep -E 'curses|readline')"
    same "the PNG is one" "$(head -c 4 crash.png | tail -c 3)" PNG
fi
got=$(loaded import "$SRC/tests/data/none.csv")
has "import loads its module" "$got" '^crumple-import\.so'
empty "and no terminal either" "$(printf '%s\n' "$got" | grep -E 'curses|readline')"

mkdir bin
cp "$crumple" bin/crumple
CRUMPLE_DATA=$SRC
export CRUMPLE_DATA
crumple=$tmp/bin/crumple
module=bin/crumple-import.so
echo text >$module
refused "a broken module" 2 'error: cannot load a part .*import.so.*install all of it again' \
    import small.json
LC_ALL=C sed 's/0\.1\.0/0.0.9/g' "$BUILD/crumple-import.so" >$module
refused "a module of another version" 2 'import.so.*of another version' import small.json
rm $module
run import --help
if [ $status -eq 0 ]; then
    skip "a module that is missing" "crumple is installed here"
else
    has "a module that is missing" "$errs" 'import.so.*No such file.*install all of it again'
fi
mkdir -p libexec/crumple
cp "$BUILD/crumple-import.so" libexec/crumple/
run import --help
has "an installation that was moved has it" "$out" '^usage: crumple import'
finish
