/* Puts a solved deformation back on the 3D model of its vehicle (the paper's Figure 3). */
#include "render/project.h"

#include "base/arena.h"

#include <math.h>
#include <stdio.h>

static const double edge = 0.05; /* m, voxels of the 3D models */

static struct cr_model_query query_of(const struct cr_result *result, int body) {
    const struct cr_scene *scene = &result->resolved;
    struct cr_model_query q = cr_scene_query(scene, &scene->part[body], result->of[body].pdof);
    q.voxel = edge;
    return q;
}

enum cr_err cr_project_body(const struct cr_model_lib *lib, const struct cr_result *result,
                            int body, struct cr_body_voxels *out, struct cr_error *err) {
    const struct cr_participant *part = &result->resolved.part[body];
    const struct cr_outcome *o = &result->solution->body[body];
    *out = (struct cr_body_voxels){0};
    if (part->kind != CR_KIND_VEHICLE) {
        cr_err_set(err, CR_ERR_NAME, "%s is an object, it has no vehicle model", part->id);
        cr_err_hint(err, "name a vehicle");
        return CR_ERR_NAME;
    }
    struct cr_model_query query = query_of(result, body);
    struct cr_voxels *v = &out->voxels;
    enum cr_err code = cr_model_voxels(lib, &query, &out->arena, v, err);
    if (code != CR_ERR_OK) {
        goto out;
    }
    snprintf(v->name, sizeof v->name, "%.20s  %s", part->id, cr_type_word(part->type));
    size_t n = (size_t)v->nx * (size_t)v->ny * (size_t)v->nz;
    double *ees = cr_arena_take(&out->arena, n, sizeof *ees);
    if (ees == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the model of %s", part->id);
        goto out;
    }
    code = cr_voxels_ees(v, ees, err);
    out->projection =
        (struct cr_projection){.voxels = v, .ees = ees, .face = result->of[body].face};
    if (o->left != NULL) {
        out->projection.grid = cr_result_grid(result, body);
        out->projection.left = o->left;
    }
out:
    if (code != CR_ERR_OK) {
        cr_body_voxels_fini(out);
    }
    return code;
}

void cr_body_voxels_fini(struct cr_body_voxels *body) {
    cr_arena_free(&body->arena);
}
