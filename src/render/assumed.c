/* Tells what was assumed of a scene, in words: "A: track 1.65 m, yaw inertia 5140 kg m2". */
#include "render/table.h"

#include <stddef.h>
#include <string.h>

#define AT(field) offsetof(struct cr_participant, field)

static const struct {
    const char *key, *word, *unit;
    size_t at;
    int decimals;
} value_rows[] = {
    {"built", "built", "", AT(built), 0},
    {"mass_kg", "mass", "kg", AT(mass), 0},
    {"kerb_mass_kg", "kerb mass", "kg", AT(kerb_mass), 0},
    {"load_kg", "load", "kg", AT(load), 0},
    {"length_m", "length", "m", AT(length), 2},
    {"width_m", "width", "m", AT(width), 2},
    {"height_m", "height", "m", AT(height), 2},
    {"wheelbase_m", "wheelbase", "m", AT(wheelbase), 2},
    {"track_m", "track", "m", AT(track), 2},
    {"front_overhang_m", "front overhang", "m", AT(front_overhang), 2},
    {"cg.behind_front_axle_m", "CG behind the front axle", "m", AT(cg_behind_front_axle), 2},
    {"cg.height_m", "CG height", "m", AT(cg_height), 2},
    {"yaw_inertia_kgm2", "yaw inertia", "kg m2", AT(yaw_inertia), 0},
    {"radius_m", "radius", "m", AT(radius), 2},
};

/* Adds one assumed key of a participant with its value; keys that are not numbers stand alone. */
static void add_value(const struct cr_participant *part, const char *key, struct cr_str *out) {
    for (size_t i = 0; i < sizeof value_rows / sizeof value_rows[0]; i++) {
        if (strcmp(value_rows[i].key, key) == 0) {
            double x;
            memcpy(&x, (const char *)part + value_rows[i].at, sizeof x);
            /* No-break spaces keep number and unit together. */
            const char *unit = value_rows[i].unit;
            cr_str_addf(out, "%s\u00a0%.*f%s%s", value_rows[i].word, value_rows[i].decimals, x,
                        unit[0] != '\0' ? "\u00a0" : "", unit);
            return;
        }
    }
    cr_str_add(out, key);
}

void cr_render_assumed(const struct cr_result *result, struct cr_str *out) {
    const struct cr_assumed *a = &result->assumed;
    const char *others = "";
    for (int b = 0; b < result->resolved.n; b++) {
        const struct cr_participant *part = &result->resolved.part[b];
        size_t n = strlen(part->id);
        bool any = false;
        const char *from = NULL;
        for (int i = 0; i < a->n; i++) {
            if (strncmp(a->key[i], part->id, n) != 0 || a->key[i][n] != '.') {
                continue;
            }
            cr_str_addf(out, any ? ", " : "%s: ", part->id);
            add_value(part, a->key[i] + n + 1, out);
            cr_str_add(out, a->from[i][0] != '\0' ? "*" : "");
            from = a->from[i][0] != '\0' ? a->from[i] : from;
            any = true;
        }
        if (from != NULL) {
            cr_str_addf(out, "; * from %s", from);
        }
        cr_str_add(out, any ? "\n" : "");
    }
    for (int i = 0; i < a->n; i++) {
        bool known = false;
        for (int b = 0; b < result->resolved.n && !known; b++) {
            size_t n = strlen(result->resolved.part[b].id);
            known = strncmp(a->key[i], result->resolved.part[b].id, n) == 0 && a->key[i][n] == '.';
        }
        if (!known) {
            cr_str_addf(out, "%s%s", others, a->key[i]);
            others = ", ";
        }
    }
    if (others[0] != '\0') {
        cr_str_add(out, "\n");
    }
}
