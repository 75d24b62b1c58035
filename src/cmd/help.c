/* Help printed from the command table, so that it cannot lie: pages, lists, and the man page. */
#include "cmd/cmd_priv.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

static const char *const type_words[] = {
    [CR_VALUE_KEY] = "VALUE",     [CR_VALUE_NUMBER] = "NUMBER",   [CR_VALUE_COUNT] = "N",
    [CR_VALUE_WORD] = "WORD",     [CR_VALUE_STEM] = "WORD",       [CR_VALUE_TEXT] = "TEXT",
    [CR_VALUE_NAME] = "NAME",     [CR_VALUE_VEHICLE] = "NAME",    [CR_VALUE_NEW] = "NAME",
    [CR_VALUE_FILE] = "FILE",     [CR_VALUE_MODEL] = "MODEL",     [CR_VALUE_COMMAND] = "COMMAND",
    [CR_VALUE_TIME] = "TIME",     [CR_VALUE_SWEEP] = "KEY RANGE", [CR_VALUE_POINT] = "X,Y",
    [CR_VALUE_SWITCH] = "on|off",
};

static void value_word(const struct cr_arg *arg, struct cr_str *out) {
    const struct cr_key *key = cr_arg_key(arg);
    if (key != NULL && key->type == CR_KEY_WORD) {
        for (size_t i = 0; i < key->aux; i++) {
            cr_str_addf(out, "%s%s", i > 0 ? "|" : "", key->words[i]);
        }
    } else if (key != NULL && (key->type == CR_KEY_SWITCH || key->type == CR_KEY_BOOL)) {
        cr_str_add(out, "on|off");
    } else if (key != NULL && key->unit != NULL && key->unit[0] != '\0') {
        cr_str_add(out, key->unit);
    } else if (arg->type == CR_VALUE_WORD || arg->type == CR_VALUE_STEM ||
               arg->type == CR_VALUE_SWITCH) {
        cr_str_add(out, arg->words);
    } else if (arg->unit != NULL) {
        cr_str_add(out, arg->unit);
        cr_str_addf(out, "%s%s", arg->words != NULL ? "|" : "",
                    arg->words != NULL ? arg->words : "");
    } else if (arg->type == CR_VALUE_FILE) {
        cr_str_addf(out, "FILE%s", strchr(arg->words, '|') == NULL ? arg->words : "");
    } else {
        cr_str_add(out, type_words[arg->type]);
    }
}

static void usage_of(const struct cr_arg *arg, struct cr_str *out) {
    switch (arg->place) {
    case CR_ARG_POSITION:
    case CR_ARG_REST:
        cr_str_addf(out, " %s", arg->name);
        break;
    case CR_ARG_OPTION:
        cr_str_addf(out, " [%s]", arg->name);
        break;
    case CR_ARG_KEY:
        cr_str_addf(out, " [%s=", arg->name);
        value_word(arg, out);
        cr_str_add(out, "]");
        break;
    case CR_ARG_FLAG:
        cr_str_addf(out, " [--%s]", arg->name);
        break;
    }
}

void cr_command_usage(const struct cr_command *cmd, struct cr_str *out) {
    cr_str_addf(out, "%s%s", cmd->name, (cmd->flags & CR_CMD_FORCE) != 0 ? "[!]" : "");
    for (int i = 0; cmd->arg[i].name != NULL; i++) {
        usage_of(&cmd->arg[i], out);
    }
}

static const char *unit_gap(const char *unit) {
    return unit[0] == '\0' || unit[0] == '%' ? "" : " ";
}

/* "mass as crashed, with load; 100 to 60000 kg (fixed)" */
void cr_arg_help(const struct cr_arg *arg, struct cr_str *out) {
    const struct cr_key *key = cr_arg_key(arg);
    double lo = key != NULL ? key->lo : arg->lo, hi = key != NULL ? key->hi : arg->hi;
    const char *unit = key != NULL ? key->unit : arg->unit;
    unit = unit != NULL ? unit : "";
    cr_str_add(out, key != NULL ? key->help : arg->help != NULL ? arg->help : "");
    if (key != NULL && key->type == CR_KEY_LOCKED) {
        cr_str_add(out, "; true or false");
    } else if (lo < hi && isfinite(hi) && hi < 1e5) {
        cr_str_addf(out, "; %.10g to %.10g%s%s", lo, hi, unit_gap(unit), unit);
    } else if (unit[0] != '\0') {
        cr_str_addf(out, "; in %s", unit);
    }
    if (arg->def != NULL) {
        cr_str_addf(out, " (%s)", arg->def);
    } else if (key != NULL && arg->mask == 0 && isfinite(key->def[0]) &&
               key->type == CR_KEY_NUMBER) {
        cr_str_addf(out, " (%.10g%s%s)", key->def[0], unit_gap(unit), unit);
    }
}

