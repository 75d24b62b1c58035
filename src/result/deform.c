/* Measures the deformation of a solved vehicle: depths, columns, area, struck face. */
#include "result/deform.h"

#include "solver/solver.h"

#include <math.h>
#include <string.h>

/* So much intact material behind damage ends a column, m: the damage beyond came from elsewhere. */
static const double intact_least = 0.3;
/* A loss below this share of a voxel's material is rounding. */
static const double nothing = 1e-9;

/* This share of a shallow crush springs back, as in the tests against walls at 23 to 40 km/h of
 * share/validation/data. */
static const double shallow = 0.4;
/* A crush of fronts up to this depth leaves no residual one, m: a wall at 8 km/h [LOW-SPEED]. */
static const double elastic_depth = 0.053;

double cr_deform_residual(double dynamic, double springback) {
    if (!(dynamic > 0)) {
        return 0;
    }
    double back = springback > 0 ? springback : 0;
    return dynamic - fmin(back, fmax(shallow * dynamic, fmin(dynamic, elastic_depth)));
}

double cr_deform_dynamic(double residual, double springback) {
    if (!(residual > 0)) {
        return 0;
    }
    double back = springback > 0 ? springback : 0;
    return fmin(residual + back, fmax(residual + elastic_depth, residual / (1 - shallow)));
}

/* Goes one step along a line or column and adds the loss to *sum; true when the line has ended.
 * *intact is the intact material since the last loss, m. */
static bool walk(double fill, double lost, double step, double *sum, double *intact) {
    if (lost > nothing) {
        *sum += lost * step;
        *intact = 0;
    } else {
        *intact += fill * step;
    }
    return *sum > 0 && *intact > intact_least;
}

/* The box of the voxels that lost material, from lo to hi, both included; false if none did. */
static bool lost_box(const struct cr_deform *d, int lo[2], int hi[2]) {
    const struct cr_grid *g = d->grid;
    lo[0] = g->nx;
    lo[1] = g->ny;
    hi[0] = hi[1] = -1;
    for (int i = 0; i < g->nx * g->ny; i++) {
        if (g->fill[i] - d->left[i] > nothing) {
            int x = i % g->nx, y = i / g->nx;
            lo[0] = x < lo[0] ? x : lo[0];
            hi[0] = x > hi[0] ? x : hi[0];
            lo[1] = y < lo[1] ? y : lo[1];
            hi[1] = y > hi[1] ? y : hi[1];
        }
    }
    return hi[0] >= 0;
}

void cr_deepest_add(struct cr_deepest *d, double depth) {
    enum { MOST = sizeof d->last / sizeof d->last[0] };
    double lines = fmin(CR_DEFORM_WIDTH / d->step, MOST - 1);
    int whole = (int)(lines + 1e-9);
    double part = lines - whole, sum = 0;
    d->last[d->n++ % MOST] = depth;
    d->sum += depth;
    if (d->n < whole + (part > 1e-9)) {
        return;
    }
    for (int i = d->n - whole; i < d->n; i++) {
        sum += d->last[i % MOST];
    }
    /* The mean is greatest where the window begins or ends exactly between two strips. */
    double before = part > 1e-9 ? d->last[(d->n - whole - 1) % MOST] : 0;
    double after = part > 1e-9 ? sum - d->last[(d->n - 1) % MOST] + before : sum;
    d->top = fmax(d->top, (sum + part * before) / lines);
    d->top = fmax(d->top, part > 1e-9 ? (after + part * depth) / lines : 0);
}

double cr_deepest_get(const struct cr_deepest *d) {
    return d->n > 0 && d->n * d->step < CR_DEFORM_WIDTH - 1e-9 ? d->sum / d->n : d->top;
}

/* Cuts the line at + t dir (in voxels) to the part [*t0, *t1] inside the box lo..hi+1; false if it
 * misses the box. */
static bool clip(struct cr_vec2 at, struct cr_vec2 dir, const int lo[2], const int hi[2],
                 double *t0, double *t1) {
    double p[2] = {at.x, at.y}, v[2] = {dir.x, dir.y};
    *t0 = -1e9;
    *t1 = 1e9;
    for (int a = 0; a < 2; a++) {
        if (fabs(v[a]) < 1e-12) {
            if (p[a] < lo[a] || p[a] >= hi[a] + 1) {
                return false;
            }
            continue;
        }
        double u = (lo[a] - p[a]) / v[a], w = (hi[a] + 1 - p[a]) / v[a];
        *t0 = fmax(*t0, fmin(u, w));
        *t1 = fmin(*t1, fmax(u, w));
    }
    return *t1 > *t0;
}

/* The length of material lost along the line at + t dir; everything is in voxels. */
static double line_loss(const struct cr_deform *d, struct cr_vec2 at, struct cr_vec2 dir,
                        const int lo[2], const int hi[2]) {
    static const double step_most = 0.25; /* voxels */
    const struct cr_grid *g = d->grid;
    double t0, t1, sum = 0, intact = 0;
    if (!clip(at, dir, lo, hi, &t0, &t1)) {
        return 0;
    }
    int n = (int)ceil((t1 - t0) / step_most);
    double step = (t1 - t0) / n;
    for (int i = 0; i < n; i++) {
        struct cr_vec2 p = cr_vec2_axpy(at, t0 + (i + 0.5) * step, dir);
        if (!(p.x >= 0 && p.y >= 0 && p.x < g->nx && p.y < g->ny)) {
            continue;
        }
        int k = (int)p.y * g->nx + (int)p.x;
        if (walk(g->fill[k] * g->h, g->fill[k] - d->left[k], step, &sum, &intact)) {
            break;
        }
    }
    return sum;
}

