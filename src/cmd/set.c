/* set and check: settings of the scene and of the session, and what stands in the way of a solve.
 */
#include "cmd/cmd_priv.h"

#include "result/robust.h"
#include "scene/compiled.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* what the session itself keeps; index is that of the argument's word where it has some */
static bool session_value(const struct cr_session *s, const char *name, char *buf, int size) {
    static const char *const colors[] = {"none", "16", "256"};
    if (strcmp(name, "name") == 0) {
        snprintf(buf, (size_t)size, "%s", cr_session_scene(s)->name);
    } else if (strcmp(name, "pair") == 0) {
        snprintf(buf, (size_t)size, "%s", cr_session_scene(s)->pair);
    } else if (strcmp(name, "echo") == 0) {
        snprintf(buf, (size_t)size, "%s", s->echo ? "on" : "off");
    } else if (strcmp(name, "units") == 0) {
        snprintf(buf, (size_t)size, "%s", s->units == CR_UNITS_US ? "us" : "si");
    } else if (strcmp(name, "ascii") == 0) {
        snprintf(buf, (size_t)size, "%s", s->opts.look.ascii ? "on" : "off");
    } else if (strcmp(name, "color") == 0) {
        snprintf(buf, (size_t)size, "%s", colors[s->opts.look.color]);
    } else {
        return false;
    }
    return true;
}

/* "restitution   0.1" with what it means */
static enum cr_err say_setting(struct cr_session *s, const struct cr_scene *scene,
                               const struct cr_arg *arg, struct cr_error *err) {
    const struct cr_key *key = cr_arg_key(arg);
    struct cr_str help = {0}, value = {0};
    char text[CR_NAME_MAX + 8] = "";
    enum cr_err code = CR_ERR_OK;
    if (key != NULL) {
        code = cr_scene_get(scene, key->name, &value, err);
        const char *unit = key->unit != NULL ? key->unit : "";
        const char *given = cr_str_get(&value);
        bool automatic = strcmp(given, "auto") == 0, on = strcmp(given, "true") == 0;
        if (key->type == CR_KEY_SWITCH) {
            snprintf(text, sizeof text, "%s", automatic ? "as method" : on ? "on" : "off");
        } else {
            snprintf(text, sizeof text, "%s%s%s", given, unit[0] != '\0' && !automatic ? " " : "",
                     automatic ? "" : unit);
        }
        cr_str_add(&help, key->help);
    } else if (session_value(s, arg->name, text, sizeof text)) {
        cr_str_add(&help, arg->help);
    }
    if (code == CR_ERR_OK) {
        s->lost = s->lost || help.failed || value.failed;
        cr_say(s, "%-12s %-12s %s", arg->name, text, cr_str_get(&help));
    }
    cr_str_fini(&help);
    cr_str_fini(&value);
    return code;
}

static enum cr_err say_settings(struct cr_call *call, const char *only, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    const struct cr_arg *arg = call->cmd->arg;
    for (int i = 1; arg[i].name != NULL && code == CR_ERR_OK; i++) {
        if (only == NULL || strcmp(only, arg[i].name) == 0) {
            code = say_setting(call->s, &cr_session_now(call->s)->scene, &arg[i], err);
        }
    }
    return code;
}

static enum cr_err no_setting(struct cr_call *call, const char *name, struct cr_error *err) {
    const char *list[CR_CMD_ARGS] = {NULL};
    int n = 0;
    for (int i = 1; call->cmd->arg[i].name != NULL; i++) {
        list[n++] = call->cmd->arg[i].name;
    }
    const char *near = cr_str_nearest(name, list, n);
    cr_err_set(err, CR_ERR_KEY, "there is no setting '%.60s'", name);
    cr_err_hint(err, near != NULL ? "did you mean '%s'?" : "set lists all%s",
                near != NULL ? near : "");
    return cr_cmd_blame(call, "SETTING", CR_ERR_KEY);
}

