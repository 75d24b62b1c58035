/* What the two files that read NHTSA's crash tests share: records of an EV5 file. */
#ifndef CR_IMPORT_EV5_PRIV_H
#define CR_IMPORT_EV5_PRIV_H

#include "import/reader.h"

struct cJSON;

enum { CR_EV5_FIELDS = 120, CR_EV5_VEHICLES = 2 };

/* A record: its section, its fields between bars, numbered from 1. */
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

/* Cut the text of an EV5 file into records; the text is taken over. cr_ev5_fini gives back, also
 * after an error. Errors: SYNTAX, RANGE, MEMORY, with the line. */
CR_MUST_CHECK enum cr_err cr_ev5_parse(char *text, const char *shown, struct cr_ev5 *out,
                                       struct cr_error *err);
void cr_ev5_fini(struct cr_ev5 *ev5);

/* The k-th record of a section, NULL if there is none. */
const struct cr_ev5_record *cr_ev5_find(const struct cr_ev5 *ev5, const char *section, int k);
/* Field i as text, "" where it is missing. */
const char *cr_ev5_text(const struct cr_ev5_record *r, int i);
/* Field i as a number, NaN where it is empty or, with zero = false, 0: "not recorded". Errors: TYPE
 * with section, field and line. */
CR_MUST_CHECK enum cr_err cr_ev5_number(const struct cr_ev5 *ev5, const struct cr_ev5_record *r,
                                        int i, bool zero, double *out, struct cr_error *err);
/* Fill in an error about a field, named with its section and meaning. */
enum cr_err cr_ev5_fault(const struct cr_ev5 *ev5, const struct cr_ev5_record *r, int i,
                         struct cr_error *err, enum cr_err code, const char *what);

#endif
