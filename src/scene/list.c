/* The two lists of a scene file: corners of a polygon and rows of a trajectory. */
#include "scene/scene_priv.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum cr_err cr_scene_vertices_read(struct cr_reader *r, const struct cr_key *key, const cJSON *json,
                                   void *base) {
    struct cr_participant *p = base;
    struct cr_vec2 v[CR_VERTEX_MAX];
    int n = cJSON_IsArray(json) ? cJSON_GetArraySize(json) : -1;
    if (n < 0) {
        return cr_scene_wrong_type(r, key, "an array of corners [x, y]", json);
    }
    if (n < 3 || n > CR_VERTEX_MAX) {
        return cr_scene_fail(r, CR_ERR_RANGE, "%s must have 3 to %d corners, got %d", key->name,
                             CR_VERTEX_MAX, n);
    }
    for (int i = 0; i < n; i++) {
        char token[12];
        double x[2];
        snprintf(token, sizeof token, "%d", i);
        size_t up = cr_scene_enter(r, token);
        enum cr_err code =
            cr_scene_numbers_read(r, key, cJSON_GetArrayItem(json, i), x, 2, "two numbers [x, y]");
        if (code != CR_ERR_OK) {
            return code;
        }
        v[i] = cr_vec2(x[0], x[1]);
        cr_scene_leave(r, up);
    }
    enum cr_err code = cr_scene_polygon_check(r, v, n);
    if (code == CR_ERR_OK) {
        memcpy(p->vertex, v, (size_t)n * sizeof v[0]);
        p->vertices = n;
    }
    return code;
}

cJSON *cr_scene_vertices_write(const struct cr_key *key, const void *base) {
    const struct cr_participant *p = base;
    cJSON *array = cJSON_CreateArray();
    for (int i = 0; i < p->vertices; i++) {
        double x[2] = {p->vertex[i].x, p->vertex[i].y};
        cJSON *item = cr_scene_numbers_write(key, x, 2);
        if (item == NULL || !cJSON_AddItemToArray(array, item)) {
            cJSON_Delete(item);
            cJSON_Delete(array);
            return NULL;
        }
    }
    return array;
}

static enum cr_err read_waypoint(struct cr_reader *r, const cJSON *json, int i,
                                 struct cr_waypoint *way) {
    uint64_t given = 0;
    if (!cJSON_IsObject(json)) {
        return cr_scene_fail(r, CR_ERR_TYPE, "a row of the trajectory must be an object");
    }
    enum cr_err code =
        cr_scene_members_read(r, CR_KEYS_WAYPOINT, CR_FOR_ALL, json, "", &way[i], &given);
    int keys;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_WAYPOINT, &keys);
    for (int k = 0; k < keys && code == CR_ERR_OK; k++) {
        if ((given >> k & 1) == 0) {
            code = cr_scene_fail(r, CR_ERR_MISSING, "this row of the trajectory has no %s",
                                 row[k].name);
        }
    }
    if (code == CR_ERR_OK && i > 0 && !(way[i].t > way[i - 1].t)) {
        size_t up = cr_scene_enter(r, "t_s");
        code =
            cr_scene_fail(r, CR_ERR_RANGE, "t_s must rise from row to row, got %.10g after %.10g",
                          way[i].t, way[i - 1].t);
        cr_scene_leave(r, up);
    }
    return code;
}

static enum cr_err read_waypoints(struct cr_reader *r, const cJSON *json, int n,
                                  struct cr_waypoint *way) {
    enum cr_err code = CR_ERR_OK;
    const cJSON *item = json->child;
    for (int i = 0; i < n && code == CR_ERR_OK; i++, item = item->next) {
        char token[12];
        cJSON *outer = NULL;
        snprintf(token, sizeof token, "%d", i);
        size_t up = cr_scene_enter(r, token);
        code = cr_scene_extra_in(r, &outer);
        if (code == CR_ERR_OK) {
            code = read_waypoint(r, item, i, way);
            code = cr_scene_extra_out(r, token, outer, code);
        }
        cr_scene_leave(r, up);
    }
    return code;
}

enum cr_err cr_scene_trajectory_read(struct cr_reader *r, const struct cr_key *key,
                                     const cJSON *json, void *base) {
    struct cr_participant *p = base;
    int n = cJSON_IsArray(json) ? cJSON_GetArraySize(json) : -1;
    if (n < 0) {
        return cr_scene_wrong_type(r, key, "an array of rows", json);
    }
    if (n < 2 || n > CR_WAYPOINT_MAX) {
        return cr_scene_fail(r, CR_ERR_RANGE, "%s must have 2 to %d rows, got %d", key->name,
                             CR_WAYPOINT_MAX, n);
    }
    struct cr_waypoint *way = calloc((size_t)n, sizeof *way);
    if (way == NULL) {
        return cr_scene_fail(r, CR_ERR_MEMORY, "no memory for the trajectory");
    }
    cJSON *outer = NULL;
    enum cr_err code = cr_scene_extra_in(r, &outer);
    if (code == CR_ERR_OK) {
        code = read_waypoints(r, json, n, way);
        code = cr_scene_extra_out(r, key->name, outer, code);
    }
    if (code != CR_ERR_OK) {
        free(way);
        return code;
    }
    free(p->waypoint);
    p->waypoint = way;
    p->waypoints = n;
    return CR_ERR_OK;
}

static cJSON *write_waypoint(const struct cr_waypoint *way) {
    int keys;
    const struct cr_key *key = cr_scene_keys(CR_KEYS_WAYPOINT, &keys);
    cJSON *row = cJSON_CreateObject();
    for (int k = 0; k < keys; k++) {
        cJSON *item = cr_scene_value_write(&key[k], way);
        if (item == NULL || !cJSON_AddItemToObject(row, key[k].name, item)) {
            cJSON_Delete(item);
            cJSON_Delete(row);
            return NULL;
        }
    }
    return row;
}

cJSON *cr_scene_trajectory_write(const struct cr_key *key, const void *base) {
    (void)key;
    const struct cr_participant *p = base;
    cJSON *array = cJSON_CreateArray();
    for (int i = 0; i < p->waypoints; i++) {
        cJSON *row = write_waypoint(&p->waypoint[i]);
        if (row == NULL || !cJSON_AddItemToArray(array, row)) {
            cJSON_Delete(row);
            cJSON_Delete(array);
            return NULL;
        }
    }
    return array;
}
