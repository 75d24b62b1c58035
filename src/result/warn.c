/* Warns of limits of validity (share/doc/method.md, "Known limits"): each warning says which limit
 * a case exceeds, what that means and what can be done. The limits are the ranges of the tests on
 * which the models were calibrated. */
#include "result/result_priv.h"

#include "base/number.h"
#include "scene/compiled.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A narrower object counts as a pole, m: NHTSA's has 254 mm, a narrow CDC up to 0.41 m
 * [CDC-J224]. */
static const double narrow = 0.41;
/* The full-width wall tests have closing speeds of 40 to 56 km/h [WALL-SPEEDS]; 2 km/h more allow
 * for the scatter of the test speed. */
static const double wall_lo = 38 / 3.6, wall_hi = 58 / 3.6;
/* The side pole tests have 32 km/h [POLE-SPEED]. */
static const double pole_lo = 28 / 3.6, pole_hi = 34 / 3.6;
/* Walls leave fronts without residual crush up to 16 to 20 km/h, the highest that is published
 * [FRONT-START]; with a margin. */
static const double unhurt_hi = 25 / 3.6;
/* EES over depth, 1/s: fronts have 20 to 27 against a wall [WALL-RATE]; with a margin of four. */
static const double slope_hi = 100;
/* No calibrated face was crushed with a higher EES, m/s. */
static const double ees_hi = 65 / 3.6;
/* Measured crashes have no more restitution [RESTITUTION-SPEED]. */
static const double restitution_hi = 0.4;
static const double deep = 0.6;         /* share of the vehicle's length or width */
static const double residual_hi = 1e-6; /* of momentum or energy, relative */
/* Direct damage narrower than this share of the width at one end of the front lies outside the
 * rails (validation.md, small overlap). */
static const double small_overlap = 0.3;

void cr_result_warn(struct cr_result *r, const char *code, const char *fmt, ...) {
    if (r->warnings == CR_WARNING_MAX) {
        snprintf(r->warning[CR_WARNING_MAX - 1], sizeof r->warning[0],
                 "more warnings than can be listed: solve the parts of this scene one by one");
        snprintf(r->warning_code[CR_WARNING_MAX - 1], sizeof r->warning_code[0], "more");
        return;
    }
    snprintf(r->warning_code[r->warnings], sizeof r->warning_code[0], "%s", code);
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(r->warning[r->warnings++], sizeof r->warning[0], fmt, ap);
    va_end(ap);
}

/* Writes a number with as many decimals as tell it from the limit: "EES 66 km/h is above the 66
 * km/h" would be nonsense. */
static const char *beside(double x, double limit, char buf[16]) {
    for (int decimals = 0; decimals <= 6; decimals++) {
        snprintf(buf, 16, "%.*f", decimals, x);
        double shown = strtod(buf, NULL);
        if (shown != limit && (shown > limit) == (x > limit)) {
            break;
        }
    }
    return buf;
}

/* Tells of a mass that nobody gave, because everything else follows it, and of one that contradicts
 * another. */
static void check_mass(struct cr_result *r) {
    for (int i = 0; i < r->resolved.n; i++) {
        double spread = r->assumed.mass_spread[i];
        if (spread > 0) {
            cr_result_warn(r, "mass-assumed",
                           "%s: mass assumed, %.0f kg +- %.0f %% (one standard deviation): EES and "
                           "delta-v follow it",
                           r->resolved.part[i].id, r->resolved.part[i].mass, 100 * spread);
        }
        const struct cr_participant *p = &r->resolved.part[i];
        if (p->kerb_mass > p->mass + 0.5) { /* what is written without decimals may be rounded */
            cr_result_warn(r, "mass-below-kerb",
                           "%s: its mass as crashed, %.0f kg, is less than its kerb mass, %.0f kg: "
                           "a car weighs that much when it is empty; check the two",
                           p->id, p->mass, p->kerb_mass);
        }
    }
}

/* Tells how the old "pdof" was read, whose number is o'clock or degrees by its size alone. */
static void check_pdof(struct cr_result *r) {
    for (int i = 0; i < r->resolved.n; i++) {
        const struct cr_model_choice *m = &r->resolved.part[i].model;
        if (m->pdof_kind == CR_PDOF_OLD) {
            cr_result_warn(r, "pdof-old-form",
                           "%s: \"pdof\" was read as %.6g %s: \"pdof_clock\" and \"pdof_deg\" say "
                           "which of the two is meant",
                           r->resolved.part[i].id,
                           m->pdof_is_clock ? cr_pdof_clock(m->pdof) : cr_round12(cr_deg(m->pdof)),
                           m->pdof_is_clock ? "o'clock" : "deg");
        }
    }
}

