/* Groups the contacts of a solve into impacts and adds up what each did to its two bodies. */
#include "result/event.h"

#include "base/elementary.h"
#include "scene/compiled.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* 49 CFR 563.5: an event is over when the velocity changes by no more than this, m/s, within 20
 * ms. */
static const double quiet_speed = 0.8 / 3.6, quiet_window = 0.020;
/* For pairs that hardly reach that change the limit is this share of their greatest change. */
static const double faint_share = 0.05;
/* So long after a blow another within the same touch belongs to the same crash, s (as in
 * solver/tuning.h). */
static const double same_crash = 0.3;
/* Touches that follow each other sooner are one impact, s: a crash pulse is about as long. */
static const double gap_between = 0.1;
/* A contact is reported whole unless it rubs for longer than this before or after, s. */
static const double rub_most = 0.1;
/* Below this share of the first relative speed the direction of the motion is chance. */
static const double slow_share = 0.2;

/* The part of a contact in which it is more than rubbing. */
struct span {
    int first, last;   /* its slices; last < first without any */
    double begin, end; /* s; NaN where it only rubs */
    double peak;       /* greatest velocity change within the window, m/s */
    int event;         /* the impact it belongs to */
};

/* What the passes over the slices share. */
struct work {
    const struct cr_solution *sol;
    const struct cr_case *cs;
    struct span *span; /* [contacts] */
    double *turned;    /* [bodies * samples] change of yaw rate by contacts, rad/s */
    unsigned char *at; /* [bodies * samples] how many impacts of the body last there */
};

static double inverse(double x) {
    return x > 0 ? 1 / x : 0;
}

static double slice_end(const struct cr_solution *sol, int i) {
    return sol->t[sol->slice[i].sample];
}

static double sample_begin(const struct cr_solution *sol, int k) {
    return k > 0 ? sol->t[k - 1] : sol->t_contact;
}

/* The impulse that a slice gives to the second body, N s. */
static struct cr_vec2 push(const struct cr_slice *s) {
    return cr_vec2_scale(s->direction, s->impulse);
}

/* The inverse mass of the lighter of the two, whose velocity an impulse changes most, 1/kg. */
static double lightness(const struct work *w, int contact) {
    const struct cr_contact *c = &w->sol->contact[contact];
    return fmax(inverse(w->cs->body[c->a].mass), inverse(w->cs->body[c->b].mass));
}

static double contact_end(const struct cr_solution *sol, const struct cr_contact *c) {
    double last = sol->samples > 0 ? sol->t[sol->samples - 1] : c->t_begin;
    return isfinite(c->t_end) ? c->t_end : last;
}

/* A stretch of a contact in which it does more than rub. */
struct stretch {
    double begin, end, top; /* s, s, m/s within the window */
};

/* Slides the window over a contact and returns its greatest velocity change within, m/s; the span
 * gets from where to where the change is at least `least`, m/s: of stretches with rubbing between
 * them the strongest, because a jolt when the two have rolled on for seconds is not the crash. */
static double sweep(const struct work *w, int contact, double least) {
    const struct cr_solution *sol = w->sol;
    struct span *of = &w->span[contact];
    struct cr_vec2 sum = {0, 0};
    double light = lightness(w, contact), top = 0;
    struct stretch now = {NAN, NAN, 0}, best = now;
    for (int i = of->first, tail = of->first; i <= of->last; i++) {
        if (sol->slice[i].contact != contact) {
            continue;
        }
        sum = cr_vec2_add(sum, push(&sol->slice[i]));
        while (tail < i && (sol->slice[tail].contact != contact ||
                            slice_end(sol, i) - sample_begin(sol, sol->slice[tail].sample) >
                                quiet_window + 1e-9)) {
            bool own = sol->slice[tail].contact == contact;
            sum = own ? cr_vec2_sub(sum, push(&sol->slice[tail])) : sum;
            tail++;
        }
        double change = light * cr_vec2_len(sum);
        top = fmax(top, change);
        if (change >= least) {
            double from = sample_begin(sol, sol->slice[tail].sample);
            now = from - now.end <= same_crash ? now : (struct stretch){.begin = from};
            now.end = slice_end(sol, i);
            now.top = fmax(now.top, change);
            best = now.top >= best.top ? now : best;
        }
    }
    of->begin = best.begin;
    of->end = best.end;
    return top;
}

