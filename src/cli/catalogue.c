/* `crumple catalogue` lists the cars that scenes and commands can name. */
#include "cli/cli.h"
#include "cli/word.h"

#include "process/signals.h"
#include "base/json.h"
#include "base/tree.h"
#include "catalogue/catalogue.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define FORMATS "text|json|csv|" CR_CATALOGUE_FORMS
enum { TEXT, JSON, CSV, REGISTER };

static const char about[] =
    "Lists the cars of the catalogue that all words fit: parts of make, model and body, a year,\n"
    "a length (4.25m); no word lists all. A scene takes one with \"car\": \"golf 2015\", a "
    "command\n"
    "with vehicle A car=\"golf 2015\". import makes a table of your own out of that of a "
    "register,\n"
    "cvs (Transport Canada), rdw (Netherlands) or eea (European Union), whose cars go before the\n"
    "others. Exit status: 0 there are some; 1 there is none; 2 usage or file system; 3 a table is\n"
    "invalid.\n";

static void number(struct cr_str *out, const char *before, double x, int decimals) {
    cr_str_add(out, before);
    if (isfinite(x)) {
        cr_str_addf(out, "%.*f", decimals, x);
    }
}

static void add_text(const struct cr_car *car, struct cr_str *out) {
    struct cr_str name = {0};
    cr_car_name(car, &name);
    out->failed = out->failed || name.failed;
    cr_str_addf(out, "%-44.44s %-13s %5.0f kg  ", cr_str_get(&name), car->type, car->curb);
    number(out, "", car->length, 3);
    number(out, " x ", car->width, 3);
    cr_str_addf(out, " m  %s\n", car->source);
    cr_str_fini(&name);
}

static void add_csv(const struct cr_car *car, struct cr_str *out) {
    cr_str_csv(out, car->make);
    cr_str_add(out, ",");
    cr_str_csv(out, car->model);
    cr_str_addf(out, ",%d,%d,", car->from, car->to);
    cr_str_csv(out, car->body);
    cr_str_add(out, ",");
    cr_str_csv(out, car->type);
    number(out, ",", car->curb, 0);
    const double size[] = {car->length,    car->width, car->height,
                           car->wheelbase, car->track, car->cg_behind_front_axle,
                           car->cg_height};
    for (size_t i = 0; i < sizeof size / sizeof size[0]; i++) {
        number(out, ",", size[i], 3);
    }
    cr_str_add(out, ",");
    cr_str_csv(out, car->source);
    cr_str_add(out, "\n");
}

static void put(cJSON *to, const char *key, double x) {
    cr_tree_put(to, key, isfinite(x) ? cJSON_CreateNumber(x) : cJSON_CreateNull());
}

static cJSON *to_json(const struct cr_car *car) {
    cJSON *json = cJSON_CreateObject();
    cr_tree_text(json, "make", car->make);
    cr_tree_text(json, "model", car->model);
    put(json, "from", car->from);
    put(json, "to", car->to);
    cr_tree_text(json, "body", car->body);
    cr_tree_text(json, "type", car->type);
    put(json, "kerb_mass_kg", car->curb);
    put(json, "length_m", car->length);
    put(json, "width_m", car->width);
    put(json, "height_m", car->height);
    put(json, "wheelbase_m", car->wheelbase);
    put(json, "track_m", car->track);
    put(json, "cg_behind_front_axle_m", car->cg_behind_front_axle);
    put(json, "cg_height_m", car->cg_height);
    cr_tree_text(json, "source", car->source);
    return json;
}

static enum cr_err write_cars(const struct cr_catalogue *c, const int *found, int n, int format,
                              struct cr_str *out, struct cr_error *err) {
    cJSON *list = format == JSON ? cJSON_CreateArray() : NULL;
    cr_str_add(out, format == CSV ? "make,model,from,to,body,type,curb_kg,length_m,width_m,"
                                    "height_m,wheelbase_m,track_m,cg_behind_front_axle_m,"
                                    "cg_height_m,source\n"
                                  : "");
    for (int i = 0; i < n; i++) {
        const struct cr_car *car = cr_catalogue_car(c, found[i]);
        if (format == JSON) {
            cr_tree_push(list, to_json(car));
        } else {
            (format == CSV ? add_csv : add_text)(car, out);
        }
    }
    bool done = format != JSON || cr_json_add(list, true, out);
    cr_str_add(out, format == JSON ? "\n" : "");
    return done && !out->failed ? CR_ERR_OK
                                : cr_err_set(err, CR_ERR_MEMORY, "no memory for the list");
}

