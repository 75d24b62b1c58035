/* What may have been meant by words that fit nowhere: the slips that people make at the prompt. */
#include "cmd/cmd_priv.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* "speed=35 mph": a unit that was torn off its number */
static bool torn_unit(const struct cr_call *call, const struct cr_token *tok,
                      struct cr_error *err) {
    const struct cr_token *before = tok - 1;
    if (tok == call->tokens->tok || before->kind != CR_TOKEN_PAIR || tok->text[0] == '\0') {
        return false;
    }
    for (int i = 0; call->cmd->arg[i].name != NULL; i++) {
        const struct cr_arg *arg = &call->cmd->arg[i];
        const struct cr_key *key = cr_arg_key(arg);
        enum cr_dim dim = key != NULL ? key->dim : arg->dim;
        if (call->value[i].token == before && cr_unit_find(tok->text, dim) != NULL) {
            cr_err_hint(err, "a number and its unit are one word: %.60s=%.40s%.20s", before->key,
                        before->text, tok->text);
            return true;
        }
    }
    return false;
}

/* "vehicle A suv": a value without its key */
static bool bare_value(const struct cr_call *call, const struct cr_token *tok,
                       struct cr_error *err) {
    for (int i = 0; call->cmd->arg[i].name != NULL; i++) {
        const struct cr_arg *arg = &call->cmd->arg[i];
        const struct cr_key *key = cr_arg_key(arg);
        bool found = arg->place == CR_ARG_KEY && arg->words != NULL &&
                     cr_cmd_word_find(arg->words, tok->text) >= 0;
        for (size_t k = 0; key != NULL && key->type == CR_KEY_WORD && k < key->aux; k++) {
            found = found || strcmp(key->words[k], tok->text) == 0;
        }
        if (found) {
            cr_err_hint(err, "did you mean %s=%.60s?", arg->name, tok->text);
            return true;
        }
    }
    return false;
}

bool cr_cmd_guess(const struct cr_call *call, const struct cr_token *tok, struct cr_error *err) {
    return torn_unit(call, tok, err) || bare_value(call, tok, err);
}

bool cr_cmd_guess_key(const struct cr_session *s, const char *key, const char *value,
                      struct cr_error *err) {
    size_t n = strcspn(key, ".");
    if (key[n] == '\0' || n > 60) {
        return false;
    }
    const struct cr_scene *scene = cr_session_scene(s);
    bool object = false;
    for (int i = 0; i < scene->n; i++) {
        const char *id = scene->part[i].id;
        if (strlen(id) == n && strncmp(id, key, n) == 0) {
            object = scene->part[i].kind == CR_KIND_OBJECT;
        }
    }
    cr_err_hint(err, "try: %s %.*s %.60s=%.40s", object ? "object" : "vehicle", (int)n, key,
                key + n + 1, value);
    return true;
}

const char *cr_cmd_elsewhere(const char *word) {
    static const char *const pair[][2] = {
        {"bye", "quit"},      {"car", "vehicle"}, {"clear", "new"},    {"delete", "remove"},
        {"exit", "quit"},     {"ls", "list"},     {"man", "help"},     {"open", "load"},
        {"plot", "pulse"},    {"pole", "object"}, {"report", "table"}, {"reset", "new"},
        {"results", "table"}, {"rm", "remove"},   {"run", "solve"},    {"simulate", "solve"},
        {"start", "solve"},   {"wall", "object"}, {"write", "save"},
    };
    for (size_t i = 0; i < sizeof pair / sizeof *pair; i++) {
        if (strcmp(pair[i][0], word) == 0) {
            return pair[i][1];
        }
    }
    return NULL;
}

void cr_cmd_guess_file(const char *path, const char *suffix, struct cr_error *err) {
    char whole[2 * CR_PATH_MAX];
    if (err != NULL && err->code == CR_ERR_IO && err->hint[0] == '\0' &&
        snprintf(whole, sizeof whole, "%s%s", path, suffix) < (int)sizeof whole &&
        access(path, F_OK) != 0 && access(whole, R_OK) == 0) {
        cr_err_hint(err, "did you mean %.160s?", whole);
    }
}
