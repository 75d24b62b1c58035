/* model: which EES model a vehicle has, and where the models come from. */
#include "cmd/cmd_priv.h"

#include <stdio.h>
#include <string.h>

static enum cr_err say_type(struct cr_session *s, enum cr_type type, struct cr_error *err) {
    double mass;
    enum cr_err code = cr_model_need(s->models, type, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_dims *d = cr_model_dims(s->models, type, &mass);
    cr_say(s, "%-14s %s/1 to %s/12: length %.2f width %.2f wheelbase %.2f m, %.0f kg",
           cr_type_word(type), cr_type_word(type), cr_type_word(type), d->length, d->width,
           d->wheelbase, mass);
    return CR_ERR_OK;
}

/* "suv", "suv/12", "ees/suv/12" */
static enum cr_err read_model(const char *text, struct cr_model_name *out, struct cr_error *err) {
    return cr_model_name_read(text + (strncmp(text, "ees/", 4) == 0 ? 4 : 0), out, err);
}

static enum cr_err model_info(struct cr_call *call, struct cr_error *err) {
    const char *text = cr_cmd_text(call, "MODEL", NULL);
    struct cr_model_name model;
    enum cr_err code = cr_session_need_models(call->s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    bool all = cr_cmd_word(call, "NAME", -1) == 0;
    for (int i = 0; all && i < CR_TYPES && code == CR_ERR_OK; i++) {
        code = say_type(call->s, (enum cr_type)i, err);
    }
    if (all) {
        return code;
    }
    if (text == NULL) {
        cr_err_set(err, CR_ERR_MISSING, "which model?");
        cr_err_hint(err, "for example: model info suv/12");
        return CR_ERR_MISSING;
    }
    code = read_model(text, &model, err);
    code =
        code == CR_ERR_OK ? say_type(call->s, model.type, err) : cr_cmd_blame(call, "MODEL", code);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_say(call->s, "recipe models/%s.json", cr_type_word(model.type));
    cr_say(call->s, "sha256 %s", cr_model_hash(call->s->models, model.type));
    cr_say(call->s, "crumple models %s prints curves, structures, source tests and scatter",
           cr_type_word(model.type));
    return CR_ERR_OK;
}

static bool is_file(const char *text) {
    size_t n = strlen(text);
    return n > 4 &&
           (strcmp(text + n - 4, ".csv") == 0 || (n > 5 && strcmp(text + n - 5, ".json") == 0));
}

enum cr_err cr_model_take(struct cr_scene *scene, const char *id, const char *text,
                          struct cr_error *err) {
    struct cr_model_name model;
    char value[16];
    if (is_file(text)) {
        return cr_cmd_set_text(scene, id, "model.file", text, err);
    }
    enum cr_err code = read_model(text, &model, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_participant *p = cr_scene_find(scene, id);
    p->model.file[0] = '\0';
    code = cr_cmd_set_text(scene, id, "model.file", "", err);
    if (code == CR_ERR_OK) {
        code = cr_cmd_set_text(scene, id, "type", cr_type_word(model.type), err);
    }
    snprintf(value, sizeof value, "%d", model.clock);
    return code == CR_ERR_OK
               ? cr_cmd_set_text(scene, id, model.clock > 0 ? "model.pdof_clock" : "model.pdof",
                                 model.clock > 0 ? value : "auto", err)
               : code;
}

static enum cr_err choose_model(struct cr_call *call, struct cr_scene *scene, const char *id,
                                struct cr_error *err) {
    const char *text = cr_cmd_text(call, "MODEL", NULL);
    enum cr_err code = text != NULL ? cr_model_take(scene, id, text, err) : CR_ERR_OK;
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "MODEL", code);
}

static enum cr_err choose_stiffness(struct cr_call *call, struct cr_scene *scene, const char *id,
                                    const char *face, struct cr_error *err) {
    const char *text = cr_cmd_text(call, face, NULL);
    char a[40], key[80];
    if (text == NULL) {
        return CR_ERR_OK;
    }
    const char *comma = strchr(text, ',');
    if (comma == NULL || comma - text >= (long)sizeof a) {
        cr_err_set(err, CR_ERR_TYPE, "%s must be A,B", face);
        cr_err_hint(err, "for example %s=92000,429000 (N/m and N/m2)", face);
        return cr_cmd_blame(call, face, CR_ERR_TYPE);
    }
    snprintf(a, sizeof a, "%.*s", (int)(comma - text), text);
    snprintf(key, sizeof key, "model.stiffness.%s.A_N_per_m", face);
    enum cr_err code = cr_cmd_set_text(scene, id, key, a, err);
    snprintf(key, sizeof key, "model.stiffness.%s.B_N_per_m2", face);
    code = code == CR_ERR_OK ? cr_cmd_set_text(scene, id, key, comma + 1, err) : code;
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, face, code);
}

static void say_model(struct cr_session *s, const struct cr_participant *p) {
    const struct cr_model_choice *m = &p->model;
    char pdof[40] = "chosen from the direction of force";
    if (m->pdof_kind != CR_PDOF_AUTO) {
        snprintf(pdof, sizeof pdof, "%.0f deg", cr_bearing_deg(m->pdof));
    }
    cr_say(s, "%s: %s%s%s, PDOF %s%s", p->id, cr_type_word(p->type),
           m->kind == CR_MODEL_FILE        ? ", voxels of "
           : m->kind == CR_MODEL_STIFFNESS ? " with CRASH3 stiffness"
                                           : "",
           m->file, pdof, m->blend ? ", blended" : "");
}

enum cr_err cr_cmd_model(struct cr_call *call, struct cr_error *err) {
    static const char *const faces[] = {"front", "side", "rear"};
    const char *id = cr_cmd_text(call, "NAME", "");
    struct cr_state *draft;
    if (cr_cmd_word(call, "NAME", -1) >= 0) {
        return model_info(call, err);
    }
    if (!cr_cmd_given(call, "MODEL") && cr_cmd_keys_given(call) == 0) {
        say_model(call->s, cr_scene_find(&cr_session_now(call->s)->scene, id));
        return CR_ERR_OK;
    }
    enum cr_err code = cr_cmd_edit(call, &draft, err);
    if (code == CR_ERR_OK) {
        code = choose_model(call, &draft->scene, id, err);
    }
    for (int i = 0; i < 3 && code == CR_ERR_OK; i++) {
        code = choose_stiffness(call, &draft->scene, id, faces[i], err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cmd_set_keys(call, &draft->scene, id, err);
    }
    if (code == CR_ERR_OK) {
        say_model(call->s, cr_scene_find(&draft->scene, id));
    }
    return code;
}
