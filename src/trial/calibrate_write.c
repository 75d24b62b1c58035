/* Puts calibrated faces into the text of a recipe, which otherwise stays as its author wrote it. */
#include "trial/calibrate.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* End of the object that begins at p, behind its closing brace; NULL if there is none. */
static const char *object_end(const char *p) {
    int depth = 0;
    for (; *p != '\0'; p++) {
        if (*p == '"') {
            for (p++; *p != '\0' && *p != '"'; p++) {
                p += *p == '\\' && p[1] != '\0';
            }
            if (*p == '\0') {
                return NULL;
            }
        }
        depth += (*p == '{') - (*p == '}');
        if (depth == 0) {
            return p + 1;
        }
    }
    return NULL;
}

static void add_unless_0(struct cr_str *out, const char *key, double value) {
    if (value > 0) {
        cr_str_addf(out, ",\n      \"%s\": %.3g", key, value);
    }
}

static void add_face(const struct cr_model_face *f, const char *name, struct cr_str *out) {
    cr_str_addf(out, "    \"%s\": {\n      \"between\": \"%s\",\n      \"depth_m_ees_kmh\": [",
                name, f->energy_linear ? "energy" : "ees");
    for (int i = 0; i < f->ees.n; i++) {
        cr_str_addf(out, "%s[%.4g, %.6g]", i > 0 ? ", " : "", f->ees.x[i], cr_kmh(f->ees.y[i]));
    }
    cr_str_add(out, "],\n");
    if (f->compartment > 0) {
        cr_str_addf(out, "      \"compartment_N\": %.7g,\n", f->compartment);
    }
    cr_str_addf(out, "      \"springback_m\": %.3g,\n      \"residual_spread_m\": %.3g",
                f->springback, f->spread);
    add_unless_0(out, "drag_slope", f->drag_slope);
    add_unless_0(out, "drag_bend_per_m", f->drag_bend);
    add_unless_0(out, "block_m", f->block);
    for (int i = 0; i < f->built.n; i++) {
        cr_str_addf(out, "%s[%.5g, %.4g]%s", i == 0 ? ",\n      \"built_strength\": [" : ", ",
                    f->built.x[i], f->built.y[i], i + 1 == f->built.n ? "]" : "");
    }
    cr_str_add(out, "\n    }");
}

static void add_number(struct cr_str *out, const char *key, double x) {
    if (isfinite(x)) {
        cr_str_addf(out, ", \"%s\": %.1f", key, x);
    }
}

static void add_fit(const struct cr_calibration_fit *f, const char *name, const char *source,
                    struct cr_str *out) {
    cr_str_addf(out, "    \"%s\": { \"basis\": \"calibrated\", \"tests\": %d, \"borrowed\": %d",
                name, f->tests, f->borrowed);
    add_number(out, "depth_mpe_percent", f->depth_mpe);
    add_number(out, "depth_sd_percent", f->depth_sd);
    if (f->dynamic_tests > 0) {
        cr_str_addf(out, ", \"dynamic_tests\": %d", f->dynamic_tests);
        add_number(out, "dynamic_mpe_percent", f->dynamic_mpe);
        add_number(out, "dynamic_sd_percent", f->dynamic_sd);
    }
    cr_str_addf(out, ",\n      \"source\": \"%s\" }", source);
}

static void add_faces(const struct cr_model_face face[CR_MODEL_ENDS], struct cr_str *out) {
    static const char *const name[] = {"front", "side", "rear"};
    cr_str_add(out, "{\n");
    for (int i = 0; i < CR_MODEL_ENDS; i++) {
        add_face(&face[i], name[i], out);
        cr_str_add(out, i + 1 < CR_MODEL_ENDS ? ",\n" : "\n  }");
    }
}

static void add_calibration(const struct cr_calibration_fit fit[2], struct cr_str *out) {
    cr_str_add(out, "{\n");
    add_fit(&fit[0], "front", "frontal_wall.csv, frontal_wall_pulse.csv (NHTSA)", out);
    cr_str_add(out, ",\n");
    char side[96];
    snprintf(side, sizeof side, "side_pole.csv (NHTSA); damaged area %.3f m2 [POLE-AREA]",
             cr_test_pole_area);
    add_fit(&fit[1], "side", side, out);
    cr_str_add(out, ",\n    \"rear\": { \"basis\": \"assumption\", \"tests\": 0, \"borrowed\": 0,\n"
                    "      \"source\": \"one curve for all types, chosen with 81 cars struck from "
                    "behind in view (NHTSA CISS, recorders; FMVSS 301)\" }\n  }");
}

enum cr_err cr_calibration_write(const char *recipe, const struct cr_model_face face[CR_MODEL_ENDS],
                                 const struct cr_calibration_fit fit[2], struct cr_str *out,
                                 struct cr_error *err) {
    static const char *const key[] = {"\"faces\": {", "\"calibration\": {"};
    const char *p = recipe;
    for (int i = 0; i < 2; i++) {
        const char *at = strstr(p, key[i]);
        const char *end = at != NULL ? object_end(at + strlen(key[i]) - 1) : NULL;
        if (end == NULL) {
            return cr_err_set(err, CR_ERR_MODEL, "recipe has no %.*s", (int)strlen(key[i]) - 3,
                              key[i]);
        }
        cr_str_addn(out, p, (size_t)(at + strlen(key[i]) - 1 - p));
        if (i == 0) {
            add_faces(face, out);
        } else {
            add_calibration(fit, out);
        }
        p = end;
    }
    cr_str_add(out, p);
    return out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for a recipe") : CR_ERR_OK;
}
