/* Warns of doubts about a result, each with a code: bodies that went through each other, spikes,
 * crush beyond the A-pillar, contacts that ended while bodies still approached, implausible
 * inputs. */
#include "result/result_priv.h"

#include "base/elementary.h"
#include "scene/compiled.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A plastic phase shorter than this with more than that is no crash pulse, s and m/s2. */
static const double spike_time = 0.015, spike_acceleration = 60 * CR_G;
/* A crash pulse lasts 0.05 to 0.25 s; bodies that press on each other for longer than this rub
 * while they roll on side by side, s (our choice). */
static const double rubs_time = 0.5;
/* From this share of the energy outside the contact on, EES rests more on the model of induced
 * damage than on the contact. */
static const double much_induced = 0.5;
/* From this ratio of friction energy to deformation energy on a crash grazes. Of 240 random
 * crashes, solved again with half the voxel and slice, the 21 above it change their EES by 19 %
 * (median; 47 % the 90th percentile), the others by 0.4 and 2.8 %. */
static const double grazing = 0.5;
/* A contact that ends for want of overlap must not leave more approach than this, m/s. */
static const double still_approaching = 0.5;
/* A direction of force nearer than this to the border of two clock hours is in doubt, rad. */
static const double border = CR_PI / 90;
/* A mass, length or inertia may differ by this share from what type and size give. */
static const double plausible = 0.4;

static const char *const codes[] = {
    "through",          "a-pillar",           "deep",        "spike",
    "induced",          "closed-approaching", "grazing",     "pdof-border",
    "balance",          "pdof-unsettled",     "interrupted", "not-resolved",
    "trajectory-speed", "trajectory-jump"};

bool cr_result_is_doubt(const char *code) {
    for (size_t i = 0; i < sizeof codes / sizeof codes[0]; i++) {
        if (strcmp(codes[i], code) == 0) {
            return true;
        }
    }
    return false;
}

/* Whether a point is on the inner side of all edges of a counter-clockwise polygon. Of a polygon
 * that is not convex this misses parts, which is on the safe side: fewer warnings. */
static bool in_polygon(const struct cr_shape *s, struct cr_vec2 p) {
    bool in = true;
    for (int i = 0; i < s->n; i++) {
        struct cr_vec2 a = s->vertex[i], b = s->vertex[(i + 1) % s->n];
        in = in && cr_vec2_cross(cr_vec2_sub(b, a), cr_vec2_sub(p, a)) > 0;
    }
    return in;
}

/* Whether a point lies inside a body's undeformed outline, own frame; of a grid its box counts. */
static bool is_inside(const struct cr_body *body, struct cr_vec2 p) {
    const struct cr_grid *g = &body->grid;
    switch (body->shape.kind) {
    case CR_SHAPE_WALL:
        return p.x < 0;
    case CR_SHAPE_POLE:
        return cr_vec2_len(p) < body->shape.radius;
    case CR_SHAPE_POLYGON:
        return in_polygon(&body->shape, p);
    case CR_SHAPE_NONE:
        break;
    }
    return p.x > g->x0 && p.x < g->x0 + g->nx * g->h && p.y > g->y0 && p.y < g->y0 + g->ny * g->h;
}

static const struct cr_sample *sample(const struct cr_solution *sol, int k, int body) {
    return &sol->trace[(long)k * sol->bodies + body];
}

/* Whether the CG of the one lay inside the other at any time of the impact. */
static bool swallowed(const struct cr_result *r, const struct cr_impact *k, int side) {
    const struct cr_solution *sol = r->solution;
    int i = k->body[side], other = k->body[!side];
    if (!cr_result_moves(r, i)) { /* a fixed barrier's place is its face, not its CG */
        return false;
    }
    for (int n = 0; n < sol->samples; n++) {
        if (sol->t[n] < k->t_begin || sol->t[n] > k->t_end) {
            continue;
        }
        const struct cr_sample *own = sample(sol, n, i), *it = sample(sol, n, other);
        struct cr_vec2 p = cr_vec2_turn(cr_vec2_sub(own->pos, it->pos), -it->heading);
        if (is_inside(&r->compiled->cs.body[other], p)) {
            return true;
        }
    }
    return false;
}

