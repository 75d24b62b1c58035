/* Writes a result as JSON (share/schema, version 2, version 1 on request). Every number passes
 * cr_round12, so that the text is the same on machines whose last bits differ; NaN and infinity
 * become null. */
#include "config.h"

#include "result/json_priv.h"

#include "base/hash.h"
#include "base/json.h"
#include "base/number.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void put_assumed(const struct cr_result *r, int version, cJSON *json) {
    cJSON *list = cr_tree_array(json, "assumed");
    for (int i = 0; i < r->assumed.n; i++) {
        cr_tree_push(list, cJSON_CreateString(r->assumed.key[i]));
    }
    list = cr_tree_array(json, "warnings");
    for (int i = 0; i < r->warnings; i++) {
        cr_tree_push(list, cr_json_warning(r, i, version));
    }
}

enum cr_err cr_result_scene_hash(const struct cr_scene *scene, char hex[CR_HASH_SIZE],
                                 struct cr_error *err) {
    struct cr_str text = {0};
    enum cr_err code = CR_ERR_OK;
    if (cr_json_add(cr_scene_to_json(scene, false), false, &text)) {
        cr_hash_hex(text.s, text.len, hex);
    } else {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory to hash a scene");
    }
    cr_str_fini(&text);
    return code;
}

/* Repeats what the scene says of the file it was made from, and which values a car of the catalogue
 * gave; false without memory. */
static bool put_origin(const struct cr_result *r, cJSON *input) {
    cJSON *scene = cr_scene_to_json(&r->scene, false);
    cJSON *source = cJSON_DetachItemFromObjectCaseSensitive(scene, "source");
    cJSON_Delete(scene);
    if (source != NULL && !cJSON_AddItemToObject(input, "source", source)) {
        cJSON_Delete(source);
        return false;
    }
    cJSON *from = NULL;
    for (int i = 0; i < r->assumed.n; i++) {
        if (r->assumed.from[i][0] != '\0') {
            from = from != NULL ? from : cr_tree_object(input, "catalogue");
            cr_tree_text(from, r->assumed.key[i], r->assumed.from[i]);
        }
    }
    return scene != NULL;
}

static bool put_input(const struct cr_result *r, const struct cr_result_opts *opts, cJSON *json) {
    cJSON *input = cr_tree_object(json, "input");
    char hex[CR_HASH_SIZE];
    if (cr_result_scene_hash(&r->scene, hex, NULL)) {
        return false;
    }
    cr_tree_text(input, "scene_sha256", hex);
    cJSON *models = cr_tree_object(input, "models");
    for (int i = 0; i < r->resolved.n; i++) {
        if (cr_result_model(r, i)[0] == '\0') {
            continue;
        }
        struct cr_str s = {0};
        cr_str_addf(&s, "%s sha256 %s", cr_result_model(r, i), cr_result_model_hash(r, i));
        cr_tree_str(models, r->resolved.part[i].id, &s);
        cr_str_fini(&s);
    }
    if (r->irf_hash[0] != '\0' && opts->version != 1) {
        cr_tree_text(input, "irf_sha256", r->irf_hash);
    }
    if (!put_origin(r, input)) {
        return false;
    }
    if (opts->resolved) {
        cJSON *all = cr_scene_to_json(&r->resolved, true);
        if (!all) {
            return false;
        }
        cr_tree_put(input, "resolved", all);
    }
    return true;
}

static void put_time(const struct cr_result *r, cJSON *json) {
    cJSON *time = cr_tree_object(json, "time");
    int main = cr_result_main_contact(r->solution, -1);
    const struct cr_contact *c = main < 0 ? NULL : &r->solution->contact[main];
    double last = NAN;
    for (int i = 0; i < r->solution->bodies; i++) {
        last = fmax(last, r->solution->body[i].t_last);
    }
    cr_json_put(time, "contact_s", r->solution->t_contact);
    cr_json_put(time, "plastic_end_s", c ? c->t_plastic_end : (double)NAN);
    cr_json_put(time, "elastic_end_s", c ? c->t_elastic_end : (double)NAN);
    cr_json_put(time, "separation_s", last);
    enum cr_stop stop = r->solution->interrupted ? CR_STOP_INTERRUPTED : c ? c->stop : CR_STOP_NONE;
    cr_tree_text(time, "stop", cr_stop_word(stop));
    cr_json_put(time, "slice_ms", 1e3 * r->solution->dt);
    cr_json_put(time, "passes", r->passes);
}

