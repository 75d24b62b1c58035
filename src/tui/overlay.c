/* What lies over the panes: help, palette, and the sheet above the prompt for long answers and
 * for candidates of a completion. */
#include "tui/tui_priv.h"

#include "render/picture.h"

#include <curses.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>
#include <wctype.h>

enum { ROWS_MAX = 96, KEY_W = 11, HELP_W = 50, PALETTE_W = 76, NAME_W = 12 };

/* ---- help ---- */

static void draw_help(struct cr_tui *t) {
    struct cr_help_row row[ROWS_MAX];
    struct cr_look look = cr_tui_look(t);
    int n = cr_tui_help_rows(t, row, ROWS_MAX), heads = 0, second = 0;
    int room = t->h - 4 > 1 ? t->h - 4 : 1;
    int columns = n > room && t->w >= 76 ? 2 : 1, rows = (n + columns - 1) / columns;
    for (int i = 0; i < n; i++) {
        heads += row[i].heading;
        second = heads == 2 && row[i].heading ? i : second;
    }
    /* one column is what works anywhere, the other what works here, if each fits whole */
    int longer = second > n - second ? second : n - second;
    if (columns == 2 && longer <= room) {
        rows = longer;
    } else {
        second = rows;
    }
    int w = KEY_W + HELP_W;
    w = w * columns + 2 > t->w - 4 ? (t->w - 6) / columns : w;
    rows = rows > room ? room : rows;
    struct cr_rect in =
        cr_render_overlay(&t->cells, &look, w * columns + 2, rows + 1, "Keys   (any key closes)");
    for (int i = 0; i < n && (columns == 2 || i < rows); i++) {
        bool right = columns == 2 && i >= second;
        int x = in.x + 1 + (right ? w : 0), y = in.y + i - (right ? second : 0);
        if (y >= in.y + rows) {
            continue;
        }
        if (row[i].heading) {
            cr_cells_print(&t->cells, x, y, w - 1, CR_ROLE_TITLE, row[i].key);
        } else {
            cr_cells_print(&t->cells, x, y, KEY_W, CR_ROLE_KEY, row[i].key);
            cr_cells_print(&t->cells, x + KEY_W, y, w - KEY_W - 1, CR_ROLE_TEXT, row[i].help);
        }
    }
}

/* ---- palette ---- */

static bool matches(const struct cr_command *c, const char *filter) {
    return filter[0] == '\0' || strstr(c->name, filter) != NULL || strstr(c->help, filter) != NULL;
}

/* commands that pass the filter, those whose name begins with it first */
static int filtered(const struct cr_tui *t, const struct cr_command **out) {
    int total, n = 0;
    const struct cr_command *all = cr_commands(&total);
    size_t len = strlen(t->filter);
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < total && n < ROWS_MAX; i++) {
            bool begins = strncmp(all[i].name, t->filter, len) == 0;
            if (begins == (pass == 0) && matches(&all[i], t->filter)) {
                out[n++] = &all[i];
            }
        }
    }
    return n;
}

static void draw_palette(struct cr_tui *t) {
    const struct cr_command *row[ROWS_MAX];
    struct cr_look look = cr_tui_look(t);
    int n = filtered(t, row), total, width = PALETTE_W < t->w - 4 ? PALETTE_W : t->w - 4;
    char text[CR_FILTER_MAX + 40];
    cr_commands(&total);
    int rows = total < t->h - 6 ? total : t->h - 6;
    struct cr_rect in = cr_render_overlay(&t->cells, &look, width, rows + 1,
                                          "Commands   Enter chooses, Esc closes");
    snprintf(text, sizeof text, "/%s_", t->filter);
    cr_cells_print(&t->cells, in.x + 1, in.y, in.w - 1, CR_ROLE_KEY, text);
    int first = t->chosen >= rows ? t->chosen - rows + 1 : 0;
    for (int i = first; i < n && i - first < in.h - 1; i++) {
        int y = in.y + 1 + i - first;
        cr_cells_print(&t->cells, in.x + 1, y, NAME_W, i == t->chosen ? CR_ROLE_TITLE : CR_ROLE_KEY,
                       row[i]->name);
        cr_cells_print(&t->cells, in.x + 1 + NAME_W, y, in.w - NAME_W - 2, CR_ROLE_TEXT,
                       row[i]->help);
        for (int x = in.x; i == t->chosen && x < in.x + in.w; x++) {
            t->cells.cell[y * t->cells.w + x].flags |= CR_CELL_REVERSE;
        }
    }
}

static void choose_command(struct cr_tui *t) {
    const struct cr_command *row[ROWS_MAX];
    char line[64];
    int n = filtered(t, row);
    t->overlay = CR_OVERLAY_NONE;
    if (t->chosen < n) {
        snprintf(line, sizeof line, "%s ", row[t->chosen]->name);
        cr_prompt_set(line);
        cr_tui_focus(t, CR_AREAS);
    }
}

