/* Writes as JSON what a result tells of a participant, in all or in one impact, and the impacts. */
#include "result/json_priv.h"
#include "result/robust.h"

#include "base/number.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

void cr_json_put(cJSON *to, const char *key, double x) {
    cr_tree_put(to, key, isfinite(x) ? cJSON_CreateNumber(cr_round12(x)) : cJSON_CreateNull());
}

cJSON *cr_json_point(struct cr_vec2 p) {
    const double xy[2] = {cr_round12(p.x), cr_round12(p.y)};
    return cJSON_CreateDoubleArray(xy, 2);
}

cJSON *cr_json_numbers(const double *x, int n) {
    cJSON *list = cJSON_CreateArray();
    for (int i = 0; list && i < n; i++) {
        cr_tree_push(list,
                     isfinite(x[i]) ? cJSON_CreateNumber(cr_round12(x[i])) : cJSON_CreateNull());
    }
    return list;
}

static double course_deg(double rad) {
    return cr_deg(cr_angle_wrap(rad));
}

void cr_json_motion(const struct cr_severity *s, int version, cJSON *p) {
    cr_json_put(p, "ees_kmh", cr_kmh(s->ees));
    cr_json_put(p, "energy_kJ", s->energy / 1e3);
    cr_json_put(p, "energy_induced_kJ", s->energy_induced / 1e3);
    cr_json_put(p, "delta_v_kmh", cr_kmh(version > 1 ? s->delta_v : s->delta_v_net));
    cr_json_put(p, "delta_v_forward_kmh", cr_kmh(s->delta_v_body.x));
    cr_json_put(p, "delta_v_left_kmh", cr_kmh(s->delta_v_body.y));
    cr_json_put(p, "delta_v_x_kmh", cr_kmh(s->delta_v_world.x));
    cr_json_put(p, "delta_v_y_kmh", cr_kmh(s->delta_v_world.y));
    cr_json_put(p, "pdof_deg", cr_deg(s->pdof));
    cr_json_put(p, "pdof_clock", s->pdof_clock);
    cr_tree_text(p, "model", s->model);
    cr_tree_text(p, "cdc", s->cdc);
    cr_json_put(p, "yaw_rate_change_deg_s", cr_deg(s->yaw_rate_change));
    cr_json_put(p, "speed_after_kmh", cr_kmh(s->speed_after));
    cr_json_put(p, "course_after_deg", course_deg(s->course_after));
    cr_json_put(p, "yaw_rate_after_deg_s", cr_deg(s->yaw_rate_after));
    if (version > 1) {
        cr_tree_put(p, "coe_m", cr_json_point(s->coe));
    }
}

/* The second face is null where only one face was crushed. */
static void put_second(const struct cr_second_face *second, cJSON *p) {
    if (second->face == CR_FACES) {
        cr_tree_put(p, "second_face", cJSON_CreateNull());
        return;
    }
    cJSON *to = cr_tree_object(p, "second_face");
    cr_tree_text(to, "face", cr_face_word(second->face));
    cr_json_put(to, "face_depth_m", second->depth);
    cr_json_put(to, "face_depth_dynamic_m", second->depth_dynamic);
    cr_json_put(to, "damage_width_m", second->width);
}

void cr_json_deformation(const struct cr_severity *s, int version, cJSON *p) {
    cr_json_put(p, "deformation_max_m", s->deformation_max);
    cr_json_put(p, "deformation_dynamic_max_m", s->deformation_dynamic_max);
    cr_json_put(p, "deformation_area_m2", s->deformation_area);
    cr_tree_put(p, "crush_profile_m",
                cr_json_numbers(version > 1 ? s->profile : s->profile_outline, CR_PROFILE));
    cr_tree_text(p, "face", cr_face_word(s->face));
    cr_json_put(p, "face_depth_m", s->face_depth);
    cr_json_put(p, "face_depth_dynamic_m", s->face_depth_dynamic);
    cr_json_put(p, "damage_width_m", s->damage_width);
    cr_tree_put(p, "crush_profile_dynamic_m", cr_json_numbers(s->profile_dynamic, CR_PROFILE));
    cr_json_put(p, "area_contact_m2", s->area_contact);
    cr_json_put(p, "area_induced_m2", s->area_induced);
    if (version > 1) {
        cr_tree_put(p, "crush_profile_outline_m", cr_json_numbers(s->profile_outline, CR_PROFILE));
        cr_json_put(p, "crush_profile_width_m", s->profile_width);
        cr_json_put(p, "crush_profile_middle_m", s->profile_middle);
        put_second(&s->second, p);
    }
}

