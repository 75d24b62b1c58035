/* Binds the words of a statement to the arguments of its command and checks their values. */
#include "cmd/cmd_priv.h"

#include "base/show.h"
#include "base/units.h"
#include "scene/keys.h"

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- word lists "a|b|c" ---- */

static void words_hint(const char *words, const char *word, struct cr_error *err) {
    char near[64];
    if (cr_cmd_word_nearest(words, word, near, sizeof near) != NULL) {
        cr_err_hint(err, "did you mean '%s'?", near);
        return;
    }
    char list[180];
    snprintf(list, sizeof list, "%s", words);
    for (char *p = list; *p != '\0'; p++) {
        *p = *p == '|' ? ' ' : *p;
    }
    cr_err_hint(err, "one of: %s", list);
}

/* ---- values ---- */

const struct cr_unit *cr_cmd_unit(const struct cr_arg *arg) {
    return cr_unit_find(arg->unit != NULL ? arg->unit : "", arg->dim);
}

static enum cr_err parse_word(const struct cr_call *call, const struct cr_arg *arg,
                              struct cr_value *v, struct cr_error *err) {
    bool position = arg->place == CR_ARG_POSITION || arg->place == CR_ARG_OPTION;
    v->word = cr_cmd_word_find(arg->words, v->text);
    if (v->word >= 0) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_NAME,
               v->word == -2 ? "'%.60s' is ambiguous for '%s'" : "unknown word '%.60s' for '%s'",
               v->text, position ? call->cmd->name : arg->name);
    words_hint(arg->words, v->text, err);
    return CR_ERR_NAME;
}

/* "scene.svg": the word is what stands before the suffix */
static enum cr_err parse_stem(const struct cr_call *call, const struct cr_arg *arg,
                              struct cr_value *v, struct cr_error *err) {
    char stem[64];
    const char *whole = v->text, *slash = strrchr(whole, '/');
    const char *name = slash != NULL ? slash + 1 : whole;
    snprintf(stem, sizeof stem, "%.*s", (int)strcspn(name, "."), name);
    v->text = stem;
    enum cr_err code = parse_word(call, arg, v, err);
    v->text = whole;
    return code;
}

static const char *bound(double x, const char *unit, char *buf, int size) {
    snprintf(buf, (size_t)size, "%.10g%s%s", x, unit != NULL && strcmp(unit, "%") != 0 ? " " : "",
             unit != NULL ? unit : "");
    return buf;
}

static enum cr_err check_range(const struct cr_arg *arg, double x, struct cr_error *err) {
    char lo[40], hi[40], got[40];
    /* a value typed in another unit may miss the bound by rounding alone */
    double slack = 1e-9 * (fabs(arg->lo) + fabs(arg->hi));
    if (arg->lo == arg->hi || (x >= arg->lo - slack && x <= arg->hi + slack)) {
        return CR_ERR_OK;
    }
    bound(x, arg->unit, got, sizeof got);
    if (isinf(arg->hi)) {
        return cr_err_set(err, CR_ERR_RANGE, "%s must be at least %s, got %s", arg->name,
                          bound(arg->lo, arg->unit, lo, sizeof lo), got);
    }
    return cr_err_set(err, CR_ERR_RANGE, "%s must be %s to %s, got %s", arg->name,
                      bound(arg->lo, arg->unit, lo, sizeof lo),
                      bound(arg->hi, arg->unit, hi, sizeof hi), got);
}

static enum cr_err parse_number(const struct cr_arg *arg, struct cr_value *v,
                                struct cr_error *err) {
    const struct cr_unit *unit = cr_cmd_unit(arg);
    if (arg->words != NULL) {
        v->word = cr_cmd_word_find(arg->words, v->text);
        if (v->word >= 0) {
            v->number = NAN;
            return CR_ERR_OK;
        }
    }
    enum cr_err code;
    struct cr_tolerance how = {.half = NAN};
    if (arg->spreads && cr_tolerance_is(v->text)) {
        code = cr_tolerance_read(v->text, arg->dim, unit, &v->number, &how, err);
    } else {
        code = cr_unit_parse(v->text, arg->dim, unit, &v->number, NULL, err);
    }
    v->second = how.half;
    if (code != CR_ERR_OK && arg->words != NULL && err != NULL) {
        char was[sizeof err->hint];
        snprintf(was, sizeof was, "%s", err->hint);
        cr_err_hint(err, "%.120s; or %s", was, arg->words);
    }
    v->sign = v->text[0] == '+' ? 1 : v->text[0] == '-' ? -1 : 0;
    return code != CR_ERR_OK ? code : check_range(arg, cr_unit_from_si(unit, v->number), err);
}

