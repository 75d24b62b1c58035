/* crumple schema: prints the JSON Schema of a kind of file, for editors and validators. */
#include "cli/cli.h"
#include "cli/word.h"

#include "process/signals.h"
#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* X(name): share/schema/NAME.schema.json */
#define SCHEMAS "scene|result|damage|voxel-model|recipe"

static const char about[] =
    "Prints the JSON Schema (2020-12) of scenes, results, damage files, voxel "
    "models or recipes;\nwithout a name, the names. Exit status: 0 done; 2 usage or file "
    "system.\n";

static enum cr_err list(struct cr_error *err) {
    struct cr_str out = {0};
    for (const char *p = SCHEMAS; *p != '\0'; p++) {
        cr_str_addn(&out, *p == '|' ? "\n" : p, 1);
    }
    cr_str_add(&out, "\n");
    enum cr_err code = cr_cli_emit(NULL, &out, err);
    cr_str_fini(&out);
    return code;
}

static enum cr_err show(const char *name, const char *to, struct cr_error *err) {
    char part[64], path[4200], *text = NULL;
    size_t len = 0;
    if (cr_str_choice(SCHEMAS, name) < 0) {
        cr_err_set(err, CR_ERR_USAGE, "there is no schema '%.60s'", name);
        cr_err_hint(err, "one of " SCHEMAS);
        return CR_ERR_USAGE;
    }
    snprintf(part, sizeof part, "schema/%.30s.schema.json", name);
    enum cr_err code = cr_cli_data(part, path, sizeof path, err);
    if (code == CR_ERR_OK) {
        code = cr_file_read(path, &text, &len, err);
    }
    if (code == CR_ERR_OK) {
        struct cr_str out = {0};
        cr_str_addn(&out, text, len);
        code = cr_cli_emit(to, &out, err);
        cr_str_fini(&out);
    }
    free(text);
    return code;
}

int cr_cli_schema(int argc, char **argv) {
    const char *to = NULL;
    const struct cr_option table[] = {
        CR_CLI_OUTPUT_OPTION(&to),
    };
    const struct cr_usage usage = {.word = "schema",
                                   .operands = "[NAME]",
                                   .about = about,
                                   .option = table,
                                   .options = sizeof table / sizeof *table,
                                   .least = 0,
                                   .most = 1,
                                   .candidates = SCHEMAS};
    struct cr_error err = {0};
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    cr_signals_catch_word();
    enum cr_err code = operands == 0 ? list(&err) : show(argv[1], to, &err);
    return code == CR_ERR_OK ? 0 : cr_cli_fail(&err);
}
