/* Reports what follows from a measured outline, from energy to delta-v, in lines and as JSON, with
 * an interval to each number. */
#include "damage/crush.h"

#include "base/json.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const sources[CR_CRUSH_SOURCES] = {"type", "tape",        "mass",
                                                      "pdof", "restitution", "guess"};

/* How a number is told: by name and unit in lines, by its key in JSON. */
struct telling {
    int number;
    const char *name, *unit, *key;
    double factor; /* on SI */
    int decimals;
    bool of_impact; /* it is unknown without a partner */
};

static const struct telling of_car[] = {
    {CR_DAMAGE_EES, "EES", "km/h", "ees_kmh", 3.6, 1, false},
    {CR_DAMAGE_ENERGY, "energy", "kJ", "energy_kJ", 1e-3, 1, false},
    {CR_DAMAGE_INDUCED, "of it induced", "kJ", "energy_induced_kJ", 1e-3, 1, false},
    {CR_DAMAGE_DELTA_V, "delta-v", "km/h", "delta_v_kmh", 3.6, 1, true},
    {CR_DAMAGE_FORWARD, "  of it forward", "km/h", "delta_v_forward_kmh", 3.6, 1, true},
    {CR_DAMAGE_LEFT, "  of it to the left", "km/h", "delta_v_left_kmh", 3.6, 1, true},
    {CR_DAMAGE_COE_X, "centre of energy, x", "m", "coe_x_m", 1, 2, false},
    {CR_DAMAGE_COE_Y, "                  y", "m", "coe_y_m", 1, 2, false},
    {CR_DAMAGE_ARM, "arm of the force", "m", "arm_m", 1, 2, false},
    {CR_DAMAGE_ACTING, "mass that acts", "%", "acting_mass_percent", 100, 0, false},
    {CR_DAMAGE_DEPTH, "greatest depth", "m", "depth_max_m", 1, 2, false},
    {CR_DAMAGE_AREA, "area", "m2", "area_m2", 1, 2, false},
    {CR_DAMAGE_FORCE, "force at the outline", "kN", "force_kN", 1e-3, 0, false},
};
static const struct telling of_impact[] = {
    {CR_DAMAGE_CLOSING, "closing speed", "km/h", "closing_speed_kmh", 3.6, 1, true},
    {CR_DAMAGE_RESTITUTION, "restitution", "", "restitution", 1, 2, true},
    {CR_DAMAGE_TOTAL, "energy of both", "kJ", "energy_kJ", 1e-3, 1, false},
    {CR_DAMAGE_BALANCE, "ratio of the forces", "", "force_ratio", 1, 2, true},
};
enum {
    OF_CAR = sizeof of_car / sizeof of_car[0],
    OF_IMPACT = sizeof of_impact / sizeof *of_impact
};

/* A number in its unit; one that rounds to nothing loses its sign. */
static double shown(const struct telling *how, double x) {
    return fabs(how->factor * x) < 0.5 * pow(10, -how->decimals) ? 0 : how->factor * x;
}

static void say_value(struct cr_str *out, const struct telling *how,
                      const struct cr_crush_value *v) {
    cr_str_addf(out, "  %-22s %7.*f %-5s 95 %%: %.*f to %.*f\n", how->name, how->decimals,
                shown(how, v->best), how->unit, how->decimals, shown(how, v->lo), how->decimals,
                shown(how, v->hi));
}

static void say_measured(const struct cr_crush_car *car, struct cr_str *out) {
    const struct cr_measured *m = &car->m;
    const struct cr_participant *p = car->p;
    cr_str_addf(out, "%s: %s %.0f +- %.0f kg, %s, field %.2f +- %.2f m at %+.2f +- %.2f m, ",
                car->id, cr_type_word(p->type), p->mass, m->mass_tol, cr_face_word(m->face),
                m->length, m->length_tol, m->offset, m->offset_tol);
    cr_str_addf(out, "PDOF %.0f +- %.0f deg\n", cr_bearing_deg(m->pdof), cr_deg(m->pdof_tol));
    if (m->guessed) {
        cr_str_add(out,
                   "  not measured: as deep as takes what such partners took in real crashes\n");
        return;
    }
    cr_str_add(out, "  crush");
    for (int i = 0; i < m->stations; i++) {
        cr_str_addf(out, " %.0f", 100 * m->depth[i]);
    }
    cr_str_addf(out, " +- %.0f cm", 100 * m->depth_tol);
    if (m->z_lo > 0 || isfinite(m->z_hi)) {
        cr_str_addf(out, ", struck from %.2f m up", m->z_lo);
        if (isfinite(m->z_hi)) {
            cr_str_addf(out, " to %.2f m", m->z_hi);
        }
    }
    cr_str_add(out, "\n");
}

static void say_part(const struct cr_crush_case *what, const struct cr_crush_impact *impact, int i,
                     struct cr_str *out) {
    char cdc[12];
    cr_crush_cdc(&what->car[i], cdc);
    say_measured(&what->car[i], out);
    for (int k = 0; k < OF_CAR; k++) {
        if (impact->pair || !of_car[k].of_impact) {
            say_value(out, &of_car[k], &impact->part[i].of[of_car[k].number]);
        }
    }
    cr_str_addf(out, "  %-22s %s\n", "CDC", cdc);
    cr_str_addf(out, "  %-22s", impact->pair ? "delta-v is uncertain by" : "EES is uncertain by");
    const char *comma = "";
    for (int s = 0; s < CR_CRUSH_SOURCES; s++) {
        if (impact->share[i][s] >= 0.005 || s < CR_CRUSH_BOUNCE) {
            cr_str_addf(out, "%s %s %.0f %%", comma, sources[s], 100 * impact->share[i][s]);
            comma = ",";
        }
    }
    cr_str_add(out, " of the variance\n");
}

