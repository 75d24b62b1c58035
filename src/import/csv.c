/* Reads long tables of trajectories (CSV) with names of the user's own, which a map explains: a row
 * for each time and participant, or a row for each time with the participants side by side. */
#define _XOPEN_SOURCE 700 /* search.h declares tsearch only with it */
#include "import/reader.h"

#include "base/csv.h"
#include "base/vec.h"

#include <cjson/cJSON.h>
#include <ctype.h>
#include <math.h>
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a column may hold; its name may begin with one of `words` where the map does not name it. */
enum channel { T, X, Y, HEADING, SPEED, VX, VY, LENGTH, WIDTH, HEIGHT, MASS, WHEELBASE, CHANNELS };
static const struct {
    const char *key;
    enum cr_dim dim;
    const char *unit; /* for the hint */
    const char *words[4];
} channels[CHANNELS] = {
    [T] = {"time", CR_DIM_TIME, "s", {"time", "t", "timestamp"}},
    [X] = {"x", CR_DIM_LENGTH, "m", {"x", "pos_x", "position_x"}},
    [Y] = {"y", CR_DIM_LENGTH, "m", {"y", "pos_y", "position_y"}},
    [HEADING] = {"heading", CR_DIM_ANGLE, "deg", {"heading", "yaw", "psi"}},
    [SPEED] = {"speed", CR_DIM_SPEED, "km/h", {"speed", "v", "velocity"}},
    [VX] = {"vx", CR_DIM_SPEED, "km/h", {"vx"}},
    [VY] = {"vy", CR_DIM_SPEED, "km/h", {"vy"}},
    [LENGTH] = {"length", CR_DIM_LENGTH, "m", {"length"}},
    [WIDTH] = {"width", CR_DIM_LENGTH, "m", {"width"}},
    [HEIGHT] = {"height", CR_DIM_LENGTH, "m", {"height"}},
    [MASS] = {"mass", CR_DIM_MASS, "kg", {"mass"}},
    [WHEELBASE] = {"wheelbase", CR_DIM_LENGTH, "m", {"wheelbase"}},
};

struct column {
    int at; /* -1: none */
    const struct cr_unit *unit;
    double factor;
    bool clockwise, north; /* of a heading: how it turns, and whether 0 is north (else east) */
};

/* The columns of the one participant of a row, or of each where they stand side by side. */
struct group {
    const char *id; /* NULL: in the column of participants */
    struct column of[CHANNELS];
};
enum { GROUPS_MAX = CR_BODY_MAX };

struct table {
    struct cr_import *im;
    struct cr_csv *csv;
    struct group group[GROUPS_MAX];
    int groups;
    int part, cases; /* columns of participants and of cases, -1: none */
    const char *name;
    enum cr_point point;
    bool sick; /* the case that has begun has a fault; its other rows are passed over */
    struct cr_error fault;
    char id[CR_IMPORT_ID_MAX];
    void *seen; /* cases that are done (tsearch) */
};

/* ---- the map ---- */

static enum cr_err map_fault(const struct cr_import *im, const char *key, const char *what,
                             struct cr_error *err) {
    cr_err_set(err, CR_ERR_TYPE, "map: \"%.40s\" %s", key, what);
    cr_err_place(err, im->opts->map, 0, 0);
    cr_err_hint(err, "\"%.40s\": \"COLUMN\" or {\"column\": \"COLUMN\", \"unit\": \"ms\"}", key);
    return CR_ERR_TYPE;
}

/* Finds the column that the map names for a key, as "time": "t [ms]" or {"column": ..}; *at is -1
 * where the map is silent. */
static enum cr_err mapped(const struct table *t, const cJSON *map, const char *key, int *at,
                          struct cr_error *err) {
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(map, key);
    *at = -1;
    if (item == NULL) {
        return CR_ERR_OK;
    }
    const char *name = cJSON_GetStringValue(
        cJSON_IsObject(item) ? cJSON_GetObjectItemCaseSensitive(item, "column") : item);
    if (name == NULL) {
        return map_fault(t->im, key, "names no column", err);
    }
    return cr_csv_need(t->csv, name, at, err);
}

