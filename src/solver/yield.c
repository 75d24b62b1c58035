/* Step 1, continued: which of two crushing bodies gives way.
 *
 * The weaker of the two does (paper, assumption from Lin et al. 1975). Weak and strong are meant of
 * structures, not of single voxels: strengths are means over a reach along the contact, of the
 * voxels pressed together there and of the string on their lines. Were it decided voxel by voxel,
 * the weakest line of a car would decide for all, because its string pulls the lines beside it to
 * the depth of the deepest, and the energies would not settle however fine the grid. */
#include "solver/solver_priv.h"

/* Distance along the contact over which a line's weight in such a mean falls to 1/e, m: about a
 * rail or a headlamp either way. Weights that fade see every wavelength and none the wrong way
 * round, as those of a window do; along such a one neighbouring lines part, and the split of the
 * energy hangs on the voxel. */
static const double yield_reach = 0.06;

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

/* those of the lines between which a memory holds more than `least` */
static struct cr_span above(const double *memory, struct cr_span lines, double least) {
    while (lines.lo < lines.hi && memory[lines.lo] <= least) {
        lines.lo++;
    }
    while (lines.lo < lines.hi && memory[lines.hi - 1] <= least) {
        lines.hi--;
    }
    return lines;
}

/* the lines of a face between which a memory holds anything: few of a face in a contact */
static struct cr_span held(const double *memory, int n) {
    return above(memory, (struct cr_span){0, n}, 0);
}

/* Place at which the sum of amounts over the lines from the k-th on, counted from one end, reaches
 * half of a line's worth: how far into the lines from that end. */
