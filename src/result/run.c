/* Leads from a scene to its result. Which model each vehicle gets depends on the direction of the
 * force, and that on the models, so a coarse trial solve goes first (share/doc/method.md, "PDOF of
 * the model"). */
#include "result/result_priv.h"

#include "base/elementary.h"
#include "scene/compiled.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The trial's voxels and time slices; they are never finer than the scene's own. */
static const double trial_voxel = 0.1; /* m */
static const double trial_dt = 2e-3;   /* s */

/* Velocity (world, m/s), place and heading of a participant at the end of its approach. */
static struct cr_vec2 approach(const struct cr_participant *p, struct cr_vec2 *pos,
                               double *heading) {
    *pos = p->pos;
    *heading = p->heading;
    double speed = p->speed, course = isfinite(p->course) ? p->course : p->heading;
    if (p->waypoints > 0) {
        const struct cr_waypoint *w = &p->waypoint[p->waypoints - 1];
        *pos = w->pos;
        *heading = w->heading;
        speed = w->speed;
        course = w->heading;
        if (p->waypoints > 1) {
            struct cr_vec2 way = cr_vec2_sub(w->pos, w[-1].pos);
            course = cr_vec2_len(way) > 0 ? cr_atan2(way.y, way.x) : course;
        }
    }
    speed = isfinite(speed) ? speed : 0;
    return cr_vec2_scale(cr_vec2_toward(course), speed);
}

/* Guesses the PDOF, rad: the impulse of a full impact with friction works along the relative
 * velocity to the participant that will be met first. */
static double guess_pdof(const struct cr_scene *scene, int i) {
    struct cr_vec2 pos, from;
    double heading, unused, soonest = INFINITY;
    struct cr_vec2 vel = approach(&scene->part[i], &pos, &heading), push = {0, 0};
    for (int k = 0; k < scene->n; k++) {
        if (k == i) {
            continue;
        }
        struct cr_vec2 rel = cr_vec2_sub(approach(&scene->part[k], &from, &unused), vel);
        struct cr_vec2 way = cr_vec2_sub(pos, from);
        double speed2 = cr_vec2_dot(rel, rel);
        /* Time until the reference points are nearest. One that lies in the past comes after all
         * that lie ahead, but before none. */
        double t = speed2 > 0 ? cr_vec2_dot(way, rel) / speed2 : (double)INFINITY;
        t = t < 0 && speed2 > 0 ? 1e3 - t : t;
        if (t < soonest) {
            soonest = t;
            push = rel;
        }
    }
    if (!(cr_vec2_len(push) > 0)) {
        return 0;
    }
    return cr_result_pdof(cr_vec2_turn(push, -heading));
}

/* Whether the direction of the force, which only a solve tells, chooses the sector of the model. */
static bool is_auto(const struct cr_participant *p) {
    return p->kind == CR_KIND_VEHICLE && p->model.kind != CR_MODEL_FILE &&
           p->model.pdof_kind == CR_PDOF_AUTO && !cr_scene_by_push(p);
}

/* Reads the PDOF of every participant whose velocity changed; the others keep theirs. */
static void read_pdof(const struct cr_solution *sol, double pdof[CR_BODY_MAX]) {
    for (int i = 0; i < sol->bodies; i++) {
        const struct cr_outcome *o = &sol->body[i];
        if (cr_vec2_len(o->delta_v) > 0) {
            pdof[i] = cr_result_pdof(cr_vec2_turn(o->delta_v, -o->before.heading));
        }
    }
}

/* A solve under way, for its limits and for whoever watches it. */
struct watched {
    const struct cr_context *ctx;
    struct cr_solver *solver;
    const struct cr_compiled *compiled;
    long polls;
    bool late, large; /* it was ended because its time is up, or its record too large */
};

enum { LOOK_EVERY = 4096 }; /* polls; to bring the solution up to date takes time */

static int poll_watched(void *user) {
    struct watched *w = user;
    if (++w->polls % LOOK_EVERY == 0 && cr_solver_touched(w->solver)) {
        w->large = cr_result_outgrown(cr_solver_solution(w->solver), w->ctx);
        if (w->large) {
            return CR_CANCEL_USER;
        }
    }
    if (w->ctx->watch != NULL) {
        w->ctx->watch(w->ctx->user, w->solver, w->compiled);
    }
    int cancel = w->ctx->cancel != NULL ? w->ctx->cancel(w->ctx->user) : CR_CANCEL_NO;
    w->late = cancel == CR_CANCEL_TIME;
    return cancel;
}

