/* Completion: what may stand at the cursor, from the command table and the live session. */
#include "cmd/cmd_priv.h"

#include "base/grow.h"
#include "base/show.h"
#include "catalogue/catalogue.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

/* where the cursor is in the line */
struct cursor {
    struct cr_session *s;
    struct cr_completion *out;
    char word[CR_PATH_MAX]; /* what is typed of the word so far */
    char raw[CR_PATH_MAX];  /* the same with its quotes */
    bool failed;
};

static void add(struct cursor *c, const char *word, const char *help, char end) {
    struct cr_completion *out = c->out;
    if (strncmp(word, c->word, strlen(c->word)) != 0) {
        return;
    }
    if (!cr_grow(&out->item, &out->size, out->n, sizeof *out->item)) {
        c->failed = true;
        return;
    }
    struct cr_candidate item = {strdup(word), strdup(help != NULL ? help : ""), end};
    out->item[out->n++] = item;
    c->failed = c->failed || item.word == NULL || item.help == NULL;
}

void cr_completion_fini(struct cr_completion *completion) {
    for (int i = 0; i < completion->n; i++) {
        free(completion->item[i].word);
        free(completion->item[i].help);
    }
    free(completion->item);
    *completion = (struct cr_completion){0};
}

/* ---- candidates by type ---- */

static void add_words(struct cursor *c, const char *words) {
    char buf[64];
    for (int i = 0; i < cr_cmd_words(words); i++) {
        add(c, cr_cmd_word_at(words, i, buf, sizeof buf), "", ' ');
    }
}

/* the number typed so far with each unit of its dimension */
static void add_units(struct cursor *c, enum cr_dim dim) {
    const char *end;
    const struct cr_unit *unit;
    char word[CR_PATH_MAX + 16];
    cr_number_scan(c->word, &end);
    if (end == c->word) {
        return;
    }
    for (int i = 0; (unit = cr_unit_nth(dim, i)) != NULL; i++) {
        snprintf(word, sizeof word, "%.*s%s", (int)(end - c->word), c->word, unit->name);
        if (unit->name[0] != '\0') {
            add(c, word, cr_dim_word(dim), ' ');
        }
    }
}

struct car_words {
    struct cursor *c;
    const char *quote, *begin;
};

/* What is typed of the word stays as it is; a year closes the quotation. */
static void add_car_word(void *user, const char *word, bool year) {
    const struct car_words *w = user;
    char text[CR_PATH_MAX + 64];
    snprintf(text, sizeof text, "%s%s%s", w->quote, w->begin, word + strlen(w->begin));
    add(w->c, text, year ? "model year" : "", year ? '"' : ' ');
}

/* "make model year", the last of the words that stand there already may be begun */
static void add_cars(struct cursor *c) {
    const struct cr_catalogue *cars;
    const char *blank = strrchr(c->raw, ' '), *last = blank != NULL ? blank + 1 : c->raw;
    struct car_words w = {c, blank != NULL ? "" : "\"", last + (last[0] == '"')};
    char said[CR_PATH_MAX];
    if (cr_session_need_models(c->s, NULL) != CR_ERR_OK ||
        cr_model_catalogue(c->s->models, &cars, NULL) != CR_ERR_OK) {
        return;
    }
    snprintf(said, sizeof said, "%.*s", (int)(last - c->raw), c->raw);
    c->out->start += (int)(last - c->raw);
    c->word[0] = '\0'; /* the catalogue looks whether they fit */
    cr_catalogue_complete(cars, said, w.begin, add_car_word, &w);
}

static void add_key_values(struct cursor *c, const struct cr_key *key) {
    if (key == NULL) {
        return;
    }
    if (strcmp(key->name, "car") == 0) {
        add_cars(c);
    } else if (key->type == CR_KEY_WORD) {
        for (size_t i = 0; i < key->aux; i++) {
            add(c, key->words[i], "", ' ');
        }
    } else if (key->type == CR_KEY_SWITCH || key->type == CR_KEY_BOOL ||
               key->type == CR_KEY_LOCKED) {
        add_words(c, "on|off");
    } else {
        if (key->type == CR_KEY_PDOF ? key->aux == 0
                                     : key->type == CR_KEY_NUMBER && key->aux != 0) {
            add(c, "auto", "", ' ');
        }
        add_units(c, key->dim);
    }
}