static bool begins(const char *name, const char *word) {
    size_t n = strlen(word);
    for (size_t i = 0; i < n; i++) {
        if (tolower((unsigned char)name[i]) != word[i]) {
            return false;
        }
    }
    return !isalnum((unsigned char)name[n]);
}

/* Finds the first column whose name begins with one of the words; -1 if there is none. */
static int named(const struct cr_csv *csv, const char *const *words, int n) {
    for (int w = 0; w < n && words[w] != NULL; w++) {
        for (int i = 0; i < cr_csv_columns(csv); i++) {
            if (begins(cr_csv_name(csv, i), words[w])) {
                return i;
            }
        }
    }
    return -1;
}

static bool flag(const cJSON *item, const char *key, const char *word) {
    const cJSON *value = cJSON_GetObjectItemCaseSensitive(item, key);
    const char *text = cJSON_GetStringValue(value);
    return word == NULL ? cJSON_IsTrue(value) : text != NULL && strcmp(text, word) == 0;
}

/* Finds the unit of a column: the map's, else that of the name or of the row of units. None is a
 * fault: to take SI for what is in mph would make a crash that never was. */
static enum cr_err unit_of(const struct table *t, enum channel ch, const cJSON *item,
                           struct column *out, struct cr_error *err) {
    const char *given = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(item, "unit"));
    enum cr_dim dim = channels[ch].dim;
    enum cr_err code = given != NULL ? cr_unit_read(given, dim, &out->unit, err)
                                     : cr_csv_unit(t->csv, out->at, dim, &out->unit, err);
    if (code != CR_ERR_OK && given != NULL) {
        cr_err_place(err, t->im->opts->map, 0, 0);
    }
    if (code == CR_ERR_OK && out->unit == NULL) {
        code = cr_csv_head_fault(t->csv, out->at, err, CR_ERR_MISSING,
                                 "column \"%.60s\" has no unit", cr_csv_name(t->csv, out->at));
        cr_err_hint(err, "name it so, \"%.40s [%s]\", or say it in the map: \"unit\": \"%s\"",
                    cr_csv_name(t->csv, out->at), channels[ch].unit, channels[ch].unit);
    }
    return code;
}

static enum cr_err find_channel(const struct table *t, const cJSON *map, enum channel ch,
                                struct column *out, struct cr_error *err) {
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(map, channels[ch].key);
    const cJSON *factor = cJSON_GetObjectItemCaseSensitive(item, "factor");
    *out = (struct column){.factor = cJSON_IsNumber(factor) ? factor->valuedouble : 1,
                           .clockwise = flag(item, "clockwise", NULL),
                           .north = flag(item, "zero", "north")};
    enum cr_err code = mapped(t, map, channels[ch].key, &out->at, err);
    if (code == CR_ERR_OK && out->at < 0 && map == t->im->map) {
        /* Side by side a bare "x" would not tell whose it is, so there the map must name it. */
        out->at = named(t->csv, channels[ch].words, 4);
    }
    return code == CR_ERR_OK && out->at >= 0 ? unit_of(t, ch, item, out, err) : code;
}

static enum cr_err lacks(const struct table *t, const char *key, struct cr_error *err) {
    cr_csv_head_fault(t->csv, 0, err, CR_ERR_MISSING, "no column is known to be the %s", key);
    cr_err_hint(err, "name it in a map (--map): {\"%s\": \"COLUMN\"}", key);
    return CR_ERR_MISSING;
}

static enum cr_err find_group(const struct table *t, const cJSON *map, struct group *out,
                              struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int ch = 0; ch < CHANNELS && code == CR_ERR_OK; ch++) {
        const cJSON *from = ch == T ? t->im->map : map; /* All share one column of times. */
        code = find_channel(t, from, (enum channel)ch, &out->of[ch], err);
    }
    static const enum channel needed[] = {T, X, Y, HEADING};
    for (size_t i = 0; i < sizeof needed / sizeof *needed && code == CR_ERR_OK; i++) {
        if (out->of[needed[i]].at < 0) {
            code = lacks(t, channels[needed[i]].key, err);
        }
    }
    bool speed = out->of[SPEED].at >= 0 || (out->of[VX].at >= 0 && out->of[VY].at >= 0);
    return code == CR_ERR_OK && !speed ? lacks(t, "speed", err) : code;
}