double cr_deform_max(const struct cr_deform *d, struct cr_vec2 inward) {
    int lo[2], hi[2];
    if (!lost_box(d, lo, hi)) {
        return 0;
    }
    struct cr_vec2 side = cr_vec2_perp(inward);
    struct cr_vec2 mid = {(lo[0] + hi[0] + 1) / 2.0, (lo[1] + hi[1] + 1) / 2.0};
    double half = (fabs(side.x) * (hi[0] + 1 - lo[0]) + fabs(side.y) * (hi[1] + 1 - lo[1])) / 2;
    /* The lines are one voxel apart and go through voxel centres if they run along the grid. */
    int n = (int)ceil(2 * half - 1e-9);
    double pitch = 2 * half / n;
    /* Lines beside the damage count too: the mean over a narrow damage includes what stands. */
    int beside = (int)ceil(CR_DEFORM_WIDTH / (pitch * d->grid->h));
    struct cr_deepest top = {.step = pitch * d->grid->h};
    for (int i = -beside; i < n + beside; i++) {
        struct cr_vec2 at = cr_vec2_axpy(mid, (i + 0.5) * pitch - half, side);
        cr_deepest_add(&top, line_loss(d, at, inward, lo, hi));
    }
    return cr_deepest_get(&top) * d->grid->h;
}

/* The index of the voxel at place i of column k, counted from the face. */
static int place(const struct cr_grid *g, enum cr_face face, int k, int i) {
    bool along = cr_face_is_end(face);
    int j = cr_face_from_high(face) ? cr_face_line_length(g, face) - 1 - i : i;
    /* Columns of the ends run from left to right, which is falling y. */
    return along ? (g->ny - 1 - k) * g->nx + j : j * g->nx + k;
}

double cr_deform_column(const struct cr_deform *d, enum cr_face face, int k, bool contact_only) {
    const struct cr_grid *g = d->grid;
    int n = cr_face_line_length(g, face);
    double sum = 0, intact = 0;
    for (int i = 0; i < n; i++) {
        int at = place(g, face, k, i);
        double lost = g->fill[at] - d->left[at];
        if (contact_only && d->how && !(d->how[at] & CR_CRUSH_CONTACT)) {
            lost = 0;
        }
        if (walk(g->fill[at] * g->h, lost, 1, &sum, &intact) ||
            (!d->through && !(sum > 0) && intact > intact_least)) {
            break;
        }
    }
    return sum * g->h;
}

double cr_deform_setback(const struct cr_grid *g, enum cr_face face, int k) {
    int n = cr_face_line_length(g, face);
    for (int i = 0; i < n; i++) {
        double fill = g->fill[place(g, face, k, i)];
        if (fill > nothing) {
            return (i + 1 - fill) * g->h;
        }
    }
    return n * g->h;
}

enum cr_face cr_deform_face_at(const struct cr_grid *g, struct cr_vec2 at, struct cr_vec2 inward) {
    enum cr_face end = inward.x < 0 ? CR_FACE_FRONT : CR_FACE_REAR;
    enum cr_face flank = inward.y < 0 ? CR_FACE_LEFT : CR_FACE_RIGHT;
    double x = at.x - g->x0, y = at.y - g->y0;
    double to_end = fmax(0, end == CR_FACE_FRONT ? g->nx * g->h - x : x);
    double to_flank = fmax(0, flank == CR_FACE_LEFT ? g->ny * g->h - y : y);
    /* Both divided by the speed towards the face, which may be 0, say which is met first. */
    return to_end * fabs(inward.y) <= to_flank * fabs(inward.x) ? end : flank;
}

void cr_deform_relax(const struct cr_deform *d, enum cr_face face, double *left) {
    const struct cr_grid *g = d->grid;
    memcpy(left, d->left, (size_t)g->nx * (size_t)g->ny * sizeof *left);
    for (int k = 0; k < cr_face_lines(g, face) && !d->residual_curve; k++) {
        double lost = cr_deform_column(d, face, k, false), sum = 0;
        double back = (lost - cr_deform_residual(lost, g->springback[face])) / g->h;
        int deep = 0;
        /* The last of the column's loss lies at place `deep`. */
        for (int i = 0; sum * g->h < lost - nothing && i < cr_face_line_length(g, face); i++) {
            int at = place(g, face, k, i);
            sum += fmax(0, g->fill[at] - left[at]);
            deep = i;
        }
        for (int i = deep; i >= 0 && back > 0; i--) {
            int at = place(g, face, k, i);
            double more = fmin(fmax(0, g->fill[at] - left[at]), back);
            left[at] += more;
            back -= more;
        }
    }
}

enum cr_face cr_deform_face(const struct cr_deform *d, struct cr_vec2 inward) {
    const struct cr_grid *g = d->grid;
    double of[CR_FACES] = {0};
    for (int i = 0; i < g->nx * g->ny; i++) {
        double lost = g->fill[i] - d->left[i];
        if (lost > nothing) {
            struct cr_vec2 at = {g->x0 + (i % g->nx + 0.5) * g->h,
                                 g->y0 + ((int)(i / g->nx) + 0.5) * g->h};
            of[cr_deform_face_at(g, at, inward)] += g->energy[i] * lost / g->fill[i];
        }
    }
    enum cr_face best = fabs(inward.x) >= fabs(inward.y)
                            ? (inward.x < 0 ? CR_FACE_FRONT : CR_FACE_REAR)
                        : inward.y < 0 ? CR_FACE_LEFT
                                       : CR_FACE_RIGHT;
    for (int f = 0; f < CR_FACES; f++) {
        best = of[f] > of[best] ? (enum cr_face)f : best;
    }
    return best;
}
