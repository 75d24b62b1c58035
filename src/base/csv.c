/* Reads tables as text: records from a buffer that is filled again and again, cut into fields. */
#include "base/csv.h"

#include "base/grow.h"
#include "base/show.h"
#include "base/str.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BUFFER = 1 << 16, RECORD_MAX = 16 << 20 };

struct row {
    struct cr_str text;
    size_t *at; /* where the fields begin in text */
    int *col;   /* 1-based, in the line of the file */
    int n, room;
    int line;
};

struct cr_csv {
    char src[256];
    FILE *file; /* NULL for a text */
    const char *p, *end;
    int line; /* of the byte at p */
    char sep;
    bool comma;   /* decimal */
    bool pending; /* the row has been read already */
    struct row head, units, row;
    struct cr_str raw, recoded;
    char buffer[BUFFER];
};

/* ---- bytes ---- */

static bool fill(struct cr_csv *c) {
    if (c->p == c->end && c->file != NULL) {
        size_t n = fread(c->buffer, 1, BUFFER, c->file);
        c->p = c->buffer;
        c->end = c->buffer + n;
    }
    return c->p < c->end;
}

static int peek(struct cr_csv *c) {
    return fill(c) ? (unsigned char)*c->p : -1;
}

/* next byte, every kind of line end as \n, -1 at the end */
static int next_byte(struct cr_csv *c) {
    if (!fill(c)) {
        return -1;
    }
    int byte = (unsigned char)*c->p++;
    if (byte == '\r') {
        if (peek(c) == '\n') {
            c->p++;
        }
        byte = '\n';
    }
    c->line += byte == '\n';
    return byte;
}

static enum cr_err fault_at(const struct cr_csv *c, int line, struct cr_error *err,
                            enum cr_err code, const char *text) {
    cr_err_set(err, code, "%s", text);
    cr_err_place(err, c->src, line, line > 0);
    return code;
}

/* ---- records ---- */

static bool is_separator(const struct cr_csv *c, int byte) {
    return c->sep != '\0' ? byte == c->sep : byte == ',' || byte == ';' || byte == '\t';
}

/* Whether a line is a remark or empty: such lines are passed over. */
static bool pass_over(struct cr_csv *c) {
    while (peek(c) == ' ') {
        c->p++;
    }
    int byte = peek(c);
    if (byte != '#' && byte != '\n' && byte != '\r') {
        return false;
    }
    do {
        byte = next_byte(c);
    } while (byte != '\n' && byte != -1);
    return true;
}

/* The next record as it stands, a line or, with line ends in quotes, several. *got is false at the
 * end. A quote opens a field only where the field begins. */
static enum cr_err read_raw(struct cr_csv *c, int *line, bool *got, struct cr_error *err) {
    bool quoted = false, fresh = true;
    int last = 0;
    cr_str_clear(&c->raw);
    while (pass_over(c)) {
    }
    *line = c->line;
    *got = peek(c) >= 0;
    for (int byte = next_byte(c); byte >= 0 && (quoted || byte != '\n'); byte = next_byte(c)) {
        if (byte == '\0') {
            return fault_at(c, c->line, err, CR_ERR_SYNTAX, "a byte 0: this is not a text");
        }
        quoted = byte == '"' ? !quoted && (fresh || last == '"') : quoted;
        last = byte;
        fresh = is_separator(c, byte) || (fresh && byte == ' ');
        char one = (char)byte;
        cr_str_addn(&c->raw, &one, 1);
        if (c->raw.len > RECORD_MAX) {
            fault_at(c, *line, err, CR_ERR_SYNTAX, "a row of more than 16 MB");
            cr_err_hint(err, "%s", quoted ? "a quote that opens in it is never closed" : "");
            return CR_ERR_SYNTAX;
        }
    }
    if (quoted) {
        return fault_at(c, *line, err, CR_ERR_SYNTAX, "a quote in this row is never closed");
    }
    if (c->file != NULL && ferror(c->file)) {
        cr_err_set(err, CR_ERR_IO, "cannot read: %s", strerror(errno));
        cr_err_place(err, c->src, c->line, 0);
        return CR_ERR_IO;
    }
    return c->raw.failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for a row") : CR_ERR_OK;
}