/* A participant that still moves at the end has no place of rest; version 1 told where it was. */
static void put_rest(const struct cr_outcome *o, int version, cJSON *p) {
    cJSON *rest = cr_tree_object(p, "rest");
    bool rests = version == 1 || isfinite(o->t_rest);
    cr_json_put(rest, "x_m", rests ? o->rest.pos.x : (double)NAN);
    cr_json_put(rest, "y_m", rests ? o->rest.pos.y : (double)NAN);
    cr_json_put(rest, "heading_deg", rests ? cr_deg(o->rest.heading) : (double)NAN);
    cr_json_put(rest, "t_s", o->t_rest);
}

static void put_participants(const struct cr_result *r, int version, cJSON *json) {
    cJSON *list = cr_tree_array(json, "participants");
    for (int i = 0; i < r->solution->bodies; i++) {
        bool vehicle = r->resolved.part[i].kind == CR_KIND_VEHICLE;
        cJSON *p = cJSON_CreateObject();
        cr_tree_push(list, p);
        cr_tree_text(p, "id", r->resolved.part[i].id);
        if (!vehicle) {
            cr_tree_text(p, "kind", "object");
        }
        /* a fixed object has no motion to report */
        if (cr_result_moves(r, i)) {
            cr_json_motion(&r->of[i], version, p);
        }
        if (cr_result_moves(r, i) && version > 1) {
            cr_json_totals(&r->of[i], p);
        }
        if (!vehicle && r->resolved.part[i].shape == CR_OBJECT_BARRIER) {
            cr_json_barrier(r, i, p);
        }
        if (vehicle) {
            cr_json_deformation(&r->of[i], version, p);
            cr_json_outline(&r->of[i], p);
            cr_json_pulse(&r->of[i], p);
            cr_json_occupant(&r->of[i], p);
        }
        if (cr_result_moves(r, i)) {
            put_rest(&r->solution->body[i], version, p);
        }
        if (vehicle) {
            cr_json_injury(&r->of[i], p);
        }
    }
}

static void put_contacts(const struct cr_result *r, cJSON *json) {
    cJSON *list = cr_tree_array(json, "contacts");
    for (int k = 0; k < r->solution->contacts; k++) {
        const struct cr_contact *c = &r->solution->contact[k];
        cJSON *one = cJSON_CreateObject();
        cr_tree_push(list, one);
        cr_tree_text(one, "a", r->resolved.part[c->a].id);
        cr_tree_text(one, "b", r->resolved.part[c->b].id);
        cr_json_put(one, "begin_s", c->t_begin);
        /* Bodies that still touch when all has come to rest count as parted. */
        bool closed = !r->solution->interrupted, open = c->stop == CR_STOP_NONE && closed;
        double end = closed ? r->solution->t[r->solution->samples - 1] : (double)NAN;
        cr_json_put(one, "plastic_end_s", isfinite(c->t_plastic_end) ? c->t_plastic_end : end);
        cr_json_put(one, "elastic_end_s", isfinite(c->t_elastic_end) ? c->t_elastic_end : end);
        cr_json_put(one, "end_s", isfinite(c->t_end) ? c->t_end : end);
        cr_tree_text(one, "stop", cr_stop_word(open ? CR_STOP_SEPARATION : c->stop));
        cr_json_put(one, "closing_kmh", cr_kmh(c->closing));
        cr_json_put(one, "restitution", c->restitution);
        cr_json_put(one, "friction", c->mu);
        cr_json_put(one, "impulse_x_Ns", c->impulse.x);
        cr_json_put(one, "impulse_y_Ns", c->impulse.y);
        cr_tree_put(one, "coe_m", cr_json_point(c->coe));
        cr_tree_put(one, "normal", cr_json_point(c->normal));
        cr_json_put(one, "energy_a_kJ", c->energy[0] / 1e3);
        cr_json_put(one, "energy_b_kJ", c->energy[1] / 1e3);
        cr_json_put(one, "friction_kJ", c->friction / 1e3);
    }
}

static void put_balance(const struct cr_balance *b, cJSON *json) {
    cJSON *to = cr_tree_object(json, "balance");
    cr_json_put(to, "kinetic_before_kJ", b->kinetic_before / 1e3);
    cr_json_put(to, "kinetic_after_kJ", b->kinetic_after / 1e3);
    cr_json_put(to, "plastic_kJ", b->plastic / 1e3);
    cr_json_put(to, "friction_kJ", b->friction / 1e3);
    cr_json_put(to, "tyre_kJ", b->tyre / 1e3);
    cr_json_put(to, "momentum_residual", b->momentum_residual);
    cr_json_put(to, "energy_residual", b->energy_residual);
    cr_json_put(to, "angular_residual", b->angular_residual);
}

