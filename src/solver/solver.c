/* The loop over slices and pairs: the six steps of the paper. */
#include "solver/crush.h"
#include "solver/motion.h"
#include "solver/phases.h"
#include "solver/record.h"
#include "solver/setup.h"
#include "solver/tuning.h"

const char *cr_stop_word(enum cr_stop stop) {
    static const char *const words[] = {
#define X(name, word) [CR_STOP_##name] = word,
        CR_STOP_LIST(X)
#undef X
    };
    return words[stop];
}

struct cr_opts cr_opts_default(void) {
    return (struct cr_opts){.dt = 0.5e-3,
                            .friction = 0.5,
                            .road_friction = 0.8,
                            .rolling = 0.010,
                            .rolling_after = 0.010,
                            .restitution = 0.1,
                            .elastic_s = 5e-3,
                            .induced = true,
                            .end = CR_END_SEPARATION,
                            .max_time = 20,
                            .rest_time = 30};
}

const struct cr_solution *cr_solver_solution(struct cr_solver *s) {
    cr_record_outcome(s);
    return &s->out;
}

double cr_solver_time(const struct cr_solver *s) {
    return s->t;
}

bool cr_solver_touched(const struct cr_solver *s) {
    return s->touched;
}

/* the record of a contact that begins, and before the first of all that of the bodies */
static bool begin_contact(struct cr_duo *d, const struct cr_force *f) {
    struct cr_solver *s = d->s;
    if (!s->touched) {
        s->touched = true;
        s->dt_contact = s->dt;
        cr_record_before(s);
    }
    return cr_touch_begin(d, f);
}

/* Steps 1 to 3 for a pair. False when memory is out; `deformed` says whether anything was
 * crushed. */
static bool crush_pair(struct cr_duo *d, bool *deformed) {
    struct cr_force f;
    *deformed = false;
    bool met;
    if (!cr_overlap_find(d, &met)) {
        return false;
    }
    if (!met) {
        return true;
    }
    cr_yield_share(d);
    if (!cr_crush_contact(d)) {
        cr_crush_settle(d, 0);
        return false;
    }
    bool begun = d->touch->record >= 0;
    if (!(d->s->side[0].energy + d->s->side[1].energy > 0)) {
        cr_crush_settle(d, 1); /* as with a trace of energy, which may be rounding */
        return true;
    }
    if (!cr_force_find(d, &f) || (!begun && !(cr_force_approach(d, &f) > cr_begin_speed))) {
        cr_crush_settle(d, 0);
        return true;
    }
    bool ok = begun || begin_contact(d, &f);
    if (ok && d->s->cs->opts.induced) {
        ok = cr_drag_along(d);
        f.energy = d->s->side[0].energy + d->s->side[1].energy;
    }
    if (!ok) {
        cr_crush_settle(d, 0);
        return false;
    }
    *deformed = true;
    return cr_kinetics_slice(d, &f);
}

static bool work_pair(struct cr_duo *d) {
    struct cr_solver *s = d->s;
    if ((d->ma->inv_mass == 0 && d->mb->inv_mass == 0) || (d->ma->at_rest && d->mb->at_rest)) {
        return true;
    }
    if (d->touch->record >= 0 && s->contact[d->touch->record].phase != CR_PHASE_PLASTIC) {
        return cr_elastic_slice(d);
    }
    bool deformed;
    if (!crush_pair(d, &deformed)) {
        return false;
    }
    if (d->touch->record >= 0) {
        struct cr_contact *c = &s->contact[d->touch->record];
        c->stop = cr_abort_check(d, deformed);
        if (c->stop != CR_STOP_NONE) {
            cr_elastic_begin(d);
        }
    }
    return true;
}

/* Whether more than half of what stood at a place of a soft body was crushed: in a square as large
 * as a voxel about it, because a wheel that stands on a line of the grid is on both sides of it. */
static bool is_crushed(const struct cr_moving *m, struct cr_vec2 at) {
    const struct cr_grid *g = &m->body->grid;
    double x = cr_clamp((at.x - g->x0) / g->h - 0.5, -1, g->nx);
    double y = cr_clamp((at.y - g->y0) / g->h - 0.5, -1, g->ny), left = 0, fill = 0;
    for (int k = 0; k < 4; k++) {
        int ix = (int)floor(x) + k % 2, iy = (int)floor(y) + k / 2;
        if (ix >= 0 && iy >= 0 && ix < g->nx && iy < g->ny) {
            double part = (1 - fabs(x - ix)) * (1 - fabs(y - iy));
            left += part * m->surface.left[iy * g->nx + ix];
            fill += part * g->fill[iy * g->nx + ix];
        }
    }
    return left < 0.5 * fill;
}

/* a wheel whose place was crushed slides */
static void drag_wheels(struct cr_moving *m) {
    for (int i = 0; i < m->body->wheels && m->soft; i++) {
        m->drag[i] = m->drag[i] || is_crushed(m, m->body->wheel[i].at);
    }
}

static void begin_slice(struct cr_solver *s) {
    for (int i = 0; i < s->cs->n; i++) {
        struct cr_moving *m = &s->m[i];
        m->vel_begin = m->vel;
        m->yaw_begin = m->yaw_rate;
        m->slice_impulse = m->slice_coe = cr_vec2(0, 0);
        m->slice_weight = 0;
    }
}

/* velocity changes of the slice count into delta-v for the bodies that are in contact */
static void end_slice(struct cr_solver *s, const bool in_contact[]) {
    for (int i = 0; i < s->cs->n; i++) {
        struct cr_moving *m = &s->m[i];
        if (in_contact[i]) {
            m->delta_v = cr_vec2_add(m->delta_v, cr_vec2_sub(m->vel, m->vel_begin));
            m->yaw_change += m->yaw_rate - m->yaw_begin;
            m->t_last = s->t_struck = s->t;
            s->out.body[i].after = cr_solver_state(s, i);
            drag_wheels(m);
        }
    }
}

