/* Induced deformation: a plastic string on the voxels of the struck face (method.md 5).
 *
 * Neighbouring lines of depth w are tied by the tension N0; outside the contact
 *     N0 (w[i-1] - 2 w[i] + w[i+1]) / h = h q_i,   w never decreasing,
 * where the string is stretched, with q the strength of the voxel at the surface (J/m2 = N/m). Solved exactly in each slice
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

/* A segment is taut where the crush has stretched it beyond its undeformed length: a wall that
 * flattens a rounded end leaves it slack. The ends of a face hang free. */
static double taut(const double *outline, const double *depth, int i, int n) {
    if (i == 0 || i == n) {
        return 0;
    }
    double rest = outline[i] - outline[i - 1], moved = depth[i] - depth[i - 1];
    return fabs(rest + moved) >= fabs(rest);
}

/* state of line i before the slice's pull */
static void prepare_line(struct cr_string *st, const struct lines *l, int i, double tension) {
    const double *depth = l->m->depth[l->face], *outline = l->m->outline[l->face];
    double h = l->g->h;
    int step, k = surface(l, i, &step);
    double q = k < 0 ? 0 : l->unit[voxel_at(l, i, k)] / (h * h);
    st->r[i] = k < 0 ? (double)INFINITY : h * h * q * l->m->share[l->face][i] / tension;
    st->w[i] = depth[i];
    st->taut[i] = taut(outline, depth, i, l->n);
    st->taut[i + 1] = taut(outline, depth, i + 1, l->n);
    st->free[i] = st->free[i] && st->taut[i] + st->taut[i + 1] > 0 && k >= 0;
}

/* the lines that the string may move: those with a dent and one on either side */
static void prepare(struct cr_string *st, const struct lines *l, double tension) {
    struct cr_span dented = l->m->dented[l->face];
    st->free = l->m->pulled[l->face];
    st->window.lo = dented.lo > 0 ? dented.lo - 1 : 0;
    st->window.hi = dented.hi + 1 < l->n ? dented.hi + 1 : dented.hi;
    for (int i = st->window.lo; i <= st->window.hi; i++) {
        prepare_line(st, l, i, tension);
    }
}

/* Free lines obey  tl (w - wl) + tr (w - wr) = -r,  t = 1 where the segment beside them is taut and
 * r = h^2 q / N0; the others stay at their depth. One sweep of the Thomas algorithm. */
static void sweep(const struct cr_string *st, const double *depth, struct cr_span window) {
    double *w = st->w, *gain = st->gain;
    for (int i = window.lo; i <= window.hi; i++) {
        gain[i] = 0;
        if (!st->free[i]) {
            w[i] = depth[i];
            continue;
        }
        /* w_i = gain_i w_{i+1} + w[i] */
        bool first = i == window.lo;
        double tl = st->taut[i], tr = st->taut[i + 1];
        double pivot = tl + tr - (first ? 0 : tl * gain[i - 1]);
        double known = first ? (i > 0 ? depth[i - 1] : 0) : w[i - 1];
        gain[i] = tr / pivot;
        w[i] = (tl * known - st->r[i]) / pivot;
    }
    double right = 0; /* the last line of the window is not free, or hangs free */
    for (int i = window.hi; i >= window.lo; i--) {
        w[i] += gain[i] * right;
        right = w[i];
    }
}

/* depth to which the neighbours would pull line i, -1 for one that hangs free */
static double pulled_to(const struct cr_string *st, int i, double wl, double wr) {
    double tl = st->taut[i], tr = st->taut[i + 1];
    return tl + tr > 0 ? (tl * wl + tr * wr - st->r[i]) / (tl + tr) : -1;
}

/* Policy iteration for the obstacle problem w >= depth: solve with the present set of free lines,
 * free those that would be pulled, hold those that would rise; exact after a few rounds because
 * the set of the slice before is nearly right. Returns the range of lines that moved. */
static struct cr_span relax(struct cr_string *st, const struct lines *l, double tension) {
    const double *depth = l->m->depth[l->face];
    struct cr_span window = st->window;
    int n = l->n;
    for (int round = 0; round < ROUNDS_MAX; round++) {
        sweep(st, depth, window);
        bool changed = false;
        for (int i = window.lo; i <= window.hi; i++) {
            double wl = i > window.lo ? st->w[i - 1] : i > 0 ? depth[i - 1] : 0;
            double wr = i < window.hi ? st->w[i + 1] : i + 1 < n ? depth[i + 1] : 0;
            bool pulled = pulled_to(st, i, wl, wr) > depth[i] + 1e-12;
            changed = changed || pulled != (st->free[i] != 0);
            st->free[i] = pulled;
        }
        /* the ends of the window must be at rest */
        int grow_lo = st->free[window.lo] && window.lo > 0;
        int grow_hi = st->free[window.hi] && window.hi + 1 < n;
        window.lo -= grow_lo;
        window.hi += grow_hi;
        if (grow_lo) {
            prepare_line(st, l, window.lo, tension);
        }
        if (grow_hi) {
            prepare_line(st, l, window.hi, tension);
        }
        if (!changed && !grow_lo && !grow_hi) {
            break;
        }
    }
    st->window = window;
    struct cr_span moved = {n, -1};
    for (int i = window.lo; i <= window.hi; i++) {
        if (st->w[i] > depth[i]) {
            moved.lo = i < moved.lo ? i : moved.lo;
            moved.hi = i;
        }
    }
    return moved;
}

/* Take the material between the old and the new depth of a line, within its surface voxel: the next
 * one has another strength, and the next slice will know it. */
static bool take(struct cr_string *st, const struct lines *l, int line, struct cr_losses *losses) {
    const double *depth = l->m->depth[l->face];
    double share = l->m->share[l->face][line];
    int step, k = surface(l, line, &step);
    if (k < 0) {
        st->w[line] = depth[line];
        return true;
    }
    int v = voxel_at(l, line, k);
    double amount = fmin((st->w[line] - depth[line]) / l->g->h * share, l->m->left[v]);
    st->w[line] = depth[line] + amount * l->g->h / share;
    return cr_deform_add(losses, v, CR_CRUSH_INDUCED, amount, amount * l->unit[v]);
}

/* of the segments in the window; those beyond are as they were made */
static double membrane_energy(const struct cr_string *st, double tension, double h) {
    double sum = 0;
    for (int i = st->window.lo + 1; i <= st->window.hi; i++) {
        double d = st->w[i] - st->w[i - 1];
        sum += st->taut[i] * d * d;
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
    if (m->dented[losses->face].hi < 0) {
        return true;
    }
    prepare(st, &l, tension);
    struct cr_span moved = relax(st, &l, tension);
    double before = losses->energy;
    for (int i = moved.lo; i <= moved.hi; i++) {
        if (st->w[i] > depth[i] && !take(st, &l, i, losses)) {
            return false;
        }
    }
    double stretched = membrane_energy(st, tension, g->h);
    losses->stretch = fmax(0, stretched - m->membrane[losses->face]);
    losses->induced = losses->energy - before + losses->stretch;
    losses->energy += losses->stretch;
    cr_deform_apply(m, losses, losses->contact);
    return true;
}
