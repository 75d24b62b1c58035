/* Which test car counts as which vehicle type: the rules of share/calibration/types.json, of which
 * the first that fits decides. */
#ifndef CR_TRIAL_TYPES_H
#define CR_TRIAL_TYPES_H

#include "base/err.h"
#include "model/model.h"

#include <stdbool.h>

/* Cars of these bodies up to this mass and length are of the type. */
struct cr_type_rule {
    enum cr_type type;
    char body[16];          /* letters of bodies; "" for any */
    double most_kg, most_m; /* INFINITY for any */
};
enum { CR_TYPE_RULES = 16 };
/* What the types have to do with each other when they are calibrated. */
struct cr_type_ties {
    int borrows[CR_TYPES]; /* type whose tests count as well, -1: none */
    bool apart[CR_TYPES];  /* its tests say nothing of the other types */
};
struct cr_type_rules {
    int n;
    struct cr_type_rule row[CR_TYPE_RULES];
    struct cr_type_ties ties;
};

/* Read the table below the data folder. Errors: IO, MODEL. */
CR_MUST_CHECK enum cr_err cr_type_rules_read(const char *dir, struct cr_type_rules *out,
                                             struct cr_error *err);

/* Type of a car: body letter of the data files, mass as tested in kg, length in m or NaN; -1 if no
 * rule fits. */
int cr_type_rules_find(const struct cr_type_rules *rules, const char *body, double mass,
                       double length);

#endif