static void add_names(struct cursor *c, bool vehicles_only) {
    const struct cr_scene *scene = cr_session_scene(c->s);
    char help[80];
    for (int i = 0; i < scene->n; i++) {
        const struct cr_participant *p = &scene->part[i];
        if (p->kind == CR_KIND_VEHICLE) {
            snprintf(help, sizeof help, "%s, %.0f kg, %.1f km/h", cr_type_word(p->type), p->mass,
                     cr_kmh(p->speed));
            add(c, p->id, help, ' ');
        } else if (!vehicles_only) {
            add(c, p->id, cr_scene_kind_word(cr_scene_kind_mask(p)), ' ');
        }
    }
}

/* Whether a name ends in one of the suffixes, in either case; ".nnn" are three digits or more, as a
 * channel of a crash test has them. */
static bool has_suffix(const char *name, const char *suffixes) {
    char suffix[16];
    const char *dot = strrchr(name, '.');
    size_t n = strlen(name), digits = dot != NULL ? strspn(dot + 1, "0123456789") : 0;
    bool channel = digits >= 3 && dot[1 + digits] == '\0';
    for (int i = 0; i < cr_cmd_words(suffixes); i++) {
        size_t k = strlen(cr_cmd_word_at(suffixes, i, suffix, sizeof suffix));
        if (strcmp(suffix, ".nnn") == 0 ? channel
                                        : n >= k && strcasecmp(name + n - k, suffix) == 0) {
            return true;
        }
    }
    return false;
}

static void add_file(struct cursor *c, const char *folder, const char *name, const char *suffixes) {
    char path[2 * CR_PATH_MAX], word[2 * CR_PATH_MAX];
    struct stat st;
    snprintf(word, sizeof word, "%s%s", folder, name);
    snprintf(path, sizeof path, "%s%s", folder[0] != '\0' ? folder : "./", name);
    if (strpbrk(word, " \t\"#;=\\") != NULL || !cr_show_fits(word) || stat(path, &st) != 0) {
        return; /* it could not be typed as one word */
    }
    if (S_ISDIR(st.st_mode)) {
        strncat(word, "/", sizeof word - strlen(word) - 1);
        add(c, word, "folder", '\0');
    } else if (has_suffix(name, suffixes)) {
        add(c, word, "", ' ');
    }
}

static void add_files(struct cursor *c, const char *suffixes) {
    char folder[CR_PATH_MAX] = "";
    const char *slash = strrchr(c->word, '/');
    if (slash != NULL) {
        snprintf(folder, sizeof folder, "%.*s", (int)(slash + 1 - c->word), c->word);
    }
    const char *base = slash != NULL ? slash + 1 : c->word;
    struct dirent **entry;
    int n = scandir(folder[0] != '\0' ? folder : ".", &entry, NULL, alphasort);
    for (int i = 0; i < n; i++) {
        bool hidden = entry[i]->d_name[0] == '.' && base[0] != '.';
        if (!hidden && strcmp(entry[i]->d_name, ".") != 0 && strcmp(entry[i]->d_name, "..") != 0) {
            add_file(c, folder, entry[i]->d_name, suffixes);
        }
        free(entry[i]);
    }
    if (n >= 0) {
        free(entry);
    }
}

static void add_models(struct cursor *c) {
    char word[64];
    bool clocks = strchr(c->word, '/') != NULL;
    for (int t = 0; t < CR_TYPES; t++) {
        const char *type = cr_type_word((enum cr_type)t);
        add(c, type, "direction of force chosen by the program", ' ');
        for (int clock = 1; clocks && clock <= 12; clock++) {
            snprintf(word, sizeof word, "%s/%d", type, clock);
            add(c, word, clock == 12 ? "from the front" : clock == 6 ? "from the rear" : "", ' ');
        }
    }
    add_files(c, ".json|.csv");
}

static void add_sweeps(struct cursor *c) {
    const struct cr_scene *scene = cr_session_scene(c->s);
    char word[CR_NAME_MAX + 48];
    for (int i = 0; i < scene->n; i++) {
        for (int k = 0; cr_sweep_keys[k].name != NULL; k++) {
            const struct cr_sweep_key *key = &cr_sweep_keys[k];
            bool fits = key->kinds == 0 || (key->kinds & cr_scene_kind_mask(&scene->part[i])) != 0;
            snprintf(word, sizeof word, "%s.%s", scene->part[i].id, key->name);
            if (fits && !key->setting) {
                add(c, word, key->help, ' ');
            }
        }
    }
    for (int k = 0; cr_sweep_keys[k].name != NULL; k++) {
        if (cr_sweep_keys[k].setting) {
            add(c, cr_sweep_keys[k].name, cr_sweep_keys[k].help, ' ');
        }
    }
}