/* Whether the one is crushed over nearly all of its length or width behind the struck face. */
static bool cut_through(const struct cr_result *r, const struct cr_impact *k, int side) {
    const struct cr_participant *p = &r->resolved.part[k->body[side]];
    const struct cr_severity *s = &k->of[side];
    return s->face_depth_dynamic > 0.95 * (cr_face_is_end(s->face) ? p->length : p->width);
}

static void check_through(struct cr_result *r, const struct cr_impact *k) {
    const char *a = r->resolved.part[k->body[0]].id, *b = r->resolved.part[k->body[1]].id;
    for (int side = 0; side < 2; side++) {
        bool car = cr_result_grid(r, k->body[side])->nx > 0;
        if (car && (swallowed(r, k, side) || cut_through(r, k, side))) {
            cr_result_warn(r, "through",
                           "%s and %s went through each other: %s; no value of this impact can be "
                           "relied on, check speeds, masses and heights",
                           a, b,
                           swallowed(r, k, side) ? "the centre of gravity of the one lay inside "
                                                   "the other"
                                                 : "the one was cut through");
            return;
        }
    }
}

/* The speed at which the bodies still approach at the COE when the impact ends, m/s. */
static double approach_at_end(const struct cr_result *r, const struct cr_impact *k) {
    const struct cr_sample *s[2];
    struct cr_vec2 v[2];
    for (int i = 0; i < 2; i++) {
        s[i] = cr_result_motion_at(r->solution, k->body[i], k->t_end + 1e-9);
        v[i] =
            cr_vec2_axpy(s[i]->vel, s[i]->yaw_rate, cr_vec2_perp(cr_vec2_sub(k->coe, s[i]->pos)));
    }
    return cr_vec2_dot(cr_vec2_sub(v[0], v[1]), k->normal);
}

/* Where bodies slide along each other a thin contact decides, whose edges the grid rounds. */
static void check_grazing(struct cr_result *r, const struct cr_impact *k) {
    double energy = k->of[0].energy + k->of[1].energy;
    if (energy > 0 && k->friction > grazing * energy) {
        cr_result_warn(r, "grazing",
                       "%s and %s graze each other (%.1f kJ of friction, %.1f kJ of deformation): "
                       "EES is good to 20 %% at best; compare with half the voxel",
                       r->resolved.part[k->body[0]].id, r->resolved.part[k->body[1]].id,
                       k->friction / 1e3, energy / 1e3);
    }
}

static void check_rubbing(struct cr_result *r, const struct cr_impact *k) {
    double pulse = fmax(k->of[0].pulse, k->of[1].pulse);
    if (pulse > rubs_time) {
        cr_result_warn(
            r, "rubbing",
            "%s and %s rub against each other for %.1f s from %.2f s on: that is no crash "
            "pulse, and what their tyres do in that time is in its delta-v",
            r->resolved.part[k->body[0]].id, r->resolved.part[k->body[1]].id, pulse, k->t_begin);
    }
}

static void check_impact(struct cr_result *r, const struct cr_impact *k) {
    check_through(r, k);
    check_rubbing(r, k);
    check_grazing(r, k);
    double left = approach_at_end(r, k);
    if (k->stop == CR_STOP_NO_OVERLAP && left > still_approaching) {
        cr_result_warn(r, "closed-approaching",
                       "%s and %s still approach by %.1f km/h when their contact ends for want of "
                       "material: they slide or slip past each other, or something is missing",
                       r->resolved.part[k->body[0]].id, r->resolved.part[k->body[1]].id,
                       cr_kmh(left));
    }
    for (int side = 0; side < 2; side++) {
        const struct cr_severity *s = &k->of[side];
        const char *id = r->resolved.part[k->body[side]].id;
        double plastic = k->t_plastic_end - k->t_begin;
        if (plastic < spike_time && s->acceleration_max > spike_acceleration) {
            cr_result_warn(r, "spike",
                           "%s: %.0f g in a plastic phase of %.0f ms is no crash pulse: take its "
                           "delta-v, not its accelerations",
                           id, s->acceleration_max / CR_G, 1e3 * plastic);
        }
        if (s->energy > 0 && s->energy_induced > much_induced * s->energy) {
            cr_result_warn(r, "induced",
                           "%s: %.0f %% of its energy went in outside the contact: EES rests on "
                           "the model of what is dragged along",
                           id, 100 * s->energy_induced / s->energy);
        }
    }
}

