/* Reads the description of an ERG file of CarMaker: lines "key = value" that name the quantities of
 * its records in their order; and the value of a quantity in a record. */
#include "import/erg_priv.h"

#include "base/csv.h"
#include "base/grow.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *word;
    enum cr_erg_kind kind;
    int bytes;
} types[] = {
    {"Float", CR_ERG_FLOAT, 4},        {"Double", CR_ERG_FLOAT, 8},  {"LongLong", CR_ERG_SIGNED, 8},
    {"ULongLong", CR_ERG_UNSIGNED, 8}, {"Long", CR_ERG_SIGNED, 4},   {"ULong", CR_ERG_UNSIGNED, 4},
    {"Int", CR_ERG_SIGNED, 4},         {"UInt", CR_ERG_UNSIGNED, 4}, {"Short", CR_ERG_SIGNED, 2},
    {"UShort", CR_ERG_UNSIGNED, 2},    {"Char", CR_ERG_SIGNED, 1},   {"UChar", CR_ERG_UNSIGNED, 1},
};
enum { TYPES = sizeof types / sizeof types[0], LINE = 1024 };

struct line {
    const char *shown;
    int number;
    char key[LINE], value[LINE];
};

static enum cr_err fault(const struct line *l, struct cr_error *err, enum cr_err code,
                         const char *what) {
    cr_err_set(err, code, "%.60s: %s: \"%.60s\"", l->key, what, l->value);
    cr_err_place(err, l->shown, l->number, 0);
    return code;
}

/* Copies a text without the blanks and quotes around it. */
static void trim(const char *from, const char *to, char out[LINE]) {
    while (from < to && strchr(" \t\"", *from) != NULL) {
        from++;
    }
    while (to > from && strchr(" \t\r\"", to[-1]) != NULL) {
        to--;
    }
    size_t n = (size_t)(to - from) < LINE - 1 ? (size_t)(to - from) : LINE - 1;
    memcpy(out, from, n);
    out[n] = '\0';
}

/* ---- quantities ---- */

static enum cr_err set_type(struct cr_erg *erg, const struct line *l, struct cr_error *err) {
    struct cr_erg_quantity *q = &erg->quantity[erg->n - 1];
    char *end;
    long n = strtol(l->value, &end, 10);
    for (int i = 0; i < TYPES; i++) {
        if (strcmp(l->value, types[i].word) == 0) {
            q->kind = types[i].kind;
            q->bytes = types[i].bytes;
        }
    }
    if (end != l->value && strcmp(end, " Bytes") == 0 && n >= 1 && n <= 1024) {
        q->kind = CR_ERG_PADDING;
        q->bytes = (int)n;
    }
    if (q->bytes == 0) {
        return fault(l, err, CR_ERR_SYNTAX, "unknown type");
    }
    q->at = erg->record;
    erg->record += q->bytes;
    return CR_ERR_OK;
}

static enum cr_err add(struct cr_erg *erg, const struct line *l, struct cr_error *err) {
    if (erg->n == CR_ERG_QUANTITIES) {
        return fault(l, err, CR_ERR_RANGE, "too many quantities");
    }
    if (!cr_grow(&erg->quantity, &erg->size, erg->n, sizeof *erg->quantity)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a quantity");
    }
    struct cr_erg_quantity *q = &erg->quantity[erg->n++];
    *q = (struct cr_erg_quantity){.factor = 1};
    if (strlen(l->value) >= sizeof q->name) {
        return fault(l, err, CR_ERR_RANGE, "too long a name");
    }
    memcpy(q->name, l->value, strlen(l->value) + 1);
    return CR_ERR_OK;
}

/* Reads "File.At.N.Name" and "File.At.N.Type", where N counts up from 1. */
static enum cr_err at_line(struct cr_erg *erg, const struct line *l, struct cr_error *err) {
    char *end;
    long n = strtol(l->key + strlen("File.At."), &end, 10);
    if (strcmp(end, ".Name") == 0) {
        bool whole = erg->n == 0 || erg->quantity[erg->n - 1].bytes > 0;
        return n == erg->n + 1 && whole ? add(erg, l, err)
                                        : fault(l, err, CR_ERR_SYNTAX,
                                                "quantities must be counted up, each with a type");
    }
    if (strcmp(end, ".Type") == 0) {
        return n == erg->n && n > 0 && erg->quantity[n - 1].bytes == 0
                   ? set_type(erg, l, err)
                   : fault(l, err, CR_ERR_SYNTAX, "a type without its name");
    }
    return CR_ERR_OK;
}