enum { INDENT = 18 };

static void arg_line(const struct cr_arg *arg, struct cr_str *out) {
    struct cr_str text = {0};
    char name[64];
    snprintf(name, sizeof name, "%s%s%s", arg->place == CR_ARG_FLAG ? "--" : "", arg->name,
             arg->place == CR_ARG_KEY ? "=" : "");
    cr_str_addf(out, "  %-*s", INDENT - 3, name);
    cr_str_add(out, " ");
    cr_arg_help(arg, &text);
    if (arg->place != CR_ARG_KEY || arg->type == CR_VALUE_WORD || cr_arg_key(arg) != NULL) {
        struct cr_str words = {0};
        value_word(arg, &words);
        out->failed = out->failed || words.failed;
        if (strchr(cr_str_get(&words), '|') != NULL && arg->type != CR_VALUE_FILE) {
            cr_str_addf(&text, ": %s", words.s);
        }
        cr_str_fini(&words);
    } else if (arg->words != NULL && arg->type != CR_VALUE_FILE && arg->type != CR_VALUE_SWITCH) {
        cr_str_addf(&text, "; or %s", arg->words);
    }
    out->failed = out->failed || text.failed;
    cr_help_fold(out, cr_str_get(&text),
                 (int)strlen(name) + 3 > INDENT ? (int)strlen(name) + 3 : INDENT, INDENT);
    cr_str_fini(&text);
}

void cr_command_help(const struct cr_command *cmd, struct cr_str *out) {
    struct cr_str usage = {0};
    cr_str_addf(out, "%s: %s\n", cmd->name, cmd->help);
    cr_command_usage(cmd, &usage);
    out->failed = out->failed || usage.failed;
    cr_help_fold(out, cr_str_get(&usage), 0, 4);
    cr_str_fini(&usage);
    for (int i = 0; cmd->arg[i].name != NULL; i++) {
        arg_line(&cmd->arg[i], out);
    }
    cr_str_add(out, "examples:\n");
    cr_str_addf(out, "  %s\n", cmd->example[0]);
    if (strcmp(cmd->example[0], cmd->example[1]) != 0) {
        cr_str_addf(out, "  %s\n", cmd->example[1]);
    }
    cr_str_addf(out, "see also: %s\n", cmd->see);
}

/* ---- man page ---- */

static void roff_text(struct cr_str *out, const char *text) {
    for (; *text != '\0'; text++) {
        if (*text == '-') {
            cr_str_add(out, "\\-");
        } else if (*text == '\\') {
            cr_str_add(out, "\\e");
        } else if (*text == '|') {
            cr_str_add(out, "|\\:"); /* a long list of words may be broken here */
        } else {
            cr_str_addn(out, text, 1);
        }
    }
}

void cr_command_roff(const struct cr_command *cmd, struct cr_str *out) {
    struct cr_str text = {0};
    cr_str_addf(out, ".SS %s\n", cmd->name);
    cr_command_usage(cmd, &text);
    cr_str_add(out, ".B ");
    roff_text(out, cr_str_get(&text));
    cr_str_add(out, "\n.PP\n");
    roff_text(out, cmd->help);
    cr_str_add(out, ".\n");
    for (int i = 0; cmd->arg[i].name != NULL; i++) {
        const struct cr_arg *arg = &cmd->arg[i];
        cr_str_clear(&text);
        cr_str_addf(out, ".TP\n.B %s", arg->place == CR_ARG_FLAG ? "\\-\\-" : "");
        roff_text(out, arg->name);
        cr_str_add(out, arg->place == CR_ARG_KEY ? "=\n" : "\n");
        cr_arg_help(arg, &text);
        if (arg->words != NULL && arg->type != CR_VALUE_FILE) {
            cr_str_addf(&text, "; %s%s",
                        arg->unit != NULL || arg->type == CR_VALUE_VEHICLE ? "or " : "",
                        arg->words);
        }
        roff_text(out, cr_str_get(&text));
        cr_str_add(out, "\n");
    }
    cr_str_add(out, ".PP\nExamples:\n.PP\n.EX\n");
    for (int i = 0; i < 2; i++) {
        if (i == 0 || strcmp(cmd->example[0], cmd->example[1]) != 0) {
            roff_text(out, cmd->example[i]);
            cr_str_add(out, "\n");
        }
    }
    cr_str_addf(out, ".EE\n.PP\nSee also: %s.\n", cmd->see);
    cr_str_fini(&text);
}

