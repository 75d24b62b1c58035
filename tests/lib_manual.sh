#!/bin/sh
# The manual page of the library, libcrumple(3), made from the comments of its header: the first one
# is the description, every other one explains the declaration below it. Usage: lib_manual.sh HEADER
set -u
HEAD='.TH LIBCRUMPLE 3 2026-11-28 "crumple 0.1.0" "Library Functions"
.SH NAME
libcrumple \- vehicle crashes by EES voxel models, from C and C++
.SH SYNOPSIS
.nf
#include <crumple.h>

cc prog.c $(pkg\-config \-\-cflags \-\-libs crumple)
.fi
'
FOOT='.SH ENVIRONMENT
.TP
.B CRUMPLE_DATA
The data folder, where
.B crumple_open
is given none.
.SH EXAMPLES
.nf
crumple *lib;
crumple_result *result;
crumple_error err = CRUMPLE_ERROR_INIT;
double ees;
if (crumple_open(NULL, &lib, &err) != CRUMPLE_OK ||
    crumple_solve(lib, scene, strlen(scene), NULL, &result, &err) != CRUMPLE_OK) {
    errx(1, "%s: %s (%s)", err.where, err.text, err.hint);
}
crumple_value(result, "A.ees_kmh", &ees);
.fi
.SH SEE ALSO
.BR crumple (1)
'
export HEAD FOOT
awk '
    function roff(s) {
        gsub(/\\/, "\\e", s)
        gsub(/-/, "\\-", s)
        sub(/^[.\047]/, "\\\\\\&&", s)
        return s
    }
    # the name that a declaration brings
    function name_of(s) {
        if (s ~ /^enum/) { sub(/ *\{.*/, "", s); return s }
        if (match(s, /\(\*[a-z_]+\)/)) return substr(s, RSTART + 2, RLENGTH - 3)
        if (match(s, /struct [a-z_]+ \{/)) return substr(s, RSTART + 7, RLENGTH - 9)
        if (match(s, /crumple_[a-z_]+\(/)) return substr(s, RSTART, RLENGTH - 1)
        return ""
    }
    function flush(   i, name) {
        for (i = 1; i <= lines; i++) {
            if (decl[i] != "") name = name == "" ? name_of(decl[i]) : name
        }
        if (lines && name != "") {
            printf ".SS %s\n.nf\n", roff(name)
            for (i = 1; i <= lines; i++) if (decl[i] != "") print roff(decl[i])
            print ".fi\n.PP"
            printf "%s", text
        }
        lines = 0
        text = ""
    }
    BEGIN {
        print ".\\\" made from crumple.h by make update-manual; do not edit"
    }
    skip { skip = /\\$/; next }
    /^#define/ { skip = /\\$/; next }
    /^#/ || /^}$/ || /^extern "C"/ || /^typedef struct [a-z_]+ [a-z_]+;$/ { next }
    /^\/\*/ && first != 2 { comment = 1; if (first) flush(); else first = 1 }
    comment {
        line = $0
        over = sub(/ *\*\/$/, "", line)
        sub(/^(\/\*| \*) ?/, "", line)
        text = text (line == "" ? ".PP\n" : roff(line) "\n")
        if (over) {
            comment = 0
            if (!described) {
                described = 1
                head = text
                text = ""
                printf "%s.SH DESCRIPTION\n%s.SH INTERFACE\n", ENVIRON["HEAD"], head
            }
        }
        next
    }
    NF || lines { sub(/^CRUMPLE_API /, ""); decl[++lines] = $0 }
    END {
        flush()
        printf "%s", ENVIRON["FOOT"]
    }' "$1"
