/* The dialogue: what was run and what was answered, in the lines that the screen shows. */
#include "tui/tui_priv.h"

#include "render/picture.h"

#include "base/grow.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINES_MAX = 8000, COUNT_ROOM = 24 };

static char *text_of(const struct cr_render_line *line) {
    union {
        const char *shown;
        char *owned;
    } u = {line->text};
    return u.owned;
}

static void forget_older_half(struct cr_dialogue *d) {
    int half = d->n / 2;
    for (int i = 0; i < half; i++) {
        free(text_of(&d->line[i]));
    }
    memmove(d->line, d->line + half, (size_t)(d->n - half) * sizeof *d->line);
    d->n -= half;
}

static void append(struct cr_dialogue *d, enum cr_role role, const char *text, size_t len) {
    if (d->n == LINES_MAX) {
        forget_older_half(d);
    }
    if (!cr_grow(&d->line, &d->size, d->n, sizeof *d->line)) {
        return;
    }
    char *copy = strndup(text, len);
    if (copy != NULL) {
        d->line[d->n++] = (struct cr_render_line){role, copy};
    }
}

void cr_dialogue_add(struct cr_dialogue *d, enum cr_role role, const char *text) {
    free(d->again);
    d->again = NULL;
    append(d, role, text, strlen(text));
}

void cr_dialogue_key(struct cr_dialogue *d, const char *command) {
    bool same = d->again != NULL && d->n > 0 && strcmp(d->again, command) == 0;
    size_t size = strlen(command) + COUNT_ROOM;
    char *text = malloc(size);
    if (text == NULL) {
        return;
    }
    d->repeats = same ? d->repeats + 1 : 1;
    if (same) {
        d->n--;
        free(text_of(&d->line[d->n]));
        snprintf(text, size, "crumple> %s   x %d", command, d->repeats);
    } else {
        snprintf(text, size, "crumple> %s", command);
    }
    append(d, CR_ROLE_KEY, text, strlen(text));
    free(text);
    if (!same) {
        free(d->again);
        d->again = strdup(command);
    }
}

void cr_dialogue_fini(struct cr_dialogue *d) {
    for (int i = 0; i < d->n; i++) {
        free(text_of(&d->line[i]));
    }
    free(d->line);
    free(d->again);
    *d = (struct cr_dialogue){0};
}

/* bytes of the text that fit into so many columns, broken at a blank if there is one */
static size_t fitting(const char *text, int width) {
    const char *p = text, *blank = NULL;
    int used = 0;
    while (*p != '\0') {
        const char *next = p;
        used += cr_glyph_columns(cr_glyph_next(&next));
        if (used > width) {
            return (size_t)((blank != NULL ? blank : p) - text);
        }
        if (*p == ' ' && p > text + width / 2) {
            blank = p;
        }
        p = next;
    }
    return (size_t)(p - text);
}

/* A row of a table, also of its head, is cut rather than folded: its columns would be lost. A word
 * and its explanation have one wide gap between them, a row has several. */
static bool is_row(const char *text) {
    int gaps = 0;
    text += strspn(text, " ");
    bool number = *text >= '0' && *text <= '9';
    while ((text = strstr(text, "   ")) != NULL) {
        text += strspn(text, " ");
        gaps++;
    }
    return gaps >= (number ? 1 : 2);
}

static void fold(const struct cr_render_line *line, int width, struct cr_dialogue *out) {
    const char *rest = line->text;
    if (is_row(rest)) {
        append(out, line->role, rest, strlen(rest));
        return;
    }
    int indent = (int)strspn(rest, " ") + 2;
    size_t n = fitting(rest, width);
    append(out, line->role, rest, n);
    rest += n;
    while (*(rest += strspn(rest, " ")) != '\0' && indent < width - 8) {
        struct cr_str more = {0};
        n = fitting(rest, width - indent);
        n = n > 0 ? n : strlen(rest);
        cr_str_fill(&more, ' ', indent);
        cr_str_addn(&more, rest, n);
        append(out, line->role, cr_str_get(&more), more.len);
        cr_str_fini(&more);
        rest += n;
    }
}

void cr_dialogue_fold(const struct cr_dialogue *d, int from, int width, struct cr_dialogue *out) {
    *out = (struct cr_dialogue){0};
    for (int i = from < 0 ? 0 : from; i < d->n; i++) {
        fold(&d->line[i], width < 10 ? 10 : width, out);
    }
}
