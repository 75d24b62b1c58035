/* Reads tables of real crashes: picks the rows that count, and makes each a case of damage. */
#include "trial/field.h"

#include "base/show.h"
#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- the filter ---- */

static enum cr_err take_rule(const struct cr_records *t, int row, struct cr_field_filter *f,
                             struct cr_error *err) {
    const struct {
        const char *name;
        double *number;
        double unit;
        char *text;
        size_t size;
    } rules[] = {
        {"min_delta_v_kmh", &f->min_delta_v, cr_mps(1), NULL, 0},
        {"max_time_ms", &f->max_time, 1e-3, NULL, 0},
        {"wrong_sign_kmh", &f->wrong_sign, cr_mps(1), NULL, 0},
        {"recorder_complete", &f->complete, 1, NULL, 0},
        {"vehicle_impacts", &f->impacts, 1, NULL, 0},
        {"occupant_kg", &f->occupant, 1, NULL, 0},
        {"super_compact_below_kg", &f->super_compact, 1, NULL, 0},
        {"mini_compact_below_kg", &f->mini_compact, 1, NULL, 0},
        {"compact_below_kg", &f->compact, 1, NULL, 0},
        {"suv_bodies", NULL, 1, f->suv_bodies, sizeof f->suv_bodies},
        {"wagon_bodies", NULL, 1, f->wagon_bodies, sizeof f->wagon_bodies},
        {"pole_objects", NULL, 1, f->poles, sizeof f->poles},
        {"tree_objects", NULL, 1, f->trees, sizeof f->trees},
    };
    const char *name = cr_records_text(t, row, "rule");
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; i++) {
        if (strcmp(rules[i].name, name) != 0) {
            continue;
        }
        if (rules[i].text != NULL) { /* The blanks make listed() find whole codes only. */
            snprintf(rules[i].text, rules[i].size, " %s ", cr_records_text(t, row, "value"));
            return CR_ERR_OK;
        }
        double x;
        enum cr_err code = cr_records_number(t, row, "value", &x, err);
        *rules[i].number = x * rules[i].unit;
        return code;
    }
    cr_err_set(err, CR_ERR_NAME, "there is no rule \"%.40s\"", name);
    cr_err_place(err, t->src, t->line[row], 0);
    return CR_ERR_NAME;
}

enum cr_err cr_field_filter_read(const char *path, struct cr_field_filter *out,
                                 struct cr_error *err) {
    struct cr_records t;
    memset(out, 0, sizeof *out);
    enum cr_err code = cr_records_load(path, &t, err);
    for (int i = 0; i < t.rows && code == CR_ERR_OK; i++) {
        code = take_rule(&t, i, out, err);
    }
    cr_records_fini(&t);
    return code;
}

static bool listed(const char *list, int number) {
    char word[16];
    snprintf(word, sizeof word, " %d ", number);
    return strstr(list, word) != NULL;
}

/* ---- rows ---- */

static const char *const columns[] = {"case",        "veh",        "event",      "object",
                                      "plane",       "curb_kg",    "field_l_cm", "c1",
                                      "edr_dv_long", "edr_dv_lat", "pdof_deg"};

bool cr_field_is(const char *path) {
    struct cr_csv *csv = NULL;
    struct cr_error err = {0};
    const struct cr_csv_opts opts = {.path = path};
    bool is = cr_csv_open(&opts, &csv, &err) == CR_ERR_OK;
    for (size_t i = 0; i < sizeof columns / sizeof columns[0] && is; i++) {
        is = cr_csv_find(csv, columns[i]) >= 0;
    }
    if (csv != NULL) {
        cr_csv_close(csv);
    }
    return is;
}

struct loading {
    const struct cr_records *t;
    const struct cr_field_filter *f;
    const struct cr_model_lib *lib;
    struct cr_field_table *out;
    struct cr_error *err;
    enum cr_err code;
};

