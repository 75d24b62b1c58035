/* Which voxels of a body its opponent can meet: the rows that the opponent's box covers, and of
 * each row the part that lies near material the opponent still has. */
#include "solver/solver_priv.h"

/* Slopes smaller than this are taken for it: over the longest row that moves nothing by as much as
 * rounding does, and the reciprocal stays finite. */
static const double slope_min = 1e-13;

/* more lines than this are not looked through for their live span */
enum { LINES_MAX = 24 };

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
                           .s = s * r,
                           .per_c = reciprocal(c * r),
                           .per_s = reciprocal(s * r)};
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
static void box_of(struct cr_reach *r, struct cr_moving *o, double h) {
    if (o->row == NULL) {
        r->lo = cr_vec2(o->lo.x - h, o->lo.y - h);
        r->hi = cr_vec2(o->hi.x + h, o->hi.y + h);
        return;
    }
    o->rows = trimmed(o->rows, o->row);
    o->cols = trimmed(o->cols, o->col);
    r->lo = cr_vec2(o->cols.lo - 1, o->rows.lo - 1);
    r->hi = cr_vec2(o->cols.hi, o->rows.hi);
}

void cr_reach_begin(struct cr_reach *r, struct cr_moving *me, struct cr_moving *other) {
    *r = (struct cr_reach){.map = map_between(me, other), .me = me, .other = other};
    const struct cr_map *map = &r->map;
    box_of(r, other, me->body->grid.h);
    /* row of each corner of the box: the map is a rotation and a scale, so its inverse is short */
    double det = map->c * map->c + map->s * map->s, low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 4; i++) {
        double u = (i & 1 ? r->hi.x : r->lo.x) - map->u, v = (i & 2 ? r->hi.y : r->lo.y) - map->v;
        double row = (map->c * v - map->s * u) / det;
        low = row < low ? row : low;
        high = row > high ? row : high;
    }
    me->rows = trimmed(me->rows, me->row);
    r->rows.lo = (int)cr_clamp(ceil(low), me->rows.lo, me->rows.hi);
    r->rows.hi = (int)cr_clamp(floor(high) + 1, me->rows.lo, me->rows.hi);
}

/* part of a row, in voxels from its first one */
struct part {
    double lo, hi;
};

static const struct part nothing = {1, 0};

/* narrow a part to the x with low <= base + x / per_slope <= high */
static struct part clip(struct part part, double base, double per_slope, double low, double high) {
    double x0 = (low - base) * per_slope, x1 = (high - base) * per_slope;
    double least = x0 < x1 ? x0 : x1, most = x0 < x1 ? x1 : x0;
    return (struct part){least > part.lo ? least : part.lo, most < part.hi ? most : part.hi};
}

/* Union of the live spans of the lines crossed between places p and q; whole when too many are
 * crossed to be worth the look. */
static struct cr_span live_between(const struct cr_span *line, struct cr_span lines, double p,
                                   double q, struct cr_span whole) {
    /* places are > -1 and in the last part of a row */
    int from = (int)((p < q ? p : q) + 1) - 1, to = (int)((p < q ? q : p) + 1);
    from = from < lines.lo ? lines.lo : from;
    to = to >= lines.hi ? lines.hi - 1 : to;
    if (to - from >= LINES_MAX) {
        return whole;
    }
    struct cr_span span = {whole.hi, whole.lo};
    for (int i = from; i <= to; i++) {
        if (line[i].lo < line[i].hi) {
            span.lo = line[i].lo < span.lo ? line[i].lo : span.lo;
            span.hi = line[i].hi > span.hi ? line[i].hi : span.hi;
        }
    }
    return span;
}

/* Narrow a part to where the opponent still has material near: by its rows where the two are
 * nearly aligned, by its columns where they stand across. */
static struct part clip_to_live(const struct cr_reach *r, double u, double v, struct part part) {
    const struct cr_moving *o = r->other;
    const struct cr_map *map = &r->map;
    if (fabs(map->c) >= fabs(map->s)) {
        struct cr_span x =
            live_between(o->row, o->rows, v + map->s * part.lo, v + map->s * part.hi, o->cols);
        return x.lo < x.hi ? clip(part, u, map->per_c, x.lo - 1, x.hi) : nothing;
    }
    struct cr_span y =
        live_between(o->col, o->cols, u + map->c * part.lo, u + map->c * part.hi, o->rows);
    return y.lo < y.hi ? clip(part, v, map->per_s, y.lo - 1, y.hi) : nothing;
}

struct cr_span cr_reach_row(const struct cr_reach *r, int iy) {
    const struct cr_map *map = &r->map;
    struct cr_span none = {0, 0}, row = r->me->row[iy];
    struct part part = {row.lo, row.hi - 1};
    double u = map->u - map->s * iy, v = map->v + map->c * iy;
    part = clip(part, u, map->per_c, r->lo.x, r->hi.x);
    part = clip(part, v, map->per_s, r->lo.y, r->hi.y);
    if (part.lo <= part.hi && r->other->row != NULL) {
        part = clip_to_live(r, u, v, part);
    }
    if (!(part.lo <= part.hi)) {
        return none;
    }
    int lo = (int)part.lo;
    return (struct cr_span){lo + (lo < part.lo), (int)part.hi + 1};
}
