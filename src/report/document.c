/* Builds a paper block by block. */
#include "report/document.h"

#include "base/grow.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void cr_document_fini(struct cr_document *doc) {
    for (int i = 0; i < doc->blocks; i++) {
        cr_canvas_free(doc->block[i].figure);
        free(doc->block[i].row);
    }
    free(doc->block);
    cr_arena_free(&doc->arena);
    *doc = (struct cr_document){0};
}

CR_PRINTF(2, 0)
static const char *vtext(struct cr_document *doc, const char *fmt, va_list args, bool comma) {
    va_list again;
    va_copy(again, args);
    int n = vsnprintf(NULL, 0, fmt, again);
    va_end(again);
    char *s = n < 0 ? NULL : cr_arena_take(&doc->arena, (size_t)n + 1, 1);
    if (s == NULL) {
        doc->failed = true;
        return "";
    }
    vsnprintf(s, (size_t)n + 1, fmt, args);
    if (comma) {
        cr_decimal_comma(s, (size_t)n);
    }
    return s;
}

const char *cr_doc_text(struct cr_document *doc, const char *fmt, ...) {
    va_list args;
    va_start(args, fmt);
    const char *s = vtext(doc, fmt, args, doc->comma);
    va_end(args);
    return s;
}

static struct cr_block *add(struct cr_document *doc, enum cr_block_kind kind) {
    if (!cr_grow(&doc->block, &doc->block_size, doc->blocks, sizeof *doc->block)) {
        doc->failed = true;
        return NULL;
    }
    struct cr_block *b = &doc->block[doc->blocks++];
    *b = (struct cr_block){.kind = kind, .text = ""};
    return b;
}

const char *cr_doc_keep(struct cr_document *doc, const char *text) {
    size_t n = strlen(text) + 1;
    char *s = cr_arena_take(&doc->arena, n, 1);
    if (s == NULL) {
        doc->failed = true;
        return "";
    }
    memcpy(s, text, n);
    return s;
}

/* Keeps code with blanks for its tabs, which no font draws, and without the CR of other systems. */
static const char *keep_code(struct cr_document *doc, const char *text) {
    struct cr_str plain = {0};
    for (const char *p = text; *p != '\0';) {
        size_t n = strcspn(p, "\t\r");
        cr_str_addn(&plain, p, n);
        cr_str_add(&plain, p[n] == '\t' ? "  " : "");
        p += n + (p[n] != '\0');
    }
    doc->failed = doc->failed || plain.failed;
    const char *kept = cr_doc_keep(doc, cr_str_get(&plain));
    cr_str_fini(&plain);
    return kept;
}

void cr_doc_add(struct cr_document *doc, enum cr_block_kind kind, const char *text) {
    struct cr_block *b = add(doc, kind);
    if (b != NULL) {
        b->text = kind == CR_BLOCK_CODE ? keep_code(doc, text) : cr_doc_keep(doc, text);
    }
}

void cr_doc_addf(struct cr_document *doc, enum cr_block_kind kind, const char *fmt, ...) {
    struct cr_block *b = add(doc, kind);
    va_list args;
    va_start(args, fmt);
    const char *s = vtext(doc, fmt, args, doc->comma);
    va_end(args);
    if (b != NULL) {
        b->text = s;
    }
}

void cr_doc_table(struct cr_document *doc, int columns) {
    struct cr_block *b = add(doc, CR_BLOCK_TABLE);
    if (b != NULL) {
        b->columns = columns < CR_COLUMNS ? columns : CR_COLUMNS;
    }
}

struct cr_doc_row *cr_doc_row(struct cr_document *doc, const char *const *cell) {
    struct cr_block *b = doc->blocks > 0 ? &doc->block[doc->blocks - 1] : NULL;
    if (b == NULL || b->kind != CR_BLOCK_TABLE || doc->failed) {
        return NULL;
    }
    if (!cr_grow(&b->row, &b->row_size, b->rows, sizeof *b->row)) {
        doc->failed = true;
        return NULL;
    }
    struct cr_doc_row *row = &b->row[b->rows++];
    *row = (struct cr_doc_row){.head = false};
    for (int i = 0; i < b->columns; i++) {
        row->cell[i] = cell[i] != NULL ? cr_doc_keep(doc, cell[i]) : "";
    }
    return row;
}

void cr_doc_figure(struct cr_document *doc, struct cr_canvas *figure, const char *caption) {
    struct cr_block *b = figure != NULL ? add(doc, CR_BLOCK_FIGURE) : NULL;
    if (b == NULL) {
        cr_canvas_free(figure);
        return;
    }
    if (doc->comma) {
        cr_canvas_comma(figure);
    }
    b->figure = figure;
    b->text = cr_doc_keep(doc, caption);
}
