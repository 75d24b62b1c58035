#!/bin/sh
# The library from Python, the program from R and as a coprocess.
. "$SRC/tests/cli/cli.sh"
CRUMPLE_LIBRARY=$BUILD/libcrumple.so.0
CRUMPLE_DATA=$SRC
export CRUMPLE_LIBRARY CRUMPLE_DATA

# python NAME COMMAND: the tests of solve.py with this python
python() {
    if ! command -v "$2" >/dev/null 2>&1; then
        skip "$1" "no $2 here"
    elif ! "$2" -c 'import sys; sys.exit(sys.version_info < (3, 8))' 2>/dev/null; then
        skip "$1" "this python is older than 3.8"
    elif [ ! -e "$CRUMPLE_LIBRARY" ]; then
        skip "$1" "no shared library was built"
    elif "$crumple" --version | grep -q '^sanitizers: [^n]'; then
        skip "$1" "python cannot load a library with sanitizers"
    else
        log=$("$2" "$SRC/tests/bindings/solve.py" "$SRC" 2>&1)
        report $? "$1"
        printf '%s\n' "$log" | explain
    fi
}
python "the library from Python" python3
# one that has numpy and pandas, where the first one has not
if ! python3 -c 'import numpy, pandas' 2>/dev/null && [ -x /usr/bin/python3 ] &&
    /usr/bin/python3 -c 'import numpy, pandas' 2>/dev/null; then
    python "the library from Python with numpy and pandas" /usr/bin/python3
else
    skip "the library from Python with numpy and pandas" "there is no other python with both"
fi

[ "$(wc -l <"$SRC/bindings/crumple.R")" -le 60 ]
report $? "R has no more than 60 lines"
if Rscript -e 'library(jsonlite)' >/dev/null 2>&1; then
    cat >"$tmp/test.R" <<'END'
source(file.path(Sys.getenv("SRC"), "bindings", "crumple.R"))
options(crumple = Sys.getenv("CRUMPLE"))
scene <- jsonlite::fromJSON(file.path(Sys.getenv("SRC"), "share/scenes/wall-56.json"),
                            simplifyVector = FALSE)
at <- function(v) { scene$participants[[1]]$speed_kmh <<- v; scene }
r <- crumple_solve(at(40), set = "restitution=0")
stopifnot(abs(crumple_value(r, "A.delta_v_kmh") - 40) < 0.5, length(r$trace$t_s) > 10,
          r$contacts[[1]]$restitution == 0,
          r$participants$A$ees_kmh == crumple_value(r, "A.ees_kmh"),
          crumple_value(r, "A.injury.gidas-mais2.probability") > 0,
          is.na(crumple_value(r, "A.colour")))
d <- crumple_solve_many(list(at(30), at(40), list(crumple = 1)), c("A.ees_kmh", "A.cdc"))
stopifnot(identical(d$index, 0:2), identical(names(d)[4:6], c("A.ees_kmh", "A.cdc", "error")))
stopifnot(nrow(d) == 3, d$A.ees_kmh[1] < d$A.ees_kmh[2], is.na(d$A.ees_kmh[3]), !is.na(d$error[3]))
one <- crumple_solve(at(40), trace = FALSE)
stopifnot(is.null(one$trace), identical(crumple_value(one, "A.ees_kmh"), d$A.ees_kmh[2]),
          identical(crumple_solve(at(40), set = "A.speed_kmh=40")$participants, one$participants))
bad <- tryCatch(crumple_solve(list(crumple = 1)), error = conditionMessage)
again <- crumple_solve(at(30))
stopifnot(grepl("participants", bad), crumple_value(again, "A.ees_kmh") == d$A.ees_kmh[1],
          length(again$trace$t_s) > 10)
# a model of its own beside the scene, whose folder is not that of R
own <- at(40)
own$source <- list(file = "crash.csv")
own$participants[[1]]$model <- list(file = "own.json")
folder <- file.path(Sys.getenv("TMP"), "R & more")
dir.create(folder)
writeLines(jsonlite::toJSON(own, auto_unbox = TRUE, digits = NA), file.path(folder, "scene.json"))
to <- shQuote(file.path(folder, "own.json"))
system2(Sys.getenv("CRUMPLE"), c("models", "compact/12", "--flat", "--to", to))
there <- crumple_solve(file.path(folder, "scene.json"))
many <- crumple_solve_many(list(file.path(folder, "scene.json")), "A.ees_kmh")
stopifnot(identical(many$A.ees_kmh, crumple_value(there, "A.ees_kmh")), is.na(many$error))
message <- tryCatch(crumple_solve("/nowhere.json"), error = conditionMessage)
stopifnot(grepl("nowhere", message))
options(crumple = "/nowhere/crumple")
.crumple_running$"--trace" <- NULL
message <- tryCatch(crumple_solve(at(30)), error = conditionMessage)
stopifnot(grepl("does not run", message))
END
    log=$(TMP=$tmp SRC=$SRC CRUMPLE=$crumple Rscript "$tmp/test.R" 2>&1)
    report $? "the program from R"
    printf '%s\n' "$log" | explain
else
    skip "the program from R" "no R with jsonlite here"
fi

# a program may wait for each answer before it asks again
wall_scene | tr -d '\n' >"$tmp/line"
mkfifo "$tmp/ask" "$tmp/answer"
"$crumple" stack --jobs 1 - <"$tmp/ask" >"$tmp/answer" &
exec 8>"$tmp/ask" 9<"$tmp/answer"
for i in 1 2 3; do
    cat "$tmp/line" >&8
    echo >&8
    IFS= read -r answer <&9
    has "answer $i of a coprocess" "$answer" '^[{]"crumple_result":[12],.*[}]$'
done
exec 8>&-
wait $!
same "which ends with its input" "$?" 0
finish
