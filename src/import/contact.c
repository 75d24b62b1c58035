/* Finds where participants are at a time, and when their outlines meet first. */
#include "import/import_priv.h"

#include <math.h>
#include <stdlib.h>

/* For this long (s) a participant without further rows is taken to go on as it did, so that a file
 * with a row a second has no gaps. */
static const double goes_on = 1.0;

/* ---- poses ---- */

static struct cr_waypoint between(const struct cr_waypoint *a, const struct cr_waypoint *b,
                                  double t) {
    double k = (t - a->t) / (b->t - a->t);
    struct cr_waypoint out = {.t = t, .pos = cr_vec2_axpy(a->pos, k, cr_vec2_sub(b->pos, a->pos))};
    out.heading = a->heading + k * cr_angle_wrap(b->heading - a->heading);
    out.speed = a->speed + k * (b->speed - a->speed);
    return out;
}

/* Pose of a participant at a time, s; false where it is not there then. Times must not go back
 * between calls, because the search goes on from the row of the last one. */
static bool pose_at(struct cr_import_part *part, double t, struct cr_waypoint *out) {
    if (part->n == part->first) {
        *out = (struct cr_waypoint){
            .t = t, .pos = part->p.pos, .heading = part->p.heading, .speed = 0};
        return part->p.kind == CR_KIND_OBJECT;
    }
    part->at = part->at < part->first ? part->first : part->at;
    while (part->at + 1 < part->n && part->row[part->at + 1].t <= t) {
        part->at++;
    }
    const struct cr_waypoint *a = &part->row[part->at];
    if (t < a->t || t > a->t + goes_on) {
        return false;
    }
    if (part->at + 1 < part->n) {
        *out = between(a, a + 1, t);
        return true;
    }
    double s = a->speed * (t - a->t);
    *out = *a;
    out->pos = cr_vec2_axpy(a->pos, s, cr_vec2(cos(a->heading), sin(a->heading)));
    return true;
}

/* ---- overlap of convex outlines ---- */

struct placed {
    struct cr_import_part *part;
    struct cr_vec2 pos;
    int n;
    struct cr_vec2 corner[CR_VERTEX_MAX];
};

static void extent(const struct placed *p, struct cr_vec2 axis, double *lo, double *hi) {
    *lo = INFINITY;
    *hi = -INFINITY;
    for (int i = 0; i < p->n; i++) {
        double x = cr_vec2_dot(p->corner[i], axis);
        *lo = fmin(*lo, x);
        *hi = fmax(*hi, x);
    }
}

/* Tells whether the two outlines lie apart in the direction across one of a's edges: convex
 * outlines overlap only if they do so for no edge of either. */
static bool parted(const struct placed *a, const struct placed *b) {
    for (int i = 0; i < a->n; i++) {
        struct cr_vec2 edge = cr_vec2_sub(a->corner[(i + 1) % a->n], a->corner[i]);
        double alo, ahi, blo, bhi;
        extent(a, cr_vec2_perp(edge), &alo, &ahi);
        extent(b, cr_vec2_perp(edge), &blo, &bhi);
        if (ahi <= blo || bhi <= alo) {
            return true;
        }
    }
    return false;
}

static void place(struct cr_import_part *part, const struct cr_waypoint *pose, struct placed *out) {
    double c = cos(pose->heading), s = sin(pose->heading);
    out->part = part;
    out->pos = pose->pos;
    out->n = part->corners;
    for (int i = 0; i < part->corners; i++) {
        out->corner[i] = cr_vec2_add(pose->pos, cr_vec2_rotate(part->corner[i], c, s));
    }
}

static bool overlap(struct cr_import_part *a, const struct cr_waypoint *pa,
                    struct cr_import_part *b, const struct cr_waypoint *pb) {
    struct placed x, y;
    double far = cr_vec2_len(cr_vec2_sub(pa->pos, pb->pos));
    if (far >= a->radius + b->radius || a->corners < 3 || b->corners < 3) {
        return false;
    }
    place(a, pa, &x);
    place(b, pb, &y);
    return !parted(&x, &y) && !parted(&y, &x);
}

void cr_import_look(struct cr_import_case *c, double t) {
    for (int i = 0; i < c->parts; i++) {
        struct cr_waypoint a, b;
        if (!c->part[i]->fixed || !pose_at(c->part[i], t, &a)) {
            continue;
        }
        for (int k = 0; k < i; k++) {
            bool objects =
                c->part[i]->p.kind == CR_KIND_OBJECT && c->part[k]->p.kind == CR_KIND_OBJECT;
            if (!objects && c->part[k]->fixed && pose_at(c->part[k], t, &b) &&
                overlap(c->part[i], &a, c->part[k], &b)) {
                c->part[i]->hit = c->part[k]->hit = true;
                c->met = true;
                c->t_met = t;
            }
        }
    }
}

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

enum cr_err cr_import_search(struct cr_import_case *c, struct cr_error *err) {
    double *t = malloc(((size_t)c->rows + 1) * sizeof *t);
    long n = 0;
    if (t == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the rows of a case");
    }
    for (int i = 0; i < c->parts; i++) {
        struct cr_import_part *part = c->part[i];
        part->at = part->first;
        for (int k = part->first; k < part->n; k++) {
            t[n++] = part->row[k].t;
        }
    }
    qsort(t, (size_t)n, sizeof *t, by_value);
    for (long i = 0; i < n && !c->met; i++) {
        if (i == 0 || t[i] > t[i - 1]) {
            cr_import_look(c, t[i]);
        }
    }
    free(t);
    return CR_ERR_OK;
}

void cr_import_cut(struct cr_import_case *c, double from, double to) {
    for (int i = 0; i < c->parts; i++) {
        struct cr_import_part *part = c->part[i];
        int first = part->first, n = part->n;
        /* The 1e-9 s are there for the rounding of doubles: 12.3 - 2 keeps the row of 10.3. */
        while (first + 2 < n && part->row[first].t < from - 1e-9) {
            first++;
        }
        while (n > first + 2 && part->row[n - 1].t > to + 1e-9) {
            n--;
        }
        c->rows -= first - part->first + part->n - n;
        c->cut = c->cut || first > part->first;
        part->first = first;
        part->n = n;
    }
}
