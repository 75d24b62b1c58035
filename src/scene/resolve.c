/* Values that were not given, from the catalogue, from type and mass. */
#include "scene/scene_priv.h"

#include "base/elementary.h"
#include "base/number.h"
#include "catalogue/catalogue.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the rules start from. */
struct basis {
    const struct cr_participant *part;
    const struct cr_dims *ref; /* of the type's recipe */
    const struct cr_model_rules *rules;
    double ref_mass; /* kg */
};

/* what is given of the kerb mass, also as what a load leaves of the mass; NaN: nothing */
static double given_kerb_mass(const struct cr_participant *p) {
    return isnan(p->kerb_mass) ? p->mass - p->load : p->kerb_mass;
}

/* Length: the type's, in proportion to a wheelbase that is given, else with the cube root of a kerb
 * mass that is given, the trend of the class medians (exponents 0.36 to 0.38) [CLASS-SIZES], by no
 * more than a fifth. Load makes no car longer. */
static double rule_length(const struct basis *b) {
    double kerb = cr_scene_kerb_by_rule(b->part, given_kerb_mass(b->part));
    if (!isnan(b->part->wheelbase)) {
        return b->ref->length * b->part->wheelbase / b->ref->wheelbase;
    }
    double size = isnan(kerb) ? 1 : cr_pow(fmax(0, kerb + CR_TEST_LOAD) / b->ref_mass, 1.0 / 3);
    return b->ref->length * cr_clamp(size, 0.8, 1.2);
}

/* Kerb mass: what is given of it; else the type's (its recipe has the mass as tested), with the
 * power of length that is the inverse of that trend, but no more than the car weighs. */
static double rule_kerb_mass(const struct basis *b) {
    double kerb = given_kerb_mass(b->part), size = b->part->length / b->ref->length;
    return isnan(kerb) ? fmin((b->ref_mass - CR_TEST_LOAD) * cr_pow(size, 2.7), b->part->mass)
                       : kerb;
}

static double rule_load(const struct basis *b) {
    const struct cr_participant *p = b->part;
    return isnan(p->mass) ? 0 : fmax(0, p->mass - p->kerb_mass);
}

/* what a draw makes of a rule's value */
static double drawn(const struct basis *b, enum cr_ruled what, double value) {
    return value * cr_exp(b->part->off_rule[what]);
}

static double rule_mass(const struct basis *b) {
    return b->part->kerb_mass + b->part->load;
}

/* Width goes with the square root of length [CLASS-SIZES]. */
static double rule_width(const struct basis *b) {
    double w = b->ref->width * sqrt(b->part->length / b->ref->length);
    return isnan(b->part->track) ? w : fmax(w, b->part->track / 0.9);
}

static double rule_height(const struct basis *b) {
    return isnan(b->part->cg_height) ? b->ref->height
                                     : fmax(b->ref->height, b->part->cg_height / 0.45);
}

static double rule_wheelbase(const struct basis *b) {
    return b->ref->wheelbase * b->part->length / b->ref->length;
}

/* regressions of the type's recipe [TRACK-MASS], [CG-HEIGHT] */
static double rule_track(const struct basis *b) {
    double tested = b->part->kerb_mass + CR_TEST_LOAD;
    double t = b->rules->track + b->rules->track_per_kg * tested;
    return cr_clamp(drawn(b, CR_RULED_TRACK, t), 0.7 * b->part->width, 0.9 * b->part->width);
}

/* the recipe's share of what stands out before and behind the axles */
static double rule_overhang(const struct basis *b) {
    double share = b->ref->front_overhang / (b->ref->length - b->ref->wheelbase);
    return share * (b->part->length - b->part->wheelbase);
}

/* share of the wheelbase 0.308 + 7.7e-5 per kg, s 0.025 [CG-SHARE] */
double cr_scene_cg_rule(double mass, double wheelbase) {
    return wheelbase * cr_clamp(0.308 + 7.7e-5 * mass, 0.36, 0.6);
}

