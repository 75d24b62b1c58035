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

#include <string.h>

/* Inside a contact the string leaves lines this far behind, m: less is the ripple that the
 * opponent's voxels press into them, and would be pulled to the deepest slice after slice. */
static const double ripple = 0.0125;
/* distance of an edge from a line, in lines, below which they are one */
static const double tie = 1e-6;

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
    bool row = cr_face_is_end(face);
    return (struct lines){.m = m,
                          .unit = unit,
                          .depth = m->depth[face],
                          .outline = m->outline[face],
                          .pitch = m->pitch[face],
                          .span = row ? m->row : m->col,
                          .n = cr_face_lines(g, face),
                          .row = row,
                          .next = row ? g->nx : 1,
                          .along = row ? 1 : g->nx,
                          .from_end = cr_face_from_high(face)};
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

enum cr_face cr_string_face(const struct cr_moving *m, struct cr_vec2 inward, struct cr_vec2 v) {
    struct cr_vec2 n = cr_vec2_unrotate(inward, m->c, m->s), w = cr_vec2_unrotate(v, m->c, m->s);
    double x = n.x * w.x, y = n.y * w.y, rounding = 1e-6 * (fabs(x) + fabs(y));
    if (x >= y - rounding) { /* a tie is the end's, whatever rounding says */
        return n.x < 0 ? CR_FACE_FRONT : CR_FACE_REAR;
    }
    return n.y < 0 ? CR_FACE_LEFT : CR_FACE_RIGHT;
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

/* State of some lines before the slice's pull; a line without material left nails the string, and
 * so do the lines beside the window, which are at rest. The strength q is the energy of a unit of
 * material over its depth and the width h of the line. */
static void prepare(struct cr_string *st, const struct lines *lines, struct cr_span part,
                    double tension) {
    const struct lines l = *lines;
    double per_tension = l.m->body->grid.h / tension;
    for (int i = part.lo; i <= part.hi; i++) {
        int k = surface(&l, i);
        st->surface[i] = k;
        st->bend[i] = k < 0 ? 0 : l.unit[voxel_at(&l, i, k)] / l.pitch[i] * per_tension;
        st->taut[i] = taut(&l, i);
    }
    int before = st->window.lo - 1, behind = st->window.hi + 1;
    if (before >= 0) {
        st->surface[before] = -1;
        st->bend[before] = 0;
    }
    if (behind < l.n) {
        st->surface[behind] = -1;
        st->bend[behind] = 0;
        st->taut[behind] = taut(&l, behind);
    }
}

/* the line above an edge, -1 where a line is at the edge */
static int above(double at) {
    double next = floor(at) + 1, back = next - at;
    return back > tie && back < 1 - tie ? (int)next : -1;
}

static struct cr_edge lower_edge(struct cr_range met) {
    double middle = 0.5 * (met.lo + met.hi), inner = ceil(met.lo + 0.5 - tie);
    return (struct cr_edge){met.lo, (int)(inner < middle ? inner : lround(middle)),
                            (int)floor(met.lo - 0.5 + tie), (int)floor(met.lo), above(met.lo)};
}

static struct cr_edge upper_edge(struct cr_range met) {
    double middle = 0.5 * (met.lo + met.hi), inner = floor(met.hi - 0.5 + tie);
    return (struct cr_edge){met.hi, (int)(inner > middle ? inner : lround(middle)),
                            (int)ceil(met.hi + 0.5 - tie), (int)floor(met.hi), above(met.hi)};
}

/* Depth at the edge of a contact: the surface goes on as it came from the lines inside, but not
 * deeper, which is level for a box and sloping for a pole. */
static double edge_depth(const struct lines *l, const double *depth, struct cr_edge e) {
    int i = e.inner, behind = e.outer > i ? i - 1 : i + 1, k = e.below;
    double rise = behind >= 0 && behind < l->n ? fmin(0, depth[i] - depth[behind]) : 0;
    double next = k + 1 < l->n ? depth[k + 1] : 0, here = k >= 0 ? depth[k] : next;
    return fmax(depth[i] + fabs(e.at - i) * rise, here + (e.at - k) * (next - here));
}

/* Puts a point on the stack of those that hold, from `first` on below `top`, and takes away those
 * that it relieves; level: the slope of the hull ahead of the first. Returns the new top. */
static inline struct cr_hold *hold(struct cr_hold *first, struct cr_hold *top, double line,
                                   double over, double level) {
    double ahead = level;
    while (top > first) {
        const struct cr_hold *last = top - 1;
        ahead = (over - last->over) / (line - last->line);
        if (ahead < last->slope) {
            break;
        }
        ahead = level;
        top--;
    }
    top->line = line;
    top->over = over;
    top->slope = ahead;
    return top + 1;
}

/* The places that hold a piece of the string, into st->held, each with the slope of the hull ahead
 * of it; returns the end of them. Puts the bow of the piece into st->w, and its slope behind the
 * last line into slope. */
static const struct cr_hold *hull(struct cr_string *st, const struct lines *l, struct cr_span piece,
                                  double *slope) {
    /* ahead of a line that hangs free the hull is level */
    double level = st->surface[piece.lo] < 0 ? (double)INFINITY : 0, bow = 0, bow_slope = 0;
    const double *depth = l->depth, *bend = st->bend;
    struct cr_hold *first = st->held, *top = first;
    int lower = st->edge[0].above, upper = st->edge[1].above;
    for (int i = piece.lo; i <= piece.hi; i++) {
        for (int k = 0; (i == lower || i == upper) && i > piece.lo && k < 2; k++) {
            const struct cr_edge *e = &st->edge[k];
            if (i == e->above) {
                double over = edge_depth(l, depth, *e) - (bow - (i - e->at) * bow_slope);
                top = hold(first, top, e->at, over, level);
            }
        }
        top = hold(first, top, i, depth[i] - bow, level);
        st->w[i] = bow;
        bow_slope += bend[i];
        bow += bow_slope;
    }
    /* a string that hangs free leaves its last line level */
    while (st->surface[piece.hi] >= 0 && top > first + 1 && top[-1].slope < -bow_slope) {
        top--;
    }
    *slope = bow_slope;
    return top;
}

/* depths of a piece of the string whose segments are all taut, both end lines included */
static void settle(struct cr_string *st, const struct lines *l, struct cr_span piece) {
    double slope, *w = st->w;
    const struct cr_hold *top = hull(st, l, piece, &slope);
    int i = piece.lo;
    for (const struct cr_hold *at = st->held; at < top; at++) {
        for (; i < at->line; i++) {
            w[i] += at->over - at->slope * (at->line - i);
        }
        if (i == at->line) {
            w[i] = l->depth[i];
            i++;
        }
    }
    for (; i <= piece.hi; i++) {
        w[i] += top[-1].over - slope * (i - top[-1].line);
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
        settle(st, l, (struct cr_span){from, to});
        bool nail = to > from && st->surface[to] < 0; /* it begins the next piece too */
        from = nail ? to : to + 1;
    }
}

/* less than this is rounding, m */
static const double slight = 1e-12;

static bool moved(const struct cr_string *st, const struct lines *l, int i) {
    return st->w[i] > l->depth[i] + slight;
}

/* Depths w of the string in all lines that it may move: those pressed on or dented and two on
 * either side, more while the outermost move. */
static void relax(struct cr_string *st, const struct lines *l, struct cr_span dented,
                  double tension) {
    int end = l->n - 1;
    struct cr_span *window = &st->window;
    int first = (int)fmin(floor(st->met.lo), dented.lo);
    int last = (int)fmax(ceil(st->met.hi), dented.hi);
    *window = (struct cr_span){first > 2 ? first - 2 : 0, last + 2 < end ? last + 2 : end};
    prepare(st, l, *window, tension);
    for (bool lo = true, hi = true; lo || hi;) {
        settle_window(st, l);
        lo = window->lo > 0 && moved(st, l, window->lo);
        hi = window->hi < end && moved(st, l, window->hi);
        window->lo -= lo;
        window->hi += hi;
        if (lo) {
            prepare(st, l, (struct cr_span){window->lo, window->lo}, tension);
        }
        if (hi) {
            prepare(st, l, (struct cr_span){window->hi, window->hi}, tension);
        }
    }
}

/* Take the material between the old and the new depth of a line, within its surface voxel: the next
 * one has another strength, and the next slice will know it. */
static void take(struct cr_string *st, const struct lines *l, int line, struct cr_losses *losses) {
    int along = st->surface[line], k = voxel_at(l, line, along);
    double depth = l->depth[line], pitch = l->pitch[line];
    double slack = line > st->met.lo && line < st->met.hi ? ripple : 0;
    double deeper = st->w[line] - depth - slack, left = l->m->left[k];
    double amount = cr_with_crumb(left, deeper > 0 ? deeper / pitch : 0);
    st->w[line] = depth + amount * pitch;
    struct cr_loss *loss = &losses->loss[losses->n++];
    loss->voxel = k;
    loss->ix = l->row ? along : line;
    loss->iy = l->row ? line : along;
    loss->amount = amount;
    loss->energy = amount * l->unit[k];
    losses->energy += loss->energy;
}

/* of the segments in the window; those beyond are as they were made */
static double membrane_energy(const struct cr_string *st, const struct lines *l, double tension) {
    double sum = 0;
    for (int i = st->window.lo + 1; i <= st->window.hi; i++) {
        double d = st->w[i] - st->w[i - 1];
        sum += st->taut[i] ? d * d : 0;
    }
    for (int k = 0; k < 2; k++) { /* around an edge the string bends there */
        const struct cr_edge *e = &st->edge[k];
        int lo = e->inner < e->outer ? e->inner : e->outer, hi = e->inner + e->outer - lo;
        if (lo < st->window.lo || hi > st->window.hi || !st->taut[lo + 1] || !st->taut[hi]) {
            continue;
        }
        double at = edge_depth(l, st->w, *e), in = st->w[e->inner] - at, out = at - st->w[e->outer];
        for (int i = lo + 1; i <= hi; i++) {
            double d = st->w[i] - st->w[i - 1];
            sum -= d * d;
        }
        sum += in * in / fabs(e->at - e->inner) + out * out / fabs(e->outer - e->at);
    }
    return 0.5 * tension * sum / l->m->body->grid.h;
}

/* Slope with which the string leaves the contact outwards at an edge, m a line: the mean over the
 * next line and half of what it bends there. */
static double slope_outside(const struct cr_string *st, const struct lines *l, struct cr_edge e) {
    double sign = e.outer > e.inner ? 1 : -1, far = e.at + sign;
    int k = (int)floor(far);
    if (k < 0 || k + 1 >= l->n || !st->taut[k + 1]) {
        return 0;
    }
    double there = st->w[k] + (far - k) * (st->w[k + 1] - st->w[k]);
    double mean = fmax(0, edge_depth(l, st->w, e) - there);
    return mean + fmin(mean, 0.5 * st->bend[e.outer > e.inner ? k : k + 1]);
}

/* depth that the string gains from line i to line j beside it, 0 where slack */
static double gain(const struct cr_string *st, int i, int j) {
    return st->taut[i > j ? i : j] ? st->w[i] - st->w[j] : 0;
}

/* Part of a line that lies within the contact, 0..1; a contact narrower than a line has only one.
 */
static double met_part(const struct cr_string *st, int line) {
    return fmin(line + 0.5, st->met.hi) - fmax(line - 0.5, st->met.lo);
}

/* What the string resists with on each line that is met, per unit of material. The force of each
 * line is spread over the reach of strength, because the kinks of single lines are chance. */
static void note_pull(struct cr_string *st, const struct lines *l, double tension, double *pull) {
    double h = l->m->body->grid.h, *at = st->spread;
    int first = (int)ceil(st->met.lo), last = (int)floor(st->met.hi);
    first = first > last ? (int)lround(0.5 * (st->met.lo + st->met.hi)) : first;
    last = first > last ? first : last;
    int n = last - first + 1;
    memset(pull + st->window.lo, 0, (size_t)(st->window.hi + 1 - st->window.lo) * sizeof *pull);
    for (int i = first; i <= last; i++) {
        at[i - first] = met_part(st, i);
    }
    cr_yield_spread(at, n, h, pull + first); /* how much of the contact each line spreads over */
    for (int i = first; i <= last; i++) {
        double slopes = i == first ? slope_outside(st, l, st->edge[0]) : gain(st, i, i - 1);
        slopes += i == last ? slope_outside(st, l, st->edge[1]) : gain(st, i, i + 1);
        at[i - first] = slopes / pull[i];
    }
    cr_yield_spread(at, n, h, pull + first);
    for (int i = first; i <= last; i++) {
        pull[i] *= tension / h * l->pitch[i];
    }
}

bool cr_string_pull(struct cr_solver *s, struct cr_moving *m, int partner,
                    struct cr_losses *losses) {
    const struct cr_grid *g = &m->body->grid;
    enum cr_face face = losses->face;
    double tension = g->nx > 0 ? m->tension[partner][face] : 0;
    if (losses->n == 0 || !(tension > 0) || m->dented[face].hi < 0) {
        return true;
    }
    struct lines l = lines_of(m, m->unit[partner], face);
    struct cr_string *st = &s->string;
    st->met = losses->met;
    st->edge[0] = lower_edge(st->met);
    st->edge[1] = upper_edge(st->met);
    relax(st, &l, m->dented[face], tension);
    double before = losses->energy;
    if (!cr_losses_reserve(losses, st->window.hi - st->window.lo + 1)) {
        return false;
    }
    for (int i = st->window.lo; i <= st->window.hi; i++) {
        if (moved(st, &l, i)) {
            take(st, &l, i, losses);
        }
    }
    double stretched = membrane_energy(st, &l, tension);
    note_pull(st, &l, tension, losses->press->pull);
    losses->stretch = fmax(0, stretched - m->membrane[face]);
    losses->induced = losses->energy - before + losses->stretch;
    losses->energy += losses->stretch;
    cr_deform_apply(m, losses, losses->contact);
    return true;
}
