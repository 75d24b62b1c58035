/* Which voxels of a body its opponent can meet: the rows that the opponent's box covers, and of
 * each row the part that lies near material the opponent still has. */
#include "solver/solver_priv.h"

/* Slopes smaller than this are taken for it: over the longest row that moves nothing by as much as
 * rounding does, and the reciprocal stays finite. */
static const double slope_min = 1e-13;

static double reciprocal(double slope) {
    return 1 / (fabs(slope) < slope_min ? copysign(slope_min, slope) : slope);
}

static struct cr_map map_between(const struct cr_moving *me, const struct cr_moving *other) {
    const struct cr_grid *g = &me->body->grid, *og = &other->body->grid;
    double c = me->c * other->c + me->s * other->s, s = me->s * other->c - me->c * other->s;
    struct cr_vec2 first = {g->x0 + 0.5 * g->h, g->y0 + 0.5 * g->h};
    struct cr_vec2 p = cr_vec2_add(cr_to_body(other, me->pos), cr_vec2_rotate(first, c, s));
    bool rigid = og->nx == 0;
    double per = rigid ? 1 : 1 / og->h, r = g->h * per;
    return (struct cr_map){.u = rigid ? p.x : (p.x - og->x0) * per - 0.5,
                           .v = rigid ? p.y : (p.y - og->y0) * per - 0.5,
                           .c = c * r,
                           .s = s * r};
}

/* drop empty lines at both ends */
static struct cr_span trimmed(struct cr_span lines, const struct cr_span *line) {
    while (lines.lo < lines.hi && line[lines.lo].lo >= line[lines.lo].hi) {
        lines.lo++;
    }
    while (lines.lo < lines.hi && line[lines.hi - 1].lo >= line[lines.hi - 1].hi) {
        lines.hi--;
    }
    return lines;
}

/* Box of what can be met of the opponent, in the map's units: a place takes part in the voxels
 * whose centres are within one edge of it; a shape fills voxels whose centres are outside it. */
static void box_of(struct cr_moving *o, double h, struct cr_vec2 *lo, struct cr_vec2 *hi) {
    if (o->row == NULL) {
        *lo = cr_vec2(o->lo.x - h, o->lo.y - h);
        *hi = cr_vec2(o->hi.x + h, o->hi.y + h);
        return;
    }
    o->rows = trimmed(o->rows, o->row);
    o->cols = trimmed(o->cols, o->col);
    *lo = cr_vec2(o->cols.lo - 1, o->rows.lo - 1);
    *hi = cr_vec2(o->cols.hi, o->rows.hi);
}

static struct cr_course course(double at, double per_row, double slope, double lo, double hi) {
    double per_slope = reciprocal(slope);
    bool rises = per_slope > 0;
    return (struct cr_course){at, per_row, slope, per_slope, rises ? lo : hi, rises ? hi : lo};
}

void cr_reach_begin(struct cr_reach *r, struct cr_moving *me, struct cr_moving *other) {
    struct cr_map map = map_between(me, other);
    struct cr_vec2 lo, hi;
    box_of(other, me->body->grid.h, &lo, &hi);
    /* row of each corner of the box: the map is a rotation and a scale, so its inverse is short */
    double det = map.c * map.c + map.s * map.s, low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 4; i++) {
        double u = (i & 1 ? hi.x : lo.x) - map.u, v = (i & 2 ? hi.y : lo.y) - map.v;
        double row = (map.c * v - map.s * u) / det;
        low = row < low ? row : low;
        high = row > high ? row : high;
    }
    me->rows = trimmed(me->rows, me->row);
    r->map = map;
    r->me = me;
    r->other = other;
    r->rows.lo = (int)cr_clamp(ceil(low), me->rows.lo, me->rows.hi);
    r->rows.hi = (int)cr_clamp(floor(high) + 1, me->rows.lo, me->rows.hi);
    struct cr_course u = course(map.u, -map.s, map.c, lo.x, hi.x);
    struct cr_course v = course(map.v, map.c, map.s, lo.y, hi.y);
    bool aligned = fabs(map.c) >= fabs(map.s);
    r->along = aligned ? u : v;
    r->across = aligned ? v : u;
    r->between = aligned ? other->between_rows : other->between_cols;
}

/* Where, from x on upwards (way 1) or downwards (-1), a row comes near material: between two lines
 * of the opponent its course along them must come into the range there. May be beyond `to`, the end
 * of the row. */