/* Latin-1 becomes UTF-8 where a record is none */
static void recode(struct cr_csv *c) {
    const char *s = cr_str_get(&c->raw);
    size_t i = 0;
    for (size_t n; i < c->raw.len && (n = cr_utf8_length(s + i, c->raw.len - i)) > 0; i += n) {
    }
    if (i == c->raw.len) {
        return;
    }
    cr_str_clear(&c->recoded);
    for (i = 0; i < c->raw.len; i++) {
        unsigned char byte = (unsigned char)s[i];
        char two[2] = {(char)(0xc0 | byte >> 6), (char)(0x80 | (byte & 0x3f))};
        cr_str_addn(&c->recoded, byte < 0x80 ? s + i : two, byte < 0x80 ? 1 : 2);
    }
    struct cr_str other = c->raw;
    c->raw = c->recoded;
    c->recoded = other;
}

static bool add_field(struct row *row, int col) {
    int room = row->room; /* of both arrays, which grow together */
    if (!cr_grow(&row->at, &room, row->n, sizeof *row->at) ||
        !cr_grow(&row->col, &row->room, row->n, sizeof *row->col)) {
        return false;
    }
    row->at[row->n] = row->text.len;
    row->col[row->n++] = col;
    return true;
}

static bool continues_character(char c) {
    return ((unsigned char)c & 0xc0) == 0x80;
}

/* One field from p on into row without its quotes and the blanks around it; where it ends. */
static const char *cut_field(struct row *row, const char *p, char sep, int *col) {
    size_t start = row->text.len;
    bool quoted = false, was_quoted = false;
    for (; *p == ' '; p++) {
        ++*col;
    }
    if (*p == '"') {
        quoted = was_quoted = true;
        p++, ++*col;
    }
    for (; *p != '\0' && (quoted || *p != sep); p++) {
        *col += !continues_character(*p);
        if (*p == '"' && was_quoted) {
            if (quoted && p[1] == '"') {
                p++, ++*col;
            } else {
                quoted = false;
                continue;
            }
        }
        cr_str_addn(&row->text, p, 1);
    }
    while (row->text.len > start && (row->text.s[row->text.len - 1] == ' ' ||
                                     (row->text.s[row->text.len - 1] == '\t' && sep != '\t'))) {
        row->text.len--;
    }
    cr_str_addn(&row->text, "", 1); /* the end of the field */
    return p;
}

/* The record that was read, cut into the fields of row. */
static enum cr_err cut_row(struct cr_csv *c, struct row *row, struct cr_error *err) {
    recode(c);
    row->n = 0;
    cr_str_clear(&row->text);
    int col = 1;
    const char *p = cr_str_get(&c->raw);
    bool room = add_field(row, col);
    p = cut_field(row, p, c->sep, &col);
    while (*p != '\0' && room) {
        room = add_field(row, ++col);
        p = cut_field(row, p + 1, c->sep, &col);
    }
    return room && !row->text.failed && !c->raw.failed
               ? CR_ERR_OK
               : cr_err_set(err, CR_ERR_MEMORY, "no memory for a row");
}

static const char *field(const struct row *row, int i) {
    return i >= 0 && i < row->n ? row->text.s + row->at[i] : "";
}

/* from a field on there is nothing more */
static bool all_empty(const struct row *row, int from) {
    for (int i = from; i < row->n; i++) {
        if (field(row, i)[0] != '\0') {
            return false;
        }
    }
    return true;
}

/* ---- the head of a table ---- */

