/* Draws a measured outline over the voxel model of its vehicle, from above and from the side. */
#include "damage/picture.h"

#include "render/project.h"

#include <math.h>
#include <stdio.h>

enum { ROWS_MOST = 24 };
static const double edge = 0.05; /* m, of the voxels that are drawn */

static enum cr_err draw_view(const struct cr_projection *p, const struct cr_look *look, int width,
                             struct cr_str *out, struct cr_error *err) {
    struct cr_cells cells;
    int rows = cr_render_projection_rows(p, width, ROWS_MOST);
    enum cr_err code = cr_cells_new(width, rows, &cells, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_render_projection(&cells, (struct cr_rect){0, 0, width, rows}, look, p, err);
    if (code == CR_ERR_OK) {
        cr_cells_text(&cells, look, out);
    }
    cr_cells_fini(&cells);
    return code;
}

enum cr_err cr_crush_picture(const struct cr_crush_car *car, const struct cr_crush_rules *rules,
                             const struct cr_crush_look *how, struct cr_str *out,
                             struct cr_error *err) {
    struct cr_arena arena = {0};
    struct cr_voxels voxels;
    struct cr_scene scene;
    static const enum cr_project views[] = {CR_PROJECT_TOP, CR_PROJECT_SIDE};
    cr_scene_init(&scene);
    struct cr_model_query q = cr_scene_query(&scene, car->p, cr_crush_square(car->m.face));
    q.voxel = edge;
    enum cr_err code = cr_model_voxels(how->lib, &q, &arena, &voxels, err);
    if (code != CR_ERR_OK) {
        goto out;
    }
    snprintf(voxels.name, sizeof voxels.name, "%.20s  %s", car->id, cr_type_word(car->p->type));
    size_t n = (size_t)voxels.nx * (size_t)voxels.ny * (size_t)voxels.nz;
    size_t flat = (size_t)car->grid.nx * (size_t)car->grid.ny;
    double *ees = cr_arena_take(&arena, n, sizeof *ees);
    double *left = cr_arena_take(&arena, flat, sizeof *left);
    if (arena.failed) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the model of %s", car->id);
        goto out;
    }
    code = cr_voxels_ees(&voxels, ees, err);
    cr_crush_left(car, rules, false, left);
    for (int i = 0; i < 2 && code == CR_ERR_OK; i++) {
        const struct cr_projection p = {.view = views[i],
                                        .voxels = &voxels,
                                        .ees = ees,
                                        .grid = &car->grid,
                                        .left = left,
                                        .face = car->m.face};
        code = draw_view(&p, how->look, how->width, out, err);
    }
out:
    cr_arena_free(&arena);
    return code;
}