static void add_commands(struct cursor *c) {
    int n;
    const struct cr_command *table = cr_commands(&n);
    for (int i = 0; i < n; i++) {
        add(c, table[i].name, table[i].help, ' ');
    }
}

static void add_terms(struct cursor *c) {
    const char *title, *name;
    add(c, "glossary", "the terms", ' ');
    add(c, "units", "all units", ' ');
    for (int i = 0; (name = cr_glossary_name(i, &title)) != NULL; i++) {
        add(c, name, title, ' ');
    }
}

static void add_values(struct cursor *c, const struct cr_arg *arg) {
    switch (arg->type) {
    case CR_VALUE_KEY:
        add_key_values(c, cr_arg_key(arg));
        break;
    case CR_VALUE_NUMBER:
    case CR_VALUE_TIME:
        add_words(c, arg->words);
        add_units(c, arg->dim);
        break;
    case CR_VALUE_WORD:
    case CR_VALUE_STEM:
    case CR_VALUE_SWITCH:
        add_words(c, arg->words);
        break;
    case CR_VALUE_NAME:
    case CR_VALUE_VEHICLE:
        add_names(c, arg->type == CR_VALUE_VEHICLE);
        add_words(c, arg->words);
        break;
    case CR_VALUE_NEW:
        add_names(c, false);
        break;
    case CR_VALUE_FILE:
        add_files(c, arg->words);
        break;
    case CR_VALUE_MODEL:
        add_models(c);
        break;
    case CR_VALUE_COMMAND:
        add_commands(c);
        add_terms(c);
        break;
    case CR_VALUE_SWEEP:
        add_sweeps(c);
        break;
    case CR_VALUE_COUNT:
    case CR_VALUE_TEXT:
    case CR_VALUE_POINT:
        break;
    }
}

/* ---- where the cursor is ---- */

/* the statement under the cursor, its command and which arguments stand before the cursor */
struct place {
    struct cr_tokens tokens;
    char *text; /* the line up to the cursor */
    int word;   /* index of the word at the cursor, tokens.n for a new one */
    const struct cr_command *cmd;
    bool given[CR_CMD_ARGS];
    const struct cr_arg *arg; /* the argument at the cursor, NULL: a key or nothing fits */
};

static const struct cr_arg *arg_of(const struct cr_command *cmd, const char *name,
                                   enum cr_arg_place where) {
    const struct cr_arg *found = NULL;
    for (int i = 0; cmd->arg[i].name != NULL; i++) {
        if (cmd->arg[i].place != where) {
            continue;
        }
        if (strcmp(cmd->arg[i].name, name) == 0) {
            return &cmd->arg[i];
        }
        if (strncmp(cmd->arg[i].name, name, strlen(name)) == 0) {
            found = found == NULL ? &cmd->arg[i] : found;
        }
    }
    return found;
}

/* the position that a bare word at this point fills, NULL if all are filled */
static const struct cr_arg *open_position(const struct place *p) {
    for (int i = 0; p->cmd->arg[i].name != NULL; i++) {
        enum cr_arg_place where = p->cmd->arg[i].place;
        bool bare = where == CR_ARG_POSITION || where == CR_ARG_OPTION || where == CR_ARG_REST;
        if (bare && !p->given[i]) {
            return &p->cmd->arg[i];
        }
    }
    return NULL;
}

static void mark_given(struct place *p, const struct cr_token *tok) {
    const struct cr_arg *arg = tok->kind == CR_TOKEN_PAIR   ? arg_of(p->cmd, tok->key, CR_ARG_KEY)
                               : tok->kind == CR_TOKEN_FLAG ? arg_of(p->cmd, tok->text, CR_ARG_FLAG)
                                                            : open_position(p);
    if (arg != NULL && arg->place != CR_ARG_REST) {
        p->given[arg - p->cmd->arg] = true;
    }
}

