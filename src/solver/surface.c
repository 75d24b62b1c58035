/* The signed distance that stands for the surface of a deformable body. */
#include "solver/surface.h"

#include "solver/tuning.h"

static struct cr_lines lines_of(const struct cr_grid *g, enum cr_face face) {
    double x1 = g->x0 + g->nx * g->h, y1 = g->y0 + g->ny * g->h, low_y = g->y0, low_x = g->x0;
    switch (face) {
    case CR_FACE_FRONT:
        return (struct cr_lines){g->ny, g->nx, g->nx - 1, g->nx, -1, {0, 1}, {-1, 0}, {x1, low_y}};
    case CR_FACE_REAR:
        return (struct cr_lines){g->ny, g->nx, 0, g->nx, 1, {0, 1}, {1, 0}, {low_x, low_y}};
    case CR_FACE_LEFT:
        return (struct cr_lines){g->nx,  g->ny,   (g->ny - 1) * g->nx, 1, -g->nx,
                                 {1, 0}, {0, -1}, {low_x, y1}};
    default:
        return (struct cr_lines){g->nx, g->ny, 0, 1, g->nx, {1, 0}, {0, 1}, {low_x, low_y}};
    }
}

static double fill_at(const struct cr_grid *g, int ix, int iy) {
    return ix >= 0 && iy >= 0 && ix < g->nx && iy < g->ny ? g->fill[iy * g->nx + ix] : 0;
}

/* A piece of the undeformed outline in the middle of a voxel: its distance and outward normal. */
struct piece {
    double phi;
    struct cr_vec2 n;
};

/* gradient of the fill about a voxel, by Sobel's weights */
static struct cr_vec2 fill_gradient(const struct cr_grid *g, int ix, int iy) {
    double x = 0, y = 0;
    for (int k = -1; k <= 1; k++) {
        double w = k == 0 ? 2 : 1;
        x += w * (fill_at(g, ix + 1, iy + k) - fill_at(g, ix - 1, iy + k));
        y += w * (fill_at(g, ix + k, iy + 1) - fill_at(g, ix + k, iy - 1));
    }
    return cr_vec2(x, y);
}

/* Does the outline pass through or beside a voxel? A voxel filled in part says by its fill
 * where. */
static bool outline_piece(const struct cr_surface *s, int ix, int iy, struct piece *out) {
    const struct cr_grid *g = s->grid;
    double fill = fill_at(g, ix, iy), dense = s->dense[iy * g->nx + ix];
    bool open = fill_at(g, ix + 1, iy) <= 0 || fill_at(g, ix - 1, iy) <= 0 ||
                fill_at(g, ix, iy + 1) <= 0 || fill_at(g, ix, iy - 1) <= 0;
    if (!(fill > 0) || (!open && fill > (1 - 1e-9) * dense)) {
        return false;
    }
    struct cr_vec2 d = fill_gradient(g, ix, iy);
    if (d.x == 0 && d.y == 0) {
        return false;
    }
    out->n = cr_vec2_unit(cr_vec2_scale(d, -1), cr_vec2(1, 0));
    out->phi = (0.5 - fill / dense) * g->h * (fabs(out->n.x) + fabs(out->n.y));
    return true;
}

/* The nearest piece of the outline decides the distance of the voxels about it. */
static void spread_piece(struct cr_surface *s, double *near, int ix, int iy, struct piece p) {
    const int reach = CR_MARGIN;
    double h = s->grid->h;
    struct cr_vec2 at = cr_vec2_scale(p.n, -p.phi); /* the piece, from the voxel's middle */
    for (int j = -reach; j <= reach; j++) {
        if (iy + j < -CR_MARGIN || iy + j >= s->grid->ny + CR_MARGIN) {
            continue;
        }
        for (int i = -reach; i <= reach; i++) {
            if (ix + i < -CR_MARGIN || ix + i >= s->grid->nx + CR_MARGIN) {
                continue;
            }
            struct cr_vec2 d = cr_vec2_sub(cr_vec2(i * h, j * h), at);
            double d2 = cr_vec2_dot(d, d);
            int k = cr_surface_at(s, ix + i, iy + j);
            double along = cr_vec2_dot(d, p.n);
            if (d2 < near[k] * (1 - 1e-9) ||
                (d2 < near[k] * (1 + 1e-9) && fabs(along) > fabs(s->phi[k]))) {
                near[k] = cr_min(d2, near[k]);
                s->phi[k] = cr_clamp(along, -s->band, s->band);
            }
        }
    }
}

