/* Tables of crash tests: CSV files with a header row of column names; # begins a comment line. */
#ifndef CR_TRIAL_RECORDS_H
#define CR_TRIAL_RECORDS_H

#include "base/err.h"

enum { CR_RECORDS_COLUMNS = 64 };

struct cr_records {
    int columns, rows;
    const char *column[CR_RECORDS_COLUMNS];
    const char **cell; /* [rows * columns]; "" for an empty field */
    int *line;         /* [rows] in the file */
    char *text;        /* owner of the texts */
    char src[512];
};

/* Errors: IO, SYNTAX with the line of a row that has not as many fields as the header. */
CR_MUST_CHECK enum cr_err cr_records_load(const char *path, struct cr_records *out,
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
