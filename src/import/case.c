/* Keeps the case that a reader fills in: its participants, and of their rows the last seconds
 * before the first contact. */
#include "import/import_priv.h"

#include "base/grow.h"
#include "base/number.h"
#include "base/show.h"
#include "base/tree.h"
#include "scene/keys.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Rows are left behind in lots of this many, because moving the rest for each one would be slow. */
enum { LOT = 256 };
/* Where the first place lies farther than this (m) along an axis, as on maps (UTM), an origin near
 * it is chosen: a scene takes 100 km, and participants move on from there. */
static const double far_off = 50000;

static struct cr_import_part *whole(struct cr_participant *p) {
    return (struct cr_import_part *)(void *)p;
}

void cr_import_case_free(struct cr_import_case *c) {
    if (c == NULL) {
        return;
    }
    for (int i = 0; i < c->parts; i++) {
        free(c->part[i]->p.extra);
        free(c->part[i]->row);
        free(c->part[i]);
    }
    free(c->part);
    cr_str_fini(&c->note);
    cJSON_Delete(c->extra);
    free(c);
}

enum cr_err cr_import_begin(struct cr_import *im, const char *id, const char *name,
                            struct cr_error *err) {
    if (im->opts->cancel != NULL && im->opts->cancel(im->opts->user)) {
        return cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted");
    }
    cr_import_case_free(im->at);
    im->at = calloc(1, sizeof *im->at);
    if (im->at == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a case");
    }
    cr_show(id, im->at->id, sizeof im->at->id);
    cr_show(name, im->at->name, sizeof im->at->name);
    im->at->point = CR_POINT_CG;
    im->at->road_friction = NAN;
    return CR_ERR_OK;
}

/* ---- participants ---- */

/* Writes an id with its letters, digits, _ and - as they are, and all else as _. */
static void scene_id(const char *id, char out[CR_NAME_MAX]) {
    size_t n = 0;
    for (const char *p = id; *p != '\0' && n < CR_NAME_CHARS; p++) {
        bool fits = (*p >= 'a' && *p <= 'z') || (*p >= 'A' && *p <= 'Z') ||
                    (*p >= '0' && *p <= '9') || *p == '-';
        out[n++] = fits ? *p : '_';
    }
    out[n] = '\0';
    if (n == 0 || strcmp(out, "t_s") == 0) {
        memcpy(out, "P", 2);
    }
}

struct cr_participant *cr_import_find(const struct cr_import *im, const char *id) {
    for (int i = 0; i < im->at->parts; i++) {
        if (strcmp(im->at->part[i]->source_id, id) == 0) {
            return &im->at->part[i]->p;
        }
    }
    return NULL;
}

static bool taken(const struct cr_import_case *c, const char *id) {
    for (int i = 0; i < c->parts; i++) {
        if (strcmp(c->part[i]->p.id, id) == 0) {
            return true;
        }
    }
    return false;
}

/* Makes a participant without values; a scene does it, so that all begins as in a scene. */
static enum cr_err blank(const char *id, enum cr_kind kind, struct cr_participant *out,
                         struct cr_error *err) {
    struct cr_scene *scene = malloc(sizeof *scene);
    struct cr_participant *p;
    if (scene == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a participant");
    }
    cr_scene_init(scene);
    enum cr_err code = cr_scene_add(scene, id, kind, &p, err);
    if (code == CR_ERR_OK) {
        *out = *p; /* It owns nothing yet, so there is nothing to give back. */
    }
    free(scene);
    return code;
}