/* The velocity change within the window below which the two bodies of a contact only rub, m/s. */
static double quiet_of(const struct work *w, int contact) {
    const struct cr_contact *c = &w->sol->contact[contact];
    double top = 0;
    for (int k = 0; k < w->sol->contacts; k++) {
        const struct cr_contact *other = &w->sol->contact[k];
        if (other->a == c->a && other->b == c->b) {
            top = fmax(top, w->span[k].peak);
        }
    }
    return fmin(quiet_speed, faint_share * top);
}

static void find_spans(struct work *w) {
    const struct cr_solution *sol = w->sol;
    for (int k = 0; k < sol->contacts; k++) {
        w->span[k] = (struct span){.first = sol->slices, .last = -1, .event = -1};
    }
    for (int i = 0; i < sol->slices; i++) {
        struct span *of = &w->span[sol->slice[i].contact];
        of->first = i < of->first ? i : of->first;
        of->last = i;
    }
    for (int k = 0; k < sol->contacts; k++) {
        struct span *of = &w->span[k];
        of->peak = of->last < of->first ? lightness(w, k) * cr_vec2_len(sol->contact[k].impulse)
                                        : sweep(w, k, INFINITY);
    }
    for (int k = 0; k < sol->contacts; k++) {
        const struct cr_contact *c = &sol->contact[k];
        struct span *of = &w->span[k];
        double end = contact_end(sol, c);
        sweep(w, k, quiet_of(w, k));
        of->begin = !(of->begin - c->t_begin > rub_most) ? c->t_begin : of->begin;
        of->end = !(end - of->end > rub_most) ? end : of->end;
    }
}

/* The latest impact of the two bodies so far; -1 without one. */
static int latest(const struct cr_events *all, const struct cr_contact *c) {
    for (int i = all->n - 1; i >= 0; i--) {
        if (all->event[i].body[0] == c->a && all->event[i].body[1] == c->b) {
            return i;
        }
    }
    return -1;
}

static void group(struct work *w, struct cr_events *out) {
    const struct cr_solution *sol = w->sol;
    for (int k = 0; k < sol->contacts; k++) {
        const struct cr_contact *c = &sol->contact[k];
        struct span *of = &w->span[k];
        int at = latest(out, c);
        bool faint = of->peak < quiet_of(w, k);
        if (at < 0 || (!faint && of->begin - out->event[at].t_end > gap_between)) {
            at = out->n++;
            out->event[at] = (struct cr_event){.body = {c->a, c->b},
                                               .t_begin = of->begin,
                                               .t_end = of->end,
                                               .main = k,
                                               .closing = c->closing};
        } else if (!faint && w->span[out->event[at].main].peak < quiet_of(w, k)) {
            out->event[at].t_begin = of->begin; /* until here the pair had only rubbed */
            out->event[at].t_end = of->end;
            out->event[at].main = k;
            out->event[at].closing = c->closing;
        } else if (!faint) {
            out->event[at].t_end = fmax(out->event[at].t_end, of->end);
        }
        of->event = at;
    }
}

/* Adds up impulse, energy and places of the contacts of each impact. */
static void add_contacts(const struct work *w, struct cr_events *all) {
    const struct cr_solution *sol = w->sol;
    for (int k = 0; k < sol->contacts; k++) {
        const struct cr_contact *c = &sol->contact[k];
        struct cr_event *e = &all->event[w->span[k].event];
        double size = cr_vec2_len(c->impulse);
        e->contacts++;
        e->main = size > cr_vec2_len(sol->contact[e->main].impulse) ? k : e->main;
        e->friction += c->friction;
        e->impulse = cr_vec2_add(e->impulse, c->impulse);
        e->coe = cr_vec2_axpy(e->coe, size, c->coe);
        e->normal = cr_vec2_axpy(e->normal, size, c->normal);
        for (int i = 0; i < 2; i++) {
            e->of[i].energy += c->energy[i];
            e->of[i].induced += c->induced[i];
        }
    }
    for (int i = 0; i < all->n; i++) {
        struct cr_event *e = &all->event[i];
        const struct cr_contact *c = &sol->contact[e->main];
        double size = 0;
        for (int k = 0; k < sol->contacts; k++) {
            size += w->span[k].event == i ? cr_vec2_len(sol->contact[k].impulse) : 0;
        }
        e->coe = size > 0 ? cr_vec2_scale(e->coe, 1 / size) : c->coe;
        e->normal = cr_vec2_unit(e->normal, c->normal);
        /* Bodies that still touch when all has come to rest count as parted. */
        bool open = c->stop == CR_STOP_NONE && !sol->interrupted;
        e->stop = open ? CR_STOP_SEPARATION : c->stop;
        e->t_plastic_end = isfinite(c->t_plastic_end) ? c->t_plastic_end : e->t_end;
        e->t_elastic_end = isfinite(c->t_elastic_end) ? c->t_elastic_end : e->t_end;
        e->restitution = c->restitution;
        e->mu = c->mu;
    }
}

