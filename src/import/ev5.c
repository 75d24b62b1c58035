/* Reads crash tests of NHTSA: an EV5 file, and beside it the channels that it lists (".001" ...).
 * It becomes the scene of the test, with what was measured as x_expect.
 *
 * Fields have their meaning by their place; the places were found by the count of fields and by the
 * values of tests 10146 and 7292. The impact angle is taken as the bearing, clockwise from ahead of
 * the struck vehicle, from which the blow comes: test 7292 and the side pole tests have it so. */
#include "base/file.h"
#include "base/number.h"
#include "base/tree.h"
#include "base/units.h"
#include "import/reader.h"
#include "result/channel.h"
#include "result/ev5.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { /* TEST */ T_CONFIGURATION = 9, T_ANGLE = 16, T_OFFSET = 17 };
enum { /* VEHICLE */
       V_NUMBER = 1,
       V_MASS = 11,
       V_KERB = 12,
       V_WHEELBASE = 13,
       V_LENGTH = 14,
       V_WIDTH = 15,
       V_CG = 16,
       V_SPEED = 42,
       V_CRAB = 43,
       V_DPD = 48,
       V_CRUSH = 57
};
/* Diameter of the rigid pole of side tests, m. */
static const double pole = 0.254;
/* The scene begins about this long before the outlines meet, s. */
static const double before = 0.2;
/* A channel must reach this far beyond its 0 to hold the whole crash, s. */
static const double whole_crash = 0.05;

enum { VEHICLES = 2 };

struct test {
    struct cr_import *im;
    struct cr_ev5 ev5;
    const struct cr_ev5_record *test, *vehicle[VEHICLES];
    struct cr_participant *car[VEHICLES];
    int n;
    double angle, offset; /* rad clockwise, m */
    cJSON *expect, *channels;
};

bool cr_import_ev5_is(const struct cr_import_head *head) {
    return strstr(head->text, "----- EV5 -----") != NULL ||
           (strncmp(head->text, "-----", 5) == 0 && strstr(head->text, "\nV5|") != NULL);
}

/* ---- vehicles ---- */

static enum cr_err add_vehicle(struct test *t, const struct cr_ev5_record *r,
                               struct cr_error *err) {
    static const struct {
        int field;
        const char *what;
        size_t at;
        double unit;
        bool needed;
    } values[] = {
        {V_MASS, "the test mass is not recorded", offsetof(struct cr_participant, mass), 1, true},
        {V_KERB, "", offsetof(struct cr_participant, kerb_mass), 1, false},
        {V_WHEELBASE, "", offsetof(struct cr_participant, wheelbase), 1e-3, false},
        {V_LENGTH, "the length is not recorded", offsetof(struct cr_participant, length), 1e-3,
         true},
        {V_WIDTH, "the width is not recorded", offsetof(struct cr_participant, width), 1e-3, true},
        {V_CG, "", offsetof(struct cr_participant, cg_behind_front_axle), 1e-3, false},
    };
    struct cr_participant *p;
    int i = t->n;
    char id[16];
    snprintf(id, sizeof id, "V%.10s", cr_ev5_text(r, V_NUMBER));
    enum cr_err code = cr_import_add(t->im, id, CR_KIND_VEHICLE, &p, err);
    for (size_t k = 0; k < sizeof values / sizeof values[0] && code == CR_ERR_OK; k++) {
        double x;
        code = cr_ev5_number(&t->ev5, r, values[k].field, false, &x, err);
        if (code == CR_ERR_OK && isnan(x) && values[k].needed) {
            code = cr_ev5_fault(&t->ev5, r, values[k].field, err, CR_ERR_MISSING, values[k].what);
        }
        x = cr_round12(x * values[k].unit);
        memcpy((char *)p + values[k].at, &x, sizeof x);
    }
    double kmh = 0;
    code = code == CR_ERR_OK ? cr_ev5_number(&t->ev5, r, V_SPEED, true, &kmh, err) : code;
    if (code == CR_ERR_OK && isnan(kmh)) {
        code = cr_ev5_fault(&t->ev5, r, V_SPEED, err, CR_ERR_MISSING, "the speed is not recorded");
    }
    if (code == CR_ERR_OK) {
        p->speed = cr_mps(kmh);
        t->vehicle[i] = r;
        t->car[i] = p;
        t->n++;
    }
    return code;
}