enum cr_err cr_import_add(struct cr_import *im, const char *id, enum cr_kind kind,
                          struct cr_participant **out, struct cr_error *err) {
    struct cr_import_case *c = im->at;
    char name[CR_NAME_MAX];
    if (strlen(id) >= CR_IMPORT_ID_MAX) {
        return cr_err_set(err, CR_ERR_RANGE,
                          "participant \"%.40s...\": an id of more than %d bytes", id,
                          CR_IMPORT_ID_MAX - 1);
    }
    if (cr_import_find(im, id) != NULL) {
        return cr_err_set(err, CR_ERR_DUPLICATE, "participant \"%.60s\" stands there twice", id);
    }
    if (c->parts == CR_IMPORT_PARTS_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "more than %d participants in one case",
                          CR_IMPORT_PARTS_MAX);
    }
    scene_id(id, name);
    for (int i = 2; taken(c, name); i++) {
        snprintf(name + (strlen(name) > 50 ? 50 : strlen(name)), 12, "_%d", i);
    }
    struct cr_import_part *part = calloc(1, sizeof *part);
    if (part == NULL || !cr_grow(&c->part, &c->size, c->parts, sizeof(struct cr_import_part *))) {
        free(part);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a participant");
    }
    enum cr_err code = blank(name, kind, &part->p, err);
    if (code != CR_ERR_OK) {
        free(part);
        return code;
    }
    memcpy(part->source_id, id, strlen(id) + 1);
    c->part[c->parts++] = part;
    *out = &part->p;
    return CR_ERR_OK;
}

/* ---- rows ---- */

static void choose_origin(struct cr_import_case *c, struct cr_vec2 pos) {
    if (!c->placed && (fabs(pos.x) > far_off || fabs(pos.y) > far_off)) {
        c->origin = cr_vec2(round(pos.x), round(pos.y));
    }
    c->placed = true;
}

/* Moves a row to the CG and rounds it to the digits that a scene is written with: 0.1 mm, 0.0001
 * degrees, 0.0001 km/h. */
static struct cr_waypoint tidy(const struct cr_import_case *c, const struct cr_import_part *part,
                               const struct cr_waypoint *row) {
    /* A double has no more than 5 certain digits behind the point of a calendar's 1.7e9 s. */
    struct cr_waypoint out = {.t = cr_round_decimals(row->t, fabs(row->t) < 1e8 ? 6 : 5)};
    double x = row->pos.x - c->origin.x + part->shift * cos(row->heading);
    double y = row->pos.y - c->origin.y + part->shift * sin(row->heading);
    out.pos = cr_vec2(cr_round_decimals(x, 4), cr_round_decimals(y, 4));
    out.heading = cr_rad(cr_round_decimals(cr_deg(row->heading), 4));
    out.speed = cr_mps(cr_round_decimals(cr_kmh(row->speed), 4));
    return out;
}

static enum cr_err check_row(const struct cr_import_part *part, const struct cr_waypoint *row,
                             struct cr_error *err) {
    bool finite = isfinite(row->t) && isfinite(row->pos.x) && isfinite(row->pos.y) &&
                  isfinite(row->heading) && isfinite(row->speed);
    if (!finite || fabs(row->t) >= 1e10 || fabs(row->pos.x) > 1e8 || fabs(row->pos.y) > 1e8 ||
        fabs(row->heading) > 1e6 || fabs(row->speed) > 1e6) {
        return cr_err_set(err, CR_ERR_RANGE,
                          "participant \"%.60s\": time, place, heading or speed is missing or "
                          "out of all range",
                          part->source_id);
    }
    if (part->n > part->first && row->t <= part->row[part->n - 1].t) {
        cr_err_set(err, CR_ERR_RANGE,
                   "participant \"%.60s\": time must rise from row to row, got %.10g s after "
                   "%.10g s",
                   part->source_id, row->t, part->row[part->n - 1].t);
        cr_err_hint(err, "one row for a time; several cases in one file need a column of cases");
        return CR_ERR_RANGE;
    }
    return CR_ERR_OK;
}

/* Makes room for one more row; rows that were left behind are dropped first. */
static bool room(struct cr_import_part *part) {
    if (part->first >= LOT && part->first > part->n / 2) {
        int held = part->n - part->first;
        memmove(part->row, part->row + part->first, (size_t)held * sizeof *part->row);
        part->at = part->at > part->first ? part->at - part->first : 0;
        part->first = 0;
        part->n = held;
    }
    return cr_grow(&part->row, &part->size, part->n, sizeof *part->row);
}

/* Looks whether outlines met at the last time, which a row at a later time t completes, and leaves
 * rows behind that are too old to matter. */
