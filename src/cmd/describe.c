/* How participants are told to the user: one in a line, the place of an error by its name; and a
 * scene resolved to be looked at. */
#include "cmd/cmd_priv.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void cr_cmd_describe(const struct cr_participant *p, char *buf, int size) {
    char what[CR_NAME_MAX + 160], mass[40] = "fixed";
    bool vehicle = p->kind == CR_KIND_VEHICLE;
    double kg = !vehicle || isfinite(p->mass) ? p->mass : p->kerb_mass + fmax(p->load, 0);
    if (isfinite(kg)) {
        snprintf(mass, sizeof mass, "%.10g kg", kg);
    } else if (vehicle) {
        snprintf(mass, sizeof mass, "%s", p->car[0] != '\0' ? "" : "of unknown mass");
    }
    if (vehicle) {
        snprintf(what, sizeof what, "%s%s%s %s", p->car,
                 p->car[0] != '\0' && p->type < CR_TYPES ? ", " : "",
                 p->type < CR_TYPES  ? cr_type_word(p->type)
                 : p->car[0] == '\0' ? "auto"
                                     : "",
                 mass);
    } else if (p->shape == CR_OBJECT_POLE) {
        snprintf(what, sizeof what, "%s pole %.10g m thick", mass, 2 * p->radius);
    } else if (p->shape == CR_OBJECT_BOX) {
        snprintf(what, sizeof what, "%s box %.10g m x %.10g m", mass, p->length, p->width);
    } else if (p->shape == CR_OBJECT_BARRIER) {
        snprintf(what, sizeof what, "barrier %s%s%s", p->barrier, isfinite(kg) ? ", " : "",
                 isfinite(kg) ? mass : "");
    } else {
        snprintf(what, sizeof what, "%s %s", mass, p->shape == CR_OBJECT_WALL ? "wall" : "polygon");
    }
    snprintf(buf, (size_t)size, "%s: %s  x=%.2f m y=%.2f m heading=%.1f deg  %.1f km/h", p->id,
             what, p->pos.x + 0.0, p->pos.y + 0.0, cr_deg(p->heading), cr_kmh(p->speed));
}

enum cr_err cr_cmd_resolve(struct cr_scene *scene, const struct cr_model_lib *models,
                           struct cr_assumed *assumed, struct cr_error *err) {
    struct cr_participant *other = NULL;
    enum cr_err code = CR_ERR_OK;
    if (scene->n == 1) { /* alone it is no whole scene, but it can be looked at */
        const char *id = strcmp(scene->part[0].id, "other") == 0 ? "another" : "other";
        code = cr_scene_add(scene, id, CR_KIND_OBJECT, &other, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_scene_resolve(scene, models, assumed, err);
    }
    if (other != NULL) {
        scene->n--;
    }
    return code;
}

/* "/participants/1/mass_kg" -> "B.mass_kg", as it is called here */
void cr_cmd_name_place(const struct cr_scene *scene, struct cr_error *err) {
    int i, n = 0;
    char rest[sizeof err->where];
    if (err->src[0] != '\0' || sscanf(err->where, "/participants/%d%n", &i, &n) != 1 || i < 0 ||
        i >= scene->n) {
        return;
    }
    snprintf(rest, sizeof rest, "%s", err->where + n);
    for (char *p = rest; *p != '\0'; p++) {
        *p = *p == '/' ? '.' : *p;
    }
    snprintf(err->where, sizeof err->where, "%.60s%.60s", scene->part[i].id, rest);
}
