/* Parses, checks and explains the options of a word of the command line by its table. */
#include "cli/options.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OPTIONS_MAX = 32, LEFT = 26 };

static bool takes_value(const struct cr_option *o) {
    return o->flag == NULL;
}

static bool is_choice(const struct cr_option *o) {
    return o->number != NULL && strchr(o->arg, '|') != NULL;
}

static enum cr_err set_number(const struct cr_option *o, const char *value, struct cr_error *err) {
    char *end = NULL;
    errno = 0;
    long x = strtol(value, &end, 10);
    if (end == value || *end != '\0' || errno != 0 || x < o->lo || x > o->hi) {
        cr_err_set(err, CR_ERR_USAGE, "--%s: '%s' is not a whole number in %d..%d", o->name, value,
                   o->lo, o->hi);
        return CR_ERR_USAGE;
    }
    *o->number = (int)x;
    return CR_ERR_OK;
}

static enum cr_err set_value(const struct cr_option *o, const char *value, struct cr_error *err) {
    if (is_choice(o)) {
        int index = cr_str_choice(o->arg, value);
        if (index < 0) {
            cr_err_set(err, CR_ERR_USAGE, "--%s: '%s' is none of %s", o->name, value, o->arg);
            return CR_ERR_USAGE;
        }
        *o->number = index;
        return CR_ERR_OK;
    }
    if (o->number != NULL) {
        return set_number(o, value, err);
    }
    if (value[0] == '\0') {
        return cr_err_set(err, CR_ERR_USAGE, "--%s needs a %s, not an empty text", o->name, o->arg);
    }
    if (o->text != NULL) {
        *o->text = value;
        return CR_ERR_OK;
    }
    if (o->values->n >= CR_OPTION_REPEAT_MAX) {
        return cr_err_set(err, CR_ERR_USAGE, "--%s is given more than %d times", o->name,
                          CR_OPTION_REPEAT_MAX);
    }
    o->values->value[o->values->n++] = value;
    return CR_ERR_OK;
}

static enum cr_err unknown(const struct cr_usage *usage, const char *given, size_t len,
                           struct cr_error *err) {
    const char *names[OPTIONS_MAX + 1] = {"help"};
    int n = 1;
    for (int i = 0; i < usage->options && n <= OPTIONS_MAX; i++) {
        names[n++] = usage->option[i].name;
    }
    char word[64];
    snprintf(word, sizeof word, "%.*s", (int)len, given);
    cr_err_set(err, CR_ERR_USAGE, "unknown option --%s", word);
    const char *near = cr_str_nearest(word, names, n);
    if (near != NULL) {
        cr_err_hint(err, "did you mean --%s?", near);
    } else {
        cr_err_hint(err, "crumple %s --help lists them", usage->word);
    }
    return CR_ERR_USAGE;
}

/* where the parsing stands in argv */
struct walk {
    int argc, at;
    char **argv;
};

static enum cr_err take(const struct cr_option *o, const char *attached, struct walk *w,
                        struct cr_error *err) {
    if (!takes_value(o)) {
        if (attached != NULL) {
            return cr_err_set(err, CR_ERR_USAGE, "--%s takes no value", o->name);
        }
        *o->flag = true;
        return CR_ERR_OK;
    }
    if (attached == NULL) {
        if (w->at + 1 >= w->argc) {
            return cr_err_set(err, CR_ERR_USAGE, "--%s needs a value: %s", o->name, o->arg);
        }
        attached = w->argv[++w->at];
    }
    return set_value(o, attached, err);
}

static enum cr_err long_option(const struct cr_usage *usage, struct walk *w, bool *help,
                               struct cr_error *err) {
    const char *name = w->argv[w->at] + 2;
    const char *equals = strchr(name, '=');
    size_t len = equals != NULL ? (size_t)(equals - name) : strlen(name);
    if (strcmp(name, "help") == 0) {
        *help = true;
        return CR_ERR_OK;
    }
    for (int i = 0; i < usage->options; i++) {
        const struct cr_option *o = &usage->option[i];
        if (strlen(o->name) == len && memcmp(o->name, name, len) == 0) {
            return take(o, equals != NULL ? equals + 1 : NULL, w, err);
        }
    }
    return unknown(usage, name, len, err);
}

