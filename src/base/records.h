/* Tables that are held whole: rows of texts under named columns, read by base/csv.h. */
#ifndef CR_BASE_RECORDS_H
#define CR_BASE_RECORDS_H

#include "base/csv.h"
#include "base/err.h"

#include <stdbool.h>

struct cr_records {
    int columns, rows;
    const char **column; /* [columns] their names */
    const char **cell;   /* [rows * columns]; "" for an empty field */
    int *line;           /* [rows] in the file */
    char *text;          /* owner of the texts */
    bool comma;          /* decimal */
    char src[512];
};

/* Read a whole table, to be freed with cr_records_fini also after an error. Errors: those of
 * cr_csv_open and cr_csv_next. */
CR_MUST_CHECK enum cr_err cr_records_load(const char *path, struct cr_records *out,
                                          struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_records_read(const struct cr_csv_opts *opts, struct cr_records *out,
                                          struct cr_error *err);
void cr_records_fini(struct cr_records *records);

/* Index of a column, -1 if there is none. */
int cr_records_find(const struct cr_records *records, const char *column);

/* Text of a field, "" if the column is not there. */
const char *cr_records_text(const struct cr_records *records, int row, const char *column);

/* Number in a field: NaN if it or its column is empty. Errors: TYPE with the line for a text. */
CR_MUST_CHECK enum cr_err cr_records_number(const struct cr_records *records, int row,
                                            const char *column, double *out, struct cr_error *err);

#endif
