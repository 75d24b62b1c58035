/* Finds lines of equal values over two inputs, for pictures in cells and on a canvas. */
#include "render/render.h"

#include <math.h>

bool cr_heat_range(const struct cr_heat_map *map, double *lo, double *hi) {
    *lo = INFINITY;
    *hi = -INFINITY;
    for (int i = 0; i < map->nx * map->ny; i++) {
        if (isfinite(map->value[i])) {
            *lo = fmin(*lo, map->value[i]);
            *hi = fmax(*hi, map->value[i]);
        }
    }
    return *lo <= *hi;
}

/* Finds where the level lies between two corners, as a place of the grid; false: not between
 * them. */
static bool cut(const double at[4][2], const double v[4], int i, int k, double level,
                double out[2]) {
    if ((v[i] < level) == (v[k] < level)) {
        return false;
    }
    double u = (level - v[i]) / (v[k] - v[i]);
    out[0] = at[i][0] + u * (at[k][0] - at[i][0]);
    out[1] = at[i][1] + u * (at[k][1] - at[i][1]);
    return true;
}

/* Cuts a cell of the grid as four triangles about its middle, of which no case is ambiguous. */
static void cut_cell(const double corner[4][2], const double value[4], double level,
                     void (*piece)(void *user, const double from[2], const double to[2]),
                     void *user) {
    double mean = (value[0] + value[1] + value[2] + value[3]) / 4;
    for (int i = 0; i < 4; i++) {
        int k = (i + 1) % 4;
        const double at[4][2] = {
            {corner[i][0], corner[i][1]},
            {corner[k][0], corner[k][1]},
            {(corner[0][0] + corner[2][0]) / 2, (corner[0][1] + corner[2][1]) / 2}};
        const double v[4] = {value[i], value[k], mean};
        double end[3][2];
        int n = 0;
        for (int side = 0; side < 3 && n < 3; side++) {
            n += cut(at, v, side, (side + 1) % 3, level, end[n]);
        }
        if (n == 2) {
            piece(user, end[0], end[1]);
        }
    }
}

void cr_heat_contour(const struct cr_heat_map *map, double level,
                     void (*piece)(void *user, const double from[2], const double to[2]),
                     void *user) {
    if (map->x_word != NULL || map->y_word != NULL) {
        return;
    }
    for (int y = 0; y + 1 < map->ny; y++) {
        for (int x = 0; x + 1 < map->nx; x++) {
            const double *low = &map->value[y * map->nx + x], *high = low + map->nx;
            const double corner[4][2] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
            const double value[4] = {low[0], low[1], high[1], high[0]};
            if (isfinite(low[0] + low[1] + high[1] + high[0])) {
                cut_cell(corner, value, level, piece, user);
            }
        }
    }
}
