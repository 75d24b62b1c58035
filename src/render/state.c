/* Finds where the bodies are at a time, from the case and the trace of a solution. */
#include "render/picture.h"

#include "base/vec.h"
#include "scene/compiled.h"

#include <math.h>
#include <stdlib.h>

double cr_render_t_contact(const struct cr_solution *sol) {
    return isfinite(sol->t_contact) ? sol->t_contact : 0;
}

double cr_render_t_after(const struct cr_solution *sol) {
    double t = cr_render_t_contact(sol);
    for (int i = 0; i < sol->contacts; i++) {
        if (sol->contact[i].phase != CR_PHASE_APART && sol->samples > 0) {
            return sol->t[sol->samples - 1]; /* still solving, or cut by its time limit */
        }
    }
    for (int i = 0; i < sol->bodies; i++) {
        if (isfinite(sol->body[i].t_last)) {
            t = fmax(t, sol->body[i].t_last);
        }
    }
    return t;
}

double cr_render_t_main(const struct cr_solution *sol) {
    double most = 0, t = cr_render_t_contact(sol);
    for (int i = 0; i < sol->contacts; i++) {
        most = fmax(most, cr_vec2_len(sol->contact[i].impulse));
    }
    for (int i = 0; i < sol->contacts; i++) {
        const struct cr_contact *k = &sol->contact[i];
        if (k->phase != CR_PHASE_APART || !isfinite(k->t_end)) {
            return cr_render_t_after(sol);
        }
        if (cr_vec2_len(k->impulse) >= 0.05 * most) {
            t = fmax(t, k->t_end);
        }
    }
    return sol->contacts > 0 ? t : cr_render_t_after(sol);
}

bool cr_render_final(const struct cr_solution *sol) {
    for (int i = 0; i < sol->contacts; i++) {
        if (sol->contact[i].phase != CR_PHASE_APART || !isfinite(sol->contact[i].t_end)) {
            return false;
        }
    }
    return sol->contacts > 0 && !sol->interrupted;
}

struct cr_result *cr_render_live(const struct cr_scene *scene, const struct cr_case *cs,
                                 const struct cr_solution *live) {
    struct cr_result *r = cr_result_new();
    if (r != NULL) {
        r->resolved = *scene;
        r->compiled->cs = *cs;
        r->solution = live;
    }
    return r;
}

static struct cr_sample start_of(const struct cr_body *body) {
    return (struct cr_sample){
        .pos = body->pos, .vel = body->vel, .heading = body->heading, .yaw_rate = body->yaw_rate};
}

static struct cr_sample mix(const struct cr_sample *a, const struct cr_sample *b, double u) {
    struct cr_sample s = *b; /* forces are those of the slice, which the trace has at its end */
    s.pos = cr_vec2_axpy(a->pos, u, cr_vec2_sub(b->pos, a->pos));
    s.vel = cr_vec2_axpy(a->vel, u, cr_vec2_sub(b->vel, a->vel));
    s.heading = a->heading + u * (b->heading - a->heading);
    s.yaw_rate = a->yaw_rate + u * (b->yaw_rate - a->yaw_rate);
    return s;
}

static struct cr_sample on_path(const struct cr_body *body, double time) {
    const struct cr_waypoint *w = body->waypoint;
    int i = 1;
    while (i < body->waypoints - 1 && w[i].t < time) {
        i++;
    }
    struct cr_sample s = start_of(body);
    if (body->waypoints < 2) {
        return s;
    }
    double span = w[i].t - w[i - 1].t;
    double u = span > 0 ? cr_clamp((time - w[i - 1].t) / span, 0, 1) : 1;
    struct cr_vec2 step = cr_vec2_sub(w[i].pos, w[i - 1].pos);
    double speed = w[i - 1].speed + u * (w[i].speed - w[i - 1].speed);
    s.pos = cr_vec2_axpy(w[i - 1].pos, u, step);
    s.heading = w[i - 1].heading + u * (w[i].heading - w[i - 1].heading);
    s.vel = cr_vec2_scale(cr_vec2_unit(step, cr_vec2(cos(s.heading), sin(s.heading))), speed);
    return s;
}

/* The state at the first contact of all, which is one slice before the first sample. */
static struct cr_sample at_contact(const struct cr_solution *sol, int body) {
    const struct cr_sample *first = &sol->trace[body];
    struct cr_sample s = sol->body[body].before;
    if (sol->body[body].t_first != sol->t_contact) {
        s = *first;
        s.pos = cr_vec2_axpy(first->pos, -(sol->t[0] - sol->t_contact), first->vel);
    }
    s.force = s.acc = cr_vec2(0, 0);
    s.energy = s.crushed = s.yaw_acc = 0;
    return s;
}

static struct cr_sample in_trace(const struct cr_solution *sol, int body, double time) {
    int lo = 0, hi = sol->samples - 1;
    if (time >= sol->t[hi]) {
        return sol->trace[hi * sol->bodies + body];
    }
    while (lo < hi) {
        int mid = (lo + hi) / 2;
        if (sol->t[mid] < time) {
            lo = mid + 1;
        } else {
            hi = mid;
        }
    }
    struct cr_sample from =
        lo > 0 ? sol->trace[(lo - 1) * sol->bodies + body] : at_contact(sol, body);
    double t0 = lo > 0 ? sol->t[lo - 1] : sol->t_contact;
    double span = sol->t[lo] - t0;
    return mix(&from, &sol->trace[lo * sol->bodies + body], span > 0 ? (time - t0) / span : 1);
}

struct cr_sample cr_render_state(const struct cr_compiled *compiled, const struct cr_result *result,
                                 int body, double time) {
    const struct cr_body *b = &compiled->cs.body[body];
    const struct cr_solution *sol = result != NULL ? result->solution : NULL;
    if (sol == NULL || sol->samples == 0) {
        return b->waypoints > 0 && isfinite(time) ? on_path(b, time) : start_of(b);
    }
    if (isnan(time)) {
        time = cr_render_t_after(sol);
    }
    if (time > sol->t_contact) {
        return in_trace(sol, body, time);
    }
    struct cr_sample contact = at_contact(sol, body);
    if (time == sol->t_contact) {
        return contact;
    }
    if (b->waypoints > 0) {
        return on_path(b, time);
    }
    struct cr_sample start = start_of(b);
    double u = sol->t_contact > 0 ? cr_clamp(time / sol->t_contact, 0, 1) : 1;
    return mix(&start, &contact, u);
}
