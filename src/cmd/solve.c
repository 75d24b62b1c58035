/* solve and explain: the crash as a whole, and one time slice of it with the paper's equations. */
#include "cmd/cmd_priv.h"
#include "process/clock.h"

#include "scene/compiled.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* share of the approach at first touch that the latest time slice has taken away */
static double approach_lost(const struct cr_solution *sol) {
    if (sol->slices == 0) {
        return NAN;
    }
    const struct cr_slice *c = &sol->slice[sol->slices - 1];
    double closing = sol->contact[c->contact].closing;
    return closing > 0 ? cr_clamp(1 - c->approach / closing, 0, 1) : (double)NAN;
}

/* called every time slice */
static void watch(void *user, struct cr_solver *solver, const struct cr_compiled *compiled) {
    struct cr_session *s = user;
    double elapsed;
    if (cr_work_due(s, &elapsed)) {
        const struct cr_solution *sol = cr_solver_solution(solver);
        struct cr_progress p = {.what = "SOLVING",
                                .share = approach_lost(sol),
                                .elapsed = elapsed,
                                .left = NAN,
                                .time = cr_solver_time(solver) - sol->t_contact,
                                .live = sol,
                                .cs = &compiled->cs};
        s->opts.out.progress(s->opts.out.user, &p);
    }
}

static int cancelled(void *user) {
    struct cr_session *s = user;
    double limit = s->opts.max_seconds, polled = s->work_polled;
    int cancel = cr_work_cancelled(s);
    bool looked = cancel == 0 && (s->opts.out.cancel == NULL || s->work_polled > polled);
    bool late = looked && limit > 0 &&
                (cr_clock_thread() - s->work_processor > limit ||
                 cr_clock_wall() - s->work_began > CR_MAX_WAIT * limit);
    return late ? (int)CR_CANCEL_TIME : cancel;
}

struct cr_context cr_session_context(struct cr_session *s) {
    return (struct cr_context){.models = s->models,
                               .irf = s->irf,
                               .cancel = cancelled,
                               .watch = watch,
                               .user = s,
                               .max_bytes = cr_work_max_bytes(s),
                               .max_seconds = s->opts.max_seconds,
                               .max_wait = CR_MAX_WAIT * s->opts.max_seconds,
                               .keep = true};
}

static void say_result(struct cr_session *s) {
    const struct cr_result *r = s->result;
    struct cr_str line = {0};
    cr_str_addf(&line, "%d steps", r->solution->samples);
    if (s->opts.ask) { /* a script says the same on every run */
        cr_str_addf(&line, " in %.2f s", s->work_took);
    }
    cr_str_add(&line, ": EES");
    for (int i = 0; i < r->solution->bodies; i++) {
        if (cr_result_grid(r, i)->nx > 0) {
            double ees = cr_kmh(r->of[i].ees);
            cr_units_shown(s->units, "km/h", &ees, NULL);
            cr_str_addf(&line, " %s %.1f", r->resolved.part[i].id, ees);
        }
    }
    cr_str_add(&line, ", delta-v");
    for (int i = 0; i < r->solution->bodies; i++) {
        if (cr_result_moves(r, i)) {
            double delta_v = cr_kmh(r->of[i].delta_v);
            cr_units_shown(s->units, "km/h", &delta_v, NULL);
            cr_str_addf(&line, " %s %.1f", r->resolved.part[i].id, delta_v);
        }
    }
    cr_str_addf(&line, " %s", cr_units_shown(s->units, "km/h", NULL, NULL));
    cr_say_str(s, &line);
    cr_str_fini(&line);
    for (int i = 0; i < r->warnings; i++) {
        cr_warn(s, "%s", r->warning[i]);
    }
}

/* ^C: what was solved until then is kept to be looked at, unless the whole is there already */
static void interrupted(struct cr_session *s, struct cr_result *part, struct cr_error *err) {
    if (part == NULL) {
        cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted before there was anything to show");
    } else {
        const struct cr_solution *sol = part->solution;
        cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted %.1f ms after the first contact",
                   1e3 * (sol->t[sol->samples - 1] - sol->t_contact));
    }
    if (cr_session_state(s) == CR_STATE_SOLVED) {
        cr_result_free(part);
        cr_err_hint(err, "the earlier result of this scene stays");
    } else if (part != NULL) {
        cr_err_hint(err, "%d slices are kept to look at (show, pulse, table); solve begins anew",
                    part->solution->samples);
        cr_session_take_result(s, part);
    }
}