static double number(struct loading *l, int row, const char *column) {
    double x = NAN;
    if (l->code == CR_ERR_OK) {
        l->code = cr_records_number(l->t, row, column, &x, l->err);
    }
    return x;
}

static int face_of(const struct cr_records *t, int row) {
    const char *plane = cr_records_text(t, row, "plane");
    return plane[0] == 'F'   ? CR_FACE_FRONT
           : plane[0] == 'B' ? CR_FACE_REAR
           : plane[0] == 'L' ? CR_FACE_LEFT
           : plane[0] == 'R' ? CR_FACE_RIGHT
                             : -1;
}

static bool wrong_sign(int face, double forward, double right, double limit) {
    return (face == CR_FACE_FRONT && forward > limit) ||
           (face == CR_FACE_REAR && forward < -limit) || (face == CR_FACE_LEFT && right < -limit) ||
           (face == CR_FACE_RIGHT && right > limit);
}

/* Whether a row with a recorder counts by itself; what its partner must have is asked later. */
static bool counts(struct loading *l, int i, const struct cr_field_row *row) {
    const struct cr_field_filter *f = l->f;
    int face = face_of(l->t, i);
    double main = face == CR_FACE_FRONT || face == CR_FACE_REAR ? number(l, i, "edr_long_ms")
                                                                : number(l, i, "edr_lat_ms");
    bool single = number(l, i, "veh_impacts") <= f->impacts;
    bool complete = number(l, i, "edr_complete") >= f->complete;
    return face >= 0 && single && complete && main * 1e-3 < f->max_time &&
           row->measured >= f->min_delta_v &&
           !wrong_sign(face, row->forward, row->right, f->wrong_sign);
}

/* Amount of a delta-v over the directions that were recorded. */
static double over(double forward, double right, const struct cr_field_row *row) {
    double a = isnan(row->forward) ? 0 : forward, b = isnan(row->right) ? 0 : right;
    return hypot(a, b);
}

static int partner_of(const struct cr_records *t, int i) {
    const char *event = cr_records_text(t, i, "event"), *of = cr_records_text(t, i, "case");
    for (int k = 0; k < t->rows; k++) {
        if (k != i && strcmp(cr_records_text(t, k, "case"), of) == 0 &&
            strcmp(cr_records_text(t, k, "event"), event) == 0 &&
            strcmp(cr_records_text(t, k, "veh"), cr_records_text(t, i, "object")) == 0 &&
            strcmp(cr_records_text(t, i, "veh"), cr_records_text(t, k, "object")) == 0) {
            return k;
        }
    }
    return -1;
}

static int kind_of(struct loading *l, int i, int partner) {
    int object = (int)number(l, i, "object");
    if (partner < 0) {
        return listed(l->f->poles, object)   ? CR_FIELD_POLE
               : listed(l->f->trees, object) ? CR_FIELD_TREE
                                             : -1;
    }
    int a = face_of(l->t, i), b = face_of(l->t, partner);
    bool fronts = a == CR_FACE_FRONT || b == CR_FACE_FRONT;
    int other = a == CR_FACE_FRONT ? b : a;
    return !fronts || other < 0     ? -1
           : other == CR_FACE_FRONT ? CR_FIELD_FRONT_FRONT
           : other == CR_FACE_REAR  ? CR_FIELD_FRONT_REAR
                                    : CR_FIELD_FRONT_SIDE;
}

static enum cr_type type_of(struct loading *l, int i) {
    int body = (int)number(l, i, "body");
    double mass = number(l, i, "curb_kg");
    if (listed(l->f->suv_bodies, body)) {
        return CR_TYPE_SUV;
    }
    return listed(l->f->wagon_bodies, body) ? CR_TYPE_STATION_WAGON
           : mass < l->f->super_compact     ? CR_TYPE_SUPER_COMPACT
           : mass < l->f->mini_compact      ? CR_TYPE_MINI_COMPACT
           : mass < l->f->compact           ? CR_TYPE_COMPACT
                                            : CR_TYPE_SEDAN;
}

