/* Induced deformation: a struck face drags along what lies beside the contact.
 *
 * The depth w of neighbouring lines of a face falls by no more than the slope k beside the contact:
 *     w[i] >= w[j] - k |y[i] - y[j]|.
 * The least such depths are found exactly by a pass up and a pass down the lines. What is dragged
 * in is material like any other, and costs what its voxels hold; the force of it acts in the
 * contact. */
#include "solver/solver_priv.h"

#include <string.h>

/* The beam of an end and what stands on it hangs together between its rails: up to this share of
 * the half width; beyond, wing and wheel house are dragged along less, by this slope: frontal poles
 * against the edge of a barrier with 25 % overlap. */
static const double rails = 0.43, beyond_rails = 3;

/* Lines of one face: line i runs inward from the outline. */
struct lines {
    const struct cr_moving *m;
    const double *unit;
    const double *depth, *outline, *pitch; /* of the face */
    const struct cr_span *span;
    double drop;        /* by which the depth may fall from line to line, m */
    double drop_beyond; /* and beyond the rails of an end */
    double slant;       /* by which the surface of the contact recedes from line to line, m */
    int n;
    bool row;      /* lines are rows of the grid, else columns */
    int next;      /* from a voxel to its neighbour in the next line */
    int along;     /* to the next voxel of the line */
    bool from_end; /* inward is towards lower indices */
};

static struct lines lines_of(const struct cr_moving *m, const struct cr_losses *losses) {
    const struct cr_grid *g = &m->body->grid;
    enum cr_face face = losses->face;
    bool row = cr_face_is_end(face);
    return (struct lines){.m = m,
                          .unit = losses->unit,
                          .depth = m->depth[face],
                          .outline = m->outline[face],
                          .pitch = m->pitch[face],
                          .span = row ? m->row : m->col,
                          .drop = g->drag_slope[face] * g->h,
                          .drop_beyond = fmax(g->drag_slope[face], row ? beyond_rails : 0) * g->h,
                          .slant = losses->slant * g->h,
                          .n = cr_face_lines(g, face),
                          .row = row,
                          .next = row ? g->nx : 1,
                          .along = row ? 1 : g->nx,
                          .from_end = cr_face_from_high(face)};
}

enum cr_face cr_struck_face(const struct cr_moving *m, struct cr_vec2 inward, struct cr_vec2 v) {
    struct cr_vec2 n = cr_vec2_unrotate(inward, m->c, m->s), w = cr_vec2_unrotate(v, m->c, m->s);
    double x = n.x * w.x, y = n.y * w.y, rounding = 1e-6 * (fabs(x) + fabs(y));
    if (x >= y - rounding) { /* a tie is the end's, whatever rounding says */
        return n.x < 0 ? CR_FACE_FRONT : CR_FACE_REAR;
    }
    return n.y < 0 ? CR_FACE_LEFT : CR_FACE_RIGHT;
}

static const double steepest = 10;

void cr_losses_turn(const struct cr_moving *m, struct cr_losses *losses, struct cr_vec2 inward,
                    struct cr_vec2 v) {
    struct cr_vec2 n = cr_vec2_unrotate(inward, m->c, m->s);
    losses->face = cr_struck_face(m, inward, v);
    bool end = cr_face_is_end(losses->face);
    double into = fabs(end ? n.x : n.y), along = end ? n.y : n.x;
    losses->slant = cr_clamp(along / fmax(into, 1e-6), -steepest, steepest);
}

/* place along a line of its first voxel from outside that still has material, -1 if none has */
static inline int surface(const struct lines *l, int line) {
    const double *left = l->m->left + line * l->next;
    struct cr_span live = l->span[line];
    if (l->from_end) {
        while (live.lo < live.hi && left[(live.hi - 1) * l->along] <= 0) {
            live.hi--;
        }
        return live.lo < live.hi ? live.hi - 1 : -1;
    }
    while (live.lo < live.hi && left[live.lo * l->along] <= 0) {
        live.lo++;
    }
    return live.lo < live.hi ? live.lo : -1;
}