static double rule_cg(const struct basis *b) {
    double kerb = b->part->kerb_mass, off = kerb - cr_scene_kerb_by_rule(b->part, kerb);
    return cr_scene_cg_rule(b->part->mass - off, b->part->wheelbase);
}

static double rule_cg_height(const struct basis *b) {
    double h = b->rules->cg_height + b->rules->cg_height_per_kg * b->part->mass;
    return fmin(drawn(b, CR_RULED_CG_HEIGHT, h), 0.45 * b->part->height);
}

/* 0.137 m L WB: nearer to measured vehicles than a line over the mass [YAW-INERTIA] */
static double rule_inertia(const struct basis *b) {
    return drawn(b, CR_RULED_INERTIA, 0.137 * b->part->mass * b->part->length * b->part->wheelbase);
}

/* in an order in which each rule finds what it needs */
static const struct {
    const char *key;
    double (*rule)(const struct basis *b);
} rules[] = {
    {"length_m", rule_length},
    {"width_m", rule_width},
    {"height_m", rule_height},
    {"wheelbase_m", rule_wheelbase},
    {"kerb_mass_kg", rule_kerb_mass},
    {"load_kg", rule_load},
    {"mass_kg", rule_mass},
    {"track_m", rule_track},
    {"front_overhang_m", rule_overhang},
    {"cg.behind_front_axle_m", rule_cg},
    {"cg.height_m", rule_cg_height},
    {"yaw_inertia_kgm2", rule_inertia},
};

void cr_assumed_fini(struct cr_assumed *assumed) {
    free(assumed->key);
    free(assumed->from);
    *assumed = (struct cr_assumed){0};
}

/* Type and mass, which all other rules start from: by the car of the catalogue, else by size. */
static enum cr_err resolve_kind(struct cr_participant *p, const struct cr_model_lib *lib,
                                struct cr_assuming *a, struct cr_error *err) {
    enum cr_err code = p->car[0] != '\0' ? cr_scene_from_car(p, lib, a, err) : CR_ERR_OK;
    if (code == CR_ERR_OK && p->type == CR_TYPES) {
        code = cr_scene_guess_type(p, lib, err);
        code = code == CR_ERR_OK ? cr_scene_assume(a, p->id, "type", err) : code;
    }
    code = code == CR_ERR_OK ? cr_model_need(lib, p->type, err) : code;
    if (code == CR_ERR_OK && isnan(p->mass) && isnan(p->kerb_mass)) {
        p->kerb_mass = cr_scene_drawn_kerb_mass(p, cr_scene_guess_mass(p, lib, &a->mass_spread));
        code = cr_scene_assume(a, p->id, "kerb_mass_kg", err);
        if (code == CR_ERR_OK && isnan(p->load)) {
            p->load = CR_CAR_DRIVER;
            code = cr_scene_assume(a, p->id, "load_kg", err);
        }
    }
    return code;
}

