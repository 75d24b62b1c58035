/* Completion for shells: what may stand for the last word of a line, from the tables that parse
 * it. */
#include "cli/word.h"

#include "scene/keys.h"

#include <stdio.h>
#include <string.h>

/* the words of a line after that of the program's word; bash parts them at "=" */
struct line {
    const struct cr_usage *usage;
    int n;
    char **word;
    const char *last;           /* the text to complete: a word, or the value of an option */
    const struct cr_option *of; /* option whose value is completed; NULL: a word of its own */
    const char *head;           /* what stands before the value in the last word, "--format=" */
    size_t head_len;
    struct cr_str *out;
};

static const struct cr_option *option_of(const struct cr_usage *usage, const char *word) {
    size_t len = strcspn(word, "=");
    for (int i = 0; i < usage->options; i++) {
        const struct cr_option *o = &usage->option[i];
        bool is_long = strncmp(word, "--", 2) == 0 && strlen(o->name) == len - 2 &&
                       memcmp(o->name, word + 2, len - 2) == 0;
        if (is_long || (len == 2 && word[0] == '-' && o->letter != '\0' && word[1] == o->letter)) {
            return o->flag == NULL ? o : NULL;
        }
    }
    return NULL;
}

static void offer(const struct line *l, const char *text, size_t len, const char *tail) {
    if (strncmp(text, l->last, strlen(l->last)) == 0) {
        cr_str_addn(l->out, l->head, l->head_len);
        cr_str_addn(l->out, text, len);
        cr_str_addf(l->out, "%s\n", tail);
    }
}

static void offer_choices(const struct line *l, const char *choices) {
    for (const char *p = choices; p != NULL;) {
        size_t len = strcspn(p, "|");
        if (len > 0 && len >= strlen(l->last) && strncmp(p, l->last, strlen(l->last)) == 0) {
            offer(l, p, len, "");
        }
        p = p[len] == '|' ? p + len + 1 : NULL;
    }
}

static void offer_keys(const struct line *l, enum cr_key_table table, const char *id,
                       unsigned mask) {
    int n;
    const struct cr_key *key = cr_scene_keys(table, &n);
    for (int i = 0; i < n; i++) {
        char name[2 * CR_NAME_MAX];
        if (id == NULL || key[i].for_kinds == 0 || (key[i].for_kinds & mask) != 0) {
            int len = snprintf(name, sizeof name, "%s%s%s", id != NULL ? id : "",
                               id != NULL ? "." : "", key[i].name);
            offer(l, name, (size_t)len, "=");
        }
    }
}

/* keys of the settings, and of the participants of the first scene file on the line */
static void offer_scene_keys(const struct line *l) {
    offer_keys(l, CR_KEYS_SETTINGS, NULL, 0);
    for (int i = 0; i < l->n - 1; i++) {
        const char *dot = strrchr(l->word[i], '.');
        struct cr_scene scene;
        if (dot == NULL || strcmp(dot, ".json") != 0) {
            continue;
        }
        if (cr_scene_load_draft(l->word[i], &scene, NULL) == CR_ERR_OK) {
            for (int k = 0; k < scene.n; k++) {
                offer_keys(l, CR_KEYS_PARTICIPANT, scene.part[k].id,
                           cr_scene_kind_mask(&scene.part[k]));
            }
            cr_scene_fini(&scene);
            return;
        }
    }
}

static void offer_options(const struct line *l) {
    for (int i = 0; i < l->usage->options; i++) {
        const struct cr_option *o = &l->usage->option[i];
        char name[64];
        int len = snprintf(name, sizeof name, "--%s", o->name);
        offer(l, name, (size_t)len, o->flag == NULL ? "=" : "");
    }
    offer(l, "--help", 6, "");
}

/* whose value the last word is: "--format=te", "--format" "=" "te", "--format" "te", "-f" "te" */
static void look_back(struct line *l) {
    const char *last = l->n > 0 ? l->word[l->n - 1] : "", *equals = strchr(last, '=');
    int back = l->n - 2;
    l->last = last;
    l->head = "";
    if (strcmp(last, "=") == 0) {
        l->last = "";
        l->of = back >= 0 ? option_of(l->usage, l->word[back]) : NULL;
    } else if (last[0] == '-' && equals != NULL) {
        l->of = option_of(l->usage, last);
        l->last = equals + 1;
        l->head = last;
        l->head_len = (size_t)(equals + 1 - last);
    } else if (back >= 0) {
        back -= strcmp(l->word[back], "=") == 0;
        l->of = back >= 0 && strchr(l->word[back], '=') == NULL ? option_of(l->usage, l->word[back])
                                                                : NULL;
    }
}

void cr_cli_complete(const struct cr_usage *usage, int n, char **word, struct cr_str *out) {
    struct line l = {.usage = usage, .n = n, .word = word, .out = out};
    look_back(&l);
    if (l.of != NULL && strchr(l.of->arg, '|') != NULL) {
        offer_choices(&l, l.of->arg);
    } else if (l.of != NULL && strcmp(l.of->arg, "KEY=VALUE") == 0) {
        offer_scene_keys(&l);
    } else if (l.of == NULL && l.last[0] == '-') {
        offer_options(&l);
    } else if (l.of == NULL && usage->candidates != NULL) {
        offer_choices(&l, usage->candidates);
    }
}
