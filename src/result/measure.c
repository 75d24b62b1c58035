/* What is reported of a finished solution (share/doc/sources.md, "Measures"). */
#include "result/result_priv.h"

#include "result/deform.h"
#include "result/pulse.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* residual depth from which a column counts as damaged, m: what a tape measure shows */
static const double DAMAGED = 0.01;
/* Front and rear are measured along the bumper beam: recorded damage width over overall width of
 * 186 full-width wall tests [RESIDUAL-SHAPE]. */
static const double BEAM_WIDTH = 0.83;
/* B-pillar, behind the front axle as a share of the wheelbase; only for the extent zones */
static const double B_PILLAR = 0.5;
/* share of the height from which a partner reaches above the belt line */
static const double BELT = 0.75;
/* shortest pulse record, s: OLC and VPI need the time after the contact too */
static const double RECORD = 0.3;

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
    // the impulse comes from where it does not push to; right is -y
    double pdof = atan2(dv.y, -dv.x);
    if (pdof < 0) {
        pdof += 2 * CR_PI;
    }
    // straight ahead is 0, whichever side rounding falls to
    return pdof > 2 * CR_PI - 1e-12 ? 0 : pdof;
}

/* time in which the body touched anything: union of its contacts, s */
static double contact_time(const struct cr_solution *sol, int body) {
    double sum = 0, until = -INFINITY;
    // contacts are in order of their beginning
    for (int k = 0; k < sol->contacts; k++) {
        const struct cr_contact *c = &sol->contact[k];
        if (c->a != body && c->b != body) {
            continue;
        }
        double from = fmax(c->t_begin, until);
        if (c->t_end > from) {
            sum += c->t_end - from;
            until = c->t_end;
        }
    }
    const struct cr_outcome *o = &sol->body[body];
    return sum > 0 ? sum : o->t_last - o->t_first;
}

static void measure_motion(const struct cr_result *r, int i, struct cr_severity *s) {
    const struct cr_outcome *o = &r->solution->body[i];
    double mass = r->compiled.cs.body[i].mass, c = cos(o->before.heading),
           sn = sin(o->before.heading);
    s->energy = o->energy;
    s->energy_induced = o->induced;
    s->ees = mass > 0 ? sqrt(2 * o->energy / mass) : 0;
    s->delta_v_world = o->delta_v;
    s->delta_v_body = cr_vec2_unrotate(o->delta_v, c, sn);
    s->delta_v = cr_vec2_len(o->delta_v);
    s->pdof = cr_result_pdof(s->delta_v_body);
    s->pdof_clock = cr_pdof_clock(s->pdof);
    s->yaw_rate_change = o->yaw_change;
    s->speed_after = cr_vec2_len(o->after.vel);
    s->course_after = atan2(o->after.vel.y, o->after.vel.x);
    s->yaw_rate_after = o->after.yaw_rate;
    s->pulse = contact_time(r->solution, i);
    memcpy(s->model, r->compiled.model[i], sizeof s->model);
}

static enum cr_err measure_pulse(const struct cr_solution *sol, int i, struct cr_severity *s,
                                 struct cr_error *err) {
    const struct cr_outcome *o = &sol->body[i];
    struct cr_vec2 u = cr_vec2_unit(o->delta_v, cr_vec2(1, 0));
    struct cr_pulse p;
    enum cr_err rc = cr_pulse_new(sol, i, u, RECORD, &p, err);
    if (rc) {
        return rc;
    }
    int start = (int)lround((o->t_first - p.t0) / p.dt);
    s->acceleration_mean = s->pulse > 0 ? s->delta_v / s->pulse : 0;
    s->asi = cr_pulse_asi(p.ax, p.ay, p.n, p.dt);
    s->thiv = cr_pulse_thiv(&p, start, &s->phd);
    rc = cr_cfc_filter(60, p.dt, p.along, p.n, err);
    rc = rc ? rc : cr_cfc_filter(60, p.dt, p.ax, p.n, err);
    rc = rc ? rc : cr_cfc_filter(60, p.dt, p.ay, p.n, err);
    if (rc) {
        goto out;
    }
    s->olc = cr_pulse_olc(p.along + start, p.n - start, p.dt);
    s->vpi = cr_pulse_vpi(p.along + start, p.n - start, p.dt);
    for (int k = 0; k < p.n; k++) {
        double a = cr_pulse_greater(p.ax[k], p.ay[k], s->acceleration_max);
        if (a > s->acceleration_max) {
            s->acceleration_max = a;
            s->t_max = p.t0 + (k + 0.5) * p.dt - o->t_first;
        }
    }
    int main = cr_result_main_contact(sol, i);
    s->t_depth_max = main < 0 ? (double)NAN : sol->contact[main].t_elastic_end - o->t_first;
out:
    cr_pulse_fini(&p);
    return rc;
}

