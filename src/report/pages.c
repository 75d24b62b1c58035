/* Lays a paper out on pages: lines are folded, tables broken between rows, figures kept whole. */
#include "report/document.h"

#include "base/grow.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MARGIN = 48, FOOT = 30, PAGES_MOST = 2000, LINE_MOST = 2000, CAPTION = 30 };
enum { INK = 0x1a1a1a, INK_DIM = 0x5a5a5a, INK_RULE = 0x808080, INK_HAIR = 0xdedede };
enum { INK_WARN = 0xb00000, INK_ASSUMED = 0xd55e00, INK_CODE = 0xf6f6f6 };

struct layout {
    const struct cr_document *doc;
    double w, h, y; /* size of the page, and where the next line begins, points */
    int pages, size;
    struct cr_canvas **page;
    bool failed;
};

static double inner(const struct layout *l) {
    return l->w - 2 * MARGIN;
}

static struct cr_canvas *page(const struct layout *l) {
    return l->page[l->pages - 1];
}

static bool new_page(struct layout *l) {
    bool room =
        l->pages < PAGES_MOST && cr_grow(&l->page, &l->size, l->pages, sizeof(struct cr_canvas *));
    struct cr_canvas *c = room ? cr_canvas_new(l->w, l->h) : NULL;
    if (c == NULL) {
        l->failed = true;
        return false;
    }
    l->page[l->pages++] = c;
    l->y = MARGIN;
    return true;
}

static double bottom(const struct layout *l) {
    return l->h - MARGIN - FOOT + 18;
}

/* Begins a new page unless so much room is left; false when there can be none. */
static bool need(struct layout *l, double h) {
    return l->y + h <= bottom(l) || new_page(l);
}

/* ---- lines ---- */

static int letter_length(const char *s) {
    unsigned char c = (unsigned char)*s;
    int n = c < 0x80 ? 1 : c < 0xE0 ? 2 : c < 0xF0 ? 3 : 4;
    for (int i = 1; i < n; i++) {
        if (s[i] == '\0') {
            return i;
        }
    }
    return n;
}

/* The length in bytes of the next line of a text that fits a width: it ends at a newline, at a
 * blank, or in the middle of a word that is too long by itself. *skip is that of the blank or
 * newline after it. */
static int next_line(const char *s, const struct cr_type_face *face, double width, int *skip) {
    char line[LINE_MOST];
    int n = 0, blank = -1;
    *skip = 0;
    while (s[n] != '\0' && s[n] != '\n' && n < LINE_MOST - 8) {
        int k = letter_length(s + n);
        memcpy(line + n, s + n, (size_t)k);
        line[n + k] = '\0';
        if (n > 0 && cr_text_width(face, line) > width) {
            bool fold = blank > 0;
            *skip = fold;
            return fold ? blank : n;
        }
        blank = s[n] == ' ' ? n : blank;
        n += k;
    }
    *skip = s[n] == '\n';
    return n;
}

static int count_lines(const char *s, const struct cr_type_face *face, double width) {
    int n = 0, skip;
    do {
        s += next_line(s, face, width, &skip);
        s += skip;
        n++;
    } while (*s != '\0');
    return n;
}

/* Puts one line of a text, n bytes, onto a page. */
static void put_line(struct cr_canvas *c, double x, double y, const struct cr_type_face *face,
                     const char *s, int n) {
    char line[LINE_MOST];
    snprintf(line, sizeof line, "%.*s", n, s);
    cr_canvas_text(c, x, y, face, line);
}

static void rule(struct cr_canvas *c, double x0, double y, double x1, uint32_t ink) {
    cr_canvas_move(c, x0, y);
    cr_canvas_line(c, x1, y);
    cr_canvas_paint(c, &(struct cr_paint){.fill = CR_NO_INK, .line = ink, .width = 0.6});
}

static void bar(struct cr_canvas *c, double x, double y, double h, uint32_t ink) {
    cr_canvas_rect(c, x, y, 2, h);
    cr_canvas_paint(c, &(struct cr_paint){.fill = ink, .line = CR_NO_INK});
}

/* Puts a text, folded to the width, on as many pages as it takes. */
static void put_text(struct layout *l, const struct cr_block *b, const struct cr_type_face *face,
                     double lead, double indent) {
    const char *s = b->text;
    do {
        int skip, n = next_line(s, face, inner(l) - indent, &skip);
        if (!need(l, lead)) {
            return;
        }
        if (b->kind == CR_BLOCK_CODE) {
            cr_canvas_rect(page(l), MARGIN, l->y, inner(l), lead);
            cr_canvas_paint(page(l), &(struct cr_paint){.fill = INK_CODE, .line = CR_NO_INK});
        }
        if (b->kind == CR_BLOCK_WARNING) {
            bar(page(l), MARGIN, l->y, lead, INK_WARN);
        }
        put_line(page(l), MARGIN + indent, l->y + 0.78 * lead, face, s, n);
        l->y += lead;
        s += n + skip;
    } while (*s != '\0');
}

