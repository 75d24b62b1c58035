/* Completes a participant of a case: by what the user's map says of it, by the sizes that nobody
 * gave, and by its outline. */
#include "import/import_priv.h"

#include "base/number.h"
#include "base/show.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void cr_import_note(struct cr_import *im, const char *fmt, ...) {
    char text[CR_SOURCE_MAX], shown[CR_SOURCE_MAX];
    va_list args;
    va_start(args, fmt);
    vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    cr_str_addf(&im->at->note, "%s%s", im->at->note.len > 0 ? "; " : "",
                cr_show(text, shown, sizeof shown));
}

/* The share of the wheelbase by which the CG is taken to lie behind the front axle, where a file
 * that counts from the rear axle gives none [CG-SHARE]. */
static const double cg_share = 0.4;

/* ---- one participant ---- */

static cJSON *map_of(const struct cr_import *im, const struct cr_import_part *part) {
    static const char *const lists[] = {"vehicles", "objects"};
    const cJSON *vehicles = cJSON_GetObjectItemCaseSensitive(im->map, "vehicles");
    for (int i = 0; i < 2; i++) {
        const cJSON *all = cJSON_GetObjectItemCaseSensitive(im->map, lists[i]);
        cJSON *own = cJSON_GetObjectItemCaseSensitive(all, part->source_id);
        if (own != NULL) {
            return own;
        }
    }
    return part->p.kind == CR_KIND_VEHICLE ? cJSON_GetObjectItemCaseSensitive(vehicles, "*") : NULL;
}

bool cr_import_lay_over(cJSON *to, const cJSON *from) {
    for (const cJSON *m = from != NULL ? from->child : NULL; m != NULL; m = m->next) {
        cJSON *old = cJSON_GetObjectItemCaseSensitive(to, m->string);
        if (cJSON_IsObject(old) && cJSON_IsObject(m)) {
            if (!cr_import_lay_over(old, m)) {
                return false;
            }
            continue;
        }
        cJSON *copy = cJSON_Duplicate(m, 1);
        cJSON_DeleteItemFromObjectCaseSensitive(to, m->string);
        if (copy == NULL || !cJSON_AddItemToObject(to, m->string, copy)) {
            cJSON_Delete(copy);
            return false;
        }
    }
    return true;
}

/* Gives a vehicle of which neither file nor map tells type or size the type "auto", and notes
 * it. */
static void need_type(struct cr_import *im, const struct cr_import_part *part, cJSON *json) {
    static const char *const tell[] = {"type",     "car",         "mass_kg", "kerb_mass_kg",
                                       "length_m", "wheelbase_m", "height_m"};
    for (size_t i = 0; i < sizeof tell / sizeof *tell; i++) {
        if (part->p.kind != CR_KIND_VEHICLE || cJSON_HasObjectItem(json, tell[i])) {
            return;
        }
    }
    cr_tree_text(json, "type", "auto");
    cr_import_note(im, "nothing tells size or type of %s", part->p.id);
}

/* Makes a scene of the participant, with the map's values over the reader's, and of a wall, as a
 * tree: a scene needs two. NULL if memory is out. */
static cJSON *scene_alone(struct cr_import *im, const struct cr_import_part *part,
                          struct cr_scene *work) {
    cr_scene_init(work);
    work->n = 1;
    work->part[0] = part->p; /* It is lent, so work is not finished. */
    cJSON *json = cr_scene_to_json(work, false);
    cJSON *list = cJSON_GetObjectItemCaseSensitive(json, "participants");
    cJSON *wall = cJSON_CreateObject();
    cr_tree_text(wall, "id", strcmp(part->p.id, "wall") != 0 ? "wall" : "wall2");
    cr_tree_text(wall, "kind", "object");
    cr_tree_text(wall, "shape", "wall");
    cJSON *place = cr_tree_array(wall, "position_m");
    cr_tree_push(place, cJSON_CreateNumber(0));
    cr_tree_push(place, cJSON_CreateNumber(0));
    bool done = list != NULL && cr_import_lay_over(cJSON_GetArrayItem(list, 0), map_of(im, part));
    need_type(im, part, cJSON_GetArrayItem(list, 0));
    cr_tree_push(list, wall);
    if (!done || !cr_tree_whole(json)) {
        cJSON_Delete(json);
        return NULL;
    }
    return json;
}

/* Has an error about a participant's value say whose it is; its place is the file. */
static void blame(const struct cr_import *im, const struct cr_import_part *part,
                  struct cr_error *err) {
    char text[sizeof err->text];
    const char *key = strstr(err->where, "/participants/0/");
    bool named = key == NULL || strstr(err->text, key + 16) != NULL;
    snprintf(text, sizeof text, "participant \"%.40s\": %.30s%s%.150s", part->source_id,
             named ? "" : key + 16, named ? "" : ": ", err->text);
    memcpy(err->text, text, sizeof text);
    err->where[0] = '\0';
    cr_err_place(err, im->shown, err->line, err->col);
}

