/* Induced deformation: a plastic string on the voxels of the struck face (method.md 5).
 *
 * Neighbouring lines of depth w are tied by the tension N0; outside the contact
 *     N0 (w[i-1] - 2 w[i] + w[i+1]) / h = h q_i,   w never decreasing,
 * with q the strength of the voxel at the surface (J/m2 = N/m). Solved exactly in each slice
 * (an obstacle problem, by policy iteration); what the string pulls in is foundation energy, what it is
 * stretched by is membrane energy, both plastic. */
#include "solver/solver_priv.h"

enum { ROUNDS_MAX = 200 };

/* Lines of one face: line i runs inward from the outline. */
struct lines {
    const struct cr_grid *g;
    const struct cr_moving *m;
    const double *unit;
    enum cr_face face;
    int n;
};

static int voxel_at(const struct lines *l, int line, int along) {
    bool row = l->face == CR_FACE_FRONT || l->face == CR_FACE_REAR;
    return row ? line * l->g->nx + along : along * l->g->nx + line;
}

/* first voxel from outside that still has material, -1 if the line has none */
static int surface(const struct lines *l, int line, int *next) {
    bool row = l->face == CR_FACE_FRONT || l->face == CR_FACE_REAR;
    bool from_end = l->face == CR_FACE_FRONT || l->face == CR_FACE_LEFT;
    struct cr_span span = row ? l->m->row[line] : l->m->col[line];
    int step = from_end ? -1 : 1;
    int k = from_end ? span.hi - 1 : span.lo;
    for (; k >= span.lo && k < span.hi; k += step) {
        if (l->m->left[voxel_at(l, line, k)] > 0) {
            *next = step;
            return k;
        }
    }
    return -1;
}

static enum cr_face struck_face(const struct cr_moving *m, struct cr_vec2 inward) {
    struct cr_vec2 d = cr_vec2_unrotate(inward, m->c, m->s);
    if (fabs(d.x) >= fabs(d.y)) {
        return d.x < 0 ? CR_FACE_FRONT : CR_FACE_REAR;
    }
    return d.y < 0 ? CR_FACE_LEFT : CR_FACE_RIGHT;
}

/* Free lines obey w = (wl + wr)/2 - r, r = h^2 q / (2 N0); the others stay at their depth. One
 * sweep of the Thomas algorithm over [lo, hi], with the string anchored at both ends of the face. */
static void sweep(const struct cr_string *st, const double *depth, struct cr_span window, int n) {
    double *w = st->w, *g = st->gain;
    for (int i = window.lo; i <= window.hi; i++) {
        bool first = i == window.lo;
        double wl = first ? (i > 0 ? depth[i - 1] : 0) : 0;
        double gl = first ? 0 : g[i - 1], cl = first ? wl : w[i - 1];
        if (st->free[i]) { /* w_i = gain w_{i+1} + w[i] */
            double pivot = 1 - 0.5 * gl;
            g[i] = 0.5 / pivot;
            w[i] = (0.5 * cl - st->r[i]) / pivot;
        } else {
            g[i] = 0;
            w[i] = depth[i];
        }
    }
    double right = window.hi + 1 < n ? depth[window.hi + 1] : 0;
    for (int i = window.hi; i >= window.lo; i--) {
        w[i] += g[i] * right;
        right = w[i];
    }
}

/* Policy iteration for the obstacle problem w >= depth: solve with the present set of free lines,
 * free those that would be pulled, hold those that would rise; exact after a few rounds because
 * the set of the slice before is nearly right. Returns the range of lines that moved. */