static inline double first_met(const struct cr_reach *r, double along, double across, double x,
                               double to, int way) {
    double slope = r->along.slope, per_line = r->across.per_slope;
    int k = (int)(across + r->across.slope * x + 2); /* of lines k - 2 and k - 1: places are > -2 */
    double here = along + slope * x;
    const struct cr_range *near = &r->between[k];
    if (here >= near->lo && here <= near->hi) {
        return x;
    }
    int next = way * per_line > 0 ? 1 : -1; /* of the opponent's lines */
    double end = (k - 2 + (next > 0) - across) * per_line, there = along + slope * end;
    double step = way * fabs(per_line), rise = slope * step;
    while ((rise > 0 ? there < near->lo || here > near->hi : here < near->lo || there > near->hi) &&
           way * x <= way * to) {
        x = end;
        here = there;
        end += step;
        there += rise;
        near += next;
    }
    if (way * x > way * to || (here >= near->lo && here <= near->hi)) {
        return x;
    }
    return ((here < near->lo ? near->lo : near->hi) - along) * r->along.per_slope;
}

/* narrow a part to the x at which a course is within its bounds */
static inline void clip(double *lo, double *hi, double at, const struct cr_course *c) {
    double first = (c->first - at) * c->per_slope, last = (c->last - at) * c->per_slope;
    *lo = first > *lo ? first : *lo;
    *hi = last < *hi ? last : *hi;
}

static inline struct cr_span reach_row(const struct cr_reach *r, struct cr_span row, int iy) {
    struct cr_span none = {0, 0};
    double lo = row.lo, hi = row.hi - 1; /* voxels from the row's first one */
    double along = r->along.at + r->along.per_row * iy;
    double across = r->across.at + r->across.per_row * iy;
    clip(&lo, &hi, along, &r->along);
    clip(&lo, &hi, across, &r->across);
    if (lo <= hi && r->between != NULL) {
        lo = first_met(r, along, across, lo, hi, 1);
        hi = lo <= hi ? first_met(r, along, across, hi, lo, -1) : hi;
    }
    if (!(lo <= hi)) {
        return none;
    }
    int first = (int)lo;
    return (struct cr_span){first + (first < lo), (int)hi + 1};
}

int cr_reach_rows(const struct cr_reach *reach, struct cr_span *met) {
    const struct cr_reach r = *reach;
    int voxels = 0;
    for (int iy = r.rows.lo; iy < r.rows.hi; iy++) {
        struct cr_span span = reach_row(&r, r.me->row[iy], iy);
        met[iy] = span;
        voxels += span.hi > span.lo ? span.hi - span.lo : 0;
    }
    return voxels;
}

/* of lines k and k + 1: a place takes part in voxels within one edge of it */
static struct cr_range near_lines(const struct cr_span *line, int n, int k) {
    struct cr_range near = {INFINITY, -INFINITY};
    for (int i = k; i <= k + 1; i++) {
        if (i >= 0 && i < n && line[i].lo < line[i].hi) {
            near.lo = line[i].lo - 1 < near.lo ? line[i].lo - 1 : near.lo;
            near.hi = line[i].hi > near.hi ? line[i].hi : near.hi;
        }
    }
    return near;
}

void cr_reach_renew(struct cr_moving *m, bool row, int line) {
    const struct cr_grid *g = &m->body->grid;
    struct cr_range *between = row ? m->between_rows : m->between_cols;
    const struct cr_span *live = row ? m->row : m->col;
    int n = row ? g->ny : g->nx;
    between[line + 1] = near_lines(live, n, line - 1);
    between[line + 2] = near_lines(live, n, line);
}

bool cr_reach_new(struct cr_solver *s, struct cr_moving *m) {
    const struct cr_grid *g = &m->body->grid;
    size_t size = sizeof(struct cr_range);
    m->between_rows = cr_arena_take_raw(&s->arena, (size_t)g->ny + 3, size);
    m->between_cols = cr_arena_take_raw(&s->arena, (size_t)g->nx + 3, size);
    if (m->between_rows == NULL || m->between_cols == NULL) {
        return false;
    }
    for (int k = -2; k <= g->ny; k++) {
        m->between_rows[k + 2] = near_lines(m->row, g->ny, k);
    }
    for (int k = -2; k <= g->nx; k++) {
        m->between_cols[k + 2] = near_lines(m->col, g->nx, k);
    }
    return true;
}
