/* place and move: where participants stand, by coordinates or against each other. */
#include "cmd/cmd_priv.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- place ---- */

static enum cr_err place_against(struct cr_call *call, struct cr_state *draft,
                                 struct cr_error *err) {
    const char *other = cr_cmd_text(call, "OTHER", NULL);
    struct cr_placed p = {.rel = (enum cr_place_rel)cr_cmd_word(call, "HOW", 0),
                          .side = cr_cmd_word(call, "side", -1),
                          .overlap = cr_cmd_number(call, "overlap", 1),
                          .at_word = cr_cmd_word(call, "at", -1),
                          .at = cr_cmd_number(call, "at", NAN),
                          .angle = cr_cmd_number(call, "angle", NAN),
                          .gap = cr_cmd_number(call, "gap", 0)};
    if (other == NULL) {
        cr_err_set(err, CR_ERR_MISSING, "%s whom?", cr_cmd_text(call, "HOW", ""));
        cr_err_hint(err, "for example: %s", call->cmd->example[0]);
        return cr_cmd_blame(call, "HOW", CR_ERR_MISSING);
    }
    snprintf(p.id, sizeof p.id, "%s", cr_cmd_text(call, "NAME", ""));
    snprintf(p.other, sizeof p.other, "%s", other);
    if (strcmp(p.id, p.other) == 0) {
        cr_err_set(err, CR_ERR_NAME, "%s cannot be placed against itself", p.id);
        return cr_cmd_blame(call, "OTHER", CR_ERR_NAME);
    }
    if (p.rel != CR_PLACE_HITTING && (p.side == CR_SIDE_FRONT || p.side == CR_SIDE_REAR)) {
        cr_err_set(err, CR_ERR_NAME, "side=%s is for hitting", cr_cmd_text(call, "side", ""));
        cr_err_hint(err, "side=left, right or centre says which half is met");
        return cr_cmd_blame(call, "side", CR_ERR_NAME);
    }
    enum cr_err code = cr_session_need_models(call->s, err);
    if (code == CR_ERR_OK) {
        code = cr_placed_apply(draft, &p, call->s->models, err);
    }
    const char *fault =
        cr_cmd_given(call, "overlap") && strstr(err->text, "overlap") != NULL ? "overlap"
        : cr_cmd_given(call, "angle") && strstr(err->text, "angle") != NULL   ? "angle"
        : cr_cmd_given(call, "at")                                            ? "at"
                                                                              : "HOW";
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, fault, code);
}

static void forget_place(struct cr_state *state, const char *id) {
    struct cr_placed *placed = cr_placed_find(state, id);
    if (placed != NULL) {
        placed->id[0] = '\0';
    }
}

enum cr_err cr_cmd_place(struct cr_call *call, struct cr_error *err) {
    static const char *const only_against[] = {"overlap", "side", "at", "angle", "gap"};
    const char *id = cr_cmd_text(call, "NAME", "");
    struct cr_state *draft;
    char line[300];
    enum cr_err code = cr_cmd_edit(call, &draft, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_participant *p = cr_scene_find(&draft->scene, id);
    if (cr_cmd_given(call, "HOW")) {
        code = place_against(call, draft, err);
    }
    for (int i = 0; i < 5 && code == CR_ERR_OK && !cr_cmd_given(call, "HOW"); i++) {
        if (cr_cmd_given(call, only_against[i])) {
            cr_err_set(err, CR_ERR_MISSING, "%s= needs to know against whom", only_against[i]);
            cr_err_hint(err, "for example: %s", call->cmd->example[0]);
            code = cr_cmd_blame(call, only_against[i], CR_ERR_MISSING);
        }
    }
    if (code == CR_ERR_OK && (cr_cmd_given(call, "x") || cr_cmd_given(call, "y"))) {
        code =
            cr_cmd_set_numbers(&draft->scene, id, "position_m", cr_cmd_number(call, "x", p->pos.x),
                               cr_cmd_number(call, "y", p->pos.y), err);
        forget_place(draft, id);
    }
    if (code == CR_ERR_OK) {
        code = cr_cmd_set_keys(call, &draft->scene, id, err);
    }
    if (code == CR_ERR_OK && cr_cmd_given(call, "heading")) {
        forget_place(draft, id);
    }
    if (code == CR_ERR_OK) {
        cr_cmd_describe(p, line, sizeof line);
        cr_say(call->s, "%s", line);
    }
    return code;
}

/* ---- move ---- */

enum cr_err cr_cmd_move(struct cr_call *call, struct cr_error *err) {
    const char *id = cr_cmd_text(call, "NAME", "");
    double dx = cr_cmd_number(call, "dx", 0), dy = cr_cmd_number(call, "dy", 0);
    double turn = cr_cmd_number(call, "turn", 0), faster = cr_cmd_number(call, "speed", 0);
    char line[300];
    struct cr_state *draft;
    if (!cr_cmd_given(call, "dx") && !cr_cmd_given(call, "dy") && !cr_cmd_given(call, "turn") &&
        !cr_cmd_given(call, "speed")) {
        cr_err_set(err, CR_ERR_MISSING, "how far?");
        cr_err_hint(err, "for example: %s", call->cmd->example[0]);
        return CR_ERR_MISSING;
    }
    enum cr_err code = cr_cmd_edit(call, &draft, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_participant *p = cr_scene_find(&draft->scene, id);
    struct cr_vec2 pos = cr_vec2_add(p->pos, cr_vec2(dx, dy));
    code = cr_cmd_set_pose(&draft->scene, id, pos, p->heading + turn, err);
    if (code == CR_ERR_OK && faster != 0) {
        const struct cr_unit *kmh = cr_unit_find("km/h", CR_DIM_SPEED);
        code = cr_cmd_set_numbers(&draft->scene, id, "speed_kmh",
                                  cr_unit_from_si(kmh, p->speed + faster), NAN, err);
    }
    if (code != CR_ERR_OK) {
        return cr_cmd_blame(call, "speed", code);
    }
    forget_place(draft, id);
    cr_cmd_describe(p, line, sizeof line);
    cr_say(call->s, "%s", line);
    return CR_ERR_OK;
}
