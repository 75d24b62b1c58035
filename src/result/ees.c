/* Computes the EES field of a plan model: how severe a crush down to each voxel is. */
#include "result/result.h"

#include <math.h>

/* A line of voxels, square to a face. */
struct line {
    int start, step, n, lines; /* first voxel, step to the next, how many; lines of the face */
};

/* EES in km/h of a line of voxels crushed from its end down to each of its voxels, if the whole
 * face were like this line: sqrt(2 E lines / m). Keeps the lesser of this and the value that is
 * there, so that every voxel ends with the value of the face that reaches it at the least EES. */
static void walk(const struct cr_grid *g, double mass, struct line line, double *ees) {
    double sum = 0;
    for (int k = 0, i = line.start; k < line.n; k++, i += line.step) {
        sum += g->energy[i];
        ees[i] = fmin(ees[i], cr_kmh(sqrt(2 * sum * line.lines / mass)));
    }
}

void cr_result_ees(const struct cr_grid *g, double mass, double *ees) {
    int n = g->nx * g->ny;
    for (int i = 0; i < n; i++) {
        ees[i] = INFINITY;
    }
    for (int iy = 0; iy < g->ny; iy++) {
        walk(g, mass, (struct line){iy * g->nx, 1, g->nx, g->ny}, ees);
        walk(g, mass, (struct line){iy * g->nx + g->nx - 1, -1, g->nx, g->ny}, ees);
    }
    for (int ix = 0; ix < g->nx; ix++) {
        walk(g, mass, (struct line){ix, g->nx, g->ny, g->nx}, ees);
        walk(g, mass, (struct line){n - g->nx + ix, -g->nx, g->ny, g->nx}, ees);
    }
}
