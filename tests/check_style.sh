#!/bin/sh
# Style rules of HACKING.md that a script can see.
. "$SRC/tests/tap.sh"
cd "$SRC" || exit 99
LC_ALL=C.UTF-8
export LC_ALL

# no file of the tree has a blank in its name, so these lists may be split into words
# shellcheck disable=SC2046
set -- $(find src tests -name '*.[ch]' | sort)
text=$(find src tests -name '*.[ch]' -o -name '*.def' -o -name '*.sh')
headers=$(find src -name '*.h')

empty "no file is longer than 600 lines" \
    "$(wc -l "$@" | awk '$2 != "total" && $1 > 600 { print $2 ": " $1 " lines" }')"

# a definition starts at column 0 and ends with a brace alone at column 0
empty "no function is longer than 50 lines" "$(awk '
    FNR == 1 || /^};/ { start = 0 }
    /^[A-Za-z_].*\(/ && !start { start = FNR; name = $0 }
    /^[A-Za-z_ ].*\);$/ && FNR - start < 5 { start = 0 }
    /^}$/ {
        if (start && FNR - start + 1 > 50)
            print FILENAME ":" start ": " FNR - start + 1 " lines: " name
        start = 0
    }' "$@")"

# shellcheck disable=SC2086
{
    empty "no line is wider than 100 columns" "$(grep -nE '^.{101,}' $text bootstrap)"
    empty "no blanks at the end of a line" "$(grep -nE '[[:space:]]+$' $text bootstrap)"
    empty "nothing is left to do" \
        "$(grep -nwE 'TODO|FIXME|XXX' $text bootstrap | grep -v '^tests/check_style.sh:')"
}
empty "no tabs in C" "$(grep -nP '\t' "$@")"
empty "at most 4 levels of nesting" \
    "$(grep -nE '^ {20,}(if|for|while|switch|do|return|break|continue|goto)\b' "$@")"
empty "a brace after every if and for" \
    "$(grep -nE '^ *(\} else )?(if|for) \(.*\)( [^{]*)?;$' "$@" | grep -vE '//|\*')"
# what memory was out for must not be missing without a word: base/tree.h, cr_str_join, cr_say_str
empty "no member of a JSON tree is added unchecked" \
    "$(grep -nE '^ *(\(void\) ?)?cJSON_Add.*\);$' "$@" | grep -v '^tests/')"
empty "no text in parts loses its failure" "$(grep -nE \
    'cr_str_add\(.*cr_str_get|cr_say\(.*"%s", cr_str_get|cr_session_lines\(.*cr_str_get' "$@")"
empty "no file is written with a text that memory was out for" \
    "$(grep -nE 'cr_file_write\([^,]*, cr_str_get' "$@" | grep -v '^src/base/file.c:')"
empty "no unbounded or unchecked C library calls" \
    "$(grep -nE '\b(alloca|gets|strcat|sprintf|vsprintf|atoi|atof|strtok) *\(' "$@")"

# One dialect.
empty "the variable of an error is called code" "$(grep -nE 'enum cr_err rc\b' "$@")"
empty "texts are compared with == 0" "$(grep -nE '!(str|mem)n?(case)?cmp\(' "$@")"
empty "comments are /* */" "$(grep -nE '(^|[;{},]) *// ' "$@")"
empty "constants have names in lower case" "$(
    grep -nE '^[^=]*[ *}][A-Z][A-Z_0-9]*(\[[^]]*\])+ = \{' "$@"
    grep -nE '^ *static const [a-z_ ]*([*] ?(const )?)?[A-Z][A-Z_0-9]*(\[.*\])* =' "$@"
)"
# Parameters are counted by the commas outside of inner parentheses, up to the brace. The interface
# of the library, crumple_NAME, is what programs were compiled against.
empty "no function has seven parameters or more" "$(awk '
    FNR == 1 { text = "" }
    /^[A-Za-z_].*\(/ { text = ""; start = FNR }
    { text = text " " $0 }
    /[;}]$/ && !/^ / { text = "" }
    /\{$/ && text ~ /^ [A-Za-z_][A-Za-z_0-9 *]*\(.*\) \{$/ && text !~ / crumple_/ {
        depth = 0
        n = 1
        for (i = 1; i <= length(text); i++) {
            c = substr(text, i, 1)
            if (c ~ /[([{]/) depth++
            if (c ~ /[])}]/) depth--
            if (c == "," && depth == 1) n++
        }
        if (n > 6) print FILENAME ":" start ": " n
        text = ""
    }' "$@")"

unguarded=$(for file in $headers; do
    guard=$(basename "$file" | tr 'a-z.' 'A-Z_')
    grep -q "^#ifndef CR_[A-Z0-9_]*$guard\$" "$file" || echo "$file: no CR_..._$guard"
done)
empty "include guards are named after the file" "$unguarded"
purposeless=$(for file in $headers; do
    head -n 1 "$file" | grep -q '^/\* .' || echo "$file"
done)
empty "every header begins with its purpose" "$purposeless"

empty "no path of somebody's machine" "$(grep -rnIE '(^|[^a-z.~])/(work|home|root)/[a-z]' \
    src tests models share man README.md HACKING.md NEWS | grep -v '^tests/check_style.sh:' |
    cut -c 1-120)"

# other versions format differently; 14 is the one the tree is kept with
if clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
    empty "clang-format has nothing to change" \
        "$(clang-format --dry-run "$@" 2>&1 | sed -n 's/:.* warning: .*//p' | sort | uniq -c)"
else
    skip "clang-format has nothing to change" "no clang-format 14"
fi
finish
