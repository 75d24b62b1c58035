/* Computes what is reported of a finished solution: EES, delta-v, PDOF, pulse, damage and injury
 * risk, for each impact and in all (share/doc/sources.md, "Measures"). */
#include "result/result_priv.h"

#include "base/elementary.h"
#include "result/damage.h"
#include "result/pulse.h"
#include "scene/compiled.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A pulse record is at least this long, s: OLC and VPI need the time after the contact too. */
static const double record = 0.3;
/* The tail of a pulse does not count below this share of the greatest acceleration. */
static const double tail = 0.05;

int cr_result_main_contact(const struct cr_solution *sol, int body) {
    int best = -1;
    double top = -1;
    for (int k = 0; k < sol->contacts; k++) {
        const struct cr_contact *c = &sol->contact[k];
        double impulse = cr_vec2_len(c->impulse);
        if ((body < 0 || c->a == body || c->b == body) && impulse > top) {
            top = impulse;
            best = k;
        }
    }
    return best;
}

double cr_result_pdof(struct cr_vec2 dv) {
    /* The impulse comes from the side opposite to the velocity change; right is -y. */
    double pdof = cr_atan2(dv.y, -dv.x);
    if (pdof < 0) {
        pdof += 2 * CR_PI;
    }
    /* Straight ahead is 0, to whichever side rounding falls. */
    return pdof > 2 * CR_PI - 1e-12 ? 0 : pdof;
}

/* What the functions below share. */
struct taking {
    struct cr_result *r;
    const struct cr_events *all;
    const struct cr_irf_set *irf;
    struct cr_error *err;
};

static int impacts_of(const struct cr_events *all, int body) {
    int n = 0;
    for (int i = 0; i < all->n; i++) {
        n += all->event[i].body[0] == body || all->event[i].body[1] == body;
    }
    return n;
}

/* Names the model of a vehicle. Where the direction of the force mixes the sectors' strengths, the
 * name is that of the sector in which the force lies. */
static void name_model(const struct cr_result *r, int i, struct cr_severity *s) {
    const struct cr_participant *p = &r->resolved.part[i];
    memcpy(s->model, r->compiled->model[i], sizeof s->model);
    if (cr_scene_by_push(p) && p->model.kind != CR_MODEL_STIFFNESS) {
        snprintf(s->model, sizeof s->model, "%s/%d", cr_type_word(p->type), s->pdof_clock);
    }
}

static void measure_motion(const struct taking *t, const struct cr_event *e, int side,
                           struct cr_severity *s) {
    const struct cr_result *r = t->r;
    const struct cr_event_body *of = &e->of[side];
    int i = e->body[side], last = e->first + e->samples - 1;
    double mass = cr_result_mass(r, i);
    const struct cr_sample *before = cr_event_before(r->solution, e, i);
    const struct cr_sample *after =
        last < 0 ? before : &r->solution->trace[(long)last * r->solution->bodies + i];
    s->impacts = 1;
    s->severest = (int)(e - t->all->event);
    s->energy = of->energy;
    s->energy_induced = of->induced;
    s->ees = mass > 0 ? sqrt(2 * of->energy / mass) : 0;
    s->coe = of->coe;
    s->delta_v_world = of->delta_v;
    s->delta_v_body = cr_vec2_turn(of->delta_v, -before->heading);
    s->delta_v = s->delta_v_net = cr_vec2_len(of->delta_v);
    s->pdof = cr_result_pdof(s->delta_v_body);
    s->pdof_clock = cr_pdof_clock(s->pdof);
    s->yaw_rate_change = of->yaw_change;
    s->speed_after = cr_vec2_len(after->vel);
    s->course_after = cr_atan2(after->vel.y, after->vel.x);
    s->yaw_rate_after = after->yaw_rate;
    s->t_depth_max = e->t_elastic_end - r->solution->body[i].t_first;
    name_model(r, i, s);
}

static enum cr_err filter(struct cr_pulse *p, struct cr_error *err) {
    enum cr_err code = cr_cfc_filter(60, p->dt, p->along, p->n, err);
    code = code ? code : cr_cfc_filter(60, p->dt, p->ax, p->n, err);
    return code ? code : cr_cfc_filter(60, p->dt, p->ay, p->n, err);
}

/* Time within the body's impacts with an acceleration of at least `least`, s. */
static double lasting(const struct cr_events *all, int body, const struct cr_pulse *p,
                      double least) {
    double sum = 0, until = -INFINITY;
    for (int i = 0; i < all->n; i++) {
        const struct cr_event *e = &all->event[i];
        if (e->body[0] == body || e->body[1] == body) {
            double from = fmax(e->t_begin, until);
            sum += cr_pulse_lasting(p, least, from, e->t_end);
            until = fmax(until, e->t_end);
        }
    }
    return sum;
}

/* Measures the pulse of the body as an accelerometer in it records it, with tyres and all its
 * impacts. */