/* what was meant may be near */
static enum cr_err none(const struct cr_catalogue *c, const char *words, struct cr_error *err) {
    const struct cr_car *car;
    struct cr_error near = {0};
    cr_err_set(err, CR_ERR_MISSED, "no car fits '%.80s'", words);
    if (cr_catalogue_find(c, words, &car, &near) != CR_ERR_OK &&
        strncmp(near.hint, "did you mean", 12) == 0) {
        cr_err_hint(err, "%.*s", (int)strcspn(near.hint, "?") + 1, near.hint);
    }
    return CR_ERR_MISSED;
}

static enum cr_err list(const char *words, int format, const char *path, struct cr_error *err) {
    struct cr_cli_shared shared = {0};
    struct cr_str text = {0};
    const struct cr_catalogue *c = NULL;
    int *found = NULL, n = 0;
    enum cr_err code = cr_cli_open(&shared, CR_CLI_NEEDED, err);
    code = code == CR_ERR_OK ? cr_model_catalogue(shared.models, &c, err) : code;
    if (code == CR_ERR_OK) {
        found = calloc((size_t)cr_catalogue_cars(c) + 1, sizeof *found);
        n = found != NULL ? cr_catalogue_search(c, words, found) : 0;
        code = found == NULL ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the list")
               : n == 0      ? none(c, words, err)
                             : write_cars(c, found, n, format, &text, err);
    }
    code = code == CR_ERR_OK ? cr_cli_emit(path, &text, err) : code;
    cr_str_fini(&text);
    free(found);
    cr_cli_close(&shared);
    return code;
}

/* each folder on the way to a file of the user's, as XDG asks: 0700 */
static void make_folders(char *path) {
    for (char *p = strchr(path + 1, '/'); p != NULL; p = strchr(p + 1, '/')) {
        *p = '\0';
        mkdir(path, 0700); /* that it cannot be made is told by who writes the file */
        *p = '/';
    }
}

static enum cr_err import(const char *file, int form, const char *path, struct cr_error *err) {
    static const char *const word[] = {"cvs", "rdw", "eea"};
    char folder[4096], own[4200];
    struct cr_str text = {0};
    int cars;
    if (path == NULL) {
        if (cr_own_cars(folder, sizeof folder)[0] == '\0') {
            return cr_err_set(err, CR_ERR_IO, "there is no home for a table: say -o FILE");
        }
        snprintf(own, sizeof own, "%s/%s.csv", folder, word[form]);
    }
    enum cr_err code = cr_catalogue_convert(file, form, &text, &cars, err);
    if (code == CR_ERR_OK && path == NULL) {
        make_folders(own);
    }
    code = code == CR_ERR_OK ? cr_cli_emit(path != NULL ? path : own, &text, err) : code;
    if (code == CR_ERR_OK && path == NULL) {
        printf("%d cars in %s\n", cars, own);
    }
    cr_str_fini(&text);
    return code;
}

/* import FILE, or words to look for */
static enum cr_err choose(char *const *word, int n, int format, const char *path,
                          struct cr_error *err) {
    struct cr_str words = {0};
    if (n > 0 && strcmp(word[0], "import") == 0) {
        return format >= REGISTER && n == 2
                   ? import(word[1], format - REGISTER, path, err)
                   : cr_err_set(err, CR_ERR_USAGE, "import needs --format=%s and one FILE",
                                CR_CATALOGUE_FORMS);
    }
    if (format >= REGISTER) {
        return cr_err_set(err, CR_ERR_USAGE, "--format=%s is for: catalogue import FILE",
                          CR_CATALOGUE_FORMS);
    }
    for (int i = 0; i < n; i++) {
        cr_str_addf(&words, "%s%s", i > 0 ? " " : "", word[i]);
    }
    enum cr_err code = words.failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the words")
                                    : list(cr_str_get(&words), format, path, err);
    cr_str_fini(&words);
    return code;
}

int cr_cli_catalogue(int argc, char **argv) {
    int format = TEXT, operands;
    const char *path = NULL;
    const struct cr_option table[] = {
        CR_OPTION_WORD("format", 'f', FORMATS, &format, "form (text); of import: what FILE is"),
        CR_CLI_OUTPUT_OPTION(&path),
    };
    const struct cr_usage usage = {.word = "catalogue",
                                   .operands = "[WORD ...] | import FILE",
                                   .about = about,
                                   .option = table,
                                   .options = sizeof table / sizeof *table,
                                   .most = -1};
    struct cr_error err = {0};
    int status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    cr_signals_catch_word();
    return choose(argv + 1, operands, format, path, &err) == CR_ERR_OK ? 0 : cr_cli_fail(&err);
}
