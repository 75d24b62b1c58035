/* `crumple models`: lists, shows and exports the voxel models, and carries a solved deformation
 * back onto them. */
#include "config.h"

#include "cli/cli.h"
#include "cli/models.h"
#include "cli/word.h"

#include "process/signals.h"
#include "base/vec.h"
#include "render/project.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define VIEWS "all|side|top|front|slice"
enum { VIEW_ALL, VIEW_SLICE = 4 };
enum { ROWS_MAX = 40 };

struct options {
    int format, view, voxel_mm;
    bool flat;
    const char *at, *to, *crash, *id;
    struct cr_cli_look look;
    struct cr_cli_budget budget;
};

static const char about[] =
    "Without a NAME: all models, each type by twelve directions of force, with the tests\n"
    "each rests on. NAME is a type (sedan), a model (sedan/12: hit from 12 o'clock), or a file\n"
    "with a voxel model of your own (my.json, my.csv). A type is described, a model is drawn in\n"
    "classes of EES, or written to a file that loads back with every bit. With --crash the\n"
    "scene is solved and the deformation of participant --id is carried back onto its model.\n";

/* What is shown, and where its voxels come from. */
struct shown {
    struct cr_arena arena;
    struct cr_voxels voxels;
    double *ees;
    struct cr_result *result; /* NULL without a crash */
    int body;
};

static bool is_file(const char *name) {
    size_t n = strlen(name);
    return (n > 5 && strcasecmp(name + n - 5, ".json") == 0) ||
           (n > 4 && strcasecmp(name + n - 4, ".csv") == 0);
}

static enum cr_err make_voxels(const struct cr_model_lib *lib, const struct options *opt,
                               struct cr_model_query *q, struct shown *s, struct cr_error *err) {
    bool flat = opt->flat;
    q->voxel = opt->voxel_mm > 0 ? opt->voxel_mm / 1000.0 : flat ? 0.025 : 0.05;
    q->z_hi = INFINITY;
    return flat ? cr_model_flat(lib, q, &s->arena, &s->voxels, err)
                : cr_model_voxels(lib, q, &s->arena, &s->voxels, err);
}