static bool is_vehicle(const struct cr_result *r, int i) {
    return r->resolved.part[i].kind == CR_KIND_VEHICLE;
}

static bool is_narrow(const struct cr_participant *p) {
    return p->kind == CR_KIND_OBJECT &&
           ((p->shape == CR_OBJECT_POLE && 2 * p->radius < narrow) ||
            (p->shape == CR_OBJECT_BOX && fmin(p->length, p->width) < narrow));
}

/* Whether the vehicle brings its own model, or its own stiffness of that face. */
static bool has_own(const struct cr_participant *p, int face) {
    return p->model.file[0] != '\0' || p->model.face[face].b > 0;
}

static void check_face(struct cr_result *r, const struct cr_contact *c, int car, int other) {
    const struct cr_severity *s = &r->of[car];
    const struct cr_participant *p = &r->resolved.part[car], *q = &r->resolved.part[other];
    bool side = s->face == CR_FACE_LEFT || s->face == CR_FACE_RIGHT;
    if (side && !is_narrow(q) && !has_own(p, CR_MODEL_SIDE)) {
        cr_result_warn(r, "side-model",
                       "%s: side struck by the wide %s, but the sides of the models rest on narrow "
                       "poles: depth and EES are estimates; own A, B stiffness of the side can be "
                       "given",
                       p->id, q->id);
    }
    if (side && isnan(p->built) && !has_own(p, CR_MODEL_SIDE)) {
        cr_result_warn(
            r, "side-year",
            "%s: side struck, and no model year: flanks of up to 2013 are dented a sixth "
            "deeper than computed, those of 2017 and later a tenth less; give \"built\"",
            p->id);
    }
    /* Only damage at one edge is a small overlap, not that of a narrow object in the middle. */
    bool edge = s->cdc[0] && (s->cdc[3] == 'L' || s->cdc[3] == 'R');
    if (s->face == CR_FACE_FRONT && edge && q->kind == CR_KIND_OBJECT &&
        c->energy[0] + c->energy[1] > 0 && s->contact_width < small_overlap * p->width) {
        cr_result_warn(r, "small-overlap",
                       "%s: small overlap outside the rails: tested cars slid off rounded edges "
                       "and poles, the model holds on; take delta-v and EES as upper bounds",
                       p->id);
    }
}

static void check_contact(struct cr_result *r, const struct cr_contact *c) {
    bool vehicle[2] = {is_vehicle(r, c->a), is_vehicle(r, c->b)};
    int car = vehicle[0] ? c->a : c->b, other = vehicle[0] ? c->b : c->a;
    const char *id = r->resolved.part[car].id, *with = r->resolved.part[other].id;
    enum cr_face face = r->of[car].face;
    if (is_narrow(&r->resolved.part[other]) && !r->compiled->cs.opts.induced) {
        cr_result_warn(r, "no-induced",
                       "%s: narrow object %s without induced deformation: depth comes out about "
                       "twice too large; use method extended or \"induced\": true",
                       id, with);
    }
    bool side = face == CR_FACE_LEFT || face == CR_FACE_RIGHT;
    char number[16];
    double lo = side ? pole_lo : wall_lo, hi = side ? pole_hi : wall_hi;
    if (vehicle[0] != vehicle[1] && (c->closing < lo || c->closing > hi)) {
        double limit = cr_round12(cr_kmh(c->closing < lo ? lo : hi));
        cr_result_warn(r, "extrapolated-speed",
                       "%s: closing speed %s km/h is outside the %.0f to %.0f km/h of the %s "
                       "tests behind the models: depth and EES are extrapolated",
                       id, beside(cr_kmh(c->closing), limit, number), cr_kmh(lo), cr_kmh(hi),
                       side ? "side" : "front");
    }
    for (int k = 0; k < 2; k++) {
        if (vehicle[k]) {
            check_face(r, c, k ? c->b : c->a, k ? c->a : c->b);
        }
    }
    if (c->restitution > restitution_hi) {
        cr_result_warn(r, "restitution",
                       "%s with %s: restitution %s is above the %g of measured crashes; "
                       "set \"restitution\" lower or \"auto\"",
                       id, with, beside(c->restitution, restitution_hi, number), restitution_hi);
    }
}

/* Warns of own A, B that make a face rigid. They hide the energy A^2/2B per width before residual
 * crush begins, which with a small B is more than any crash has; with a great B nothing crushes
 * it. */