static enum cr_status failed(struct cr_error *err, enum cr_err code, const char *text) {
    cr_err_set(err, code, "%s", text);
    return CR_STATUS_FAILED;
}

static bool finite_state(const struct cr_solver *s) {
    for (int i = 0; i < s->cs->n; i++) {
        const struct cr_moving *m = &s->m[i];
        if (!isfinite(m->pos.x + m->pos.y + m->vel.x + m->vel.y + m->heading + m->yaw_rate)) {
            return false;
        }
    }
    return true;
}

/* A pair of bodies and what decides when it is worked, the most important first. */
struct turn {
    int a, b;
    double key[4];
};

static bool is_before(const struct turn *x, const struct turn *y) {
    int k = 0;
    while (k < 3 && x->key[k] == y->key[k]) {
        k++;
    }
    return x->key[k] < y->key[k];
}

/* The pairs in an order of the crash, not of the scene: who met first, then who is nearer, then who
 * stands further west and south, which says no more than that one of two equals must be first. */
static int take_turns(const struct cr_solver *s, struct turn turn[CR_PAIR_MAX]) {
    int n = 0;
    for (int a = 0; a < s->cs->n; a++) {
        for (int b = a + 1; b < s->cs->n; b++) {
            struct cr_vec2 way = cr_vec2_sub(s->m[b].pos, s->m[a].pos);
            struct cr_vec2 sum = cr_vec2_add(s->m[a].pos, s->m[b].pos);
            int met = s->met[cr_pair(s, a, b)];
            struct turn one = {
                a, b, {met > 0 ? met : (double)INFINITY, cr_vec2_len(way), sum.x, sum.y}};
            int at = n++;
            for (; at > 0 && is_before(&one, &turn[at - 1]); at--) {
                turn[at] = turn[at - 1];
            }
            turn[at] = one;
        }
    }
    return n;
}

/* Work all pairs, in their turns and backwards alternately: a body between two others feels the
 * first of its contacts before the second, and the lead changes from slice to slice. */
static bool work_pairs(struct cr_solver *s, bool in_contact[]) {
    struct turn turn[CR_PAIR_MAX];
    int pairs = take_turns(s, turn);
    s->backwards = !s->backwards;
    for (int k = 0; k < pairs; k++) {
        int at = s->backwards ? pairs - 1 - k : k, a = turn[at].a, b = turn[at].b;
        struct cr_duo d = cr_duo(s, a, b);
        bool before = d.touch->record >= 0;
        double pushed = s->m[a].slice_weight;
        if (!work_pair(&d)) {
            return false;
        }
        const struct cr_touch *t = d.touch;
        bool met = before || t->record >= 0 || s->m[a].slice_weight > pushed;
        if (met && s->met[d.pair] == 0) {
            s->met[d.pair] = 1 + s->samples;
        }
        if (met && !t->rubbing) {
            in_contact[a] = in_contact[b] = true;
        }
    }
    return true;
}

enum cr_status cr_solver_step(struct cr_solver *s, struct cr_error *err) {
    if (s->done) {
        return CR_STATUS_DONE;
    }
    bool in_contact[CR_BODY_MAX] = {false};
    s->dt = cr_kinematics_slice_length(s);
    begin_slice(s);
    cr_kinematics_move(s);
    if (!work_pairs(s, in_contact)) {
        return failed(err, CR_ERR_MEMORY, "no memory for the solve");
    }
    for (int i = 0; i < s->cs->n; i++) {
        cr_tyres_apply(s, i);
    }
    if (!finite_state(s)) {
        return failed(err, CR_ERR_SOLVER, "a velocity is no longer finite");
    }
    end_slice(s, in_contact);
    if (!s->touched) {
        if (s->t > s->cs->opts.max_time) {
            cr_err_set(err, CR_ERR_NO_CONTACT, "the participants never meet within %g s",
                       s->cs->opts.max_time);
            cr_err_hint(err, "check positions, headings, speeds and height ranges");
            return CR_STATUS_FAILED;
        }
        return CR_STATUS_RUNNING;
    }
    if (s->cs->opts.end == CR_END_REST) {
        cr_ending_rest(s, in_contact);
    }
    if (!cr_record_sample(s)) {
        return failed(err, CR_ERR_MEMORY, "no memory for the trace");
    }
    cr_ending_check(s);
    return s->done ? CR_STATUS_DONE : CR_STATUS_RUNNING;
}

/* The caller has cancelled or resumed the solve; contacts still in plastic compression have no
 * criterion of their own. */
static void mark_interrupted(struct cr_solver *s, bool interrupted) {
    s->out.interrupted = interrupted;
    for (int i = 0; i < s->contacts; i++) {
        if (s->contact[i].phase == CR_PHASE_PLASTIC) {
            s->contact[i].stop = interrupted ? CR_STOP_INTERRUPTED : CR_STOP_NONE;
        }
    }
}

enum cr_err cr_solver_run(struct cr_solver *s, int (*cancel)(void *), void *user,
                          struct cr_error *err) {
    struct cr_error unasked;
    err = err != NULL ? err : &unasked;
    enum cr_status status = CR_STATUS_RUNNING;
    mark_interrupted(s, false);
    while (status == CR_STATUS_RUNNING) {
        if (cancel != NULL && cancel(user) != 0) {
            mark_interrupted(s, true);
            return cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted at t = %.4g s", s->t);
        }
        status = cr_solver_step(s, err);
    }
    return status == CR_STATUS_DONE ? CR_ERR_OK : err->code;
}
