/* `crumple diff`: two results, or scenes that are solved for it, side by side. */
#include "cli/cli.h"
#include "cli/word.h"

#include "base/file.h"
#include "base/json.h"
#include "result/diff.h"

#include <cjson/cJSON.h>
#include <stdlib.h>
#include <string.h>

static const char about[] =
    "Puts two results of crumple run side by side: which inputs differ, all numbers of each\n"
    "participant, and by how much. A scene is solved first.\n"
    "Exit status: 0 nothing differs; 1 something does; else as of crumple run.\n";

struct options {
    int units;
    struct cr_cli_budget budget;
};

static enum cr_err solve(const char *path, const struct options *opt, cJSON **out,
                         struct cr_error *err) {
    const struct cr_result_opts form = {.resolved = true};
    struct cr_cli_job job;
    enum cr_err code = cr_cli_begin(path, NULL, &opt->budget, &job, err);
    if (code == CR_ERR_OK) {
        code = cr_cli_solve_job(&job, &opt->budget, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_result_tree(job.result, &form, out, err);
    }
    cr_cli_end(&job);
    return code;
}

/* A file may hold a result, which is taken as it is, or a scene, which is solved. */
static enum cr_err open_side(const char *path, const struct options *opt, cJSON **out,
                             struct cr_error *err) {
    char *text = NULL;
    size_t len = 0;
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    if (code == CR_ERR_OK) {
        code = cr_json_check(text, len, path, err);
    }
    cJSON *json = code == CR_ERR_OK ? cJSON_ParseWithLength(text, len) : NULL;
    free(text);
    if (code == CR_ERR_OK && cr_diff_is_result(json)) {
        *out = json;
        return CR_ERR_OK;
    }
    cJSON_Delete(json);
    return code == CR_ERR_OK ? solve(path, opt, out, err) : code;
}

static enum cr_err diff(char **argv, const struct options *opt, bool *same, struct cr_error *err) {
    cJSON *side[2] = {NULL, NULL};
    struct cr_str out = {0};
    enum cr_err code = open_side(argv[1], opt, &side[0], err);
    if (code == CR_ERR_OK) {
        code = open_side(argv[2], opt, &side[1], err);
    }
    struct cr_diff d = {.a = side[0],
                        .b = side[1],
                        .a_name = argv[1],
                        .b_name = argv[2],
                        .units = (enum cr_units)opt->units};
    if (code == CR_ERR_OK) {
        code = cr_diff_text(&d, &out, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_emit(NULL, &out, err);
    }
    *same = d.inputs == 0 && d.values == 0;
    cr_str_fini(&out);
    cJSON_Delete(side[0]);
    cJSON_Delete(side[1]);
    return code;
}

int cr_cli_diff(int argc, char **argv) {
    struct options opt = {.budget = CR_CLI_BUDGET};
    const struct cr_option table[] = {CR_CLI_UNITS_OPTION(&opt.units),
                                      CR_CLI_BUDGET_OPTIONS(&opt.budget)};
    const struct cr_usage usage = CR_USAGE("diff", "A.json B.json", about, table, 2, 2);
    struct cr_error err = {0};
    bool same = false;
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    if (diff(argv, &opt, &same, &err) != CR_ERR_OK) {
        return cr_cli_fail(&err);
    }
    return same ? 0 : 1;
}
