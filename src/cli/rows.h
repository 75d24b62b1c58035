/* Results of a stack as rows of a table: which values, and their text as CSV or JSON. */
#ifndef CR_CLI_ROWS_H
#define CR_CLI_ROWS_H

#include "base/err.h"
#include "base/str.h"

#include <stdbool.h>

enum { CR_FIELDS_MAX = 128, CR_FIELD_SIZE = 160 };

struct cJSON;

/* Names of values: of results (result/names.h), else of the scene's inputs ("A.speed_kmh",
 * "friction"). */
struct cr_fields {
    int n;
    bool given; /* else chosen by the first solved result */
    char name[CR_FIELDS_MAX][CR_FIELD_SIZE];
};

/* Add "NAME,NAME,...". Errors: USAGE. */
CR_MUST_CHECK enum cr_err cr_fields_add(struct cr_fields *fields, const char *list,
                                        struct cr_error *err);

/* Settle the fields by the first solved result, which must have input.resolved: its vehicles' main
 * measures where none were given, else each must be there. Errors: USAGE, with the nearest one. */
CR_MUST_CHECK enum cr_err cr_fields_settle(struct cr_fields *fields, const struct cJSON *result,
                                           struct cr_error *err);

/* Each vehicle in each impact of a result as a record of its own, in a new array: index, scene,
 * pair, number of the impact from 1, partner, times, stop, closing speed, the keys of the vehicle
 * in it. NULL where memory is out. And the fields of such records by the first result. */
struct cJSON *cr_rows_impacts(const struct cJSON *result);
CR_MUST_CHECK enum cr_err cr_fields_settle_impacts(struct cr_fields *fields,
                                                   const struct cJSON *impacts,
                                                   struct cr_error *err);

/* A value of a record: number (NaN for none) and, where it is one, text (else NULL). */
double cr_fields_value(const struct cJSON *record, const char *name, const char **text);

/* The header of a CSV table, and a record as its row: index, scene, pair, fields, error. */
void cr_rows_csv_header(const struct cr_fields *fields, struct cr_str *out);
void cr_rows_csv(const struct cr_fields *fields, const struct cJSON *record, struct cr_str *out);

/* A record as one object with the fields as keys. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_rows_json(const struct cr_fields *fields, const struct cJSON *record,
                                       struct cr_str *out, struct cr_error *err);

#endif