/* ---- tables ---- */

enum { CELL_PAD = 6 };
static const double cell_size = 8.5, cell_lead = 11;

static struct cr_type_face cell_face(bool head) {
    return (struct cr_type_face){.size = cell_size, .ink = INK, .bold = head};
}

/* Makes each column as wide as its longest cell; if that is too much, the widest get narrower. */
static void column_widths(const struct layout *l, const struct cr_block *b, double *w) {
    double sum = 0;
    for (int k = 0; k < b->columns; k++) {
        w[k] = 10;
        for (int i = 0; i < b->rows; i++) {
            struct cr_type_face face = cell_face(b->row[i].head);
            w[k] = fmax(w[k], cr_text_width(&face, b->row[i].cell[k]) + CELL_PAD + 1);
        }
        sum += w[k];
    }
    for (int round = 0; round < 200 && sum > inner(l); round++) {
        int widest = 0;
        for (int k = 1; k < b->columns; k++) {
            widest = w[k] > w[widest] ? k : widest;
        }
        double less = fmin(sum - inner(l), 0.1 * w[widest]);
        w[widest] -= less;
        sum -= less;
    }
}

static double row_height(const struct cr_block *b, int i, const double *w) {
    int most = 1;
    struct cr_type_face face = cell_face(b->row[i].head);
    for (int k = 0; k < b->columns; k++) {
        int n = count_lines(b->row[i].cell[k], &face, w[k] - CELL_PAD);
        most = n > most ? n : most;
    }
    return most * cell_lead + 3;
}

static void put_row(struct layout *l, const struct cr_block *b, int i, const double *w) {
    const struct cr_doc_row *r = &b->row[i];
    struct cr_type_face face = cell_face(r->head);
    double x = MARGIN, h = row_height(b, i, w);
    if (r->marked) {
        bar(page(l), MARGIN - 5, l->y + 1, h - 2, INK_ASSUMED);
    }
    for (int k = 0; k < b->columns; k++) {
        const char *s = r->cell[k];
        double y = l->y + 9.5;
        do {
            int skip, n = next_line(s, &face, w[k] - CELL_PAD, &skip);
            put_line(page(l), x, y, &face, s, n);
            y += cell_lead;
            s += n + skip;
        } while (*s != '\0');
        x += w[k];
    }
    l->y += h;
    rule(page(l), MARGIN, l->y - 0.5, x, r->head ? INK_RULE : INK_HAIR);
}

static void table(struct layout *l, const struct cr_block *b) {
    double w[CR_COLUMNS];
    column_widths(l, b, w);
    l->y += 4;
    for (int i = 0; i < b->rows && !l->failed; i++) {
        double h = row_height(b, i, w);
        int pages = l->pages;
        /* A head is not left alone at the foot of a page. */
        bool next = b->row[i].head && i + 1 < b->rows;
        if (!need(l, next ? h + row_height(b, i + 1, w) : h)) {
            return;
        }
        if (l->pages > pages && !b->row[i].head && b->row[0].head) {
            put_row(l, b, 0, w);
        }
        put_row(l, b, i, w);
    }
    l->y += 8;
}

/* The scale, at most 1, at which a figure fits a page with its caption. */
static double figure_scale(const struct layout *l, const struct cr_block *b) {
    double most = l->h - 2 * MARGIN - FOOT - CAPTION;
    return fmin(1, fmin(inner(l) / cr_canvas_w(b->figure), most / cr_canvas_h(b->figure)));
}

/* The least height, with the caption, at which the words of a figure can still be read. */
static double least_height(const struct layout *l, const struct cr_block *b) {
    return 0.8 * figure_scale(l, b) * cr_canvas_h(b->figure) + CAPTION;
}

static void figure(struct layout *l, const struct cr_block *b) {
    struct cr_type_face face = {.size = 8.5, .ink = INK_DIM};
    if (!need(l, least_height(l, b))) {
        return;
    }
    double left = bottom(l) - l->y - CAPTION, high = cr_canvas_h(b->figure);
    double k = fmin(figure_scale(l, b), left / high), h = k * high;
    cr_canvas_place(page(l), b->figure, MARGIN, l->y, k);
    l->y += h;
    struct cr_block caption = {.kind = CR_BLOCK_TEXT, .text = b->text};
    put_text(l, &caption, &face, 11, 0);
    l->y += 8;
}

