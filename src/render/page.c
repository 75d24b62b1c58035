/* Adds cells, headings and paragraphs to the page of a report, line by line. */
#include "render/report.h"

#include <stdio.h>
#include <string.h>

enum cr_err cr_page_emit(const struct cr_page *page, struct cr_cells *cells, struct cr_error *err) {
    cr_cells_text(cells, page->look, page->out);
    cr_cells_fini(cells);
    return page->out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the report")
                             : CR_ERR_OK;
}

void cr_page_draw_heading(const struct cr_target *target, const char *title, const char *note) {
    struct cr_cells *c = target->cells;
    int x = target->at.x, y = target->at.y, w = target->at.w;
    int used = cr_glyph_width(title) + 2, n = cr_glyph_width(note), room = w - used - 6;
    cr_cells_run(c, x, y, w, CR_ROLE_FRAME, target->look->ascii ? '-' : 0x2500);
    cr_cells_run(c, x + 2, y, used, CR_ROLE_TEXT, ' ');
    cr_cells_print(c, x + 3, y, w - 4, CR_ROLE_TITLE, title);
    if (n > 0 && room > 8) {
        n = n > room ? room : n;
        cr_cells_run(c, x + w - n - 4, y, n + 2, CR_ROLE_TEXT, ' ');
        cr_cells_print(c, x + w - n - 3, y, n, CR_ROLE_DIM, note);
    }
}

enum cr_err cr_page_heading(const struct cr_page *page, const char *title, const char *note,
                            struct cr_error *err) {
    struct cr_cells c;
    enum cr_err code = cr_cells_new(page->width, 2, &c, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_page_draw_heading(&(struct cr_target){&c, {0, 1, page->width, 1}, page->look}, title, note);
    return cr_page_emit(page, &c, err);
}

enum cr_err cr_page_paragraph(const struct cr_page *page, int indent, enum cr_role role,
                              const char *text, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    struct cr_str shown = {0};
    int at = 1;
    cr_units_text(page->result->units, text, &shown);
    page->out->failed = page->out->failed || shown.failed;
    text = cr_str_get(&shown);
    while (*text != '\0' && code == CR_ERR_OK) {
        struct cr_cells c;
        int room = page->width - at, used = 0, w = 0;
        const char *end = text, *s = text, *brk = NULL;
        while (*s != '\0') {
            if (*s == ' ') {
                brk = s;
            }
            w = cr_glyph_columns(cr_glyph_next(&s));
            if (used + w > room) {
                break;
            }
            used += w;
            end = s;
        }
        end = *end == '\0' || brk == NULL || brk == text ? end : brk;
        char line[1024];
        snprintf(line, sizeof line, "%.*s", (int)(end - text), text);
        code = cr_cells_new(page->width, 1, &c, err);
        if (code == CR_ERR_OK) {
            cr_cells_print(&c, at, 0, 0, role, line);
            code = cr_page_emit(page, &c, err);
        }
        text = end;
        while (*text == ' ') {
            text++;
        }
        at = 1 + indent;
    }
    cr_str_fini(&shown);
    return code;
}