static enum cr_err measure_record(const struct taking *t, int i, struct cr_severity *s) {
    const struct cr_outcome *o = &t->r->solution->body[i];
    struct cr_vec2 u = cr_vec2_unit(s->delta_v_world, cr_vec2(1, 0));
    struct cr_pulse p;
    enum cr_err code = cr_pulse_new(t->r->solution, i, u, record, &p, t->err);
    if (code) {
        return code;
    }
    int start = (int)lround((o->t_first - p.t0) / p.dt);
    s->asi = cr_pulse_asi(p.ax, p.ay, p.n, p.dt);
    s->thiv = cr_pulse_thiv(&p, start, &s->phd);
    code = filter(&p, t->err);
    if (!code) {
        s->olc = cr_pulse_olc(p.along + start, p.n - start, p.dt);
        s->vpi = cr_pulse_vpi(p.along + start, p.n - start, p.dt);
        s->acceleration_max = cr_pulse_peak(&p, &s->t_max);
        s->t_max -= o->t_first;
        s->pulse = lasting(t->all, i, &p, tail * s->acceleration_max);
        s->acceleration_mean = s->pulse > 0 ? s->delta_v / s->pulse : 0;
    }
    cr_pulse_fini(&p);
    return code;
}

/* Measures the pulse of one impact among several. */
static enum cr_err measure_pulse(const struct taking *t, const struct cr_event *e, int side,
                                 struct cr_severity *s) {
    struct cr_pulse p;
    enum cr_err code = cr_pulse_of_event(t->r->solution, e, side, &p, t->err);
    if (code) {
        return code;
    }
    code = filter(&p, t->err);
    if (!code) {
        s->acceleration_max = cr_pulse_peak(&p, &s->t_max);
        s->t_max -= t->r->solution->body[e->body[side]].t_first;
        s->pulse = cr_pulse_lasting(&p, tail * s->acceleration_max, e->t_begin, e->t_end);
        s->acceleration_mean = s->pulse > 0 ? s->delta_v / s->pulse : 0;
    }
    cr_pulse_fini(&p);
    return code;
}

static void measure_injury(const struct taking *t, const struct cr_event *e, int side,
                           struct cr_severity *s) {
    int own = e->body[side], other = e->body[!side];
    const struct cr_sample *a = cr_event_before(t->r->solution, e, own);
    const struct cr_sample *b = cr_event_before(t->r->solution, e, other);
    struct cr_irf_case what = {.words = t->r->resolved.set.injury,
                               .delta_v = s->delta_v,
                               .closing = cr_vec2_len(cr_vec2_sub(a->vel, b->vel)),
                               .ees = s->ees,
                               .pdof = s->pdof,
                               .vehicle_partner =
                                   t->r->resolved.part[other].kind == CR_KIND_VEHICLE};
    cr_irf_apply(t->irf, &what, s);
}

static enum cr_err measure_side(const struct taking *t, int event, int side, const short *owner) {
    const struct cr_event *e = &t->all->event[event];
    struct cr_severity *s = &t->r->impact[event].of[side];
    int i = e->body[side];
    const struct cr_body *body = &t->r->compiled->cs.body[i];
    enum cr_err code = CR_ERR_OK;
    s->second.face = CR_FACES;
    measure_motion(t, e, side, s);
    if (body->mass > 0 && impacts_of(t->all, i) == 1) {
        code = measure_record(t, i, s);
    } else if (body->mass > 0) {
        code = measure_pulse(t, e, side, s);
    }
    if (!code && t->r->solution->body[i].left != NULL) {
        struct cr_damage_case what = {t->r, t->all, event, side, owner};
        code = cr_damage_measure(&what, s, t->err);
    }
    if (!code && t->r->resolved.part[i].kind == CR_KIND_VEHICLE) {
        measure_injury(t, e, side, s);
    }
    return code;
}

static enum cr_err measure_impacts(const struct taking *t, int body) {
    short *owner = NULL;
    enum cr_err code = CR_ERR_OK;
    if (impacts_of(t->all, body) > 1 && t->r->solution->body[body].left != NULL) {
        code = cr_damage_owners(t->r, t->all, body, &owner, t->err);
    }
    for (int i = 0; i < t->all->n && !code; i++) {
        const struct cr_event *e = &t->all->event[i];
        for (int side = 0; side < 2 && !code; side++) {
            code = e->body[side] == body ? measure_side(t, i, side, owner) : CR_ERR_OK;
        }
    }
    free(owner);
    return code;
}

/* Adds one impact of the body to its totals, which begin as those of the severest. */
static void add_up(const struct cr_severity *one, double heading, struct cr_severity *s) {
    s->impacts++;
    s->delta_v += one->delta_v;
    s->delta_v_world = cr_vec2_add(s->delta_v_world, one->delta_v_world);
    s->delta_v_body = cr_vec2_turn(s->delta_v_world, -heading);
    s->delta_v_net = cr_vec2_len(s->delta_v_world);
    s->yaw_rate_change += one->yaw_rate_change;
    s->deformation_area += one->deformation_area;
    s->area_contact += one->area_contact;
    s->area_induced += one->area_induced;
    s->deformation_max = fmax(s->deformation_max, one->deformation_max);
    s->deformation_dynamic_max = fmax(s->deformation_dynamic_max, one->deformation_dynamic_max);
}