static inline bool beyond(const struct lines *l, int line) {
    return fabs(line - 0.5 * (l->n - 1)) > 0.5 * rails * l->n;
}

/* A line is dragged along by line `by` beside it. An outline that recedes leaves it behind: a wall
 * that flattens a rounded end drags nothing. */
static inline void drag(struct cr_drag *d, const struct lines *l, int line, int by) {
    double back = l->outline[line] - l->outline[by], away = (line - by) * l->slant;
    double drop = beyond(l, line) && beyond(l, by) ? l->drop_beyond : l->drop;
    double w = d->w[by] - drop - (back > 0 ? back : 0) - (away > 0 ? away : 0);
    if (w > d->w[line]) {
        d->w[line] = w;
    }
}

/* least depths w of all lines that no slope is too steep for */
static void settle(struct cr_drag *d, const struct lines *l) {
    for (int i = 1; i < l->n; i++) {
        drag(d, l, i, i - 1);
    }
    for (int i = l->n - 2; i >= 0; i--) {
        drag(d, l, i, i + 1);
    }
}

static bool drags(const struct cr_solver *s, const struct cr_moving *m,
                  const struct cr_losses *losses) {
    return s->cs->opts.induced && losses->n > 0 && m->body->grid.nx > 0 &&
           m->body->grid.drag_slope[losses->face] > 0;
}

double cr_drag_energy(struct cr_solver *s, const struct cr_moving *m,
                      const struct cr_losses *losses) {
    if (!drags(s, m, losses)) {
        return 0;
    }
    struct lines l = lines_of(m, losses);
    struct cr_drag *d = &s->drag;
    double sum = 0;
    memcpy(d->w, l.depth, (size_t)l.n * sizeof *d->w);
    for (int i = 0; i < losses->n; i++) {
        int line = l.row ? losses->loss[i].iy : losses->loss[i].ix;
        d->w[line] += losses->loss[i].amount * l.pitch[line];
    }
    memcpy(d->own, d->w, (size_t)l.n * sizeof *d->own);
    settle(d, &l);
    for (int i = 0; i < l.n; i++) {
        if (d->w[i] > d->own[i]) {
            int k = surface(&l, i);
            sum +=
                k < 0 ? 0 : (d->w[i] - d->own[i]) / l.pitch[i] * l.unit[i * l.next + k * l.along];
        }
    }
    return sum;
}

/* Takes `deeper` m out of a line, from its surface inward; false when memory is out. */
static bool take(const struct lines *l, int line, double deeper, struct cr_losses *losses) {
    double want = deeper / l->pitch[line];
    struct cr_span live = l->span[line];
    int k = surface(l, line), step = l->from_end ? -1 : 1;
    for (; k >= live.lo && k < live.hi && want > cr_crumb; k += step) {
        int voxel = line * l->next + k * l->along;
        double left = l->m->left[voxel], amount = cr_with_crumb(left, want);
        if (left <= 0) {
            continue;
        }
        if (!cr_losses_reserve(losses, 1)) {
            return false;
        }
        struct cr_loss *loss = &losses->loss[losses->n++];
        loss->voxel = voxel;
        loss->ix = l->row ? k : line;
        loss->iy = l->row ? line : k;
        loss->amount = amount;
        loss->energy = amount * l->unit[voxel];
        losses->energy += loss->energy;
        want -= amount;
    }
    return true;
}

bool cr_drag_along(struct cr_solver *s, struct cr_moving *m, struct cr_losses *losses,
                   double most) {
    if (!drags(s, m, losses)) {
        return true;
    }
    struct lines l = lines_of(m, losses);
    struct cr_drag *d = &s->drag;
    double before = losses->energy;
    memcpy(d->w, l.depth, (size_t)l.n * sizeof *d->w);
    settle(d, &l);
    for (int i = 0; i < l.n; i++) {
        double deeper = fmin(d->w[i] - l.depth[i], most);
        if (deeper > 0 && !take(&l, i, deeper, losses)) {
            return false;
        }
    }
    losses->induced = losses->energy - before;
    cr_deform_apply(m, losses, losses->contact);
    return true;
}
