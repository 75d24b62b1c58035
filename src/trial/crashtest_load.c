/* Reads the crash tests of a class, or own ones: tables, and scene files that bring their own
 * expectations in x_expect. */
#include "trial/crashtest_read.h"

#include "base/file.h"

#include <cjson/cJSON.h>
#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double none = (double)NAN;

static const char *word(const cJSON *json, const char *key) {
    const char *s = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, key));
    return s != NULL ? s : "";
}

static double number(const cJSON *json, const char *key) {
    const cJSON *x = cJSON_GetObjectItemCaseSensitive(json, key);
    return cJSON_IsNumber(x) ? x->valuedouble : none;
}

static enum cr_err bad_expectation(const char *path, const char *what, struct cr_error *err) {
    cr_err_set(err, CR_ERR_NAME, "x_expect: %s", what);
    cr_err_place(err, path, 0, 0);
    cr_err_hint(err, "participants with numbers such as delta_v_kmh, ees_kmh, face_depth_m");
    return CR_ERR_NAME;
}

static enum cr_err read_expectation(const cJSON *expect, const char *path, struct cr_test *c,
                                    struct cr_error *err) {
    static const char *const key[] = {
#define X(name, key, label, unit, relative) key,
        CR_MEASURE_LIST(X)
#undef X
    };
    const cJSON *item;
    cJSON_ArrayForEach(item, expect) {
        int m = 0;
        while (m < CR_MEASURES && strcmp(key[m], item->string) != 0) {
            m++;
        }
        if (m == CR_MEASURES || !cJSON_IsNumber(item)) {
            return bad_expectation(path, item->string, err);
        }
        c->reference[m] = item->valuedouble;
    }
    return CR_ERR_OK;
}

static void read_pulse(const cJSON *json, struct cr_test *c) {
    const cJSON *item;
    cJSON_ArrayForEach(item, cJSON_GetObjectItemCaseSensitive(json, "x_pulse")) {
        if (strcmp(word(item, "participant"), c->part) == 0) {
            snprintf(c->file, sizeof c->file, "%s/%s", c->dir, word(item, "file"));
            snprintf(c->column, sizeof c->column, "%s", word(item, "column"));
            bool left = strcmp(word(item, "axis"), "left") == 0;
            c->pulse.axis = left ? CR_COMPARE_LEFT : CR_COMPARE_FORWARD;
        }
    }
}

static const cJSON *participant(const cJSON *json, const char *id) {
    const cJSON *p;
    cJSON_ArrayForEach(p, cJSON_GetObjectItemCaseSensitive(json, "participants")) {
        if (strcmp(word(p, "id"), id) == 0) {
            return p;
        }
    }
    return NULL;
}

