/* What is known of each model: from the calibration and provenance of its recipe. */
#include "config.h"

#include "cli/models.h"

#include "base/file.h"
#include "base/json.h"
#include "base/tree.h"
#include "base/vec.h"

#include <cjson/cJSON.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum cr_err cr_model_papers_read(const char *dir, struct cr_model_papers *out,
                                 struct cr_error *err) {
    *out = (struct cr_model_papers){{NULL}};
    for (int i = 0; i < CR_TYPES; i++) {
        char path[600], *text = NULL;
        size_t len = 0;
        snprintf(path, sizeof path, "%s/%s.json", dir, cr_type_word((enum cr_type)i));
        enum cr_err code = cr_file_read_regular(path, &text, &len, err);
        if (code) {
            return code;
        }
        out->recipe[i] = cJSON_ParseWithLength(text, len);
        if (out->recipe[i] == NULL && cr_json_check(text, len, NULL, NULL) == CR_ERR_OK) {
            code = cr_err_set(err, CR_ERR_MEMORY, "no memory for a recipe");
        }
        free(text);
        if (code) {
            return code;
        }
    }
    return CR_ERR_OK;
}

void cr_model_papers_fini(struct cr_model_papers *papers) {
    for (int i = 0; i < CR_TYPES; i++) {
        cJSON_Delete(papers->recipe[i]);
        papers->recipe[i] = NULL;
    }
}

/* One row of the list. */
struct row {
    enum cr_type type;
    int clock;
    const char *face;
    int tests, borrowed;
    double mpe, sd; /* of the residual depth, %; NaN: no tests */
    char basis[160];
};

static double number(const cJSON *o, const char *key) {
    const cJSON *m = cJSON_GetObjectItemCaseSensitive(o, key);
    return cJSON_IsNumber(m) ? m->valuedouble : (double)NAN;
}

static struct row row_of(const struct cr_model_papers *papers, enum cr_type type, int clock) {
    static const char *const face[] = {"front", "side", "side", "side", "rear", "rear",
                                       "rear",  "side", "side", "side", "front"};
    struct row r = {.type = type, .clock = clock, .face = clock == 12 ? "front" : face[clock - 1]};
    const cJSON *cal = cJSON_GetObjectItemCaseSensitive(
        cJSON_GetObjectItemCaseSensitive(papers->recipe[type], "calibration"), r.face);
    double tests = number(cal, "tests"), borrowed = number(cal, "borrowed");
    r.tests = isfinite(tests) ? (int)tests : 0;
    r.borrowed = isfinite(borrowed) ? (int)borrowed : 0;
    r.mpe = number(cal, "depth_mpe_percent");
    r.sd = number(cal, "depth_sd_percent");
    const char *what = "assumption: one curve for all types, chosen with 81 rear crashes in view";
    if (r.face[0] != 'r') {
        what = r.face[0] == 'f' ? "rigid walls, 23 to 57 km/h" : "poles, 75 deg, 32 km/h";
    }
    const char *borrow = r.borrowed > 0 ? "; few of its own" : "";
    const char *oblique = clock % 3 == 0 ? "" : "; oblique: both directions in series (assumption)";
    snprintf(r.basis, sizeof r.basis, "%s%s%s", what, borrow, oblique);
    return r;
}

static void add_percent(struct cr_str *out, double x, bool sign) {
    if (isfinite(x)) {
        cr_str_addf(out, sign ? " %+7.1f" : " %6.1f", x);
    } else {
        cr_str_add(out, sign ? "       -" : "      -");
    }
}

void cr_model_list_text(const struct cr_model_papers *papers, int type, int clock,
                        struct cr_str *out) {
    cr_str_add(out, "model             face   tests borrowed  depth MPE %   SD %  basis\n");
    for (int k = 0; k < 12 * CR_TYPES; k++) {
        struct row r = row_of(papers, (enum cr_type)(k / 12), k % 12 == 0 ? 12 : k % 12);
        char name[40];
        if ((type < CR_TYPES && (int)r.type != type) || (clock > 0 && r.clock != clock)) {
            continue;
        }
        snprintf(name, sizeof name, "%s/%d", cr_type_word(r.type), r.clock);
        cr_str_addf(out, "%-17s %-6s %5d %8d     ", name, r.face, r.tests, r.borrowed);
        add_percent(out, r.mpe, true);
        add_percent(out, r.sd, false);
        cr_str_addf(out, "  %s\n", r.basis);
    }
    if (type == CR_TYPES) {
        cr_str_add(out, "\nTests and errors: greatest residual depth, solved against measured, of "
                        "the cars that count\nas the type (share/calibration/types.json); SD is "
                        "mostly the scatter from car to car.\n");
    }
}

/* the tests behind a model */
static void put_basis(cJSON *o, const struct row *r) {
    cr_tree_number(o, "tests", r->tests);
    cr_tree_number(o, "borrowed", r->borrowed);
    if (isfinite(r->mpe)) {
        cr_tree_number(o, "depth_mpe_percent", r->mpe);
        cr_tree_number(o, "depth_sd_percent", r->sd);
    }
    cr_tree_text(o, "basis", r->basis);
}

