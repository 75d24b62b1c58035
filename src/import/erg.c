/* Reads results of CarMaker: NAME.erg, which holds records of bytes, beside NAME.erg.info, which
 * describes them. The car under test and its traffic become participants; places are those of the
 * middle of the rear end, where CarMaker has the origin of its vehicles. */
#include "import/erg_priv.h"

#include "base/file.h"
#include "base/units.h"

#include <cjson/cJSON.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is read of a participant; its speed is made of vx and vy where the records have no v. */
enum channel { CH_X, CH_Y, CH_YAW, CH_V, CH_VX, CH_VY, CHANNELS };
static const struct {
    const char *key; /* of the map */
    const char *car[2], *traffic;
    enum cr_dim dim;
} channels[CHANNELS] = {
    [CH_X] = {"x", {"Car.Fr1.tx", "Car.tx"}, "tx", CR_DIM_LENGTH},
    [CH_Y] = {"y", {"Car.Fr1.ty", "Car.ty"}, "ty", CR_DIM_LENGTH},
    [CH_YAW] = {"heading", {"Car.Yaw", "Car.Fr1.rz"}, "rz", CR_DIM_ANGLE},
    [CH_V] = {"speed", {"Car.v", "Car.vx"}, "LongVel", CR_DIM_SPEED},
    [CH_VX] = {"vx", {"Car.Fr1.vx", "Car.vx"}, "v_0.x", CR_DIM_SPEED},
    [CH_VY] = {"vy", {"Car.Fr1.vy", "Car.vy"}, "v_0.y", CR_DIM_SPEED},
};
enum { CARS = 256 };

struct moving {
    char id[CR_ERG_NAME];
    struct cr_participant *p;
    int at[CHANNELS];
};

struct carmaker {
    struct cr_import *im;
    struct cr_erg erg;
    char data[CR_PATH_MAX + 8], info[CR_PATH_MAX + 8];
    int time;
    struct moving car[CARS];
    int n;
};

bool cr_import_erg_is(const struct cr_import_head *head) {
    size_t n = strlen(head->name);
    char info[CR_PATH_MAX + 8];
    if (head->folder) {
        return false;
    }
    if (strncmp(head->text, "#INFOFILE1", 10) == 0 && strstr(head->text, "File.At.1.") != NULL) {
        return true;
    }
    /* Records say nothing of themselves, so only a description beside the file tells. */
    snprintf(info, sizeof info, "%.511s.info", head->path);
    return n > 4 && strcmp(head->name + n - 4, ".erg") == 0 &&
           cr_file_check_regular(info, NULL) == CR_ERR_OK;
}

/* ---- quantities ---- */

static double si(const struct carmaker *cm, int i, const unsigned char *record, enum cr_dim dim) {
    const struct cr_unit *unit = cr_unit_spelled(cm->erg.quantity[i].unit, dim);
    double x = cr_erg_value(&cm->erg, i, record);
    return unit != NULL ? cr_unit_to_si(unit, x) : x;
}

static enum cr_err lacks(const struct carmaker *cm, const char *id, const char *what,
                         struct cr_error *err) {
    cr_err_set(err, CR_ERR_MISSING, "%.60s: no quantity %.60s", id, what);
    cr_err_place(err, cm->info, 0, 0);
    cr_err_hint(err,
                "record it, or name another in a map: {\"participants\": {\"%.30s\": {\"x\": "
                "\"QUANTITY\"}}}",
                id);
    return CR_ERR_MISSING;
}

static enum cr_err check_unit(const struct carmaker *cm, int i, enum cr_dim dim,
                              struct cr_error *err) {
    const struct cr_erg_quantity *q = &cm->erg.quantity[i];
    if (q->unit[0] == '\0' || cr_unit_spelled(q->unit, dim) != NULL) {
        return CR_ERR_OK; /* A quantity without unit is in SI, in which CarMaker computes. */
    }
    cr_err_set(err, CR_ERR_NAME, "%.60s: the unit \"%.20s\" is not one of %s", q->name, q->unit,
               cr_dim_word(dim));
    cr_err_place(err, cm->info, 0, 0);
    return CR_ERR_NAME;
}

static const char *mapped(const cJSON *own, const char *key) {
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(own, key);
    item = cJSON_IsObject(item) ? cJSON_GetObjectItemCaseSensitive(item, "column") : item;
    return cJSON_GetStringValue(item);
}

