/* Step 1, continued: which of two crushing bodies gives way.
 *
 * The weaker of the two does (paper, assumption from Lin et al. 1975). Weak and strong are meant of
 * structures, not of single voxels: strengths are means over a reach along the contact, of the
 * voxels pressed together there and of the string on their lines. Were it decided voxel by voxel,
 * the weakest line of a car would decide for all, because its string pulls the lines beside it to
 * the depth of the deepest, and the energies would not settle however fine the grid. */
#include "solver/solver_priv.h"

const double cr_yield_reach = 0.075; /* a rail or a headlamp */

/* time over which it is one, s: which voxels are pressed on in a slice is chance of where the grids
 * lie, and strengths that answer at once to the string's pull would overshoot and swing */
const double cr_yield_memory = 2e-3;

/* time over which it is seen which lines are pressed on, s: a line that the string pulls out of the
 * opponent's way is met again, and with less the edges of small contacts swing */
static const double range_memory = 6e-3;

/* relative difference of strength at which the weaker takes the whole loss; below it both share,
 * so that equal cars deform equally and nothing jumps when strengths cross */
static const double share_band = 0.2;

/* what a sum that is nothing but rounding can come to, of the sum over all lines */
static const double trace = 1e-9;

/* time in which that share settles at which both are equally strong, s */
static const double lean_time = 4e-3;

static bool by_row(const struct cr_losses *losses) {
    return cr_face_is_end(losses->face);
}

/* number of lines of the struck face */
static int lines_of(const struct cr_moving *m, const struct cr_losses *losses) {
    return cr_face_lines(&m->body->grid, losses->face);
}

/* Place at which the sum of amounts over lines, from one end on, reaches half of a line's worth:
 * how far into the lines from that end. */
static double depth_of_edge(const double *amount, int n, int step, double half) {
    double sum = 0;
    for (int k = 0; k < n; k++, amount += step) {
        if (sum + *amount >= half) {
            return k + (half - sum) / *amount;
        }
        sum += *amount;
    }
    return n;
}

/* What is left at time t of a memory that was last renewed at *last, which it moves on. */
static double kept(double t, double *last, double memory) {
    double keep = exp((*last - t) / memory);
    *last = t;
    return keep;
}

void cr_yield_range(struct cr_solver *s, struct cr_moving *m, struct cr_losses *losses) {
    losses->met = (struct cr_range){0, 0};
    if (losses->n == 0) {
        return;
    }
    bool row = by_row(losses);
    int n = lines_of(m, losses);
    double *pressed = losses->press->pressed,
           keep = kept(s->t, &losses->press->t_pressed, range_memory);
    for (int k = 0; k < n; k++) {
        pressed[k] *= keep;
    }
    for (int i = 0; i < losses->n; i++) {
        pressed[row ? losses->loss[i].iy : losses->loss[i].ix] += losses->loss[i].amount;
    }
    double sum = 0, squares = 0;
    for (int k = 0; k < n; k++) {
        sum += pressed[k];
        squares += pressed[k] * pressed[k];
    }
    double half = 0.5 * squares / sum;
    losses->met.lo = fmax(0, depth_of_edge(pressed, n, 1, half) - 0.5) - 0.5;
    losses->met.hi = n - 0.5 - fmax(0, depth_of_edge(pressed + n - 1, n, -1, half) - 0.5);
}

/* Into the memory of the lines of both bodies goes by how much the opponent is stronger on the
 * voxels of `losses`; other: the opponent's losses. */
static void remember(const struct cr_losses *losses, const struct cr_losses *other) {
    double *more = losses->press->more, *all = losses->press->all;
    double *their_more = other->press->more, *their_all = other->press->all;
    bool row = by_row(losses);
    for (int i = 0; i < losses->n; i++) {
        const struct cr_loss *l = &losses->loss[i];
        int line = row ? l->iy : l->ix;
        double unit = losses->unit[l->voxel], pull = cr_pull_at(losses, l);
        double stronger = l->amount * (l->beside - unit - pull);
        double both = l->amount * (l->beside + unit + fabs(pull));
        more[line] += stronger;
        all[line] += both;
        their_more[l->line] -= (1 - l->next) * stronger;
        their_all[l->line] += (1 - l->next) * both;
        their_more[l->line + 1] -= l->next * stronger;
        their_all[l->line + 1] += l->next * both;
    }
}

/* older slices fade */
static void fade(const struct cr_moving *m, const struct cr_losses *losses, double t) {
    double *more = losses->press->more, *all = losses->press->all;
    double keep = kept(t, &losses->press->t_weighed, cr_yield_memory);
    for (int k = 0, n = lines_of(m, losses); k < n; k++) {
        more[k] *= keep;
        all[k] *= keep;
    }
}

