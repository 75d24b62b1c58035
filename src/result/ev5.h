/* Reads the records of NHTSA's crash tests: an EV5 file tells the test, the channels (".001") with
 * the measured curves lie beside it. */
#ifndef CR_RESULT_EV5_H
#define CR_RESULT_EV5_H

#include "base/err.h"

#include <stdbool.h>
#include <stddef.h>

enum { CR_EV5_FIELDS = 120 };
/* Fields of section INSTRUMENTATION, matched by their values in tests 10146 and 7292. */
enum {
    CR_EV5_OF = 1, /* number of the vehicle */
    CR_EV5_CURVE = 2,
    CR_EV5_SENSOR = 3,
    CR_EV5_OCCUPANT = 4,
    CR_EV5_ATTACHMENT = 5,
    CR_EV5_AXIS = 6,
    CR_EV5_UNIT = 8,
    CR_EV5_STATUS = 18
};

/* A record: its section, and its fields between bars, numbered from 1. */
struct cr_ev5_record {
    const char *section; /* "VEHICLE" */
    int line, n;
    const char *field[CR_EV5_FIELDS + 1];
};

struct cr_ev5 {
    char *text; /* owned, cut into fields */
    const char *shown;
    struct cr_ev5_record *record;
    int n, size;
};

/* Cuts the text of an EV5 file, UTF-8 or Latin-1, into records; `shown`, borrowed, names the file
 * in errors. cr_ev5_fini gives back, also after an error. Errors: RANGE (too many records), MEMORY,
 * with the line. */
CR_MUST_CHECK enum cr_err cr_ev5_parse(const char *text, const char *shown, struct cr_ev5 *out,
                                       struct cr_error *err);
void cr_ev5_fini(struct cr_ev5 *ev5);

/* The k-th record of a section, NULL if there is none. */
const struct cr_ev5_record *cr_ev5_find(const struct cr_ev5 *ev5, const char *section, int k);
/* Field i as text, "" where it is missing. */
const char *cr_ev5_text(const struct cr_ev5_record *r, int i);
/* Field i as a number, NaN where it is empty. With zero = false 0 is NaN too, as NHTSA writes 0 for
 * what was not recorded. Errors: TYPE with section, field and line. */
CR_MUST_CHECK enum cr_err cr_ev5_number(const struct cr_ev5 *ev5, const struct cr_ev5_record *r,
                                        int i, bool zero, double *out, struct cr_error *err);
/* Fills in an error about field i, with its section and line; returns code. */
enum cr_err cr_ev5_fault(const struct cr_ev5 *ev5, const struct cr_ev5_record *r, int i,
                         struct cr_error *err, enum cr_err code, const char *what);

/* The record in INSTRUMENTATION of an acceleration of the vehicle of that number along an axis
 * ('X', 'Y'), measured at the CG if there is one there, else at a seat, the floor or elsewhere;
 * NULL without. */
const struct cr_ev5_record *cr_ev5_accel(const struct cr_ev5 *ev5, const char *vehicle, char axis);
/* The record in INSTRUMENTATION of the curve of that number; NULL without. */
const struct cr_ev5_record *cr_ev5_curve(const struct cr_ev5 *ev5, long number);
/* The file of a record's channel beside the EV5 file of that path, "v07292.008", into buf; false if
 * the record has no curve number, or there is no such file. */
bool cr_ev5_file(const char *path, const struct cr_ev5_record *r, char *buf, size_t size);

#endif
