/* `crumple damage`: EES and delta-v out of measured deformations. */
#include "cli/cli.h"
#include "cli/word.h"
#include "damage/against.h"
#include "damage/picture.h"

#include "process/signals.h"

#include <stdio.h>
#include <string.h>

#define FORMATS "text|json"

struct options {
    int format;
    bool picture;
    const char *out, *solved;
    struct cr_cli_look look;
    struct cr_cli_budget budget;
};

static const char about[] =
    "Works from the damage back: crush profiles of one or two vehicles (FILE) to EES,\n"
    "energy, centre of energy and CDC, with a partner to delta-v and closing speed; every number\n"
    "with the interval that holds 95 %. See crumple(1) for the file.\n";

/* Everything that the work on one file holds in memory. */
struct work {
    const struct options *opt;
    struct cr_cli_shared shared;
    struct cr_crush_rules rules;
    struct cr_crush_file measured;
    struct cr_crush_case what;
    struct cr_crush_impact impact;
    struct cr_crush_against against[CR_CRUSH_CARS];
    struct cr_arena arena;
    struct cr_str text;
};

static enum cr_err write_case(struct work *w, struct cr_error *err) {
    const struct options *opt = w->opt;
    int width;
    struct cr_look look = cr_cli_look_of(&opt->look, opt->out != NULL, &width);
    const struct cr_crush_look how = {.lib = w->shared.models, .look = &look, .width = width};
    if (opt->format == 1) {
        return cr_crush_json(&w->what, &w->impact, &w->text, err);
    }
    enum cr_err code = cr_crush_text(&w->what, &w->impact, &w->text, err);
    for (int i = 0; i < w->what.n && code == CR_ERR_OK; i++) {
        const struct cr_crush_car *car = &w->what.car[i];
        if (car->against != NULL) {
            cr_crush_against_text(car->id, &car->m, car->against, &w->text);
        }
        if (opt->picture) {
            code = cr_crush_picture(car, &w->rules, &how, &w->text, err);
        }
    }
    return code;
}

/* The vehicles with the defaults of a scene, beside their measured damage. */
static enum cr_err compare(struct work *w, struct cr_error *err) {
    struct cr_scene scene;
    struct cr_result *result = NULL;
    cr_scene_init(&scene);
    enum cr_err code = cr_scene_load(w->opt->solved, &scene, err);
    for (int i = 0; i < w->what.n && code == CR_ERR_OK; i++) {
        if (cr_scene_find(&scene, w->what.car[i].id) == NULL) {
            cr_err_set(err, CR_ERR_NAME, "the scene has no '%s'", w->what.car[i].id);
            cr_err_hint(err, "give the vehicles of the damage file the ids of the scene");
            cr_err_place(err, w->opt->solved, 0, 0);
            code = CR_ERR_NAME;
        }
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_solve(&w->shared, &w->opt->budget, &scene, &result, err);
        if (code != CR_ERR_OK) {
            cr_cli_locate(w->opt->solved, err);
        }
    }
    for (int i = 0; i < w->what.n && code == CR_ERR_OK; i++) {
        struct cr_crush_car *car = &w->what.car[i];
        if (!car->m.guessed) {
            int body = (int)(cr_scene_find(&scene, car->id) - scene.part);
            cr_crush_against(result, body, &car->m, &w->against[i]);
            car->against = &w->against[i];
        }
    }
    cr_result_free(result);
    cr_scene_fini(&scene);
    return code;
}

static enum cr_err work_back(struct work *w, const char *file, struct cr_error *err) {
    char path[4200];
    enum cr_err code = cr_cli_data("damage/calibration.json", path, sizeof path, err);
    if (code == CR_ERR_OK) {
        code = cr_crush_rules_read(path, &w->rules, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_open(&w->shared, CR_CLI_NEEDED, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_case_open(&w->measured, w->shared.models, &w->arena, &w->what, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_solve(&w->what, &w->rules, &w->impact, err);
    }
    if (code != CR_ERR_OK && err->src[0] == '\0') {
        cr_err_place(err, file, 0, 0);
    }
    return code;
}

static enum cr_err run(const char *file, const struct options *opt, struct cr_error *err) {
    struct work w = {.opt = opt};
    enum cr_err code = cr_crush_read(file, &w.measured, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_signals_catch_word();
    code = work_back(&w, file, err);
    if (code == CR_ERR_OK && opt->solved != NULL) {
        code = compare(&w, err);
    }
    if (code == CR_ERR_OK) {
        code = write_case(&w, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_emit(opt->out, &w.text, err);
    }
    cr_str_fini(&w.text);
    cr_arena_free(&w.arena);
    cr_crush_file_fini(&w.measured);
    cr_cli_close(&w.shared);
    return code;
}

int cr_cli_damage(int argc, char **argv) {
    struct cr_error err = {0};
    struct options opt = {.budget = CR_CLI_BUDGET};
    const struct cr_option table[] = {
        CR_OPTION_WORD("format", 'f', FORMATS, &opt.format, "form of the result (text)"),
        CR_OPTION_FLAG("picture", 'p', &opt.picture,
                       "the outline over the voxels, from above and from the side"),
        CR_OPTION_TEXT("solved", 's', "SCENE.json", &opt.solved,
                       "beside what is left of them when that scene is solved"),
        CR_CLI_OUTPUT_OPTION(&opt.out),
        CR_CLI_BUDGET_OPTIONS(&opt.budget),
        CR_CLI_LOOK_OPTIONS(&opt.look),
    };
    const struct cr_usage usage = CR_USAGE("damage", "FILE.json|FILE.csv", about, table, 1, 1);
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    return run(argv[1], &opt, &err) == CR_ERR_OK ? 0 : cr_cli_fail(&err);
}
