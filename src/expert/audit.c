/* `crumple audit`: computes a result again and says whether it is the same, and if not, why. */
#include "cli/cli.h"
#include "cli/word.h"
#include "expert/expert.h"
#include "expert/recheck.h"

#include "process/signals.h"
#include "base/file.h"

#include <stdlib.h>
#include <string.h>

static const char about[] =
    "Computes a result of crumple run again, from the scene that is named or else from the one\n"
    "inside of the result, and compares: \"same bytes\", or the first difference and whether\n"
    "version, models, risk functions or scene differ.\n"
    "Exit status: 0 the same; 1 a difference; else as of crumple run.\n";

static enum cr_err get_scene(const char *text, size_t len, char **argv, int n,
                             struct cr_scene *scene, struct cr_error *err) {
    return n > 1 ? cr_scene_load(argv[2], scene, err)
                 : cr_recheck_scene(text, len, argv[1], scene, err);
}

struct options {
    struct cr_option_values set;
    struct cr_cli_budget budget;
};

static enum cr_err audit(char **argv, int n, const struct options *opt, bool *same,
                         struct cr_error *err) {
    struct cr_cli_shared shared = {0};
    struct cr_result *result = NULL;
    struct cr_recheck check = {.same = false};
    struct cr_str out = {0};
    struct cr_scene scene;
    char *text = NULL;
    size_t len = 0;
    cr_scene_init(&scene);
    enum cr_err code = cr_file_read(argv[1], &text, &len, err);
    if (code == CR_ERR_OK) {
        code = get_scene(text, len, argv, n, &scene, err);
    }
    cr_signals_catch_word();
    if (code == CR_ERR_OK) {
        code = cr_cli_override(&scene, &opt->set, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_open(&shared, CR_CLI_NEEDED, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_solve(&shared, &opt->budget, &scene, &result, err);
    }
    if (code == CR_ERR_OK) {
        code =
            cr_recheck(&(struct cr_recheck_file){text, len, argv[1]}, result, n < 2, &check, err);
    }
    if (code == CR_ERR_OK) {
        cr_recheck_text(&check, &out);
        code = cr_cli_emit(NULL, &out, err);
    }
    *same = check.same;
    cr_str_fini(&out);
    cr_result_free(result);
    cr_scene_fini(&scene);
    cr_cli_close(&shared);
    free(text);
    return code;
}

int cr_expert_audit(int argc, char **argv) {
    struct options opt = {.budget = CR_CLI_BUDGET};
    const struct cr_option table[] = {
        CR_OPTION_VALUES("set", 's', "KEY=VALUE", &opt.set,
                         "what was overridden when the result was made"),
        CR_CLI_BUDGET_OPTIONS(&opt.budget)};
    const struct cr_usage usage = CR_USAGE("audit", "RESULT.json [SCENE.json]", about, table, 1, 2);
    struct cr_error err = {0};
    bool same = false;
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    if (audit(argv, operands, &opt, &same, &err) != CR_ERR_OK) {
        return cr_cli_fail(&err);
    }
    return same ? 0 : 1;
}