void cr_json_outline(const struct cr_severity *s, cJSON *p) {
    cJSON *outline = cr_tree_array(p, "deformation_outline_m");
    for (int i = 0; i < s->outline_n; i++) {
        cr_tree_push(outline, cr_json_point(s->outline[i]));
    }
}

void cr_json_pulse(const struct cr_severity *s, cJSON *p) {
    cr_json_put(p, "acceleration_max_g", s->acceleration_max / CR_G);
    cr_json_put(p, "acceleration_mean_g", s->acceleration_mean / CR_G);
    cr_json_put(p, "pulse_ms", 1e3 * s->pulse);
    cr_json_put(p, "time_of_max_ms", 1e3 * s->t_max);
    cr_json_put(p, "time_of_depth_ms", 1e3 * s->t_depth_max);
}

void cr_json_occupant(const struct cr_severity *s, cJSON *p) {
    cr_json_put(p, "olc_g", s->olc / CR_G);
    cr_json_put(p, "asi", s->asi);
    cr_json_put(p, "thiv_kmh", cr_kmh(s->thiv));
    cr_json_put(p, "phd_g", s->phd / CR_G);
    cr_json_put(p, "vpi_g", s->vpi / CR_G);
}

void cr_json_injury(const struct cr_severity *s, cJSON *p) {
    cJSON *list = cr_tree_array(p, "injury");
    for (int i = 0; i < s->injuries; i++) {
        cJSON *one = cJSON_CreateObject();
        cr_tree_text(one, "function", s->injury[i].function);
        cr_json_put(one, "probability", s->injury[i].probability);
        cr_tree_text(one, "injury", s->injury[i].level);
        cr_tree_bool(one, "extrapolated", s->injury[i].extrapolated);
        cr_tree_push(list, one);
    }
}

/* What a deformable barrier took up, also one that is fixed and has no motion to tell. */
void cr_json_barrier(const struct cr_result *r, int i, cJSON *p) {
    const struct cr_severity *s = &r->of[i];
    double plastic = r->solution->balance.plastic;
    cJSON *one = cr_tree_object(p, "barrier");
    cr_tree_text(one, "name", r->resolved.part[i].barrier);
    cr_json_put(one, "energy_kJ", s->energy / 1e3);
    cr_json_put(one, "energy_share", plastic > 0 ? s->energy / plastic : (double)NAN);
    cr_json_put(one, "depth_m", s->face_depth_dynamic);
    cr_json_put(one, "area_m2", s->deformation_area);
}

void cr_json_totals(const struct cr_severity *s, cJSON *p) {
    cr_json_put(p, "delta_v_net_kmh", cr_kmh(s->delta_v_net));
    cr_json_put(p, "impacts", s->impacts);
    cr_json_put(p, "severest_impact", s->severest < 0 ? (double)NAN : s->severest);
}

static void put_vehicle(const struct cr_result *r, const struct cr_impact *k, int side,
                        cJSON *list) {
    int i = k->body[side];
    bool vehicle = r->resolved.part[i].kind == CR_KIND_VEHICLE;
    if (!cr_result_moves(r, i)) {
        return;
    }
    cJSON *p = cJSON_CreateObject();
    cr_tree_push(list, p);
    cr_tree_text(p, "id", r->resolved.part[i].id);
    if (!vehicle) {
        cr_tree_text(p, "kind", "object");
    }
    cr_json_motion(&k->of[side], CR_RESULT_VERSION, p);
    if (vehicle) {
        cr_json_deformation(&k->of[side], CR_RESULT_VERSION, p);
        cr_json_pulse(&k->of[side], p);
        cr_json_injury(&k->of[side], p);
    }
}