/* Tells an overlap at the start by the names of the scene, with the way out. */
static void name_overlap(const struct cr_scene *scene, const struct cr_case *cs,
                         struct cr_error *err) {
    struct cr_overlap found;
    if (!cr_solver_overlap(cs, &found)) {
        return;
    }
    const struct cr_participant *p = &scene->part[found.mover];
    struct cr_vec2 to = cr_vec2_add(p->waypoints > 0 ? p->waypoint[0].pos : p->pos, found.by);
    cr_err_set(err, CR_ERR_OVERLAP, "\"%s\" and \"%s\" overlap at the start by %.2g m2",
               scene->part[found.a].id, scene->part[found.b].id, found.area);
    snprintf(err->where, sizeof err->where, "/participants/%d/%s", found.mover,
             p->waypoints > 0 ? "trajectory" : "position_m");
    if (isfinite(found.by.x)) {
        cr_err_hint(err, "move \"%s\" by %.2f m or more, to x=%.2f m y=%.2f m", p->id,
                    cr_vec2_len(found.by), to.x, to.y);
    } else {
        cr_err_hint(err, "move them apart");
    }
}

enum cr_err cr_result_solver(const struct cr_scene *scene, const struct cr_case *cs,
                             struct cr_solver **out, struct cr_error *err) {
    enum cr_err code = cr_solver_new(cs, out, err);
    if (code == CR_ERR_OVERLAP && err) {
        name_overlap(scene, cs, err);
    }
    return code;
}

/* Compiles and solves. The caller owns compiled and solver after success, and also after
 * INTERRUPTED if ctx->keep left something (*solver is then not NULL). */
static enum cr_err solve(const struct cr_scene *scene, const struct cr_context *ctx,
                         const double pdof[CR_BODY_MAX], struct cr_compiled *compiled,
                         struct cr_solver **solver, struct cr_error *err) {
    *solver = NULL;
    enum cr_err code = cr_scene_compile(scene, ctx->models, pdof, compiled, err);
    if (code) {
        return code;
    }
    code = cr_result_solver(scene, &compiled->cs, solver, err);
    struct watched watched = {.ctx = ctx, .solver = *solver, .compiled = compiled};
    code = code ? code : cr_solver_run(*solver, poll_watched, &watched, err);
    if (watched.late || watched.large) {
        code = cr_result_too_expensive(scene, ctx, watched.late, err);
    }
    bool part = code == CR_ERR_INTERRUPTED && ctx->keep && cr_solver_solution(*solver)->samples > 0;
    if (code && !part) {
        cr_solver_free(*solver);
        *solver = NULL;
        cr_compiled_fini(compiled);
    }
    return code;
}

static enum cr_err trial(const struct cr_scene *scene, const struct cr_context *ctx,
                         double pdof[CR_BODY_MAX], struct cr_error *err) {
    struct cr_scene coarse;
    struct cr_compiled compiled;
    struct cr_solver *solver;
    enum cr_err code = cr_scene_copy(scene, &coarse, err);
    if (code) {
        return code;
    }
    coarse.set.voxel = fmax(coarse.set.voxel, trial_voxel);
    coarse.set.dt = fmax(coarse.set.dt, trial_dt);
    coarse.set.end = CR_END_SEPARATION;
    struct cr_context all = *ctx;
    all.keep = false;
    code = solve(&coarse, &all, pdof, &compiled, &solver, err);
    if (!code) {
        read_pdof(cr_solver_solution(solver), pdof);
        cr_solver_free(solver);
        cr_compiled_fini(&compiled);
    }
    cr_scene_fini(&coarse);
    return code;
}

/* Whether the PDOF chooses another model for direction b than for a. */
static bool moved(const struct cr_participant *p, double a, double b) {
    return is_auto(p) && cr_pdof_clock(a) != cr_pdof_clock(b);
}

static int first_moved(const struct cr_scene *scene, const double *a, const double *b) {
    for (int i = 0; i < scene->n; i++) {
        if (moved(&scene->part[i], a[i], b[i])) {
            return i;
        }
    }
    return -1;
}

