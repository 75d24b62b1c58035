/* Editing a scene: the draft of a command, and key arguments handed to the scene. */
#include "cmd/cmd_priv.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum cr_err cr_cmd_edit(struct cr_call *call, struct cr_state **out, struct cr_error *err) {
    if (call->draft == NULL) {
        enum cr_err code = cr_state_dup(cr_session_now(call->s), &call->draft, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    *out = call->draft;
    return CR_ERR_OK;
}

/* messages of the scene begin with the key as in JSON; who typed "mass" wants to read "mass" */
static void rename_key(const struct cr_arg *arg, struct cr_error *err) {
    size_t n = strlen(arg->key);
    if (err != NULL && strncmp(err->text, arg->key, n) == 0) {
        char rest[sizeof err->text];
        snprintf(rest, sizeof rest, "%s", err->text + n);
        snprintf(err->text, sizeof err->text, "%s%.200s", arg->name, rest);
    }
}

enum cr_err cr_cmd_set_key(struct cr_call *call, struct cr_scene *scene, const char *id,
                           const char *name, struct cr_error *err) {
    const struct cr_value *v = cr_cmd_arg(call, name);
    const struct cr_arg *arg = &call->cmd->arg[v - call->value];
    char full[CR_NAME_MAX + 64];
    if (v->token == NULL) {
        return CR_ERR_OK;
    }
    snprintf(full, sizeof full, "%s%s%s", id != NULL ? id : "", id != NULL ? "." : "", arg->key);
    enum cr_err code = cr_scene_set(scene, full, v->text, err);
    if (code != CR_ERR_OK) {
        rename_key(arg, err);
        call->blame = v->token;
    }
    return code;
}

/* all key arguments that were given */
enum cr_err cr_cmd_set_keys(struct cr_call *call, struct cr_scene *scene, const char *id,
                            struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; call->cmd->arg[i].name != NULL && code == CR_ERR_OK; i++) {
        if (call->cmd->arg[i].type == CR_VALUE_KEY) {
            code = cr_cmd_set_key(call, scene, id, call->cmd->arg[i].name, err);
        }
    }
    return code;
}

bool cr_cmd_is_arg(const struct cr_call *call, const struct cr_token *tok) {
    for (int k = 0; call->cmd->arg[k].name != NULL; k++) {
        if (call->value[k].token == tok) {
            return true;
        }
    }
    return false;
}

int cr_cmd_keys_given(const struct cr_call *call) {
    int n = 0;
    for (int i = 0; call->cmd->arg[i].name != NULL; i++) {
        n += call->cmd->arg[i].place == CR_ARG_KEY && call->value[i].token != NULL;
    }
    return n;
}

enum cr_err cr_cmd_set_text(struct cr_scene *scene, const char *id, const char *key,
                            const char *value, struct cr_error *err) {
    char full[CR_NAME_MAX + 64];
    snprintf(full, sizeof full, "%s.%s", id, key);
    return cr_scene_set(scene, full, value, err);
}

enum cr_err cr_cmd_set_numbers(struct cr_scene *scene, const char *id, const char *key, double x,
                               double y, struct cr_error *err) {
    char full[CR_NAME_MAX + 32], value[80];
    snprintf(full, sizeof full, "%s.%s", id, key);
    if (isnan(y)) {
        snprintf(value, sizeof value, "%.17g", x);
    } else {
        snprintf(value, sizeof value, "%.17g,%.17g", x, y);
    }
    return cr_scene_set(scene, full, value, err);
}

enum cr_err cr_cmd_set_pose(struct cr_scene *scene, const char *id, struct cr_vec2 pos,
                            double heading, struct cr_error *err) {
    enum cr_err code = cr_cmd_set_numbers(scene, id, "position_m", pos.x, pos.y, err);
    const struct cr_unit *deg = cr_unit_find("deg", CR_DIM_ANGLE);
    return code != CR_ERR_OK
               ? code
               : cr_cmd_set_numbers(scene, id, "heading_deg",
                                    cr_unit_from_si(deg, cr_angle_wrap(heading)), NAN, err);
}