/* Further out a lower bound of the distance is enough to pass over empty voxels: from neighbour to
 * neighbour, a pass forward and a pass back. */
static void spread_outward(struct cr_surface *s, const double *near) {
    int w = s->stride, rows = s->grid->ny + 2 * CR_MARGIN;
    double straight = 0.9 * s->grid->h, slant = 1.3 * s->grid->h;
    for (int pass = 0; pass < 2; pass++) {
        int way = pass == 0 ? 1 : -1;
        for (int n = 0; n < (w - 2) * (rows - 2); n++) {
            int cell = pass == 0 ? n : (w - 2) * (rows - 2) - 1 - n;
            int k = (cell / (w - 2) + 1) * w + cell % (w - 2) + 1;
            if (isfinite(near[k]) || s->phi[k] < 0) {
                continue;
            }
            double d = cr_min(s->phi[k - way], s->phi[k - way * w]) + straight;
            d = cr_min(d, cr_min(s->phi[k - way * (w - 1)], s->phi[k - way * (w + 1)]) + slant);
            s->phi[k] = pass == 0 ? cr_max(d, s->band) : cr_max(cr_min(s->phi[k], d), s->band);
        }
    }
}

static void mark_near(struct cr_surface *s) {
    for (int iy = -CR_MARGIN + 1; iy < s->grid->ny + CR_MARGIN - 1; iy++) {
        for (int ix = -CR_MARGIN + 1; ix < s->grid->nx + CR_MARGIN - 1; ix++) {
            int at = cr_surface_at(s, ix, iy);
            if (s->phi[at] > -s->band) {
                cr_surface_near(s, at);
            }
        }
    }
}

static void measure_outline(struct cr_surface *s, enum cr_face face) {
    const struct cr_grid *g = s->grid;
    struct cr_lines lines = s->lines[face];
    for (int i = 0; i < lines.n; i++) {
        int k = lines.first + i * lines.next, n = 0;
        while (n < lines.length && !(g->fill[k + n * lines.inward] > 0)) {
            n++;
        }
        int at = k + n * lines.inward;
        double part = n < lines.length ? 1 - g->fill[at] / s->dense[at] : 0;
        s->first[face][i] = n;
        s->outline[face][i] = s->limit[face][i] = (n + part) * g->h;
    }
}

/* share of a voxel that is material: what the fullest of its neighbours holds */
static void measure_density(struct cr_surface *s) {
    const struct cr_grid *g = s->grid;
    for (int iy = 0; iy < g->ny; iy++) {
        for (int ix = 0; ix < g->nx; ix++) {
            double most = cr_max(g->fill[iy * g->nx + ix], 1e-9);
            for (int k = 0; k < 9 && most < 1; k++) { /* nothing is fuller than full */
                most = cr_max(most, fill_at(g, ix + k % 3 - 1, iy + k / 3 - 1));
            }
            s->dense[iy * g->nx + ix] = most;
        }
    }
}

/* n objects of a piece of memory, from its begin on */
static void *cut(char **piece, size_t n, size_t each) {
    void *at = *piece;
    *piece += n * each;
    return at;
}