static struct cr_span relax(const struct cr_string *st, const double *depth, int n,
                            struct cr_span *window) {
    for (int round = 0; round < ROUNDS_MAX; round++) {
        sweep(st, depth, *window, n);
        bool changed = false;
        for (int i = window->lo; i <= window->hi; i++) {
            double wl = i > window->lo ? st->w[i - 1] : i > 0 ? depth[i - 1] : 0;
            double wr = i < window->hi ? st->w[i + 1] : i + 1 < n ? depth[i + 1] : 0;
            bool pulled = 0.5 * (wl + wr) - st->r[i] > depth[i] + 1e-12;
            changed = changed || pulled != (st->free[i] != 0);
            st->free[i] = pulled;
        }
        if (st->free[window->lo] && window->lo > 0) {
            window->lo--;
            changed = true;
        }
        if (st->free[window->hi] && window->hi + 1 < n) {
            window->hi++;
            changed = true;
        }
        if (!changed) {
            break;
        }
    }
    struct cr_span moved = {n, -1};
    for (int i = window->lo; i <= window->hi; i++) {
        if (st->w[i] > depth[i]) {
            moved.lo = i < moved.lo ? i : moved.lo;
            moved.hi = i;
        }
    }
    return moved;
}

/* take the material between the old and the new depth of a line, from the surface inward */
static bool take(const struct lines *l, int line, double by, struct cr_losses *losses) {
    int step = 0, k = surface(l, line, &step);
    bool row = l->face == CR_FACE_FRONT || l->face == CR_FACE_REAR;
    struct cr_span span = row ? l->m->row[line] : l->m->col[line];
    double want = by / l->g->h;
    for (; k >= span.lo && k < span.hi && want > 1e-12; k += step) {
        int v = voxel_at(l, line, k);
        double amount = fmin(want, l->m->left[v]);
        if (amount > 0) {
            if (!cr_deform_add(losses, v, CR_CRUSH_INDUCED, amount, amount * l->unit[v])) {
                return false;
            }
            want -= amount;
        }
    }
    return true;
}

static double membrane_energy(const double *w, int n, double tension, double h) {
    double sum = 0;
    for (int i = 0; i <= n; i++) {
        double d = (i < n ? w[i] : 0) - (i > 0 ? w[i - 1] : 0);
        sum += d * d;
    }
    return 0.5 * tension * sum / h;
}

bool cr_string_pull(struct cr_solver *s, struct cr_moving *m, int partner, struct cr_vec2 inward,
                    struct cr_losses *losses) {
    const struct cr_grid *g = &m->body->grid;
    losses->face = struck_face(m, inward);
    double tension = g->nx > 0 ? g->tension[losses->face] : 0;
    if (losses->n == 0 || !(tension > 0)) {
        return true;
    }
    bool row = losses->face == CR_FACE_FRONT || losses->face == CR_FACE_REAR;
    struct lines l = {g, m, m->unit[partner], losses->face, row ? g->ny : g->nx};
    const double *depth = m->depth[losses->face];
    struct cr_string *st = &s->string;
    st->free = m->pulled[losses->face];
    struct cr_span window = {l.n, -1};
    for (int i = 0; i < l.n; i++) {
        int step, k = surface(&l, i, &step);
        double q = k < 0 ? 0 : l.unit[voxel_at(&l, i, k)] / (g->h * g->h);
        st->r[i] = k < 0 ? (double)INFINITY : g->h * g->h * q / (2 * tension);
        st->w[i] = depth[i];
        if (depth[i] > 0) {
            window.lo = window.lo < i ? window.lo : i > 0 ? i - 1 : 0;
            window.hi = i + 1 < l.n ? i + 1 : i;
        }
    }
    struct cr_span moved = relax(st, depth, l.n, &window);
    double before = losses->energy;
    for (int i = moved.lo; i <= moved.hi; i++) {
        if (st->w[i] > depth[i] && !take(&l, i, st->w[i] - depth[i], losses)) {
            return false;
        }
    }
    double stretched = membrane_energy(st->w, l.n, tension, g->h);
    losses->stretch = fmax(0, stretched - m->membrane[losses->face]);
    losses->induced = losses->energy - before + losses->stretch;
    losses->energy += losses->stretch;
    cr_deform_apply(m, losses, losses->contact);
    return true;
}