static void check_stiffness(struct cr_result *r, const struct cr_participant *p) {
    static const char *const name[] = {"front", "side", "rear"};
    for (int i = 0; i < CR_MODEL_ENDS && p->model.kind == CR_MODEL_STIFFNESS; i++) {
        const struct cr_stiffness *s = &p->model.face[i];
        double width = i == CR_MODEL_SIDE ? p->length : p->width;
        double mass = p->kerb_mass + CR_TEST_LOAD, slope = sqrt(s->b * width / mass);
        double unhurt = s->b > 0 ? s->a * sqrt(width / (s->b * mass)) : 0;
        if (unhurt > unhurt_hi) {
            cr_result_warn(r, "stiffness",
                           "%s: its own A, B leave the %s uncrushed up to an EES of %.0f km/h, "
                           "where tests say 8 to 20: it acts as rigid; check the units, B is too "
                           "small or A too large",
                           p->id, name[i], cr_kmh(unhurt));
        }
        if (slope > slope_hi) {
            cr_result_warn(r, "stiffness",
                           "%s: its own B lets an EES of 50 km/h crush the %s by no more than %.2f "
                           "m, where tests say 0.3 to 0.6: it acts as rigid; check the units, B "
                           "is too large",
                           p->id, name[i], cr_mps(50) / slope);
        }
    }
}

static void check_vehicle(struct cr_result *r, int i) {
    const struct cr_severity *s = &r->of[i];
    const struct cr_participant *p = &r->resolved.part[i];
    check_stiffness(r, p);
    if (s->energy > 0 && s->face == CR_FACE_REAR && !has_own(p, CR_MODEL_REAR)) {
        cr_result_warn(r, "rear-model",
                       "%s: struck at the rear, where the models rest on few tests: EES and "
                       "depth are estimates; own A, B stiffness of the rear can be given",
                       p->id);
    }
    if (s->ees > ees_hi) {
        char number[16];
        double limit = cr_round12(cr_kmh(ees_hi));
        cr_result_warn(r, "extrapolated-ees",
                       "%s: EES %s km/h is above the %.0f km/h of the tests behind the models",
                       p->id, beside(cr_kmh(s->ees), limit, number), limit);
    }
    bool end = cr_face_is_end(s->face);
    double extent = end ? p->length : p->width;
    if (s->deformation_dynamic_max > deep * extent) {
        cr_result_warn(r, "deep",
                       "%s: crushed over %.0f %% of its %s: structures behind that depth are an "
                       "assumption of the model; check masses, speeds and overlap",
                       p->id, 100 * s->deformation_dynamic_max / extent, end ? "length" : "width");
    }
    int out = 0;
    for (int k = 0; k < s->injuries; k++) {
        out += s->injury[k].extrapolated;
    }
    if (out > 0) {
        cr_result_warn(r, "extrapolated-risk",
                       "%s: delta-v %.0f km/h lies outside the range of %d injury risk functions: "
                       "their probabilities are extrapolated and marked so",
                       p->id, cr_kmh(s->delta_v), out);
    }
}

void cr_result_check(struct cr_result *r) {
    const struct cr_solution *sol = r->solution;
    check_mass(r);
    check_pdof(r);
    for (int k = 0; k < sol->contacts; k++) {
        const struct cr_contact *c = &sol->contact[k];
        /* Only the main contact of a body is worth a word; the others belong to the same crash. */
        if (cr_result_main_contact(sol, c->a) == k || cr_result_main_contact(sol, c->b) == k) {
            check_contact(r, c);
        }
    }
    for (int i = 0; i < sol->bodies; i++) {
        if (is_vehicle(r, i)) {
            check_vehicle(r, i);
        }
    }
    const struct cr_balance *b = &sol->balance;
    if (b->momentum_residual > residual_hi || b->energy_residual > residual_hi) {
        cr_result_warn(r, "balance",
                       "the balance does not close: momentum %.1e, energy %.1e of the whole; "
                       "a smaller \"dt_ms\" should cure it, please report the scene",
                       b->momentum_residual, b->energy_residual);
    }
    if (r->resolved.set.end == CR_END_REST) {
        for (int i = 0; i < sol->bodies; i++) {
            bool touched = isfinite(sol->body[i].t_first);
            if (is_vehicle(r, i) && touched && !isfinite(sol->body[i].t_rest)) {
                cr_result_warn(r, "not-at-rest",
                               "%s: still moving after %.0f s; brake it or take its rest "
                               "position as that instant's",
                               r->resolved.part[i].id, r->compiled->cs.opts.rest_time);
            }
        }
    }
}