/* residual and dynamic depth of what the grid lost */
struct depth {
    double residual, dynamic;
};

static struct depth both(const struct cr_deform *d, enum cr_face face, double lost) {
    double back = d->grid->springback[face];
    return d->residual_curve ? (struct depth){lost, cr_deform_dynamic(lost, back)}
                             : (struct depth){cr_deform_residual(lost, back), lost};
}

struct face_damage {
    int lo, hi; /* first and last damaged column, lo > hi without damage */
    int direct_lo, direct_hi;
    double residual_sum, dynamic_sum; /* of the columns, m */
};

/* depth of the face at column position x (columns from 0.5), linear between their middles */
static struct depth depth_at(const struct cr_deform *d, enum cr_face face, double x) {
    int n = cr_face_lines(d->grid, face);
    double at = cr_clamp(x - 0.5, 0, n - 1);
    int k = (int)at < n - 1 ? (int)at : n - 2;
    double f = n > 1 ? at - k : 0;
    double a = cr_deform_column(d, face, n > 1 ? k : 0, false);
    double b = n > 1 ? cr_deform_column(d, face, k + 1, false) : a;
    return both(d, face, a + f * (b - a));
}

static struct face_damage scan_face(const struct cr_deform *d, enum cr_face face,
                                    struct cr_severity *s) {
    int n = cr_face_lines(d->grid, face);
    struct face_damage f = {.lo = n, .hi = -1, .direct_lo = n, .direct_hi = -1};
    for (int k = 0; k < n; k++) {
        struct depth all = both(d, face, cr_deform_column(d, face, k, false));
        struct depth direct = both(d, face, cr_deform_column(d, face, k, true));
        f.residual_sum += all.residual;
        f.dynamic_sum += all.dynamic;
        s->face_depth = fmax(s->face_depth, all.residual);
        s->face_depth_dynamic = fmax(s->face_depth_dynamic, all.dynamic);
        if (all.residual > DAMAGED) {
            f.lo = k < f.lo ? k : f.lo;
            f.hi = k;
        }
        if (direct.residual > DAMAGED) {
            f.direct_lo = k < f.direct_lo ? k : f.direct_lo;
            f.direct_hi = k;
        }
    }
    return f;
}

/* C1..C6 at six equal spaces over the damaged width [CRUSH-POINTS] */
static void crush_profile(const struct cr_deform *d, const struct face_damage *f,
                          struct cr_severity *s) {
    int n = cr_face_lines(d->grid, s->face);
    double lo = f->lo + 0.5, hi = f->hi + 0.5; // middles of the outermost damaged columns
    if (cr_face_is_end(s->face)) {
        lo = fmax(lo, n * (1 - BEAM_WIDTH) / 2);
        hi = fmin(hi, n * (1 + BEAM_WIDTH) / 2);
    }
    s->damage_width = f->hi < f->lo ? 0 : (f->hi + 1 - f->lo) * d->grid->h;
    s->contact_width =
        f->direct_hi < f->direct_lo ? 0 : (f->direct_hi + 1 - f->direct_lo) * d->grid->h;
    if (!(hi >= lo)) {
        return;
    }
    for (int i = 0; i < CR_PROFILE; i++) {
        struct depth c = depth_at(d, s->face, lo + (hi - lo) * i / (CR_PROFILE - 1));
        s->profile[i] = c.residual;
        s->profile_dynamic[i] = c.dynamic;
    }
}

static double or_else(double x, double fallback) {
    return isfinite(x) && x > 0 ? x : fallback;
}

/* slid along its partner: little of the closing speed was lost, most of it is left */
static bool is_sideswipe(const struct cr_result *r, int i, int other) {
    const struct cr_outcome *a = &r->solution->body[i], *b = &r->solution->body[other];
    double before = cr_vec2_len(cr_vec2_sub(a->before.vel, b->before.vel));
    double after = cr_vec2_len(cr_vec2_sub(a->after.vel, b->after.vel));
    return after > before / 2 && cr_vec2_len(a->delta_v) < before / 4;
}

