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
static inline struct part clip(struct part part, double base, double per_slope, double low,
                               double high) {
    double x0 = (low - base) * per_slope, x1 = (high - base) * per_slope;
    double least = x0 < x1 ? x0 : x1, most = x0 < x1 ? x1 : x0;
    return (struct part){least > part.lo ? least : part.lo, most < part.hi ? most : part.hi};
}

/* One coordinate of the opponent's grid along a row: at + slope x at its voxel x. */
struct course {
    double at, slope, per_slope;
};

static struct course reversed(struct course c) {
    return (struct course){c.at, -c.slope, -c.per_slope};
}

/* Where, from x on, a row comes near material: between two lines of the opponent its course `along`
 * them must come into the range there. May be beyond `to`, the end of the row. */
static inline double first_met(const struct cr_range *between, struct course along,
                               struct course across, double x, double to) {
    bool up = across.per_slope > 0;                  /* a slope may be 0 */
    int k = (int)(across.at + across.slope * x + 2); /* of lines k - 2 and k - 1: places are > -2 */
    double end = (k - 2 + up - across.at) * across.per_slope, step = fabs(across.per_slope);
    double here = along.at + along.slope * x, there = along.at + along.slope * end;
    double rise = along.slope * step;
    const struct cr_range *near = &between[k];
    while ((rise > 0 ? there < near->lo || here > near->hi : here < near->lo || there > near->hi) &&
           x <= to) {
        x = end;
        here = there;
        end += step;
        there += rise;
        near += up ? 1 : -1;
    }
    if (x > to || (here >= near->lo && here <= near->hi)) {
        return x;
    }
    return ((here < near->lo ? near->lo : near->hi) - along.at) * along.per_slope;
}

/* Narrow a part at both ends to where the opponent still has material near: going by its rows where
 * the two are nearly aligned, by its columns where they stand across. */
static inline struct part clip_to_live(const struct cr_reach *r, double u, double v,
                                       struct part part) {
    const struct cr_map *map = &r->map;
    struct course along = {u, map->c, map->per_c}, across = {v, map->s, map->per_s};
    const struct cr_range *between = r->other->between_rows;
    if (fabs(map->c) < fabs(map->s)) {
        struct course by_u = along;
        along = across;
        across = by_u;
        between = r->other->between_cols;
    }
    double lo = first_met(between, along, across, part.lo, part.hi);
    if (!(lo <= part.hi)) {
        return nothing;
    }
    double hi = -first_met(between, reversed(along), reversed(across), -part.hi, -lo);
    return (struct part){lo, hi};
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

void cr_reach_renew(struct cr_moving *m, int ix, int iy) {
    const struct cr_grid *g = &m->body->grid;
    for (int k = -1; k <= 0; k++) {
        m->between_rows[iy + k + 2] = near_lines(m->row, g->ny, iy + k);
        m->between_cols[ix + k + 2] = near_lines(m->col, g->nx, ix + k);
    }
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
