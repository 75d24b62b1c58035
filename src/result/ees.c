/* The EES field of a plan model: how severe a crush down to each voxel is. */
#include "result/result.h"

#include <math.h>

/* EES in km/h of a line of voxels crushed from its end down to each of its voxels, if the whole
 * face were like this line (`lines` of them): sqrt(2 E lines / m). Keeps the lesser of this and
 * what is there, so that every voxel ends with the value of the face that reaches it first. */
static void walk(const struct cr_grid *g, double mass, int lines, int start, int step, int n,
                 double *ees) {
    double sum = 0;
    for (int k = 0, i = start; k < n; k++, i += step) {
        sum += g->energy[i];
        ees[i] = fmin(ees[i], cr_kmh(sqrt(2 * sum * lines / mass)));
    }
}

void cr_result_ees(const struct cr_grid *g, double mass, double *ees) {
    int n = g->nx * g->ny;
    for (int i = 0; i < n; i++) {
        ees[i] = INFINITY;
    }
    for (int iy = 0; iy < g->ny; iy++) {
        walk(g, mass, g->ny, iy * g->nx, 1, g->nx, ees);
        walk(g, mass, g->ny, iy * g->nx + g->nx - 1, -1, g->nx, ees);
    }
    for (int ix = 0; ix < g->nx; ix++) {
        walk(g, mass, g->nx, ix, g->nx, g->ny, ees);
        walk(g, mass, g->nx, n - g->nx + ix, -g->nx, g->ny, ees);
    }
}