/* ---- commands ---- */

/* a command by its whole name, else a term of the field, else a command by its first letters */
static enum cr_err explain(struct cr_call *call, const char *name, struct cr_error *err) {
    struct cr_session *s = call->s;
    bool many;
    struct cr_str page = {0};
    const struct cr_command *cmd = cr_command_among(s->command, s->commands, name, &many);
    bool whole = cmd != NULL && strcmp(cmd->name, name) == 0;
    if (!whole && cr_glossary_say(s, name)) {
        return CR_ERR_OK;
    }
    if (cmd == NULL) {
        cr_err_set(err, CR_ERR_NAME, "there is no command or term '%.60s'", name);
        cr_err_hint(err, "apropos %.40s searches the help, help glossary lists the terms", name);
        return cr_cmd_blame(call, "COMMAND", CR_ERR_NAME);
    }
    cr_command_help(cmd, &page);
    cr_session_lines(s, &page, false);
    cr_str_fini(&page);
    if (whole) {
        cr_glossary_say(s, name);
    }
    return CR_ERR_OK;
}

enum cr_err cr_cmd_help(struct cr_call *call, struct cr_error *err) {
    const struct cr_session *s = call->s;
    const struct cr_command *table = s->command;
    const char *name = cr_cmd_text(call, "COMMAND", NULL), *group = "";
    if (name != NULL) {
        return explain(call, name, err);
    }
    for (int i = 0; i < s->commands; i++) {
        if (strcmp(group, table[i].group) != 0) {
            group = table[i].group;
            cr_say(call->s, "%s", group);
        }
        cr_say(call->s, "  %-9s %s", table[i].name, table[i].help);
    }
    cr_say(call->s,
           "help COMMAND explains one, help glossary lists the terms (help pdof), help units "
           "the units; Tab");
    cr_say(call->s, "completes; any unique prefix is enough");
    return CR_ERR_OK;
}

static bool mentions(struct cr_session *s, const struct cr_command *cmd, const char *word) {
    if (cr_help_contains(cmd->name, word) || cr_help_contains(cmd->help, word)) {
        return true;
    }
    for (int i = 0; cmd->arg[i].name != NULL; i++) {
        struct cr_str text = {0};
        cr_arg_help(&cmd->arg[i], &text);
        bool found = cr_help_contains(cmd->arg[i].name, word) ||
                     cr_help_contains(cmd->arg[i].words, word) ||
                     cr_help_contains(cr_str_get(&text), word);
        s->lost = s->lost || text.failed;
        cr_str_fini(&text);
        if (found) {
            return true;
        }
    }
    return false;
}

enum cr_err cr_cmd_apropos(struct cr_call *call, struct cr_error *err) {
    int found = 0;
    const struct cr_command *table = call->s->command;
    const char *word = cr_cmd_text(call, "WORD", "");
    for (int i = 0; i < call->s->commands; i++) {
        if (mentions(call->s, &table[i], word)) {
            cr_say(call->s, "%-9s %s", table[i].name, table[i].help);
            found++;
        }
    }
    found += cr_glossary_search(call->s, word);
    if (found == 0) {
        cr_err_set(err, CR_ERR_NAME, "no help mentions '%.60s'", word);
        cr_err_hint(err, "help lists the commands");
        return cr_cmd_blame(call, "WORD", CR_ERR_NAME);
    }
    return CR_ERR_OK;
}