/* Passes over a byte order mark and refuses UTF-16. */
static enum cr_err check_encoding(struct cr_csv *c, struct cr_error *err) {
    if (!fill(c)) {
        return CR_ERR_OK;
    }
    size_t n = (size_t)(c->end - c->p);
    const unsigned char *p = (const unsigned char *)c->p;
    bool little = n >= 2 && p[0] == 0xff && p[1] == 0xfe,
         big = n >= 2 && p[0] == 0xfe && p[1] == 0xff;
    if (little || big || (n >= 4 && ((p[0] == 0 && p[2] == 0) || (p[1] == 0 && p[3] == 0)))) {
        fault_at(c, 1, err, CR_ERR_SYNTAX, "the file is UTF-16, UTF-8 is wanted");
        cr_err_hint(err, "save it as \"CSV UTF-8\", or: iconv -f UTF-16 -t UTF-8 FILE > NEW.csv");
        return CR_ERR_SYNTAX;
    }
    if (n >= 3 && memcmp(p, "\xef\xbb\xbf", 3) == 0) {
        c->p += 3;
    }
    return CR_ERR_OK;
}

/* the first of tab, semicolon, comma that the header has outside of quotes */
static char separator(const char *s) {
    bool seen[3] = {false}, quoted = false;
    for (; *s != '\0'; s++) {
        quoted = quoted != (*s == '"');
        seen[0] |= *s == '\t' && !quoted;
        seen[1] |= *s == ';' && !quoted;
    }
    return seen[0] ? '\t' : seen[1] ? ';' : ',';
}

static bool begins_with(const char *s, const char *word) {
    s += strspn(s, " \"");
    return strncmp(s, word, strlen(word)) == 0;
}

/* a row without a number in which at least one field is a unit */
static bool is_units_row(const struct row *row) {
    int known = 0;
    for (int i = 0; i < row->n; i++) {
        const char *s = field(row, i);
        double x;
        if (cr_csv_scan(s, true, &x)) {
            return false;
        }
        known += s[0] != '\0' && cr_unit_spelled(s, CR_DIMS) != NULL;
    }
    return known > 0;
}