/* settings that are kept by the session and are no change of the scene */
static void set_session(struct cr_call *call) {
    struct cr_session *s = call->s;
    if (cr_cmd_given(call, "echo")) {
        s->echo = cr_cmd_word(call, "echo", 1) == 0;
    }
    if (cr_cmd_given(call, "units")) {
        s->units = (enum cr_units)cr_cmd_word(call, "units", 0);
        if (s->result != NULL) {
            s->result->units = s->units;
        }
        cr_say(s, "%s; inputs without a unit, and files, stay metric",
               s->units == CR_UNITS_US ? "mph, ft, in, lb, lbf, ft-lb" : "km/h, m, kg, kN, kJ");
    }
    if (cr_cmd_given(call, "ascii")) {
        s->opts.look.ascii = cr_cmd_word(call, "ascii", 1) == 0;
    }
    if (cr_cmd_given(call, "color")) {
        s->opts.look.color = (enum cr_color)cr_cmd_word(call, "color", 0);
    }
}

static bool is_scene_setting(const struct cr_arg *arg) {
    return arg->type == CR_VALUE_KEY || strcmp(arg->name, "name") == 0 ||
           strcmp(arg->name, "pair") == 0;
}

/* a name that is none is told now, not when the scene is solved */
static enum cr_err check_injury(struct cr_call *call, const struct cr_scene *scene,
                                struct cr_error *err) {
    if (!cr_cmd_given(call, "injury") || cr_session_need_models(call->s, NULL) != CR_ERR_OK) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_irf_check(call->s->irf, scene->set.injury, err);
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "injury", code);
}

