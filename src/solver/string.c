/* Induced deformation: a plastic string on the voxels of the struck face (method.md 5).
 *
 * Neighbouring lines of depth w are tied by the tension N0; outside the contact
 *     N0 (w[i-1] - 2 w[i] + w[i+1]) / h = h q_i,   w never decreasing,
 * where the string is stretched, with q the strength of the voxel at the surface (J/m2 = N/m). What
 * the string pulls in is foundation energy, what it is stretched by is membrane energy, both
 * plastic.
 *
 * With the bow p that obeys p[i-1] - 2 p[i] + p[i+1] = r_i = h^2 q_i / N0, w - p is straight where
 * the string moves lines and bends back at lines that hold it: it is the least concave function
 * above depth - p, an upper hull, found exactly in one pass (monotone chain, Andrew 1979). */
#include "solver/solver_priv.h"

/* Lines of one face: line i runs inward from the outline. */
struct lines {
    const struct cr_moving *m;
    const double *unit;
    const double *depth, *outline, *pitch; /* of the face */
    const struct cr_span *span;
    int n;
    bool row;      /* lines are rows of the grid, else columns */
    int next;      /* from a voxel to its neighbour in the next line */
    int along;     /* to the next voxel of the line */
    bool from_end; /* inward is towards lower indices */
};

static struct lines lines_of(const struct cr_moving *m, const double *unit, enum cr_face face) {
    const struct cr_grid *g = &m->body->grid;
    bool row = face == CR_FACE_FRONT || face == CR_FACE_REAR;
    return (struct lines){.m = m,
                          .unit = unit,
                          .depth = m->depth[face],
                          .outline = m->outline[face],
                          .pitch = m->pitch[face],
                          .span = row ? m->row : m->col,
                          .n = row ? g->ny : g->nx,
                          .row = row,
                          .next = row ? g->nx : 1,
                          .along = row ? 1 : g->nx,
                          .from_end = face == CR_FACE_FRONT || face == CR_FACE_LEFT};
}

