/* What a scene must keep to beyond the ranges of its single values. */
#include "scene/scene_priv.h"

#include "base/show.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum cr_err cr_scene_id_check(struct cr_reader *r, const char *id) {
    size_t n = strlen(id);
    if (n == 0 || n >= CR_NAME_MAX || cr_utf8_chars(id) > CR_NAME_CHARS) {
        return cr_scene_fail(r, CR_ERR_RANGE, "an id has 1 to %d characters", CR_NAME_CHARS);
    }
    for (size_t i = 0; i < n; i++) {
        unsigned char c = (unsigned char)id[i];
        bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c >= 0x80;
        if (!letter && (c < '0' || c > '9') && c != '_' && c != '-') {
            cr_scene_fail(r, CR_ERR_RANGE, "id \"%.40s\" has a '%c' in it", id, c < 0x20 ? ' ' : c);
            cr_err_hint(r->err, "letters, digits, _ and - only");
            return CR_ERR_RANGE;
        }
    }
    /* the trace of a result has the times under this name beside the participants */
    if (strcmp(id, "t_s") == 0) {
        return cr_scene_fail(r, CR_ERR_RANGE, "id \"t_s\" is taken by the times of a result");
    }
    return CR_ERR_OK;
}

/* Fails at a key of the participant. */
static enum cr_err at_key(struct cr_reader *r, const char *key, const char *hint,
                          const char *text) {
    size_t up = strlen(r->path);
    char name[64];
    snprintf(name, sizeof name, "%s", key);
    char *rest = strchr(name, '.');
    if (rest != NULL) {
        *rest++ = '\0';
    }
    cr_scene_enter(r, name);
    if (rest != NULL) {
        cr_scene_enter(r, rest);
    }
    cr_scene_fail(r, CR_ERR_RANGE, "%s", text);
    cr_err_hint(r->err, "%s", hint);
    cr_scene_leave(r, up);
    return CR_ERR_RANGE;
}

/* one quantity must be less than another; NaN, what is not known, is never too much */
struct limit {
    double value, most;
    const char *key, *text, *most_text, *unit, *hint;
};

static enum cr_err check_limit(struct cr_reader *r, const struct limit *l) {
    if (!(l->value >= l->most)) {
        return CR_ERR_OK;
    }
    char text[160];
    snprintf(text, sizeof text, "%s of %.6g %s is not below %s of %.6g %s", l->text, l->value,
             l->unit, l->most_text, l->most, l->unit);
    return at_key(r, l->key, l->hint, text);
}

/* mass = kerb mass + load, whichever were given */
static enum cr_err check_masses(struct cr_reader *r, const struct cr_participant *p) {
    char text[160];
    if (isnan(p->mass) || isnan(p->load)) {
        return CR_ERR_OK;
    }
    if (!isnan(p->kerb_mass) && p->load > 0 && fabs(p->kerb_mass + p->load - p->mass) > 0.5) {
        snprintf(text, sizeof text, "a load of %.6g kg on %.6g kg gives no mass of %.6g kg",
                 p->load, p->kerb_mass, p->mass);
        return at_key(r, "load_kg", "two of mass, kerb mass and load say it all", text);
    }
    if (p->load > 0.9 * p->mass) {
        snprintf(text, sizeof text, "a load of %.6g kg leaves nothing of a mass of %.6g kg",
                 p->load, p->mass);
        return at_key(r, "load_kg", "mass_kg is kerb mass and load together", text);
    }
    return CR_ERR_OK;
}

/* the direction of force is told by one of its keys */
static enum cr_err check_pdof(struct cr_reader *r, const struct cr_participant *p) {
    int n, told = 0;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    for (int i = 0; i < n; i++) {
        told += row[i].type == CR_KEY_PDOF && (p->given >> i & 1) != 0;
    }
    return told < 2 ? CR_ERR_OK
                    : at_key(r, "model", "keep one of pdof, pdof_clock and pdof_deg",
                             "a model has one direction of force");
}