static enum cr_err run(struct cr_session *s, struct cr_error *err) {
    struct cr_result *result = NULL;
    if (cr_session_scene(s)->n < 2) {
        cr_err_set(err, CR_ERR_MISSING, "a crash needs two participants");
        cr_err_hint(err, "try: check");
        return CR_ERR_MISSING;
    }
    enum cr_err code = cr_session_need_models(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_context ctx = cr_session_context(s);
    s->solving = true;
    cr_work_begin(s);
    code = cr_result_run(cr_session_scene(s), &ctx, &result, err);
    s->work_took = cr_work_end(s);
    s->solving = false;
    bool failed = code != CR_ERR_OK && code != CR_ERR_INTERRUPTED;
    s->failed_rev = failed ? cr_session_now(s)->rev : 0;
    if (code == CR_ERR_OK) {
        cr_session_take_result(s, result);
    } else if (code == CR_ERR_INTERRUPTED) {
        interrupted(s, result, err);
    } else if (err != NULL && err->hint[0] == '\0') {
        cr_err_hint(err, "try: check");
    }
    return code;
}

/* ---- explain ---- */

static const char *const phase_words[] = {
    [CR_PHASE_APART] = "apart",
    [CR_PHASE_PLASTIC] = "plastic compression",
    [CR_PHASE_COMPRESSION] = "elastic compression",
    [CR_PHASE_RESTITUTION] = "elastic restitution",
};

/* a coordinate without "-0.00" */
static double tidy(double x, double unit) {
    return fabs(x) < 0.5 * unit ? 0 : x;
}

/* Why F of the motion is not |F_n| of Eq. (2): J v - J^2 / 2 m_eff = E + friction
 * work, so F works over the way along itself at the mean speed of the slice (solver/kinetics.c). */
static void explain_forces(struct cr_session *s, const struct cr_slice *c) {
    double along = c->force * cr_vec2_dot(c->direction, c->normal);
    double across = c->force * fabs(cr_vec2_cross(c->normal, c->direction));
    double sum = c->energy[0] + c->energy[1] + c->friction;
    cr_say(s, "         F is not |F_n|: %.1f kN of it act along the normal, %.1f kN across it",
           1e-3 * along, 1e-3 * across);
    cr_say(s, "         (friction, snagging); and F takes E%s over the way along itself",
           c->friction >= 0.05 ? " and the friction work" : "");
    cr_say(s, "         at the mean speed of the slice, %.2f mm, Eq. (2) over s = %.2f mm at the",
           1e3 * sum / c->force, 1e3 * c->path);
    cr_say(s, "         speed before it along the normal");
}

/* An elastic phase as it was, or as far as it came where the solve was interrupted in it. */
static void explain_elastic(struct cr_session *s, const struct cr_slice *c) {
    const struct cr_solution *sol = s->result->solution;
    const struct cr_contact *pair = &sol->contact[c->contact];
    bool first = c->phase == CR_PHASE_COMPRESSION;
    bool open = sol->interrupted && isnan(pair->t_end) && pair->phase == c->phase;
    double from = first ? pair->t_plastic_end : pair->t_elastic_end;
    double to = first ? pair->t_elastic_end : pair->t_end;
    double impulse = pair->elastic_impulse;
    if (open) {
        impulse = 0;
        for (int i = 0; i < sol->slices; i++) {
            const struct cr_slice *of = &sol->slice[i];
            impulse += of->contact == c->contact && of->phase == c->phase ? of->impulse : 0;
        }
    }
    if (open || !isfinite(to)) { /* bodies that still touch when all has come to rest */
        to = sol->t[sol->samples - 1];
    }
    cr_say(
        s,
        "Eq. (1)  E = 0 J: no voxel yields, the elastic impulse of %.0f N s works over %.1f ms%s",
        impulse, 1e3 * (to - from), open ? " until ^C" : "");
}

static void explain_contact(struct cr_session *s, const struct cr_slice *c) {
    const struct cr_result *r = s->result;
    const struct cr_contact *pair = &r->solution->contact[c->contact];
    const char *a = r->resolved.part[pair->a].id, *b = r->resolved.part[pair->b].id;
    double sum = c->energy[0] + c->energy[1];
    cr_say(s, "contact %s - %s, %s", a, b, phase_words[c->phase]);
    if (c->phase == CR_PHASE_PLASTIC) {
        cr_say(s, "Eq. (1)  E = sum of E_voxel = %s %.1f J (%d voxels) + %s %.1f J (%d) = %.1f J",
               a, c->energy[0], c->deformed[0], b, c->energy[1], c->deformed[1], sum);
        if (c->induced > 0) {
            cr_say(s, "         of it induced beside the contact: %.1f J", c->induced);
        }
    } else {
        explain_elastic(s, c);
    }
    cr_say(s, "Eq. (3)  COE = sum(E_voxel p_voxel) / sum(E_voxel) = (%.3f, %.3f) m",
           tidy(c->coe.x, 1e-3), tidy(c->coe.y, 1e-3));
    if (c->phase == CR_PHASE_PLASTIC && c->path > 0) {
        cr_say(
            s, "Eq. (2)  |F_n| = E / s = %.1f J / %.5f m = %.1f kN along the normal (%.3f, %.3f)",
            sum, c->path, 1e-3 * sum / c->path, tidy(c->normal.x, 1e-3), tidy(c->normal.y, 1e-3));
    }
    cr_say(s, "         F = %.1f kN along (%.3f, %.3f): impulse %.1f N s, effective mass %.0f kg",
           1e-3 * c->force, tidy(c->direction.x, 1e-3), tidy(c->direction.y, 1e-3), c->impulse,
           c->mass_eff);
    if (c->friction >= 0.05) {
        cr_say(s, "         friction work %.1f J, which is not EES", c->friction);
    }
    if (c->phase == CR_PHASE_PLASTIC && c->path > 0 && c->force > 0) {
        explain_forces(s, c);
    }
}

static void explain_body(struct cr_session *s, int body, int sample) {
    const struct cr_result *r = s->result;
    const struct cr_sample *x = &r->solution->trace[(long)sample * r->solution->bodies + body];
    const struct cr_body *cb = &r->compiled->cs.body[body];
    const char *id = r->resolved.part[body].id;
    struct cr_vec2 total = cr_vec2_scale(x->acc, cb->mass);
    struct cr_vec2 tyres = cr_vec2_sub(total, x->force), arm = cr_vec2_sub(x->coe, x->pos);
    bool touched = cr_vec2_len(x->force) > 0;
    double moment = touched ? cr_vec2_cross(arm, x->force) : 0;
    if (cb->mass <= 0) {
        cr_say(s, "%s is fixed to the ground", id);
        return;
    }
    cr_say(s, "Eq. (4)  %s: m a = F + sum F_tyre = (%.1f, %.1f) + (%.1f, %.1f) kN", id,
           tidy(1e-3 * x->force.x, 0.1), tidy(1e-3 * x->force.y, 0.1), tidy(1e-3 * tyres.x, 0.1),
           tidy(1e-3 * tyres.y, 0.1));
    cr_say(s, "         a = (%.1f, %.1f) m/s2 for %.0f kg: %.1f g", tidy(x->acc.x, 0.1),
           tidy(x->acc.y, 0.1), cb->mass, cr_vec2_len(x->acc) / CR_G);
    if (cb->inertia > 0) {
        cr_say(s, "Eq. (5)  %s: Theta psi'' = p_F x F + sum p_tyre x F_tyre = %.2f + %.2f kN m", id,
               tidy(1e-3 * moment, 0.01), tidy(1e-3 * (cb->inertia * x->yaw_acc - moment), 0.01));
        cr_say(s, "         psi'' = %.2f rad/s2 for %.0f kg m2, arm (%.3f, %.3f) m",
               tidy(x->yaw_acc, 0.01), cb->inertia, touched ? tidy(arm.x, 1e-3) : 0,
               touched ? tidy(arm.y, 1e-3) : 0);
    }
    cr_say(s, "then     %s: v = (%.2f, %.2f) m/s, %.1f km/h; yaw rate %.1f deg/s", id,
           tidy(x->vel.x, 0.01), tidy(x->vel.y, 0.01), cr_kmh(cr_vec2_len(x->vel)),
           tidy(cr_deg(x->yaw_rate), 0.1));
    cr_say(s, "         x = %.3f m, y = %.3f m, heading %.2f deg", tidy(x->pos.x, 1e-3),
           tidy(x->pos.y, 1e-3), tidy(cr_deg(x->heading), 0.01));
}

static void explain(struct cr_session *s, int sample) {
    const struct cr_solution *sol = s->result->solution;
    double end = sol->t[sample], begin = sample > 0 ? sol->t[sample - 1] : sol->t_contact;
    bool any = false;
    cr_say(s, "time slice %d of %d: %.2f to %.2f ms after the first contact", sample + 1,
           sol->samples, 1e3 * (begin - sol->t_contact), 1e3 * (end - sol->t_contact));
    for (int i = 0; i < sol->slices; i++) {
        if (sol->slice[i].sample == sample) {
            explain_contact(s, &sol->slice[i]);
            any = true;
        }
    }
    if (!any) {
        cr_say(s, "Eq. (1)  E = 0 J: nobody touches, so only the tyres act");
    }
    for (int i = 0; i < sol->bodies; i++) {
        explain_body(s, i, sample);
    }
}

/* sample with the largest contact force */
static int peak_sample(const struct cr_solution *sol) {
    int best = 0;
    double most = -1;
    for (int i = 0; i < sol->slices; i++) {
        if (sol->slice[i].force > most) {
            most = sol->slice[i].force;
            best = sol->slice[i].sample;
        }
    }
    return best;
}

enum cr_err cr_cmd_explain(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_solution *sol = s->result->solution;
    int frame = s->view.frame > 0 ? s->view.frame : 1;
    if (cr_cmd_given(call, "slice")) {
        frame = (int)cr_cmd_number(call, "slice", 1);
        if (frame > sol->samples) {
            code =
                cr_err_set(err, CR_ERR_RANGE, "slice must be 1 to %d, got %d", sol->samples, frame);
            return cr_cmd_blame(call, "slice", code);
        }
    } else if (cr_cmd_word(call, "TIME", -1) >= 0) {
        int word = cr_cmd_word(call, "TIME", 0);
        frame = word == 0 ? 1 : word == 1 ? peak_sample(sol) + 1 : sol->samples;
    } else if (cr_cmd_given(call, "TIME")) {
        code = cr_cmd_frame_at(call, "TIME", &frame, err);
        frame = frame > 0 ? frame : 1;
    }
    if (code == CR_ERR_OK && sol->samples > 0) {
        explain(s, frame - 1);
    }
    return code;
}

/* ---- solve ---- */

static void say_steps_short(struct cr_session *s) {
    const struct cr_solution *sol = s->result->solution;
    for (int k = 0; k < sol->samples; k++) {
        const struct cr_sample *x = &sol->trace[(long)k * sol->bodies];
        struct cr_str line = {0};
        cr_str_addf(&line, "%4d %7.2f ms", k + 1, 1e3 * (sol->t[k] - sol->t_contact));
        for (int i = 0; i < sol->bodies; i++) {
            if (cr_result_moves(s->result, i)) {
                cr_str_addf(&line, "  %s %5.1f km/h %5.1f g %6.1f kJ",
                            s->result->resolved.part[i].id, cr_kmh(cr_vec2_len(x[i].vel)),
                            cr_vec2_len(x[i].acc) / CR_G, 1e-3 * x[i].energy);
            }
        }
        cr_say_str(s, &line);
        cr_str_fini(&line);
    }
}

/* the next time slice of the recorded trace; the first step solves */
static enum cr_err step(struct cr_session *s, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    if (cr_session_state(s) != CR_STATE_SOLVED) {
        code = run(s, err);
        s->view.frame = 0;
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    if (s->view.frame >= cr_session_frames(s)) {
        cr_say(s, "all %d slices are shown; show frame=0 begins again", cr_session_frames(s));
        return CR_ERR_OK;
    }
    s->view.frame++;
    explain(s, s->view.frame - 1);
    return CR_ERR_OK;
}

enum cr_err cr_cmd_solve(struct cr_call *call, struct cr_error *err) {
    if (cr_cmd_given(call, "step")) {
        return step(call->s, err);
    }
    enum cr_err code = run(call->s, err);
    if (code == CR_ERR_OK && cr_cmd_given(call, "until")) {
        code = cr_cmd_frame_at(call, "until", &call->s->view.frame, err);
    }
    if (code == CR_ERR_OK) {
        say_result(call->s);
        if (cr_cmd_given(call, "trace")) {
            say_steps_short(call->s);
        }
    }
    return code;
}