static void take_crush(struct loading *l, int i, struct cr_measured *m) {
    cr_crush_init(m);
    m->face = (enum cr_face)face_of(l->t, i);
    m->stations = 6;
    for (int k = 0; k < 6; k++) {
        char name[13];
        snprintf(name, sizeof name, "c%d", k + 1);
        m->depth[k] = fmax(0, number(l, i, name) / 100);
    }
    m->length = number(l, i, "field_l_cm") / 100;
    m->offset = number(l, i, "field_d_cm") / 100;
    m->direct = number(l, i, "direct_w_cm") / 100;
    /* WinSMASH asks for the offset of the direct damage. */
    m->direct_offset = number(l, i, "smash_d_cm") / 100;
    m->pdof = cr_rad(number(l, i, "pdof_deg"));
}

/* Cuts what tables say beyond the car: fields wider than the car itself, forces along its face. */
static void make_possible(struct cr_measured *m, const struct cr_participant *p) {
    double span = cr_face_is_end(m->face) ? p->width : p->length, square = cr_crush_square(m->face);
    m->length = fmin(fmax(m->length, 0.1), span);
    m->offset = isnan(m->offset) ? 0 : m->offset;
    double room = (span - m->length) / 2;
    m->offset = fmin(fmax(m->offset, -room), room);
    if (isnan(m->direct) || m->direct <= 0 || isnan(m->direct_offset)) {
        m->direct = m->direct_offset = NAN;
    } else { /* The direct damage is part of the field, by more than a hair. */
        double reach = (m->length + m->direct) / 2 - 0.02;
        m->direct_offset = fmin(fmax(m->direct_offset, m->offset - reach), m->offset + reach);
    }
    double off = remainder(m->pdof - square, 2 * CR_PI), most = cr_rad(60);
    m->pdof = isnan(m->pdof) ? square : square + fmin(fmax(off, -most), most);
}

/* Opens one car of a case; its participant is kept in the arena. */
static void open_car(struct loading *l, int i, struct cr_crush_car *car) {
    struct cr_scene scene;
    struct cr_assumed assumed = {0};
    struct cr_participant *p = NULL, *wall = NULL;
    struct cr_measured m;
    double mass = number(l, i, "curb_kg"), cargo = number(l, i, "cargo_kg");
    if (l->code != CR_ERR_OK) {
        return;
    }
    cr_scene_init(&scene);
    l->code = cr_scene_add(&scene, "car", CR_KIND_VEHICLE, &p, l->err);
    if (l->code == CR_ERR_OK) {
        p->type = type_of(l, i);
        p->kerb_mass = mass; /* The structure goes by this mass, the motion by all of it. */
        p->mass = mass + l->f->occupant + (isnan(cargo) ? 0 : cargo);
        p->pos = cr_vec2(0, 0);
        l->code = cr_scene_add(&scene, "wall", CR_KIND_OBJECT, &wall, l->err);
    }
    if (l->code == CR_ERR_OK) {
        wall->shape = CR_OBJECT_WALL;
        wall->pos = cr_vec2(100, 0);
        l->code = cr_scene_resolve(&scene, l->lib, &assumed, l->err);
    }
    struct cr_participant *kept = cr_arena_take(&l->out->arena, 1, sizeof *kept);
    if (l->code == CR_ERR_OK && kept == NULL) {
        l->code = cr_err_set(l->err, CR_ERR_MEMORY, "no memory for the table");
    }
    if (l->code == CR_ERR_OK) {
        *kept = *p;
        take_crush(l, i, &m);
        make_possible(&m, kept);
        if (l->code == CR_ERR_OK) {
            l->code = cr_crush_open(l->lib, kept, &m, &l->out->arena, car, l->err);
        }
    }
    cr_assumed_fini(&assumed);
    cr_scene_fini(&scene);
}

