#!/bin/sh
# The words load no library of the screen, of pictures or of import before they need it; a module
# that is missing, broken or of another version is told.
. "$SRC/tests/cli/cli.sh"
LD_DEBUG=files "$crumple" --version 2>&1 | grep -q 'libc\.so' && [ -e "$BUILD/crumple-screen.so" ] || {
    echo "1..0 # SKIP built with --disable-shared, or a loader that does not tell"
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
for word in --version --help 'run --format json' 'stack -j1' 'run -p crash.svg' 'mc --n 2' models; do
    # words with their options
    # shellcheck disable=SC2086
    case $word in --* | models) set -- $word ;; *) set -- $word "$tmp/small.json" ;; esac
    empty "crumple $word loads no large library" "$(cd "$tmp" && loaded "$@" | grep -E "$large")"
done
printf 'load %s\nsolve\nquit!\n' "$tmp/small.json" >"$tmp/small.crumple"
empty "nor does a command file" "$(loaded "$tmp/small.crumple" | grep -E "$large")"
if "$crumple" --version | grep -q 'cairo [0-9]'; then
    got=$(cd "$tmp" && loaded run -p crash.png "$tmp/small.json")
    has "a PNG loads cairo" "$got" '^libcairo'
    empty "and no terminal" "$(printf '%s\n' "$got" | grep -E 'curses|readline')"
    same "the PNG is one" "$(head -c 4 "$tmp/crash.png" | tail -c 3)" PNG
fi
got=$(loaded import "$SRC/tests/data/none.csv")
has "import loads its module" "$got" '^crumple-import\.so'
empty "and no terminal either" "$(printf '%s\n' "$got" | grep -E 'curses|readline')"

mkdir "$tmp/bin"
cp "$crumple" "$tmp/bin/crumple"
CRUMPLE_DATA=$SRC
export CRUMPLE_DATA
crumple=$tmp/bin/crumple
module=$tmp/bin/crumple-import.so
echo text >"$module"
refused "a broken module" 2 'error: cannot load a part of the program: .*crumple-import.so.*install all of it again' \
    import "$tmp/small.json"
LC_ALL=C sed 's/0\.1\.0/0.0.9/g' "$BUILD/crumple-import.so" >"$module"
refused "a module of another version" 2 'crumple-import.so.*of another version' import "$tmp/small.json"
rm "$module"
"$crumple" import --help >"$tmp/out" 2>"$tmp/errs"
case $? in
0) skip "a module that is missing" "crumple is installed here" ;;
*) has "a module that is missing" "$(cat "$tmp/errs")" 'crumple-import.so.*No such file.*install all' ;;
esac
mkdir -p "$tmp/libexec/crumple"
cp "$BUILD/crumple-import.so" "$tmp/libexec/crumple/"
same "an installation that was moved has it" "$("$crumple" import --help | head -n 1 | cut -c 1-21)" \
    'usage: crumple import'
finish