static enum cr_err load(const char *name, const struct cr_model_lib *lib, const struct options *opt,
                        struct shown *s, struct cr_error *err) {
    if (is_file(name)) {
        if (opt->flat || opt->voxel_mm > 0) {
            enum cr_err code = cr_err_set(err, CR_ERR_USAGE, "%s has the voxels it has", name);
            cr_err_hint(err, "leave out --flat and --voxel");
            return code;
        }
        return cr_voxels_read(name, &s->arena, &s->voxels, NULL, err);
    }
    struct cr_model_name model;
    enum cr_err code = cr_model_name_read(name, &model, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_model_query q = {.type = model.type, .pdof = model.clock * (CR_PI / 6)};
    q.dims = *cr_model_dims(lib, model.type, &q.mass_kg);
    return make_voxels(lib, opt, &q, s, err);
}

/* ---- a crash ---- */

static int find_body(const struct cr_result *r, const char *id) {
    for (int i = 0; i < r->resolved.n; i++) {
        const struct cr_participant *p = &r->resolved.part[i];
        if (p->kind == CR_KIND_VEHICLE && (id == NULL || strcmp(p->id, id) == 0)) {
            return i;
        }
    }
    return -1;
}

/* The 3D model of a participant after a solve: the one its substitute was made of. */
static enum cr_err crash_model(const struct cr_model_lib *lib, const struct options *opt,
                               struct shown *s, struct cr_error *err) {
    const struct cr_scene *scene = &s->result->resolved;
    const struct cr_participant *p = &scene->part[s->body];
    struct cr_model_query q = cr_scene_query(scene, p, s->result->of[s->body].pdof);
    if (p->model.kind == CR_MODEL_FILE) {
        char path[2 * CR_PATH_MAX];
        cr_scene_model_path(scene, p, path);
        return cr_voxels_read(path, &s->arena, &s->voxels, NULL, err);
    }
    const char *slash = strchr(s->result->of[s->body].model, '/');
    if (slash != NULL) {
        q.pdof = strtol(slash + 1, NULL, 10) * (CR_PI / 6);
    }
    return make_voxels(lib, opt, &q, s, err);
}

static enum cr_err solve(const struct cr_cli_shared *shared, const struct options *opt,
                         struct shown *s, struct cr_error *err) {
    struct cr_scene scene;
    cr_scene_init(&scene);
    enum cr_err code = cr_scene_load(opt->crash, &scene, err);
    if (code == CR_ERR_OK) {
        code = cr_cli_solve(shared, &opt->budget, &scene, &s->result, err);
        if (code != CR_ERR_OK) {
            cr_cli_locate(opt->crash, err);
        }
    }
    if (code == CR_ERR_OK) {
        s->body = find_body(s->result, opt->id);
        if (s->body < 0) {
            code =
                cr_err_set(err, CR_ERR_NAME, "no vehicle \"%s\"", opt->id != NULL ? opt->id : "");
            cr_err_place(err, opt->crash, 0, 0);
            cr_err_hint(err, "name one of the scene's vehicles with --id");
        }
    }
    cr_scene_fini(&scene);
    if (code != CR_ERR_OK) {
        return code;
    }
    return crash_model(shared->models, opt, s, err);
}

/* ---- pictures ---- */

/* what a drawing is of, and how wide */
struct sheet {
    struct cr_look look;
    int width;
    double slice_y;
    struct cr_str *out;
};

static enum cr_err draw(const struct shown *s, const struct sheet *sheet, enum cr_project view,
                        struct cr_error *err) {
    const struct cr_look *look = &sheet->look;
    struct cr_projection p = {
        .view = view, .slice_y = sheet->slice_y, .voxels = &s->voxels, .ees = s->ees};
    if (s->result != NULL) {
        p.grid = cr_result_grid(s->result, s->body);
        p.left = s->result->solution->body[s->body].left;
        p.face = s->result->of[s->body].face;
    }
    struct cr_cells cells;
    int width = sheet->width, rows = cr_render_projection_rows(&p, width, ROWS_MAX);
    enum cr_err code = cr_cells_new(width, rows, &cells, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_render_projection(&cells, (struct cr_rect){0, 0, width, rows}, look, &p, err);
    if (code == CR_ERR_OK) {
        cr_cells_text(&cells, look, sheet->out);
        cr_str_add(sheet->out, "\n");
    }
    cr_cells_fini(&cells);
    return code;
}

static enum cr_err draw_views(struct shown *s, const struct options *opt, struct cr_str *out,
                              struct cr_error *err) {
    const struct cr_voxels *v = &s->voxels;
    struct sheet sheet = {.out = out};
    if (opt->at != NULL) {
        char *end = NULL;
        sheet.slice_y = strtod(opt->at, &end);
        if (end == opt->at || *end != '\0' || !(fabs(sheet.slice_y) <= v->dims.width / 2)) {
            enum cr_err code =
                cr_err_set(err, CR_ERR_USAGE, "--at %s is not on the vehicle", opt->at);
            cr_err_hint(err, "m from the centre line, left is positive, up to %.2f",
                        v->dims.width / 2);
            return code;
        }
    }
    s->ees =
        cr_arena_take(&s->arena, (size_t)v->nx * (size_t)v->ny * (size_t)v->nz, sizeof *s->ees);
    if (s->ees == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the picture of %s", v->name);
    }
    enum cr_err code = cr_voxels_ees(v, s->ees, err);
    sheet.look = cr_cli_look_of(&opt->look, false, &sheet.width);
    static const enum cr_project all[] = {CR_PROJECT_SIDE, CR_PROJECT_TOP, CR_PROJECT_FRONT};
    for (int i = 0; i < 3 && code == CR_ERR_OK; i++) {
        if (opt->view == VIEW_ALL && (!v->flat || all[i] == CR_PROJECT_TOP)) {
            code = draw(s, &sheet, all[i], err);
        }
    }
    if (opt->view != VIEW_ALL && code == CR_ERR_OK) {
        code = draw(s, &sheet, (enum cr_project)(opt->view - 1), err);
    }
    return code;
}

/* ---- output ---- */

/* `to` says the format; `origin` is what is known of the model, NULL: nothing */
static enum cr_err export_to(const struct shown *s, const char *to, const char *origin,
                             struct cr_str *out, struct cr_error *err) {
    size_t n = strlen(to);
    if (n > 4 && strcasecmp(to + n - 4, ".csv") == 0) {
        cr_voxels_csv(&s->voxels, out);
        return CR_ERR_OK;
    }
    if (!is_file(to)) {
        cr_err_set(err, CR_ERR_USAGE, "--to %s is neither .json nor .csv", to);
        cr_err_hint(err, "the suffix decides the format");
        return CR_ERR_USAGE;
    }
    cr_voxels_json(&s->voxels, origin, out);
    return CR_ERR_OK;
}

/* Does the request need voxels, or is it answered by what is known of the models? */
static bool wants_voxels(const char *name, const struct options *opt) {
    return opt->crash != NULL || opt->to != NULL || is_file(name) || strchr(name, '/') != NULL;
}

static enum cr_err describe(const char *name, const struct options *opt,
                            const struct cr_model_papers *papers, const struct cr_model_lib *lib,
                            struct cr_str *out, struct cr_error *err) {
    struct cr_model_name model = {.type = CR_TYPES};
    enum cr_err code = name != NULL ? cr_model_name_read(name, &model, err) : CR_ERR_OK;
    if (code != CR_ERR_OK) {
        return code;
    }
    if (opt->format == 1) {
        return cr_model_list_json(papers, (int)model.type, model.clock, out, err);
    }
    if (name == NULL) {
        cr_model_list_text(papers, CR_TYPES, 0, out);
    } else {
        cr_model_about(papers, lib, model.type, out);
    }
    return CR_ERR_OK;
}

static enum cr_err show(const char *name, const struct options *opt,
                        const struct cr_cli_shared *shared, const struct cr_model_papers *papers,
                        struct cr_str *out, struct cr_error *err) {
    struct shown s = {.body = -1};
    struct cr_model_name model;
    struct cr_str origin = {0};
    bool known =
        name != NULL && !is_file(name) && cr_model_name_read(name, &model, NULL) == CR_ERR_OK;
    enum cr_err code =
        opt->crash != NULL ? solve(shared, opt, &s, err) : load(name, shared->models, opt, &s, err);
    if (code == CR_ERR_OK && opt->to != NULL) {
        if (known) {
            cr_model_provenance(papers, shared->models, model.type, model.clock, &origin);
        }
        code = origin.failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the provenance")
                             : export_to(&s, opt->to, known ? cr_str_get(&origin) : NULL, out, err);
    } else if (code == CR_ERR_OK) {
        if (known) {
            cr_model_list_text(papers, (int)model.type, model.clock, out);
            cr_str_add(out, "\n");
        }
        code = draw_views(&s, opt, out, err);
    }
    cr_str_fini(&origin);
    cr_result_free(s.result);
    cr_arena_free(&s.arena);
    return code;
}

/* Options that would change nothing are a slip. */
static enum cr_err check_use(const char *name, const struct options *opt, struct cr_error *err) {
    bool voxels = opt->crash != NULL || (name != NULL && wants_voxels(name, opt));
    if (!voxels && (opt->view != VIEW_ALL || opt->flat || opt->voxel_mm > 0 || opt->at != NULL)) {
        cr_err_set(err, CR_ERR_USAGE, "nothing is drawn without a model");
        cr_err_hint(err, "name one, %s/12, or a scene with --crash", name != NULL ? name : "sedan");
        return CR_ERR_USAGE;
    }
    if (opt->at != NULL && opt->view != VIEW_SLICE) {
        cr_err_set(err, CR_ERR_USAGE, "--at is for --view slice");
        return CR_ERR_USAGE;
    }
    if (opt->id != NULL && opt->crash == NULL) {
        cr_err_set(err, CR_ERR_USAGE, "--id is for a scene");
        cr_err_hint(err, "name it with --crash SCENE.json");
        return CR_ERR_USAGE;
    }
    return CR_ERR_OK;
}

static enum cr_err models(const char *name, const struct options *opt, struct cr_error *err) {
    struct cr_cli_shared shared = {0};
    struct cr_model_papers papers = {{NULL}};
    struct cr_str out = {0};
    char dir[4200];
    enum cr_err code = check_use(name, opt, err);
    if (code == CR_ERR_OK) {
        code = cr_cli_open(&shared, CR_CLI_ALL, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_data("models", dir, sizeof dir, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_model_papers_read(dir, &papers, err);
    }
    bool voxels = opt->crash != NULL || (name != NULL && wants_voxels(name, opt));
    if (code == CR_ERR_OK && name == NULL && opt->to != NULL && opt->crash == NULL) {
        code = cr_err_set(err, CR_ERR_USAGE, "--to wants the NAME of a model");
        cr_err_hint(err, "for example crumple models sedan/12 --to %s", opt->to);
    }
    if (code == CR_ERR_OK) {
        code = voxels && opt->format == 0 ? show(name, opt, &shared, &papers, &out, err)
                                          : describe(name, opt, &papers, shared.models, &out, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_emit(voxels ? opt->to : NULL, &out, err);
    }
    cr_str_fini(&out);
    cr_model_papers_fini(&papers);
    cr_cli_close(&shared);
    return code;
}

/* for completion: "sedan|sedan/1|...|suv/12" */
static void list_names(char *buf, size_t size) {
    size_t n = 0;
    buf[0] = '\0';
    for (int t = 0; t < CR_TYPES; t++) {
        const char *word = cr_type_word((enum cr_type)t);
        n += (size_t)snprintf(buf + n, size - n, "%s%s", n > 0 ? "|" : "", word);
        for (int clock = 1; clock <= 12; clock++) {
            n += (size_t)snprintf(buf + n, size - n, "|%s/%d", word, clock);
        }
    }
}

int cr_cli_models(int argc, char **argv) {
    struct options opt = {.view = VIEW_ALL, .budget = CR_CLI_BUDGET};
    const struct cr_option table[] = {
        CR_OPTION_WORD("view", 0, VIEWS, &opt.view, "which picture (all)"),
        CR_OPTION_TEXT("at", 0, "Y", &opt.at,
                       "where a slice is cut, m left of the centre line (0)"),
        CR_OPTION_TEXT("to", 0, "FILE", &opt.to,
                       "export to FILE.json or FILE.csv instead of drawing"),
        CR_OPTION_FLAG("flat", 0, &opt.flat, "the 2D model that the solver uses"),
        {.name = "voxel",
         .arg = "MM",
         .number = &opt.voxel_mm,
         .lo = 5,
         .hi = 100,
         .help = "edge of the voxels, mm (50; with --flat 25)"},
        CR_OPTION_TEXT("crash", 0, "SCENE.json", &opt.crash,
                       "solve this scene, show a vehicle of it deformed"),
        CR_OPTION_TEXT("id", 0, "ID", &opt.id, "which vehicle of the scene (the first)"),
        CR_OPTION_WORD("format", 'f', "text|json", &opt.format, "form of the list (text)"),
        CR_CLI_BUDGET_OPTIONS(&opt.budget),
        CR_CLI_LOOK_OPTIONS(&opt.look),
    };
    char names[CR_TYPES * 13 * 24];
    list_names(names, sizeof names);
    const struct cr_usage usage = {.word = "models",
                                   .candidates = names,
                                   .operands = "[NAME]",
                                   .about = about,
                                   .option = table,
                                   .options = sizeof table / sizeof *table,
                                   .most = 1};
    struct cr_error err = {0};
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    cr_signals_catch_word();
    return models(operands > 0 ? argv[1] : NULL, &opt, &err) ? cr_cli_fail(&err) : 0;
}