/* Finds the columns of participants side by side: {"participants": {"A": {"x": ..}, "B": ..}}. */
static enum cr_err find_groups(struct table *t, const cJSON *side, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (const cJSON *g = side->child; g != NULL && code == CR_ERR_OK; g = g->next) {
        if (!cJSON_IsObject(g) || t->groups == GROUPS_MAX) {
            return map_fault(t->im, "participants", "is an object with the columns of each", err);
        }
        t->group[t->groups].id = g->string;
        code = find_group(t, g, &t->group[t->groups++], err);
    }
    return code;
}

static enum cr_err find_point(struct table *t, struct cr_error *err) {
    static const char *const words[] = {
#define X(name, word) word,
        CR_POINT_LIST(X)
#undef X
    };
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(t->im->map, "reference");
    const char *given = cJSON_GetStringValue(item);
    t->point = CR_POINT_CG;
    for (int i = 0; i < CR_POINT_COUNT && given != NULL; i++) {
        if (strcmp(given, words[i]) == 0) {
            t->point = (enum cr_point)i;
            return CR_ERR_OK;
        }
    }
    if (item == NULL) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_NAME, "map: \"reference\" is one of %s", CR_POINTS);
    cr_err_place(err, t->im->opts->map, 0, 0);
    return CR_ERR_NAME;
}

static enum cr_err check_keys(const struct cr_import *im, struct cr_error *err) {
    const char *known[CHANNELS + 7] = {"vehicles", "objects", "participant", "participants",
                                       "case",     "name",    "reference"};
    for (int i = 0; i < CHANNELS; i++) {
        known[7 + i] = channels[i].key;
    }
    for (const cJSON *m = im->map != NULL ? im->map->child : NULL; m != NULL; m = m->next) {
        bool found = strncmp(m->string, "x_", 2) == 0;
        for (int i = 0; i < CHANNELS + 7; i++) {
            found = found || strcmp(m->string, known[i]) == 0;
        }
        if (!found) {
            const char *near = cr_str_nearest(m->string, known, CHANNELS + 7);
            cr_err_set(err, CR_ERR_KEY, "map: unknown key \"%.60s\"", m->string);
            cr_err_place(err, im->opts->map, 0, 0);
            cr_err_hint(err, near != NULL ? "did you mean \"%s\"?" : "see crumple-import(1), MAP%s",
                        near != NULL ? near : "");
            return CR_ERR_KEY;
        }
    }
    return CR_ERR_OK;
}

static enum cr_err find_columns(struct table *t, struct cr_error *err) {
    static const char *const part_words[] = {"participant", "vehicle", "id", "name"};
    static const char *const case_words[] = {"case"};
    const cJSON *map = t->im->map, *side = cJSON_GetObjectItemCaseSensitive(map, "participants");
    t->name = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(map, "name"));
    enum cr_err code = check_keys(t->im, err);
    code = code == CR_ERR_OK ? mapped(t, map, "case", &t->cases, err) : code;
    code = code == CR_ERR_OK ? mapped(t, map, "participant", &t->part, err) : code;
    code = code == CR_ERR_OK ? find_point(t, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    t->cases = t->cases < 0 ? named(t->csv, case_words, 1) : t->cases;
    t->part = t->part < 0 ? named(t->csv, part_words, 4) : t->part;
    if (cJSON_IsObject(side)) {
        return find_groups(t, side, err);
    }
    t->groups = 1;
    code = find_group(t, map, &t->group[0], err);
    return code == CR_ERR_OK && t->part < 0 ? lacks(t, "participant", err) : code;
}

/* ---- rows ---- */