/* What changes lies in one piece: what is widest comes first, so that all is aligned. */
static bool take_state(struct cr_surface *s, struct cr_arena *arena, size_t n, size_t padded) {
    size_t lines = 2 * (size_t)(s->grid->nx + s->grid->ny);
    s->state_size = (padded + 2 * n + lines) * sizeof(double) + lines * sizeof(int) + padded + n;
    s->state = cr_arena_take(arena, 1, s->state_size);
    s->kept = cr_arena_take_raw(arena, 1, s->state_size);
    if (s->state == NULL || s->kept == NULL) {
        return false;
    }
    char *piece = s->state;
    s->phi = cut(&piece, padded, sizeof *s->phi);
    s->left = cut(&piece, n, sizeof *s->left);
    s->t_sum = cut(&piece, n, sizeof *s->t_sum);
    for (int f = 0; f < CR_FACES; f++) {
        s->limit[f] = cut(&piece, (size_t)cr_face_lines(s->grid, f), sizeof *s->limit[f]);
    }
    for (int f = 0; f < CR_FACES; f++) {
        s->first[f] = cut(&piece, (size_t)cr_face_lines(s->grid, f), sizeof *s->first[f]);
    }
    s->near = cut(&piece, padded, sizeof *s->near);
    s->how = cut(&piece, n, sizeof *s->how);
    return true;
}

static bool take_arrays(struct cr_surface *s, struct cr_arena *arena, double **near) {
    size_t n = (size_t)s->grid->nx * (size_t)s->grid->ny;
    size_t padded = (size_t)s->stride * (size_t)(s->grid->ny + 2 * CR_MARGIN);
    bool ok = take_state(s, arena, n, padded);
    *near = cr_arena_take_raw(arena, padded, sizeof **near);
    s->dense = cr_arena_take_raw(arena, n, sizeof *s->dense);
    ok = ok && *near != NULL && s->dense != NULL;
    for (int f = 0; f < CR_FACES; f++) {
        size_t lines = (size_t)cr_face_lines(s->grid, f);
        s->outline[f] = cr_arena_take_raw(arena, lines, sizeof *s->outline[f]);
        ok = ok && s->outline[f] != NULL;
    }
    return ok;
}

void cr_surface_keep(struct cr_surface *s) {
    memcpy(s->kept, s->state, s->state_size);
}

void cr_surface_back(struct cr_surface *s) {
    memcpy(s->state, s->kept, s->state_size);
}

bool cr_surface_new(struct cr_surface *s, const struct cr_grid *grid, struct cr_arena *arena) {
    double *near;
    *s = (struct cr_surface){
        .grid = grid, .stride = grid->nx + 2 * CR_MARGIN, .band = cr_band_voxels * grid->h};
    if (!take_arrays(s, arena, &near)) {
        return false;
    }
    memcpy(s->left, grid->fill, (size_t)grid->nx * (size_t)grid->ny * sizeof *s->left);
    for (int f = 0; f < CR_FACES; f++) {
        s->lines[f] = lines_of(grid, f);
    }
    measure_density(s);
    int padded = s->stride * (grid->ny + 2 * CR_MARGIN);
    for (int k = 0; k < padded; k++) {
        near[k] = INFINITY;
        s->phi[k] = s->band;
    }
    for (int iy = 0; iy < grid->ny; iy++) {
        for (int ix = 0; ix < grid->nx; ix++) {
            if (grid->fill[iy * grid->nx + ix] > 0) {
                s->phi[cr_surface_at(s, ix, iy)] = -s->band;
            }
        }
    }
    for (int iy = 0; iy < grid->ny; iy++) {
        for (int ix = 0; ix < grid->nx; ix++) {
            struct piece p;
            if (outline_piece(s, ix, iy, &p)) {
                spread_piece(s, near, ix, iy, p);
            }
        }
    }
    spread_outward(s, near);
    mark_near(s);
    for (int f = 0; f < CR_FACES; f++) {
        measure_outline(s, f);
    }
    return true;
}

