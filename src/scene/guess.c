/* Type and mass of a vehicle that gives neither: from the catalogue, else from its dimensions. */
#include "scene/scene_priv.h"

#include "base/elementary.h"
#include "base/grow.h"
#include "base/number.h"
#include "catalogue/catalogue.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Relative standard deviations of kerb mass and driver: about the type's mass times the volume over
 * that of the reference car [MASS-BY-VOLUME], about the type's mass alone [MASS-BY-TYPE], and
 * within a row of the catalogue with what was loaded [MASS-BY-ROW]. */
static const double spread_by_volume = 0.11, spread_by_row = 0.06;
const double cr_mass_spread_by_type = 0.15;

enum cr_err cr_scene_assume(struct cr_assuming *how, const char *id, const char *key,
                            struct cr_error *err) {
    struct cr_assumed *a = how->list;
    if (a == NULL) {
        return CR_ERR_OK;
    }
    int size = a->size; /* of both arrays, which grow together */
    if (!cr_grow(&a->key, &size, a->n, sizeof *a->key) ||
        !cr_grow(&a->from, &a->size, a->n, sizeof *a->from)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to resolve the scene");
    }
    snprintf(a->from[a->n], sizeof *a->from, "%s", how->from);
    snprintf(a->key[a->n++], sizeof *a->key, "%s.%s", id, key);
    return CR_ERR_OK;
}

static double middle(double a, double b) {
    return (a + b) / 2;
}

/* The limits lie midway between the reference cars of models/TYPE.json: an SUV by its height, the
 * others by their length. A wagon cannot be told from a sedan by either. */
static enum cr_type type_by_size(const struct cr_model_lib *lib, double length, double height) {
    static const enum cr_type row[] = {CR_TYPE_SUPER_COMPACT, CR_TYPE_MINI_COMPACT, CR_TYPE_COMPACT,
                                       CR_TYPE_SEDAN};
    double suv = cr_model_dims(lib, CR_TYPE_SUV, NULL)->height;
    if (height > middle(suv, cr_model_dims(lib, CR_TYPE_SEDAN, NULL)->height)) {
        return CR_TYPE_SUV;
    }
    for (int i = 0; i < 3; i++) {
        double limit = middle(cr_model_dims(lib, row[i], NULL)->length,
                              cr_model_dims(lib, row[i + 1], NULL)->length);
        if (length < limit) {
            return row[i];
        }
    }
    return CR_TYPE_SEDAN;
}

/* the same by mass where there is no length; a sedan where there is nothing */
static enum cr_type type_by_mass(const struct cr_model_lib *lib, double mass) {
    static const enum cr_type row[] = {CR_TYPE_SUPER_COMPACT, CR_TYPE_MINI_COMPACT, CR_TYPE_COMPACT,
                                       CR_TYPE_SEDAN};
    for (int i = 0; i < 3; i++) {
        double a, b;
        cr_model_dims(lib, row[i], &a);
        cr_model_dims(lib, row[i + 1], &b);
        if (mass < middle(a, b)) {
            return row[i];
        }
    }
    return CR_TYPE_SEDAN;
}

enum cr_err cr_scene_guess_type(struct cr_participant *p, const struct cr_model_lib *lib,
                                struct cr_error *err) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    const struct cr_key *type = cr_scene_key_find(CR_KEYS_PARTICIPANT, "type", CR_FOR_VEHICLE);
    bool asked = (p->given >> (type - row) & 1) != 0; /* "auto" */
    if (!asked && isnan(p->mass) && isnan(p->kerb_mass) && isnan(p->length) &&
        isnan(p->wheelbase) && isnan(p->height)) {
        cr_err_set(err, CR_ERR_MISSING, "vehicle \"%s\" has neither type, car, mass nor size",
                   p->id);
        cr_err_hint(err, "give \"type\" or \"car\"; \"type\": \"auto\" takes a sedan");
        return CR_ERR_MISSING;
    }
    enum cr_err code = cr_model_need_all(lib, err);
    if (code == CR_ERR_OK) {
        double length = isnan(p->length) && !isnan(p->wheelbase)
                            ? p->wheelbase * 1.7 /* of the reference cars 1.51 to 1.74 */
                            : p->length;
        bool by_mass = isnan(length) && !(p->height > 0);
        p->type = by_mass ? type_by_mass(lib, isnan(p->mass) ? p->kerb_mass : p->mass)
                          : type_by_size(lib, isnan(length) ? 4.8 : length, p->height);
    }
    return code;
}

