/* A paper as a list of blocks (headings, text, tables, figures, code), which can be written as one
 * HTML file or as the pages of a PDF. */
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

/* A row of a table; a marked one (of an assumed value) carries a sign in the margin. */
struct cr_doc_row {
    const char *cell[CR_COLUMNS];
    bool head, marked;
};

struct cr_block {
    enum cr_block_kind kind;
    const char *text; /* of a figure: its caption */
    bool quoted;      /* these are somebody else's words: they are never told in other units */
    int columns, rows, row_size;
    struct cr_doc_row *row;   /* [rows], owned */
    struct cr_canvas *figure; /* owned */
};

/* A lack of memory is remembered in `failed`, and the writers report it. */
struct cr_document {
    struct cr_arena arena;
    const char *title, *author, *date; /* NULL: none */
    const char *language;              /* "en", "de" */
    bool comma, failed;                /* numbers have a decimal comma; memory was out */
    int blocks, block_size;
    struct cr_block *block;
};
void cr_document_fini(struct cr_document *doc);

/* Add a block with a text, which is copied; cr_doc_addf with a formatted one. */
void cr_doc_add(struct cr_document *doc, enum cr_block_kind kind, const char *text);
void cr_doc_addf(struct cr_document *doc, enum cr_block_kind kind, const char *fmt, ...)
    CR_PRINTF(3, 4);
/* Formats a text that the document keeps; with doc->comma points between digits become commas. */
const char *cr_doc_text(struct cr_document *doc, const char *fmt, ...) CR_PRINTF(2, 3);
/* Copies a text as it is; the document keeps the copy. */
const char *cr_doc_keep(struct cr_document *doc, const char *text);
/* Adds a table of up to CR_COLUMNS columns; its rows follow by cr_doc_row. */
void cr_doc_table(struct cr_document *doc, int columns);
/* Adds a row to the table that was added last and copies the cells, [columns], NULL for an empty
 * one. Returns the row, to be made a head or marked; NULL without memory. */
struct cr_doc_row *cr_doc_row(struct cr_document *doc, const char *const *cell);
/* Adds a figure and takes the canvas over; NULL adds nothing. */
void cr_doc_figure(struct cr_document *doc, struct cr_canvas *figure, const char *caption);

/* Tells everything but figures, code and quotations in US units, wherever a number stands before or
 * below a metric unit. unit_head: the heading of columns that hold the units of their rows. */
void cr_document_us(struct cr_document *doc, const char *unit_head);

/* Writes one file, without scripts and without anything outside of it, for screen and print.
 * Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_document_html(const struct cr_document *doc, struct cr_str *out,
                                           struct cr_error *err);
/* Writes pages of w x h points. Errors: USAGE in a build without cairo, RANGE for too many pages,
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_document_pdf(const struct cr_document *doc, double w, double h,
                                          struct cr_str *out, struct cr_error *err);

#endif
