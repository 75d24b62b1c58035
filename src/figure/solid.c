/* Writes the 3D model of a vehicle with its deformation as VTK voxels and as an OBJ surface. */
#include "figure/forms.h"

#include "base/vec.h"

#include <math.h>
#include <stdlib.h>

/* The share of its material that the column of a voxel has lost, 0..1. */
static double damage(const struct cr_projection *p, int ix, int iy) {
    const struct cr_voxels *m = p->voxels;
    const struct cr_grid *g = p->grid;
    if (g == NULL || p->left == NULL) {
        return 0;
    }
    int gx = (int)floor((m->x0 + (ix + 0.5) * m->edge - g->x0) / g->h);
    int gy = (int)floor((m->y0 + (iy + 0.5) * m->edge - g->y0) / g->h);
    if (gx < 0 || gy < 0 || gx >= g->nx || gy >= g->ny || !(g->fill[gy * g->nx + gx] > 0)) {
        return 0;
    }
    return cr_clamp(1 - p->left[gy * g->nx + gx] / g->fill[gy * g->nx + gx], 0, 1);
}

static size_t index_of(const struct cr_voxels *m, int x, int y, int z) {
    return ((size_t)z * (size_t)m->ny + (size_t)y) * (size_t)m->nx + (size_t)x;
}

void cr_form_vtk(const struct cr_body_voxels *body, struct cr_str *out) {
    static const char *const names[] = {"fill", "ees_kmh", "energy_J", "damage"};
    const struct cr_voxels *m = &body->voxels;
    const struct cr_projection *p = &body->projection;
    cr_str_addf(out,
                "# vtk DataFile Version 3.0\n%s, x forward, y left, z up, m\nASCII\n"
                "DATASET STRUCTURED_POINTS\nDIMENSIONS %d %d %d\nORIGIN %.9g %.9g %.9g\n"
                "SPACING %.9g %.9g %.9g\nCELL_DATA %ld\n",
                m->name, m->nx + 1, m->ny + 1, m->nz + 1, m->x0, m->y0, m->z0, m->edge, m->edge,
                m->edge, (long)m->nx * m->ny * m->nz);
    for (int k = 0; k < 4; k++) {
        cr_str_addf(out, "SCALARS %s float 1\nLOOKUP_TABLE default\n", names[k]);
        for (int z = 0; z < m->nz; z++) {
            for (int y = 0; y < m->ny; y++) {
                for (int x = 0; x < m->nx; x++) {
                    size_t i = index_of(m, x, y, z);
                    double v = k == 0   ? m->fill[i]
                               : k == 1 ? cr_kmh(p->ees[i])
                               : k == 2 ? m->energy[i]
                                        : damage(p, x, y);
                    cr_str_addf(out, "%.6g\n", m->fill[i] > 0 || k == 0 ? v : 0);
                }
            }
        }
    }
}

static bool solid(const struct cr_body_voxels *b, int x, int y, int z) {
    const struct cr_voxels *m = &b->voxels;
    return x >= 0 && y >= 0 && z >= 0 && x < m->nx && y < m->ny && z < m->nz &&
           m->fill[index_of(m, x, y, z)] >= 0.5 && damage(&b->projection, x, y) < 0.5;
}

/* The ways out through the six sides of a voxel, and the corners of each side, counter-clockwise as
 * seen from outside. */
static const int side_out[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                   {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
static const int side_corner[6][4][3] = {
    {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}},
    {{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}},
    {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}};

/* The number of a corner, 1 for the first; a corner that is met first gets its line. */
static int vertex(const struct cr_voxels *m, int *number, int *n, const int c[3],
                  struct cr_str *out) {
    size_t i =
        ((size_t)c[2] * (size_t)(m->ny + 1) + (size_t)c[1]) * (size_t)(m->nx + 1) + (size_t)c[0];
    if (number[i] == 0) {
        number[i] = ++*n;
        cr_str_addf(out, "v %.6g %.6g %.6g\n", m->x0 + c[0] * m->edge, m->y0 + c[1] * m->edge,
                    m->z0 + c[2] * m->edge);
    }
    return number[i];
}

static void sides(const struct cr_body_voxels *b, const int at[3], int *number, int *n,
                  struct cr_str *out) {
    for (int s = 0; s < 6; s++) {
        const int *o = side_out[s];
        int corner[4];
        if (solid(b, at[0] + o[0], at[1] + o[1], at[2] + o[2])) {
            continue;
        }
        for (int k = 0; k < 4; k++) {
            const int *d = side_corner[s][k];
            const int c[3] = {at[0] + d[0], at[1] + d[1], at[2] + d[2]};
            corner[k] = vertex(&b->voxels, number, n, c, out);
        }
        cr_str_addf(out, "f %d %d %d %d\n", corner[0], corner[1], corner[2], corner[3]);
    }
}

enum cr_err cr_form_obj(const struct cr_body_voxels *b, struct cr_str *out, struct cr_error *err) {
    const struct cr_voxels *m = &b->voxels;
    int *number =
        calloc((size_t)(m->nx + 1) * (size_t)(m->ny + 1) * (size_t)(m->nz + 1), sizeof *number);
    int n = 0;
    if (number == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the surface of %s", m->name);
    }
    cr_str_addf(out, "# %s, what is left after the crash; x forward, y left, z up, m\n", m->name);
    for (int z = 0; z < m->nz; z++) {
        for (int y = 0; y < m->ny; y++) {
            for (int x = 0; x < m->nx; x++) {
                const int at[3] = {x, y, z};
                if (solid(b, x, y, z)) {
                    sides(b, at, number, &n, out);
                }
            }
        }
    }
    free(number);
    return CR_ERR_OK;
}
