/* Evaluates the expressions of OpenSCENARIO, as in "${2 * $speed / 3.6}". */
#ifndef CR_IMPORT_FORMULA_H
#define CR_IMPORT_FORMULA_H

#include "base/err.h"

/* Gives the value of a $name in an expression. Errors: NAME and others; they end the evaluation. */
struct cr_formula_names {
    enum cr_err (*value)(void *user, const char *name, double *out, struct cr_error *err);
    void *user;
};

/* Evaluates an expression: numbers, $names, true, false, + - * / % ( ), not and or, the comparisons
 * < > <= >= == !=, and the functions abs sign round floor ceil sqrt pow min max sin cos tan asin
 * acos atan atan2, with angles in rad. The result is finite. Errors: SYNTAX, RANGE, and those of
 * names. */
CR_MUST_CHECK enum cr_err cr_formula(const char *text, const struct cr_formula_names *names,
                                     double *out, struct cr_error *err);

#endif
