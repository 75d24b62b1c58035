/* Moves the entities of OpenSCENARIO: straight on, with changes of speed, along trajectories. */
#include "import/xosc_priv.h"

#include <math.h>
#include <stdlib.h>

static const double step = 0.05;    /* s between rows */
static const double goes_on = 10;   /* s that the motion lasts after the last action */
static const double longest = 3600; /* s that a motion may last */
static const double never = INFINITY;

/* An entity at a time, and what it is doing then. */
struct runner {
    const struct cr_xosc_entity *e;
    int next; /* index of the action that begins next */
    struct cr_vec2 pos;
    double heading, v;
    const struct cr_xosc_action *change; /* of speed; NULL: none is under way */
    double v0, t_change, duration;
    const struct cr_xosc_action *path; /* NULL: straight on */
    int seg;                           /* of the path */
    double s;                          /* m along it */
};

/* ---- speed ---- */

static double speed_at(const struct runner *r, double t) {
    if (r->change == NULL) {
        return r->v;
    }
    double u = r->duration > 0 ? cr_clamp((t - r->t_change) / r->duration, 0, 1) : 1;
    double dv = r->change->speed - r->v0;
    switch (r->change->shape) {
    case CR_XOSC_CUBIC:
        return r->v0 + dv * u * u * (3 - 2 * u);
    case CR_XOSC_SINUSOIDAL:
        return r->v0 + dv * (1 - cos(CR_PI * u)) / 2;
    default:
        return r->v0 + dv * u;
    }
}

static void begin_change(struct runner *r, const struct cr_xosc_action *a, double t) {
    r->v0 = r->v;
    r->t_change = t;
    r->duration = a->shape == CR_XOSC_STEP ? 0
                  : a->rate                ? fabs(a->speed - r->v) / a->value
                                           : a->value;
    r->change = a;
}

/* ---- path ---- */

static void on_segment(struct runner *r, double u) {
    const struct cr_xosc_point *p = &r->path->point[r->seg], *q = p + 1;
    r->pos = cr_vec2_axpy(p->pos, u, cr_vec2_sub(q->pos, p->pos));
    r->heading = p->heading + u * cr_angle_wrap(q->heading - p->heading);
}

/* The speed on the way to the next point, negative if it lies behind the heading. */
static double signed_speed(const struct cr_xosc_point *p, double over) {
    struct cr_vec2 d = cr_vec2_sub(p[1].pos, p[0].pos);
    double v = (p[1].s - p[0].s) / over;
    return cr_vec2_dot(d, cr_vec2(cos(p->heading), sin(p->heading))) < 0 ? -v : v;
}

/* Ends a path: the entity goes straight on. */
static void leave_path(struct runner *r) {
    const struct cr_xosc_point *end = &r->path->point[r->path->n - 1];
    r->pos = end->pos;
    r->heading = end->heading;
    r->path = NULL;
}

static void follow_times(struct runner *r, double t) {
    const struct cr_xosc_point *p = r->path->point;
    while (r->seg + 2 < r->path->n && p[r->seg + 1].t <= t) {
        r->seg++;
    }
    p += r->seg;
    r->v = signed_speed(p, p[1].t - p[0].t);
    on_segment(r, cr_clamp((t - p[0].t) / (p[1].t - p[0].t), 0, 1));
    if (t >= r->path->point[r->path->n - 1].t) {
        double late = t - r->path->point[r->path->n - 1].t;
        leave_path(r);
        r->pos = cr_vec2_axpy(r->pos, r->v * late, cr_vec2(cos(r->heading), sin(r->heading)));
    }
}

static void follow_length(struct runner *r, double ds) {
    const struct cr_xosc_point *p = r->path->point;
    double end = p[r->path->n - 1].s;
    r->s += ds;
    if (r->s >= end) {
        leave_path(r);
        r->pos = cr_vec2_axpy(r->pos, r->s - end, cr_vec2(cos(r->heading), sin(r->heading)));
        return;
    }
    while (r->seg + 2 < r->path->n && p[r->seg + 1].s <= r->s) {
        r->seg++;
    }
    double span = p[r->seg + 1].s - p[r->seg].s;
    on_segment(r, span > 0 ? cr_clamp((r->s - p[r->seg].s) / span, 0, 1) : 0);
}

/* ---- time ---- */

/* When the next action takes hold, s; a path with times begins at the time of its first point. */
static double next_start(const struct runner *r) {
    if (r->next == r->e->actions) {
        return never;
    }
    const struct cr_xosc_action *a = &r->e->action[r->next];
    return a->path && a->timed ? fmax(a->t, a->point[0].t) : a->t;
}

static void start(struct runner *r, double t) {
    const struct cr_xosc_action *a = &r->e->action[r->next++];
    if (!a->path) {
        begin_change(r, a, t);
        return;
    }
    r->path = a;
    r->seg = 0;
    r->s = 0;
    on_segment(r, 0);
    if (a->timed) {
        r->change = NULL;
        follow_times(r, t);
    }
}

