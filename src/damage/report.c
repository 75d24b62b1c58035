/* The way from a measured outline to delta-v in lines and as JSON, with an interval to each number.
 */
#include "damage/crush.h"

#include "base/json.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const sources[CR_CRUSH_SOURCES] = {"type", "tape", "mass", "pdof"};

static void say_value(struct cr_str *out, const char *name, const struct cr_crush_value *v,
                      double factor, const char *unit) {
    cr_str_addf(out, "  %-22s %7.1f %-5s 95 %%: %.1f to %.1f\n", name, factor * v->best, unit,
                factor * v->lo, factor * v->hi);
}

static void say_measured(const struct cr_crush_car *car, struct cr_str *out) {
    const struct cr_measured *m = &car->m;
    const struct cr_participant *p = car->p;
    cr_str_addf(out, "%s: %s %.0f kg, %s, field %.2f m at %+.2f m, crush", car->id,
                cr_type_word(p->type), p->mass, cr_crush_face_word(m->face), m->length, m->offset);
    for (int i = 0; i < m->stations; i++) {
        cr_str_addf(out, " %.0f", 100 * m->depth[i]);
    }
    cr_str_addf(out, " cm, PDOF %.0f deg\n",
                cr_deg(m->pdof) < -0.5 ? cr_deg(m->pdof) + 360 : cr_deg(m->pdof));
}

static void say_part(const struct cr_crush_case *what, const struct cr_crush_impact *impact, int i,
                     struct cr_str *out) {
    const struct cr_crush_part *part = &impact->part[i];
    char cdc[12];
    cr_crush_cdc(&what->car[i], cdc);
    say_measured(&what->car[i], out);
    say_value(out, "EES", &part->ees, cr_kmh(1), "km/h");
    say_value(out, "energy", &part->energy, 1e-3, "kJ");
    cr_str_addf(out, "  %-22s %7.1f kJ    beside what was struck directly\n", "of it induced",
                part->e.induced / 1000);
    if (impact->pair) {
        say_value(out, "delta-v", &part->delta_v, cr_kmh(1), "km/h");
    }
    cr_str_addf(out, "  %-22s x %.2f, y %.2f m; arm %.2f m, %.0f %% of the mass acts\n",
                "centre of energy", part->e.coe.x, part->e.coe.y, part->arm, 100 * part->gamma);
    cr_str_addf(out, "  %-22s %.2f m, area %.2f m2, CDC %s\n", "greatest depth", part->e.depth,
                part->e.area, cdc);
    cr_str_addf(out, "  %-22s", impact->pair ? "delta-v is uncertain by" : "EES is uncertain by");
    for (int s = 0; s < CR_CRUSH_SOURCES; s++) {
        cr_str_addf(out, " %s %.0f %%%s", sources[s], 100 * impact->share[i][s],
                    s + 1 < CR_CRUSH_SOURCES ? "," : " of the variance\n");
    }
}

enum cr_err cr_crush_text(const struct cr_crush_case *what, const struct cr_crush_impact *impact,
                          struct cr_str *out, struct cr_error *err) {
    for (int i = 0; i < what->n; i++) {
        say_part(what, impact, i, out);
    }
    if (impact->pair) {
        cr_str_add(out, "impact\n");
        say_value(out, "closing speed", &impact->closing, cr_kmh(1), "km/h");
        cr_str_addf(out, "  %-22s %.2f; %s\n", "restitution", impact->restitution,
                    "speeds are along the force at the places of contact");
    } else {
        cr_str_add(out, "one vehicle alone: delta-v needs its partner (another vehicle or an "
                        "object)\n");
    }
    /* two partners press on each other with one force */
    if (what->n == 2 && (impact->balance > 2.5 || impact->balance < 0.4)) {
        cr_str_addf(out,
                    "warning: the outlines stand for forces of %.0f and %.0f kN: one of them does "
                    "not fit\n",
                    impact->part[0].e.force / 1000, impact->part[1].e.force / 1000);
    }
    return out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the report") : CR_ERR_OK;
}

static void add_value(cJSON *to, const char *name, const struct cr_crush_value *v, double factor) {
    cJSON *o = cr_tree_object(to, name);
    cr_tree_number(o, "value", factor * v->best);
    cr_tree_number(o, "low", factor * v->lo);
    cr_tree_number(o, "high", factor * v->hi);
}

static cJSON *part_json(const struct cr_crush_case *what, const struct cr_crush_impact *impact,
                        int i) {
    const struct cr_crush_part *part = &impact->part[i];
    const struct cr_crush_car *car = &what->car[i];
    char cdc[12];
    cJSON *o = cJSON_CreateObject();
    cr_crush_cdc(car, cdc);
    cr_tree_text(o, "id", car->id);
    cr_tree_text(o, "type", cr_type_word(car->p->type));
    cr_tree_number(o, "mass_kg", car->p->mass);
    cr_tree_text(o, "face", cr_crush_face_word(car->m.face));
    cr_tree_number(o, "pdof_deg", cr_deg(part->pdof));
    add_value(o, "ees_kmh", &part->ees, cr_kmh(1));
    add_value(o, "energy_kJ", &part->energy, 1e-3);
    cr_tree_number(o, "energy_induced_kJ", part->e.induced / 1000);
    if (impact->pair) {
        add_value(o, "delta_v_kmh", &part->delta_v, cr_kmh(1));
        double dv = cr_kmh(part->delta_v.best);
        cr_tree_number(o, "delta_v_forward_kmh", dv * part->push.x);
        cr_tree_number(o, "delta_v_left_kmh", dv * part->push.y);
    }
    const double coe[] = {part->e.coe.x, part->e.coe.y};
    cr_tree_put(o, "coe_m", cJSON_CreateDoubleArray(coe, 2));
    cr_tree_number(o, "arm_m", part->arm);
    cr_tree_number(o, "effective_mass_kg", part->gamma * car->p->mass);
    cr_tree_number(o, "force_kN", part->e.force / 1000);
    cr_tree_number(o, "depth_max_m", part->e.depth);
    cr_tree_number(o, "area_m2", part->e.area);
    cr_tree_text(o, "cdc", cdc);
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
    cr_tree_number(root, "energy_kJ", impact->energy / 1000);
    if (impact->pair) {
        add_value(root, "closing_speed_kmh", &impact->closing, cr_kmh(1));
        cr_tree_number(root, "restitution", impact->restitution);
    }
    if (what->n == 2) {
        cr_tree_number(root, "force_ratio", impact->balance);
    }
    bool done = cr_json_add(root, true, out);
    cr_str_add(out, "\n");
    return done && !out->failed ? CR_ERR_OK
                                : cr_err_set(err, CR_ERR_MEMORY, "no memory for the result");
}
