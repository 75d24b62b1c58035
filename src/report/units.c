/* Turns a paper into US units: the numbers that its sections wrote in metric units are converted
 * one by one. */
#include "report/document.h"

#include "base/str.h"
#include "base/units.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The metric unit at the end of "EES, km/h" or "km/h", if it has a counterpart; else NULL. */
static const char *unit_of(const char *head) {
    const char *comma = strrchr(head, ',');
    const char *unit = comma != NULL ? comma + 1 + strspn(comma + 1, " ") : head;
    return cr_units_shown(CR_UNITS_US, unit, NULL, NULL) != unit ? unit : NULL;
}

/* Converts a number with so many decimals. An input is exact, however few digits were typed, so it
 * keeps four of them at least. */
static double convert(const char *unit, double x, bool input, int *decimals) {
    cr_units_shown(CR_UNITS_US, unit, &x, decimals);
    int least = input && x != 0 ? 3 - (int)floor(log10(fabs(x))) : 0;
    *decimals = *decimals > least ? *decimals : least;
    return x;
}

/* Converts a list "[2.3,0.7]"; its commas separate in every language. */
static const char *list(struct cr_document *doc, const char *cell, const char *unit, bool input) {
    struct cr_str out = {0};
    for (const char *p = cell; *p != '\0';) {
        char *end;
        double x = strtod(p, &end);
        if (end == p) {
            cr_str_addn(&out, p++, 1);
            continue;
        }
        const char *point = memchr(p, '.', (size_t)(end - p));
        int decimals = point != NULL ? (int)(end - point - 1) : 0;
        x = convert(unit, x, input, &decimals);
        cr_str_addf(&out, "%.*f", decimals, x);
        p = end;
    }
    doc->failed = doc->failed || out.failed;
    const char *kept = cr_doc_keep(doc, cr_str_get(&out));
    cr_str_fini(&out);
    return kept;
}

/* Converts a cell that is nothing but a number or a list, from the unit of its row or column; other
 * cells stay. */
static const char *number(struct cr_document *doc, const char *cell, const char *unit, bool input) {
    char plain[64], *end;
    if (cell[0] == '[') {
        return list(doc, cell, unit, input);
    }
    snprintf(plain, sizeof plain, "%.60s", cell);
    char *comma = doc->comma ? strchr(plain, ',') : NULL;
    if (comma != NULL) {
        *comma = '.';
    }
    double x = strtod(plain, &end);
    if (end == plain || *end != '\0') {
        return cell;
    }
    const char *point = strchr(plain, '.');
    int decimals = point != NULL ? (int)strlen(point + 1) : 0;
    x = convert(unit, x, input, &decimals);
    return cr_doc_text(doc, "%.*f", decimals, x);
}

static const char *words(struct cr_document *doc, const char *text) {
    struct cr_str shown = {0};
    cr_units_words(CR_UNITS_US, doc->comma ? ',' : '.', text, &shown);
    doc->failed = doc->failed || shown.failed;
    const char *kept =
        strcmp(cr_str_get(&shown), text) != 0 ? cr_doc_text(doc, "%s", cr_str_get(&shown)) : text;
    cr_str_fini(&shown);
    return kept;
}

/* Makes "EES, mph" of "EES, km/h". */
static const char *head(struct cr_document *doc, const char *text, const char *unit) {
    char shown[200];
    snprintf(shown, sizeof shown, "%.*s%s", (int)(unit - text), text,
             cr_units_shown(CR_UNITS_US, unit, NULL, NULL));
    return cr_doc_keep(doc, shown);
}

static void row(struct cr_document *doc, const struct cr_block *b, struct cr_doc_row *r,
                const struct cr_doc_row *top, const char *unit_head) {
    const char *of_row = r->cell[0] != NULL ? unit_of(r->cell[0]) : NULL;
    bool input = false;
    for (int i = 0; i < b->columns && of_row == NULL; i++) { /* is there a column of units? */
        if (top->cell[i] != NULL && strcmp(top->cell[i], unit_head) == 0 && r->cell[i] != NULL) {
            of_row = unit_of(r->cell[i]);
            input = true;
            r->cell[i] = cr_units_shown(CR_UNITS_US, r->cell[i], NULL, NULL);
        }
    }
    for (int i = 0; i < b->columns; i++) {
        const char *unit = top->cell[i] != NULL ? unit_of(top->cell[i]) : NULL;
        unit = unit != NULL ? unit : i > 0 ? of_row : NULL;
        if (r->cell[i] != NULL && unit != NULL) {
            r->cell[i] = number(doc, r->cell[i], unit, input);
        }
        if (r->cell[i] != NULL) {
            r->cell[i] = words(doc, r->cell[i]);
        }
    }
    if (r->cell[0] != NULL && of_row != NULL && unit_of(r->cell[0]) != NULL) {
        r->cell[0] = head(doc, r->cell[0], unit_of(r->cell[0]));
    }
}

static void table(struct cr_document *doc, struct cr_block *b, const char *unit_head) {
    static const struct cr_doc_row none = {.head = false};
    const struct cr_doc_row top = b->rows > 0 && b->row[0].head ? b->row[0] : none;
    for (int i = 0; i < b->rows; i++) {
        if (!b->row[i].head) {
            row(doc, b, &b->row[i], &top, unit_head);
        }
    }
    for (int i = 0; i < b->columns && top.head; i++) {
        const char *unit = top.cell[i] != NULL ? unit_of(top.cell[i]) : NULL;
        if (unit != NULL) {
            b->row[0].cell[i] = head(doc, top.cell[i], unit);
        }
    }
}

void cr_document_us(struct cr_document *doc, const char *unit_head) {
    for (int i = 0; i < doc->blocks; i++) {
        struct cr_block *b = &doc->block[i];
        if (b->quoted) {
            continue;
        }
        if (b->kind == CR_BLOCK_TABLE) {
            table(doc, b, unit_head);
        } else if (b->kind != CR_BLOCK_CODE) {
            b->text = words(doc, b->text);
        }
    }
}