/* Moves an entity from time t to `to`, s, between which no action begins. */
static void go(struct runner *r, double t, double to) {
    /* Simpson's rule is exact for steps, ramps and the cubic. */
    double ds = (to - t) / 6 * (speed_at(r, t) + 4 * speed_at(r, (t + to) / 2) + speed_at(r, to));
    r->v = speed_at(r, to);
    if (r->change != NULL && to >= r->t_change + r->duration) {
        r->v = r->change->speed;
        r->change = NULL;
    }
    if (r->path == NULL) {
        r->pos = cr_vec2_axpy(r->pos, ds, cr_vec2(cos(r->heading), sin(r->heading)));
    } else if (r->path->timed) {
        follow_times(r, to);
    } else {
        follow_length(r, fabs(ds));
    }
}

static void advance(struct runner *r, double t, double to) {
    while (t < to) {
        double due = next_start(r), kink = r->change != NULL ? r->t_change + r->duration : never;
        if (due <= t) {
            start(r, t);
            continue;
        }
        double until = fmin(to, due);
        until = kink > t ? fmin(until, kink) : until;
        go(r, t, until);
        t = until;
    }
    while (next_start(r) <= to) {
        start(r, to);
    }
    if (r->change != NULL && r->duration <= 0) {
        r->v = r->change->speed;
        r->change = NULL;
    }
}

static double end_of(const struct cr_xosc_entity *e) {
    double end = 0;
    for (int i = 0; i < e->actions; i++) {
        const struct cr_xosc_action *a = &e->action[i];
        end = fmax(end, a->t);
        if (a->path && a->timed) {
            end = fmax(end, a->point[a->n - 1].t);
        } else if (!a->path && a->shape != CR_XOSC_STEP && !a->rate) {
            end = fmax(end, a->t + a->value);
        } else if (a->path) {
            end += a->point[a->n - 1].s / fmax(fabs(e->speed), 1);
        }
    }
    return end;
}

/* ---- rows ---- */

static enum cr_err give_row(struct cr_xosc *x, const struct runner *r, double t,
                            struct cr_error *err) {
    const struct cr_waypoint row = {
        .t = t,
        .pos = cr_vec2_axpy(r->pos, r->e->rear_x, cr_vec2(cos(r->heading), sin(r->heading))),
        .heading = r->heading,
        .speed = r->v};
    enum cr_err code = cr_import_row(x->im, r->e->p, &row, err);
    if (code != CR_ERR_OK) {
        cr_err_place(err, x->shown, 0, 0);
    }
    return code;
}

static enum cr_err run(struct cr_xosc *x, struct runner *r, int n, double end,
                       struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    long steps = (long)(fmin(end, longest) / step);
    for (long k = 0; k <= steps && !cr_import_met(x->im) && code == CR_ERR_OK; k++) {
        for (int i = 0; i < n && code == CR_ERR_OK; i++) {
            advance(&r[i], k > 0 ? (double)(k - 1) * step : 0, (double)k * step);
            code = give_row(x, &r[i], (double)k * step, err);
        }
    }
    return code;
}

/* Gives an entity its place and speed alone. It needs no rows if all stand or go straight on. */
static void give_place(const struct cr_xosc_entity *e) {
    struct cr_participant *p = e->p;
    double c = cos(e->heading), s = sin(e->heading);
    p->heading = e->heading;
    if (p->kind == CR_KIND_OBJECT) {
        p->pos = cr_vec2_add(e->pos, cr_vec2_rotate(e->centre, c, s));
        return;
    }
    p->pos = cr_vec2_axpy(e->pos, e->rear_x, cr_vec2(c, s));
    p->speed = e->speed;
}

static bool moves_otherwise(const struct cr_xosc *x) {
    for (int i = 0; i < x->n; i++) {
        if (x->entity[i].p != NULL && x->entity[i].actions > 0) {
            return true;
        }
    }
    return false;
}

enum cr_err cr_xosc_move(struct cr_xosc *x, struct cr_error *err) {
    bool rows = moves_otherwise(x);
    double end = 0;
    int n = 0;
    struct runner *r = calloc((size_t)x->n + 1, sizeof *r);
    if (r == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the motion");
    }
    for (int i = 0; i < x->n; i++) {
        const struct cr_xosc_entity *e = &x->entity[i];
        if (e->p != NULL && (e->p->kind == CR_KIND_OBJECT || !rows)) {
            give_place(e);
        } else if (e->p != NULL) {
            r[n++] = (struct runner){.e = e, .pos = e->pos, .heading = e->heading, .v = e->speed};
            end = fmax(end, end_of(e) + goes_on);
        }
    }
    enum cr_err code = rows ? run(x, r, n, end, err) : CR_ERR_OK;
    free(r);
    return code;
}
