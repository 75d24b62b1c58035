/* The one reader of tables as text (CSV): row by row, in constant memory however long the file.
 *
 * Columns stand between commas, semicolons or tabs, whichever the header has outside of quotes; a
 * byte order mark, CRLF, quoted fields (also over several lines, "" for a quote), blank lines and
 * lines that begin with # are taken as they come. With semicolons or tabs a comma in a number is
 * its decimal point. Bytes that are not UTF-8 are read as Latin-1. UTF-16 is refused by name. */
#ifndef CR_BASE_CSV_H
#define CR_BASE_CSV_H

#include "base/err.h"
#include "base/units.h"

#include <stdbool.h>
#include <stddef.h>

struct cr_csv;

struct cr_csv_opts {
    const char *path;   /* file, "-" is standard input; with text: its name in errors */
    const char *text;   /* NULL, or the table itself; the caller keeps it until it is closed */
    size_t len;         /* bytes of text */
    int line;           /* number of the first line of text in its file; 0: 1 */
    const char *header; /* NULL, or how the header row begins: rows before it are passed over */
    bool units;         /* a row of units may stand below the header */
};

/* Open a table and read its header. Errors: IO; SYNTAX for UTF-16, for no header and for a row
 * beyond 16 MB; MISSING for an empty file; MEMORY. The caller closes it. */
CR_MUST_CHECK enum cr_err cr_csv_open(const struct cr_csv_opts *opts, struct cr_csv **out,
                                      struct cr_error *err);
void cr_csv_close(struct cr_csv *csv);

/* Whether numbers have a decimal comma: with semicolons or tabs. */
bool cr_csv_comma(const struct cr_csv *csv);

int cr_csv_columns(const struct cr_csv *csv);
/* Name of column i as the header has it, without quotes and blanks around it. */
const char *cr_csv_name(const struct cr_csv *csv, int i);
/* First column of that name, -1 if there is none. */
int cr_csv_find(const struct cr_csv *csv, const char *name);
/* The column of that name. Errors: NAME with the nearest or all names; DUPLICATE. */
CR_MUST_CHECK enum cr_err cr_csv_need(const struct cr_csv *csv, const char *name, int *column,
                                      struct cr_error *err);

/* Unit of a column from the row of units, else from its name (cr_unit_of_column); NULL if it has
 * none. dim: what the column should be, CR_DIMS for anything. Errors: NAME with the place. */
CR_MUST_CHECK enum cr_err cr_csv_unit(const struct cr_csv *csv, int column, enum cr_dim dim,
                                      const struct cr_unit **unit, struct cr_error *err);

/* Go to the next row; *row is false after the last. Errors: SYNTAX for a row of another length
 * than the header, IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_csv_next(struct cr_csv *csv, bool *row, struct cr_error *err);

/* Line of the present row, 1-based. */
int cr_csv_line(const struct cr_csv *csv);
/* Field of the present row, valid until the next; "" where it is empty or column is -1. */
const char *cr_csv_cell(const struct cr_csv *csv, int column);
/* The same as a number, NaN where it is empty. Errors: TYPE with line and column. */
CR_MUST_CHECK enum cr_err cr_csv_number(const struct cr_csv *csv, int column, double *out,
                                        struct cr_error *err);

/* Fill in an error about a field of the present row (column -1: the row), with its place. */
enum cr_err cr_csv_fault(const struct cr_csv *csv, int column, struct cr_error *err,
                         enum cr_err code, const char *fmt, ...) CR_PRINTF(5, 6);

/* The same about a name in the header. */
enum cr_err cr_csv_head_fault(const struct cr_csv *csv, int column, struct cr_error *err,
                              enum cr_err code, const char *fmt, ...) CR_PRINTF(5, 6);

/* "1.5" or "1,5" as a finite number, the whole of the text but blanks around it. */
bool cr_csv_scan(const char *text, bool comma, double *out);

#endif
