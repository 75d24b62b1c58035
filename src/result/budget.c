/* What a scene may cost: an estimate before it is solved, limits while it is, and the words for
 * what makes it so expensive. */
#include "result/result_priv.h"

#include <math.h>
#include <stdio.h>

/* Bytes that solver and model take per voxel of a vehicle. 55 were measured; the estimate lies
 * above because a scene that is let through must really fit. */
static const double voxel_bytes = 64;

/* Counts the voxels of all participants that move, seen from above, as compiling will make them. */
static double voxels(const struct cr_scene *scene) {
    double n = 0;
    for (int i = 0; i < scene->n; i++) {
        const struct cr_participant *p = &scene->part[i];
        double cells = ceil(p->length / scene->set.voxel) * ceil(p->width / scene->set.voxel);
        n += isfinite(cells) && p->mass > 0 ? cells : 0;
    }
    return n;
}

/* Time that the solver works through before the last of the trajectories has ended, s. */
static double approach_s(const struct cr_scene *scene) {
    double from = 0, to = 0;
    for (int i = 0; i < scene->n; i++) {
        const struct cr_participant *p = &scene->part[i];
        if (p->waypoints > 0) {
            from = fmin(from, p->waypoint[0].t);
            to = fmax(to, p->waypoint[p->waypoints - 1].t);
        }
    }
    return to - from;
}

enum cr_err cr_result_too_expensive(const struct cr_scene *scene, const struct cr_context *ctx,
                                    bool time, struct cr_error *err) {
    const struct cr_settings *set = &scene->set;
    double cells = voxels(scene), approach = approach_s(scene);
    if (time) {
        char wait[48] = "";
        if (ctx->max_wait > 0) {
            snprintf(wait, sizeof wait, " or %g s by the clock", ctx->max_wait);
        }
        cr_err_set(err, CR_ERR_EXPENSIVE, "too expensive: not solved within %g s of work%s",
                   ctx->max_seconds, wait);
    } else {
        cr_err_set(err, CR_ERR_EXPENSIVE, "too expensive: it takes more than %.0f MB",
                   ctx->max_bytes / 1e6);
    }
    const char *more = time ? "allow more with --max-seconds" : "allow more with --max-memory";
    if (cells > 4e6) {
        cr_err_hint(err, "its vehicles have %.3g million voxels: raise voxel_mm, %g now; or %s",
                    cells / 1e6, 1e3 * set->voxel, more);
    } else if (approach > 1000) {
        cr_err_hint(err,
                    "its trajectories last %.4g s: leave out what is long before the crash; "
                    "or %s",
                    approach, more);
    } else {
        cr_err_hint(err, "it works in slices of %g ms%s: raise dt_ms%s; or %s", 1e3 * set->dt,
                    set->end == CR_END_REST ? ", until all stand still" : "",
                    set->end == CR_END_REST ? ", or end at separation" : "", more);
    }
    return CR_ERR_EXPENSIVE;
}

enum cr_err cr_result_afford(const struct cr_scene *scene, const struct cr_context *ctx,
                             struct cr_error *err) {
    if (ctx->max_bytes > 0 && voxel_bytes * voxels(scene) > ctx->max_bytes) {
        return cr_result_too_expensive(scene, ctx, false, err);
    }
    return CR_ERR_OK;
}

bool cr_result_outgrown(const struct cr_solution *sol, const struct cr_context *ctx) {
    double bytes =
        (double)sol->samples * ((double)sol->bodies * sizeof *sol->trace + sizeof *sol->t) +
        (double)sol->slices * sizeof *sol->slice;
    return ctx->max_bytes > 0 && bytes > ctx->max_bytes;
}