static enum cr_err find_channels(const struct carmaker *cm, struct moving *m, const cJSON *own,
                                 struct cr_error *err) {
    char name[2 * CR_ERG_NAME];
    bool car = strcmp(m->id, "Car") == 0;
    enum cr_err code = CR_ERR_OK;
    for (int ch = 0; ch < CHANNELS && code == CR_ERR_OK; ch++) {
        const char *given = mapped(own, channels[ch].key);
        m->at[ch] = -1;
        for (int k = 0; k < (car ? 2 : 1) && m->at[ch] < 0 && given == NULL; k++) {
            if (car) {
                snprintf(name, sizeof name, "%s", channels[ch].car[k]);
            } else {
                snprintf(name, sizeof name, "Traffic.%s.%s", m->id, channels[ch].traffic);
            }
            m->at[ch] = cr_erg_find(&cm->erg, name);
        }
        if (given != NULL && (m->at[ch] = cr_erg_find(&cm->erg, given)) < 0) {
            return lacks(cm, m->id, given, err);
        }
        if (m->at[ch] < 0 && ch <= CH_YAW) {
            return lacks(cm, m->id, car ? channels[ch].car[0] : name, err);
        }
        code = m->at[ch] >= 0 ? check_unit(cm, m->at[ch], channels[ch].dim, err) : CR_ERR_OK;
    }
    if (code == CR_ERR_OK && m->at[CH_V] < 0 && (m->at[CH_VX] < 0 || m->at[CH_VY] < 0)) {
        snprintf(name, sizeof name, "Traffic.%s.%s", m->id, channels[CH_V].traffic);
        code = lacks(cm, m->id, car ? channels[CH_V].car[0] : name, err);
    }
    return code;
}

static enum cr_err add_car(struct carmaker *cm, const char *id, const cJSON *own,
                           struct cr_error *err) {
    if (cm->n == CARS) {
        return cr_err_set(err, CR_ERR_RANGE, "more than %d cars", CARS);
    }
    struct moving *m = &cm->car[cm->n++];
    snprintf(m->id, sizeof m->id, "%.127s", id);
    enum cr_err code = find_channels(cm, m, own, err);
    return code == CR_ERR_OK ? cr_import_add(cm->im, id, CR_KIND_VEHICLE, &m->p, err) : code;
}

/* Finds the car and what has a place under "Traffic.", or those that a map names. */
static enum cr_err find_cars(struct carmaker *cm, struct cr_error *err) {
    const cJSON *named = cJSON_GetObjectItemCaseSensitive(cm->im->map, "participants");
    enum cr_err code = CR_ERR_OK;
    cm->time = cr_erg_find(&cm->erg, "Time");
    if (cm->time < 0) {
        return lacks(cm, "all", "Time", err);
    }
    code = check_unit(cm, cm->time, CR_DIM_TIME, err);
    if (cJSON_IsObject(named)) {
        for (const cJSON *p = named->child; p != NULL && code == CR_ERR_OK; p = p->next) {
            code = add_car(cm, p->string, p, err);
        }
        return code;
    }
    code = code == CR_ERR_OK ? add_car(cm, "Car", NULL, err) : code;
    for (int i = 0; i < cm->erg.n && code == CR_ERR_OK; i++) {
        char id[CR_ERG_NAME];
        const char *name = cm->erg.quantity[i].name;
        size_t n = strlen(name);
        if (strncmp(name, "Traffic.", 8) != 0 || n < 12 || strcmp(name + n - 3, ".tx") != 0) {
            continue;
        }
        snprintf(id, sizeof id, "%.*s", (int)(n - 11), name + 8);
        code = strchr(id, '.') == NULL ? add_car(cm, id, NULL, err) : CR_ERR_OK;
    }
    return code;
}

/* ---- records ---- */

static enum cr_err give_row(struct carmaker *cm, struct moving *m, const unsigned char *record,
                            long number, struct cr_error *err) {
    double v[CHANNELS];
    for (int ch = 0; ch < CHANNELS; ch++) {
        v[ch] = m->at[ch] >= 0 ? si(cm, m->at[ch], record, channels[ch].dim) : (double)NAN;
    }
    const struct cr_waypoint row = {.t = si(cm, cm->time, record, CR_DIM_TIME),
                                    .pos = cr_vec2(v[CH_X], v[CH_Y]),
                                    .heading = v[CH_YAW],
                                    .speed =
                                        m->at[CH_V] >= 0 ? v[CH_V] : hypot(v[CH_VX], v[CH_VY])};
    enum cr_err code = cr_import_row(cm->im, m->p, &row, err);
    if (code != CR_ERR_OK) {
        char text[200];
        snprintf(text, sizeof text, "%.199s", err->text);
        cr_err_set(err, code, "record %ld: %s", number, text);
        cr_err_place(err, cm->data, 0, 0);
    }
    return code;
}