static void put_trace(const struct cr_result *r, cJSON *json) {
    const struct cr_solution *sol = r->solution;
    cJSON *trace = cr_tree_object(json, "trace");
    cr_tree_put(trace, "t_s", cr_json_numbers(sol->t, sol->samples));
    for (int i = 0; i < sol->bodies; i++) {
        cJSON *p = cr_tree_object(trace, r->resolved.part[i].id);
        for (int q = 0; q < CR_QUANTITIES; q++) {
            cJSON *list = cr_tree_array(p, cr_quantity_key((enum cr_quantity)q));
            for (int k = 0; k < sol->samples; k++) {
                double x = cr_result_quantity(sol, k, i, (enum cr_quantity)q);
                cr_tree_push(list,
                             isfinite(x) ? cJSON_CreateNumber(cr_round12(x)) : cJSON_CreateNull());
            }
        }
    }
}

/* Adds the text of json with a newline to out; deletes json. */
static enum cr_err print(cJSON *json, bool pretty, struct cr_str *out, struct cr_error *err) {
    bool done = cr_json_add(json, pretty, out);
    cr_str_add(out, "\n");
    return done && !out->failed
               ? CR_ERR_OK
               : cr_err_set(err, CR_ERR_MEMORY, "no memory for the JSON of a result");
}

enum cr_err cr_result_tree(const struct cr_result *r, const struct cr_result_opts *opts,
                           cJSON **out, struct cr_error *err) {
    cJSON *json = cJSON_CreateObject();
    int version = opts->version ? opts->version : CR_RESULT_VERSION;
    *out = NULL;
    cr_json_put(json, "crumple_result", version);
    cr_tree_text(json, "scene", r->scene.name);
    cr_tree_text(json, "version", PACKAGE_VERSION);
    cr_tree_text(json, "method", r->resolved.set.method == CR_METHOD_PAPER ? "paper" : "extended");
    if (r->scene.pair[0]) {
        cr_tree_text(json, "pair", r->scene.pair);
    }
    put_assumed(r, version, json);
    if (version > 1) {
        cr_json_quality(r, json);
        cr_json_robust(r, json);
    }
    if (!put_input(r, opts, json)) {
        cJSON_Delete(json);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the JSON of a result");
    }
    put_time(r, json);
    put_participants(r, version, json);
    if (version > 1) {
        cr_json_impacts(r, json);
    }
    put_contacts(r, json);
    put_balance(&r->solution->balance, json);
    if (opts->trace) {
        put_trace(r, json);
    }
    if (json == NULL || !cr_tree_whole(json)) {
        cJSON_Delete(json);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the JSON of a result");
    }
    *out = json;
    return CR_ERR_OK;
}

enum cr_err cr_result_json(const struct cr_result *r, const struct cr_result_opts *opts,
                           struct cr_str *out, struct cr_error *err) {
    cJSON *json;
    enum cr_err code = cr_result_tree(r, opts, &json, err);
    return code == CR_ERR_OK ? print(json, opts->pretty, out, err) : code;
}

cJSON *cr_result_error_tree(const char *scene, const struct cr_error *what,
                            const struct cr_result_opts *opts) {
    cJSON *json = cJSON_CreateObject();
    cr_json_put(json, "crumple_result", opts->version ? opts->version : CR_RESULT_VERSION);
    cr_tree_text(json, "scene", scene ? scene : "");
    cJSON *e = cr_tree_object(json, "error");
    cr_tree_text(e, "code", cr_err_word(what->code));
    struct cr_str s = {0};
    cr_str_add(&s, what->text);
    if (what->hint[0]) {
        cr_str_addf(&s, "; %s", what->hint);
    }
    cr_tree_str(e, "message", &s);
    cr_str_clear(&s);
    if (what->src[0]) {
        cr_str_addf(&s, "%s:", what->src);
    }
    if (what->line > 0) {
        cr_str_addf(&s, what->col > 0 ? "%d:%d:" : "%d:", what->line, what->col);
    }
    cr_str_add(&s, what->where);
    cr_tree_str(e, "where", &s);
    cr_str_fini(&s);
    return json;
}

enum cr_err cr_result_error_json(const char *scene, const struct cr_error *what,
                                 const struct cr_result_opts *opts, struct cr_str *out,
                                 struct cr_error *err) {
    return print(cr_result_error_tree(scene, what, opts), opts->pretty, out, err);
}