/* Reads "Quantity.NAME.Unit", ".Factor" and ".Offset". */
static enum cr_err quantity_line(struct cr_erg *erg, const struct line *l, struct cr_error *err) {
    char name[LINE];
    const char *dot = strrchr(l->key, '.'), *from = l->key + strlen("Quantity.");
    if (dot <= from) {
        return CR_ERR_OK;
    }
    snprintf(name, sizeof name, "%.*s", (int)(dot - from), from);
    /* A line most often describes the quantity that was named last. */
    int i = erg->n > 0 && strcmp(erg->quantity[erg->n - 1].name, name) == 0
                ? erg->n - 1
                : cr_erg_find(erg, name);
    if (i < 0) {
        return CR_ERR_OK; /* It is described, but not recorded. */
    }
    struct cr_erg_quantity *q = &erg->quantity[i];
    if (strcmp(dot, ".Unit") == 0) {
        snprintf(q->unit, sizeof q->unit, "%.31s", l->value);
    } else if (strcmp(dot, ".Factor") == 0 && !cr_csv_scan(l->value, false, &q->factor)) {
        return fault(l, err, CR_ERR_TYPE, "no number");
    } else if (strcmp(dot, ".Offset") == 0 && !cr_csv_scan(l->value, false, &q->offset)) {
        return fault(l, err, CR_ERR_TYPE, "no number");
    }
    return CR_ERR_OK;
}

static enum cr_err one_line(struct cr_erg *erg, const struct line *l, bool *ordered,
                            struct cr_error *err) {
    if (strcmp(l->key, "File.Format") == 0 && strcmp(l->value, "erg") != 0) {
        return fault(l, err, CR_ERR_TYPE, "only the format erg can be read");
    }
    if (strcmp(l->key, "File.ByteOrder") == 0) {
        erg->big_endian = strcmp(l->value, "BigEndian") == 0;
        *ordered = true;
        return erg->big_endian || strcmp(l->value, "LittleEndian") == 0
                   ? CR_ERR_OK
                   : fault(l, err, CR_ERR_SYNTAX, "neither LittleEndian nor BigEndian");
    }
    if (strncmp(l->key, "File.At.", 8) == 0) {
        return at_line(erg, l, err);
    }
    return strncmp(l->key, "Quantity.", 9) == 0 ? quantity_line(erg, l, err) : CR_ERR_OK;
}

enum cr_err cr_erg_parse(const char *text, const char *shown, struct cr_erg *out,
                         struct cr_error *err) {
    struct line l = {.shown = shown};
    bool ordered = false;
    enum cr_err code = CR_ERR_OK;
    *out = (struct cr_erg){.n = 0};
    for (const char *p = text; *p != '\0' && code == CR_ERR_OK;) {
        const char *end = p + strcspn(p, "\n"), *equals = memchr(p, '=', (size_t)(end - p));
        l.number++;
        if (equals != NULL && *p != '#') {
            trim(p, equals, l.key);
            trim(equals + 1, end, l.value);
            code = one_line(out, &l, &ordered, err);
        }
        p = *end != '\0' ? end + 1 : end;
    }
    const char *lacks = !ordered                               ? "File.ByteOrder"
                        : out->n == 0                          ? "File.At.1.Name"
                        : out->quantity[out->n - 1].bytes == 0 ? "type of its last quantity"
                                                               : NULL;
    if (code == CR_ERR_OK && lacks != NULL) {
        code = cr_err_set(err, CR_ERR_MISSING, "no %s", lacks);
        cr_err_place(err, shown, 0, 0);
    }
    return code;
}

void cr_erg_fini(struct cr_erg *erg) {
    free(erg->quantity);
    *erg = (struct cr_erg){.n = 0};
}

int cr_erg_find(const struct cr_erg *erg, const char *name) {
    for (int i = 0; i < erg->n; i++) {
        if (strcmp(erg->quantity[i].name, name) == 0) {
            return i;
        }
    }
    return -1;
}

double cr_erg_value(const struct cr_erg *erg, int i, const unsigned char *record) {
    const struct cr_erg_quantity *q = &erg->quantity[i];
    uint64_t raw = 0;
    double x = 0;
    for (int k = 0; k < q->bytes && k < 8; k++) {
        int at = erg->big_endian ? k : q->bytes - 1 - k;
        raw = raw << 8 | record[q->at + at];
    }
    if (q->kind == CR_ERG_FLOAT && q->bytes == 4) {
        uint32_t bits = (uint32_t)raw;
        float f;
        memcpy(&f, &bits, sizeof f);
        x = (double)f;
    } else if (q->kind == CR_ERG_FLOAT) {
        memcpy(&x, &raw, sizeof x);
    } else if (q->kind == CR_ERG_SIGNED && raw >> (8 * q->bytes - 1) != 0) {
        /* The number is negative, in two's complement. */
        x = -(double)(~(raw | (q->bytes < 8 ? UINT64_MAX << 8 * q->bytes : 0)) + 1);
    } else if (q->kind != CR_ERG_PADDING) {
        x = (double)raw;
    }
    return q->factor * x + q->offset;
}
