/* `crumple import`: files of other programs, databases and test houses as scenes, one per line. */
#include "cli/cli.h"
#include "cli/word.h"

#include "process/signals.h"
#include "import/import.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static const char about[] =
    "Makes scenes of crashes that other programs, databases and test houses have written, one per\n"
    "line (JSON Lines), for crumple stack. A case that cannot be converted gives an error object\n"
    "in its place. The format is recognised by the content of a file. crumple-import(1) tells the\n"
    "formats and the map. Exit status: 0 all converted; 1 a case was not; 2 usage or file system;\n"
    "3 a file has no known format or is broken; 130 interrupted.\n";

struct work {
    FILE *out;
    const char *name;   /* of out */
    struct cr_str text; /* what goes into the file of -o, whole or not at all */
    bool whole, gone;
};

static enum cr_err take(void *user, const struct cr_str *line, struct cr_error *err) {
    struct work *w = user;
    if (w->whole) {
        cr_str_addn(&w->text, line->s, line->len);
        return w->text.failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the scenes")
                              : CR_ERR_OK;
    }
    if (fwrite(line->s, 1, line->len, stdout) == line->len && fflush(stdout) == 0) {
        return CR_ERR_OK;
    }
    w->gone = errno == EPIPE;
    cr_err_set(err, CR_ERR_IO, "cannot write: %s", strerror(errno));
    cr_err_place(err, "standard output", 0, 0);
    return CR_ERR_IO;
}

static void failed(void *user, const struct cr_error *why) {
    (void)user;
    (void)cr_cli_fail(why);
}

struct options {
    struct cr_import_opts import;
    int point; /* 0: auto */
    const char *list, *before, *out;
};

static enum cr_err set_up(struct options *o, struct cr_error *err) {
    enum cr_err code =
        o->list != NULL ? cr_import_set(&o->import, "case", o->list, err) : CR_ERR_OK;
    o->import.point = o->point - 1;
    return code == CR_ERR_OK && o->before != NULL
               ? cr_import_set(&o->import, "before", o->before, err)
               : code;
}

static int run(struct options *o, char *const *path, int n) {
    struct work work = {.whole = o->out != NULL && strcmp(o->out, "-") != 0};
    struct cr_cli_shared shared = {0};
    struct cr_import_count count = {0};
    struct cr_error err = {0};
    enum cr_err code = set_up(o, &err);
    code = code == CR_ERR_OK ? cr_cli_open(&shared, CR_CLI_NEEDED, &err) : code;
    if (code == CR_ERR_OK) {
        o->import.models = shared.models;
        o->import.user = &work;
        code = cr_import_files(&o->import, (const char *const *)path, n, &count, &err);
    }
    if (code == CR_ERR_OK && work.whole) {
        code = cr_cli_emit(o->out, &work.text, &err);
    }
    int status = code == CR_ERR_OK || work.gone ? count.errors > 0 : cr_cli_fail(&err);
    cr_str_fini(&work.text);
    cr_import_fini(&o->import);
    cr_cli_close(&shared);
    return status;
}

int cr_cli_import(int argc, char **argv) {
    struct options o = {.point = 0};
    cr_import_init(&o.import);
    o.import.cancel = cr_cli_cancelled;
    o.import.take = take;
    o.import.failed = failed;
    const struct cr_option table[] = {
        CR_OPTION_WORD("format", 'f', cr_import_formats(), &o.import.format,
                       "instead of recognising it"),
        CR_OPTION_TEXT("case", 0, "ID,ID", &o.list, "only these cases"),
        CR_OPTION_TEXT("map", 0, "FILE", &o.import.map,
                       "names of columns; vehicles and objects: what the file lacks (JSON)"),
        CR_OPTION_WORD("reference", 0, "auto|" CR_POINTS, &o.point,
                       "point of a vehicle that places are of (auto: as the format has it)"),
        CR_OPTION_TEXT("before", 0, "TIME", &o.before,
                       "what is kept before the outlines meet (2s)"),
        CR_CLI_OUTPUT_OPTION(&o.out),
    };
    const struct cr_usage usage = CR_USAGE("import", "FILE ...", about, table, 1, -1);
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    cr_signals_catch_word();
    return run(&o, argv + 1, operands);
}