static enum cr_err parse_count(const struct cr_arg *arg, struct cr_value *v, struct cr_error *err) {
    char *end;
    long n = strtol(v->text, &end, 10);
    if (end == v->text || *end != '\0' || n > INT_MAX || n < INT_MIN) {
        cr_err_set(err, CR_ERR_TYPE, "%s must be a whole number, got '%.40s'", arg->name, v->text);
        return CR_ERR_TYPE;
    }
    v->sign = v->text[0] == '+' ? 1 : v->text[0] == '-' ? -1 : 0;
    v->number = (double)n;
    return check_range(arg, v->number, err);
}

static enum cr_err parse_point(const struct cr_arg *arg, struct cr_value *v, struct cr_error *err) {
    char first[40];
    const char *comma = strchr(v->text, ',');
    const struct cr_unit *unit = cr_cmd_unit(arg);
    if (comma == NULL || comma - v->text >= (long)sizeof first) {
        cr_err_set(err, CR_ERR_TYPE, "%s must be x,y, got '%.40s'", arg->name, v->text);
        cr_err_hint(err, "for example %s=1.5,-0.2", arg->name);
        return CR_ERR_TYPE;
    }
    snprintf(first, sizeof first, "%.*s", (int)(comma - v->text), v->text);
    enum cr_err code = cr_unit_parse(first, arg->dim, unit, &v->number, NULL, err);
    return code != CR_ERR_OK ? code
                             : cr_unit_parse(comma + 1, arg->dim, unit, &v->second, NULL, err);
}

static enum cr_err check_new_name(const struct cr_value *v, struct cr_error *err) {
    size_t n = strlen(v->text);
    if (n == 0 || cr_utf8_chars(v->text) > CR_NAME_CHARS || !cr_show_fits(v->text) ||
        strcspn(v->text, " .=:,;#\"'\\|/") != n) {
        cr_err_set(err, CR_ERR_NAME, "'%.40s' cannot be a name", v->text);
        cr_err_hint(err, "letters, digits, - and _, at most %d", CR_NAME_CHARS);
        return CR_ERR_NAME;
    }
    return CR_ERR_OK;
}

/* a participant of the scene, or of the draft a handler has not made yet */
static enum cr_err find_name(struct cr_call *call, const struct cr_arg *arg,
                             const struct cr_value *v, struct cr_error *err) {
    struct cr_scene *scene = &cr_session_now(call->s)->scene;
    const char *ids[CR_BODY_MAX] = {NULL};
    struct cr_participant *part = cr_scene_find(scene, v->text);
    if (part != NULL && arg->type == CR_VALUE_VEHICLE && part->kind != CR_KIND_VEHICLE) {
        cr_err_set(err, CR_ERR_NAME, "%.60s is an object, not a vehicle", v->text);
        return CR_ERR_NAME;
    }
    if (part != NULL) {
        return CR_ERR_OK;
    }
    for (int i = 0; i < scene->n; i++) {
        ids[i] = scene->part[i].id;
    }
    const char *near = cr_str_nearest(v->text, ids, scene->n);
    cr_err_set(err, CR_ERR_NAME, "there is no participant '%.60s'", v->text);
    if (scene->n == 0) {
        cr_err_hint(err, "the scene is empty; begin with: vehicle A type=compact");
    } else if (near != NULL && strlen(v->text) > 1) {
        cr_err_hint(err, "did you mean '%s'?", near);
    } else {
        cr_err_hint(err, "list shows the participants");
    }
    return CR_ERR_NAME;
}

static enum cr_err parse_value(struct cr_call *call, const struct cr_arg *arg, struct cr_value *v,
                               struct cr_error *err) {
    switch (arg->type) {
    case CR_VALUE_NUMBER:
    case CR_VALUE_TIME:
        return parse_number(arg, v, err);
    case CR_VALUE_COUNT:
        return parse_count(arg, v, err);
    case CR_VALUE_WORD:
    case CR_VALUE_SWITCH:
        return parse_word(call, arg, v, err);
    case CR_VALUE_STEM:
        return parse_stem(call, arg, v, err);
    case CR_VALUE_POINT:
        return parse_point(arg, v, err);
    case CR_VALUE_NAME:
    case CR_VALUE_VEHICLE:
        v->word = arg->words != NULL ? cr_str_choice(arg->words, v->text) : -1;
        return v->word >= 0 ? CR_ERR_OK : find_name(call, arg, v, err);
    case CR_VALUE_NEW:
        return check_new_name(v, err);
    case CR_VALUE_KEY:
    case CR_VALUE_TEXT:
    case CR_VALUE_FILE:
    case CR_VALUE_MODEL:
    case CR_VALUE_COMMAND:
    case CR_VALUE_SWEEP:
        break;
    }
    return CR_ERR_OK;
}

