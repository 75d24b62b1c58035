/* Makes the scene of a case: chooses participants and rows, notes the source, writes the line. */
#include "config.h"

#include "import/import_priv.h"

#include "base/json.h"
#include "base/number.h"
#include "base/show.h"
#include "base/tree.h"
#include "scene/keys.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Chooses the participants of the scene: all, or those that meet where all are too many. */
static void choose(struct cr_import *im, struct cr_import_part **chosen, int *n) {
    struct cr_import_case *c = im->at;
    bool all = c->parts <= CR_BODY_MAX;
    *n = 0;
    for (int i = 0; i < c->parts && *n < CR_BODY_MAX; i++) {
        if (all || c->part[i]->hit) {
            chosen[(*n)++] = c->part[i];
        }
    }
    if (!all) {
        cr_import_note(im, "%d of %d participants, which meet first", *n, c->parts);
    }
}

static enum cr_err trim(struct cr_import *im, struct cr_error *err) {
    struct cr_import_case *c = im->at;
    enum cr_err code = CR_ERR_OK;
    if (!c->started) {
        return CR_ERR_OK;
    }
    if (c->unordered) {
        code = cr_import_search(c, err);
    } else if (!c->met) {
        cr_import_look(c, c->now);
    }
    double to = c->met ? c->t_met : c->now;
    bool was_cut = c->cut;
    c->cut = false;
    cr_import_cut(c, to - im->opts->before, to);
    if (c->cut || was_cut) {
        cr_import_note(im, "only the last %.4g s before %s", im->opts->before,
                       c->met ? "the outlines meet" : "its end");
    }
    if (!c->met) {
        cr_import_note(im, "the outlines do not meet in the file");
    }
    return code;
}

/* Has times of a calendar or of a recording of hours count from the first second that is kept,
 * because those of a scene end at 10000 s. */
static void near_zero(struct cr_import *im) {
    struct cr_import_case *c = im->at;
    double first = INFINITY, furthest = 0;
    for (int i = 0; i < c->parts; i++) {
        const struct cr_import_part *part = c->part[i];
        if (part->n > part->first) {
            first = fmin(first, part->row[part->first].t);
            furthest = fmax(furthest, fabs(part->row[part->n - 1].t));
        }
    }
    if (fmax(furthest, isfinite(first) ? fabs(first) : 0) <= 9000) {
        return;
    }
    first = floor(first);
    for (int i = 0; i < c->parts; i++) {
        for (int k = c->part[i]->first; k < c->part[i]->n; k++) {
            c->part[i]->row[k].t = cr_round_decimals(c->part[i]->row[k].t - first, 6);
        }
    }
    cr_import_note(im, "times less %.0f s", first);
}

static enum cr_err need_two(const struct cr_import *im, struct cr_error *err) {
    const struct cr_import_case *c = im->at;
    if (c->parts >= 2) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_MISSING, "a crash needs two participants, the case has %s",
               c->parts == 0 ? "none" : c->part[0]->source_id);
    cr_err_place(err, im->shown, 0, 0);
    cr_err_hint(err, "a map adds others: \"objects\", see crumple-import(1)");
    return CR_ERR_MISSING;
}

/* Adds the walls and poles that the map has for every case. */
static enum cr_err add_objects(struct cr_import *im, struct cr_error *err) {
    const cJSON *all = cJSON_GetObjectItemCaseSensitive(im->map, "objects");
    enum cr_err code = CR_ERR_OK;
    for (const cJSON *o = all != NULL ? all->child : NULL; o != NULL && code == CR_ERR_OK;
         o = o->next) {
        struct cr_participant *p;
        if (cr_import_find(im, o->string) == NULL) {
            const char *kind = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(o, "kind"));
            bool vehicle = kind != NULL && strcmp(kind, "vehicle") == 0;
            code =
                cr_import_add(im, o->string, vehicle ? CR_KIND_VEHICLE : CR_KIND_OBJECT, &p, err);
        }
    }
    return code;
}

