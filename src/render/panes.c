/* Draws frames, title bar, log, key bar and sheets of the full screen. */
#include "render/panes.h"
#include "render/render_priv.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static uint32_t line(const struct cr_look *look, uint32_t ch) {
    return look->ascii ? (uint8_t)cr_glyph_ascii(ch) : ch;
}

static void draw_tabs(struct cr_cells *cells, int x, int y, int end, enum cr_area view) {
    for (int i = 0; i < CR_AREAS && x < end; i++) {
        char text[32];
        bool here = i == (int)view;
        snprintf(text, sizeof text, here ? "[%d %s]" : " %d %s ", i + 1, cr_area_title(i));
        if (x + cr_glyph_width(text) > end) {
            return;
        }
        x += cr_cells_print(cells, x, y, end - x, here ? CR_ROLE_TITLE : CR_ROLE_DIM, text);
    }
}

struct cr_rect cr_render_frame(const struct cr_target *target, const char *title, enum cr_area view,
                               bool active, bool joined) {
    struct cr_cells *cells = target->cells;
    struct cr_rect at = target->at;
    const struct cr_look *look = target->look;
    enum cr_role role = active ? CR_ROLE_KEY : CR_ROLE_FRAME;
    int x0 = joined ? at.x - 1 : at.x, x1 = at.x + at.w - 1, y1 = at.y + at.h - 1;
    if (at.w < 3 || at.h < 3) {
        return at;
    }
    cr_cells_run(cells, x0, at.y, x1 - x0, role, line(look, 0x2500));
    cr_cells_run(cells, x0, y1, x1 - x0, role, line(look, 0x2500));
    for (int y = at.y + 1; y < y1; y++) {
        cr_cells_put(cells, x0, y, role, line(look, 0x2502));
        cr_cells_put(cells, x1, y, role, line(look, 0x2502));
    }
    cr_cells_put(cells, x0, at.y, role, line(look, joined ? 0x252C : 0x250C));
    cr_cells_put(cells, x1, at.y, role, line(look, 0x2510));
    cr_cells_put(cells, x0, y1, role, line(look, joined ? 0x2534 : 0x2514));
    cr_cells_put(cells, x1, y1, role, line(look, 0x2518));
    if (title != NULL) {
        char text[96];
        snprintf(text, sizeof text, " %.90s ", title);
        cr_cells_print(cells, x0 + 1, at.y, x1 - x0 - 1, active ? CR_ROLE_TITLE : CR_ROLE_TEXT,
                       text);
    } else {
        draw_tabs(cells, x0 + 1, at.y, x1, view);
    }
    return (struct cr_rect){x0 + 1, at.y + 1, x1 - x0 - 1, at.h - 2};
}

struct cr_rect cr_render_overlay(struct cr_cells *cells, const struct cr_look *look, int w, int h,
                                 const char *title) {
    w = w + 2 > cells->w ? cells->w : w + 2;
    h = h + 2 > cells->h ? cells->h : h + 2;
    struct cr_rect at = {(cells->w - w) / 2, (cells->h - h) / 2, w, h};
    for (int y = 0; y < h; y++) {
        cr_cells_run(cells, at.x, at.y + y, w, CR_ROLE_TEXT, ' ');
    }
    return cr_render_frame(&(struct cr_target){cells, at, look}, title, CR_AREA_SCENE, true, false);
}

/* ---- title bar ---- */

static const struct {
    const char *word;
    enum cr_role role;
} title_states[CR_TITLE_STATES] = {
    [CR_TITLE_EMPTY] = {"EMPTY", CR_ROLE_DIM},
    [CR_TITLE_UNSOLVED] = {"UNSOLVED", CR_ROLE_WARN},
    [CR_TITLE_EDITED] = {"EDITED", CR_ROLE_WARN},
    [CR_TITLE_SOLVING] = {"SOLVING", CR_ROLE_KEY},
    [CR_TITLE_SOLVED] = {"SOLVED", CR_ROLE_GOOD},
    [CR_TITLE_STALE] = {"STALE", CR_ROLE_WARN},
    [CR_TITLE_FAILED] = {"FAILED", CR_ROLE_BAD},
    [CR_TITLE_INTERRUPTED] = {"INTERRUPTED", CR_ROLE_WARN},
};

struct title_pen {
    struct cr_cells *cells;
    int x, y, end;
};

static void add(struct title_pen *pen, int gap, enum cr_role role, const char *text) {
    if (pen->x + gap + cr_glyph_width(text) <= pen->end) {
        pen->x += gap;
        pen->x += cr_cells_print(pen->cells, pen->x, pen->y, 0, role, text);
    }
}

