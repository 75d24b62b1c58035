#!/bin/sh
# Folder rules of HACKING.md: who may include whom, who sees cJSON, curses and readline.
. "$SRC/tests/tap.sh"
cd "$SRC" || exit 99

# rows "| `src/x/` | ... | a, b/c.h |" as lines "x: a b/c.h"
row='^| `src/\([a-z.]*\)/*` |.*| *\([^|]*[^| ]\) *|$'
table=$(sed -n "s#$row#\1: \2#p" HACKING.md | tr -d ',')

allowed() { # FOLDER HEADER
    dir=${2%%/*}
    [ "$dir" = "$1" ] && return 0
    case " $(printf '%s\n' "$table" | sed -n "s/^$1: //p") " in
    *" $dir "* | *" $2 "*) ;;
    *) return 1 ;;
    esac
    case $2 in
    *_priv.h) return 1 ;;
    esac
}

# lines "file:line:header" of the includes with quotes below a path
includes() {
    grep -rno --include='*.[ch]' --include='*.def' '^#include "[^"]*"' "$1" /dev/null |
        sed 's/#include "\(.*\)"/\1/'
}

broken() { # FOLDER PATH
    includes "$2" | while IFS=: read -r file line header; do
        case $header in
        config.h) case $file in *.h) echo "$file:$line: config.h in a header" ;; esac ;;
        */*) allowed "$1" "$header" || echo "$file:$line: $1 may not include $header" ;;
        *) echo "$file:$line: name the folder of $header" ;;
        esac
    done
}

rows=$(printf '%s\n' "$table" | wc -l)
[ "$rows" -eq "$(find src -mindepth 1 -maxdepth 1 ! -name '.*' | wc -l)" ]
report $? "the table of HACKING.md has a row for each folder and main.c"

for dir in src/*/ src/main.c; do
    empty "includes of $dir" "$(broken "$(basename "$dir")" "$dir")"
done

# the .c files that include a header, also through others
users() { # HEADER
    grep -ro --include='*.[ch]' '^#include "[^"]*"' src tests |
        sed 's#^src/##; s#^tests/[a-z]*/##; s#:.include "#" #; s#"##g' |
        awk -v header="$1" '
            { file[NR] = $1; included[NR] = $2 }
            END {
                reached[header] = 1
                for (more = 1; more;)
                    for (i = more = 0; i++ < NR;)
                        if (reached[included[i]] && !reached[file[i]]) more = reached[file[i]] = 1
                for (name in reached) if (name ~ /c$/) print name
            }'
}
case_users=$(users solver/case.h | wc -l)
[ "$case_users" -lt 60 ] && [ "$case_users" -gt 20 ]
report $? "fewer than 60 files are compiled anew when solver/case.h changes: $case_users"

all=$(grep -rnE --include='*.[ch]' '#include <(cjson|n?curses|ncursesw|term|panel|readline)' src)
outside() { # INCLUDE PATHS
    printf '%s\n' "$all" | grep -E "<$1" | grep -vE "^$2"
}
empty "cJSON is included in .c files only" "$(outside cjson '[^:]*\.c:')"
empty "curses is included in tui only" "$(outside '(n?curses|term|panel)' src/tui/)"
empty "readline is included in repl and tui only" "$(outside readline 'src/(repl|tui)/')"
finish
