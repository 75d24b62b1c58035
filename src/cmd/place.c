/* place and move: where participants stand, by coordinates or against each other. */
#include "cmd/cmd_priv.h"

#include "scene/keys.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- place ---- */

/* a number of the relation, and whether it was given */
static void take(struct cr_call *call, struct cr_participant *p, const char *name,
                 const char *key_name, double *field) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    const struct cr_key *key = cr_scene_key_find(CR_KEYS_PARTICIPANT, key_name, CR_FOR_ALL);
    double given = cr_cmd_number(call, name, NAN);
    if (cr_cmd_given(call, name) && !isnan(given)) {
        *field = given;
        p->given |= (uint64_t)1 << (key - row);
    }
}

static enum cr_err check_against(struct cr_call *call, const char *id, const char *other,
                                 struct cr_error *err) {
    enum cr_place_side side = (enum cr_place_side)cr_cmd_word(call, "side", CR_SIDE_AUTO);
    if (other == NULL) {
        cr_err_set(err, CR_ERR_MISSING, "%s whom?", cr_cmd_text(call, "HOW", ""));
        cr_err_hint(err, "for example: %s", call->cmd->example[0]);
        return cr_cmd_blame(call, "HOW", CR_ERR_MISSING);
    }
    if (strcmp(id, other) == 0) {
        cr_err_set(err, CR_ERR_NAME, "%s cannot be placed against itself", id);
        return cr_cmd_blame(call, "OTHER", CR_ERR_NAME);
    }
    if (cr_cmd_word(call, "HOW", 0) != CR_PLACE_HITTING &&
        (side == CR_SIDE_FRONT || side == CR_SIDE_REAR)) {
        cr_err_set(err, CR_ERR_NAME, "side=%s is for hitting", cr_cmd_text(call, "side", ""));
        cr_err_hint(err, "side=left, right or centre says which half is met");
        return cr_cmd_blame(call, "side", CR_ERR_NAME);
    }
    return CR_ERR_OK;
}

/* the argument that a message is about */
static const char *fault_of(const struct cr_call *call, const struct cr_error *err) {
    return cr_cmd_given(call, "overlap") && strstr(err->text, "overlap") != NULL ? "overlap"
           : cr_cmd_given(call, "angle") && strstr(err->text, "angle") != NULL   ? "angle"
           : cr_cmd_given(call, "at")                                            ? "at"
                                                                                 : "HOW";
}

static enum cr_err place_against(struct cr_call *call, struct cr_state *draft,
                                 struct cr_participant *p, struct cr_error *err) {
    const char *other = cr_cmd_text(call, "OTHER", NULL);
    char key[CR_NAME_MAX + 16];
    enum cr_err code = check_against(call, p->id, other, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_scene_unplace(p);
    struct cr_stand *s = &p->place;
    snprintf(s->against, sizeof s->against, "%s", other);
    s->how = (enum cr_place_rel)cr_cmd_word(call, "HOW", 0);
    s->side = (enum cr_place_side)cr_cmd_word(call, "side", CR_SIDE_AUTO);
    int at = cr_cmd_word(call, "at", -1); /* a number is no word */
    s->at = at >= 0 ? (enum cr_place_at)at : CR_AT_AUTO;
    take(call, p, "overlap", "place.overlap_percent", &s->overlap);
    if (s->at == CR_AT_AUTO) {
        take(call, p, "at", "place.at_m", &s->at_m);
    }
    take(call, p, "angle", "place.angle_deg", &s->angle);
    take(call, p, "gap", "place.gap_m", &s->gap);
    if (p->kind == CR_KIND_VEHICLE) { /* it drives where it looks */
        snprintf(key, sizeof key, "%s.course_deg", p->id);
        code = cr_scene_set(&draft->scene, key, "auto", err);
    }
    if (code == CR_ERR_OK) {
        code = cr_session_need_models(call->s, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_scene_settle(&draft->scene, call->s->models, err);
    }
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, fault_of(call, err), code);
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
        code = place_against(call, draft, p, err);
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
    }
    if (code == CR_ERR_OK) {
        code = cr_cmd_set_keys(call, &draft->scene, id, err);
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
    cr_cmd_describe(p, line, sizeof line);
    cr_say(call->s, "%s", line);
    return CR_ERR_OK;
}
