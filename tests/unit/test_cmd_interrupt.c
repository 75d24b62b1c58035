/* ^C while solving: what was solved until then is kept to be looked at, and taken for no more. */
#include "test.h"

#include "cmd/cmd_priv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* who watches a solve, and stops it once so many slices have been seen */
struct watcher {
    struct cr_str said, faults;
    int stop_at; /* slices, 0: never */
    int seen;
};

static void on_text(void *user, enum cr_tone tone, const char *line) {
    struct watcher *w = user;
    (void)tone;
    cr_str_addf(&w->said, "%s\n", line);
}

static void on_fault(void *user, const struct cr_fault *fault) {
    struct watcher *w = user;
    cr_fault_text(fault, -1, &w->faults);
}

static void on_progress(void *user, const struct cr_progress *p) {
    struct watcher *w = user;
    w->seen = p != NULL && p->live != NULL ? p->live->samples : 0;
}

static int on_cancel(void *user) {
    const struct watcher *w = user;
    return w->stop_at > 0 && w->seen >= w->stop_at;
}

static struct cr_session *session(struct watcher *w) {
    struct cr_session *s;
    struct cr_error err;
    struct cr_session_opts opts = {.data_dir = getenv("SRC"),
                                   .out = {.user = w,
                                           .text = on_text,
                                           .fault = on_fault,
                                           .progress = on_progress,
                                           .cancel = on_cancel}};
    assert_int_equal(cr_session_new(&opts, &s, &err), CR_ERR_OK);
    return s;
}

static void end(struct cr_session *s, struct watcher *w) {
    cr_session_free(s);
    cr_str_fini(&w->said);
    cr_str_fini(&w->faults);
}

static void run(struct cr_session *s, struct watcher *w, const char *line) {
    cr_str_clear(&w->said);
    cr_str_clear(&w->faults);
    if (cr_session_run(s, line) != CR_ERR_OK) {
        fail_msg("%s: %s", line, cr_str_get(&w->faults));
    }
}

static void refused(struct cr_session *s, struct watcher *w, const char *line, enum cr_err code,
                    const char *why) {
    cr_str_clear(&w->said);
    cr_str_clear(&w->faults);
    assert_int_equal(cr_session_run(s, line), code);
    if (strstr(cr_str_get(&w->faults), why) == NULL) {
        fail_msg("%s: no '%s' in '%s'", line, why, cr_str_get(&w->faults));
    }
}

static const char wall[] = "vehicle A type=compact mass=1400kg speed=40km/h; object W kind=wall; "
                           "place W facing A gap=0.1m; set dt=1ms voxel=50mm";
/* so many short slices of small voxels that no machine is through its plastic phase before the
 * watcher is told of the first, after 0.3 s */
static const char slow[] = "vehicle A type=compact mass=1400kg speed=40km/h; "
                           "vehicle W type=suv mass=2000kg; place W facing A gap=0.01m; "
                           "set dt=0.001ms voxel=5mm";

static void a_part_is_kept_and_is_no_result(void **state) {
    (void)state;
    struct watcher w = {.stop_at = 5};
    struct cr_session *s = session(&w);
    char path[64], line[128];
    snprintf(path, sizeof path, "interrupted-%ld.json", (long)getpid());
    run(s, &w, slow);
    refused(s, &w, "solve", CR_ERR_INTERRUPTED, "ms after the first contact");
    assert_non_null(strstr(w.faults.s, "slices are kept"));
    assert_int_equal(cr_session_state(s), CR_STATE_INTERRUPTED);
    assert_true(cr_session_result(s)->solution->interrupted);
    int frames = cr_session_frames(s);
    assert_true(frames >= 5);
    /* its slices can be walked, its pictures drawn */
    run(s, &w, "show frame=3");
    assert_int_equal(cr_session_view(s)->frame, 3);
    run(s, &w, "explain slice=2");
    run(s, &w, "table contacts");
    assert_non_null(strstr(w.said.s, "plastic to - ms (interrupted)"));
    run(s, &w, "table results");
    assert_non_null(strstr(w.said.s, "interrupted: values of the last slice"));
    /* but nobody takes it for the crash */
    refused(s, &w, "assert A.ees > 0km/h", CR_ERR_MISSING, "no final values");
    refused(s, &w, "compare share/tutorial/reference.json", CR_ERR_MISSING, "no final values");
    snprintf(line, sizeof line, "export report %s", "interrupted.txt");
    refused(s, &w, line, CR_ERR_MISSING, "was interrupted");
    assert_int_not_equal(access("interrupted.txt", F_OK), 0);
    snprintf(line, sizeof line, "export! pulse %s", path);
    run(s, &w, line);
    unlink(path);
    /* a change makes it stale like any other, and solving begins anew */
    run(s, &w, "vehicle A speed=41km/h");
    assert_int_equal(cr_session_state(s), CR_STATE_STALE);
    w.stop_at = 0;
    run(s, &w, "set dt=1ms voxel=50mm; solve");
    assert_int_equal(cr_session_state(s), CR_STATE_SOLVED);
    assert_false(cr_session_result(s)->solution->interrupted);
    end(s, &w);
}

