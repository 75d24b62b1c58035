/* show view=side: the 3D model of a vehicle from the side, above or the front, with the deformation
 * of the solve carried back onto it (the paper's Figure 3). */
#include "cmd/cmd_priv.h"

#include "render/project.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* the vehicle to be drawn: the one selected, else the first */
static int find_vehicle(const struct cr_scene *scene, const char *id) {
    int first = -1;
    for (int i = 0; i < scene->n; i++) {
        bool vehicle = scene->part[i].kind == CR_KIND_VEHICLE;
        if (vehicle && strcmp(scene->part[i].id, id) == 0) {
            return i;
        }
        first = vehicle && first < 0 ? i : first;
    }
    return first;
}

enum { TEXT_W = 72 /* columns of a picture as text, which fit the log of a large screen */ };

/* PDOF of the model that was used: "suv/11" -> 330 deg */
static double pdof_of(const struct cr_result *r, int part, const struct cr_participant *p) {
    const char *slash = r != NULL ? strrchr(r->of[part].model, '/') : NULL;
    if (p->model.pdof_kind != CR_PDOF_AUTO) {
        return p->model.pdof;
    }
    return slash != NULL ? cr_rad(30 * fmod(strtod(slash + 1, NULL), 12)) : 0;
}

static enum cr_err make_voxels(struct cr_session *s, const struct cr_scene *scene, int part,
                               struct cr_arena *arena, struct cr_voxels *out,
                               struct cr_error *err) {
    const struct cr_participant *p = &scene->part[part];
    bool solved = cr_session_fits(s);
    if (p->model.kind == CR_MODEL_FILE) {
        char path[2 * CR_PATH_MAX];
        cr_scene_model_path(scene, p, path);
        return cr_voxels_read(path, arena, out, NULL, err);
    }
    struct cr_model_query query =
        cr_scene_query(scene, p, pdof_of(solved ? s->result : NULL, part, p));
    query.voxel = fmax(query.voxel, 0.05);
    return cr_model_voxels(s->models, &query, arena, out, err);
}

struct projection_job {
    struct cr_session *s;
    struct cr_projection projection;
};

static enum cr_err draw(void *user, struct cr_cells *cells, struct cr_rect at,
                        struct cr_error *err) {
    struct projection_job *job = user;
    return cr_render_projection(cells, at, &job->s->opts.look, &job->projection, err);
}

static enum cr_err draw_vehicle(struct cr_session *s, const struct cr_scene *scene, int part,
                                enum cr_project view, struct cr_error *err) {
    struct cr_arena arena = {0};
    struct cr_voxels voxels;
    int w, h;
    enum cr_err code = make_voxels(s, scene, part, &arena, &voxels, err);
    double *ees = NULL;
    if (code == CR_ERR_OK) {
        ees = cr_arena_take(&arena, (size_t)voxels.nx * (size_t)voxels.ny * (size_t)voxels.nz,
                            sizeof *ees);
        code = ees != NULL ? cr_voxels_ees(&voxels, ees, err)
                           : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    if (code == CR_ERR_OK) {
        bool solved = cr_session_fits(s);
        const struct cr_grid *grid = solved ? cr_result_grid(s->result, part) : NULL;
        struct projection_job job = {s,
                                     {.view = view,
                                      .voxels = &voxels,
                                      .ees = ees,
                                      .grid = grid,
                                      .left = solved ? s->result->solution->body[part].left : NULL,
                                      .face = solved ? s->result->of[part].face : CR_FACE_FRONT}};
        cr_session_room(s, &w, &h);
        cr_say(s, "%s: %s", scene->part[part].id, voxels.name);
        bool screen = s->opts.out.cells == NULL;
        w = screen && w > TEXT_W ? TEXT_W : w;
        int rows = cr_render_projection_rows(&job.projection, w, h - 4);
        code = (screen ? cr_cmd_picture_text : cr_cmd_picture)(s, w, rows, draw, &job, err);
    }
    cr_arena_free(&arena);
    return code;
}

enum cr_err cr_cmd_project(struct cr_session *s, int view, struct cr_error *err) {
    struct cr_scene scene;
    enum cr_err code = cr_session_need_models(s, err);
    if (code == CR_ERR_OK) {
        code = cr_scene_copy(cr_session_scene(s), &scene, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    int part = find_vehicle(&scene, s->view.selected);
    if (part < 0) {
        cr_err_set(err, CR_ERR_MISSING, "there is no vehicle to draw");
        cr_err_hint(err, "for example: vehicle A type=compact");
        code = CR_ERR_MISSING;
    } else {
        code = cr_cmd_resolve(&scene, s->models, NULL, err);
    }
    if (code == CR_ERR_OK) {
        code = draw_vehicle(s, &scene, part, (enum cr_project)view, err);
    }
    cr_scene_fini(&scene);
    return code;
}