static void put_source(const struct cr_import *im, struct cr_scene *scene) {
    const struct cr_import_case *c = im->at;
    const char *slash = strrchr(im->shown, '/');
    static const char *const point[] = {
#define X(name, word) word,
        CR_POINT_LIST(X)
#undef X
    };
    char(*s)[CR_SOURCE_MAX] = scene->source;
    int taken = im->opts->point >= 0 ? im->opts->point : (int)c->point;
    snprintf(s[CR_SOURCE_FORMAT], CR_SOURCE_MAX, "%s", im->format);
    snprintf(s[CR_SOURCE_FILE], CR_SOURCE_MAX, "%.250s", slash != NULL ? slash + 1 : im->shown);
    snprintf(s[CR_SOURCE_SHA256], CR_SOURCE_MAX, "%s", im->sha256);
    snprintf(s[CR_SOURCE_CASE], CR_SOURCE_MAX, "%s", c->id);
    snprintf(s[CR_SOURCE_CONVERTER], CR_SOURCE_MAX, "%s", PACKAGE_STRING);
    snprintf(s[CR_SOURCE_REFERENCE], CR_SOURCE_MAX, "%s", point[taken]);
    cr_show(cr_str_get(&c->note), s[CR_SOURCE_NOTE], CR_SOURCE_MAX);
}

/* Writes a participant as it goes into the scene, which borrows its rows. */
static void put_part(struct cr_import_part *part, struct cr_participant *out) {
    int n = part->n - part->first;
    *out = part->p;
    if (n == 1) {
        out->pos = part->row[part->first].pos;
        out->heading = part->row[part->first].heading;
        out->speed = part->row[part->first].speed;
    } else if (n > 1) {
        out->waypoints = n;
        out->waypoint = part->row + part->first;
        out->speed = out->heading = 0;
        out->pos = cr_vec2(0, 0);
    }
}

static void give_road_friction(double mu, struct cr_settings *set) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_SETTINGS, &n);
    if (isnan(mu)) {
        return;
    }
    set->road_friction = mu;
    for (int i = 0; i < n; i++) {
        set->given |= strcmp(row[i].name, "road_friction") == 0 ? 1U << i : 0;
    }
}

/* Reads the tree of the scene again, so that nothing comes out that crumple itself would refuse. */
static enum cr_err check(const struct cr_import *im, const cJSON *json, struct cr_error *err) {
    struct cr_scene *scene = malloc(sizeof *scene);
    if (scene == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a scene");
    }
    enum cr_err code = cr_scene_from_json(json, scene, err);
    if (code == CR_ERR_OK) {
        cr_scene_fini(scene);
    } else {
        cr_err_place(err, im->shown, 0, 0);
    }
    free(scene);
    return code;
}

static enum cr_err write_scene(struct cr_import *im, struct cr_scene *scene, struct cr_str *line,
                               struct cr_error *err) {
    struct cr_import_case *c = im->at;
    struct cr_import_part *chosen[CR_BODY_MAX];
    cr_scene_init(scene);
    choose(im, chosen, &scene->n);
    snprintf(scene->name, sizeof scene->name, "%s", c->name);
    put_source(im, scene);
    give_road_friction(c->road_friction, &scene->set);
    for (int i = 0; i < scene->n; i++) {
        put_part(chosen[i], &scene->part[i]);
    }
    cJSON *json = cr_scene_to_json(scene, false);
    if (json == NULL || c->note.failed || !cr_import_lay_over(json, c->extra)) {
        cJSON_Delete(json);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a scene");
    }
    enum cr_err code = check(im, json, err);
    if (code != CR_ERR_OK) {
        cJSON_Delete(json);
        return code;
    }
    bool done = cr_json_add(json, false, line);
    cr_str_add(line, "\n");
    return done && !line->failed ? CR_ERR_OK
                                 : cr_err_set(err, CR_ERR_MEMORY, "no memory for a scene");
}

enum cr_err cr_import_scene(struct cr_import *im, struct cr_str *line, struct cr_error *err) {
    struct cr_import_case *c = im->at;
    enum cr_err code = add_objects(im, err);
    code = code == CR_ERR_OK ? need_two(im, err) : code;
    code = code == CR_ERR_OK ? cr_import_settle(im, false, err) : code;
    code = code == CR_ERR_OK ? trim(im, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    near_zero(im);
    if (c->origin.x != 0 || c->origin.y != 0) {
        cr_import_note(im, "places less (%.0f, %.0f) m", c->origin.x, c->origin.y);
    }
    struct cr_scene *scene = malloc(sizeof *scene);
    if (scene == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a scene");
    }
    code = write_scene(im, scene, line, err);
    free(scene); /* What it holds is the case's. */
    return code;
}