static double depth_of_edge(const double *amount, int k, int n, int step, double half) {
    double sum = 0;
    for (; k < n; k++) {
        double here = amount[k * step];
        if (sum + here >= half) {
            return k + (half - sum) / here;
        }
        sum += here;
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
    double *pressed = losses->press->pressed, sum = 0, squares = 0;
    double keep = kept(s->t, &losses->press->t_pressed, range_memory);
    for (int k = 0; k < n; k++) {
        pressed[k] *= keep;
    }
    for (int i = 0; i < losses->n; i++) {
        pressed[row ? losses->loss[i].iy : losses->loss[i].ix] += losses->loss[i].amount;
    }
    struct cr_span lines = held(pressed, n);
    for (int k = lines.lo; k < lines.hi; k++) {
        sum += pressed[k];
        squares += pressed[k] * pressed[k];
    }
    double half = 0.5 * squares / sum;
    double before = depth_of_edge(pressed, lines.lo, n, 1, half);
    double behind = depth_of_edge(pressed + n - 1, n - lines.hi, n, -1, half);
    losses->met.lo = fmax(0, before - 0.5) - 0.5;
    losses->met.hi = n - 0.5 - fmax(0, behind - 0.5);
}

/* The way outwards along the lines of the struck face. */
struct outwards {
    bool row, up;
    int dx, dy, step; /* to the next voxel outwards, in voxels and in the grid's order */
    int end;          /* voxels of a line */
};

static struct outwards outwards(const struct cr_moving *m, const struct cr_losses *losses) {
    const struct cr_grid *g = &m->body->grid;
    bool row = by_row(losses), up = cr_face_from_high(losses->face);
    int out = up ? 1 : -1, dx = row ? out : 0, dy = row ? 0 : out;
    return (struct outwards){
        row, up, dx, dy, dy * g->nx + dx, cr_face_line_length(g, losses->face)};
}

/* From the voxel of a loss on outwards: how many of those hit before are there without a gap? They
 * give way before it does. */
static inline int crumbs_beyond(const struct cr_moving *m, const struct outwards *o,
                                const struct cr_loss *l) {
    const double *left = m->left + l->voxel, *fill = m->body->grid.fill + l->voxel;
    int along = o->row ? l->ix : l->iy, beyond = o->up ? o->end - 1 - along : along, n = 0;
    while (n < beyond && left[o->step] > 0 && fill[o->step] - left[o->step] > cr_crumb) {
        left += o->step;
        fill += o->step;
        n++;
    }
    return n;
}

/* Into the memory of the lines of both bodies goes by how much the opponent is stronger on the
 * voxels of `losses`; other: the opponent's losses. A voxel is as strong as what gives way for it:
 * by its own strength each car would seem stronger by a voxel's step, and the less deeply crushed
 * one by the greater part of its strength. */
static void remember(const struct cr_moving *m, const struct cr_losses *losses,
                     const struct cr_losses *other) {
    double *more = losses->press->more, *all = losses->press->all;
    double *their_more = other->press->more, *their_all = other->press->all;
    const double *pulls = losses->press->pull;
    struct outwards o = outwards(m, losses);
    for (int i = 0; i < losses->n; i++) {
        const struct cr_loss *l = &losses->loss[i];
        int line = o.row ? l->iy : l->ix, outermost = l->voxel + crumbs_beyond(m, &o, l) * o.step;
        double unit = losses->unit[outermost], pull = pulls[line];
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

/* From both ends at once: each sum waits for its last step. */
void cr_yield_spread(const double *of, int n, double h, double *to) {
    double keep = exp(-h / yield_reach), below = 0, above = 0;
    int k = 0, j = n - 1;
    for (; k < j; k++, j--) {
        to[k] = below;
        below = keep * (below + of[k]);
        to[j] = above;
        above = keep * (above + of[j]);
    }
    if (k == j) {
        to[k] = below;
        below = keep * (below + of[k++]);
    }
    for (; j >= 0; k++, j--) {
        to[j] = of[j] + (to[j] + above);
        above = keep * (above + of[j]);
        if (k < n) {
            to[k] = of[k] + (below + to[k]);
            below = keep * (below + of[k]);
        }
    }
}

/* Share of the excess that each line of a body takes, 0..1. It does not change far from where
 * anything has been pressed on. */
static void share_lines(struct cr_solver *s, const struct cr_moving *m,
                        const struct cr_losses *mine) {
    struct cr_yield *y = &s->yield;
    const double *all = mine->press->all;
    double *lean = mine->press->lean, *share = mine->press->share, h = m->body->grid.h, total = 0;
    int far = (int)ceil(2 * yield_reach / h), n = lines_of(m, mine);
    struct cr_span lines = held(all, n);
    for (int k = lines.lo; k < lines.hi; k++) {
        total += all[k];
    }
    lines = above(all, lines, trace * total);
    if (lines.lo == lines.hi) {
        return;
    }
    lines.lo = lines.lo > far ? lines.lo - far : 0;
    lines.hi = lines.hi + far < n ? lines.hi + far : n;
    cr_yield_spread(mine->press->more + lines.lo, lines.hi - lines.lo, h, y->more + lines.lo);
    cr_yield_spread(all + lines.lo, lines.hi - lines.lo, h, y->all + lines.lo);
    for (int k = lines.lo; k < lines.hi; k++) {
        double weaker = y->more[k] / (share_band * y->all[k]);
        lean[k] = cr_clamp(lean[k] + weaker * s->dt / lean_time, -1, 1);
        share[k] = cr_clamp(0.5 * (1 + lean[k] + weaker), 0, 1);
    }
}

/* leaves of one body's losses its share; seen from both bodies, so that both shares make one */
static void keep_share(struct cr_losses *losses, const double *mine, const double *theirs) {
    bool row = by_row(losses);
    struct cr_loss *kept = losses->loss;
    for (int i = 0; i < losses->n; i++) {
        struct cr_loss *l = &losses->loss[i];
        double other = theirs[l->line] + l->next * (theirs[l->line + 1] - theirs[l->line]);
        double share = 0.5 * (mine[row ? l->iy : l->ix] + 1 - other);
        if (share > 0) {
            double amount = l->amount * share, energy = l->energy * share;
            *kept = *l;
            kept->amount = amount;
            kept->energy = energy;
            kept++;
        }
    }
    losses->n = (int)(kept - losses->loss);
}

void cr_yield_share(struct cr_solver *s, int a, int b) {
    const struct cr_moving *ma = &s->m[a], *mb = &s->m[b];
    struct cr_losses *la = &s->losses[0], *lb = &s->losses[1];
    fade(ma, la, s->t);
    fade(mb, lb, s->t);
    remember(ma, la, lb);
    remember(mb, lb, la);
    share_lines(s, ma, la);
    share_lines(s, mb, lb);
    const double *share_a = la->press->share, *share_b = lb->press->share;
    keep_share(la, share_a, share_b);
    keep_share(lb, share_b, share_a);
}

/* Makes up a loss from the n-th voxel beyond its own on inward, ending at its own, dx or dy apart;
 * the first part replaces it, further ones are added behind the others. Each keeps what its voxel
 * held in `beside`. */
static bool take_inward(struct cr_moving *m, struct cr_losses *losses, int i, int n, int dx,
                        int dy) {
    struct cr_loss *l = &losses->loss[i];
    int nx = m->body->grid.nx, own_x = l->ix, own_y = l->iy;
    double want = l->amount;
    for (; n >= 0 && want > 0; n--) {
        l->ix = own_x + n * dx;
        l->iy = own_y + n * dy;
        l->voxel = l->iy * nx + l->ix;
        double left = m->left[l->voxel], amount = cr_with_crumb(left, want);
        l->amount = amount;
        l->energy = amount * losses->unit[l->voxel];
        l->beside = left;
        m->left[l->voxel] = left - amount;
        want -= amount;
        if (n > 0 && want > 0) {
            if (!cr_losses_reserve(losses, 1)) {
                return false;
            }
            l = &losses->loss[losses->n++];
        }
    }
    return true;
}

bool cr_yield_order(struct cr_moving *m, struct cr_losses *losses) {
    struct outwards o = outwards(m, losses);
    int n = losses->n;
    for (int k = 0; k < n; k++) { /* the outer ones of a line first */
        int i = o.up ? n - 1 - k : k;
        struct cr_loss *l = &losses->loss[i];
        int crumbs = crumbs_beyond(m, &o, l);
        if (crumbs == 0) {
            l->beside = m->left[l->voxel];
            m->left[l->voxel] -= l->amount;
        } else if (!take_inward(m, losses, i, crumbs, o.dx, o.dy)) {
            return false;
        }
    }
    for (int i = 0; i < losses->n; i++) { /* nothing has changed yet */
        double *left = &m->left[losses->loss[i].voxel], before = losses->loss[i].beside;
        *left = before > *left ? before : *left;
    }
    return true;
}
