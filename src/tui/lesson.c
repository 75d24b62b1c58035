/* Lessons on the full screen: command files that stop at `pause` until somebody presses Enter. */
#include "tui/tui_priv.h"

#include <curses.h>
#include <stdio.h>
#include <string.h>

/* How a lesson is left or read; what else looks and changes nothing is in the table of keys. */
static const struct {
    bool function;
    wint_t code;
    enum { GO_ON, GIVE_UP, READ } what;
    int rows;
} keys[] = {{false, '\r', GO_ON, 0}, {false, '\n', GO_ON, 0},     {true, KEY_ENTER, GO_ON, 0},
            {false, 3, GIVE_UP, 0},  {true, KEY_PPAGE, READ, -5}, {true, KEY_NPAGE, READ, 5}};

int cr_lesson_lines(struct cr_tui *t, int width) {
    struct cr_dialogue lines;
    if (t->lesson_from < 0 || t->lesson_from > t->log.n) {
        return 0;
    }
    cr_dialogue_fold(&t->log, t->lesson_from, width, &lines);
    t->told = lines.n;
    cr_dialogue_fini(&lines);
    return t->told;
}

int cr_lesson_bar(struct cr_render_key *out, int max) {
    static const struct cr_render_key bar[] = {
        {"Enter", "go on"}, {"^C", "end here"}, {"PgUp PgDn", "read"},
        {"Space", "play"},  {"F7 F8", "slice"}, {"Alt-1..6", "panes"},
        {"< >", "rate"},    {"o", "loop"},      {"i", "start's place"}};
    int n = (int)(sizeof bar / sizeof *bar);
    n = n < max ? n : max;
    memcpy(out, bar, (size_t)n * sizeof *bar);
    return n;
}

/* rows in which the words of the lesson are shown */
static int rows_of(const struct cr_tui *t) {
    const struct cr_rect *log = &t->layout.pane[CR_AREA_LOG];
    return t->layout.dialogue.h > log->h - 2 ? t->layout.dialogue.h : log->h - 2;
}

void cr_lesson_prompt(struct cr_tui *t, struct cr_rect at) {
    int rows = rows_of(t), last = t->lesson_down + rows;
    char text[80] = "Enter goes on, ^C ends the lesson";
    if (t->told > last) {
        snprintf(text, sizeof text, "Enter reads on: %d of %d lines; ^C ends the lesson", last,
                 t->told);
    }
    cr_cells_print(&t->cells, at.x, at.y, at.w, CR_ROLE_KEY, text);
}

bool cr_lesson_key(struct cr_tui *t, const struct cr_input *in) {
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        if (keys[i].function != in->function || keys[i].code != in->code || in->alt) {
            continue;
        }
        int most = t->told > rows_of(t) ? t->told - rows_of(t) : 0;
        if (keys[i].what == READ || (keys[i].what == GO_ON && t->lesson_down < most)) {
            int rows = keys[i].what == READ ? keys[i].rows : rows_of(t) - 1;
            int down = t->lesson_down + rows;
            t->lesson_down = down < 0 ? 0 : down > most ? most : down;
        } else {
            t->given_up = keys[i].what == GIVE_UP;
            t->paused = false;
        }
        t->dirty = true;
        return true;
    }
    return false;
}