static enum cr_err resolve_vehicle(struct cr_participant *p, const struct cr_model_lib *lib,
                                   struct cr_assuming *a, struct cr_error *err) {
    struct basis b = {.part = p};
    a->mass_spread = 0;
    enum cr_err code = resolve_kind(p, lib, a, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    b.ref = cr_model_dims(lib, p->type, &b.ref_mass);
    b.rules = cr_model_rules(lib, p->type);
    bool weighed = !isnan(p->mass), loaded = !isnan(p->load);
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; i++) {
        const struct cr_key *key =
            cr_scene_key_find(CR_KEYS_PARTICIPANT, rules[i].key, CR_FOR_VEHICLE);
        double *x = (double *)(void *)((char *)p + key->at);
        if (!isnan(*x)) {
            continue;
        }
        *x = cr_round12(rules[i].rule(&b)); /* is read in the result, with all its digits */
        /* what follows from two given ones is no assumption */
        bool follows = (strcmp(rules[i].key, "load_kg") == 0 && weighed) ||
                       (strcmp(rules[i].key, "mass_kg") == 0) ||
                       (strcmp(rules[i].key, "kerb_mass_kg") == 0 && weighed && loaded);
        code = follows ? CR_ERR_OK : cr_scene_assume(a, p->id, rules[i].key, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    return CR_ERR_OK;
}

/* A barrier brings its sizes, and its mass where it is not fixed and none was given; its CG lies
 * behind its front as in a vehicle, that of a fixed one in the middle of its face. */
static enum cr_err resolve_barrier(struct cr_participant *p, const struct cr_model_lib *lib,
                                   struct cr_error *err) {
    const struct cr_barrier *b;
    enum cr_err code = cr_model_barrier(lib, p->barrier, &b, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    p->length = b->length;
    p->width = b->width;
    p->height = b->z_hi;
    p->front_overhang = 0;
    p->cg_behind_front_axle = b->cg_behind_face;
    p->z_lo = isnan(p->z_lo) ? b->z_lo : p->z_lo;
    p->z_hi = isnan(p->z_hi) ? b->z_hi : p->z_hi;
    p->mass = isnan(p->mass) && !b->fixed ? b->mass : p->mass;
    p->yaw_inertia = b->fixed ? 0 : b->inertia * p->mass / b->mass;
    if (b->fixed && !isnan(p->mass)) {
        cr_err_set(err, CR_ERR_RANGE, "barrier %s stands fixed, it has no mass", p->barrier);
        cr_err_hint(err, "leave mass_kg out, or take mpdb, fmvss214, r95 or ae-mdb");
        return CR_ERR_RANGE;
    }
    return CR_ERR_OK;
}

/* without a height range an object is as high as a vehicle at least: 0 to 3 m */
static enum cr_err resolve_object(struct cr_participant *p, const struct cr_model_lib *lib,
                                  struct cr_assuming *a, struct cr_error *err) {
    if (p->shape == CR_OBJECT_BARRIER) {
        return resolve_barrier(p, lib, err);
    }
    if (!isnan(p->z_lo)) {
        return CR_ERR_OK;
    }
    p->z_lo = 0;
    p->z_hi = 3;
    return cr_scene_assume(a, p->id, "height_m", err);
}

/* what the method decides of a vehicle's model where the scene does not */
static void resolve_model(struct cr_participant *p, int method) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    const struct cr_key *blend =
        cr_scene_key_find(CR_KEYS_PARTICIPANT, "model.blend", CR_FOR_VEHICLE);
    if ((p->given >> (blend - row) & 1) == 0) {
        cr_scene_value_reset(blend, p, method);
    }
}

static enum cr_err resolve_part(struct cr_reader *r, struct cr_participant *p,
                                const struct cr_model_lib *lib, int method, struct cr_assuming *a) {
    enum cr_err code = cr_scene_part_complete(r, p);
    cr_scene_model_kind(p);
    if (p->kind == CR_KIND_VEHICLE) {
        resolve_model(p, method);
    }
    if (code == CR_ERR_OK) {
        code = cr_scene_part_check(r, p);
    }
    if (code == CR_ERR_OK) {
        code = p->kind == CR_KIND_VEHICLE ? resolve_vehicle(p, lib, a, r->err)
                                          : resolve_object(p, lib, a, r->err);
        bool placeless = code != CR_ERR_OK && r->err != NULL && r->err->src[0] == '\0' &&
                         r->err->where[0] == '\0';
        if (placeless) { /* a car that is not in the catalogue: here is who named it */
            snprintf(r->err->where, sizeof r->err->where, "%.*s%s",
                     (int)(sizeof r->err->where - sizeof "/barrier"), r->path,
                     p->car[0] != '\0'                                            ? "/car"
                     : p->shape == CR_OBJECT_BARRIER && p->kind == CR_KIND_OBJECT ? "/barrier"
                                                                                  : "");
        }
    }
    return code == CR_ERR_OK ? cr_scene_part_check(r, p) : code;
}

/* what the method decides where the scene does not */
static void resolve_settings(struct cr_settings *set) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_SETTINGS, &n);
    for (int i = 0; i < n; i++) {
        if ((set->given >> i & 1) != 0) {
            continue;
        }
        if (row[i].type == CR_KEY_NUMBER) {
            cr_scene_value_reset(&row[i], set, (int)set->method);
        } else if (row[i].type == CR_KEY_SWITCH && !cr_scene_value_known(&row[i], set)) {
            int on = row[i].def[set->method] != 0;
            memcpy((char *)set + row[i].at, &on, sizeof on);
        }
    }
}