static enum cr_err read_header(struct cr_csv *c, const char *begins, struct cr_error *err) {
    int numbers = 0, line;
    bool got = true;
    enum cr_err code = CR_ERR_OK;
    /* the separator is known when the whole record is, which is then given back to be read */
    do {
        code = read_raw(c, &line, &got, err);
    } while (code == CR_ERR_OK && got && begins != NULL &&
             !begins_with(cr_str_get(&c->raw), begins));
    if (code != CR_ERR_OK) {
        return code;
    }
    if (!got) {
        fault_at(c, 0, err, CR_ERR_MISSING, begins != NULL ? "no header row" : "the file is empty");
        if (begins != NULL) {
            cr_err_hint(err, "it begins with %s", begins);
        }
        return CR_ERR_MISSING;
    }
    c->sep = separator(cr_str_get(&c->raw));
    c->comma = c->sep != ',';
    c->head.line = line;
    code = cut_row(c, &c->head, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    while (c->head.n > 1 && field(&c->head, c->head.n - 1)[0] == '\0') {
        c->head.n--; /* a separator at the end of the line */
    }
    for (int i = 0; i < c->head.n; i++) {
        double x;
        numbers += cr_csv_scan(field(&c->head, i), c->comma, &x);
    }
    if (numbers == c->head.n) {
        fault_at(c, line, err, CR_ERR_SYNTAX, "no header: the first row must name the columns");
        cr_err_hint(err, "for example t_s,ax_g");
        return CR_ERR_SYNTAX;
    }
    return CR_ERR_OK;
}

/* Reads the row below the header: it is the units, or it stays to be given as the first row. */
static enum cr_err read_units(struct cr_csv *c, struct cr_error *err) {
    bool got;
    enum cr_err code = read_raw(c, &c->row.line, &got, err);
    code = code == CR_ERR_OK && got ? cut_row(c, &c->row, err) : code;
    if (code == CR_ERR_OK && got && is_units_row(&c->row)) {
        struct row other = c->units;
        c->units = c->row;
        c->row = other;
    } else {
        c->pending = code == CR_ERR_OK && got;
    }
    return code;
}

enum cr_err cr_csv_open(const struct cr_csv_opts *opts, struct cr_csv **out, struct cr_error *err) {
    *out = NULL;
    struct cr_csv *c = calloc(1, sizeof *c);
    if (c == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a table");
    }
    bool standard = opts->text == NULL && strcmp(opts->path, "-") == 0;
    snprintf(c->src, sizeof c->src, "%s",
             standard             ? "standard input"
             : opts->path != NULL ? opts->path
                                  : "");
    c->line = opts->line > 0 ? opts->line : 1;
    c->p = opts->text != NULL ? opts->text : c->buffer;
    c->end = opts->text != NULL ? opts->text + opts->len : c->buffer;
    enum cr_err code = CR_ERR_OK;
    if (opts->text == NULL) {
        c->file = standard ? stdin : fopen(opts->path, "r");
        if (c->file == NULL) {
            cr_err_set(err, CR_ERR_IO, "cannot open: %s", strerror(errno));
            cr_err_place(err, c->src, 0, 0);
            code = CR_ERR_IO;
        }
    }
    code = code == CR_ERR_OK ? check_encoding(c, err) : code;
    code = code == CR_ERR_OK ? read_header(c, opts->header, err) : code;
    code = code == CR_ERR_OK && opts->units ? read_units(c, err) : code;
    if (code != CR_ERR_OK) {
        cr_csv_close(c);
        return code;
    }
    *out = c;
    return CR_ERR_OK;
}

static void free_row(struct row *row) {
    cr_str_fini(&row->text);
    free(row->at);
    free(row->col);
}

void cr_csv_close(struct cr_csv *csv) {
    if (csv == NULL) {
        return;
    }
    if (csv->file != NULL && csv->file != stdin) {
        fclose(csv->file);
    }
    free_row(&csv->head);
    free_row(&csv->units);
    free_row(&csv->row);
    cr_str_fini(&csv->raw);
    cr_str_fini(&csv->recoded);
    free(csv);
}

/* ---- columns ---- */

bool cr_csv_comma(const struct cr_csv *csv) {
    return csv->comma;
}

int cr_csv_columns(const struct cr_csv *csv) {
    return csv->head.n;
}

const char *cr_csv_name(const struct cr_csv *csv, int i) {
    return field(&csv->head, i);
}

int cr_csv_find(const struct cr_csv *csv, const char *name) {
    for (int i = 0; i < csv->head.n; i++) {
        if (strcmp(field(&csv->head, i), name) == 0) {
            return i;
        }
    }
    return -1;
}

/* The hint of an unknown column: the nearest name, else all names. */
static void hint_names(const struct cr_csv *csv, const char *name, struct cr_error *err) {
    const char **names = calloc((size_t)csv->head.n, sizeof *names);
    struct cr_str list = {0};
    for (int i = 0; names != NULL && i < csv->head.n; i++) {
        names[i] = field(&csv->head, i);
        cr_str_addf(&list, "%s%s", i > 0 ? ", " : "", names[i]);
    }
    const char *near = names != NULL ? cr_str_nearest(name, names, csv->head.n) : NULL;
    if (near != NULL) {
        cr_err_hint(err, "did you mean '%s'?", near);
    } else {
        cr_err_hint(err, "its columns: %.160s", cr_str_get(&list));
    }
    cr_str_fini(&list);
    free(names);
}

enum cr_err cr_csv_need(const struct cr_csv *csv, const char *name, int *column,
                        struct cr_error *err) {
    *column = cr_csv_find(csv, name);
    for (int i = *column + 1; *column >= 0 && i < csv->head.n; i++) {
        if (strcmp(field(&csv->head, i), name) == 0) {
            cr_err_set(err, CR_ERR_DUPLICATE, "two columns are named '%.80s'", name);
            cr_err_place(err, csv->src, csv->head.line, csv->head.col[i]);
            return CR_ERR_DUPLICATE;
        }
    }
    if (*column < 0) {
        cr_err_set(err, CR_ERR_NAME, "no column '%.80s'", name);
        cr_err_place(err, csv->src, csv->head.line, 1);
        hint_names(csv, name, err);
        return CR_ERR_NAME;
    }
    return CR_ERR_OK;
}

enum cr_err cr_csv_unit(const struct cr_csv *csv, int column, enum cr_dim dim,
                        const struct cr_unit **unit, struct cr_error *err) {
    const char *spelled = field(&csv->units, column);
    const struct row *row = spelled[0] != '\0' ? &csv->units : &csv->head;
    enum cr_err code = row == &csv->units
                           ? cr_unit_read(spelled, dim, unit, err)
                           : cr_unit_of_column(field(&csv->head, column), dim, unit, err);
    if (code != CR_ERR_OK && column >= 0 && column < row->n) {
        cr_err_place(err, csv->src, row->line, row->col[column]);
    }
    return code;
}

/* ---- rows ---- */

static enum cr_err check_length(struct cr_csv *c, struct cr_error *err) {
    int have = c->row.n, want = c->head.n;
    if (have == want || (have > want && all_empty(&c->row, want))) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_SYNTAX, "the row is too %s: %d field%s where the header has %d",
               have < want ? "short" : "long", have, have == 1 ? "" : "s", want);
    cr_err_place(err, c->src, c->row.line, 1);
    if (have > want && c->sep == ',') {
        cr_err_hint(err, "decimal commas want ; or a tab between the columns");
    }
    return CR_ERR_SYNTAX;
}