static enum cr_err check_vehicle(struct cr_reader *r, const struct cr_participant *p) {
    /* the radius of gyration is below half the length even with all mass at both ends */
    const struct limit limits[] = {
        {p->wheelbase, p->length, "wheelbase_m", "wheelbase", "the length", "m",
         "both axles lie within the length"},
        {p->front_overhang + p->wheelbase, p->length, "front_overhang_m",
         "front overhang and wheelbase", "the length", "m",
         "the length is the wheelbase and both overhangs"},
        {p->cg_behind_front_axle, p->wheelbase, "cg.behind_front_axle_m",
         "centre of gravity behind the front axle", "the wheelbase", "m",
         "the centre of gravity lies between the axles"},
        {p->track, p->width, "track_m", "track", "the width", "m",
         "the wheels lie within the width"},
        {p->cg_height, p->height, "cg.height_m", "height of the centre of gravity", "the height",
         "m", "the centre of gravity lies below the roof"},
        {p->yaw_inertia, p->mass * p->length * p->length / 4, "yaw_inertia_kgm2", "yaw inertia",
         "the utmost", "kgm2", "0.137 mass length wheelbase is usual"},
    };
    for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        enum cr_err code = check_limit(r, &limits[i]);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    enum cr_err masses = check_masses(r, p);
    if (masses != CR_ERR_OK) {
        return masses;
    }
    enum cr_err pdof = check_pdof(r, p);
    if (pdof != CR_ERR_OK) {
        return pdof;
    }
    const struct cr_model_choice *m = &p->model;
    static const char *const faces[] = {"front", "side", "rear"};
    bool stiff = false;
    for (int i = 0; i < 3; i++) {
        stiff = stiff || m->face[i].a != 0 || m->face[i].b != 0;
        if (m->face[i].a > 0 && !(m->face[i].b > 0)) {
            char key[40];
            snprintf(key, sizeof key, "model.stiffness.%s", faces[i]);
            return at_key(r, "model", "a face needs A_N_per_m and B_N_per_m2",
                          "a stiffness without its B");
        }
    }
    if (stiff && m->file[0] != '\0') {
        return at_key(r, "model", "keep one of the two",
                      "a model is from a file or from stiffness");
    }
    return CR_ERR_OK;
}

static enum cr_err check_object(struct cr_reader *r, const struct cr_participant *p) {
    double half = fmin(p->length, p->width) / 2;
    if (p->shape == CR_OBJECT_BOX && p->edge_radius > half) {
        char text[96];
        snprintf(text, sizeof text, "edge radius of %.4g is more than half the box, %.4g",
                 p->edge_radius, half);
        return at_key(r, "edge_radius_m", "a box rounded all over is a pole", text);
    }
    if (isnan(p->mass) && p->shape != CR_OBJECT_BARRIER) {
        const char *hint = "give it mass_kg if it shall move";
        if (p->speed != 0) {
            return at_key(r, "speed_kmh", hint, "an object without mass is fixed and has no speed");
        }
        if (p->yaw_rate != 0) {
            return at_key(r, "yaw_rate_deg_s", hint, "an object without mass is fixed");
        }
        if (p->waypoints > 0) {
            return at_key(r, "trajectory", hint, "an object without mass is fixed");
        }
    }
    return CR_ERR_OK;
}

/* keys that say the same as a trajectory */
static enum cr_err check_trajectory(struct cr_reader *r, const struct cr_participant *p) {
    static const char *const rivals[] = {"position_m", "heading_deg", "course_deg", "speed_kmh",
                                         "yaw_rate_deg_s"};
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    for (size_t i = 0; i < sizeof rivals / sizeof rivals[0] && p->waypoints > 0; i++) {
        const struct cr_key *key =
            cr_scene_key_find(CR_KEYS_PARTICIPANT, rivals[i], cr_scene_kind_mask(p));
        if ((p->given >> (key - row) & 1) != 0) {
            char text[80];
            snprintf(text, sizeof text, "%s cannot stand beside a trajectory", rivals[i]);
            return at_key(r, rivals[i], "the rows of the trajectory say it already", text);
        }
    }
    return CR_ERR_OK;
}