/* Solves until the models fit the force that comes out: trial, solve, at most one repeat. */
static enum cr_err settle(struct cr_result *r, const struct cr_context *ctx, struct cr_error *err) {
    const struct cr_scene *scene = &r->resolved;
    double pdof[CR_BODY_MAX] = {0}, found[CR_BODY_MAX];
    bool any = false;
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < scene->n; i++) {
        pdof[i] = scene->part[i].kind == CR_KIND_VEHICLE ? guess_pdof(scene, i) : 0;
        any = any || is_auto(&scene->part[i]);
    }
    if (any) {
        code = trial(scene, ctx, pdof, err);
        r->passes++;
    }
    for (int pass = 0; pass < 2 && !code; pass++) {
        code = solve(scene, ctx, pdof, r->compiled, &r->solver, err);
        r->passes++;
        r->solution = r->solver != NULL ? cr_solver_solution(r->solver) : NULL;
        if (code) {
            break;
        }
        memcpy(found, pdof, sizeof found);
        read_pdof(r->solution, found);
        int i = first_moved(scene, pdof, found);
        if (i < 0) {
            break;
        }
        if (pass > 0) {
            cr_result_warn(r, "pdof-unsettled",
                           "%s: the PDOF did not settle: model of %.0f deg, force from %.0f deg; "
                           "set \"blend\": true or a fixed \"pdof_deg\" and compare",
                           scene->part[i].id, cr_bearing_deg(pdof[i]), cr_bearing_deg(found[i]));
            break;
        }
        memcpy(pdof, found, sizeof pdof);
        cr_solver_free(r->solver);
        cr_compiled_fini(r->compiled);
        r->solver = NULL;
        r->solution = NULL;
    }
    return code;
}

static void warn_part(struct cr_result *r) {
    const struct cr_solution *sol = r->solution;
    cr_result_warn(r, "interrupted",
                   "interrupted %.1f ms after the first contact: every value is of that instant, "
                   "none of the whole crash",
                   1e3 * (sol->t[sol->samples - 1] - sol->t_contact));
}

/* Refuses a scene of rigid objects, which do not crush each other; deformable barriers do. */
static enum cr_err need_vehicle(const struct cr_scene *scene, struct cr_error *err) {
    for (int i = 0; i < scene->n; i++) {
        if (scene->part[i].kind == CR_KIND_VEHICLE || scene->part[i].shape == CR_OBJECT_BARRIER) {
            return CR_ERR_OK;
        }
    }
    cr_err_set(err, CR_ERR_MISSING, "there is no vehicle among the participants");
    cr_err_hint(err, "objects are rigid and do not crush each other: make one a vehicle");
    if (err != NULL) {
        snprintf(err->where, sizeof err->where, "/participants");
    }
    return CR_ERR_MISSING;
}

static enum cr_err check_injury(const struct cr_scene *scene, const struct cr_context *ctx,
                                struct cr_error *err) {
    enum cr_err code =
        ctx->irf != NULL ? cr_irf_check(ctx->irf, scene->set.injury, err) : CR_ERR_OK;
    if (code != CR_ERR_OK && err != NULL) {
        snprintf(err->where, sizeof err->where, "/settings/injury");
    }
    return code;
}

enum cr_err cr_result_run(const struct cr_scene *scene, const struct cr_context *ctx,
                          struct cr_result **out, struct cr_error *err) {
    *out = NULL;
    struct cr_result *r = cr_result_new();
    if (!r) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a result");
    }
    cr_scene_init(&r->scene);
    cr_scene_init(&r->resolved);
    enum cr_err code = cr_scene_copy(scene, &r->scene, err);
    code = code ? code : cr_scene_copy(scene, &r->resolved, err);
    code = code ? code : cr_scene_resolve(&r->resolved, ctx->models, &r->assumed, err);
    code = code ? code : cr_result_afford(&r->resolved, ctx, err);
    code = code ? code : need_vehicle(&r->resolved, err);
    code = code ? code : check_injury(&r->resolved, ctx, err);
    code = code ? code : settle(r, ctx, err);
    bool part = code == CR_ERR_INTERRUPTED && r->solution != NULL;
    if (ctx->irf != NULL) {
        snprintf(r->irf_hash, sizeof r->irf_hash, "%s", cr_irf_hash(ctx->irf));
    }
    enum cr_err measured = code && !part ? code : cr_result_measure(r, ctx->irf, part ? NULL : err);
    if (measured) {
        cr_result_free(r);
        return code ? code : measured;
    }
    if (part) {
        warn_part(r);
    }
    cr_result_check(r);
    cr_result_trajectories(r);
    cr_result_quality(r, ctx->models);
    *out = r;
    return code;
}

void cr_result_free(struct cr_result *result) {
    if (!result) {
        return;
    }
    for (int i = 0; i < CR_BODY_MAX; i++) {
        free(result->of[i].outline);
    }
    free(result->impact);
    free(result->robust);
    if (result->solver) {
        cr_solver_free(result->solver);
        cr_compiled_fini(result->compiled);
    }
    cr_assumed_fini(&result->assumed);
    cr_scene_fini(&result->scene);
    cr_scene_fini(&result->resolved);
    free(result);
}