/* ---- what meets what ---- */

/* Distance in m from the first vehicle's CG to what it strikes ahead: more than it reaches however
 * it is turned, half its length, and what it drives before they meet. */
static double gap(const struct test *t) {
    const struct cr_participant *a = t->car[0];
    return hypot(a->length, a->width) / 2 + a->length / 2 + before * a->speed;
}

/* Distance in m from the CG to a pole in the direction of the angle. Sideways it begins close to
 * the flank, because the tyres would brake the car, which is carried in the test. */
static double to_pole(const struct test *t) {
    const struct cr_participant *a = t->car[0];
    double c = fabs(cos(t->angle)), s = fabs(sin(t->angle));
    bool flank = a->width * c < a->length * s;
    return flank ? (a->width / 2 + pole / 2) / s + 0.05 : gap(t);
}

static enum cr_err add_barrier(struct test *t, bool is_pole, struct cr_error *err) {
    struct cr_participant *p, *a = t->car[0];
    enum cr_err code = cr_import_add(t->im, is_pole ? "pole" : "wall", CR_KIND_OBJECT, &p, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    /* The car drives towards where the blow comes from; a wall is turned to face it. */
    p->shape = is_pole ? CR_OBJECT_POLE : CR_OBJECT_WALL;
    p->radius = is_pole ? pole / 2 : p->radius;
    if (is_pole) {
        a->course = cr_rad(cr_round_decimals(-cr_deg(t->angle), 4));
        p->pos = cr_vec2_scale(cr_vec2(cos(t->angle), -sin(t->angle)), to_pole(t));
        cr_import_note(t->im, "a pole of %g mm before the CG", pole * 1e3);
    } else {
        p->pos = cr_vec2(cr_round_decimals(gap(t) + a->width / 2 * fabs(tan(t->angle)), 3), 0);
        p->heading = cr_angle_wrap(CR_PI - t->angle);
    }
    p->pos = cr_vec2(cr_round_decimals(p->pos.x, 3), cr_round_decimals(p->pos.y, 3));
    return CR_ERR_OK;
}

/* Places the second vehicle where it is when they meet, less what it drives until then. */
static void place_second(struct test *t) {
    struct cr_participant *a = t->car[0], *b = t->car[1];
    b->heading = cr_angle_wrap(CR_PI + t->angle);
    double c = cos(b->heading), s = sin(b->heading);
    double reach = (b->length * fabs(c) + b->width * fabs(s)) / 2;
    double closing = a->speed - b->speed * c;
    double until = closing > 0 ? (gap(t) - a->length / 2) / closing : 0;
    struct cr_vec2 met = cr_vec2(a->speed * until + a->length / 2 + reach, -t->offset);
    b->pos = cr_vec2_axpy(met, -b->speed * until, cr_vec2(c, s));
    b->pos = cr_vec2(cr_round_decimals(b->pos.x, 3), cr_round_decimals(b->pos.y, 3));
    if (t->offset != 0) {
        cr_import_note(t->im, "offset %.4g m to the right of the path", t->offset);
    }
}

static enum cr_err arrange(struct test *t, struct cr_error *err) {
    const char *what = cr_ev5_text(t->test, T_CONFIGURATION);
    double deg, mm, crab = NAN;
    enum cr_err code = cr_ev5_number(&t->ev5, t->test, T_ANGLE, true, &deg, err);
    code = code == CR_ERR_OK ? cr_ev5_number(&t->ev5, t->test, T_OFFSET, true, &mm, err) : code;
    code =
        code == CR_ERR_OK ? cr_ev5_number(&t->ev5, t->vehicle[0], V_CRAB, false, &crab, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    t->angle = isnan(deg) ? 0 : cr_angle_wrap(cr_rad(deg));
    t->offset = isnan(mm) ? 0 : mm / 1e3;
    if (strcmp(what, "VTP") == 0) {
        return add_barrier(t, true, err);
    }
    if (!isnan(crab)) {
        cr_import_note(t->im, "crab angle %.4g deg not taken", crab);
    }
    if (strcmp(what, "VTB") == 0 && fabs(t->angle) < 1.4) {
        return add_barrier(t, false, err);
    }
    if (strcmp(what, "VTV") == 0 && t->n == 2) {
        place_second(t);
        return CR_ERR_OK;
    }
    cr_ev5_fault(&t->ev5, t->test, T_CONFIGURATION, err, CR_ERR_TYPE,
                 "neither a vehicle into a barrier before it (VTB), into a pole (VTP), nor into a "
                 "vehicle (VTV)");
    return CR_ERR_TYPE;
}

/* ---- what was measured ---- */

/* Expects the mean depth of crush: C1 to C6 stand at equal spaces, so it is that of trapezoids. */
static enum cr_err expect_crush(struct test *t, int i, cJSON *to, struct cr_error *err) {
    double sum = 0, mm, most = NAN;
    enum cr_err code = cr_ev5_number(&t->ev5, t->vehicle[i], V_CRUSH, false, &most, err);
    for (int k = 0; k < 6 && code == CR_ERR_OK; k++) {
        code = cr_ev5_number(&t->ev5, t->vehicle[i], V_DPD + k, true, &mm, err);
        sum += k == 0 || k == 5 ? mm / 2 : mm;
    }
    if (code == CR_ERR_OK && !isnan(most)) {
        cr_tree_number(to, "face_depth_m", cr_round12(most / 1e3));
    }
    if (code == CR_ERR_OK && !isnan(sum) && sum != 0) {
        cr_tree_number(to, "crush_mean_m", cr_round12(sum / 5e3));
    }
    return code;
}

static void list_channel(struct test *t, int i, const struct cr_ev5_record *r, const char *file) {
    cJSON *c = cJSON_CreateObject();
    const char *slash = strrchr(file, '/');
    cr_tree_text(c, "participant", t->car[i]->id);
    cr_tree_text(c, "file", slash != NULL ? slash + 1 : file);
    cr_tree_text(c, "attachment", cr_ev5_text(r, CR_EV5_ATTACHMENT));
    cr_tree_text(c, "axis", cr_ev5_text(r, CR_EV5_AXIS));
    cr_tree_text(c, "unit", cr_ev5_text(r, CR_EV5_UNIT));
    cr_tree_push(t->channels, c);
}

/* Loads the file of a channel, if it is there; often only the file of the test is at hand. NHTSA's
 * x is forward and y to the right. Errors: those of the file. */
static enum cr_err load_channel(struct test *t, int i, const struct cr_ev5_record *r,
                                struct cr_channel *ch, struct cr_error *err) {
    char file[CR_PATH_MAX + 16], *text = NULL;
    size_t len;
    const struct cr_unit *unit = cr_unit_spelled(cr_ev5_text(r, CR_EV5_UNIT), CR_DIM_ACCELERATION);
    *ch = (struct cr_channel){.n = 0};
    if (unit == NULL || !cr_ev5_file(t->im->path, r, file, sizeof file)) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_file_read_regular(file, &text, &len, err);
    code = code == CR_ERR_OK ? cr_channel_pairs(text, file, ch, err) : code;
    free(text);
    for (int k = 0; k < ch->n; k++) {
        ch->x[k] = cr_unit_to_si(unit, ch->x[k]);
    }
    list_channel(t, i, r, file);
    return code;
}

static enum cr_err expect_delta_v(struct test *t, int i, cJSON *to, struct cr_error *err) {
    const char *number = cr_ev5_text(t->vehicle[i], V_NUMBER);
    const struct cr_ev5_record *x = cr_ev5_accel(&t->ev5, number, 'X');
    const struct cr_ev5_record *y = cr_ev5_accel(&t->ev5, number, 'Y');
    struct cr_channel cx = {.n = 0}, cy = {.n = 0};
    enum cr_err code = x != NULL ? load_channel(t, i, x, &cx, err) : CR_ERR_OK;
    code = code == CR_ERR_OK && y != NULL ? load_channel(t, i, y, &cy, err) : code;
    double at = cr_channel_furthest(&cx);
    bool crash = cx.n > 0 && cx.t[cx.n - 1] >= whole_crash;
    if (code == CR_ERR_OK && crash) {
        double dv = cr_kmh(cr_channel_integral(&cx, at));
        cr_tree_number(to, "delta_v_forward_kmh", cr_round_decimals(dv, 2));
    } else if (code == CR_ERR_OK && cx.n > 0) {
        cr_import_note(t->im, "%s: channel %s is too short for a delta-v", t->car[i]->id,
                       cr_ev5_text(x, CR_EV5_CURVE));
    }
    if (code == CR_ERR_OK && crash && cy.n > 0 && cy.t[cy.n - 1] >= at) {
        double dv = -cr_kmh(cr_channel_integral(&cy, at));
        cr_tree_number(to, "delta_v_left_kmh", cr_round_decimals(dv, 2));
    }
    cr_channel_fini(&cx);
    cr_channel_fini(&cy);
    return code;
}

static enum cr_err measured(struct test *t, cJSON *extra, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    t->expect = cr_tree_object(extra, "x_expect");
    t->channels = cr_tree_array(extra, "x_channels");
    for (int i = 0; i < t->n && code == CR_ERR_OK; i++) {
        cJSON *to = cr_tree_object(t->expect, t->car[i]->id);
        code = expect_crush(t, i, to, err);
        code = code == CR_ERR_OK ? expect_delta_v(t, i, to, err) : code;
    }
    return code;
}

/* ---- the test ---- */

static enum cr_err read_case(struct test *t, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int k = 0; k < VEHICLES && code == CR_ERR_OK; k++) {
        const struct cr_ev5_record *r = cr_ev5_find(&t->ev5, "VEHICLE", k);
        code = r != NULL ? add_vehicle(t, r, err) : CR_ERR_OK;
    }
    if (code == CR_ERR_OK && t->n == 0) {
        code = cr_err_set(err, CR_ERR_MISSING, "no record in section VEHICLE");
        cr_err_place(err, t->ev5.shown, 0, 0);
    }
    code = code == CR_ERR_OK ? arrange(t, err) : code;
    cJSON *extra = code == CR_ERR_OK ? cJSON_CreateObject() : NULL;
    if (code == CR_ERR_OK) {
        cr_tree_text(extra, "x_title", cr_ev5_text(t->test, 2));
        code = measured(t, extra, err);
    }
    return cr_import_extra(t->im, code, extra, err);
}

/* Takes the name of the test, "v10146", from that of its file. */
static void name_of(const char *path, char out[64]) {
    const char *slash = strrchr(path, '/');
    snprintf(out, 64, "%.60s", slash != NULL ? slash + 1 : path);
    char *dot = strrchr(out, '.');
    if (dot != NULL && dot > out) {
        *dot = '\0';
    }
}

enum cr_err cr_import_ev5_read(struct cr_import *im, struct cr_error *err) {
    struct test t = {.im = im};
    struct cr_error why;
    char *text, name[64];
    size_t len;
    enum cr_err code = cr_file_read(im->path, &text, &len, err);
    if (code == CR_ERR_OK) {
        code = cr_ev5_parse(text, im->shown, &t.ev5, err);
        free(text);
    }
    if (code != CR_ERR_OK) {
        goto out;
    }
    cr_import_format(im, "NHTSA EV5");
    t.test = cr_ev5_find(&t.ev5, "TEST", 0);
    if (t.test == NULL) {
        code = cr_err_set(err, CR_ERR_MISSING, "no record in section TEST");
        cr_err_place(err, im->shown, 0, 0);
        goto out;
    }
    name_of(im->shown, name);
    code = cr_import_begin(im, "", name, err);
    if (code == CR_ERR_OK) {
        enum cr_err fault = read_case(&t, &why);
        code = cr_import_end(im, fault != CR_ERR_OK ? &why : NULL, err);
    }
out:
    cr_ev5_fini(&t.ev5);
    return code;
}