enum cr_err cr_crush_text(const struct cr_crush_case *what, const struct cr_crush_impact *impact,
                          struct cr_str *out, struct cr_error *err) {
    for (int i = 0; i < what->n; i++) {
        say_part(what, impact, i, out);
    }
    if (impact->pair) {
        cr_str_add(out, "impact: speeds are along the force at the places of contact\n");
        for (int k = 0; k < OF_IMPACT; k++) {
            if (what->n == 2 || of_impact[k].number == CR_DAMAGE_CLOSING ||
                of_impact[k].number == CR_DAMAGE_RESTITUTION) {
                say_value(out, &of_impact[k], &impact->of[of_impact[k].number]);
            }
        }
    } else {
        cr_str_add(out, "one vehicle alone: delta-v needs its partner (another vehicle or an "
                        "object)\n");
    }
    /* Two partners press on each other with one force: a ratio far from 1 tells of a wrong
     * outline. */
    double balance = impact->of[CR_DAMAGE_BALANCE].best;
    if (what->n == 2 && (balance > 2.5 || balance < 0.4)) {
        cr_str_addf(out,
                    "warning: the outlines stand for forces of %.0f and %.0f kN: one of them does "
                    "not fit\n",
                    impact->part[0].of[CR_DAMAGE_FORCE].best / 1000,
                    impact->part[1].of[CR_DAMAGE_FORCE].best / 1000);
    }
    return out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the report") : CR_ERR_OK;
}

static void add_value(cJSON *to, const struct telling *how, const struct cr_crush_value *v) {
    cJSON *o = cr_tree_object(to, how->key);
    cr_tree_number(o, "value", how->factor * v->best);
    cr_tree_number(o, "low", how->factor * v->lo);
    cr_tree_number(o, "high", how->factor * v->hi);
}

static void add_given(cJSON *to, const char *key, double value, double tolerance) {
    cJSON *o = cr_tree_object(to, key);
    cr_tree_number(o, "value", value);
    cr_tree_number(o, "tolerance", tolerance);
}

static void add_against(cJSON *to, const struct cr_crush_against *against) {
    cJSON *o = cr_tree_object(to, "solved");
    cr_tree_number(o, "ees_kmh", cr_kmh(against->ees));
    cr_tree_number(o, "delta_v_kmh", cr_kmh(against->delta_v));
    cr_tree_put(o, "at_m", cJSON_CreateDoubleArray(against->at, against->n));
    cr_tree_put(o, "crush_m", cJSON_CreateDoubleArray(against->solved, against->n));
    cr_tree_number(o, "rms_m", against->rms);
    cr_tree_number(o, "within_tolerance", against->within);
}

static cJSON *part_json(const struct cr_crush_case *what, const struct cr_crush_impact *impact,
                        int i) {
    const struct cr_crush_car *car = &what->car[i];
    const struct cr_measured *m = &car->m;
    char cdc[12];
    cJSON *o = cJSON_CreateObject();
    cr_crush_cdc(car, cdc);
    cr_tree_text(o, "id", car->id);
    cr_tree_text(o, "type", cr_type_word(car->p->type));
    cr_tree_text(o, "face", cr_face_word(m->face));
    add_given(o, "mass_kg", car->p->mass, m->mass_tol);
    add_given(o, "pdof_deg", cr_deg(m->pdof), cr_deg(m->pdof_tol));
    add_given(o, "field_length_m", m->length, m->length_tol);
    add_given(o, "field_offset_m", m->offset, m->offset_tol);
    cr_tree_put(o, "crush_m", cJSON_CreateDoubleArray(m->depth, m->stations));
    cr_tree_number(o, "crush_tolerance_m", m->depth_tol);
    cr_tree_bool(o, "guessed", m->guessed);
    for (int k = 0; k < OF_CAR; k++) {
        if (impact->pair || !of_car[k].of_impact) {
            add_value(o, &of_car[k], &impact->part[i].of[of_car[k].number]);
        }
    }
    cr_tree_text(o, "cdc", cdc);
    if (car->against != NULL) {
        add_against(o, car->against);
    }
    cJSON *share = cr_tree_object(o, "variance_shares");
    for (int s = 0; s < CR_CRUSH_SOURCES; s++) {
        cr_tree_number(share, sources[s], impact->share[i][s]);
    }
    return o;
}

enum cr_err cr_crush_json(const struct cr_crush_case *what, const struct cr_crush_impact *impact,
                          struct cr_str *out, struct cr_error *err) {
    cJSON *root = cJSON_CreateObject();
    cr_tree_text(root, "class", "damage");
    cJSON *list = cr_tree_array(root, "vehicles");
    for (int i = 0; i < what->n; i++) {
        cr_tree_push(list, part_json(what, impact, i));
    }
    for (int k = 0; k < OF_IMPACT; k++) {
        bool of_two = of_impact[k].number == CR_DAMAGE_BALANCE;
        if ((impact->pair || !of_impact[k].of_impact) && (!of_two || what->n == 2)) {
            add_value(root, &of_impact[k], &impact->of[of_impact[k].number]);
        }
    }
    bool done = cr_json_add(root, true, out);
    cr_str_add(out, "\n");
    return done && !out->failed ? CR_ERR_OK
                                : cr_err_set(err, CR_ERR_MEMORY, "no memory for the result");
}