static enum cr_err value(const struct table *t, const struct column *c, double *out,
                         struct cr_error *err) {
    *out = (double)NAN;
    if (c->at < 0) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_csv_number(t->csv, c->at, out, err);
    *out = c->factor * cr_unit_to_si(c->unit, *out);
    return code;
}

/* Takes sizes and mass from a participant's first row; they stand in every row alike. */
static void take_sizes(struct cr_participant *p, const double v[CHANNELS]) {
    p->length = v[LENGTH];
    p->width = v[WIDTH];
    p->height = v[HEIGHT];
    p->mass = v[MASS];
    p->wheelbase = v[WHEELBASE];
}

static enum cr_err empty(const struct table *t, const struct group *g, enum channel ch,
                         struct cr_error *err) {
    return cr_csv_fault(t->csv, g->of[ch].at, err, CR_ERR_MISSING, "no %s in this row",
                        channels[ch].key);
}

static enum cr_err read_group(struct table *t, const struct group *g, struct cr_error *err) {
    const char *id = g->id != NULL ? g->id : cr_csv_cell(t->csv, t->part);
    double v[CHANNELS];
    enum cr_err code = CR_ERR_OK;
    for (int ch = 0; ch < CHANNELS && code == CR_ERR_OK; ch++) {
        code = value(t, &g->of[ch], &v[ch], err);
    }
    /* Side by side, one may be there before the other: its fields are empty until then. */
    if (code != CR_ERR_OK || (g->id != NULL && isnan(v[X]) && isnan(v[Y]))) {
        return code;
    }
    v[SPEED] = g->of[SPEED].at >= 0 ? v[SPEED] : hypot(v[VX], v[VY]);
    static const enum channel needed[] = {T, X, Y, HEADING};
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++) {
        if (isnan(v[needed[i]])) {
            return empty(t, g, needed[i], err);
        }
    }
    if (isnan(v[SPEED])) {
        return empty(t, g, g->of[SPEED].at >= 0 ? SPEED : VX, err);
    }
    if (id[0] == '\0') {
        return cr_csv_fault(t->csv, t->part, err, CR_ERR_MISSING, "no participant in this row");
    }
    struct cr_participant *p = cr_import_find(t->im, id);
    if (p == NULL) {
        code = cr_import_add(t->im, id, CR_KIND_VEHICLE, &p, err);
        if (code != CR_ERR_OK) {
            return code;
        }
        take_sizes(p, v);
    }
    double heading = g->of[HEADING].clockwise ? -v[HEADING] : v[HEADING];
    struct cr_waypoint row = {.t = v[T], .pos = cr_vec2(v[X], v[Y]), .speed = v[SPEED]};
    row.heading = heading + (g->of[HEADING].north ? CR_PI / 2 : 0);
    return cr_import_row(t->im, p, &row, err);
}

/* ---- cases ---- */

static int by_text(const void *a, const void *b) {
    return strcmp(a, b);
}

/* Remembers the case that begins; one that comes back later is a fault, since it would become two
 * scenes of pieces. */
static enum cr_err remember(struct table *t, struct cr_error *err) {
    char *key = malloc(strlen(t->id) + 1);
    if (key == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the cases");
    }
    memcpy(key, t->id, strlen(t->id) + 1);
    char **node = tsearch(key, &t->seen, by_text);
    if (node == NULL) {
        free(key);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the cases");
    }
    if (*node == key) {
        return CR_ERR_OK;
    }
    free(key);
    cr_csv_fault(t->csv, t->cases, err, CR_ERR_DUPLICATE, "case %.60s comes again after others",
                 t->id);
    cr_err_hint(err, "sort the file by case, then by time");
    return CR_ERR_DUPLICATE;
}

static void forget(struct table *t) {
    while (t->seen != NULL) {
        char *key = *(char **)t->seen;
        tdelete(key, &t->seen, by_text);
        free(key);
    }
}

static enum cr_err end_case(struct table *t, struct cr_error *err) {
    return t->im->at != NULL ? cr_import_end(t->im, t->sick ? &t->fault : NULL, err) : CR_ERR_OK;
}

