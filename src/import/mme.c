/* Reads crash tests in ISO-MME (ISO/TS 13499): a folder with TEST.mme, which says what met what,
 * and the channels in Channel/. A test of one vehicle before a fixed barrier or pole, or of two
 * vehicles front to front, becomes a scene; what was measured goes with it as x_expect. */
#include "import/reader.h"
#include "result/mme.h"

#include "base/csv.h"
#include "base/file.h"
#include "base/number.h"
#include "base/tree.h"
#include "base/units.h"

#include <cjson/cJSON.h>
#include <ctype.h>
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { OBJECTS = 9 };
static const double before = 0.2;       /* s that the scene has before the outlines meet, about */
static const double pole = 0.254;       /* diameter of the usual rigid pole, m */
static const double whole_crash = 0.05; /* s that a channel must reach beyond 0 to hold the crash */

struct object {
    int number;
    const char *name;
    bool barrier, pole;
    char side; /* of the impact: F, R (rear), L, I (right); 0: not told */
    struct cr_participant *p;
    char id[24];
};

struct test {
    struct cr_import *im;
    char dir[CR_PATH_MAX], file[2 * CR_PATH_MAX];
    struct cr_mme mme;
    struct object object[OBJECTS];
    int n;
};

/* ---- the folder ---- */

static int ends(const char *name, const char *with) {
    size_t n = strlen(name), m = strlen(with);
    return n > m && strcasecmp(name + n - m, with) == 0;
}

static int is_mme(const struct dirent *entry) {
    return ends(entry->d_name, ".mme");
}

bool cr_import_mme_is(const struct cr_import_head *head) {
    struct cr_folder folder;
    if (!head->folder) {
        return ends(head->name, ".mme") && strchr(head->text, ':') != NULL;
    }
    /* what cannot be listed is of no format, which is told */
    bool any =
        cr_folder_list(head->path, is_mme, false, &folder, NULL) == CR_ERR_OK && folder.n > 0;
    cr_folder_fini(&folder);
    return any;
}