/* ---- binding ---- */

/* index of the key or flag of that name or unique prefix; -1: none, -2: ambiguous */
static int find_key(const struct cr_command *cmd, const char *name, enum cr_arg_place place) {
    int found = -1;
    for (int i = 0; cmd->arg[i].name != NULL; i++) {
        if (cmd->arg[i].place != place) {
            continue;
        }
        if (strcmp(cmd->arg[i].name, name) == 0) {
            return i;
        }
        if (name[0] != '\0' && strncmp(cmd->arg[i].name, name, strlen(name)) == 0) {
            found = found == -1 ? i : -2;
        }
    }
    return found;
}

static enum cr_err no_such_key(struct cr_call *call, const struct cr_token *tok, const char *name,
                               enum cr_arg_place place, bool many, struct cr_error *err) {
    const char *list[CR_CMD_ARGS] = {NULL}, *dashes = place == CR_ARG_KEY ? "" : "--";
    char fitting[120] = "";
    int n = 0;
    for (int i = 0; call->cmd->arg[i].name != NULL; i++) {
        if (call->cmd->arg[i].place == place) {
            list[n++] = call->cmd->arg[i].name;
            size_t used = strlen(fitting);
            if (strncmp(call->cmd->arg[i].name, name, strlen(name)) == 0) {
                snprintf(fitting + used, sizeof fitting - used, " %s%s", dashes,
                         call->cmd->arg[i].name);
            }
        }
    }
    call->blame = tok;
    const char *near = cr_str_nearest(name, list, n);
    cr_err_set(err, CR_ERR_KEY, "%s %s '%s%.60s' for '%s'", many ? "ambiguous" : "unknown",
               place == CR_ARG_KEY ? "key" : "flag", dashes, name, call->cmd->name);
    if (many) {
        cr_err_hint(err, "one of:%s", fitting);
    } else if (near != NULL) {
        cr_err_hint(err, "did you mean '%s%s'?", dashes, near);
    } else if (place == CR_ARG_FLAG ||
               !cr_cmd_guess_key(call->s, name,
                                 tok->kind == CR_TOKEN_PAIR ? tok->text : tok[1].text, err)) {
        cr_err_hint(err, "help %s lists what it takes", call->cmd->name);
    }
    return CR_ERR_KEY;
}

static enum cr_err take(struct cr_call *call, int i, const struct cr_token *tok,
                        struct cr_error *err) {
    struct cr_value *v = &call->value[i];
    if (v->token != NULL) {
        call->blame = tok;
        return cr_err_set(err, CR_ERR_DUPLICATE, "'%s' is given twice", call->cmd->arg[i].name);
    }
    *v = (struct cr_value){.token = tok, .text = tok->text, .word = -1};
    if (tok->kind == CR_TOKEN_FLAG) {
        return CR_ERR_OK;
    }
    enum cr_err code = parse_value(call, &call->cmd->arg[i], v, err);
    if (code != CR_ERR_OK) {
        call->blame = tok;
    }
    return code;
}

static enum cr_err no_place(struct cr_call *call, const struct cr_token *tok,
                            struct cr_error *err) {
    const char *list[CR_CMD_ARGS] = {NULL};
    int n = 0;
    for (int i = 0; call->cmd->arg[i].name != NULL; i++) {
        if (call->cmd->arg[i].place == CR_ARG_KEY && strlen(call->cmd->arg[i].name) > 2) {
            list[n++] = call->cmd->arg[i].name;
        }
    }
    call->blame = tok;
    cr_err_set(err, CR_ERR_SYNTAX, "unknown word '%.60s' for '%s'", tok->text, call->cmd->name);
    if (cr_cmd_guess(call, tok, err)) {
        return CR_ERR_SYNTAX;
    }
    const char *near = strlen(tok->text) > 2 ? cr_str_nearest(tok->text, list, n) : NULL;
    if (near != NULL) {
        cr_err_hint(err, "did you mean '%s=...'?", near);
    } else {
        cr_err_hint(err, "help %s shows what it takes", call->cmd->name);
    }
    return CR_ERR_SYNTAX;
}

/* next free position; -1 if all are taken */
static int next_position(const struct cr_call *call) {
    for (int i = 0; call->cmd->arg[i].name != NULL; i++) {
        enum cr_arg_place place = call->cmd->arg[i].place;
        if ((place == CR_ARG_POSITION || place == CR_ARG_OPTION) && call->value[i].token == NULL) {
            return i;
        }
    }
    return -1;
}