static int voxel_at(const struct lines *l, int line, int along) {
    return line * l->next + along * l->along;
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

static enum cr_face struck_face(const struct cr_moving *m, struct cr_vec2 inward) {
    struct cr_vec2 d = cr_vec2_unrotate(inward, m->c, m->s);
    if (fabs(d.x) >= fabs(d.y)) {
        return d.x < 0 ? CR_FACE_FRONT : CR_FACE_REAR;
    }
    return d.y < 0 ? CR_FACE_LEFT : CR_FACE_RIGHT;
}

/* A segment, between lines i - 1 and i, is taut where the crush has stretched it beyond its
 * undeformed length: a wall that flattens a rounded end leaves it slack. The ends of a face hang
 * free. */
static inline bool taut(const struct lines *l, int i) {
    if (i == 0 || i == l->n) {
        return false;
    }
    double rest = l->outline[i] - l->outline[i - 1], moved = l->depth[i] - l->depth[i - 1];
    return fabs(rest + moved) >= fabs(rest);
}

/* State of line i before the slice's pull: a line without material left nails the string. The
 * strength q is the energy of a unit of material over its depth and the width h of the line. */
static inline void prepare_line(struct cr_string *st, const struct lines *l, int i,
                                double per_tension) {
    int k = surface(l, i);
    st->surface[i] = k;
    st->bend[i] = k < 0 ? 0 : l->unit[voxel_at(l, i, k)] / l->pitch[i] * per_tension;
    st->taut[i] = taut(l, i);
}

/* the lines beside the window are at rest: there the string is nailed too */
static void prepare_ends(struct cr_string *st, const struct lines *l) {
    int lo = st->window.lo - 1, hi = st->window.hi + 1;
    if (lo >= 0) {
        st->surface[lo] = -1;
        st->bend[lo] = 0;
    }
    if (hi < l->n) {
        st->surface[hi] = -1;
        st->bend[hi] = 0;
        st->taut[hi] = taut(l, hi);
    }
}

/* the lines that the string may move: those with a dent and one on either side */
static void prepare(struct cr_string *st, const struct lines *l, struct cr_span dented,
                    double per_tension) {
    st->window.lo = dented.lo > 0 ? dented.lo - 1 : 0;
    st->window.hi = dented.hi + 1 < l->n ? dented.hi + 1 : dented.hi;
    for (int i = st->window.lo; i <= st->window.hi; i++) {
        prepare_line(st, l, i, per_tension);
    }
    prepare_ends(st, l);
}

/* Whether the last of n held lines lies below the hull once line i is on it. Ahead of a first line
 * that hangs free the hull is level. */
static bool below(const struct cr_string *st, int n, bool nailed, int i) {
    int q = st->held[n - 1];
    double rise = st->over[i] - st->over[q];
    if (n == 1) {
        return !nailed && rise >= 0;
    }
    int p = st->held[n - 2];
    return rise * (q - p) >= (st->over[q] - st->over[p]) * (i - q);
}

/* Lines of a piece that hold the string, into st->held; returns how many. Puts the bow of the
 * piece into st->w, and its slope behind the last line into slope. */
static int hull(struct cr_string *st, const double *depth, struct cr_span piece, double *slope) {
    bool nailed = st->surface[piece.lo] < 0;
    double bow = 0;
    int n = 0;
    *slope = 0;
    for (int i = piece.lo; i <= piece.hi; i++) {
        st->w[i] = bow;
        st->over[i] = depth[i] - bow;
        while (n > 0 && below(st, n, nailed, i)) {
            n--;
        }
        st->held[n++] = i;
        *slope += st->bend[i];
        bow += *slope;
    }
    /* a string that hangs free leaves its last line level */
    for (; st->surface[piece.hi] >= 0 && n > 1; n--) {
        int p = st->held[n - 2], q = st->held[n - 1];
        if (st->over[q] - st->over[p] >= -*slope * (q - p)) {
            break;
        }
    }
    return n;
}

/* depths of a piece of the string whose segments are all taut, both end lines included */
static void settle(struct cr_string *st, const double *depth, struct cr_span piece) {
    double slope;
    int n = hull(st, depth, piece, &slope), before = piece.lo - 1;
    for (int j = 0; j < n; j++) {
        int at = st->held[j];
        double rise = j == 0 ? 0 : (st->over[at] - st->over[before]) / (at - before);
        for (int i = before + 1; i < at; i++) {
            st->w[i] += st->over[at] - rise * (at - i);
        }
        st->w[at] = depth[at];
        before = at;
    }
    for (int i = before + 1; i <= piece.hi; i++) {
        st->w[i] += st->over[before] - slope * (i - before);
    }
}

/* piece by piece, from one nail or slack segment to the next */
static void settle_window(struct cr_string *st, const struct lines *l) {
    int first = st->window.lo > 0 ? st->window.lo - 1 : 0;
    int last = st->window.hi + 1 < l->n ? st->window.hi + 1 : st->window.hi;
    for (int from = first; from <= last;) {
        int to = from;
        while (to < last && st->taut[to + 1] && (to == from || st->surface[to] >= 0)) {
            to++;
        }
        settle(st, l->depth, (struct cr_span){from, to});
        bool nail = to > from && st->surface[to] < 0; /* it begins the next piece too */
        from = nail ? to : to + 1;
    }
}

/* less than this is rounding, m */
static const double slight = 1e-12;

static bool moved(const struct cr_string *st, const struct lines *l, int i) {
    return st->w[i] > l->depth[i] + slight;
}

/* Depths w of the string in all lines of the window, which grows until its ends are at rest. */
static void relax(struct cr_string *st, const struct lines *l, double per_tension) {
    struct cr_span *window = &st->window;
    for (bool lo = true, hi = true; lo || hi;) {
        settle_window(st, l);
        lo = window->lo > 0 && moved(st, l, window->lo);
        hi = window->hi + 1 < l->n && moved(st, l, window->hi);
        if (lo) {
            prepare_line(st, l, --window->lo, per_tension);
        }
        if (hi) {
            prepare_line(st, l, ++window->hi, per_tension);
        }
        prepare_ends(st, l);
    }
}

/* Take the material between the old and the new depth of a line, within its surface voxel: the next
 * one has another strength, and the next slice will know it. */
static bool take(struct cr_string *st, const struct lines *l, int line, struct cr_losses *losses) {
    const struct cr_grid *g = &l->m->body->grid;
    int along = st->surface[line], k = voxel_at(l, line, along);
    double depth = l->depth[line], pitch = l->pitch[line];
    double want = (st->w[line] - depth) / pitch, left = l->m->left[k];
    double amount = want < left ? want : left;
    st->w[line] = depth + amount * pitch;
    return cr_deform_add(losses, g, l->row ? along : line, l->row ? line : along, amount,
                         amount * l->unit[k]);
}

/* of the segments in the window; those beyond are as they were made */
static double membrane_energy(const struct cr_string *st, double tension, double h) {
    double sum = 0;
    for (int i = st->window.lo + 1; i <= st->window.hi; i++) {
        double d = st->w[i] - st->w[i - 1];
        sum += st->taut[i] ? d * d : 0;
    }
    return 0.5 * tension * sum / h;
}

bool cr_string_pull(struct cr_solver *s, struct cr_moving *m, int partner, struct cr_vec2 inward,
                    struct cr_losses *losses) {
    const struct cr_grid *g = &m->body->grid;
    enum cr_face face = struck_face(m, inward);
    losses->face = face;
    double tension = g->nx > 0 ? g->tension[face] : 0;
    if (losses->n == 0 || !(tension > 0) || m->dented[face].hi < 0) {
        return true;
    }
    struct lines l = lines_of(m, m->unit[partner], face);
    struct cr_string *st = &s->string;
    double per_tension = g->h / tension;
    prepare(st, &l, m->dented[face], per_tension);
    relax(st, &l, per_tension);
    double before = losses->energy;
    for (int i = st->window.lo; i <= st->window.hi; i++) {
        if (moved(st, &l, i) && !take(st, &l, i, losses)) {
            return false;
        }
    }
    double stretched = membrane_energy(st, tension, g->h);
    losses->stretch = fmax(0, stretched - m->membrane[face]);
    losses->induced = losses->energy - before + losses->stretch;
    losses->energy += losses->stretch;
    cr_deform_apply(m, losses, losses->contact);
    return true;
}