enum cr_err cr_cmd_set(struct cr_call *call, struct cr_error *err) {
    const char *only = cr_cmd_text(call, "SETTING", NULL);
    int given = 0, of_scene = 0;
    enum cr_err code = CR_ERR_OK;
    struct cr_state *draft = NULL; /* where a setting of the scene is given */
    for (int i = 1; call->cmd->arg[i].name != NULL; i++) {
        given += call->value[i].token != NULL;
        of_scene += call->value[i].token != NULL && is_scene_setting(&call->cmd->arg[i]);
    }
    if (only != NULL) {
        bool known = false;
        for (int i = 1; call->cmd->arg[i].name != NULL; i++) {
            known = known || strcmp(call->cmd->arg[i].name, only) == 0;
        }
        return known && given == 0 ? say_settings(call, only, err) : no_setting(call, only, err);
    }
    if (given == 0) {
        return say_settings(call, NULL, err);
    }
    if (of_scene > 0) {
        code = cr_cmd_edit(call, &draft, err);
    }
    if (code == CR_ERR_OK && draft != NULL) {
        code = cr_cmd_set_keys(call, &draft->scene, NULL, err);
        code = code == CR_ERR_OK ? check_injury(call, &draft->scene, err) : code;
    }
    static const char *const texts[] = {"name", "pair"};
    for (int i = 0; i < 2 && code == CR_ERR_OK && draft != NULL; i++) {
        if (cr_cmd_given(call, texts[i])) {
            code = cr_scene_set(&draft->scene, texts[i], cr_cmd_text(call, texts[i], ""), err);
            code = code == CR_ERR_OK ? code : cr_cmd_blame(call, texts[i], code);
        }
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    set_session(call);
    for (int i = 1; call->cmd->arg[i].name != NULL && code == CR_ERR_OK; i++) {
        const struct cr_arg *arg = &call->cmd->arg[i];
        if (call->value[i].token != NULL && arg->type == CR_VALUE_KEY) {
            code = say_setting(call->s, &draft->scene, arg, err);
        }
    }
    return code;
}

/* ---- check ---- */

/* the command that mends what the message is about */
static const char *remedy(const struct cr_error *err, char *buf, int size) {
    if (err->hint[0] != '\0') {
        snprintf(buf, (size_t)size, "%s", err->hint);
    } else {
        snprintf(buf, (size_t)size, "see help vehicle, help model and help place");
    }
    return buf;
}

/* distances along the way to the first contact, from the outlines */
static int check_motion(struct cr_session *s, const struct cr_scene *scene) {
    int doubts = 0;
    bool moves = false;
    for (int i = 0; i < scene->n; i++) {
        moves = moves || scene->part[i].speed != 0 || scene->part[i].waypoints > 0;
    }
    if (!moves) {
        cr_warn(s, "nobody moves; try: place %s speed=50km/h", scene->part[0].id);
        doubts++;
    }
    for (int i = 0; i < scene->n; i++) {
        double speed = fabs(scene->part[i].speed);
        if (speed > cr_mps(200)) {
            cr_warn(s, "%s drives %.0f km/h; the crash tests behind the models end at 70 km/h",
                    scene->part[i].id, cr_kmh(speed));
            doubts++;
        }
    }
    return doubts;
}

static void say_assumed(struct cr_session *s, const struct cr_assumed *assumed) {
    struct cr_str line = {0};
    for (int i = 0; i < assumed->n; i++) {
        cr_str_addf(&line, "%s%s", line.len > 0 ? ", " : "assumed: ", assumed->key[i]);
        if (line.len > 69 || i == assumed->n - 1) {
            cr_say_str(s, &line);
            cr_str_clear(&line);
        }
    }
    cr_str_fini(&line);
}

/* The scene solved again with grid, place and mass nudged; the result keeps what came of it. */
static enum cr_err check_robust(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    int solves = (int)cr_cmd_number(call, "solves", CR_ROBUST_USUAL);
    enum cr_err code = cr_session_need_whole(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_robust_begin(s->result, err);
    for (int i = 0; i < solves && code == CR_ERR_OK; i++) {
        struct cr_context ctx = cr_session_context(s);
        cr_work_begin(s);
        code = cr_robust_step(s->result, &ctx, err);
        cr_work_end(s);
    }
    if (code != CR_ERR_OK) {
        free(s->result->robust); /* of a part nothing can be said */
        s->result->robust = NULL;
        return code;
    }
    int before = s->result->warnings;
    struct cr_str text = {0};
    cr_robust_end(s->result);
    cr_render_robust(s->result, &text);
    cr_session_lines(s, &text, false);
    cr_str_fini(&text);
    for (int i = before; i < s->result->warnings; i++) {
        cr_warn(s, "%s", s->result->warning[i]);
    }
    return CR_ERR_OK;
}

enum cr_err cr_cmd_check(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct cr_scene scene;
    struct cr_assumed assumed = {0};
    struct cr_error found = {0};
    char how[200];
    int faults = 0;
    if (cr_cmd_given(call, "WHAT")) {
        return check_robust(call, err);
    }
    if (cr_session_scene(s)->n < 2) {
        cr_say(s, "a crash needs two participants, there %s %d",
               cr_session_scene(s)->n == 1 ? "is" : "are", cr_session_scene(s)->n);
        cr_say(s, "  try: vehicle A type=compact speed=50km/h; object wall kind=wall; "
                  "place wall facing A");
        return CR_ERR_OK;
    }
    enum cr_err code = cr_session_need_models(s, err);
    if (code == CR_ERR_OK) {
        code = cr_scene_copy(cr_session_scene(s), &scene, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_solver *solver = NULL;
    if (cr_scene_resolve(&scene, s->models, &assumed, &found) != CR_ERR_OK ||
        cr_session_compiled(s, &found) == NULL ||
        cr_result_solver(&scene, &s->compiled->cs, &solver, &found) != CR_ERR_OK) {
        cr_cmd_name_place(cr_session_scene(s), &found);
        cr_say(s, "%s%s%s%s%s", found.where, found.where[0] != '\0' ? ": " : "", found.src,
               found.src[0] != '\0' ? ": " : "", found.text);
        cr_say(s, "  %s", remedy(&found, how, sizeof how));
        faults++;
    }
    cr_solver_free(solver);
    int doubts = check_motion(s, &scene);
    say_assumed(s, &assumed);
    if (faults == 0) {
        cr_say(s, "%s", doubts == 0 ? "ready to solve" : "can be solved, with doubts");
    }
    cr_assumed_fini(&assumed);
    cr_scene_fini(&scene);
    return CR_ERR_OK;
}
