#!/bin/sh
# Every example of README.md and crumple.1 runs, and shows what the program prints; the programs of
# README.md in C, Python and R have ten lines at most and print what is shown below them.
# "check_examples.sh update" puts the present output into README.md: review the difference.
. "$SRC/tests/tap.sh"
tmp=$(mktemp -d) || exit 99
trap 'rm -rf "$tmp"' EXIT
ln -s "$SRC/share" "$SRC/models" "$tmp"
ln -s "$BUILD" "$tmp/build"
ln -s "$SRC/bindings/crumple.R" "$tmp"
PATH=$BUILD:$PATH
COLUMNS=80
export PATH COLUMNS

# README: fences "console"; man page: .EX ... .EE with roff's escapes undone
awk '/^```console$/ { on = 1; next } /^```$/ { on = 0 } on { print }' "$SRC/README.md" \
    >"$tmp/readme"
awk '/^\.EX$/ { on = 1; next } /^\.EE$/ { on = 0 } on { print }' "$SRC/man/crumple.1" |
    sed 's/\\-/-/g; s/\\e/\\/g' >"$tmp/man"

# split FILE: each "$ command" (going on in lines "> ...") into FILE.1.cmd, what follows it into
# FILE.1.out, and so on
split() {
    awk -v f="$1" '/^\$ / { n++
                            head = 1
                            print substr($0, 3) >(f "." n ".cmd")
                            printf "" >(f "." n ".out")
                            next }
                   head && /^> / { print substr($0, 3) >(f "." n ".cmd"); next }
                   n { head = 0; print >(f "." n ".out") }' "$1"
}

# alike WANT GOT: equal but for pictures (lines that are not ASCII), blank lines, and numbers that
# differ by less than a tenth: better physics should not need a new README each time; a line "..."
# stands for any lines
alike() {
    LC_ALL=C awk '
        function number(t) { return t ~ /^[-+]?[0-9]+(\.[0-9]*)?[,;]?$/ }
        function near(x, y,   d, m) {
            d = x > y ? x - y : y - x
            m = (x < 0 ? -x : x) > (y < 0 ? -y : y) ? (x < 0 ? -x : x) : (y < 0 ? -y : y)
            return d <= m / 10 + (m < 1 ? 0.3 : 1)
        }
        function line_alike(w, g,   a, b, i, n) {
            n = split(w, a, " ")
            if (split(g, b, " ") != n) return 0
            for (i = 1; i <= n; i++) {
                if (a[i] == b[i]) continue
                if (!number(a[i]) || !number(b[i]) || !near(a[i] + 0, b[i] + 0)) return 0
            }
            return 1
        }
        function match_from(i, j) {
            for (; i <= n; i++) {
                if (want[i] == "...") {
                    for (; j <= m + 1; j++) if (match_from(i + 1, j)) return 1
                    return 0
                }
                if (j > m || !line_alike(want[i], got[j])) return 0
                j++
            }
            return j == m + 1
        }
        /[\200-\377]/ || /^[ \t]*$/ { next }
        FILENAME == ARGV[1] { want[++n] = $0; next }
        { got[++m] = $0 }
        END { exit !match_from(1, 1) }' "$1" "$2"
}

examples() { # FILE
    split "$tmp/$1"
    for cmd in "$tmp/$1".*.cmd; do
        base=${cmd%.cmd}
        (cd "$tmp" && sh "$cmd") >"$base.got" 2>&1 </dev/null
        report $? "$1: $(head -n 1 "$cmd")"
        [ -s "$base.out" ] || continue
        alike "$base.out" "$base.got"
        good=$?
        report $good "$1 shows what it prints (else: make update-examples)"
        [ $good -eq 0 ] || diff "$base.out" "$base.got" | explain
    done
}

# the output of each example of README.md as it is today; one that is shown in part (with a line
# "...") is left as it is
update() {
    awk -v dir="$tmp" '
        function flush(   line, script) {
            if (cmd != "" && old !~ /(^|\n)\.\.\.\n/) {
                script = dir "/example"
                printf "cd %s\n%s", dir, cmd >script
                close(script)
                while ((("sh " script " 2>&1 </dev/null") | getline line) > 0) print line
                close("sh " script " 2>&1 </dev/null")
            } else {
                printf "%s", old
            }
            cmd = old = ""
        }
        /^```console$/ { on = 1; print; next }
        on && (/^\$ / || /^```$/) {
            flush()
            print
            head = on = !/^```/
            cmd = on ? substr($0, 3) "\n" : ""
            next
        }
        on && head && /^> / { print; cmd = cmd substr($0, 3) "\n"; next }
        on && cmd != "" { head = 0; old = old $0 "\n"; next }
        { print }' "$SRC/README.md" >"$tmp/new" && cat "$tmp/new" >"$SRC/README.md"
}

# runs COMMAND PROGRAM: what it prints is what is shown, up to a tenth of its numbers
runs() {
    (cd "$tmp" && CRUMPLE_DATA=$SRC CRUMPLE_LIBRARY=$BUILD/libcrumple.so.0 LD_LIBRARY_PATH=$BUILD \
        PYTHONPATH=$SRC/bindings PYTHONDONTWRITEBYTECODE=1 sh -c "$1") \
        >"$tmp/got" 2>&1 <"$tmp/pole.json"
    report $? "README.md: the program in $2 runs"
    [ "$(wc -l <"$tmp/program.$2")" -le 10 ]
    report $? "it has ten lines at most"
    alike "$tmp/program.$2.out" "$tmp/got"
    good=$?
    report $good "and prints what is shown"
    [ $good -eq 0 ] || diff "$tmp/program.$2.out" "$tmp/got" | explain
}

# the fences of C, Python and R, each with the fence "text" below it
programs() {
    awk -v f="$tmp/program." '/^```(c|python|r)$/ { kind = substr($0, 4); file = f kind; next }
        /^```text$/ && kind != "" { file = f kind ".out"; kind = ""; next }
        /^```/ { file = "" }
        file != "" { print >file }' "$SRC/README.md"
    sed -n '/^$ cat >pole.json/,/^> END$/s/^> \([^E].*\)/\1/p' "$SRC/README.md" >"$tmp/pole.json"
    if [ ! -f "$BUILD/libcrumple.so" ] || "$CRUMPLE" --version | grep -q '^sanitizers: [^n]'; then
        skip "programs in C and Python" "no shared library, or one with sanitizers"
    else
        flags=$(PKG_CONFIG_PATH=$BUILD pkg-config --define-variable=libdir="$BUILD" \
            --define-variable=includedir="$SRC/src/lib" --cflags --libs crumple)
        runs "cc -x c program.c -x none $flags -o program && ./program" c
        if python3 -c 'import sys; sys.exit(sys.version_info < (3, 8))' 2>/dev/null; then
            runs "python3 program.python" python
        else
            skip "the program in Python" "no python3 here"
        fi
    fi
    if Rscript -e 'library(jsonlite)' >/dev/null 2>&1; then
        runs "Rscript program.r" r
    else
        skip "the program in R" "no R with jsonlite here"
    fi
}

if [ "${1:-}" = update ]; then
    update
    exit
fi
examples readme
examples man
programs
finish