/* How far behind the front end the A-pillar stands, m; infinite where the type has none. */
static double a_pillar(const struct cr_participant *p, const struct cr_model_lib *models) {
    double a = 0, b = 0;
    if (p->type >= CR_TYPES || models == NULL) {
        return INFINITY;
    }
    cr_model_pillars(models, p->type, &a, &b);
    return p->front_overhang + a * p->wheelbase;
}

/* Warns of a value far from the usual one; where pounds or feet would explain it, that is said. */
static void check_value(struct cr_result *r, const char *id, const char *name, double x,
                        double usual) {
    if (!(usual > 0) || fabs(x / usual - 1) <= plausible) {
        return;
    }
    double unit = strcmp(name, "mass") == 0 ? 0.45359237 : strcmp(name, "length") == 0 ? 0.3048 : 0;
    char guess[60] = "";
    if (unit > 0 && fabs(unit * x / usual - 1) < plausible / 2) {
        snprintf(guess, sizeof guess, "; if it is in %s it is %.4g here", unit > 0.4 ? "lb" : "ft",
                 unit * x);
    }
    cr_result_warn(r, "implausible", "%s: %s %.4g is far from the %.4g that type and size give%s",
                   id, name, x, usual, guess);
}

/* Compares length, mass and yaw inertia with what type and size give: the mass of the tested cars
 * grows with a power of the length, as the medians of the classes do. */
static void check_inputs(struct cr_result *r, int i, const struct cr_model_lib *models) {
    const struct cr_participant *p = &r->resolved.part[i];
    double mass;
    if (models == NULL || p->type >= CR_TYPES) {
        return;
    }
    const struct cr_dims *ref = cr_model_dims(models, p->type, &mass);
    check_value(r, p->id, "length", p->length, ref->length);
    if (fabs(p->length / ref->length - 1) > plausible) {
        return; /* mass and inertia would be judged by a wrong size */
    }
    double size = cr_clamp(p->length / ref->length, 0.6, 1.6);
    check_value(r, p->id, "mass", p->mass, mass * cr_pow(size, 2.7));
    check_value(r, p->id, "yaw inertia", p->yaw_inertia,
                0.137 * p->mass * p->length * p->wheelbase);
}

static void check_vehicle(struct cr_result *r, int i, const struct cr_model_lib *models) {
    const struct cr_severity *s = &r->of[i];
    const struct cr_participant *p = &r->resolved.part[i];
    double pillar = a_pillar(p, models);
    if (s->face == CR_FACE_FRONT && s->face_depth_dynamic > pillar) {
        cr_result_warn(
            r, "a-pillar",
            "%s: crushed by %.2f m, beyond the A-pillar at %.2f m: the compartment is an "
            "assumption of the model",
            p->id, s->face_depth_dynamic, pillar);
    }
    bool chosen =
        p->model.pdof_kind == CR_PDOF_AUTO && p->model.kind == CR_MODEL_TYPE && !p->model.blend;
    double off = fabs(fmod(s->pdof + CR_PI / 12, CR_PI / 6));
    off = fmin(off, CR_PI / 6 - off);
    if (s->delta_v > 0 && chosen && off < border) {
        cr_result_warn(
            r, "pdof-border",
            "%s: the force comes from %.0f deg, at the border of two hours of the clock: "
            "its model might as well be the other; \"blend\": true mixes them",
            p->id, cr_bearing_deg(s->pdof));
    }
}

void cr_result_quality(struct cr_result *r, const struct cr_model_lib *models) {
    for (int i = 0; i < r->impacts; i++) {
        check_impact(r, &r->impact[i]);
    }
    for (int i = 0; i < r->solution->bodies; i++) {
        if (r->resolved.part[i].kind == CR_KIND_VEHICLE) {
            check_inputs(r, i, models);
            check_vehicle(r, i, models);
        }
    }
}