/* Fold by a hash of the case, so that both cars of a crash are in one fold. */
static int fold_of(const char *text) {
    unsigned long h = 5381;
    for (; *text != '\0'; text++) {
        h = (h * 33 + (unsigned char)*text) & 0xffffffffUL;
    }
    return (int)(h % CR_FIELD_FOLDS);
}

static bool has_mass(struct loading *l, int i) {
    return number(l, i, "curb_kg") > 0;
}

/* Takes delta-v of the recorder, and of WinSMASH in the same directions. */
static void take_speeds(struct loading *l, int i, struct cr_field_row *row) {
    row->forward = cr_mps(number(l, i, "edr_dv_long"));
    row->right = cr_mps(number(l, i, "edr_dv_lat"));
    row->measured = over(row->forward, row->right, row);
    row->smash_forward = cr_mps(number(l, i, "ws_dv_long"));
    row->smash_right = cr_mps(number(l, i, "ws_dv_lat"));
    row->winsmash = over(row->smash_forward, row->smash_right, row);
    row->winsmash = row->winsmash > 0 ? row->winsmash : (double)NAN;
    row->value = NAN;
}

static void take_row(struct loading *l, int i) {
    struct cr_field_row *row = &l->out->row[l->out->n];
    memset(row, 0, sizeof *row);
    take_speeds(l, i, row);
    if (isnan(row->forward) && isnan(row->right)) {
        return;
    }
    int partner = partner_of(l->t, i), kind = kind_of(l, i, partner);
    if (kind < 0 || !counts(l, i, row) || !has_mass(l, i) ||
        (partner >= 0 && !has_mass(l, partner))) {
        l->out->dropped++;
        return;
    }
    row->kind = (enum cr_field_kind)kind;
    row->line = l->t->line[i];
    row->fold = fold_of(cr_records_text(l->t, i, "case"));
    row->what = (struct cr_crush_case){
        .n = partner >= 0 ? 2 : 1, .object = partner < 0, .object_mass = NAN, .restitution = NAN};
    snprintf(row->name, sizeof row->name, "%.24s/%.8s", cr_records_text(l->t, i, "case"),
             cr_records_text(l->t, i, "veh"));
    cr_show_mask(row->name);
    open_car(l, i, &row->what.car[0]);
    if (partner >= 0) {
        open_car(l, partner, &row->what.car[1]);
    }
    l->out->n += l->code == CR_ERR_OK;
}

enum cr_err cr_field_load(const char *path, const struct cr_field_filter *filter,
                          const struct cr_model_lib *lib, struct cr_field_table *out,
                          struct cr_error *err) {
    struct cr_records t;
    memset(out, 0, sizeof *out);
    struct loading l = {.t = &t, .f = filter, .lib = lib, .out = out, .err = err};
    l.code = cr_records_load(path, &t, err);
    for (size_t i = 0; i < sizeof columns / sizeof columns[0] && l.code == CR_ERR_OK; i++) {
        if (cr_records_find(&t, columns[i]) < 0) {
            l.code = cr_err_set(err, CR_ERR_MISSING, "the table has no column \"%s\"", columns[i]);
            cr_err_place(err, path, 0, 0);
        }
    }
    if (l.code == CR_ERR_OK) {
        out->row = calloc((size_t)t.rows + 1, sizeof *out->row);
        l.code = out->row != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory");
    }
    for (int i = 0; i < t.rows && l.code == CR_ERR_OK; i++) {
        take_row(&l, i);
        if (l.code != CR_ERR_OK && err != NULL && err->line == 0) {
            cr_err_place(err, path, t.line[i], 0);
        }
    }
    cr_records_fini(&t);
    if (l.code != CR_ERR_OK) {
        cr_field_fini(out);
    }
    return l.code;
}

void cr_field_fini(struct cr_field_table *field) {
    free(field->row);
    cr_arena_free(&field->arena);
    memset(field, 0, sizeof *field);
}