/* The impact in which the body's velocity changed most; NULL without any. */
static const struct cr_severity *severest(const struct cr_result *r, int body) {
    const struct cr_severity *best = NULL;
    for (int i = 0; i < 2 * r->impacts; i++) {
        const struct cr_severity *s = &r->impact[i / 2].of[i % 2];
        if (r->impact[i / 2].body[i % 2] == body && (best == NULL || s->delta_v > best->delta_v)) {
            best = s;
        }
    }
    return best;
}

static void measure_totals(const struct taking *t, int body, struct cr_severity *s) {
    const struct cr_result *r = t->r;
    const struct cr_outcome *o = &r->solution->body[body];
    const struct cr_severity *main = severest(r, body);
    double mass = cr_result_mass(r, body);
    if (main != NULL) {
        *s = *main;
    } else {
        s->severest = -1;
        s->second.face = CR_FACES;
    }
    if (main == NULL || main->impacts < impacts_of(t->all, body)) {
        s->impacts = 0;
        s->delta_v = s->yaw_rate_change = s->deformation_area = 0;
        s->area_contact = s->area_induced = 0;
        s->delta_v_world = cr_vec2(0, 0);
        for (int i = 0; i < 2 * r->impacts; i++) {
            if (r->impact[i / 2].body[i % 2] == body) {
                add_up(&r->impact[i / 2].of[i % 2], o->before.heading, s);
            }
        }
    }
    name_model(r, body, s);
    s->energy = o->energy;
    s->energy_induced = o->induced;
    s->ees = mass > 0 ? sqrt(2 * o->energy / mass) : 0;
    s->speed_after = cr_vec2_len(o->after.vel);
    s->course_after = cr_atan2(o->after.vel.y, o->after.vel.x);
    s->yaw_rate_after = o->after.yaw_rate;
}

/* Takes the outline of the material that is left, after springback. */
static enum cr_err measure_outline(const struct taking *t, int body, struct cr_severity *s) {
    struct cr_deform d = cr_damage_of(t->r, body);
    const struct cr_grid *g = d.grid;
    double *left = malloc((size_t)g->nx * (size_t)g->ny * sizeof *left);
    if (!left) {
        return cr_err_set(t->err, CR_ERR_MEMORY, "no memory for an outline");
    }
    cr_deform_relax(&d, s->face, left);
    enum cr_err code = cr_deform_outline(g, left, g->h / 4, &s->outline, &s->outline_n, t->err);
    free(left);
    return code;
}

static enum cr_err measure_body(const struct taking *t, int i) {
    const struct cr_outcome *o = &t->r->solution->body[i];
    struct cr_severity *s = &t->r->of[i];
    free(s->outline);
    memset(s, 0, sizeof *s);
    bool touched = isfinite(o->t_first) && isfinite(o->t_last) && o->t_last > o->t_first;
    enum cr_err code = touched ? measure_impacts(t, i) : CR_ERR_OK;
    if (code) {
        return code;
    }
    measure_totals(t, i, s);
    if (touched && cr_result_moves(t->r, i) && s->impacts > 1) {
        code = measure_record(t, i, s);
    }
    if (!code && touched && o->left != NULL) {
        code = measure_outline(t, i, s);
    }
    return code;
}

static void take_impact(const struct cr_event *e, struct cr_impact *to) {
    *to = (struct cr_impact){.body = {e->body[0], e->body[1]},
                             .t_begin = e->t_begin,
                             .t_end = e->t_end,
                             .t_plastic_end = e->t_plastic_end,
                             .t_elastic_end = e->t_elastic_end,
                             .contacts = e->contacts,
                             .stop = e->stop,
                             .closing = e->closing,
                             .restitution = e->restitution,
                             .mu = e->mu,
                             .friction = e->friction,
                             .impulse = e->impulse,
                             .coe = e->coe,
                             .normal = e->normal};
}

enum cr_err cr_result_measure(struct cr_result *r, const struct cr_irf_set *irf,
                              struct cr_error *err) {
    struct cr_events all;
    enum cr_err code = cr_events_find(r->solution, &r->compiled->cs, &all, err);
    if (code) {
        return code;
    }
    free(r->impact);
    r->impacts = 0;
    r->impact = calloc((size_t)(all.n > 0 ? all.n : 1), sizeof *r->impact);
    if (!r->impact) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the impacts of a result");
        goto out;
    }
    r->impacts = all.n;
    for (int i = 0; i < all.n; i++) {
        take_impact(&all.event[i], &r->impact[i]);
    }
    struct taking t = {r, &all, irf, err};
    for (int i = 0; i < r->solution->bodies && !code; i++) {
        code = measure_body(&t, i);
    }
out:
    cr_events_fini(&all);
    return code;
}
