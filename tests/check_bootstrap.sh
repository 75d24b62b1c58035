#!/bin/sh
# ./bootstrap on a machine that lacks everything: what it says, installs and refuses. The machine is
# a folder of links to the few tools that every system has, and stand-ins for apt-get, sudo and id.
. "$SRC/tests/tap.sh"
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
mkdir "$tmp/tree" "$tmp/whole" "$tmp/bare" "$tmp/apt" "$tmp/root" "$tmp/user" "$tmp/sudo"
cp "$SRC/bootstrap" "$tmp/tree/"
for tool in sh dirname cat grep find head env mkdir rm sed; do
    ln -s "$(command -v "$tool")" "$tmp/bare/$tool"
done
echo 'echo 0' >"$tmp/root/id"
echo 'echo 1000' >"$tmp/user/id"
echo 'echo "apt-get $DEBIAN_FRONTEND $*" >>"$LOG"' >"$tmp/apt/apt-get"
printf 'echo "sudo $*" >>"$LOG"\nexec "$@"\n' >"$tmp/sudo/sudo"
for file in root/id user/id apt/apt-get sudo/sudo; do
    sed -i '1s|^|#!/bin/sh\n|' "$tmp/$file"
    chmod +x "$tmp/$file"
done
for tool in gcc make pkg-config automake autoreconf; do
    printf '#!/bin/sh\n[ %s != autoreconf ]\n' $tool >"$tmp/whole/$tool"
    chmod +x "$tmp/whole/$tool"
done
LOG=$tmp/log
export LOG

# on FOLDERS WORD: run with the folders of $tmp as PATH; $out, $status, $log
on() {
    path=
    for dir in $1; do
        path=$path$tmp/$dir:
    done
    : >"$LOG"
    out=$(cd / && PATH=${path%:} "$tmp/tree/bootstrap" "$2" 2>&1 </dev/null)
    status=$?
    log=$(cat "$LOG")
}

on "bare root" build
same "without apt-get the status is 2" "$status" 2
has "and all that is missing is named" "$out" \
    'gcc .*make .*pkg-config .*libncurses-dev .*readline-dev .*cjson-dev .*nettle-dev .*autoconf'
has "and why it stops" "$out" 'there is no apt-get'
same "a build does not need what only the tests need" "$(echo "$out" | grep -c cmocka)" 0
on "bare root" check
has "the tests need CMocka, too" "$out" 'libcmocka-dev'

on "bare user apt" build
same "neither root nor sudo: status 2" "$status" 2
has "and the command to run as root" "$out" 'as root run: apt-get install .*gcc'
same "and nothing was tried" "$log" ""

on "bare root apt" demo
has "root installs without sudo" "$log" \
    '^apt-get noninteractive .*install --no-install-recommends .*gcc'
same "and sudo is not asked" "$(echo "$log" | grep -c sudo)" 0
has "it says what it installs" "$out" 'installing with apt-get: .*gcc.* libcjson-dev'
on "bare user apt sudo" build
has "others install by way of sudo" "$log" \
    '^sudo env DEBIAN_FRONTEND=noninteractive apt-get .*install .*gcc'

# one that has all that is needed, but whose apt-get knows none of what can be left out
mkdir "$tmp/poor"
cat >"$tmp/poor/apt-get" <<'END'
#!/bin/sh
echo "apt-get $*" >>"$LOG"
case $* in *gsl* | *nlopt* | *expat*) exit 100 ;; esac
END
chmod +x "$tmp/poor/apt-get"
on "bare root poor" build
has "it goes on without what cannot be had" "$out" 'going on without.*: libgsl-dev libnlopt-dev'
same "but not without what can" "$(echo "$out" | grep 'going on' | grep -c 'sqlite\|cairo')" 0
has "which is installed by itself" "$log" 'install --no-install-recommends libsqlite3-dev$'
on "bare root" build
same "and needs come first" "$(echo "$out" | grep -c 'going on')" 0

# a machine that has everything but an autoreconf that works, and a clock that was set back
for file in late build/late; do
    mkdir -p "$tmp/tree/build"
    touch -t 209901010000 "$tmp/tree/$file"
done
ln -s "$(command -v touch)" "$tmp/bare/"
on "bare root whole" build
has "a step that fails is told" "$out" 'failed: autoreconf'
touch "$tmp/now"
same "before it, files of the future are made those of today" \
    "$(find "$tmp/tree" -newer "$tmp/now")" ""
[ ! -e "$tmp/tree/build/late" ]
report $? "and what was built in the future goes"

on "bare root" --help
same "--help succeeds" "$status" 0
has "and explains demo" "$out" 'demo +build, then solve'
on "bare root" dmeo
same "an unknown word is refused" "$status" 2
finish
