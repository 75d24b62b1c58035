/* A paper as a list of blocks (headings, text, tables, figures, code), written as one HTML file or
 * as pages of a PDF. */
#ifndef CR_REPORT_DOCUMENT_H
#define CR_REPORT_DOCUMENT_H

#include "base/arena.h"
#include "figure/canvas.h"

enum cr_block_kind {
    CR_BLOCK_TITLE,
    CR_BLOCK_HEADING,
    CR_BLOCK_MINOR, /* a heading inside of a section */
    CR_BLOCK_TEXT,
    CR_BLOCK_WARNING,
    CR_BLOCK_TABLE,
    CR_BLOCK_FIGURE,
    CR_BLOCK_CODE,
};
enum { CR_COLUMNS = 10 };

/* A row of a table: marked ones (assumed values) carry a sign in the margin. */
struct cr_doc_row {
    const char *cell[CR_COLUMNS];
    bool head, marked;
};

struct cr_block {
    enum cr_block_kind kind;
    const char *text; /* of a figure: its caption */
    bool quoted;      /* somebody else's words: never told in other units */
    int columns, rows, row_size;
    struct cr_doc_row *row;
    struct cr_canvas *figure; /* owned */
};

/* Memory that runs out is remembered; the writers report it. */
struct cr_document {
    struct cr_arena arena;
    const char *title, *author, *date; /* NULL: none */
    const char *language;              /* "en", "de" */
    bool comma, failed;
    int blocks, block_size;
    struct cr_block *block;
};
void cr_document_fini(struct cr_document *doc);

void cr_doc_add(struct cr_document *doc, enum cr_block_kind kind, const char *text);
void cr_doc_addf(struct cr_document *doc, enum cr_block_kind kind, const char *fmt, ...)
    CR_PRINTF(3, 4);
/* A text kept by the document; with a decimal comma between digits where that is its language. */
const char *cr_doc_text(struct cr_document *doc, const char *fmt, ...) CR_PRINTF(2, 3);
/* A copy of it that the document keeps, as it is. */
const char *cr_doc_keep(struct cr_document *doc, const char *text);
/* A table; its rows follow by cr_doc_row, which copies the cells (NULL: empty). */
void cr_doc_table(struct cr_document *doc, int columns);
struct cr_doc_row *cr_doc_row(struct cr_document *doc, const char *const *cell);
/* Takes the canvas over; NULL is nothing. */
void cr_doc_figure(struct cr_document *doc, struct cr_canvas *figure, const char *caption);

/* Everything but figures and code in US units, where numbers stand before or below a metric one;
 * unit_head: heading of columns that hold the units of their rows. */
void cr_document_us(struct cr_document *doc, const char *unit_head);

/* One file without scripts or anything outside of it, for screen and print. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_document_html(const struct cr_document *doc, struct cr_str *out,
                                           struct cr_error *err);
/* Pages of w x h points. Errors: USAGE in a build without cairo, MEMORY. */
CR_MUST_CHECK enum cr_err cr_document_pdf(const struct cr_document *doc, double w, double h,
                                          struct cr_str *out, struct cr_error *err);

#endif