/* Finds the time slices that lie in each impact and makes room for vel and way; false without
 * memory. */
static bool take_samples(struct work *w, struct cr_events *all) {
    const struct cr_solution *sol = w->sol;
    size_t sum = 0;
    for (int i = 0; i < all->n; i++) {
        struct cr_event *e = &all->event[i];
        int k = 0;
        while (k < sol->samples && sol->t[k] <= e->t_begin + 1e-9) {
            k++;
        }
        e->first = k;
        while (k < sol->samples && sol->t[k] <= e->t_end + 1e-9) {
            k++;
        }
        e->samples = k - e->first;
        sum += 4 * (size_t)e->samples;
    }
    struct cr_vec2 *m = calloc(sum > 0 ? sum : 1, sizeof *m);
    all->memory = m;
    for (int i = 0; i < all->n && m != NULL; i++) {
        struct cr_event *e = &all->event[i];
        for (int b = 0; b < 2; b++) {
            e->of[b].vel = m;
            e->of[b].way = m + e->samples;
            m += 2 * (size_t)e->samples;
            for (int k = e->first; k < e->first + e->samples; k++) {
                w->at[(size_t)e->body[b] * (size_t)sol->samples + (size_t)k]++;
            }
        }
    }
    return all->memory != NULL;
}

static const struct cr_sample *end_of(const struct cr_solution *sol, int k, int body) {
    return k < 0 ? &sol->body[body].before
                 : &sol->trace[(size_t)k * (size_t)sol->bodies + (size_t)body];
}

/* The velocity of the point `at` (world) of a body at the beginning of time slice k. */
static struct cr_vec2 point_velocity(const struct cr_solution *sol, int k, int body,
                                     struct cr_vec2 at) {
    const struct cr_sample *was = end_of(sol, k - 1, body), *is = end_of(sol, k, body);
    return cr_vec2_axpy(was->vel, was->yaw_rate, cr_vec2_perp(cr_vec2_sub(at, is->pos)));
}

static void add_slice_to(const struct work *w, struct cr_event *e, int side,
                         const struct cr_slice *s, struct cr_vec2 rel) {
    const struct cr_solution *sol = w->sol;
    struct cr_event_body *of = &e->of[side];
    int body = e->body[side], k = s->sample - e->first;
    const struct cr_sample *is = end_of(sol, s->sample, body);
    double c, sn;
    cr_sincos(is->heading, &sn, &c);
    struct cr_vec2 at = cr_vec2_unrotate(cr_vec2_sub(s->coe, is->pos), c, sn);
    struct cr_vec2 gain = cr_vec2_scale(push(s), side == 0 ? -1 : 1);
    of->vel[k] = cr_vec2_axpy(of->vel[k], inverse(w->cs->body[body].mass), gain);
    of->coe = cr_vec2_axpy(of->coe, fabs(s->impulse), at);
    of->pushed += fabs(s->impulse);
    of->touch = isnan(of->touch.x) ? at : of->touch;
    /* rel is the motion of the second body against the first; way is the partner's over this
     * one. */
    struct cr_vec2 way = cr_vec2_unrotate(side == 0 ? rel : cr_vec2_scale(rel, -1), c, sn);
    of->way[k] = cr_vec2_unit(way, of->way[k]);
}