/* how it stands against another, but not against whom; or both that and a trajectory */
static enum cr_err check_place(struct cr_reader *r, const struct cr_participant *p) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    for (int i = 0; i < n && p->place.against[0] == '\0'; i++) {
        if (strncmp(row[i].name, "place.", 6) == 0 && (p->given >> i & 1) != 0) {
            return at_key(r, "place", "\"against\" names the participant that stays",
                          "a place without the other one that it is against");
        }
    }
    if (p->place.against[0] != '\0' && p->waypoints > 0) {
        return at_key(r, "place", "keep one of the two",
                      "a place cannot stand beside a trajectory");
    }
    return CR_ERR_OK;
}

enum cr_err cr_scene_part_check(struct cr_reader *r, const struct cr_participant *p) {
    enum cr_err code = check_trajectory(r, p);
    if (code == CR_ERR_OK) {
        code = check_place(r, p);
    }
    if (code == CR_ERR_OK) {
        code = p->kind == CR_KIND_VEHICLE ? check_vehicle(r, p) : check_object(r, p);
    }
    return code;
}

static void hint_missing(struct cr_reader *r, const struct cr_key *key) {
    char list[160] = "";
    const char *unit = key->unit != NULL ? key->unit : "";
    for (size_t i = 0; key->type == CR_KEY_WORD && i < key->aux; i++) {
        size_t n = strlen(list);
        snprintf(list + n, sizeof list - n, "%s%s", i > 0 ? ", " : "", key->words[i]);
    }
    if (key->type == CR_KEY_WORD) {
        cr_err_hint(r->err, "one of: %s", list);
    } else if (key->type == CR_KEY_PAIR) {
        cr_err_hint(r->err, "[x, y] in m, or give a \"trajectory\"");
    } else {
        cr_err_hint(r->err, "%s%s%s", key->help, unit[0] != '\0' ? ", in " : "", unit);
    }
}

enum cr_err cr_scene_part_complete(struct cr_reader *r, const struct cr_participant *p) {
    unsigned mask = cr_scene_kind_mask(p);
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    for (int i = 0; i < n; i++) {
        const struct cr_key *key = &row[i];
        bool placed = key->type == CR_KEY_PAIR;
        bool there = placed ? (p->given >> i & 1) != 0 || p->waypoints > 0 || r->draft ||
                                  p->place.against[0] != '\0'
                            : cr_scene_value_known(key, p);
        if ((key->required & mask) == 0 || there) {
            continue;
        }
        cr_scene_fail(r, CR_ERR_MISSING, "%s \"%s\" has no \"%s\"", cr_scene_kind_word(mask) + 2,
                      p->id, key->name);
        hint_missing(r, key);
        return CR_ERR_MISSING;
    }
    return CR_ERR_OK;
}

enum cr_err cr_scene_whole_check(struct cr_reader *r, const struct cr_scene *scene) {
    size_t up = cr_scene_enter(r, "participants");
    if (scene->n < 2 && !r->draft) {
        cr_scene_fail(r, CR_ERR_MISSING, "a crash needs at least two participants, got %d",
                      scene->n);
        cr_err_hint(r->err, "add a vehicle or an object");
        return CR_ERR_MISSING;
    }
    for (int i = 1; i < scene->n; i++) {
        for (int k = 0; k < i; k++) {
            if (strcmp(scene->part[i].id, scene->part[k].id) == 0) {
                char token[12];
                snprintf(token, sizeof token, "%d", i);
                cr_scene_enter(r, token);
                cr_scene_enter(r, "id");
                cr_scene_fail(r, CR_ERR_DUPLICATE, "id \"%s\" is taken by participant %d",
                              scene->part[i].id, k + 1);
                cr_err_hint(r->err, "each participant needs its own id");
                return CR_ERR_DUPLICATE;
            }
        }
    }
    cr_scene_leave(r, up);
    return CR_ERR_OK;
}