double cr_scene_guess_mass(const struct cr_participant *p, const struct cr_model_lib *lib,
                           double *spread) {
    double mass;
    const struct cr_dims *ref = cr_model_dims(lib, p->type, &mass);
    double share = 1;
    share *= isnan(p->length) ? 1 : p->length / ref->length;
    share *= isnan(p->width) ? 1 : p->width / ref->width;
    share *= isnan(p->height) ? 1 : p->height / ref->height;
    *spread = isnan(p->length) ? cr_mass_spread_by_type : spread_by_volume;
    /* a whole number of 10 kg: more digits would claim what nobody knows */
    return cr_clamp(10 * round(mass * share / 10), 100, 60000);
}

/* Their scatter is that of kerb mass and driver together. */
double cr_scene_drawn_kerb_mass(const struct cr_participant *p, double with_driver) {
    return with_driver * cr_exp(p->off_rule[CR_RULED_MASS]) - CR_CAR_DRIVER;
}

double cr_scene_kerb_by_rule(const struct cr_participant *p, double drawn) {
    double off = p->off_rule[CR_RULED_MASS];
    return off == 0 ? drawn : (drawn + CR_CAR_DRIVER) * cr_exp(-off) - CR_CAR_DRIVER;
}

/* ---- the catalogue ---- */

static enum cr_err take(struct cr_participant *p, const char *key, double value,
                        struct cr_assuming *a, struct cr_error *err) {
    const struct cr_key *row = cr_scene_key_find(CR_KEYS_PARTICIPANT, key, CR_FOR_VEHICLE);
    double *x = (double *)(void *)((char *)p + row->at);
    if (!isnan(*x) || isnan(value)) {
        return CR_ERR_OK;
    }
    *x = cr_round12(value);
    return cr_scene_assume(a, p->id, key, err);
}

/* where the values of a row are from, for the result */
static enum cr_err name_row(const struct cr_car *car, char from[CR_FROM_MAX],
                            struct cr_error *err) {
    struct cr_str name = {0};
    cr_car_name(car, &name);
    snprintf(from, CR_FROM_MAX, "%.60s (%.24s:%d, %.80s)", cr_str_get(&name), car->file, car->line,
             car->source);
    bool whole = !name.failed;
    cr_str_fini(&name);
    return whole ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory for the name of a car");
}

enum cr_err cr_scene_from_car(struct cr_participant *p, const struct cr_model_lib *lib,
                              struct cr_assuming *a, struct cr_error *err) {
    const struct cr_catalogue *catalogue;
    const struct cr_car *car;
    enum cr_err code = cr_model_catalogue(lib, &catalogue, err);
    code = code == CR_ERR_OK ? cr_catalogue_find(catalogue, p->car, &car, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    bool heavy = !isnan(p->mass) && !isnan(p->load); /* these two say the kerb mass */
    bool light = p->mass < car->curb;                /* lighter than the row with all in it */
    int year = cr_car_year(car, p->car);
    const struct {
        const char *key;
        double value;
    } value[] = {
        {"kerb_mass_kg", heavy   ? p->mass - p->load
                         : light ? p->mass
                                 : cr_scene_drawn_kerb_mass(p, car->curb + CR_CAR_DRIVER)},
        {"load_kg", isnan(p->mass) ? CR_CAR_DRIVER : (double)NAN},
        {"built", year > 0 ? year : (double)NAN}, /* a row's own years say too little */
        {"length_m", car->length},
        {"width_m", car->width},
        {"height_m", car->height},
        {"wheelbase_m", car->wheelbase},
        {"track_m", car->track},
        {"cg.behind_front_axle_m", car->cg_behind_front_axle},
        {"cg.height_m", car->cg_height},
    };
    bool massless = isnan(p->mass) && isnan(p->kerb_mass);
    code = name_row(car, a->from, err);
    for (size_t i = 0; i < sizeof value / sizeof value[0] && code == CR_ERR_OK; i++) {
        code = take(p, value[i].key, value[i].value, a, err);
    }
    int type = cr_type_find(car->type);
    if (code == CR_ERR_OK && p->type == CR_TYPES && type >= 0) {
        p->type = (enum cr_type)type;
        code = cr_scene_assume(a, p->id, "type", err);
    }
    a->mass_spread = massless && !isnan(p->kerb_mass) ? spread_by_row : 0;
    a->from[0] = '\0';
    return code;
}