static void advance(struct cr_import *im, double t) {
    struct cr_import_case *c = im->at;
    if (c->started && !c->unordered && t > c->now && c->moving > 0) {
        cr_import_look(c, c->now);
        if (!c->met && c->rows > (long)LOT * c->moving && c->moving > 1) {
            cr_import_cut(c, c->now - im->opts->before, c->now);
        }
    }
}

enum cr_err cr_import_row(struct cr_import *im, struct cr_participant *p,
                          const struct cr_waypoint *row, struct cr_error *err) {
    struct cr_import_case *c = im->at;
    struct cr_import_part *part = whole(p);
    enum cr_err code = part->fixed ? CR_ERR_OK : cr_import_fix(im, part, err);
    code = code == CR_ERR_OK ? check_row(part, row, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    choose_origin(c, row->pos);
    if (!c->started && (code = cr_import_settle(im, true, err)) != CR_ERR_OK) {
        return code;
    }
    struct cr_waypoint tidied = tidy(c, part, row);
    if (c->met && !c->unordered) {
        return CR_ERR_OK;
    }
    if (c->started && tidied.t < c->now && part->n == part->first && !c->unordered) {
        c->unordered = true; /* The file has one participant after the other. */
        if (c->cut) {
            return cr_err_set(err, CR_ERR_RANGE,
                              "participant \"%.60s\" begins where others "
                              "are past: sort the rows by time",
                              part->source_id);
        }
    }
    advance(im, tidied.t);
    if (c->met && !c->unordered && tidied.t > c->t_met) {
        return CR_ERR_OK;
    }
    if (part->n > part->first && tidied.t <= part->row[part->n - 1].t) {
        return CR_ERR_OK; /* Times this close are one time in the digits of a scene. */
    }
    if (c->rows >= CR_IMPORT_ROWS_MAX) {
        cr_err_set(err, CR_ERR_EXPENSIVE, "more than %d rows of one case", CR_IMPORT_ROWS_MAX);
        cr_err_hint(err, "sort the file by time, so that only the last seconds must be held");
        return CR_ERR_EXPENSIVE;
    }
    if (!room(part)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the rows of a case");
    }
    c->moving += part->n == part->first;
    c->rows++;
    part->row[part->n++] = tidied;
    c->now = c->started ? fmax(c->now, tidied.t) : tidied.t;
    c->started = true;
    return CR_ERR_OK;
}

enum cr_err cr_import_settle(struct cr_import *im, bool objects, struct cr_error *err) {
    struct cr_import_case *c = im->at;
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < c->parts && code == CR_ERR_OK; i++) {
        struct cr_import_part *part = c->part[i];
        if (part->fixed || part->n > part->first || (objects && part->p.kind != CR_KIND_OBJECT)) {
            continue;
        }
        code = cr_import_fix(im, part, err);
        struct cr_participant *p = &part->p;
        struct cr_waypoint at = {.pos = p->pos, .heading = p->heading, .speed = p->speed};
        if (code == CR_ERR_OK) {
            choose_origin(c, p->pos);
            at = tidy(c, part, &at);
            p->pos = at.pos;
            p->heading = at.heading;
            p->speed = at.speed;
        }
    }
    return code;
}

bool cr_import_met(const struct cr_import *im) {
    return im->at->met && !im->at->unordered;
}

/* ---- the rest of a case ---- */

void cr_import_point(struct cr_import *im, enum cr_point point) {
    im->at->point = point;
}

void cr_import_road_friction(struct cr_import *im, double mu) {
    im->at->road_friction = mu;
}

enum cr_err cr_import_extra(struct cr_import *im, enum cr_err code, cJSON *object,
                            struct cr_error *err) {
    if (code != CR_ERR_OK) {
        cJSON_Delete(object);
        return code;
    }
    cJSON_Delete(im->at->extra);
    im->at->extra = object;
    return object != NULL && cr_tree_whole(object)
               ? CR_ERR_OK
               : cr_err_set(err, CR_ERR_MEMORY, "no memory for what was measured");
}