/* share of the excess that each line of a body takes, 0..1 */
static void share_lines(struct cr_solver *s, const struct cr_moving *m,
                        const struct cr_losses *mine) {
    struct cr_yield *y = &s->yield;
    const double *more = mine->press->more, *all = mine->press->all;
    double *lean = mine->press->lean, *share = mine->press->share;
    int wide = (int)lround(cr_yield_reach / m->body->grid.h), n = lines_of(m, mine);
    y->more[0] = y->all[0] = 0;
    for (int k = 0; k < n; k++) {
        y->more[k + 1] = y->more[k] + more[k];
        y->all[k + 1] = y->all[k] + all[k];
    }
    for (int k = 0; k < n; k++) {
        int from = k - wide > 0 ? k - wide : 0, to = k + wide + 1 < n ? k + wide + 1 : n;
        double sum = y->all[to] - y->all[from];
        double weaker =
            sum > trace * y->all[n] ? (y->more[to] - y->more[from]) / (share_band * sum) : 0;
        lean[k] = cr_clamp(lean[k] + weaker * s->dt / lean_time, -1, 1);
        share[k] = cr_clamp(0.5 * (1 + lean[k] + weaker), 0, 1);
    }
}

/* leaves of one body's losses its share; seen from both bodies, so that both shares make one */
static void keep_share(struct cr_losses *losses, const double *mine, const double *theirs) {
    bool row = by_row(losses);
    int kept = 0;
    for (int i = 0; i < losses->n; i++) {
        struct cr_loss l = losses->loss[i];
        double other = theirs[l.line] + l.next * (theirs[l.line + 1] - theirs[l.line]);
        double share = 0.5 * (mine[row ? l.iy : l.ix] + 1 - other);
        if (share > 0) {
            l.amount *= share;
            l.energy *= share;
            losses->loss[kept++] = l;
        }
    }
    losses->n = kept;
}

void cr_yield_share(struct cr_solver *s, int a, int b) {
    const struct cr_moving *ma = &s->m[a], *mb = &s->m[b];
    struct cr_losses *la = &s->losses[0], *lb = &s->losses[1];
    fade(ma, la, s->t);
    fade(mb, lb, s->t);
    remember(la, lb);
    remember(lb, la);
    share_lines(s, ma, la);
    share_lines(s, mb, lb);
    const double *share_a = la->press->share, *share_b = lb->press->share;
    keep_share(la, share_a, share_b);
    keep_share(lb, share_b, share_a);
}

/* The outermost voxel of those hit before, without a gap from a voxel outwards. */
static int outermost_crumb(const struct cr_moving *m, int voxel, int beyond, int step) {
    const double *fill = m->body->grid.fill;
    while (beyond-- > 0 && m->left[voxel + step] > 0 &&
           m->left[voxel + step] < fill[voxel + step]) {
        voxel += step;
    }
    return voxel;
}

/* From a voxel on inward until a loss is made up, ending at its own voxel; the first part replaces
 * it, further ones are added behind the others. Each keeps what its voxel held in `beside`. */
static bool take_inward(struct cr_moving *m, struct cr_losses *losses, int i, int voxel, int step) {
    const struct cr_grid *g = &m->body->grid;
    struct cr_loss whole = losses->loss[i];
    double want = whole.amount;
    if (voxel == whole.voxel) {
        losses->loss[i].beside = m->left[voxel];
        m->left[voxel] -= want;
        return true;
    }
    for (bool first = true; want > 0; voxel -= step) {
        double left = m->left[voxel], amount = left - want < cr_crumb ? left : want;
        if (!first && !cr_losses_reserve(losses, 1)) {
            return false;
        }
        struct cr_loss *part = first ? &losses->loss[i] : &losses->loss[losses->n++];
        *part = (struct cr_loss){.voxel = voxel,
                                 .ix = voxel % g->nx,
                                 .iy = voxel / g->nx,
                                 .amount = amount,
                                 .energy = amount * losses->unit[voxel],
                                 .beside = left};
        m->left[voxel] = left - amount;
        want -= amount;
        first = false;
        if (voxel == whole.voxel) {
            break;
        }
    }
    return true;
}

bool cr_yield_order(struct cr_moving *m, struct cr_losses *losses) {
    const struct cr_grid *g = &m->body->grid;
    bool row = by_row(losses);
    bool up = losses->face == CR_FACE_FRONT || losses->face == CR_FACE_LEFT;
    int step = (up ? 1 : -1) * (row ? 1 : g->nx), end = row ? g->nx : g->ny, n = losses->n;
    bool ok = true;
    for (int k = 0; ok && k < n; k++) { /* the outer ones of a line first */
        int i = up ? n - 1 - k : k;
        const struct cr_loss *l = &losses->loss[i];
        int along = row ? l->ix : l->iy, beyond = up ? end - 1 - along : along;
        ok = take_inward(m, losses, i, outermost_crumb(m, l->voxel, beyond, step), step);
    }
    for (int i = 0; i < losses->n; i++) { /* nothing has changed yet */
        double *left = &m->left[losses->loss[i].voxel], before = losses->loss[i].beside;
        *left = before > *left ? before : *left;
    }
    return ok;
}
