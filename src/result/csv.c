/* Writes a result as CSV for spreadsheets: a row per participant, with impacts a row per impact and
 * participant, with trace a row per time slice and participant; every column names its unit. */
#include "result/result_priv.h"

#include <math.h>
#include <string.h>

/* Adds a comma and the number; NaN and infinity leave the field empty. */
static void number(struct cr_str *out, double x) {
    if (isfinite(x)) {
        cr_str_addf(out, ",%.12g", x);
    } else {
        cr_str_add(out, ",");
    }
}

static void row(const struct cr_result *r, int i, struct cr_str *out) {
    const struct cr_severity *s = &r->of[i];
    const struct cr_outcome *o = &r->solution->body[i];
    bool rests = isfinite(o->t_rest); /* what moves still has no place of rest */
    const double value[] = {cr_kmh(s->ees),
                            s->energy / 1e3,
                            s->energy_induced / 1e3,
                            cr_kmh(s->delta_v),
                            cr_kmh(s->delta_v_body.x),
                            cr_kmh(s->delta_v_body.y),
                            cr_kmh(s->delta_v_world.x),
                            cr_kmh(s->delta_v_world.y),
                            cr_deg(s->pdof),
                            s->pdof_clock,
                            cr_deg(s->yaw_rate_change),
                            cr_kmh(s->speed_after),
                            cr_deg(s->course_after),
                            cr_deg(s->yaw_rate_after),
                            s->deformation_max,
                            s->deformation_dynamic_max,
                            s->deformation_area,
                            s->profile[0],
                            s->profile[1],
                            s->profile[2],
                            s->profile[3],
                            s->profile[4],
                            s->profile[5],
                            s->acceleration_max / CR_G,
                            s->acceleration_mean / CR_G,
                            1e3 * s->pulse,
                            s->olc / CR_G,
                            s->asi,
                            cr_kmh(s->thiv),
                            rests ? o->rest.pos.x : (double)NAN,
                            rests ? o->rest.pos.y : (double)NAN,
                            rests ? cr_deg(o->rest.heading) : (double)NAN,
                            o->t_rest};
    cr_str_csv(out, r->scene.name);
    cr_str_add(out, ",");
    cr_str_csv(out, r->resolved.part[i].id);
    cr_str_add(out, ",");
    cr_str_csv(out, s->model);
    cr_str_add(out, ",");
    cr_str_csv(out, s->cdc);
    for (size_t k = 0; k < sizeof value / sizeof *value; k++) {
        number(out, value[k]);
    }
    cr_str_add(out, "\n");
}

static void impact_row(const struct cr_result *r, int impact, int side, struct cr_str *out) {
    const struct cr_impact *one = &r->impact[impact];
    const struct cr_severity *s = &one->of[side];
    int i = one->body[side];
    bool deforms = cr_result_grid(r, i)->nx > 0;
    const double *c = s->profile;
    const double value[] = {one->t_begin,
                            one->t_end,
                            cr_kmh(s->ees),
                            s->energy / 1e3,
                            s->energy_induced / 1e3,
                            cr_kmh(s->delta_v),
                            cr_kmh(s->delta_v_body.x),
                            cr_kmh(s->delta_v_body.y),
                            cr_kmh(s->delta_v_world.x),
                            cr_kmh(s->delta_v_world.y),
                            cr_deg(s->pdof),
                            s->pdof_clock,
                            s->coe.x,
                            s->coe.y,
                            cr_kmh(one->closing),
                            cr_deg(s->yaw_rate_change),
                            s->face_depth,
                            s->face_depth_dynamic,
                            s->second.depth,
                            s->damage_width,
                            c[0],
                            c[1],
                            c[2],
                            c[3],
                            c[4],
                            c[5],
                            s->profile_width,
                            s->profile_middle,
                            s->acceleration_max / CR_G,
                            s->acceleration_mean / CR_G,
                            1e3 * s->pulse};
    cr_str_csv(out, r->scene.name);
    cr_str_addf(out, ",%d,", impact + 1);
    cr_str_csv(out, r->resolved.part[i].id);
    cr_str_add(out, ",");
    cr_str_csv(out, r->resolved.part[one->body[!side]].id);
    cr_str_addf(out, ",%s,%s,%s,%s", deforms ? cr_face_word(s->face) : "",
                deforms ? cr_face_word(s->second.face) : "", cr_stop_word(one->stop), s->cdc);
    for (size_t k = 0; k < sizeof value / sizeof *value; k++) {
        number(out, value[k]);
    }
    cr_str_add(out, "\n");
}