static enum cr_err read_line(struct place *p, const char *line, int point, struct cr_error *err) {
    *p = (struct place){.text = calloc((size_t)point + 2, 1)};
    if (p->text == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    memcpy(p->text, line, (size_t)point);
    int at = 0;
    for (;;) {
        enum cr_err code = cr_cmd_tokens(p->text, at, &p->tokens, err);
        if (code == CR_ERR_SYNTAX && (int)strlen(p->text) == point) {
            cr_cmd_tokens_fini(&p->tokens);
            p->text[point] = '"'; /* perhaps the cursor stands in an open quotation */
            continue;
        }
        if (code != CR_ERR_OK || p->tokens.next >= point || p->tokens.next == p->tokens.end) {
            p->word = p->tokens.n;
            return code;
        }
        at = p->tokens.next;
        cr_cmd_tokens_fini(&p->tokens);
    }
}

static void place_fini(struct place *p) {
    cr_cmd_tokens_fini(&p->tokens);
    free(p->text);
}

/* finds the word at the cursor, the command and the argument */
static enum cr_err find_place(struct place *p, const char *line, int point, struct cr_error *err) {
    enum cr_err code = read_line(p, line, point, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (p->tokens.n > 0) {
        const struct cr_token *last = &p->tokens.tok[p->tokens.n - 1];
        bool touches = last->at + last->len >= point;
        p->word = p->tokens.n - (touches ? 1 : 0);
    }
    if (p->word == 0) {
        return CR_ERR_OK;
    }
    char name[64];
    snprintf(name, sizeof name, "%s", p->tokens.tok[0].text);
    size_t n = strlen(name);
    if (n > 1 && name[n - 1] == '!') {
        name[n - 1] = '\0';
    }
    p->cmd = cr_command_find(name, NULL);
    for (int i = 1; p->cmd != NULL && i < p->word; i++) {
        mark_given(p, &p->tokens.tok[i]);
    }
    const struct cr_token *tok = p->word < p->tokens.n ? &p->tokens.tok[p->word] : NULL;
    if (p->cmd != NULL) {
        p->arg = tok != NULL && tok->kind == CR_TOKEN_PAIR ? arg_of(p->cmd, tok->key, CR_ARG_KEY)
                                                           : open_position(p);
    }
    return CR_ERR_OK;
}

static void add_keys_and_flags(struct cursor *c, const struct place *p) {
    char word[64];
    for (int i = 0; p->cmd->arg[i].name != NULL; i++) {
        const struct cr_arg *arg = &p->cmd->arg[i];
        if (p->given[i] || (arg->place != CR_ARG_KEY && arg->place != CR_ARG_FLAG)) {
            continue;
        }
        struct cr_str help = {0};
        cr_arg_help(arg, &help);
        bool key = arg->place == CR_ARG_KEY;
        snprintf(word, sizeof word, "%s%s%s", key ? "" : "--", arg->name, key ? "=" : "");
        if (key || c->word[0] == '-' || p->word > 0) {
            add(c, word, cr_str_get(&help), key ? '\0' : ' ');
        }
        cr_str_fini(&help);
    }
}

enum cr_err cr_session_complete(struct cr_session *s, const char *line, int point,
                                struct cr_completion *out, struct cr_error *err) {
    struct cursor c = {.s = s, .out = out};
    struct place p;
    *out = (struct cr_completion){.start = point, .end = point};
    enum cr_err code = find_place(&p, line, point, err);
    if (code != CR_ERR_OK) {
        place_fini(&p);
        return code == CR_ERR_SYNTAX ? CR_ERR_OK : code;
    }
    const struct cr_token *tok = p.word < p.tokens.n ? &p.tokens.tok[p.word] : NULL;
    if (tok != NULL) {
        bool pair = tok->kind == CR_TOKEN_PAIR;
        out->start = pair ? tok->value_at : tok->at;
        snprintf(c.word, sizeof c.word, "%s%s", tok->kind == CR_TOKEN_FLAG ? "--" : "", tok->text);
        snprintf(c.raw, sizeof c.raw, "%.*s", point - out->start, line + out->start);
    }
    if (p.word == 0) {
        add_commands(&c);
    } else if (p.cmd != NULL) {
        if (p.arg != NULL) {
            add_values(&c, p.arg);
        }
        if (tok == NULL || tok->kind != CR_TOKEN_PAIR) {
            add_keys_and_flags(&c, &p);
        }
    }
    place_fini(&p);
    if (c.failed) {
        cr_completion_fini(out);
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    return CR_ERR_OK;
}

void cr_session_hint(struct cr_session *s, const char *line, int point, struct cr_str *out) {
    struct place p;
    (void)s;
    if (find_place(&p, line, point, NULL) == CR_ERR_OK && p.tokens.n > 0) {
        const struct cr_command *cmd =
            p.cmd != NULL ? p.cmd : cr_command_find(p.tokens.tok[0].text, NULL);
        if (cmd != NULL) {
            cr_command_usage(cmd, out);
            cr_str_add(out, "\n");
        }
        if (cmd != NULL && p.arg != NULL) {
            cr_str_addf(out, "%s: ", p.arg->name);
            cr_arg_help(p.arg, out);
        } else if (cmd != NULL) {
            cr_str_add(out, cmd->help);
        }
    }
    place_fini(&p);
}
