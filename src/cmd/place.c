/* place and move: where participants stand, by coordinates or against each other. */
#include "cmd/cmd_priv.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct cr_placed *cr_placed_find(struct cr_state *state, const char *id) {
    for (int i = 0; i < CR_BODY_MAX; i++) {
        if (state->placed[i].id[0] != '\0' && strcmp(state->placed[i].id, id) == 0) {
            return &state->placed[i];
        }
    }
    return NULL;
}

static void remember(struct cr_state *state, const struct cr_placed *placed) {
    struct cr_placed *row = cr_placed_find(state, placed->id);
    for (int i = 0; i < CR_BODY_MAX && row == NULL; i++) {
        row = state->placed[i].id[0] == '\0' ? &state->placed[i] : NULL;
    }
    if (row != NULL) {
        *row = *placed;
    }
}

static enum cr_err set_numbers(struct cr_scene *scene, const char *id, const char *key, double x,
                               double y, struct cr_error *err) {
    char full[CR_NAME_MAX + 32], value[80];
    snprintf(full, sizeof full, "%s.%s", id, key);
    if (isnan(y)) {
        snprintf(value, sizeof value, "%.17g", x);
    } else {
        snprintf(value, sizeof value, "%.17g,%.17g", x, y);
    }
    return cr_scene_set(scene, full, value, err);
}

static enum cr_err set_pose(struct cr_scene *scene, const char *id, struct cr_vec2 pos,
                            double heading, struct cr_error *err) {
    enum cr_err code = set_numbers(scene, id, "position_m", pos.x, pos.y, err);
    const struct cr_unit *deg = cr_unit_find("deg", CR_DIM_ANGLE);
    return code != CR_ERR_OK ? code
                             : set_numbers(scene, id, "heading_deg",
                                           cr_unit_from_si(deg, cr_angle_wrap(heading)), NAN, err);
}

/* where along the flank of a vehicle with known dimensions, m behind its front end */
static double along_of(const struct cr_placed *p, const struct cr_participant *v,
                       const struct cr_model_lib *models) {
    double a = 0, b = 0, front = v->front_overhang;
    if (v->type < CR_TYPES) {
        cr_model_pillars(models, v->type, &a, &b);
    }
    const double places[] = {front,
                             front + a * v->wheelbase,
                             front + b * v->wheelbase,
                             front + v->wheelbase,
                             front + v->cg_behind_front_axle,
                             v->length / 2};
    if (p->at_word >= 0) {
        return places[p->at_word];
    }
    return isnan(p->at) ? v->length / 2 : p->at;
}

/* The vehicle slides into a pole with its own flank: the line through the place on the flank along
 * the direction of travel leads through the middle of the pole, as Euro NCAP aims its carriers. */
static enum cr_err flank_at_pole(struct cr_state *state, const struct cr_placed *p,
                                 const struct cr_participant *v, const struct cr_participant *pole,
                                 const struct cr_model_lib *models, struct cr_error *err) {
    double sign = p->side == CR_SIDE_RIGHT ? -1 : 1;
    double angle = isnan(p->angle) ? CR_PI / 2 : fabs(p->angle), course = v->heading + sign * angle;
    double along = along_of(p, v, models);
    if (!(angle > cr_rad(10) && angle < cr_rad(170))) {
        return cr_err_set(err, CR_ERR_RANGE, "angle must be 10 to 170 deg for a flank at a pole");
    }
    if (!(along > 0 && along < v->length)) {
        return cr_err_set(err, CR_ERR_RANGE, "at must be within the %.2f m of %s", v->length,
                          v->id);
    }
    double front = v->front_overhang + v->cg_behind_front_axle;
    struct cr_vec2 spot = cr_vec2(front - along, sign * v->width / 2);
    struct cr_vec2 way = cr_vec2(cos(course), sin(course));
    double ahead = pole->radius / sin(angle) + p->gap;
    struct cr_vec2 pos = cr_vec2_axpy(pole->pos, -ahead, way);
    pos = cr_vec2_sub(pos, cr_vec2_rotate(spot, cos(v->heading), sin(v->heading)));
    enum cr_err code = set_pose(&state->scene, v->id, pos, v->heading, err);
    const struct cr_unit *deg = cr_unit_find("deg", CR_DIM_ANGLE);
    return code != CR_ERR_OK ? code
                             : set_numbers(&state->scene, v->id, "course_deg",
                                           cr_unit_from_si(deg, cr_angle_wrap(course)), NAN, err);
}

