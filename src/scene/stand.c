/* Participants that stand against another: the relation is kept in the scene, and the place follows
 * from it whenever type, size, heading or the other one change. */
#include "scene/scene_priv.h"

#include "base/elementary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* where along the flank of a vehicle with known dimensions, m behind its front end */
static double along_of(const struct cr_stand *s, const struct cr_participant *v,
                       const struct cr_model_lib *models) {
    double a = 0, b = 0, front = v->front_overhang;
    if (v->type < CR_TYPES) {
        cr_model_pillars(models, v->type, &a, &b);
    }
    const double places[CR_AT_AUTO] = {
        [CR_AT_FRONT_AXLE] = front,
        [CR_AT_A_PILLAR] = front + a * v->wheelbase,
        [CR_AT_B_PILLAR] = front + b * v->wheelbase,
        [CR_AT_REAR_AXLE] = front + v->wheelbase,
        [CR_AT_CG] = front + v->cg_behind_front_axle,
        [CR_AT_MIDDLE] = v->length / 2,
    };
    return !isnan(s->at_m) ? s->at_m : s->at < CR_AT_AUTO ? places[s->at] : v->length / 2;
}

/* The vehicle slides into a pole with its own flank: the line through the place on the flank along
 * the direction of travel leads through the middle of the pole, as Euro NCAP aims its carriers. */
static enum cr_err flank_at_pole(struct cr_participant *v, const struct cr_participant *pole,
                                 const struct cr_model_lib *models, struct cr_error *err) {
    const struct cr_stand *s = &v->place;
    double sign = s->side == CR_SIDE_RIGHT ? -1 : 1;
    double angle = isnan(s->angle) ? CR_PI / 2 : fabs(s->angle), course = v->heading + sign * angle;
    double along = along_of(s, v, models);
    if (!(angle > cr_rad(10) && angle < cr_rad(170))) {
        return cr_err_set(err, CR_ERR_RANGE, "angle must be 10 to 170 deg for a flank at a pole");
    }
    if (!(along > 0 && along < v->length)) {
        return cr_err_set(err, CR_ERR_RANGE, "at must be within the %.2f m of %s", v->length,
                          v->id);
    }
    double front = v->front_overhang + v->cg_behind_front_axle;
    struct cr_vec2 spot = cr_vec2(front - along, sign * v->width / 2);
    struct cr_vec2 way = cr_vec2_toward(course);
    double ahead = pole->radius / cr_sin(angle) + s->gap;
    struct cr_vec2 pos = cr_vec2_axpy(pole->pos, -ahead, way);
    pos = cr_vec2_sub(pos, cr_vec2_turn(spot, v->heading));
    cr_scene_pose(v, pos, v->heading);
    cr_scene_course(v, course);
    return CR_ERR_OK;
}

static bool is_flank(int side) {
    return side == CR_SIDE_LEFT || side == CR_SIDE_RIGHT;
}

/* against a face of the other one */
static struct cr_place face_place(const struct cr_stand *s, const struct cr_participant *other,
                                  const struct cr_model_lib *models) {
    static const enum cr_face faces[CR_SIDE_AUTO] = {CR_FACE_LEFT, CR_FACE_RIGHT, CR_FACE_FRONT,
                                                     CR_FACE_FRONT, CR_FACE_REAR};
    struct cr_place how = {.rel = s->how,
                           .overlap = s->overlap,
                           .angle = isnan(s->angle) ? 0 : s->angle,
                           .gap = s->gap};
    bool vehicle = other->kind == CR_KIND_VEHICLE;
    bool flank = s->how == CR_PLACE_HITTING || s->how == CR_PLACE_BESIDE;
    how.side = s->side < CR_SIDE_AUTO ? faces[s->side] : vehicle ? CR_FACE_LEFT : CR_FACE_FRONT;
    if (flank && vehicle) {
        bool nowhere = s->at == CR_AT_AUTO && isnan(s->at_m);
        how.along = s->how == CR_PLACE_BESIDE && nowhere ? 0 : along_of(s, other, models);
    } else if (flank) {
        how.along = isnan(s->at_m) ? other->length / 2 : s->at_m;
    }
    if (!flank || cr_face_is_end(how.side)) {
        how.overlap_side = s->side == CR_SIDE_CENTRE ? 0 : s->side == CR_SIDE_RIGHT ? -1 : 1;
    }
    if (s->overlap >= 1) {
        how.overlap_side = 0;
    }
    return how;
}

