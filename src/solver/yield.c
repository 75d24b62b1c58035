/* Step 1, continued: which of two crushing bodies gives way.
 *
 * The weaker of the two does (paper, assumption from Lin et al. 1975): two structures that press on
 * each other stand in series, and the one whose contact as a whole, with all that it drags along,
 * resists with the smaller force is crushed until it resists with as much as the other. */
#include "solver/solver_priv.h"

/* Structures are the stronger the faster they are crushed, as the power c of the speed: 1.1 to 1.3
 * times at 15 m/s (contact of the design, section 3). With F v^c on both sides the split of an
 * approach is v_A / v_B = (F_B / F_A)^(1/c): the weaker takes nearly all of it, equal ones half
 * each, and nothing jumps where strengths cross. */
static const double rate_exponent = 0.05;

/* The way outwards along the lines of the struck face. */
struct outwards {
    bool row, up;
    int dx, dy, step; /* to the next voxel outwards, in voxels and in the grid's order */
    int end;          /* voxels of a line */
};

static struct outwards outwards(const struct cr_moving *m, const struct cr_losses *losses) {
    const struct cr_grid *g = &m->body->grid;
    bool row = cr_face_is_end(losses->face), up = cr_face_from_high(losses->face);
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

/* Energy per unit of material in the contact if this body alone gives way, what it drags along
 * included, J. A voxel is as strong as what gives way for it. */
static double strength(struct cr_solver *s, const struct cr_moving *m,
                       const struct cr_losses *losses) {
    struct outwards o = outwards(m, losses);
    double energy = 0, amount = 0;
    for (int i = 0; i < losses->n; i++) {
        const struct cr_loss *l = &losses->loss[i];
        energy += l->amount * losses->unit[l->voxel + crumbs_beyond(m, &o, l) * o.step];
        amount += l->amount;
    }
    return amount > 0 ? (energy + cr_drag_energy(s, m, losses)) / amount : (double)INFINITY;
}

void cr_yield_share(struct cr_solver *s, int a, int b) {
    struct cr_losses *la = &s->losses[0], *lb = &s->losses[1];
    double sa = strength(s, &s->m[a], la), sb = strength(s, &s->m[b], lb);
    double share = !isfinite(sa)   ? 0
                   : !isfinite(sb) ? 1
                                   : 1 / (1 + pow(sa / sb, 1 / rate_exponent));
    la->normal = cr_vec2_scale(la->normal, share);
    lb->normal = cr_vec2_scale(lb->normal, 1 - share);
    cr_deform_scale(la, share);
    cr_deform_scale(lb, 1 - share);
    la->n = share > 0 ? la->n : 0;
    lb->n = share < 1 ? lb->n : 0;
}
/* Makes up a loss from the n-th voxel beyond its own on inward, ending at its own, dx or dy apart;
 * the first part replaces it, further ones are added behind the others. Each keeps what its voxel
 * held in `before`. */
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
        l->before = left;
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
            l->before = m->left[l->voxel];
            m->left[l->voxel] -= l->amount;
        } else if (!take_inward(m, losses, i, crumbs, o.dx, o.dy)) {
            return false;
        }
    }
    for (int i = 0; i < losses->n; i++) { /* nothing has changed yet */
        double *left = &m->left[losses->loss[i].voxel], before = losses->loss[i].before;
        *left = before > *left ? before : *left;
    }
    return true;
}