static void classify(const struct cr_result *r, int i, const struct face_damage *f,
                     struct cr_severity *s) {
    const struct cr_grid *g = &r->compiled.cs.body[i].grid;
    const struct cr_participant *p = &r->resolved.part[i];
    int n = cr_face_lines(g, s->face), main = cr_result_main_contact(r->solution, i);
    double length = or_else(p->length, g->nx * g->h), width = or_else(p->width, g->ny * g->h);
    double pillar = or_else(p->front_overhang + B_PILLAR * p->wheelbase, length / 2);
    struct cr_cdc_case what = {
        .pdof = s->pdof,
        .face = s->face,
        .lo = (double)f->direct_lo / n,
        .hi = (double)(f->direct_hi + 1) / n,
        .width = s->contact_width,
        .depth = s->face_depth,
        .zone = s->face == CR_FACE_FRONT  ? pillar
                : s->face == CR_FACE_REAR ? length - pillar
                                          : width,
    };
    if (main >= 0) {
        const struct cr_contact *c = &r->solution->contact[main];
        int other = c->a == i ? c->b : c->a;
        const struct cr_participant *q = &r->resolved.part[other];
        what.above_belt = q->kind == CR_KIND_OBJECT && q->z_hi > BELT * p->height;
        what.sideswipe = is_sideswipe(r, i, other);
    }
    cr_cdc_write(&what, s->cdc);
}

/* outline of what is left on the car, after springback */
static enum cr_err measure_outline(const struct cr_deform *d, struct cr_severity *s,
                                   struct cr_error *err) {
    const struct cr_grid *g = d->grid;
    double *left = malloc((size_t)g->nx * (size_t)g->ny * sizeof *left);
    if (!left) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for an outline");
    }
    cr_deform_relax(d, s->face, left);
    enum cr_err rc = cr_deform_outline(g, left, g->h / 4, &s->outline, &s->outline_n, err);
    free(left);
    return rc;
}

static enum cr_err measure_deformation(struct cr_result *r, int i, struct cr_severity *s,
                                       struct cr_error *err) {
    const struct cr_outcome *o = &r->solution->body[i];
    const struct cr_grid *g = &r->compiled.cs.body[i].grid;
    int residual = r->resolved.set.residual_curve;
    struct cr_deform d = {.grid = g,
                          .left = o->left,
                          .how = o->how,
                          .residual_curve = residual < 0 ? r->resolved.set.method == CR_METHOD_PAPER
                                                         : residual > 0};
    struct cr_vec2 inward = cr_vec2_unit(s->delta_v_body, cr_vec2(-1, 0));
    s->face = cr_deform_face(&d, inward);
    struct depth most = both(&d, s->face, cr_deform_max(&d, inward));
    s->deformation_max = most.residual;
    s->deformation_dynamic_max = most.dynamic;
    double area = cr_deform_area(&d, &s->area_induced);
    s->area_contact = area - s->area_induced;
    struct face_damage f = scan_face(&d, s->face, s);
    // the residual share of the area is that of the struck face's columns
    double lost = d.residual_curve ? f.residual_sum : f.dynamic_sum;
    s->deformation_area = lost > 0 ? area * f.residual_sum / lost : 0;
    crush_profile(&d, &f, s);
    classify(r, i, &f, s);
    return measure_outline(&d, s, err);
}

static void measure_injury(const struct cr_result *r, int i, const struct cr_irf_set *irf,
                           struct cr_severity *s) {
    struct cr_irf_case what = {
        .delta_v = s->delta_v, .closing = NAN, .ees = s->ees, .pdof = s->pdof};
    int main = cr_result_main_contact(r->solution, i);
    if (main >= 0) {
        const struct cr_contact *c = &r->solution->contact[main];
        int other = c->a == i ? c->b : c->a;
        const struct cr_outcome *o = r->solution->body;
        what.closing = cr_vec2_len(cr_vec2_sub(o[i].before.vel, o[other].before.vel));
        what.vehicle_partner = r->resolved.part[other].kind == CR_KIND_VEHICLE;
    }
    cr_irf_apply(irf, &what, s);
}

enum cr_err cr_result_measure(struct cr_result *r, const struct cr_irf_set *irf,
                              struct cr_error *err) {
    enum cr_err rc = CR_ERR_OK;
    for (int i = 0; i < r->solution->bodies && !rc; i++) {
        const struct cr_outcome *o = &r->solution->body[i];
        struct cr_severity *s = &r->of[i];
        free(s->outline);
        memset(s, 0, sizeof *s);
        bool touched = isfinite(o->t_first) && isfinite(o->t_last) && o->t_last > o->t_first;
        measure_motion(r, i, s);
        if (touched && r->compiled.cs.body[i].mass > 0) {
            rc = measure_pulse(r->solution, i, s, err);
        }
        if (!rc && touched && o->left) {
            rc = measure_deformation(r, i, s, err);
        }
        if (!rc && touched && r->resolved.part[i].kind == CR_KIND_VEHICLE) {
            measure_injury(r, i, irf, s);
        }
    }
    return rc;
}
