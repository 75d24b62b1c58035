/* Reads what was measured of a damaged car as it is typed: depths, an outline, heights; and sets
 * the tolerance of its mass. */
#include "damage/crush.h"

#include "scene/keys.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Height of the top of bumpers, m: they are tested from 16 to 20 inches [BUMPER-ZONE]. */
static const double bumper_top = 0.508;
/* Tolerance (95 %) of a mass that was weighed or looked up, relative to it. */
static const double usual_mass = 0.03;

bool cr_crush_ride(const char *word, struct cr_measured *m) {
    bool under = strcmp(word, "under") == 0;
    if (!under && strcmp(word, "over") != 0) {
        return false;
    }
    m->z_lo = under ? bumper_top : 0;
    m->z_hi = under ? (double)INFINITY : bumper_top;
    return true;
}

void cr_crush_mass(const struct cr_participant *p, double spread, struct cr_measured *m) {
    int rows;
    const struct cr_key *first = cr_scene_keys(CR_KEYS_PARTICIPANT, &rows);
    static const char *const names[] = {"mass_kg", "kerb_mass_kg"};
    m->mass_tol = (spread > 0 ? 1.96 * spread : usual_mass) * p->mass;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const struct cr_key *key = cr_scene_key_find(CR_KEYS_PARTICIPANT, names[i], CR_FOR_VEHICLE);
        for (int k = 0; k < p->tolerances.n; k++) {
            if (p->tolerances.of[k].row == key - first) {
                m->mass_tol = p->tolerances.of[k].half;
                return;
            }
        }
    }
}

enum cr_err cr_crush_outline(const struct cr_crush_point *p, int n, struct cr_measured *m,
                             struct cr_error *err) {
    enum { EVEN = 24 };
    for (int i = 1; i < n; i++) {
        if (!(p[i].along > p[i - 1].along)) {
            cr_err_set(err, CR_ERR_RANGE, "the outline does not go on from %.3g m to %.3g m",
                       p[i - 1].along, p[i].along);
            cr_err_hint(err, "its points go from left to right, or from rear to front");
            return CR_ERR_RANGE;
        }
    }
    if (n < 2) {
        cr_err_set(err, CR_ERR_MISSING, "the outline has fewer than two points");
        cr_err_hint(err, "along and depth: -0.7 m 0.1 m, 0 m 0.3 m, 0.7 m 0.2 m");
        return CR_ERR_MISSING;
    }
    m->length = p[n - 1].along - p[0].along;
    m->offset = (p[n - 1].along + p[0].along) / 2;
    m->stations = EVEN;
    m->guessed = false;
    for (int i = 0, k = 0; i < EVEN; i++) {
        double x = p[0].along + m->length * i / (EVEN - 1);
        while (k + 2 < n && x > p[k + 1].along) {
            k++;
        }
        double u = cr_clamp((x - p[k].along) / (p[k + 1].along - p[k].along), 0, 1);
        m->depth[i] = p[k].depth + u * (p[k + 1].depth - p[k].depth);
    }
    return CR_ERR_OK;
}

/* ---- lists as they are typed ---- */

/* A list of numbers between commas. A unit behind the last number counts for all, also where a
 * tolerance stands before it ("+-2cm"). */
struct list {
    const char *at;
    const struct cr_unit *unit;
};

static struct list begin_list(const char *text) {
    struct list l = {.at = text, .unit = cr_unit_find("m", CR_DIM_LENGTH)};
    const char *letters = text + strcspn(text, "abcdefghijklmnopqrstuvwxyz\"");
    const char *end = strrchr(text, ',');
    const struct cr_unit *unit =
        end != NULL && letters > end ? cr_unit_find(letters, CR_DIM_LENGTH) : NULL;
    l.unit = unit != NULL ? unit : l.unit;
    return l;
}

/* Reads the next number, up to one of the separators; *by is the one found, '\0' at the end. */
static enum cr_err next_number(struct list *l, const char *separators, double *out, char *by,
                               struct cr_error *err) {
    char word[64];
    size_t len = strcspn(l->at, separators);
    if (len >= sizeof word) {
        return cr_err_set(err, CR_ERR_TYPE, "'%.20s...' is no length", l->at);
    }
    snprintf(word, sizeof word, "%.*s", (int)len, l->at);
    *by = l->at[len];
    l->at += len + (*by != '\0');
    return cr_unit_parse(word, CR_DIM_LENGTH, l->unit, out, NULL, err);
}

enum cr_err cr_crush_stations_read(const char *text, struct cr_measured *m, struct cr_error *err) {
    char by = ',', plain[512];
    const char *plus = strstr(text, "+-");
    m->guessed = strcmp(text, "unknown") == 0;
    m->stations = 0;
    if (m->guessed) {
        return CR_ERR_OK;
    }
    struct list l = begin_list(text);
    if (plus != NULL) { /* A tolerance behind the depths holds for all of them. */
        struct list tolerance = {.at = plus + 2, .unit = l.unit};
        enum cr_err code = next_number(&tolerance, "", &m->depth_tol, &by, err);
        if (code != CR_ERR_OK || !(m->depth_tol >= 0)) {
            return code != CR_ERR_OK ? code
                                     : cr_err_set(err, CR_ERR_RANGE, "a tolerance is not negative");
        }
        if (plus - text >= (int)sizeof plain) {
            return cr_err_set(err, CR_ERR_RANGE, "the list of stations is too long");
        }
        snprintf(plain, sizeof plain, "%.*s", (int)(plus - text), text);
        l.at = plain;
        by = ',';
    }
    while (by == ',') {
        if (m->stations == CR_STATIONS_MAX) {
            return cr_err_set(err, CR_ERR_RANGE, "more than %d stations", CR_STATIONS_MAX);
        }
        enum cr_err code = next_number(&l, ",", &m->depth[m->stations++], &by, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    return CR_ERR_OK;
}

enum cr_err cr_crush_outline_read(const char *text, struct cr_measured *m, struct cr_error *err) {
    struct cr_crush_point p[CR_CRUSH_POINTS];
    struct list l = begin_list(text);
    char by = ',';
    int n = 0;
    for (; by == ','; n++) {
        if (n == CR_CRUSH_POINTS) {
            return cr_err_set(err, CR_ERR_RANGE, "more than %d points", CR_CRUSH_POINTS);
        }
        enum cr_err code = next_number(&l, ":,", &p[n].along, &by, err);
        if (code == CR_ERR_OK && by != ':') {
            cr_err_set(err, CR_ERR_SYNTAX, "a point of the outline is ALONG:DEPTH");
            cr_err_hint(err, "for example outline=-70:10,0:30,70:20cm");
            code = CR_ERR_SYNTAX;
        }
        code = code == CR_ERR_OK ? next_number(&l, ",", &p[n].depth, &by, err) : code;
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    return cr_crush_outline(p, n, m, err);
}
