/* How a participant stands against another, remembered so that it can be placed again. */
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
    enum cr_err code = cr_cmd_set_pose(&state->scene, v->id, pos, v->heading, err);
    const struct cr_unit *deg = cr_unit_find("deg", CR_DIM_ANGLE);
    return code != CR_ERR_OK
               ? code
               : cr_cmd_set_numbers(&state->scene, v->id, "course_deg",
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
            code = cr_cmd_set_pose(&state->scene, placed->id, part->pos, part->heading, err);
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
