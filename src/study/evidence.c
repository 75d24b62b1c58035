/* Reads evidence as it is typed, "dv.A=43km/h", and finds its counterpart in a result. */
#include "study/fit.h"

#include "scene/keys.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Usual tolerances, half widths that hold 95 %: recorders are good to a tenth (49 CFR 563), a tape
 * along a bent car to 3 cm, a place of rest to half a metre. */
static const double relative = 0.10, tape = 0.03, place = 0.5, least_speed = 0.5;

/* Splits "dv.A" or "A.dv" into the participant, -1 without, and the other word. */
static int split(const struct cr_scene *scene, const char *name, char *word, size_t size) {
    const char *dot = strchr(name, '.');
    for (int i = 0; i < scene->n && dot != NULL; i++) {
        const char *id = scene->part[i].id;
        size_t n = strlen(id);
        if (strcmp(dot + 1, id) == 0) {
            snprintf(word, size, "%.*s", (int)(dot - name), name);
            return i;
        }
        if ((size_t)(dot - name) == n && strncmp(name, id, n) == 0) {
            snprintf(word, size, "%s", dot + 1);
            return i;
        }
    }
    return -1;
}

static enum cr_err unknown(const struct cr_scene *scene, const char *name, struct cr_error *err) {
    cr_err_set(err, CR_ERR_NAME, "'%.60s' is no evidence", name);
    cr_err_hint(err, "dv.%s, ees.%s, crush.%s, rest.%s or another result of a participant",
                scene->n > 0 ? scene->part[0].id : "A", scene->n > 0 ? scene->part[0].id : "A",
                scene->n > 0 ? scene->part[0].id : "A", scene->n > 0 ? scene->part[0].id : "A");
    return CR_ERR_NAME;
}

static enum cr_err push(struct cr_fit_evidence *e, const struct cr_fit_target *t,
                        struct cr_error *err) {
    for (int i = 0; i < e->n; i++) {
        if (strcmp(e->target[i].name, t->name) == 0) {
            return cr_err_set(err, CR_ERR_DUPLICATE, "%s is given twice", t->name);
        }
    }
    /* The search squares these numbers: they must be within reason, which NaN is not. */
    if (!(fabs(t->value) < 1e9 && t->half > 1e-9 && t->half < 1e9)) {
        cr_err_set(err, CR_ERR_RANGE, "%s: %.3g +- %.3g %s is beyond all measure", t->name,
                   cr_unit_from_si(t->unit, t->value), cr_unit_from_si(t->unit, t->half),
                   t->unit->name);
        return CR_ERR_RANGE;
    }
    if (e->n == CR_FIT_TARGETS) {
        return cr_err_set(err, CR_ERR_RANGE, "more than %d measured numbers", CR_FIT_TARGETS);
    }
    e->target[e->n++] = *t;
    return CR_ERR_OK;
}

/* Reads the n lengths of a list, m; a unit behind the last counts for all. */
static enum cr_err read_list(const char *text, double *out, int n, const char *what,
                             struct cr_error *err) {
    const struct cr_unit *unit = cr_unit_find("m", CR_DIM_LENGTH);
    const char *last = strrchr(text, ','), *end;
    char word[64];
    if (last != NULL) {
        cr_number_scan(last + 1, &end);
        unit = *end != '\0' && cr_unit_find(end, CR_DIM_LENGTH) != NULL
                   ? cr_unit_find(end, CR_DIM_LENGTH)
                   : unit;
    }
    const char *at = text;
    for (int i = 0; i < n; i++) {
        size_t len = strcspn(at, ",");
        bool ends = at[len] == '\0';
        if (len >= sizeof word || ends != (i == n - 1)) {
            cr_err_set(err, CR_ERR_TYPE, "'%.60s' is not %s", text, what);
            cr_err_hint(err, n == 2 ? "for example rest.A=12,3m"
                                    : "for example crush.A=12,14,20,22,18,10cm");
            return CR_ERR_TYPE;
        }
        snprintf(word, sizeof word, "%.*s", (int)len, at);
        enum cr_err code = cr_unit_parse(word, CR_DIM_LENGTH, unit, &out[i], NULL, err);
        if (code != CR_ERR_OK) {
            return code;
        }
        at += len + !ends;
    }
    return CR_ERR_OK;
}

static enum cr_err add_crush(struct cr_fit_evidence *e, int part, const char *id, const char *value,
                             struct cr_error *err) {
    double depth[CR_PROFILE];
    enum cr_err code = read_list(value, depth, CR_PROFILE, "six depths C1 to C6", err);
    for (int i = 0; i < CR_PROFILE && code == CR_ERR_OK; i++) {
        struct cr_fit_target t = {.kind = CR_FIT_STATION,
                                  .participant = part,
                                  .index = i,
                                  .value = depth[i],
                                  .half = tape,
                                  .unit = cr_unit_find("cm", CR_DIM_LENGTH),
                                  .decimals = 0};
        snprintf(t.name, sizeof t.name, "crush.%s C%d", id, i + 1);
        code = push(e, &t, err);
    }
    return code;
}