/* one or more letters: -q, -qv, -oFILE, -o FILE */
static enum cr_err short_options(const struct cr_usage *usage, struct walk *w, bool *help,
                                 struct cr_error *err) {
    for (const char *p = w->argv[w->at] + 1; *p != '\0'; p++) {
        const struct cr_option *o = NULL;
        for (int i = 0; i < usage->options && o == NULL; i++) {
            o = usage->option[i].letter == *p ? &usage->option[i] : NULL;
        }
        if (*p == 'h') {
            *help = true;
            return CR_ERR_OK;
        }
        if (o == NULL) {
            cr_err_set(err, CR_ERR_USAGE, "unknown option -%c", *p);
            cr_err_hint(err, "crumple %s --help lists them", usage->word);
            return CR_ERR_USAGE;
        }
        const char *attached = takes_value(o) && p[1] != '\0' ? p + 1 : NULL;
        enum cr_err code = take(o, attached, w, err);
        if (code != CR_ERR_OK || takes_value(o)) {
            return code;
        }
    }
    return CR_ERR_OK;
}

static enum cr_err check_operands(const struct cr_usage *usage, int n, struct cr_error *err) {
    if (n < usage->least) {
        cr_err_set(err, CR_ERR_USAGE, "crumple %s needs %s", usage->word, usage->operands);
        cr_err_hint(err, "crumple %s --help explains", usage->word);
        return CR_ERR_USAGE;
    }
    if (usage->most >= 0 && n > usage->most) {
        cr_err_set(err, CR_ERR_USAGE, "crumple %s takes %d operand%s, not %d", usage->word,
                   usage->most, usage->most == 1 ? "" : "s", n);
        cr_err_hint(err, "crumple %s --help explains", usage->word);
        return CR_ERR_USAGE;
    }
    return CR_ERR_OK;
}

enum cr_err cr_options_parse(const struct cr_usage *usage, int argc, char **argv, int *operands,
                             bool *help, struct cr_error *err) {
    struct walk w = {.argc = argc, .at = 1, .argv = argv};
    bool rest = false;
    int n = 0;
    *help = false;
    *operands = 0;
    for (; w.at < argc; w.at++) {
        const char *word = argv[w.at];
        enum cr_err code = CR_ERR_OK;
        if (rest || word[0] != '-' || word[1] == '\0') {
            argv[1 + n++] = argv[w.at];
        } else if (strcmp(word, "--") == 0) {
            rest = true;
        } else if (word[1] == '-') {
            code = long_option(usage, &w, help, err);
        } else {
            code = short_options(usage, &w, help, err);
        }
        if (code != CR_ERR_OK || *help) {
            return code;
        }
    }
    *operands = n;
    return check_operands(usage, n, err);
}

void cr_options_help(const struct cr_usage *usage, struct cr_str *out) {
    cr_str_addf(out, "usage: crumple %s [OPTION ...] %s\n\n%s\n", usage->word, usage->operands,
                usage->about);
    for (int i = 0; i < usage->options; i++) {
        const struct cr_option *o = &usage->option[i];
        char left[80], letter[8] = "    ";
        if (o->letter != '\0') {
            snprintf(letter, sizeof letter, "-%c, ", o->letter);
        }
        snprintf(left, sizeof left, "  %s--%s%s%s", letter, o->name, takes_value(o) ? "=" : "",
                 takes_value(o) ? o->arg : "");
        if (strlen(left) > LEFT) {
            cr_str_addf(out, "%s\n%-*s  %s\n", left, LEFT, "", o->help);
        } else {
            cr_str_addf(out, "%-*s  %s\n", LEFT, left, o->help);
        }
    }
    cr_str_addf(out, "%-*s  %s\n", LEFT, "  -h, --help", "this text");
}