static enum cr_err begin_case(struct table *t, const char *id, struct cr_error *err) {
    char name[CR_NAME_MAX];
    if (strlen(id) >= sizeof t->id) {
        return cr_csv_fault(t->csv, t->cases, err, CR_ERR_RANGE, "the id of this case is too long");
    }
    memcpy(t->id, id, strlen(id) + 1);
    t->sick = false;
    enum cr_err code = remember(t, err);
    if (code != CR_ERR_OK || !cr_import_wants(t->im, id)) {
        return code;
    }
    const char *stem = t->name != NULL ? t->name : "csv";
    snprintf(name, sizeof name, id[0] != '\0' ? "%.30s-%.30s" : "%.30s%.30s", stem, id);
    code = cr_import_begin(t->im, id, name, err);
    if (code == CR_ERR_OK) {
        cr_import_point(t->im, t->point);
    }
    return code;
}

static enum cr_err read_row(struct table *t, bool first, struct cr_error *err) {
    const char *id = t->cases >= 0 ? cr_csv_cell(t->csv, t->cases) : "";
    enum cr_err code = CR_ERR_OK;
    if (first || strcmp(id, t->id) != 0) {
        code = end_case(t, err);
        code = code == CR_ERR_OK ? begin_case(t, id, err) : code;
    }
    if (code != CR_ERR_OK || t->im->at == NULL || t->sick) {
        return code;
    }
    for (int i = 0; i < t->groups && code == CR_ERR_OK; i++) {
        code = read_group(t, &t->group[i], &t->fault);
    }
    if (code != CR_ERR_OK && t->fault.line == 0) {
        cr_err_place(&t->fault, t->im->shown, cr_csv_line(t->csv), 1);
    }
    t->sick = code != CR_ERR_OK;
    return CR_ERR_OK;
}

static enum cr_err read_rows(struct table *t, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    bool row = true, first = true;
    while (code == CR_ERR_OK) {
        code = cr_csv_next(t->csv, &row, err);
        if (code != CR_ERR_OK || !row) {
            break;
        }
        code = read_row(t, first, err);
        first = false;
        /* Nothing that follows the contact of the only case is of use. */
        if (code == CR_ERR_OK && t->cases < 0 && t->im->at != NULL && cr_import_met(t->im)) {
            break;
        }
    }
    if (code == CR_ERR_OK && first) {
        code = cr_csv_head_fault(t->csv, -1, err, CR_ERR_MISSING, "a table without rows");
    }
    return code == CR_ERR_OK ? end_case(t, err) : code;
}

/* ---- the format ---- */

/* Takes every text whose first line that is no remark has separators: this is asked last, when the
 * text is of no other format. */
bool cr_import_csv_is(const struct cr_import_head *head) {
    const char *p = head->text, *end = head->text + head->len;
    if (head->folder || memchr(p, '\0', head->len) != NULL) {
        return false;
    }
    while (p < end && (*p == '#' || *p == '\n' || *p == '\r')) {
        const char *next = memchr(p, '\n', (size_t)(end - p));
        p = next != NULL ? next + 1 : end;
    }
    size_t line = strcspn(p, "\r\n");
    bool markup = *p == '<' || *p == '{' || *p == '[';
    return !markup && (memchr(p, ',', line) != NULL || memchr(p, ';', line) != NULL ||
                       memchr(p, '\t', line) != NULL);
}

enum cr_err cr_import_csv_read(struct cr_import *im, struct cr_error *err) {
    struct table t = {.im = im};
    const struct cr_csv_opts opts = {.path = im->path, .units = true};
    cr_import_format(im, "CSV");
    enum cr_err code = cr_csv_open(&opts, &t.csv, err);
    if (code == CR_ERR_OK) {
        code = find_columns(&t, err);
        code = code == CR_ERR_OK ? read_rows(&t, err) : code;
        cr_csv_close(t.csv);
    }
    forget(&t);
    return code;
}
