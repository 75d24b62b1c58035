/* Warns of doubtful trajectories: speeds that contradict the path, jumps, rows that end before the
 * contact. */
#include "result/result_priv.h"

#include <math.h>
#include <stdio.h>

/* Rows are compared over at least this time, s, so that noise of the places does not matter. */
static const double window = 0.2;
/* A speed may differ from that of the path by this share and by this much, m/s. */
static const double share_most = 0.15, speed_most = 2;
/* No car is faster, m/s: more between two rows is a jump. */
static const double jump_speed = 140;
/* Rows are up to 0.1 s apart; a contact later than this after the last is not covered by them,
 * s. */
static const double cover_most = 0.1;

/* The length of the path along rows i to k, m. */
static double way(const struct cr_waypoint *w, int i, int k) {
    double sum = 0;
    for (int n = i; n < k; n++) {
        sum += cr_vec2_len(cr_vec2_sub(w[n + 1].pos, w[n].pos));
    }
    return sum;
}

/* The mean over time of the speeds that rows i to k give, m/s. */
static double told(const struct cr_waypoint *w, int i, int k) {
    double sum = 0;
    for (int n = i; n < k; n++) {
        sum += (fabs(w[n].speed) + fabs(w[n + 1].speed)) / 2 * (w[n + 1].t - w[n].t);
    }
    return sum / (w[k].t - w[i].t);
}

static void warn_speed(struct cr_result *r, const char *id, double t, double given, double path) {
    char guess[64] = "";
    if (fabs(given * 3.6 / path - 1) < share_most) {
        snprintf(guess, sizeof guess, "; as if it were in m/s");
    } else if (fabs(given / 3.6 / path - 1) < share_most) {
        snprintf(guess, sizeof guess, "; as if m/s had been turned into km/h twice");
    }
    cr_result_warn(
        r, "trajectory-speed",
        "%s: its trajectory gives %.1f km/h at %.2f s, but its path runs at %.1f km/h%s; "
        "the contact is solved with the speed given",
        id, cr_kmh(given), t, cr_kmh(path), guess);
}

/* Tells the first stretch that contradicts itself; the others would be the same fault again. */
static void check_path(struct cr_result *r, const struct cr_participant *p) {
    const struct cr_waypoint *w = p->waypoint;
    for (int i = 0; i + 1 < p->waypoints; i++) {
        double dt = w[i + 1].t - w[i].t, step = cr_vec2_len(cr_vec2_sub(w[i + 1].pos, w[i].pos));
        if (step > 0.5 && step / dt > jump_speed) {
            cr_result_warn(r, "trajectory-jump",
                           "%s: its trajectory jumps by %.1f m within %.3g s at %.2f s", p->id,
                           step, dt, w[i].t);
            return;
        }
    }
    for (int i = 0, k = 0; i < p->waypoints; i++) {
        while (k < p->waypoints - 1 && w[k].t - w[i].t < window) {
            k++;
        }
        double time = w[k].t - w[i].t;
        double path = time > 0 ? way(w, i, k) / time : 0, given = time > 0 ? told(w, i, k) : 0;
        double off = fabs(given - path);
        if (time >= window && off > speed_most && off > share_most * path) {
            warn_speed(r, p->id, w[i].t, given, path);
            return;
        }
    }
}

static void check_cover(struct cr_result *r, int i) {
    const struct cr_participant *p = &r->resolved.part[i];
    double end = p->waypoint[p->waypoints - 1].t, touch = r->solution->body[i].t_first;
    if (isfinite(touch) && touch - end > cover_most) {
        cr_result_warn(r, "trajectory-end",
                       "%s: its trajectory ends %.2f s before its contact; until then it runs on "
                       "with its last speed, course and yaw rate",
                       p->id, touch - end);
    }
}

void cr_result_trajectories(struct cr_result *r) {
    for (int i = 0; i < r->solution->bodies; i++) {
        if (r->resolved.part[i].waypoints > 1) {
            check_path(r, &r->resolved.part[i]);
            check_cover(r, i);
        }
    }
}