static int at_once(void *user) {
    (void)user;
    return 1;
}

static void nothing_worked_leaves_nothing(void **state) {
    (void)state;
    struct watcher w = {0};
    struct cr_session *s = session(&w);
    struct cr_out out = {.user = &w, .text = on_text, .fault = on_fault, .cancel = at_once};
    run(s, &w, wall);
    cr_session_set_out(s, &out);
    refused(s, &w, "solve", CR_ERR_INTERRUPTED, "before there was anything to show");
    assert_int_equal(cr_session_state(s), CR_STATE_EDITED);
    assert_null(cr_session_result(s));
    end(s, &w);
}

/* a crash that is solved already is not given up for a part of the same */
static void a_whole_result_stays(void **state) {
    (void)state;
    struct watcher w = {0};
    struct cr_session *s = session(&w);
    run(s, &w, wall);
    run(s, &w, "solve");
    int frames = cr_session_frames(s);
    w.stop_at = 1;
    w.seen = 1;
    refused(s, &w, "solve", CR_ERR_INTERRUPTED, "earlier result of this scene stays");
    assert_int_equal(cr_session_state(s), CR_STATE_SOLVED);
    assert_int_equal(cr_session_frames(s), frames);
    end(s, &w);
}

/* ---- in an elastic phase ---- */

/* who cancels a solve in the third slice of a phase, which no clock could hit */
struct phase_watcher {
    enum cr_phase phase;
    int slices;
};

static void on_solver(void *user, struct cr_solver *solver, const struct cr_compiled *compiled) {
    struct phase_watcher *w = user;
    const struct cr_solution *sol = cr_solver_solution(solver);
    (void)compiled;
    w->slices = 0;
    for (int i = 0; i < sol->slices; i++) {
        w->slices += sol->slice[i].phase == w->phase;
    }
}

static int after_three(void *user) {
    const struct phase_watcher *w = user;
    return w->slices >= 3 ? CR_CANCEL_USER : CR_CANCEL_NO;
}

static void an_elastic_phase_is_told_as_far_as_it_came(void **state) {
    (void)state;
    static const enum cr_phase phases[] = {CR_PHASE_COMPRESSION, CR_PHASE_RESTITUTION};
    for (int k = 0; k < 2; k++) {
        struct watcher w = {.stop_at = 0};
        struct phase_watcher p = {.phase = phases[k]};
        struct cr_session *s = session(&w);
        struct cr_result *part = NULL;
        char want[80];
        run(s, &w, wall);
        run(s, &w, "set elastic=20ms restitution=0.1");
        assert_int_equal(cr_session_need_models(s, NULL), CR_ERR_OK);
        const struct cr_context ctx = {.models = s->models,
                                       .watch = on_solver,
                                       .cancel = after_three,
                                       .user = &p,
                                       .keep = true};
        assert_int_equal(cr_result_run(cr_session_scene(s), &ctx, &part, NULL), CR_ERR_INTERRUPTED);
        assert_non_null(part);
        const struct cr_solution *sol = part->solution;
        double impulse = 0; /* of the three slices of 1 ms, each told with its own */
        for (int i = 0; i < sol->slices; i++) {
            impulse += sol->slice[i].phase == p.phase ? sol->slice[i].impulse : 0;
        }
        cr_session_take_result(s, part);
        run(s, &w, "explain last");
        snprintf(want, sizeof want, "elastic impulse of %.0f N s works over 3.0 ms until ^C",
                 impulse);
        assert_true(impulse > 1);
        if (strstr(w.said.s, want) == NULL) {
            fail_msg("no '%s' in %s", want, w.said.s);
        }
        end(s, &w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_part_is_kept_and_is_no_result),
        cmocka_unit_test(nothing_worked_leaves_nothing),
        cmocka_unit_test(a_whole_result_stays),
        cmocka_unit_test(an_elastic_phase_is_told_as_far_as_it_came),
    };
    return cmocka_run_group_tests_name("interrupt", tests, NULL, NULL);
}