static enum cr_err read_records(struct carmaker *cm, FILE *file, unsigned char *record,
                                struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    size_t n = fread(record, 1, CR_ERG_HEADER, file), whole = (size_t)cm->erg.record;
    for (long k = 1; code == CR_ERR_OK && n > 0 && !cr_import_met(cm->im); k++) {
        n = fread(record, 1, whole, file);
        if (n > 0 && n < whole) {
            cr_err_set(err, CR_ERR_SYNTAX,
                       "record %ld has %zu bytes, not the %zu of its description", k, n, whole);
            cr_err_place(err, cm->data, 0, 0);
            cr_err_hint(err, "the file was cut, or is of another test run than its .info");
            code = CR_ERR_SYNTAX;
        }
        for (int i = 0; i < cm->n && code == CR_ERR_OK && n == whole; i++) {
            code = give_row(cm, &cm->car[i], record, k, err);
        }
    }
    if (ferror(file) != 0) {
        code = cr_err_set(err, CR_ERR_IO, "cannot read: %s", strerror(errno));
        cr_err_place(err, cm->data, 0, 0);
    }
    return code;
}

static enum cr_err read_case(struct carmaker *cm, struct cr_error *err) {
    cr_import_point(cm->im, CR_POINT_REAR);
    enum cr_err code = find_cars(cm, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    size_t room = (size_t)cm->erg.record > CR_ERG_HEADER ? (size_t)cm->erg.record : CR_ERG_HEADER;
    unsigned char *record = malloc(room);
    FILE *file = fopen(cm->data, "rb");
    if (record == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for a record");
    } else if (file == NULL) {
        code = cr_err_set(err, CR_ERR_IO, "cannot open: %s", strerror(errno));
        cr_err_place(err, cm->data, 0, 0);
    } else {
        code = read_records(cm, file, record, err);
    }
    if (file != NULL) {
        fclose(file);
    }
    free(record);
    return code;
}

/* ---- the files ---- */

/* Finds both files by the one that is given, which may be either. */
static enum cr_err find_files(struct carmaker *cm, struct cr_error *err) {
    const char *path = cm->im->path;
    size_t n = strlen(path);
    bool is_info = n > 5 && strcmp(path + n - 5, ".info") == 0;
    if (n >= CR_PATH_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "too long a path");
    }
    snprintf(cm->info, sizeof cm->info, "%s%s", path, is_info ? "" : ".info");
    snprintf(cm->data, sizeof cm->data, "%.*s", (int)(is_info ? n - 5 : n), path);
    enum cr_err code = cr_file_check_regular(is_info ? cm->data : cm->info, err);
    if (code != CR_ERR_OK) {
        cr_err_hint(err, "NAME.erg and NAME.erg.info belong together");
        return code;
    }
    return cr_import_also(cm->im, is_info ? cm->data : cm->info, err);
}

static enum cr_err read_info(struct carmaker *cm, struct cr_error *err) {
    char *text;
    size_t len;
    enum cr_err code = cr_file_read_regular(cm->info, &text, &len, err);
    if (code == CR_ERR_OK) {
        code = cr_erg_parse(text, cm->info, &cm->erg, err);
        free(text);
    }
    return code;
}

enum cr_err cr_import_erg_read(struct cr_import *im, struct cr_error *err) {
    struct cr_error why;
    struct carmaker *cm = calloc(1, sizeof *cm);
    if (cm == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a file of CarMaker");
    }
    cm->im = im;
    cr_import_format(im, "CarMaker ERG");
    enum cr_err code = find_files(cm, err);
    code = code == CR_ERR_OK ? read_info(cm, err) : code;
    code = code == CR_ERR_OK ? cr_import_begin(im, "", "carmaker", err) : code;
    if (code == CR_ERR_OK) {
        enum cr_err fault = read_case(cm, &why);
        code = cr_import_end(im, fault != CR_ERR_OK ? &why : NULL, err);
    }
    cr_erg_fini(&cm->erg);
    free(cm);
    return code;
}
