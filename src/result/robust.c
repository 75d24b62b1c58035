/* Solves a scene again with grid, time slice, places and masses nudged: the spread of each number
 * tells whether it is resolved or chance. */
#include "result/robust.h"

#include "base/random.h"
#include "result/result_priv.h"
#include "scene/keys.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double grid_nudge = 0.1, slice_nudge = 0.1, place_nudge = 1e-3, mass_nudge = 5e-3;
/* A spread above this share of the number is too large. */
static const double resolved_share = 0.05;

/* The measures that are judged. A spread below the floor, in the measure's unit, is fine whatever
 * its share: of a small number any spread is a large share. */
static const struct {
    const char *name;
    double floor;
} judged[] = {
    {"ees", 0.5},              /* km/h */
    {"delta_v", 0.5},          /* km/h */
    {"deformation_max", 0.01}, /* m */
    {"yaw_rate_change", 5},    /* deg/s */
    {"acceleration_max", 1},   /* g */
    {"pulse", 2},              /* ms */
};

static double judged_floor(const struct cr_measure *m) {
    for (size_t i = 0; i < sizeof judged / sizeof judged[0]; i++) {
        if (strcmp(judged[i].name, m->name) == 0) {
            const struct cr_unit *unit = cr_measure_unit(m);
            return judged[i].floor * unit->mul / unit->div;
        }
    }
    return NAN;
}

bool cr_robust_is_judged(const struct cr_measure *m) {
    return !isnan(judged_floor(m));
}

double cr_robust_spread(const struct cr_robust *robust, int part, int measure) {
    long at = (long)part * robust->measures + measure;
    return (robust->most[at] - robust->least[at]) / 2;
}

static bool is_angle(const struct cr_measure *m) {
    return m->dim == CR_DIM_ANGLE;
}

double cr_robust_share(const struct cr_result *r, int part, int measure) {
    int n;
    const struct cr_measure *m = &cr_measures(&n)[measure];
    double value = fabs(cr_measure_get(m, &r->of[part]));
    double spread = cr_robust_spread(r->robust, part, measure);
    /* Of a number that moves by more than itself a share says nothing. */
    return is_angle(m) || !(spread <= value) || value == 0 ? (double)NAN : spread / value;
}

bool cr_robust_is_unresolved(const struct cr_result *r, int part, int measure) {
    int n;
    double least = judged_floor(&cr_measures(&n)[measure]);
    double spread = cr_robust_spread(r->robust, part, measure);
    double share = cr_robust_share(r, part, measure);
    /* Without a share the number is smaller than its spread, which is then too large. */
    return spread > least && !(share <= resolved_share);
}

/* Takes back the warnings of an earlier check. */
static void take_warnings_back(struct cr_result *r) {
    int kept = 0;
    for (int i = 0; i < r->warnings; i++) {
        if (strcmp(r->warning_code[i], "not-resolved") != 0) {
            memmove(r->warning[kept], r->warning[i], sizeof r->warning[0]);
            memmove(r->warning_code[kept++], r->warning_code[i], sizeof r->warning_code[0]);
        }
    }
    r->warnings = kept;
}

enum cr_err cr_robust_begin(struct cr_result *r, struct cr_error *err) {
    int n;
    const struct cr_measure *m = cr_measures(&n);
    size_t numbers = (size_t)n * (size_t)r->resolved.n;
    take_warnings_back(r);
    free(r->robust);
    r->robust = calloc(1, sizeof *r->robust + 2 * numbers * sizeof r->robust->number[0]);
    if (r->robust == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to check how robust the result is");
    }
    r->robust->measures = n;
    r->robust->least = r->robust->number;
    r->robust->most = r->robust->number + numbers;
    for (int p = 0; p < r->resolved.n; p++) {
        for (int i = 0; i < n; i++) {
            long at = (long)p * n + i;
            r->robust->least[at] = r->robust->most[at] = cr_measure_get(&m[i], &r->of[p]);
        }
    }
    return CR_ERR_OK;
}

/* The next number -1..1 of a fixed sequence. */
static double next(uint64_t *state) {
    return (double)(cr_random(state) >> 11) * 0x1p-52 - 1;
}

/* Moves a participant. It gets a place of its own first, else resolving the scene would put it back
 * where its place relation says. */
static void move(struct cr_participant *p, struct cr_vec2 by) {
    cr_scene_unplace(p);
    p->pos = cr_vec2_add(p->pos, by);
    for (int i = 0; i < p->waypoints; i++) {
        p->waypoint[i].pos = cr_vec2_add(p->waypoint[i].pos, by);
    }
}