/* ---- headings ---- */

static const struct {
    double size, before, after;
} looks[] = {{18, 0, 8}, {13, 16, 6}, {10.5, 8, 2}}; /* of title, heading, minor */

/* The room for a heading, the headings below it and the begin of the block that they head. */
static double with_first(const struct layout *l, int block) {
    const struct cr_block *b = &l->doc->block[block];
    double w[CR_COLUMNS];
    switch (b->kind) {
    case CR_BLOCK_TITLE:
    case CR_BLOCK_HEADING:
    case CR_BLOCK_MINOR:
        return looks[b->kind].before + 1.25 * looks[b->kind].size + looks[b->kind].after +
               (block + 1 < l->doc->blocks ? with_first(l, block + 1) : 0);
    case CR_BLOCK_TABLE:
        column_widths(l, b, w);
        return 4 + (b->rows > 0 ? row_height(b, 0, w) : 0) +
               (b->rows > 1 ? row_height(b, 1, w) : 0);
    case CR_BLOCK_FIGURE:
        return least_height(l, b);
    default: { /* a text stays with the figure that follows it */
        bool figure = block + 1 < l->doc->blocks && b[1].kind == CR_BLOCK_FIGURE;
        return 40 + (figure ? least_height(l, b + 1) : 0);
    }
    }
}

static void heading(struct layout *l, int block) {
    const struct cr_block *b = &l->doc->block[block];
    struct cr_type_face face = {.size = looks[b->kind].size, .ink = INK, .bold = true};
    double room = with_first(l, block);
    l->y += l->y > MARGIN ? looks[b->kind].before : 0;
    if (!need(l, room - looks[b->kind].before)) {
        return;
    }
    put_text(l, b, &face, 1.25 * face.size, 0);
    if (b->kind == CR_BLOCK_HEADING) {
        rule(page(l), MARGIN, l->y + 1, l->w - MARGIN, INK_RULE);
    }
    l->y += looks[b->kind].after;
}

/* ---- all ---- */

static void lay_out(struct layout *l) {
    for (int i = 0; i < l->doc->blocks && !l->failed; i++) {
        const struct cr_block *b = &l->doc->block[i];
        struct cr_type_face text = {.size = 9.5, .ink = INK}, code = {.size = 6.8, .ink = INK};
        code.mono = true;
        switch (b->kind) {
        case CR_BLOCK_TITLE:
        case CR_BLOCK_HEADING:
        case CR_BLOCK_MINOR:
            heading(l, i);
            break;
        case CR_BLOCK_TEXT:
            put_text(l, b, &text, 13, 0);
            l->y += 4;
            break;
        case CR_BLOCK_WARNING:
            put_text(l, b, &text, 13, 8);
            l->y += 4;
            break;
        case CR_BLOCK_TABLE:
            table(l, b);
            break;
        case CR_BLOCK_FIGURE:
            figure(l, b);
            break;
        case CR_BLOCK_CODE:
            put_text(l, b, &code, 8.6, 4);
            l->y += 8;
            break;
        }
    }
}

static void feet(const struct layout *l) {
    struct cr_type_face face = {.size = 8, .ink = INK_DIM};
    for (int i = 0; i < l->pages; i++) {
        char text[48];
        double y = l->h - 28;
        snprintf(text, sizeof text, "%d / %d", i + 1, l->pages);
        face.anchor = CR_ANCHOR_START;
        cr_canvas_text(l->page[i], MARGIN, y, &face, l->doc->title);
        face.anchor = CR_ANCHOR_END;
        cr_canvas_text(l->page[i], l->w - MARGIN, y, &face, text);
    }
}

enum cr_err cr_document_pdf(const struct cr_document *doc, double w, double h, struct cr_str *out,
                            struct cr_error *err) {
    struct layout l = {.doc = doc, .w = w, .h = h};
    struct cr_pdf_about about = {.title = doc->title, .author = doc->author, .date = doc->date};
    enum cr_err code = CR_ERR_OK;
    if (new_page(&l)) {
        lay_out(&l);
        feet(&l);
    }
    if (l.failed && l.pages == PAGES_MOST) {
        cr_err_set(err, CR_ERR_RANGE, "the report has more than %d pages", PAGES_MOST);
        cr_err_hint(err, "write it as .html");
        code = CR_ERR_RANGE;
    } else if (l.failed || doc->failed) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the report");
    } else {
        code = cr_canvas_pdf(l.page, l.pages, &about, out, err);
    }
    for (int i = 0; i < l.pages; i++) {
        cr_canvas_free(l.page[i]);
    }
    free(l.page);
    return code;
}