/* a second surface is a polygon and its friction */
static enum cr_err check_surface(const struct cr_settings *set, struct cr_error *err) {
    if ((set->patch_vertices > 0) == !isnan(set->patch_friction)) {
        return CR_ERR_OK;
    }
    const char *missing = set->patch_vertices > 0 ? "friction" : "vertices_m";
    cr_err_set(err, CR_ERR_MISSING, "the second surface has no \"%s\"", missing);
    cr_err_hint(err, "\"surface\": {\"friction\": 0.3, \"vertices_m\": [[0, 0], [20, 0], [0, 9]]}");
    if (err != NULL) {
        snprintf(err->where, sizeof err->where, "/settings/surface");
    }
    return CR_ERR_MISSING;
}

enum cr_err cr_scene_resolve(struct cr_scene *scene, const struct cr_model_lib *lib,
                             struct cr_assumed *assumed, struct cr_error *err) {
    /* a scene made by commands may leave positions at the origin */
    struct cr_reader whole = {.err = err}, r = {.err = err, .draft = true};
    enum cr_err code = cr_scene_whole_check(&whole, scene);
    if (code != CR_ERR_OK) {
        return code;
    }
    resolve_settings(&scene->set);
    code = check_surface(&scene->set, err);
    struct cr_assuming a = {.list = assumed};
    cr_scene_enter(&r, "participants");
    for (int i = 0; i < scene->n && code == CR_ERR_OK; i++) {
        char token[12];
        snprintf(token, sizeof token, "%d", i);
        size_t up = cr_scene_enter(&r, token);
        a.mass_spread = 0;
        code = resolve_part(&r, &scene->part[i], lib, (int)scene->set.method, &a);
        if (assumed != NULL) {
            assumed->mass_spread[i] = a.mass_spread;
        }
        cr_scene_leave(&r, up);
    }
    if (code == CR_ERR_OK) {
        code = cr_scene_stand(scene, lib, err);
    }
    for (int i = 0; i < scene->n; i++) { /* it drives where it looks */
        struct cr_participant *p = &scene->part[i];
        if (isnan(p->course) && p->waypoints == 0) {
            p->course = p->heading;
        }
    }
    return code;
}

enum cr_err cr_scene_settle(struct cr_scene *scene, const struct cr_model_lib *models,
                            struct cr_error *err) {
    struct cr_scene full;
    bool any = false;
    for (int i = 0; i < scene->n; i++) {
        any = any || cr_scene_is_placed(&scene->part[i]);
    }
    if (!any) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_scene_copy(scene, &full, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_scene_resolve(&full, models, NULL, err);
    for (int i = 0; i < scene->n && code == CR_ERR_OK; i++) {
        const struct cr_participant *from = &full.part[i];
        struct cr_participant *to = &scene->part[i];
        if (cr_scene_is_placed(to)) {
            cr_scene_pose(to, from->pos, from->heading);
        }
        if (cr_scene_is_placed(to) &&
            cr_scene_slides(from, cr_scene_find(&full, from->place.against))) {
            cr_scene_course(to, from->course);
        }
    }
    cr_scene_fini(&full);
    return code;
}