void cr_render_title(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                     const struct cr_title *title) {
    char text[160];
    bool wide = at.w >= 120;
    struct title_pen pen = {cells, at.x, at.y, at.x + at.w};
    (void)look;
    add(&pen, 1, CR_ROLE_KEY, "crumple");
    snprintf(text, sizeof text, "%.100s%s", title->file != NULL ? title->file : "(no file)",
             title->unsaved ? "*" : "");
    add(&pen, 2, CR_ROLE_TITLE, text);
    if (wide) {
        snprintf(text, sizeof text, "%d vehicle%s, %d object%s", title->vehicles,
                 title->vehicles == 1 ? "" : "s", title->objects, title->objects == 1 ? "" : "s");
        add(&pen, 3, CR_ROLE_TEXT, text);
    }
    snprintf(text, sizeof text, "%s", title_states[title->state].word);
    if (title->state == CR_TITLE_SOLVING && isfinite(title->progress)) {
        snprintf(text, sizeof text, "SOLVING %.0f %%", title->progress * 100);
    }
    add(&pen, wide ? 3 : 2, title_states[title->state].role, text);
    if (isfinite(title->t_end)) {
        snprintf(text, sizeof text, "t %.1f/%.1f ms",
                 (isfinite(title->time) ? title->time : title->t_end) * 1e3, title->t_end * 1e3);
        add(&pen, 2, CR_ROLE_TEXT, text);
        snprintf(text, sizeof text, "frame %d/%d", title->frame, title->frames);
        add(&pen, 2, CR_ROLE_TEXT, text);
    }
    snprintf(text, sizeof text, "dt %g ms", title->dt * 1e3);
    add(&pen, 2, CR_ROLE_DIM, text);
    if (wide && title->field != NULL) {
        snprintf(text, sizeof text, "field %.40s", title->field);
        add(&pen, 3, CR_ROLE_DIM, text);
    }
    if (wide && title->undo > 0) {
        snprintf(text, sizeof text, "undo %d", title->undo);
        add(&pen, 3, CR_ROLE_DIM, text);
    }
    if (wide && title->theme != NULL) {
        snprintf(text, sizeof text, "theme %.30s", title->theme);
        add(&pen, 3, CR_ROLE_DIM, text);
    }
}

/* ---- log, keys, sheet ---- */

void cr_render_log(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                   const struct cr_render_line *line_of, int n, int back) {
    (void)look;
    int most = n > at.h ? n - at.h : 0;
    int first = most - (back < 0 ? 0 : back > most ? most : back);
    for (int i = first; i < n && i - first < at.h; i++) {
        cr_cells_print(cells, at.x, at.y + i - first, at.w, line_of[i].role, line_of[i].text);
    }
}

void cr_render_keys(struct cr_cells *cells, struct cr_rect at, const struct cr_render_key *key,
                    int n) {
    int x = at.x, end = at.x + at.w;
    for (int i = 0; i < n; i++) {
        int w = cr_glyph_width(key[i].key) + 1 + cr_glyph_width(key[i].label);
        if (x + w > end) {
            continue;
        }
        x += cr_cells_print(cells, x, at.y, 0, CR_ROLE_KEY, key[i].key) + 1;
        x += cr_cells_print(cells, x, at.y, 0, CR_ROLE_TEXT, key[i].label) + 2;
    }
}

static const char *sheet_text(const struct cr_sheet *sheet, int row, int column) {
    const char *s = row < 0 ? sheet->head[column] : sheet->cell[row * sheet->columns + column];
    return s != NULL ? s : "";
}

static int sheet_width(const struct cr_sheet *sheet, int column) {
    int width = 0;
    for (int r = -1; r < sheet->rows; r++) {
        int w = cr_glyph_width(sheet_text(sheet, r, column));
        width = w > width ? w : width;
    }
    return width;
}

static void draw_progress(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                          double progress) {
    char text[16];
    snprintf(text, sizeof text, " %3.0f %%", cr_clamp(progress, 0, 1) * 100);
    int room = at.w - 6, done = (int)(room * cr_clamp(progress, 0, 1));
    cr_cells_run(cells, at.x, at.y, done, CR_ROLE_GOOD, look->ascii ? '=' : 0x2501);
    cr_cells_run(cells, at.x + done, at.y, room - done, CR_ROLE_FRAME, look->ascii ? '-' : 0x2500);
    cr_cells_print(cells, at.x + room, at.y, 6, CR_ROLE_TEXT, text);
}

void cr_render_sheet(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                     const struct cr_sheet *sheet) {
    bool bar = isfinite(sheet->progress);
    int foot = (sheet->note != NULL) + bar, rows = at.h - 1 - foot;
    int first = sheet->chosen >= rows ? sheet->chosen - rows + 1 : 0;
    int x = at.x + 2, end = at.x + at.w;
    for (int c = 0; c < sheet->columns && x < end; c++) {
        int w = sheet_width(sheet, c);
        w = x + w > end ? end - x : w;
        cr_cells_print_right(cells, x + w, at.y, w, CR_ROLE_DIM, sheet_text(sheet, -1, c));
        for (int r = first; r < sheet->rows && r - first < rows; r++) {
            cr_cells_print_right(cells, x + w, at.y + 1 + r - first, w,
                                 r == sheet->chosen ? CR_ROLE_TITLE : CR_ROLE_TEXT,
                                 sheet_text(sheet, r, c));
        }
        x += w + 2;
    }
    if (sheet->chosen >= first && sheet->chosen - first < rows && sheet->chosen < sheet->rows) {
        int y = at.y + 1 + sheet->chosen - first;
        cr_cells_put(cells, at.x, y, CR_ROLE_TITLE, '>');
        cr_cells_flag(cells, at.x, y, at.w, CR_CELL_REVERSE);
    }
    int y = at.y + at.h - foot;
    if (bar) {
        draw_progress(cells, (struct cr_rect){at.x, y++, at.w, 1}, look, sheet->progress);
    }
    if (sheet->note != NULL) {
        cr_cells_print(cells, at.x, y, at.w, CR_ROLE_DIM, sheet->note);
    }
}