static void palette_key(struct cr_tui *t, const struct cr_input *in) {
    const struct cr_command *row[ROWS_MAX];
    size_t len = strlen(t->filter);
    if (!in->function && (in->code == '\r' || in->code == '\n')) {
        choose_command(t);
        return;
    }
    if (in->function && (in->code == KEY_DOWN || in->code == KEY_UP)) {
        t->chosen += in->code == KEY_DOWN ? 1 : -1;
    } else if ((in->function && in->code == KEY_BACKSPACE) ||
               (!in->function && (in->code == 127 || in->code == 8))) {
        t->filter[len > 0 ? len - 1 : 0] = '\0';
        t->chosen = 0;
    } else if (!in->function && in->code < 127 && iswprint(in->code) && len + 1 < CR_FILTER_MAX) {
        t->filter[len] = (char)in->code;
        t->filter[len + 1] = '\0';
        t->chosen = 0;
    } else {
        t->overlay = CR_OVERLAY_NONE;
    }
    int n = filtered(t, row);
    t->chosen = t->chosen >= n ? n - 1 : t->chosen;
    t->chosen = t->chosen < 0 ? 0 : t->chosen;
}

bool cr_overlay_input(struct cr_tui *t, const struct cr_input *in) {
    t->dirty = true;
    if (!in->function && (in->code == 26 || in->code == 12)) {
        return false; /* ^Z and ^L mean the same as ever */
    }
    if (t->overlay == CR_OVERLAY_PALETTE && !(in->function && in->code == KEY_MOUSE)) {
        palette_key(t, in);
    } else {
        t->overlay = CR_OVERLAY_NONE;
    }
    return true;
}

void cr_overlay_draw(struct cr_tui *t) {
    if (t->overlay != CR_OVERLAY_NONE && t->layout.kind == CR_LAYOUT_PROMPT) {
        cr_cells_run(&t->cells, 0, 0, t->w, CR_ROLE_TEXT, ' ');
        cr_cells_print(&t->cells, 0, 0, t->w, CR_ROLE_WARN, "Esc; 40x12 shows this");
    } else if (t->overlay == CR_OVERLAY_HELP) {
        draw_help(t);
    } else if (t->overlay == CR_OVERLAY_PALETTE) {
        draw_palette(t);
    }
}

/* ---- sheet ---- */

static void candidate_lines(const struct cr_tui *t, struct cr_dialogue *out) {
    int width = 8;
    *out = (struct cr_dialogue){0};
    for (int i = 0; i < t->candidates.n; i++) {
        int w = cr_glyph_width(t->candidates.item[i].word);
        width = w > width && w < 32 ? w : width;
    }
    for (int i = 0; i < t->candidates.n; i++) {
        const struct cr_candidate *c = &t->candidates.item[i];
        struct cr_str line = {0};
        cr_str_addf(&line, "  %s", c->word);
        cr_str_fill(&line, ' ', width + 2 - cr_glyph_width(c->word));
        cr_str_add(&line, c->help);
        cr_dialogue_add(out, CR_ROLE_TEXT, cr_str_get(&line));
        cr_str_fini(&line);
    }
}

/* rows that the dialogue or the log pane show anyway */
static int rows_shown(const struct cr_tui *t) {
    const struct cr_rect *log = &t->layout.pane[CR_AREA_LOG];
    int frame = t->layout.kind == CR_LAYOUT_PROMPT ? 0 : 2;
    return log->h - frame > t->layout.dialogue.h ? log->h - frame : t->layout.dialogue.h;
}

static void draw_lines(struct cr_tui *t, struct cr_dialogue *lines) {
    int bottom = t->layout.prompt.y, room = bottom - t->layout.title.h - 1;
    int rows = lines->n < room ? lines->n : room;
    int most = lines->n - rows;
    if (rows < 1) {
        return;
    }
    t->sheet_down = t->sheet_down > most ? most : t->sheet_down;
    for (int y = bottom - rows - 1; y < bottom; y++) {
        for (int x = 0; x < t->w; x++) {
            struct cr_cell *cell = &t->cells.cell[y * t->cells.w + x];
            bool rule = y == bottom - rows - 1;
            uint32_t ch = !rule ? ' ' : cr_tui_look(t).ascii ? '-' : 0x2500;
            *cell = (struct cr_cell){.ch = ch, .role = rule ? CR_ROLE_KEY : CR_ROLE_TEXT};
        }
    }
    char text[80];
    snprintf(text, sizeof text,
             most > 0 ? " %d of %d lines, PgUp PgDn; Esc closes " : " Esc closes ", rows, lines->n);
    cr_cells_print(&t->cells, 2, bottom - rows - 1, t->w - 2, CR_ROLE_DIM, text);
    cr_render_log(&t->cells, (struct cr_rect){0, bottom - rows, t->w, rows}, NULL,
                  lines->line + t->sheet_down, rows, 0);
}

void cr_sheet_draw(struct cr_tui *t) {
    struct cr_dialogue lines;
    if (t->overlay != CR_OVERLAY_NONE || t->question != NULL) {
        return;
    }
    if (t->candidates.n > 0) {
        candidate_lines(t, &lines);
        draw_lines(t, &lines);
        cr_dialogue_fini(&lines);
    } else if (t->sheet_from >= 0 && t->sheet_from < t->log.n) {
        cr_dialogue_fold(&t->log, t->sheet_from, t->w, &lines);
        if (lines.n > rows_shown(t)) {
            draw_lines(t, &lines);
        }
        cr_dialogue_fini(&lines);
    }
}