/* Finds the .mme of a folder, or takes the .mme that is given itself. */
static enum cr_err find_file(struct test *t, struct cr_error *err) {
    struct cr_folder folder;
    if (ends(t->im->path, ".mme") && cr_file_check_regular(t->im->path, NULL) == CR_ERR_OK) {
        cr_file_dir(t->im->path, t->dir, sizeof t->dir);
        snprintf(t->file, sizeof t->file, "%.1000s", t->im->path);
        return CR_ERR_OK;
    }
    enum cr_err code = cr_folder_list(t->im->path, is_mme, false, &folder, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    int n = folder.n;
    if (n == 1) {
        snprintf(t->dir, sizeof t->dir, "%.511s", t->im->path);
        snprintf(t->file, sizeof t->file, "%.511s/%.255s", t->im->path, folder.entry[0]->d_name);
    }
    cr_folder_fini(&folder);
    if (n != 1) {
        cr_err_set(err, CR_ERR_MISSING,
                   n > 1 ? "more than one .mme file in the folder" : "no .mme file in the folder");
        cr_err_place(err, t->im->shown, 0, 0);
        return CR_ERR_MISSING;
    }
    return cr_import_also(t->im, t->file, err);
}

/* ---- test objects ---- */

static const char *of_object(const struct test *t, const char *key, int number, int *line) {
    char name[80];
    snprintf(name, sizeof name, "%s %d", key, number);
    return cr_mme_get(&t->mme, name, line);
}

static bool says(const char *text, const char *word) {
    size_t n = strlen(word);
    for (; text != NULL && *text != '\0'; text++) {
        if (strncasecmp(text, word, n) == 0) {
            return true;
        }
    }
    return false;
}

/* Reads a value with its unit, "50.1 km/h", or without, "13.92", in SI. Errors: TYPE, NAME, with
 * the line. */
static enum cr_err quantity(const struct test *t, const char *key, int number, enum cr_dim dim,
                            double *out, struct cr_error *err) {
    int line = 0;
    const char *text = of_object(t, key, number, &line);
    *out = NAN;
    if (text == NULL) {
        return CR_ERR_OK;
    }
    char tight[64];
    size_t n = 0;
    for (const char *p = text; *p != '\0' && n + 1 < sizeof tight; p++) {
        if (*p != ' ') {
            tight[n++] = dim == CR_DIM_MASS ? (char)tolower((unsigned char)*p) : *p;
        }
    }
    tight[n] = '\0';
    enum cr_err code = cr_unit_parse(tight, dim, NULL, out, NULL, err);
    if (code != CR_ERR_OK) {
        char what[160];
        snprintf(what, sizeof what, "%.159s", err->text);
        cr_err_set(err, code, "%s %d: %s", key, number, what);
        cr_err_place(err, t->file, line, 0);
    }
    return code;
}

static char side_of(const char *word) {
    return word == NULL                      ? '\0'
           : strncasecmp(word, "FR", 2) == 0 ? 'F'
           : strncasecmp(word, "RE", 2) == 0 ? 'R'
           : strncasecmp(word, "LE", 2) == 0 ? 'L'
           : strncasecmp(word, "RI", 2) == 0 ? 'I'
                                             : '?';
}

static void look_at(struct test *t, int number) {
    struct object *o = &t->object[t->n++];
    const char *type = of_object(t, "Type of test object", number, NULL);
    const char *class = of_object(t, "Class of test object", number, NULL);
    const char *name = of_object(t, "Name of test object", number, NULL);
    *o = (struct object){.number = number, .name = name != NULL ? name : ""};
    o->pole = says(name, "pole") || says(class, "pole") || says(type, "pole");
    o->barrier = o->pole || says(name, "barrier") || says(name, "wall") || says(class, "barrier") ||
                 says(class, "wall") || says(type, "barrier") ||
                 (type != NULL && (strcmp(type, "B") == 0 || strcmp(type, "M") == 0));
    o->side = side_of(of_object(t, "Impact side test object", number, NULL));
    snprintf(o->id, sizeof o->id, "%s%d", o->barrier ? "barrier" : "V", number);
}

static enum cr_err lacks(const struct test *t, const struct object *o, const char *what,
                         struct cr_error *err) {
    cr_err_set(err, CR_ERR_MISSING, "test object %d \"%.40s\": no \"%s %d\"", o->number, o->name,
               what, o->number);
    cr_err_place(err, t->file, 0, 0);
    cr_err_hint(err, "write it into the .mme file; the channels can be compared without it");
    return CR_ERR_MISSING;
}

static enum cr_err add_vehicle(struct test *t, struct object *o, struct cr_error *err) {
    double lateral;
    enum cr_err code = cr_import_add(t->im, o->id, CR_KIND_VEHICLE, &o->p, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = quantity(t, "Velocity test object", o->number, CR_DIM_SPEED, &o->p->speed, err);
    code = code == CR_ERR_OK
               ? quantity(t, "Velocity lat test object", o->number, CR_DIM_SPEED, &lateral, err)
               : code;
    code = code == CR_ERR_OK
               ? quantity(t, "Mass test object", o->number, CR_DIM_MASS, &o->p->mass, err)
               : code;
    if (code == CR_ERR_OK && isnan(o->p->speed)) {
        code = lacks(t, o, "Velocity test object", err);
    }
    if (code == CR_ERR_OK && isnan(o->p->mass)) {
        code = lacks(t, o, "Mass test object", err);
    }
    if (code == CR_ERR_OK && !isnan(lateral) && lateral != 0) {
        cr_import_note(t->im, "lateral velocity of %s not taken", o->id);
    }
    return code;
}

/* Takes length and width of a test object; numbers of mm are told from m by their size. */
static void take_size(const struct test *t, struct object *o) {
    char first[32];
    const char *text = of_object(t, "Dimensions test object", o->number, NULL);
    text = text != NULL ? text : of_object(t, ".Dimension test object", o->number, NULL);
    const char *comma = text != NULL ? strchr(text, ',') : NULL;
    double length, width;
    if (comma == NULL || comma - text > 30) {
        return;
    }
    snprintf(first, sizeof first, "%.*s", (int)(comma - text), text);
    if (cr_csv_scan(first, false, &length) && cr_csv_scan(comma + 1, false, &width)) {
        double unit = length > 100 ? 1e-3 : 1;
        o->p->length = cr_round12(length * unit);
        o->p->width = cr_round12(width * unit);
    }
}

/* ---- what meets what ---- */

/* Distance in m from the CG to the barrier. Of a car of unknown size it is that of the largest: no
 * type is longer than 6 m or wider than 2.1 m. Sideways it begins close, because the tyres would
 * brake the car, which is carried in the test. */
static double gap(const struct object *o) {
    double width = isnan(o->p->width) ? 2.1 : o->p->width;
    if (o->side == 'L' || o->side == 'I') {
        return cr_round_decimals(width / 2 + pole / 2 + 0.05, 3);
    }
    double length = isnan(o->p->length) ? 6 : o->p->length;
    return cr_round_decimals(length + before * o->p->speed, 3);
}

static enum cr_err before_barrier(struct test *t, struct object *car, struct object *barrier,
                                  struct cr_error *err) {
    static const struct {
        char side;
        double bearing; /* rad, counter-clockwise from ahead */
    } sides[] = {{'F', 0}, {'L', CR_PI / 2}, {'R', CR_PI}, {'I', -CR_PI / 2}};
    struct cr_participant *p;
    double bearing = 0;
    for (int i = 0; i < 4; i++) {
        bearing = sides[i].side == car->side ? sides[i].bearing : bearing;
    }
    if (car->side == '\0' || car->side == '?') {
        cr_import_note(t->im, "impact taken to be frontal");
    }
    enum cr_err code =
        cr_import_add(t->im, barrier != NULL ? barrier->id : "barrier", CR_KIND_OBJECT, &p, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    bool is_pole = barrier != NULL && barrier->pole;
    p->shape = is_pole ? CR_OBJECT_POLE : CR_OBJECT_WALL;
    p->radius = is_pole ? pole / 2 : p->radius;
    double far = gap(car);
    p->pos =
        cr_vec2(cr_round_decimals(far * cos(bearing), 3), cr_round_decimals(far * sin(bearing), 3));
    p->heading = is_pole ? 0 : cr_angle_wrap(bearing + CR_PI);
    if (bearing != 0) {
        car->p->course = cr_angle_wrap(bearing);
    }
    if (is_pole) {
        cr_import_note(t->im, "a pole of %g mm before the CG", pole * 1e3);
    }
    return CR_ERR_OK;
}

static enum cr_err front_to_front(struct test *t, struct object *a, struct object *b,
                                  struct cr_error *err) {
    if (a->side != 'F' || b->side != 'F') {
        const struct object *o = a->side != 'F' ? a : b;
        cr_err_set(err, CR_ERR_TYPE,
                   "the file does not say how two vehicles meet, unless both with the front: "
                   "\"Impact side test object %d\"",
                   o->number);
        cr_err_place(err, t->file, 0, 0);
        cr_err_hint(err, "place them in a scene by hand; the channels can be compared with it");
        return CR_ERR_TYPE;
    }
    b->p->heading = CR_PI;
    b->p->pos = cr_vec2(gap(a) + gap(b), 0);
    cr_import_note(t->im, "the vehicles meet front to front over the full width");
    return CR_ERR_OK;
}

static enum cr_err arrange(struct test *t, struct cr_error *err) {
    struct object *car[OBJECTS], *barrier = NULL;
    int cars = 0;
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < t->n && code == CR_ERR_OK; i++) {
        struct object *o = &t->object[i];
        if (o->barrier) {
            barrier = o;
            continue;
        }
        car[cars++] = o;
        code = add_vehicle(t, o, err);
        if (code == CR_ERR_OK) {
            take_size(t, o);
        }
    }
    const char *type =
        barrier != NULL ? of_object(t, "Type of test object", barrier->number, NULL) : NULL;
    bool mobile =
        barrier != NULL && (says(barrier->name, "mobile") || says(barrier->name, "MPDB") ||
                            says(barrier->name, "MDB") || (type != NULL && strcmp(type, "M") == 0));
    if (code != CR_ERR_OK) {
        return code;
    }
    if (cars == 1 && !mobile && t->n <= 2) {
        return before_barrier(t, car[0], barrier, err);
    }
    if (cars == 2 && t->n == 2) {
        return front_to_front(t, car[0], car[1], err);
    }
    cr_err_set(err, CR_ERR_TYPE, "a test of %d vehicles%s has no scene", cars,
               mobile            ? " and a mobile barrier, of which there is no model,"
               : barrier != NULL ? " and a barrier"
                                 : "");
    cr_err_place(err, t->file, 0, 0);
    return CR_ERR_TYPE;
}

/* ---- channels ---- */

struct measured {
    struct test *t;
    cJSON *expect, *list;
};

static enum cr_err use_channel(void *user, const char *path, const char *name,
                               struct cr_error *err) {
    const struct measured *m = user;
    struct cr_mme_channel ch;
    enum cr_err code = cr_mme_channel_load(path, &ch, err);
    const struct cr_unit *unit =
        code == CR_ERR_OK ? cr_unit_spelled(ch.unit, CR_DIM_ACCELERATION) : NULL;
    bool x = cr_mme_is_accel(ch.code, 'X');
    for (int i = 0; i < m->t->n && code == CR_ERR_OK && unit != NULL; i++) {
        const struct object *o = &m->t->object[i];
        if (o->p == NULL || ch.code[0] - '0' != o->number ||
            !(x || cr_mme_is_accel(ch.code, 'Y'))) {
            continue;
        }
        cJSON *item = cJSON_CreateObject();
        cJSON *own = cJSON_GetObjectItemCaseSensitive(m->expect, o->id);
        cr_tree_text(item, "participant", o->id);
        cr_tree_text(item, "file", name);
        cr_tree_text(item, "code", ch.code);
        cr_tree_text(item, "unit", ch.unit);
        cr_tree_push(m->list, item);
        double at = cr_channel_furthest(&ch.samples);
        if (x && own == NULL && ch.samples.t[ch.samples.n - 1] >= whole_crash) {
            double dv = cr_kmh(cr_unit_to_si(unit, cr_channel_integral(&ch.samples, at)));
            own = cr_tree_object(m->expect, o->id);
            cr_tree_number(own, "delta_v_forward_kmh", cr_round_decimals(dv, 2));
        }
    }
    cr_channel_fini(&ch.samples);
    return code;
}

static enum cr_err measured(struct test *t, cJSON *extra, struct cr_error *err) {
    struct measured m = {t, cr_tree_object(extra, "x_expect"), cr_tree_array(extra, "x_channels")};
    return cr_mme_channels(t->dir, use_channel, &m, err);
}

/* ---- the test ---- */

static enum cr_err read_case(struct test *t, struct cr_error *err) {
    double n;
    enum cr_err code = cr_mme_number(&t->mme, t->file, "Number of test objects", &n, err);
    if (code == CR_ERR_OK && !(n >= 1 && n <= OBJECTS)) {
        code =
            cr_err_set(err, CR_ERR_MISSING, "no \"Number of test objects\" from 1 to %d", OBJECTS);
        cr_err_place(err, t->file, 0, 0);
    }
    for (int i = 1; code == CR_ERR_OK && i <= (int)n; i++) {
        look_at(t, i);
    }
    code = code == CR_ERR_OK ? arrange(t, err) : code;
    cJSON *extra = code == CR_ERR_OK ? cJSON_CreateObject() : NULL;
    if (code == CR_ERR_OK) {
        code = measured(t, extra, err);
    }
    return cr_import_extra(t->im, code, extra, err);
}

enum cr_err cr_import_mme_read(struct cr_import *im, struct cr_error *err) {
    struct cr_error why;
    struct test *t = calloc(1, sizeof *t);
    if (t == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a test");
    }
    t->im = im;
    cr_import_format(im, "ISO-MME");
    enum cr_err code = find_file(t, err);
    code = code == CR_ERR_OK ? cr_mme_load(t->file, &t->mme, err) : code;
    if (code == CR_ERR_OK) {
        const char *title = cr_mme_get(&t->mme, "Title", NULL);
        code = cr_import_begin(im, "", title != NULL ? title : "mme", err);
    }
    if (code == CR_ERR_OK) {
        enum cr_err fault = read_case(t, &why);
        code = cr_import_end(im, fault != CR_ERR_OK ? &why : NULL, err);
    }
    cr_mme_fini(&t->mme);
    free(t);
    return code;
}