static double shift_of(const struct cr_participant *p, enum cr_point point) {
    double front = p->front_overhang + p->cg_behind_front_axle;
    switch (p->kind == CR_KIND_VEHICLE ? point : CR_POINT_CG) {
    case CR_POINT_CENTRE:
        return p->length / 2 - front;
    case CR_POINT_REAR_AXLE:
        return p->wheelbase - p->cg_behind_front_axle;
    case CR_POINT_REAR:
        return p->length - front;
    case CR_POINT_FRONT:
        return -front;
    default:
        return 0;
    }
}

/* Writes the values into the scene by which the file's places were moved to the CG: with others the
 * places would not hold. */
static void pin(struct cr_import *im, struct cr_import_part *part, enum cr_point point) {
    struct cr_participant *p = &part->p, *full = &part->full;
    if (isnan(p->cg_behind_front_axle)) {
        double x =
            point == CR_POINT_REAR_AXLE ? cg_share * full->wheelbase : full->cg_behind_front_axle;
        full->cg_behind_front_axle = p->cg_behind_front_axle = cr_round_decimals(x, 4);
        cr_import_note(im, "CG of %s assumed %.4g m behind the front axle", p->id,
                       p->cg_behind_front_axle);
    }
    if (point == CR_POINT_REAR_AXLE && isnan(p->wheelbase)) {
        full->wheelbase = p->wheelbase = cr_round_decimals(full->wheelbase, 4);
    }
    if (point != CR_POINT_REAR_AXLE && isnan(p->front_overhang)) {
        full->front_overhang = p->front_overhang = cr_round_decimals(full->front_overhang, 4);
    }
    if ((point == CR_POINT_CENTRE || point == CR_POINT_REAR) && isnan(p->length)) {
        full->length = p->length = cr_round_decimals(full->length, 4);
    }
}

static void outline(struct cr_import_part *part) {
    part->corners = cr_scene_outline(&part->full, part->corner, CR_VERTEX_MAX);
    part->radius = 0;
    for (int i = 0; i < part->corners; i++) {
        part->radius = fmax(part->radius, cr_vec2_len(part->corner[i]));
    }
}

/* Keeps the reader's position, heading and speed where the map does not say them. */
static void keep_motion(struct cr_participant *to, const struct cr_participant *from,
                        const cJSON *map) {
    to->pos = cJSON_HasObjectItem(map, "position_m") ? to->pos : from->pos;
    to->heading = cJSON_HasObjectItem(map, "heading_deg") ? to->heading : from->heading;
    to->course = cJSON_HasObjectItem(map, "course_deg") ? to->course : from->course;
    to->speed = cJSON_HasObjectItem(map, "speed_kmh") ? to->speed : from->speed;
    to->yaw_rate = cJSON_HasObjectItem(map, "yaw_rate_deg_s") ? to->yaw_rate : from->yaw_rate;
}

static enum cr_err fix(struct cr_import *im, struct cr_import_part *part, struct cr_scene *work,
                       struct cr_error *err) {
    const struct cr_participant given = part->p;
    cJSON *json = scene_alone(im, part, work);
    if (json == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a participant");
    }
    enum cr_err code = cr_scene_from_json(json, work, err);
    cJSON_Delete(json);
    if (code != CR_ERR_OK) {
        return code;
    }
    free(part->p.extra);
    part->p = work->part[0];
    work->part[0].extra = NULL; /* It belongs to part->p now. */
    keep_motion(&part->p, &given, map_of(im, part));
    code = cr_scene_resolve(work, im->opts->models, NULL, err);
    if (code == CR_ERR_OK) {
        enum cr_point point = im->opts->point >= 0 ? (enum cr_point)im->opts->point : im->at->point;
        part->full = work->part[0];
        part->full.waypoint = NULL;
        part->full.extra = NULL;
        if (part->p.kind == CR_KIND_VEHICLE && point != CR_POINT_CG) {
            pin(im, part, point);
        }
        part->shift = shift_of(&part->full, point);
        outline(part);
        part->fixed = true;
    }
    cr_scene_fini(work);
    return code;
}

enum cr_err cr_import_fix(struct cr_import *im, struct cr_import_part *part, struct cr_error *err) {
    struct cr_error own;
    err = err != NULL ? err : &own;
    struct cr_scene *work = calloc(1, sizeof *work);
    if (work == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a participant");
    }
    enum cr_err code = fix(im, part, work, err);
    free(work);
    if (code != CR_ERR_OK && code != CR_ERR_MEMORY) {
        blame(im, part, err);
    }
    return code;
}
