/* Reads the recipe that a vehicle type is built from (share/schema/recipe.schema.json). */
#include "config.h"

#include "model/json.h"

#include "base/vec.h"

#include <cjson/cJSON.h>

static void read_reference(struct cr_model_json *j, const cJSON *root, struct cr_model_recipe *r) {
    const cJSON *o = cr_model_json_object(j, root, "reference");
    struct cr_dims *d = &r->dims;
    const struct {
        const char *key;
        double *to, lo, hi;
    } row[] = {
        {"mass_kg", &r->mass, 300, 5000},
        {"length_m", &d->length, 2, 7},
        {"width_m", &d->width, 1, 2.6},
        {"height_m", &d->height, 1, 3},
        {"wheelbase_m", &d->wheelbase, 1, 5},
        {"track_m", &d->track, 1, 2.4},
        {"front_overhang_m", &d->front_overhang, 0.2, 2},
        {"cg_behind_front_axle_m", &d->cg_behind_front_axle, 0.2, 4},
        {"cg_height_m", &d->cg_height, 0.2, 1.5},
        {"a_pillar_m", &r->a_pillar, 0.5, 4},
        {"b_pillar_m", &r->b_pillar, 0.5, 5},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        *row[i].to = cr_model_json_number(j, o, row[i].key, row[i].lo, row[i].hi);
    }
    cr_model_json_leave(j);
}

static void read_rules(struct cr_model_json *j, const cJSON *root, struct cr_model_rules *r) {
    const cJSON *o = cr_model_json_object(j, root, "rules");
    r->cg_height = cr_model_json_number(j, o, "cg_height_m", 0.2, 1);
    r->cg_height_per_kg = cr_model_json_number(j, o, "cg_height_m_per_kg", 0, 1e-3);
    r->track = cr_model_json_number(j, o, "track_m", 0.5, 2);
    r->track_per_kg = cr_model_json_number(j, o, "track_m_per_kg", 0, 1e-3);
    r->end_low = cr_model_json_number(j, o, "end_low_share", 0, 0.5);
    cr_model_json_leave(j);
}

/* Reads how far an end stands back over the share of the half width: 0 on the centre line, so that
 * every layer of depth has material. */
static void read_end(struct cr_model_json *j, const cJSON *shape, const char *key,
                     struct cr_model_knots *k) {
    cr_model_json_knots(j, shape, key, k);
    if (j->failed) {
        return;
    }
    if (k->x[0] != 0 || k->y[0] != 0 || k->x[k->n - 1] != 1) {
        cr_model_json_fail(j, CR_ERR_MODEL, key, "knots must run from [0, 0] to [1, setback]");
    }
    for (int i = 1; i < k->n; i++) {
        if (k->y[i] < k->y[i - 1] || k->y[i] > 0.9) {
            cr_model_json_fail(j, CR_ERR_MODEL, key,
                               "setback must not fall outward and not exceed 0.9 m");
        }
    }
}

static void read_shape(struct cr_model_json *j, const cJSON *root, struct cr_model_recipe *r) {
    const cJSON *o = cr_model_json_object(j, root, "shape");
    read_end(j, o, "front_m", &r->end[0]);
    read_end(j, o, "rear_m", &r->end[1]);
    cr_model_json_knots(j, o, "top_m", &r->top);
    cr_model_json_knots(j, o, "bottom_m", &r->bottom);
    cr_model_json_knots(j, o, "side_share", &r->side);
    r->keep_below = cr_model_json_number(j, o, "keep_heights_below_m", 0.1, 1);
    r->wheel_radius = cr_model_json_number(j, o, "wheel_radius_m", 0.1, 0.8);
    r->wheel_width = cr_model_json_number(j, o, "wheel_width_m", 0.05, 0.6);
    r->house_radius = cr_model_json_number(j, o, "wheel_house_radius_m", 0.1, 1);
    cr_model_json_leave(j);
}

static double read_or_0(struct cr_model_json *j, const cJSON *o, const char *key, double most) {
    return cJSON_HasObjectItem(o, key) ? cr_model_json_number(j, o, key, 0, most) : 0;
}