static void add_slices(struct work *w, struct cr_events *all) {
    const struct cr_solution *sol = w->sol;
    for (int i = 0; i < all->n; i++) {
        all->event[i].of[0].touch = all->event[i].of[1].touch = cr_vec2(NAN, NAN);
    }
    for (int i = 0; i < sol->slices; i++) {
        const struct cr_slice *s = &sol->slice[i];
        const struct cr_contact *c = &sol->contact[s->contact];
        struct cr_event *e = &all->event[w->span[s->contact].event];
        bool in = s->sample >= e->first && s->sample < e->first + e->samples;
        struct cr_vec2 rel = cr_vec2_sub(point_velocity(sol, s->sample, c->b, s->coe),
                                         point_velocity(sol, s->sample, c->a, s->coe));
        rel = cr_vec2_len(rel) > slow_share * e->closing ? rel : cr_vec2(0, 0);
        for (int side = 0; side < 2; side++) {
            int body = side == 0 ? c->a : c->b;
            struct cr_vec2 arm = cr_vec2_sub(s->coe, end_of(sol, s->sample, body)->pos);
            double turn = (side == 0 ? -1 : 1) * cr_vec2_cross(arm, push(s)) *
                          inverse(w->cs->body[body].inertia);
            w->turned[(size_t)body * (size_t)sol->samples + (size_t)s->sample] += turn;
            if (in) {
                e->of[side].yaw_change += turn;
                add_slice_to(w, e, side, s, rel);
            }
        }
    }
}

/* Sums the velocity change of an impact slice by slice. What no contact did, above all what tyres
 * did, is shared by the impacts that last in that slice. */
static void add_rest(const struct work *w, struct cr_event *e, int side) {
    const struct cr_solution *sol = w->sol;
    struct cr_event_body *of = &e->of[side];
    int body = e->body[side];
    double light = inverse(w->cs->body[body].mass);
    for (int i = 0; i < e->samples; i++) {
        int k = e->first + i;
        size_t row = (size_t)body * (size_t)sol->samples + (size_t)k;
        const struct cr_sample *s = end_of(sol, k, body);
        double dt = sol->t[k] - sample_begin(sol, k), share = dt / w->at[row];
        of->vel[i] = cr_vec2_axpy(of->vel[i], share, cr_vec2_axpy(s->acc, -light, s->force));
        of->yaw_change += share * s->yaw_acc - w->turned[row] / w->at[row];
        of->vel[i] = i > 0 ? cr_vec2_add(of->vel[i], of->vel[i - 1]) : of->vel[i];
        bool known = cr_vec2_len(of->way[i]) > 0;
        of->way[i] = known || i == 0 ? of->way[i] : of->way[i - 1];
    }
    of->delta_v = e->samples > 0 ? of->vel[e->samples - 1] : cr_vec2(0, 0);
    of->coe = cr_vec2_scale(of->coe, inverse(of->pushed));
}

enum cr_err cr_events_find(const struct cr_solution *sol, const struct cr_case *cs,
                           struct cr_events *out, struct cr_error *err) {
    size_t rows = (size_t)sol->bodies * (size_t)(sol->samples > 0 ? sol->samples : 1);
    size_t contacts = (size_t)(sol->contacts > 0 ? sol->contacts : 1);
    struct work w = {.sol = sol,
                     .cs = cs,
                     .span = calloc(contacts, sizeof *w.span),
                     .turned = calloc(rows, sizeof *w.turned),
                     .at = calloc(rows, sizeof *w.at)};
    enum cr_err code = CR_ERR_MEMORY;
    *out = (struct cr_events){.event = calloc(contacts, sizeof *out->event)};
    if (w.span == NULL || w.turned == NULL || w.at == NULL || out->event == NULL) {
        goto out;
    }
    find_spans(&w);
    group(&w, out);
    add_contacts(&w, out);
    if (!take_samples(&w, out)) {
        goto out;
    }
    add_slices(&w, out);
    for (int i = 0; i < 2 * out->n; i++) {
        add_rest(&w, &out->event[i / 2], i % 2);
    }
    code = CR_ERR_OK;
out:
    free(w.span);
    free(w.turned);
    free(w.at);
    if (code != CR_ERR_OK) {
        cr_events_fini(out);
        return cr_err_set(err, code, "no memory for the impacts of a result");
    }
    return code;
}

const struct cr_sample *cr_event_before(const struct cr_solution *sol, const struct cr_event *event,
                                        int body) {
    return end_of(sol, event->first - 1, body);
}

void cr_events_fini(struct cr_events *events) {
    free(events->event);
    free(events->memory);
    *events = (struct cr_events){0};
}