bool cr_scene_slides(const struct cr_participant *p, const struct cr_participant *other) {
    bool pole = other->kind == CR_KIND_OBJECT && other->shape == CR_OBJECT_POLE;
    return p->place.how == CR_PLACE_HITTING && pole && is_flank((int)p->place.side) &&
           p->kind == CR_KIND_VEHICLE;
}

/* One participant whose other one stands already. */
static enum cr_err stand(struct cr_scene *scene, struct cr_participant *p,
                         const struct cr_model_lib *models, struct cr_error *err) {
    const struct cr_participant *other = cr_scene_find(scene, p->place.against);
    if (cr_scene_slides(p, other)) {
        return flank_at_pole(p, other, models, err);
    }
    struct cr_place how = face_place(&p->place, other, models);
    return cr_scene_place(scene, p->id, p->place.against, &how, err);
}

static enum cr_err fail_at(const struct cr_scene *scene, const struct cr_participant *p,
                           const char *key, enum cr_err code, struct cr_error *err) {
    if (err != NULL && err->where[0] == '\0') {
        snprintf(err->where, sizeof err->where, "/participants/%d/place%s", (int)(p - scene->part),
                 key);
    }
    return code;
}

static enum cr_err check_others(struct cr_scene *scene, struct cr_error *err) {
    for (int i = 0; i < scene->n; i++) {
        const struct cr_participant *p = &scene->part[i];
        if (!cr_scene_is_placed(p)) {
            continue;
        }
        if (strcmp(p->id, p->place.against) == 0) {
            cr_err_set(err, CR_ERR_NAME, "\"%s\" cannot be placed against itself", p->id);
            return fail_at(scene, p, "/against", CR_ERR_NAME, err);
        }
        if (cr_scene_find(scene, p->place.against) == NULL) {
            return fail_at(scene, p, "/against", cr_scene_unknown_id(scene, p->place.against, err),
                           err);
        }
    }
    return CR_ERR_OK;
}

enum cr_err cr_scene_stand(struct cr_scene *scene, const struct cr_model_lib *models,
                           struct cr_error *err) {
    bool waits[CR_BODY_MAX] = {false};
    int left = 0;
    enum cr_err code = check_others(scene, err);
    for (int i = 0; i < scene->n; i++) {
        waits[i] = cr_scene_is_placed(&scene->part[i]);
        left += waits[i];
    }
    /* each round places those whose other one stands; a round without any goes in a circle */
    for (int before = -1; left > 0 && left != before && code == CR_ERR_OK;) {
        before = left;
        for (int i = 0; i < scene->n && code == CR_ERR_OK; i++) {
            struct cr_participant *p = &scene->part[i];
            if (!waits[i] || waits[cr_scene_find(scene, p->place.against) - scene->part]) {
                continue;
            }
            code = stand(scene, p, models, err);
            code = code == CR_ERR_OK ? code : fail_at(scene, p, "", code, err);
            waits[i] = false;
            left--;
        }
    }
    for (int i = 0; i < scene->n && code == CR_ERR_OK; i++) {
        if (waits[i]) {
            cr_err_set(err, CR_ERR_NAME, "\"%s\" is placed against \"%s\" in a circle",
                       scene->part[i].id, scene->part[i].place.against);
            cr_err_hint(err, "one of them needs a place of its own");
            code = fail_at(scene, &scene->part[i], "/against", CR_ERR_NAME, err);
        }
    }
    return code;
}
