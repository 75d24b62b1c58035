/* Commands that edit the scene: vehicle, object, list, remove, copy, new. */
#include "cmd/cmd_priv.h"

#include "catalogue/catalogue.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- keys of the scene by argument ---- */

/* ---- telling about participants ---- */

static void say_participant(struct cr_session *s, const struct cr_participant *p) {
    char line[300];
    cr_cmd_describe(p, line, sizeof line);
    cr_say(s, "%s", line);
}

/* every key with its value; what was not given as the solver will assume it */
static enum cr_err say_keys(struct cr_call *call, const char *id, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct cr_scene *scene = &cr_session_now(s)->scene, resolved;
    struct cr_assumed assumed = {0};
    struct cr_error ignored;
    enum cr_err code = cr_scene_copy(scene, &resolved, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    bool known = cr_session_need_models(s, &ignored) == CR_ERR_OK &&
                 cr_cmd_resolve(&resolved, s->models, &assumed, &ignored) == CR_ERR_OK;
    for (int i = 0; call->cmd->arg[i].name != NULL && code == CR_ERR_OK; i++) {
        const struct cr_arg *arg = &call->cmd->arg[i];
        const struct cr_key *key = cr_arg_key(arg);
        struct cr_str given = {0}, value = {0};
        char full[CR_NAME_MAX + 64];
        if (key == NULL || strcmp(arg->name, "v") == 0) {
            continue;
        }
        snprintf(full, sizeof full, "%s.%s", id, key->name);
        code = cr_scene_get(scene, full, &given, err);
        if (code == CR_ERR_KEY) { /* a key of other kinds of objects */
            code = CR_ERR_OK;
        } else if (code == CR_ERR_OK) {
            bool assumes = strcmp(cr_str_get(&given), "auto") == 0;
            if (assumes && known) {
                code = cr_scene_get(&resolved, full, &value, err);
            }
            const char *text = cr_str_get(assumes && known ? &value : &given);
            double x = strtod(text, NULL);
            s->lost = s->lost || given.failed || value.failed;
            if (key->type == CR_KEY_NUMBER && strcmp(text, "auto") != 0 && !cr_tolerance_is(text)) {
                cr_say(s, "%-10s %.5g %s%s", arg->name, x, key->unit, assumes ? "  (assumed)" : "");
            } else {
                bool bare = assumes || key->unit == NULL || key->unit[0] == '\0';
                cr_say(s, "%-10s %s%s%s", arg->name, cr_str_get(&given), bare ? "" : " ",
                       bare ? "" : key->unit);
            }
        }
        cr_str_fini(&given);
        cr_str_fini(&value);
    }
    cr_assumed_fini(&assumed);
    cr_scene_fini(&resolved);
    return code;
}

enum cr_err cr_cmd_list(struct cr_call *call, struct cr_error *err) {
    const struct cr_scene *scene = cr_session_scene(call->s);
    (void)err;
    if (scene->n == 0) {
        cr_say(call->s, "the scene is empty; begin with: vehicle A type=compact");
    }
    for (int i = 0; i < scene->n; i++) {
        say_participant(call->s, &scene->part[i]);
    }
    return CR_ERR_OK;
}

/* ---- vehicle, object ---- */

static enum cr_err forget(struct cr_call *call, const char *id, struct cr_error *err) {
    struct cr_state *draft;
    enum cr_err code = cr_cmd_edit(call, &draft, err);
    if (code == CR_ERR_OK) {
        code = cr_scene_remove(&draft->scene, id, err);
    }
    if (code != CR_ERR_OK) {
        return cr_cmd_blame(call, "NAME", code);
    }
    cr_say(call->s, "%s removed", id);
    return CR_ERR_OK;
}

enum cr_err cr_cmd_remove(struct cr_call *call, struct cr_error *err) {
    return forget(call, cr_cmd_text(call, "NAME", ""), err);
}

/* a free place east of all others, so that nothing overlaps before it is placed */
static void park(const struct cr_scene *scene, struct cr_participant *p) {
    double x = 0;
    for (int i = 0; i < scene->n; i++) {
        if (&scene->part[i] != p) {
            x = fmax(x, scene->part[i].pos.x + 10);
        }
    }
    cr_scene_unplace(p);
    p->pos = cr_vec2(x, 0);
}

/* the participant to change: a known one of the right kind, or a new one */
static enum cr_err find_or_add(struct cr_call *call, enum cr_kind kind, struct cr_state **draft,
                               struct cr_participant **out, bool *is_new, struct cr_error *err) {
    const char *id = cr_cmd_text(call, "NAME", "");
    enum cr_err code = cr_cmd_edit(call, draft, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    *out = cr_scene_find(&(*draft)->scene, id);
    *is_new = *out == NULL;
    if (*is_new) {
        code = cr_scene_add(&(*draft)->scene, id, kind, out, err);
        if (code == CR_ERR_OK) {
            park(&(*draft)->scene, *out);
        }
        return code == CR_ERR_OK ? code : cr_cmd_blame(call, "NAME", code);
    }
    if ((*out)->kind != kind) {
        code = cr_err_set(err, CR_ERR_DUPLICATE, "%s is %s", id,
                          (*out)->kind == CR_KIND_VEHICLE ? "a vehicle" : "an object");
        cr_err_hint(err, "take another name, or remove %.40s first", id);
        return cr_cmd_blame(call, "NAME", code);
    }
    return CR_ERR_OK;
}

/* What the catalogue says of the car that was named, before anything is changed by it. */
static enum cr_err say_car(struct cr_call *call, const struct cr_participant *p,
                           struct cr_error *err) {
    const struct cr_car *car;
    struct cr_str line = {0};
    enum cr_err code = cr_session_car(call->s, p->car, &car, err);
    if (code != CR_ERR_OK) {
        return cr_cmd_blame(call, "car", code);
    }
    cr_car_name(car, &line);
    cr_str_addf(&line, ": %.0f kg kerb + %.0f driver, %.3f x %.3f m (%s)", car->curb, CR_CAR_DRIVER,
                car->length, car->width, car->source);
    cr_say_str(call->s, &line);
    cr_str_fini(&line);
    return CR_ERR_OK;
}

/* A vehicle needs a type, unless a car of the catalogue or its size says it; its mass is that of
 * the type's reference car unless it is given. */
static enum cr_err complete_vehicle(struct cr_call *call, struct cr_scene *scene,
                                    struct cr_participant *p, bool is_new, struct cr_error *err) {
    (void)is_new;
    char value[40], full[CR_NAME_MAX + 16];
    double mass;
    if (p->car[0] != '\0') {
        return cr_cmd_given(call, "car") ? say_car(call, p, err) : CR_ERR_OK;
    }
    if (p->type >= CR_TYPES && cr_cmd_given(call, "type")) {
        return CR_ERR_OK;
    }
    if (p->type >= CR_TYPES) {
        cr_err_set(err, CR_ERR_MISSING, "vehicle %s needs a type", p->id);
        cr_err_hint(err, "type=sedan or another (model list), type=auto or car=\"golf 2015\"");
        return cr_cmd_blame(call, "NAME", CR_ERR_MISSING);
    }
    if (isfinite(p->mass) || isfinite(p->kerb_mass) || isfinite(p->load)) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_session_need_models(call->s, err);
    code = code == CR_ERR_OK ? cr_model_need(call->s->models, p->type, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_model_dims(call->s->models, p->type, &mass);
    snprintf(value, sizeof value, "%.17g", mass);
    snprintf(full, sizeof full, "%s.mass_kg", p->id);
    cr_say(call->s, "mass %.10g kg, that of the reference %s", mass, cr_type_word(p->type));
    return cr_scene_set(scene, full, value, err);
}

/* what an object's arguments say that is not a key of the scene file */
static enum cr_err object_extras(struct cr_call *call, struct cr_scene *scene,
                                 struct cr_participant *p, bool is_new, struct cr_error *err) {
    const struct cr_value *mass = cr_cmd_arg(call, "mass");
    char value[80];
    enum cr_err code = CR_ERR_OK;
    if (cr_cmd_given(call, "diameter") && p->shape != CR_OBJECT_POLE) {
        code = cr_err_set(err, CR_ERR_KEY, "diameter is for poles");
        return cr_cmd_blame(call, "diameter", code);
    }
    if (cr_cmd_given(call, "diameter") || (is_new && p->shape == CR_OBJECT_POLE)) {
        snprintf(value, sizeof value, "%.17g", cr_cmd_number(call, "diameter", 0.254) / 2);
        code = cr_cmd_set_text(scene, p->id, "radius_m", value, err);
        if (code != CR_ERR_OK) {
            return cr_cmd_blame(call, "diameter", code);
        }
    }
    if (cr_cmd_given(call, "low") || cr_cmd_given(call, "high")) {
        double lo = isfinite(p->z_lo) ? p->z_lo : 0, hi = isfinite(p->z_hi) ? p->z_hi : 3;
        snprintf(value, sizeof value, "%.17g,%.17g", cr_cmd_number(call, "low", lo),
                 cr_cmd_number(call, "high", hi));
        code = cr_cmd_set_text(scene, p->id, "height_m", value, err);
        if (code != CR_ERR_OK) {
            return cr_cmd_blame(call, cr_cmd_given(call, "low") ? "low" : "high", code);
        }
    }
    if (mass->token != NULL) {
        snprintf(value, sizeof value, "%.17g", mass->number);
        code = cr_cmd_set_text(scene, p->id, "mass_kg", mass->word == 0 ? "auto" : value, err);
    }
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "mass", code);
}

static enum cr_err check_barrier(struct cr_call *call, const struct cr_participant *p,
                                 struct cr_error *err) {
    const struct cr_barrier *b;
    enum cr_err code = cr_session_need_models(call->s, err);
    if (code == CR_ERR_OK) {
        code = cr_model_barrier(call->s->models, p->barrier, &b, err);
    }
    return cr_cmd_given(call, "barrier") ? cr_cmd_blame(call, "barrier", code)
                                         : cr_cmd_blame(call, "kind", code);
}

static enum cr_err check_object(struct cr_call *call, const struct cr_participant *p, bool is_new,
                                struct cr_error *err) {
    if (is_new && !cr_cmd_given(call, "kind") && !cr_cmd_given(call, "barrier")) {
        cr_err_set(err, CR_ERR_MISSING, "object %s needs a kind", p->id);
        cr_err_hint(err, "kind=wall, pole, box, or barrier=odb");
        return cr_cmd_blame(call, "NAME", CR_ERR_MISSING);
    }
    if (p->shape == CR_OBJECT_BARRIER) {
        return check_barrier(call, p, err);
    }
    if (p->shape == CR_OBJECT_BOX && !(isfinite(p->length) && isfinite(p->width))) {
        cr_err_set(err, CR_ERR_MISSING, "a box needs length and width");
        cr_err_hint(err, "for example length=1m width=2m");
        return cr_cmd_blame(call, "NAME", CR_ERR_MISSING);
    }
    if (p->shape == CR_OBJECT_POLYGON && p->vertices == 0) {
        cr_err_set(err, CR_ERR_MISSING, "the corners of a polygon are given in a scene file");
        cr_err_hint(err, "\"vertices_m\": [[0, 0], [1, 0], [0, 1]]");
        return cr_cmd_blame(call, "kind", CR_ERR_MISSING);
    }
    return CR_ERR_OK;
}

static enum cr_err complete_object(struct cr_call *call, struct cr_scene *scene,
                                   struct cr_participant *p, bool is_new, struct cr_error *err) {
    enum cr_err code = object_extras(call, scene, p, is_new, err);
    return code == CR_ERR_OK ? check_object(call, p, is_new, err) : code;
}

/* One participant made, changed, shown or removed. complete adds what its kind needs beside the
 * keys of the scene file, and checks it. */
static enum cr_err edit(struct cr_call *call, enum cr_kind kind,
                        enum cr_err (*complete)(struct cr_call *, struct cr_scene *,
                                                struct cr_participant *, bool, struct cr_error *),
                        struct cr_error *err) {
    const char *id = cr_cmd_text(call, "NAME", "");
    struct cr_participant *p = cr_scene_find(&cr_session_now(call->s)->scene, id);
    struct cr_state *draft;
    bool is_new;
    if (cr_cmd_given(call, "remove")) {
        return forget(call, id, err);
    }
    if (p != NULL && p->kind == kind && cr_cmd_keys_given(call) == 0) {
        say_participant(call->s, p);
        return say_keys(call, id, err);
    }
    enum cr_err code = find_or_add(call, kind, &draft, &p, &is_new, err);
    if (code == CR_ERR_OK && kind == CR_KIND_OBJECT && cr_cmd_given(call, "barrier")) {
        code = cr_cmd_set_text(&draft->scene, id, "shape", "barrier", err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cmd_set_keys(call, &draft->scene, id, err);
    }
    if (code == CR_ERR_OK) {
        code = complete(call, &draft->scene, p, is_new, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    say_participant(call->s, p);
    return CR_ERR_OK;
}

enum cr_err cr_cmd_vehicle(struct cr_call *call, struct cr_error *err) {
    return edit(call, CR_KIND_VEHICLE, complete_vehicle, err);
}

enum cr_err cr_cmd_object(struct cr_call *call, struct cr_error *err) {
    return edit(call, CR_KIND_OBJECT, complete_object, err);
}

static enum cr_err copy_into(struct cr_participant *to, const struct cr_participant *from,
                             const char *id, struct cr_error *err) {
    struct cr_waypoint *waypoint = NULL;
    char *extra = from->extra != NULL ? strdup(from->extra) : NULL;
    size_t size = (size_t)from->waypoints * sizeof *waypoint;
    if (size > 0) {
        waypoint = malloc(size);
        if (waypoint != NULL) {
            memcpy(waypoint, from->waypoint, size);
        }
    }
    if ((size > 0 && waypoint == NULL) || (from->extra != NULL && extra == NULL)) {
        free(waypoint);
        free(extra);
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    *to = *from;
    snprintf(to->id, sizeof to->id, "%s", id);
    to->waypoint = waypoint;
    to->extra = extra;
    return CR_ERR_OK;
}

enum cr_err cr_cmd_copy(struct cr_call *call, struct cr_error *err) {
    const char *id = cr_cmd_text(call, "NEW", "");
    struct cr_participant *to;
    struct cr_state *draft;
    enum cr_err code = cr_cmd_edit(call, &draft, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_scene_add(&draft->scene, id, CR_KIND_VEHICLE, &to, err);
    if (code != CR_ERR_OK) {
        return cr_cmd_blame(call, "NEW", code);
    }
    code = copy_into(to, cr_scene_find(&draft->scene, cr_cmd_text(call, "NAME", "")), id, err);
    if (code == CR_ERR_OK) {
        park(&draft->scene, to);
        say_participant(call->s, to);
    }
    return code;
}

enum cr_err cr_cmd_new(struct cr_call *call, struct cr_error *err) {
    const char *name = cr_cmd_text(call, "NAME", "");
    struct cr_state *draft;
    enum cr_err code = cr_cmd_edit(call, &draft, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    bool old = draft->scene.n > 0;
    cr_scene_fini(&draft->scene);
    draft->file[0] = '\0';
    if (name[0] != '\0') {
        code = cr_scene_set(&draft->scene, "name", name, err);
        if (code != CR_ERR_OK) {
            return cr_cmd_blame(call, "NAME", code);
        }
    }
    call->fresh = true;
    cr_say(call->s, "an empty scene%s", old ? "; undo brings the old one back" : "");
    return CR_ERR_OK;
}