static bool is_flank(int side) {
    return side == CR_SIDE_LEFT || side == CR_SIDE_RIGHT;
}

/* against a face of the other one */
static struct cr_place face_place(const struct cr_placed *p, const struct cr_participant *other,
                                  const struct cr_model_lib *models) {
    static const enum cr_face faces[] = {CR_FACE_LEFT, CR_FACE_RIGHT, CR_FACE_FRONT, CR_FACE_FRONT,
                                         CR_FACE_REAR};
    struct cr_place how = {.rel = p->rel,
                           .overlap = p->overlap,
                           .angle = isnan(p->angle) ? 0 : p->angle,
                           .gap = p->gap};
    bool vehicle = other->kind == CR_KIND_VEHICLE;
    bool flank = p->rel == CR_PLACE_HITTING || p->rel == CR_PLACE_BESIDE;
    how.side = p->side >= 0 ? faces[p->side] : vehicle ? CR_FACE_LEFT : CR_FACE_FRONT;
    if (flank && vehicle) {
        how.along = p->rel == CR_PLACE_BESIDE && p->at_word < 0 && isnan(p->at)
                        ? 0
                        : along_of(p, other, models);
    } else if (flank) {
        how.along = isnan(p->at) ? other->length / 2 : p->at;
    }
    if (!flank || cr_face_is_end(how.side)) {
        how.overlap_side = p->side == CR_SIDE_CENTRE ? 0 : p->side == CR_SIDE_RIGHT ? -1 : 1;
    }
    if (p->overlap >= 1) {
        how.overlap_side = 0;
    }
    return how;
}

enum cr_err cr_placed_apply(struct cr_state *state, const struct cr_placed *placed,
                            const struct cr_model_lib *models, struct cr_error *err) {
    struct cr_scene full;
    enum cr_err code = cr_scene_copy(&state->scene, &full, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_scene_resolve(&full, models, NULL, err);
    if (code != CR_ERR_OK) {
        goto out;
    }
    const struct cr_participant *part = cr_scene_find(&full, placed->id);
    const struct cr_participant *other = cr_scene_find(&full, placed->other);
    bool pole = other->kind == CR_KIND_OBJECT && other->shape == CR_OBJECT_POLE;
    if (placed->rel == CR_PLACE_HITTING && pole && is_flank(placed->side) &&
        part->kind == CR_KIND_VEHICLE) {
        code = flank_at_pole(state, placed, part, other, models, err);
    } else {
        struct cr_place how = face_place(placed, other, models);
        code = cr_scene_place(&full, placed->id, placed->other, &how, err);
        if (code == CR_ERR_OK) {
            code = set_pose(&state->scene, placed->id, part->pos, part->heading, err);
        }
        if (code == CR_ERR_OK && part->kind == CR_KIND_VEHICLE) { /* it drives where it looks */
            char key[CR_NAME_MAX + 16];
            snprintf(key, sizeof key, "%s.course_deg", placed->id);
            code = cr_scene_set(&state->scene, key, "auto", err);
        }
    }
    if (code == CR_ERR_OK) {
        remember(state, placed);
    }
out:
    cr_scene_fini(&full);
    return code;
}

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
        code = set_numbers(&draft->scene, id, "position_m", cr_cmd_number(call, "x", p->pos.x),
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
    code = set_pose(&draft->scene, id, pos, p->heading + turn, err);
    if (code == CR_ERR_OK && faster != 0) {
        const struct cr_unit *kmh = cr_unit_find("km/h", CR_DIM_SPEED);
        code = set_numbers(&draft->scene, id, "speed_kmh", cr_unit_from_si(kmh, p->speed + faster),
                           NAN, err);
    }
    if (code != CR_ERR_OK) {
        return cr_cmd_blame(call, "speed", code);
    }
    forget_place(draft, id);
    cr_cmd_describe(p, line, sizeof line);
    cr_say(call->s, "%s", line);
    return CR_ERR_OK;
}