/* Makes a participant heavier. NaN, a value that nobody gave, stays NaN. */
static void weigh(struct cr_participant *p, double factor) {
    p->mass *= factor;
    p->kerb_mass *= factor;
    p->load *= factor;
    p->yaw_inertia *= factor;
}

/* Keeps the value of a setting, SI, in the setting's range and below `most`. */
static double kept(double x, const char *key, double most) {
    const struct cr_key *k = cr_scene_key_find(CR_KEYS_SETTINGS, key, 0);
    const struct cr_unit *unit = cr_scene_key_unit(k);
    return cr_clamp(x, cr_unit_to_si(unit, k->lo), fmin(most, cr_unit_to_si(unit, k->hi)));
}

static void nudge(struct cr_scene *scene, int which) {
    uint64_t state = (uint64_t)which * 1000003U;
    struct cr_settings *set = &scene->set;
    set->voxel = kept(set->voxel * (1 + grid_nudge * next(&state)), "voxel_mm", INFINITY);
    set->dt = kept(set->dt * (1 - slice_nudge * fabs(next(&state))), "dt_ms", set->dt);
    for (int i = 0; i < scene->n; i++) {
        double dx = place_nudge * next(&state), dy = place_nudge * next(&state);
        move(&scene->part[i], cr_vec2(dx, dy));
        weigh(&scene->part[i], 1 + mass_nudge * next(&state));
    }
}

static void widen(struct cr_result *r, const struct cr_result *other) {
    struct cr_robust *robust = r->robust;
    const struct cr_measure *m = cr_measures(&robust->measures);
    for (int p = 0; p < r->resolved.n; p++) {
        for (int i = 0; i < robust->measures; i++) {
            long at = (long)p * robust->measures + i;
            double given = cr_measure_get(&m[i], &r->of[p]);
            double x = cr_measure_get(&m[i], &other->of[p]);
            x = is_angle(&m[i]) ? given + cr_angle_wrap(x - given) : x;
            robust->least[at] = fmin(robust->least[at], x);
            robust->most[at] = fmax(robust->most[at], x);
        }
    }
}

enum cr_err cr_robust_step(struct cr_result *r, const struct cr_context *ctx,
                           struct cr_error *err) {
    struct cr_scene scene;
    struct cr_result *other = NULL;
    struct cr_error own = {0};
    struct cr_context plain = *ctx;
    plain.keep = false;
    enum cr_err code = cr_scene_copy(&r->resolved, &scene, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    nudge(&scene, r->robust->solves + 1);
    code = cr_result_run(&scene, &plain, &other, &own);
    cr_scene_fini(&scene);
    if (code == CR_ERR_INTERRUPTED || code == CR_ERR_MEMORY || code == CR_ERR_EXPENSIVE) {
        if (err != NULL) {
            *err = own;
        }
        return code;
    }
    r->robust->solves++;
    if (code == CR_ERR_OK) {
        widen(r, other);
    } else {
        snprintf(r->robust->failure, sizeof r->robust->failure, "%.199s",
                 r->robust->failed > 0 ? r->robust->failure : own.text);
        r->robust->failed++;
    }
    cr_result_free(other);
    return CR_ERR_OK;
}

static void warn_of(struct cr_result *r, int part, int measure) {
    int n;
    const struct cr_measure *m = &cr_measures(&n)[measure];
    const struct cr_unit *unit = cr_measure_unit(m);
    double scale = unit->div / unit->mul, value = cr_measure_get(m, &r->of[part]);
    char spread[32], given[32], share[32] = "";
    cr_measure_text(m, scale * cr_robust_spread(r->robust, part, measure), spread, sizeof spread);
    cr_measure_text(m, scale * value, given, sizeof given);
    if (isfinite(cr_robust_share(r, part, measure))) {
        snprintf(share, sizeof share, " (%.0f %%)", 100 * cr_robust_share(r, part, measure));
    }
    cr_result_warn(r, "not-resolved",
                   "%s: %s %s %s is not resolved: it moves by +-%s%s as grid, place and mass are "
                   "nudged; see what happens there, give an interval",
                   r->resolved.part[part].id, m->name, given, m->unit, spread, share);
}

void cr_robust_end(struct cr_result *r) {
    const struct cr_robust *robust = r->robust;
    for (int p = 0; p < r->resolved.n; p++) {
        for (int i = 0; i < robust->measures; i++) {
            if (cr_robust_is_unresolved(r, p, i)) {
                warn_of(r, p, i);
            }
        }
    }
    if (robust->failed > 0) {
        cr_result_warn(r, "not-resolved", "%d of %d nudged solves have no result: %.110s",
                       robust->failed, robust->solves, robust->failure);
    }
}