static void read_face(struct cr_model_json *j, const cJSON *faces, const char *key, double mass,
                      struct cr_model_face *f) {
    const cJSON *o = cr_model_json_object(j, faces, key);
    cr_model_json_knots(j, o, "depth_m_ees_kmh", &f->ees);
    for (int i = 0; i < f->ees.n; i++) {
        f->ees.y[i] = cr_mps(f->ees.y[i]);
        if (f->ees.y[i] < 0 || (i > 0 && f->ees.y[i] < f->ees.y[i - 1])) {
            cr_model_json_fail(j, CR_ERR_MODEL, "depth_m_ees_kmh",
                               "EES must be 0 or more and never fall with depth");
        }
    }
    if (!j->failed && (f->ees.x[0] != 0 || f->ees.y[0] != 0)) {
        cr_model_json_fail(j, CR_ERR_MODEL, "depth_m_ees_kmh", "first knot must be [0, 0]");
    }
    static const char *const between[] = {"ees", "energy"};
    f->energy_linear = cr_model_json_word(j, o, "between", between, 2) == 1;
    f->compartment = read_or_0(j, o, "compartment_N", 1e7);
    f->beyond = f->compartment / mass;
    f->springback = cr_model_json_number(j, o, "springback_m", 0, 0.6);
    f->spread = cr_model_json_number(j, o, "residual_spread_m", 0.01, 0.6);
    f->drag_bend = read_or_0(j, o, "drag_bend_per_m", 100);
    f->drag_slope = cJSON_HasObjectItem(o, "drag_bend_per_m")
                        ? read_or_0(j, o, "drag_slope", 100)
                        : cr_model_json_number(j, o, "drag_slope", 0, 100); /* one must be said */
    f->block = read_or_0(j, o, "block_m", 10);
    f->built.n = 0;
    if (cJSON_HasObjectItem(o, "built_strength")) {
        cr_model_json_knots(j, o, "built_strength", &f->built);
        for (int i = 0; i < f->built.n && !j->failed; i++) {
            if (!(f->built.y[i] >= 0.1 && f->built.y[i] <= 10)) {
                cr_model_json_fail(j, CR_ERR_RANGE, "built_strength",
                                   "a strength against the mean of the tests is 0.1 to 10");
            }
        }
    }
    cr_model_json_leave(j);
}

static void read_box(struct cr_model_json *j, const cJSON *item, struct cr_model_box *b) {
    static const char *const known[] = {"name",         "x_m",     "y_m",  "z_m",
                                        "longitudinal", "lateral", "basis"};
    cr_model_json_only(j, item, known, sizeof known / sizeof known[0]);
    cr_model_json_text(j, item, "name", b->name, sizeof b->name);
    cr_model_json_range(j, item, "x_m", b->x, -0.5, 8);
    cr_model_json_range(j, item, "y_m", b->y, 0, 1.5);
    cr_model_json_range(j, item, "z_m", b->z, 0, 3);
    b->weight[0] = cr_model_json_number(j, item, "longitudinal", 0, 1000);
    b->weight[1] = cr_model_json_number(j, item, "lateral", 0, 1000);
}

static void read_structures(struct cr_model_json *j, const cJSON *root, struct cr_model_recipe *r) {
    const cJSON *body = cr_model_json_object(j, root, "body_weight");
    r->body_weight[0] = cr_model_json_number(j, body, "longitudinal", 1e-3, 1000);
    r->body_weight[1] = cr_model_json_number(j, body, "lateral", 1e-3, 1000);
    cr_model_json_leave(j);
    const cJSON *list = cr_model_json_array(j, root, "structures"), *item = NULL;
    cJSON_ArrayForEach(item, list) {
        if (r->boxes == CR_MODEL_BOXES) {
            cr_model_json_fail(j, CR_ERR_RANGE, NULL, "too many structures, at most 64");
            break;
        }
        cr_model_json_enter(j, NULL, r->boxes);
        read_box(j, item, &r->box[r->boxes++]);
        cr_model_json_leave(j);
    }
    cr_model_json_leave(j);
}

/* Refuses a reference vehicle whose lines are not in order: stretching would divide by nothing. */
static void check_reference(struct cr_model_json *j, const struct cr_model_recipe *r) {
    struct cr_model_stretch stretch;
    struct cr_error why = {0};
    if (!j->failed && cr_model_stretch_make(r, &r->dims, &stretch, &why) != CR_ERR_OK) {
        cr_model_json_fail(j, CR_ERR_MODEL, "reference", why.text);
    }
}

enum cr_err cr_model_recipe_read(const char *text, size_t len, const char *src,
                                 struct cr_model_recipe *r, struct cr_error *err) {
    static const char *const known[] = {"crumple_recipe", "type",       "label",       "reference",
                                        "shape",          "faces",      "body_weight", "structures",
                                        "calibration",    "provenance", "rules"};
    *r = (struct cr_model_recipe){.boxes = 0};
    struct cr_model_json j;
    cJSON *root = cr_model_json_parse(&j, text, len, src, err);
    if (root == NULL) {
        return j.code;
    }
    cr_model_json_only(&j, root, known, sizeof known / sizeof known[0]);
    cr_model_json_number(&j, root, "crumple_recipe", 1, 1);
    cr_model_json_text(&j, root, "label", r->label, sizeof r->label);
    read_reference(&j, root, r);
    read_rules(&j, root, &r->rules);
    read_shape(&j, root, r);
    const cJSON *faces = cr_model_json_object(&j, root, "faces");
    read_face(&j, faces, "front", r->mass, &r->face[CR_MODEL_FRONT]);
    read_face(&j, faces, "side", r->mass, &r->face[CR_MODEL_SIDE]);
    read_face(&j, faces, "rear", r->mass, &r->face[CR_MODEL_REAR]);
    cr_model_json_leave(&j);
    read_structures(&j, root, r);
    check_reference(&j, r);
    cJSON_Delete(root);
    cr_hash_hex(text, len, r->hash);
    return j.code;
}
