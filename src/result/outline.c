/* Draws the outline of the material that is left of a grid: marching squares over the voxel
 * centres. */
#include "result/deform.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The squares lie between four voxel centres and are padded by one ring of empty voxels; every
 * square edge that the contour crosses is a node, linked to the next node counter-clockwise about
 * the material. Edge numbers: 2 * corner + (0: towards +x, 1: towards +y). */
struct field {
    const struct cr_grid *grid;
    const double *left;
    int w, h;            /* corners of squares: nx + 2, ny + 2 */
    int *next;           /* [2 * w * h] */
    unsigned char *full; /* [2 * w] whether the corners of two rows hold material */
};

static const double level = 0.5; /* material of a voxel; the contour runs where half is left */

static double value(const struct field *f, int x, int y) {
    bool in = x >= 1 && y >= 1 && x <= f->grid->nx && y <= f->grid->ny;
    return in ? f->left[(y - 1) * f->grid->nx + x - 1] : 0;
}

/* The number of the bottom (0), right, top or left (3) edge of the square whose lower left corner
 * is (x, y). */
static int edge(const struct field *f, int x, int y, int side) {
    int c = y * f->w + x;
    const int of[4] = {2 * c, 2 * (c + 1) + 1, 2 * (c + f->w), 2 * c + 1};
    return of[side];
}

/* Finds which corners of row y hold material. Only two rows are needed at a time: even and odd rows
 * take turns in the halves of f->full. */
static const unsigned char *corners(const struct field *f, int y) {
    unsigned char *full = f->full + (y % 2) * f->w;
    int nx = f->grid->nx;
    bool in = y >= 1 && y <= f->grid->ny;
    const double *left = f->left + (in ? (y - 1) * nx : 0);
    full[0] = full[nx + 1] = 0;
    for (int x = 0; x < nx; x++) {
        full[x + 1] = in && left[x] >= level;
    }
    return full;
}

/* Links the edges of the squares between the corners `low` of row y and `high` of the next row. */
static void link_row(struct field *f, int y, const unsigned char *low, const unsigned char *high) {
    /* The bits of a row's number are the corners lower left, lower right, upper right, upper left;
     * its pairs lead from edge to edge with the material on the left hand. The two saddles (5, 10)
     * keep the corners of material apart. */
    static const signed char table[16][4] = {
        {-1, -1, -1, -1}, {0, 3, -1, -1}, {1, 0, -1, -1}, {1, 3, -1, -1},
        {2, 1, -1, -1},   {0, 3, 2, 1},   {2, 0, -1, -1}, {2, 3, -1, -1},
        {3, 2, -1, -1},   {0, 2, -1, -1}, {1, 0, 3, 2},   {1, 2, -1, -1},
        {3, 1, -1, -1},   {0, 1, -1, -1}, {3, 0, -1, -1}, {-1, -1, -1, -1},
    };
    for (int x = 0; x + 1 < f->w; x++) {
        int kind = low[x] | low[x + 1] << 1 | high[x + 1] << 2 | high[x] << 3;
        for (int i = 0; i < 4 && table[kind][i] >= 0; i += 2) {
            f->next[edge(f, x, y, table[kind][i])] = edge(f, x, y, table[kind][i + 1]);
        }
    }
}

static struct cr_vec2 crossing(const struct field *f, int e) {
    const struct cr_grid *g = f->grid;
    int x = e / 2 % f->w, y = e / 2 / f->w, up = e % 2;
    double a = value(f, x, y), b = value(f, x + !up, y + up);
    /* The contour crosses this edge: one end has at least the level, the other less, so b != a. */
    double t = (level - a) / (b - a);
    return cr_vec2(g->x0 + g->h * (x - 0.5 + (up ? 0 : t)),
                   g->y0 + g->h * (y - 0.5 + (up ? t : 0)));
}

static double loop_area(const struct field *f, int start, int *n) {
    double area = 0;
    struct cr_vec2 a = crossing(f, start);
    *n = 0;
    for (int e = start, go = 1; go; go = e != start) {
        e = f->next[e];
        struct cr_vec2 b = crossing(f, e);
        area += cr_vec2_cross(a, b) / 2;
        a = b;
        ++*n;
    }
    return area;
}

/* The first edge of the loop that encloses most, with its number of points; -1 without any loop, -2
 * without memory. */
static int largest(struct field *f, int *points) {
    double best = 0;
    int found = -1;
    unsigned char *seen = calloc((size_t)(2 * f->w) * (size_t)f->h, 1);
    if (seen == NULL) {
        return -2;
    }
    for (int e = 0; e < 2 * f->w * f->h; e++) {
        if (f->next[e] < 0 || seen[e]) {
            continue;
        }
        int n;
        double area = loop_area(f, e, &n);
        for (int k = e, i = 0; i < n; i++) {
            seen[k] = 1;
            k = f->next[k];
        }
        if (area > best) {
            best = area;
            found = e;
            *points = n;
        }
    }
    free(seen);
    return found;
}

/* Drops points nearer than tol to the line from the last kept point to the following one; returns
 * how many are kept. */
static int simplify(struct cr_vec2 *p, int n, double tol) {
    int kept = 0;
    for (int i = 0, from = 0; i < n; i++) {
        struct cr_vec2 a = kept > 0 ? p[kept - 1] : p[n - 1], b = p[(i + 1) % n];
        struct cr_vec2 ab = cr_vec2_sub(b, a);
        double len = cr_vec2_len(ab), off = 0;
        /* The points that were dropped since the last kept one must stay within the tolerance
         * too. */
        for (int k = from; k <= i && off <= tol; k++) {
            struct cr_vec2 ak = cr_vec2_sub(p[k], a);
            off = len > 0 ? fabs(cr_vec2_cross(ab, ak)) / len : cr_vec2_len(ak);
        }
        if (off > tol || i == 0) {
            p[kept++] = p[i];
            from = i + 1;
        }
    }
    return kept;
}

enum cr_err cr_deform_outline(const struct cr_grid *grid, const double *left, double tolerance,
                              struct cr_vec2 **out, int *n, struct cr_error *err) {
    struct field f = {.grid = grid, .left = left, .w = grid->nx + 2, .h = grid->ny + 2};
    size_t edges = (size_t)(2 * f.w) * (size_t)f.h;
    enum cr_err code = CR_ERR_MEMORY;
    *out = NULL;
    *n = 0;
    f.next = malloc(edges * sizeof *f.next);
    f.full = malloc(2 * (size_t)f.w);
    if (f.next == NULL || f.full == NULL) {
        goto out;
    }
    memset(f.next, 0xff, edges * sizeof *f.next);
    const unsigned char *low = corners(&f, 0);
    for (int y = 0; y + 1 < f.h; y++) {
        const unsigned char *high = corners(&f, y + 1);
        link_row(&f, y, low, high);
        low = high;
    }
    int points = 0;
    int start = largest(&f, &points);
    if (start == -2) {
        goto out;
    }
    code = CR_ERR_OK;
    if (start < 0) {
        goto out;
    }
    struct cr_vec2 *p = malloc((size_t)points * sizeof *p);
    if (p == NULL) {
        code = CR_ERR_MEMORY;
        goto out;
    }
    for (int i = 0, e = start; i < points; i++, e = f.next[e]) {
        p[i] = crossing(&f, e);
    }
    *n = simplify(p, points, tolerance);
    *out = p;
out:
    free(f.next);
    free(f.full);
    if (code != CR_ERR_OK) {
        cr_err_set(err, code, "no memory for the outline of a grid");
    }
    return code;
}
