/* Playing the recorded crash in slow motion. */
#include "tui/tui_priv.h"

#include "render/picture.h"

#include <math.h>
#include <stdio.h>

#define WATCH_S 6.0 /* wall clock for the crash itself; what follows runs at the same rate */
#define LEAP_S  0.2 /* of it that one look may bring: after ^Z it goes on where it was */

/* s of the wall clock for one second of the crash */
static double slowness(const struct cr_solution *sol) {
    int n = cr_render_samples(sol);
    double span = n > 0 ? sol->t[n - 1] - sol->t_contact : 0;
    return span > 0 ? WATCH_S / span : 1;
}

static const struct cr_solution *playable(const struct cr_tui *t) {
    const struct cr_result *r = cr_session_result(t->session);
    enum cr_solve_state state = cr_session_state(t->session);
    bool fits = state == CR_STATE_SOLVED || state == CR_STATE_INTERRUPTED;
    return r != NULL && fits && r->solution->samples > 1 ? r->solution : NULL;
}

static void set_frame(struct cr_tui *t, int frame, bool logged) {
    char line[40];
    snprintf(line, sizeof line, "show frame=%d", frame);
    if (logged) {
        cr_tui_run_key(t, line);
    } else if (!cr_tui_run_quiet(t, line)) {
        t->play.on = false;
    }
}

void cr_play_start(struct cr_tui *t, int frame) {
    const struct cr_solution *sol = playable(t);
    if (sol == NULL) {
        return;
    }
    double since = frame > 0 ? sol->t[frame - 1] - sol->t_contact : 0;
    t->play = (struct cr_play){true, since, cr_clock_wall()};
    set_frame(t, frame, false);
}

void cr_play_stop(struct cr_tui *t) {
    if (t->play.on) {
        t->play.on = false;
        set_frame(t, cr_session_view(t->session)->frame, true);
    }
}

void cr_play_toggle(struct cr_tui *t) {
    int frame = cr_session_view(t->session)->frame;
    if (t->play.on) {
        cr_play_stop(t);
    } else if (playable(t) == NULL) {
        cr_dialogue_add(&t->log, CR_ROLE_WARN, "  nothing to play before  solve  (F5)");
        t->dirty = true;
    } else {
        cr_play_start(t, frame >= cr_session_frames(t->session) ? 0 : frame);
    }
}

void cr_play_tick(struct cr_tui *t) {
    const struct cr_solution *sol = t->play.on ? playable(t) : NULL;
    if (sol == NULL) {
        t->play.on = false;
        return;
    }
    const struct cr_view *view = cr_session_view(t->session);
    double now = cr_clock_wall();
    t->play.at += fmin(now - t->play.ticked, LEAP_S) * view->rate / slowness(sol);
    t->play.ticked = now;
    int frame = view->frame, last = sol->samples;
    while (frame < last && sol->t[frame] - sol->t_contact <= t->play.at) {
        frame++;
    }
    if (frame != view->frame) {
        set_frame(t, frame, false);
    }
    if (frame >= last && cr_session_view(t->session)->loop) {
        cr_play_start(t, 0);
    } else if (frame >= last) {
        cr_play_stop(t);
    }
}

void cr_play_rate(struct cr_tui *t, int step) {
    static const double rates[] = {0.1, 0.25, 0.5, 1, 2, 4};
    enum { N = sizeof rates / sizeof *rates };
    char line[40];
    int i = 0;
    while (i < N - 1 && rates[i] < cr_session_view(t->session)->rate - 1e-9) {
        i++;
    }
    i += step;
    snprintf(line, sizeof line, "play rate=%g", rates[i < 0 ? 0 : i >= N ? N - 1 : i]);
    cr_tui_run_key(t, line);
}

void cr_play_obey(struct cr_tui *t) {
    if (t->play_asked) {
        t->play_asked = false;
        if (t->play_on != t->play.on) {
            cr_play_toggle(t);
        }
    }
}