void cr_json_impacts(const struct cr_result *r, cJSON *json) {
    cJSON *list = cr_tree_array(json, "impacts");
    for (int i = 0; i < r->impacts; i++) {
        const struct cr_impact *k = &r->impact[i];
        cJSON *one = cJSON_CreateObject();
        cr_tree_push(list, one);
        cr_json_put(one, "t_s", k->t_begin);
        cr_json_put(one, "end_s", k->t_end);
        cJSON *between = cr_tree_array(one, "between");
        cr_tree_push(between, cJSON_CreateString(r->resolved.part[k->body[0]].id));
        cr_tree_push(between, cJSON_CreateString(r->resolved.part[k->body[1]].id));
        cr_tree_text(one, "stop", cr_stop_word(k->stop));
        cr_json_put(one, "contacts", k->contacts);
        cr_json_put(one, "closing_kmh", cr_kmh(k->closing));
        cr_json_put(one, "restitution", k->restitution);
        cr_json_put(one, "friction", k->mu);
        cr_json_put(one, "friction_kJ", k->friction / 1e3);
        cr_json_put(one, "impulse_x_Ns", k->impulse.x);
        cr_json_put(one, "impulse_y_Ns", k->impulse.y);
        cr_tree_put(one, "coe_m", cr_json_point(k->coe));
        cr_tree_put(one, "normal", cr_json_point(k->normal));
        cJSON *vehicles = cr_tree_array(one, "vehicles");
        put_vehicle(r, k, 0, vehicles);
        put_vehicle(r, k, 1, vehicles);
    }
}

/* Lists the doubts among the warnings, each code once. */
void cr_json_quality(const struct cr_result *r, cJSON *json) {
    cJSON *quality = cr_tree_object(json, "quality"), *flags = cJSON_CreateArray();
    for (int i = 0; i < r->warnings; i++) {
        bool told = !cr_result_is_doubt(r->warning_code[i]);
        for (int k = 0; k < i; k++) {
            told = told || strcmp(r->warning_code[k], r->warning_code[i]) == 0;
        }
        if (!told) {
            cr_tree_push(flags, cJSON_CreateString(r->warning_code[i]));
        }
    }
    cr_tree_bool(quality, "clean", cJSON_GetArraySize(flags) == 0);
    cr_tree_put(quality, "doubts", flags);
}

cJSON *cr_json_warning(const struct cr_result *r, int i, int version) {
    if (version == 1) {
        return cJSON_CreateString(r->warning[i]);
    }
    cJSON *one = cJSON_CreateObject();
    cr_tree_text(one, "code", r->warning_code[i]);
    cr_tree_text(one, "text", r->warning[i]);
    return one;
}

static void put_robust_number(const struct cr_result *r, int part, int i, cJSON *to) {
    int n;
    const struct cr_measure *m = &cr_measures(&n)[i];
    const struct cr_unit *unit = cr_measure_unit(m);
    long at = (long)part * n + i;
    cJSON *one = cr_tree_object(to, m->key);
    cr_json_put(one, "value", cr_unit_from_si(unit, cr_measure_get(m, &r->of[part])));
    cr_json_put(one, "least", cr_unit_from_si(unit, r->robust->least[at]));
    cr_json_put(one, "most", cr_unit_from_si(unit, r->robust->most[at]));
    cr_json_put(one, "spread", cr_unit_from_si(unit, cr_robust_spread(r->robust, part, i)));
    cr_json_put(one, "spread_percent", 100 * cr_robust_share(r, part, i));
    cr_tree_bool(one, "resolved", !cr_robust_is_unresolved(r, part, i));
}

void cr_json_robust(const struct cr_result *r, cJSON *json) {
    if (r->robust == NULL) {
        return;
    }
    cJSON *robust = cr_tree_object(json, "robust");
    cr_json_put(robust, "solves", r->robust->solves);
    cr_json_put(robust, "failed", r->robust->failed);
    cr_tree_text(robust, "nudged", CR_ROBUST_NUDGES);
    cJSON *vehicles = cr_tree_array(robust, "vehicles");
    for (int p = 0; p < r->resolved.n; p++) {
        if (r->resolved.part[p].kind != CR_KIND_VEHICLE) {
            continue;
        }
        cJSON *one = cJSON_CreateObject();
        cr_tree_push(vehicles, one);
        cr_tree_text(one, "id", r->resolved.part[p].id);
        for (int i = 0; i < r->robust->measures; i++) {
            put_robust_number(r, p, i, one);
        }
    }
}
