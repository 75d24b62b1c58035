/* Runs lines, typed or standing for a key, and decides whether their answer needs a sheet. */
#include "tui/tui_priv.h"

#include <stdio.h>
#include <string.h>

struct before {
    const struct cr_result *result;
    struct cr_view view;
    int undos, lines;
    const char *file;
};

/* Did the line change what the panes show? Then its answer must not cover them. */
static bool changed(const struct cr_tui *t, const struct before *b) {
    const struct cr_view *v = cr_session_view(t->session);
    return b->result != cr_session_result(t->session) || b->undos != cr_session_undos(t->session) ||
           memcmp(&b->view, v, sizeof *v) != 0;
}

/* Is the answer of the last command on the line to be read, whatever came before it? */
static bool reads(const char *line) {
    static const char *const words[] = {"explain", "solve --step", "compare", "table",
                                        "help",    "check",        "?"};
    const char *last = strrchr(line, ';');
    last = last != NULL ? last + 1 : line;
    last += strspn(last, " \t");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        if (strncmp(last, words[i], strlen(words[i])) == 0) {
            return true;
        }
    }
    return false;
}

static void run(struct cr_tui *t, const char *line) {
    struct before b = {.result = cr_session_result(t->session),
                       .view = *cr_session_view(t->session),
                       .undos = cr_session_undos(t->session),
                       .lines = t->log.n};
    t->cancel = false;
    t->lesson_from = t->paused ? t->lesson_from : -1;
    t->log_back = 0;
    t->sheet_from = -1;
    t->sheet_down = 0;
    cr_completion_fini(&t->candidates);
    cr_preview_forget(t);
    t->failed = cr_session_run(t->session, line) != CR_ERR_OK;
    t->progress = NULL;
    if (t->log.n > b.lines && t->lesson_from < 0 && (t->failed || reads(line) || !changed(t, &b))) {
        t->sheet_from = b.lines - 1; /* with the command itself */
        t->sheet_down = t->failed ? CR_SHEET_END : 0;
    }
    t->dirty = true;
}

/* a line as it was typed, into dialogue and history */
static void show_typed(struct cr_tui *t, const char *line, size_t n, bool first) {
    struct cr_str shown = {0};
    cr_str_add(&shown, first ? "crumple> " : "      -> ");
    cr_str_addn(&shown, line, n);
    for (char *p = shown.s; p != NULL && *p != '\0'; p++) {
        *p = *p == '\n' ? ' ' : *p;
    }
    cr_dialogue_add(&t->log, CR_ROLE_KEY, cr_str_get(&shown));
    if (shown.s != NULL && !shown.failed) {
        cr_history_add(shown.s + CR_PROMPT_W, true);
    }
    cr_str_fini(&shown);
}

void cr_tui_run(struct cr_tui *t, const char *line) {
    if (line[strspn(line, " \t\n")] == '\0') {
        t->sheet_from = -1;
        return;
    }
    /* pasted lines are lines, those that "\\" joins are one */
    const char *from = line, *end = line;
    while (*(end += strcspn(end, "\n")) != '\0') {
        if (end == line || end[-1] != '\\') {
            show_typed(t, from, (size_t)(end - from), from == line);
            from = end + 1;
        }
        end++;
    }
    show_typed(t, from, (size_t)(end - from), from == line);
    run(t, line);
}

void cr_tui_run_key(struct cr_tui *t, const char *line) {
    bool looks = strncmp(line, "show ", 5) == 0 || strncmp(line, "view ", 5) == 0 ||
                 strncmp(line, "play ", 5) == 0;
    if (!t->paused) { /* else it would stand in the words of the lesson */
        cr_dialogue_key(&t->log, line);
    }
    if (!looks) { /* nobody wants a hundred frames back by Up */
        cr_history_add(line, false);
    }
    /* the title bar and the panes show what these change */
    t->mute = looks || strncmp(line, "move ", 5) == 0;
    run(t, line);
    t->mute = false;
}

bool cr_tui_run_quiet(struct cr_tui *t, const char *line) {
    t->mute = true;
    t->cancel = false;
    bool good = cr_session_script(t->session, line, "key", 1) == CR_ERR_OK;
    t->mute = false;
    t->dirty = true;
    return good;
}