static bool has_rest(const struct cr_command *cmd) {
    for (int i = 0; cmd->arg[i].name != NULL; i++) {
        if (cmd->arg[i].place == CR_ARG_REST) {
            return true;
        }
    }
    return false;
}

/* takes one word; *i is its index and moves on when a second one is used up */
static enum cr_err bind_word(struct cr_call *call, int *i, struct cr_error *err) {
    struct cr_token *tok = &call->tokens->tok[*i];
    const struct cr_command *cmd = call->cmd;
    if (tok->kind == CR_TOKEN_FLAG) {
        int at = find_key(cmd, tok->text, CR_ARG_FLAG);
        return at >= 0 ? take(call, at, tok, err)
                       : no_such_key(call, tok, tok->text, CR_ARG_FLAG, at == -2, err);
    }
    if (tok->kind == CR_TOKEN_PAIR) {
        int at = find_key(cmd, tok->key, CR_ARG_KEY);
        return at >= 0 ? take(call, at, tok, err)
                       : no_such_key(call, tok, tok->key, CR_ARG_KEY, at == -2, err);
    }
    if ((cmd->flags & CR_CMD_PAIRS) != 0) {
        int at = find_key(cmd, tok->text, CR_ARG_KEY);
        bool pair = *i + 1 < call->tokens->n && tok[1].kind == CR_TOKEN_WORD;
        if (pair && at < 0) {
            return no_such_key(call, tok, tok->text, CR_ARG_KEY, at == -2, err);
        }
        if (pair) {
            *i += 1;
            return take(call, at, &call->tokens->tok[*i], err);
        }
    }
    int at = next_position(call);
    return at >= 0 ? take(call, at, tok, err) : no_place(call, tok, err);
}

static enum cr_err check_missing(struct cr_call *call, struct cr_error *err) {
    int at = next_position(call);
    if (at < 0 || call->cmd->arg[at].place != CR_ARG_POSITION) {
        return CR_ERR_OK;
    }
    call->blame = &call->tokens->tok[0];
    cr_err_set(err, CR_ERR_MISSING, "%s needs %s (%s)", call->cmd->name, call->cmd->arg[at].name,
               call->cmd->arg[at].help);
    cr_err_hint(err, "for example: %s", call->cmd->example[0]);
    return CR_ERR_MISSING;
}

enum cr_err cr_cmd_bind(struct cr_call *call, struct cr_error *err) {
    bool rest = has_rest(call->cmd);
    call->rest = call->tokens->n;
    for (int i = 1; i < call->tokens->n; i++) {
        const struct cr_token *tok = &call->tokens->tok[i];
        bool pair = tok->kind == CR_TOKEN_PAIR;
        bool known = pair && find_key(call->cmd, tok->key, CR_ARG_KEY) >= 0;
        if (rest && tok->kind != CR_TOKEN_FLAG && !known && (pair || next_position(call) < 0)) {
            call->rest = call->rest < i ? call->rest : i;
            continue;
        }
        enum cr_err code = bind_word(call, &i, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    return check_missing(call, err);
}

/* ---- what handlers read ---- */

const struct cr_value *cr_cmd_arg(const struct cr_call *call, const char *name) {
    for (int i = 0; call->cmd->arg[i].name != NULL; i++) {
        if (strcmp(call->cmd->arg[i].name, name) == 0) {
            return &call->value[i];
        }
    }
    assert(!"argument of this name in the command table");
    return NULL;
}

bool cr_cmd_given(const struct cr_call *call, const char *name) {
    return cr_cmd_arg(call, name)->token != NULL;
}

double cr_cmd_number(const struct cr_call *call, const char *name, double otherwise) {
    const struct cr_value *v = cr_cmd_arg(call, name);
    return v->token != NULL ? v->number : otherwise;
}

int cr_cmd_word(const struct cr_call *call, const char *name, int otherwise) {
    const struct cr_value *v = cr_cmd_arg(call, name);
    return v->token != NULL ? v->word : otherwise;
}

const char *cr_cmd_text(const struct cr_call *call, const char *name, const char *otherwise) {
    const struct cr_value *v = cr_cmd_arg(call, name);
    return v->token != NULL ? v->text : otherwise;
}

enum cr_err cr_cmd_blame(struct cr_call *call, const char *name, enum cr_err code) {
    const struct cr_value *v = cr_cmd_arg(call, name);
    if (v->token != NULL) {
        call->blame = v->token;
    }
    return code;
}