static void table(const struct cr_result *r, struct cr_str *out) {
    cr_str_add(out, "scene,id,model,cdc,ees_kmh,energy_kJ,energy_induced_kJ,delta_v_kmh,"
                    "delta_v_forward_kmh,delta_v_left_kmh,delta_v_x_kmh,delta_v_y_kmh,pdof_deg,"
                    "pdof_clock,yaw_rate_change_deg_s,speed_after_kmh,course_after_deg,"
                    "yaw_rate_after_deg_s,deformation_max_m,deformation_dynamic_max_m,"
                    "deformation_area_m2,c1_m,c2_m,c3_m,c4_m,c5_m,c6_m,acceleration_max_g,"
                    "acceleration_mean_g,pulse_ms,olc_g,asi,thiv_kmh,rest_x_m,rest_y_m,"
                    "rest_heading_deg,rest_t_s\n");
    for (int i = 0; i < r->solution->bodies; i++) {
        if (cr_result_moves(r, i)) {
            row(r, i, out);
        }
    }
}

static void impacts(const struct cr_result *r, struct cr_str *out) {
    cr_str_add(out, "scene,impact,id,partner,face,second_face,stop,cdc,t_s,end_s,ees_kmh,energy_kJ,"
                    "energy_induced_kJ,delta_v_kmh,delta_v_forward_kmh,delta_v_left_kmh,"
                    "delta_v_x_kmh,delta_v_y_kmh,pdof_deg,pdof_clock,coe_forward_m,coe_left_m,"
                    "closing_kmh,yaw_rate_change_deg_s,face_depth_m,face_depth_dynamic_m,"
                    "second_depth_m,damage_width_m,c1_m,c2_m,c3_m,c4_m,c5_m,c6_m,profile_width_m,"
                    "profile_middle_m,acceleration_max_g,acceleration_mean_g,pulse_ms\n");
    for (int k = 0; k < 2 * r->impacts; k++) {
        const struct cr_impact *one = &r->impact[k / 2];
        if (cr_result_moves(r, one->body[k % 2])) {
            impact_row(r, k / 2, k % 2, out);
        }
    }
}

static void trace(const struct cr_result *r, struct cr_str *out) {
    const struct cr_solution *sol = r->solution;
    cr_str_add(out, "scene,id,t_s");
    for (int q = 0; q < CR_QUANTITIES; q++) {
        cr_str_addf(out, ",%s", cr_quantity_key((enum cr_quantity)q));
    }
    cr_str_add(out, "\n");
    for (int k = 0; k < sol->samples; k++) {
        for (int i = 0; i < sol->bodies; i++) {
            cr_str_csv(out, r->scene.name);
            cr_str_add(out, ",");
            cr_str_csv(out, r->resolved.part[i].id);
            number(out, sol->t[k]);
            for (int q = 0; q < CR_QUANTITIES; q++) {
                number(out, cr_result_quantity(sol, k, i, (enum cr_quantity)q));
            }
            cr_str_add(out, "\n");
        }
    }
}

enum cr_err cr_result_csv(const struct cr_result *r, const struct cr_result_opts *opts,
                          struct cr_str *out, struct cr_error *err) {
    if (opts->trace) {
        trace(r, out);
    } else if (opts->impacts) {
        impacts(r, out);
    } else {
        table(r, out);
    }
    return out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the CSV of a result")
                       : CR_ERR_OK;
}