static enum cr_err scene_case(const cJSON *json, const cJSON *expect, const char *path,
                              const char *text, struct cr_test *c, struct cr_error *err) {
    const cJSON *p = participant(json, expect->string);
    bool barrier = strcmp(word(p, "shape"), "barrier") == 0;
    int type = barrier ? CR_TYPES : cr_type_find(word(p, "type"));
    if (type < 0) {
        return bad_expectation(path, expect->string, err);
    }
    c->type = (enum cr_type)type;
    c->speed_kmh = number(p, "speed_kmh");
    snprintf(c->id, sizeof c->id, "%s", word(json, "name"));
    snprintf(c->part, sizeof c->part, "%s", expect->string);
    snprintf(c->title, sizeof c->title, "%s", word(json, "x_title"));
    snprintf(c->group, sizeof c->group, "%s", word(json, "x_group"));
    snprintf(c->name, sizeof c->name, "%s", word(p, "x_name"));
    cr_file_dir(path, c->dir, sizeof c->dir);
    read_pulse(json, c);
    c->at = 1e-3 * number(json, "x_at_ms");
    c->normal = cr_rad(number(json, "x_planar_normal_deg"));
    struct cr_str copy = {0};
    cr_str_add(&copy, text);
    enum cr_err code = cr_test_set_scene(c, &copy, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    return read_expectation(expect, path, c, err);
}

enum cr_err cr_test_read(const char *text, const char *path, enum cr_test_class class,
                         struct cr_test_list *list, struct cr_error *err) {
    struct cr_scene scene;
    enum cr_err code = cr_scene_parse(text, strlen(text), path, &scene, err);
    cr_scene_fini(&scene);
    if (code != CR_ERR_OK) {
        return code;
    }
    cJSON *json = cJSON_Parse(text);
    const cJSON *expect = cJSON_GetObjectItemCaseSensitive(json, "x_expect"), *one;
    if (json == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for what was measured");
    } else if (!cJSON_IsObject(expect) || expect->child == NULL) {
        code = bad_expectation(path, "the scene has none to be compared with", err);
    }
    for (one = expect != NULL ? expect->child : NULL; one != NULL && code == CR_ERR_OK;
         one = one->next) {
        struct cr_test *c = cr_test_list_add(list, err);
        code = c != NULL ? scene_case(json, one, path, text, c, err) : CR_ERR_MEMORY;
        if (c != NULL) {
            c->class = class;
        }
    }
    cJSON_Delete(json);
    return code;
}

static bool ends_in(const char *name, const char *suffix) {
    size_t n = strlen(name), k = strlen(suffix);
    return n > k && strcmp(name + n - k, suffix) == 0;
}

/* Loads a scene, or with the suffix .jsonl a scene per line. */
static enum cr_err load_scene(const char *path, enum cr_test_class class, struct cr_test_list *list,
                              struct cr_error *err) {
    char *text = NULL;
    size_t len;
    enum cr_err code = cr_file_read(path, &text, &len, err);
    if (code != CR_ERR_OK || !ends_in(path, ".jsonl")) {
        code = code == CR_ERR_OK ? cr_test_read(text, path, class, list, err) : code;
        free(text);
        return code;
    }
    int number = 1;
    for (char *line = text, *end; *line != '\0' && code == CR_ERR_OK; line = end, number++) {
        end = line + strcspn(line, "\n");
        end += *end == '\n' ? 1 : 0;
        char kept = *end;
        *end = '\0';
        code = cr_test_read(line, path, class, list, err);
        *end = kept;
        if (code != CR_ERR_OK) {
            cr_err_place(err, path, number, 0);
        }
    }
    free(text);
    return code;
}

static int is_json(const struct dirent *e) {
    return e->d_name[0] != '.' && (ends_in(e->d_name, ".json") || ends_in(e->d_name, ".jsonl"));
}

static enum cr_err load_folder(const char *dir, enum cr_test_class class, struct cr_test_list *list,
                               struct cr_error *err) {
    struct cr_folder folder;
    enum cr_err code = cr_folder_list(dir, is_json, false, &folder, err);
    for (int i = 0; i < folder.n && code == CR_ERR_OK; i++) {
        struct cr_str path = {0};
        cr_str_addf(&path, "%s/%s", dir, folder.entry[i]->d_name);
        code = load_scene(cr_str_get(&path), class, list, err);
        cr_str_fini(&path);
    }
    cr_folder_fini(&folder);
    return code;
}

static enum cr_err load_walls(const char *dir, const struct cr_type_rules *rules,
                              struct cr_test_list *list, struct cr_error *err) {
    char path[4200];
    int from = list->n;
    cr_file_part(dir, "validation/data/frontal_wall.csv", path, sizeof path);
    enum cr_err code = cr_test_load_table(path, CR_TEST_WALL, rules, list, err);
    cr_file_part(dir, "validation/data/frontal_wall_pulse.csv", path, sizeof path);
    if (code != CR_ERR_OK) {
        return code;
    }
    return cr_test_add_pulses(path, list, from, err);
}

enum cr_err cr_test_load(const char *dir, enum cr_test_class class,
                         const struct cr_type_rules *rules, struct cr_test_list *list,
                         struct cr_error *err) {
    static const char *const words[] = {
#define X(name, word, title) word,
        CR_TEST_CLASS_LIST(X)
#undef X
    };
    char path[4200];
    if (class == CR_TEST_WALL) {
        return load_walls(dir, rules, list, err);
    }
    if (class == CR_TEST_POLE) {
        cr_file_part(dir, "validation/data/side_pole.csv", path, sizeof path);
        return cr_test_load_table(path, class, rules, list, err);
    }
    char part[100];
    snprintf(part, sizeof part, "validation/%s", words[class]);
    cr_file_part(dir, part, path, sizeof path);
    return load_folder(path, class, list, err);
}

enum cr_err cr_test_load_own(const char *path, const struct cr_type_rules *rules,
                             struct cr_test_list *list, struct cr_error *err) {
    size_t n = strlen(path);
    bool table = n > 4 && strcmp(path + n - 4, ".csv") == 0;
    return table ? cr_test_load_table(path, CR_TEST_OWN, rules, list, err)
                 : load_scene(path, CR_TEST_OWN, list, err);
}