enum cr_err cr_csv_next(struct cr_csv *csv, bool *row, struct cr_error *err) {
    do {
        *row = true;
        if (csv->pending) {
            csv->pending = false;
            continue;
        }
        enum cr_err code = read_raw(csv, &csv->row.line, row, err);
        code = code == CR_ERR_OK && *row ? cut_row(csv, &csv->row, err) : code;
        if (code != CR_ERR_OK || !*row) {
            return code;
        }
    } while (all_empty(&csv->row, 0));
    return check_length(csv, err);
}

int cr_csv_line(const struct cr_csv *csv) {
    return csv->row.line;
}

const char *cr_csv_cell(const struct cr_csv *csv, int column) {
    return field(&csv->row, column);
}

bool cr_csv_scan(const char *text, bool comma, double *out) {
    char buf[64];
    text += strspn(text, " \t");
    size_t n = strlen(text);
    while (n > 0 && (text[n - 1] == ' ' || text[n - 1] == '\t')) {
        n--;
    }
    if (n >= sizeof buf) {
        return false;
    }
    memcpy(buf, text, n);
    buf[n] = '\0';
    char *point = comma ? strchr(buf, ',') : NULL;
    if (point != NULL) {
        *point = '.';
    }
    const char *end;
    *out = cr_number_scan(buf, &end);
    return end != buf && *end == '\0' && isfinite(*out);
}

enum cr_err cr_csv_number(const struct cr_csv *csv, int column, double *out, struct cr_error *err) {
    const char *text = field(&csv->row, column);
    if (text[0] == '\0') {
        *out = (double)NAN;
        return CR_ERR_OK;
    }
    return cr_csv_scan(text, csv->comma, out)
               ? CR_ERR_OK
               : cr_csv_fault(csv, column, err, CR_ERR_TYPE,
                              "'%.60s' in column '%.80s' is not a number", text,
                              field(&csv->head, column));
}

static void place_fault(const struct cr_csv *csv, const struct row *row, int column,
                        struct cr_error *err) {
    bool known = column >= 0 && column < row->n;
    cr_err_place(err, csv->src, row->line, known ? row->col[column] : 1);
}

enum cr_err cr_csv_fault(const struct cr_csv *csv, int column, struct cr_error *err,
                         enum cr_err code, const char *fmt, ...) {
    va_list args;
    va_start(args, fmt);
    cr_err_vset(err, code, fmt, args);
    va_end(args);
    place_fault(csv, &csv->row, column, err);
    return code;
}

enum cr_err cr_csv_head_fault(const struct cr_csv *csv, int column, struct cr_error *err,
                              enum cr_err code, const char *fmt, ...) {
    va_list args;
    va_start(args, fmt);
    cr_err_vset(err, code, fmt, args);
    va_end(args);
    place_fault(csv, &csv->head, column, err);
    return code;
}