static enum cr_err add_rest(struct cr_fit_evidence *e, int part, const char *id, const char *value,
                            struct cr_error *err) {
    double at[2];
    enum cr_err code = read_list(value, at, 2, "a place x,y", err);
    for (int i = 0; i < 2 && code == CR_ERR_OK; i++) {
        struct cr_fit_target t = {.kind = i == 0 ? CR_FIT_REST_X : CR_FIT_REST_Y,
                                  .participant = part,
                                  .value = at[i],
                                  .half = place,
                                  .unit = cr_unit_find("m", CR_DIM_LENGTH),
                                  .decimals = 1};
        snprintf(t.name, sizeof t.name, "rest.%s %c", id, "xy"[i]);
        code = push(e, &t, err);
    }
    e->to_rest = e->to_rest || code == CR_ERR_OK;
    return code;
}

static enum cr_err add_measure(struct cr_fit_evidence *e, const struct cr_measure *m, int part,
                               const char *name, const char *value, struct cr_error *err) {
    int n;
    struct cr_fit_target t = {.kind = CR_FIT_MEASURE,
                              .participant = part,
                              .index = (int)(m - cr_measures(&n)),
                              .unit = cr_measure_unit(m),
                              .decimals = m->decimals};
    struct cr_tolerance how;
    snprintf(t.name, sizeof t.name, "%.80s", name);
    enum cr_err code;
    if (cr_tolerance_is(value)) {
        code = cr_tolerance_read(value, m->dim, t.unit, &t.value, &how, err);
        t.half = how.half;
    } else {
        code = cr_unit_parse(value, m->dim, t.unit, &t.value, NULL, err);
        t.half = m->dim == CR_DIM_LENGTH ? tape : fabs(relative * t.value);
        t.half = m->dim == CR_DIM_SPEED ? fmax(t.half, least_speed) : t.half;
        t.half = m->dim == CR_DIM_ANGLE ? cr_rad(5) : t.half;
        t.half = t.half > 0 ? t.half : cr_unit_to_si(t.unit, 1);
    }
    return code == CR_ERR_OK ? push(e, &t, err) : code;
}

enum cr_err cr_fit_add(struct cr_fit_evidence *evidence, const struct cr_scene *scene,
                       const char *name, const char *value, struct cr_error *err) {
    char word[64];
    if (value == NULL) {
        cr_err_set(err, CR_ERR_SYNTAX, "'%.60s' is no EVIDENCE=VALUE", name);
        cr_err_hint(err, CR_FIT_EVIDENCE_HINT);
        return CR_ERR_SYNTAX;
    }
    int part = split(scene, name, word, sizeof word);
    if (part < 0) {
        return unknown(scene, name, err);
    }
    if (strcmp(word, "crush") == 0) {
        return add_crush(evidence, part, scene->part[part].id, value, err);
    }
    if (strcmp(word, "rest") == 0) {
        return add_rest(evidence, part, scene->part[part].id, value, err);
    }
    const struct cr_measure *m =
        cr_measure_find(strcmp(word, "yaw") == 0 ? "yaw_rate_after" : word);
    return m != NULL ? add_measure(evidence, m, part, name, value, err) : unknown(scene, name, err);
}

double cr_fit_found(const struct cr_result *r, const struct cr_fit_target *t) {
    const struct cr_severity *s = &r->of[t->participant];
    int n;
    if (t->kind == CR_FIT_MEASURE) {
        double x = cr_measure_get(&cr_measures(&n)[t->index], s);
        bool angle = cr_measures(&n)[t->index].dim == CR_DIM_ANGLE;
        return angle ? t->value + remainder(x - t->value, 2 * CR_PI) : x;
    }
    if (t->kind == CR_FIT_STATION) {
        return s->profile[t->index];
    }
    const struct cr_outcome *o = &r->solution->body[t->participant];
    if (!isfinite(o->t_rest)) { /* a participant that still moves has no place of rest */
        return (double)NAN;
    }
    return t->kind == CR_FIT_REST_X ? o->rest.pos.x : o->rest.pos.y;
}

void cr_fit_bounds(const char *key, double now, double *lo, double *hi) {
    /* Bounds are a half width about the value, absolute (SI) or as a share of it; or fixed, lo and
     * hi (SI), where both half widths are 0. */
    static const struct {
        const char *word;
        double lo, hi, about, share;
    } rules[] = {
        {"speed", 0, 150 / 3.6, 0, 0},
        {"overlap", 0.05, 1, 0, 0},
        {"angle", 0, 0, 30 * CR_PI / 180, 0},
        {"heading", 0, 0, 30 * CR_PI / 180, 0},
        {"course", 0, 0, 30 * CR_PI / 180, 0},
        {"at", 0, 0, 1, 0},
        {"mass", 0, 0, 0, 0.2},
        {"yaw_rate", 0, 0, CR_PI / 3, 0},
        {"yawrate", 0, 0, CR_PI / 3, 0},
        {"inertia", 0, 0, 0, 0.3},
        {"yaw_inertia", 0, 0, 0, 0.3},
        {"brake", 0, 1, 0, 0},
        {"restitution", 0, 0.5, 0, 0},
        {"road", 0.2, 1, 0, 0},
        {"friction", 0, 1, 0, 0},
        {"model.energy_factor", 0.4, 2.5, 0, 0},
    };
    const char *dot = strchr(key, '.'), *word = dot != NULL ? dot + 1 : key;
    *lo = now - fabs(now) - 1;
    *hi = now + fabs(now) + 1;
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; i++) {
        if (strncmp(word, rules[i].word, strlen(rules[i].word)) == 0) {
            double half = rules[i].about + rules[i].share * fabs(now);
            *lo = half > 0 ? now - half : rules[i].lo;
            *hi = half > 0 ? now + half : rules[i].hi;
            return;
        }
    }
}