enum cr_err cr_model_list_json(const struct cr_model_papers *papers, int type, int clock,
                               struct cr_str *out, struct cr_error *err) {
    cJSON *list = cJSON_CreateArray();
    for (int k = 0; k < 12 * CR_TYPES && list != NULL; k++) {
        struct row r = row_of(papers, (enum cr_type)(k / 12), k % 12 == 0 ? 12 : k % 12);
        char name[40];
        if ((type < CR_TYPES && (int)r.type != type) || (clock > 0 && r.clock != clock)) {
            continue;
        }
        cJSON *o = cJSON_CreateObject();
        snprintf(name, sizeof name, "%s/%d", cr_type_word(r.type), r.clock);
        cr_tree_text(o, "model", name);
        cr_tree_text(o, "face", r.face);
        put_basis(o, &r);
        cr_tree_push(list, o);
    }
    if (!cr_json_add(list, true, out)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the list");
    }
    cr_str_add(out, "\n");
    return CR_ERR_OK;
}

static void add_faces(const struct cr_model_lib *lib, enum cr_type type, struct cr_str *out) {
    static const char *const name[] = {"front", "side", "rear"};
    cr_str_add(out, "\nEES of a whole face crushed to a dynamic depth, km/h\n  depth m");
    for (int d = 1; d <= 8; d++) {
        cr_str_addf(out, "%7.1f", 0.1 * d);
    }
    cr_str_add(out, "   springback m  drag slope, bend\n");
    for (int i = 0; i < CR_MODEL_ENDS; i++) {
        const struct cr_model_face *f = cr_model_face(lib, type, (enum cr_model_end)i);
        cr_str_addf(out, "  %-7s", name[i]);
        for (int d = 1; d <= 8; d++) {
            double e = cr_model_face_energy(f, CR_CURVE_DYNAMIC, 0.1 * d);
            cr_str_addf(out, "%7.1f", cr_kmh(sqrt(2 * e)));
        }
        cr_str_addf(out, "   %12.3f  %9.1f  %5.1f\n", f->springback, f->drag_slope, f->drag_bend);
    }
}

void cr_model_about(const struct cr_model_papers *papers, const struct cr_model_lib *lib,
                    enum cr_type type, struct cr_str *out) {
    double mass;
    const struct cr_dims *d = cr_model_dims(lib, type, &mass);
    const cJSON *recipe = papers->recipe[type], *item = NULL;
    const char *label = cJSON_GetStringValue(cJSON_GetObjectItem(recipe, "label"));
    cr_str_addf(out,
                "%s: reference vehicle %.0f kg, %.3f x %.3f x %.3f m, wheelbase %.3f, track %.3f,\n"
                "front overhang %.3f m, CG %.3f m behind the front axle, %.3f m high\n",
                label != NULL ? label : "", mass, d->length, d->width, d->height, d->wheelbase,
                d->track, d->front_overhang, d->cg_behind_front_axle, d->cg_height);
    add_faces(lib, type, out);
    cr_str_add(out, "\nstructures                     x from front, m    |y| m         z m         "
                    "weight along, across\n");
    cJSON_ArrayForEach(item, cJSON_GetObjectItem(recipe, "structures")) {
        static const char *const key[] = {"x_m", "y_m", "z_m"};
        const char *name = cJSON_GetStringValue(cJSON_GetObjectItem(item, "name"));
        cr_str_addf(out, "  %-28s", name != NULL ? name : "");
        for (int k = 0; k < 3; k++) {
            const cJSON *range = cJSON_GetObjectItem(item, key[k]);
            cr_str_addf(out, "%6.2f to %4.2f", cJSON_GetNumberValue(cJSON_GetArrayItem(range, 0)),
                        cJSON_GetNumberValue(cJSON_GetArrayItem(range, 1)));
        }
        cr_str_addf(out, "%9.2f %9.2f\n", number(item, "longitudinal"), number(item, "lateral"));
    }
    cr_str_add(out, "\nwhere it comes from\n");
    cJSON_ArrayForEach(item, cJSON_GetObjectItem(recipe, "provenance")) {
        const char *text = cJSON_GetStringValue(item);
        cr_str_addf(out, "  %s: %s\n", item->string, text != NULL ? text : "");
    }
    cr_str_addf(out, "  recipe: SHA-256 %s\n\n", cr_model_hash(lib, type));
    cr_model_list_text(papers, (int)type, 0, out);
}

void cr_model_provenance(const struct cr_model_papers *papers, const struct cr_model_lib *lib,
                         enum cr_type type, int clock, struct cr_str *out) {
    cJSON *o = cJSON_CreateObject();
    struct row r = row_of(papers, type, clock);
    cr_tree_text(o, "program", PACKAGE_STRING);
    cr_tree_text(o, "recipe_sha256", cr_model_hash(lib, type));
    put_basis(o, &r);
    if (!cr_json_add(o, false, out)) {
        cr_str_add(out, "{}");
    }
}