/* Place in the padded grid, in voxels; false beyond it, with the least distance there. */
static bool place_in(const struct cr_surface *s, struct cr_vec2 p, double *u, double *v,
                     double *beyond) {
    const struct cr_grid *g = s->grid;
    const double edge = CR_MARGIN - 1;
    double x = (p.x - g->x0) / g->h - 0.5, y = (p.y - g->y0) / g->h - 0.5;
    *u = x + CR_MARGIN;
    *v = y + CR_MARGIN;
    if (x >= -edge && y >= -edge && x < g->nx - 1 + edge && y < g->ny - 1 + edge) {
        return true;
    }
    double dx = cr_max(cr_max(-x, x - (g->nx - 1)), 0), dy = cr_max(cr_max(-y, y - (g->ny - 1)), 0);
    *beyond = cr_max(s->band, g->h * (cr_max(dx, dy) - 1));
    return false;
}

/* Weights of four nodes for a place t between the middle two: a cubic of one slope in each node, so
 * that a bend keeps its form. A straight line between two nodes rounds it by a millimetre each time
 * a surface is read from the other's grid, and what slides is worn down by that. */
static inline void cubic(double t, double w[4]) {
    w[0] = t * (-0.5 + t * (1 - 0.5 * t));
    w[1] = 1 + t * t * (-2.5 + 1.5 * t);
    w[2] = t * (0.5 + t * (2 - 1.5 * t));
    w[3] = t * t * (-0.5 + 0.5 * t);
}

double cr_surface_between(const struct cr_surface *s, double u, double v) {
    double wx[4], wy[4], sum = 0;
    int i = (int)u, j = (int)v;
    cubic(u - i, wx);
    cubic(v - j, wy);
    const double *q = s->phi + (j - 1) * s->stride + i - 1;
    for (int k = 0; k < 4; k++, q += s->stride) {
        sum += wy[k] * (wx[0] * q[0] + wx[1] * q[1] + wx[2] * q[2] + wx[3] * q[3]);
    }
    return sum;
}

double cr_surface_distance(const struct cr_surface *s, struct cr_vec2 p) {
    double u, v, beyond;
    return place_in(s, p, &u, &v, &beyond) ? cr_surface_between(s, u, v) : beyond;
}

/* Weights of the three nodes about a place t off the middle one, and their slopes: a parabola in
 * each stretch, so that a gradient has no jumps, nor a side that it prefers. */
static inline void parabola(double t, double w[3], double slope[3]) {
    w[0] = 0.5 * (0.5 - t) * (0.5 - t);
    w[1] = 0.75 - t * t;
    w[2] = 0.5 * (0.5 + t) * (0.5 + t);
    slope[0] = t - 0.5;
    slope[1] = -2 * t;
    slope[2] = t + 0.5;
}

struct cr_vec2 cr_surface_gradient(const struct cr_surface *s, double u, double v) {
    const struct cr_grid *g = s->grid;
    if (!(u >= 1 && v >= 1 && u < g->nx + 2 * CR_MARGIN - 2 && v < g->ny + 2 * CR_MARGIN - 2)) {
        return cr_vec2(0, 0);
    }
    int i = (int)(u + 0.5), j = (int)(v + 0.5); /* the nearest voxel */
    double wx[3], wy[3], dx[3], dy[3], x = 0, y = 0, per = 1 / g->h;
    parabola(u - i, wx, dx);
    parabola(v - j, wy, dy);
    const double *q = s->phi + (j - 1) * s->stride + i - 1;
    for (int k = 0; k < 3; k++, q += s->stride) {
        x += wy[k] * (dx[0] * q[0] + dx[1] * q[1] + dx[2] * q[2]);
        y += dy[k] * (wx[0] * q[0] + wx[1] * q[1] + wx[2] * q[2]);
    }
    return cr_vec2(x * per, y * per);
}

void cr_surface_renew(struct cr_surface *s, enum cr_face face, int line) {
    struct cr_lines lines = s->lines[face];
    int n = s->first[face][line], k = lines.first + line * lines.next + n * lines.inward;
    while (n < lines.length && s->left[k] <= cr_crumb * s->dense[k]) {
        n++;
        k += lines.inward;
    }
    s->first[face][line] = n;
}
