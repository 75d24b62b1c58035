/* Scenes as values: copy, add, remove and find participants. */
#include "scene/scene_priv.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void cr_scene_init(struct cr_scene *scene) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_SETTINGS, &n);
    memset(scene, 0, sizeof *scene);
    for (int i = 0; i < n; i++) {
        cr_scene_value_reset(&row[i], &scene->set, CR_METHOD_EXTENDED);
    }
}

void cr_scene_part_init(struct cr_participant *part, enum cr_kind kind) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    memset(part, 0, sizeof *part);
    part->kind = kind;
    part->type = CR_TYPES;
    unsigned mask = kind == CR_KIND_VEHICLE ? CR_FOR_VEHICLE : CR_FOR_OBJECT;
    for (int i = 0; i < n; i++) {
        if ((row[i].for_kinds & mask) != 0) {
            cr_scene_value_reset(&row[i], part, 0);
        }
    }
    part->model.blend = kind == CR_KIND_VEHICLE;
    part->place.side = CR_SIDE_AUTO;
    part->place.at = CR_AT_AUTO;
}

bool cr_scene_is_placed(const struct cr_participant *p) {
    return p->place.against[0] != '\0';
}

void cr_scene_unplace(struct cr_participant *p) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    struct cr_participant blank;
    cr_scene_part_init(&blank, p->kind);
    p->place = blank.place;
    for (int i = 0; i < n; i++) {
        if (strncmp(row[i].name, "place.", 6) == 0) {
            p->given &= ~((uint64_t)1 << i);
        }
    }
}

void cr_scene_part_fini(struct cr_participant *part) {
    free(part->waypoint);
    free(part->extra);
    memset(part, 0, sizeof *part);
}

void cr_scene_model_kind(struct cr_participant *part) {
    struct cr_model_choice *m = &part->model;
    bool stiff = false;
    for (int i = 0; i < 3; i++) {
        stiff = stiff || m->face[i].a != 0 || m->face[i].b != 0;
    }
    m->kind = m->file[0] != '\0' ? CR_MODEL_FILE : stiff ? CR_MODEL_STIFFNESS : CR_MODEL_TYPE;
}

void cr_scene_fini(struct cr_scene *scene) {
    for (int i = 0; i < scene->n; i++) {
        cr_scene_part_fini(&scene->part[i]);
    }
    free(scene->extra);
    cr_scene_init(scene);
}

static enum cr_err copy_text(char **to, const char *from, struct cr_error *err) {
    if (from == NULL) {
        return CR_ERR_OK;
    }
    size_t n = strlen(from) + 1;
    *to = malloc(n);
    if (*to == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to copy the scene");
    }
    memcpy(*to, from, n);
    return CR_ERR_OK;
}

static enum cr_err copy_part(const struct cr_participant *from, struct cr_participant *to,
                             struct cr_error *err) {
    *to = *from;
    to->extra = NULL;
    to->waypoint = NULL;
    if (from->waypoints > 0) {
        size_t size = (size_t)from->waypoints * sizeof *from->waypoint;
        to->waypoint = malloc(size);
        if (to->waypoint == NULL) {
            to->waypoints = 0;
            return cr_err_set(err, CR_ERR_MEMORY, "no memory to copy the trajectory");
        }
        memcpy(to->waypoint, from->waypoint, size);
    }
    return copy_text(&to->extra, from->extra, err);
}

enum cr_err cr_scene_copy(const struct cr_scene *from, struct cr_scene *to, struct cr_error *err) {
    cr_scene_init(to);
    memcpy(to->name, from->name, sizeof to->name);
    memcpy(to->pair, from->pair, sizeof to->pair);
    memcpy(to->dir, from->dir, sizeof to->dir);
    memcpy(to->source, from->source, sizeof to->source);
    to->set = from->set;
    enum cr_err code = copy_text(&to->extra, from->extra, err);
    for (int i = 0; i < from->n && code == CR_ERR_OK; i++) {
        code = copy_part(&from->part[i], &to->part[i], err);
        to->n = i + 1;
    }
    if (code != CR_ERR_OK) {
        cr_scene_fini(to);
    }
    return code;
}

size_t cr_scene_size(const struct cr_scene *scene) {
    size_t n = scene->extra != NULL ? strlen(scene->extra) : 0;
    for (int i = 0; i < scene->n; i++) {
        const struct cr_participant *p = &scene->part[i];
        n += (size_t)p->waypoints * sizeof *p->waypoint;
        n += p->extra != NULL ? strlen(p->extra) : 0;
    }
    return n;
}

struct cr_participant *cr_scene_find(struct cr_scene *scene, const char *id) {
    for (int i = 0; i < scene->n; i++) {
        if (strcmp(scene->part[i].id, id) == 0) {
            return &scene->part[i];
        }
    }
    return NULL;
}

enum cr_err cr_scene_add(struct cr_scene *scene, const char *id, enum cr_kind kind,
                         struct cr_participant **out, struct cr_error *err) {
    struct cr_reader r = {.err = err};
    enum cr_err code = cr_scene_id_check(&r, id);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (cr_scene_find(scene, id) != NULL) {
        return cr_err_set(err, CR_ERR_DUPLICATE, "there is a participant \"%s\" already", id);
    }
    if (scene->n == CR_BODY_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "a scene has no more than %d participants",
                          CR_BODY_MAX);
    }
    struct cr_participant *part = &scene->part[scene->n++];
    cr_scene_part_init(part, kind);
    snprintf(part->id, sizeof part->id, "%s", id);
    if (out != NULL) {
        *out = part;
    }
    return CR_ERR_OK;
}

/* the nearest id; of a single letter all are as near, so all are named */
static void name_nearest(const struct cr_scene *scene, const char *id, struct cr_error *err) {
    const char *list[CR_BODY_MAX];
    char all[160] = "";
    for (int i = 0; i < scene->n; i++) {
        size_t used = strlen(all);
        list[i] = scene->part[i].id;
        snprintf(all + used, sizeof all - used, "%s%s", i > 0 ? ", " : "", list[i]);
    }
    const char *near = strlen(id) > 1 ? cr_str_nearest(id, list, scene->n) : NULL;
    if (near != NULL) {
        cr_err_hint(err, "did you mean \"%s\"?", near);
    } else if (scene->n > 0) {
        cr_err_hint(err, "there is %s", all);
    }
}

enum cr_err cr_scene_unknown_id(const struct cr_scene *scene, const char *id,
                                struct cr_error *err) {
    cr_err_set(err, CR_ERR_NAME, "there is no participant \"%.40s\"", id);
    name_nearest(scene, id, err);
    return CR_ERR_NAME;
}

enum cr_err cr_scene_remove(struct cr_scene *scene, const char *id, struct cr_error *err) {
    struct cr_participant *part = cr_scene_find(scene, id);
    if (part == NULL) {
        return cr_scene_unknown_id(scene, id, err);
    }
    char gone[CR_NAME_MAX];
    memcpy(gone, part->id, sizeof gone);
    cr_scene_part_fini(part);
    size_t rest = (size_t)(&scene->part[scene->n] - (part + 1));
    memmove(part, part + 1, rest * sizeof *part);
    scene->n--;
    memset(&scene->part[scene->n], 0, sizeof *part);
    for (int i = 0; i < scene->n; i++) { /* who stood against it stays where it is */
        if (strcmp(scene->part[i].place.against, gone) == 0) {
            cr_scene_unplace(&scene->part[i]);
        }
    }
    return CR_ERR_OK;
}
