/* Results by name, for assert, compare and sweep: "A.ees", "B.delta_v", "stop". */
#ifndef CR_CMD_MEASURE_H
#define CR_CMD_MEASURE_H

#include "cmd/cmd_priv.h"
#include "result/measures.h"

#include <stddef.h>

/* Value of a name that assert knows: a result, else an input of the scene. */
struct cr_quantity_value {
    bool is_word;
    char word[CR_PATH_MAX];
    double si;
    const struct cr_unit *unit; /* in which it is shown */
    int decimals;               /* -1: as many as it has */
};
enum cr_err cr_measure_eval(struct cr_session *s, const char *name, struct cr_quantity_value *out,
                            struct cr_error *err);

/* Which result of which of n participants (-1: all) the argument plot= names: "A.ees"; else the EES
 * of all. Errors: NAME. */
enum cr_err cr_measure_plot(struct cr_call *call, const char (*id)[CR_NAME_MAX], int n, int *part,
                            const struct cr_measure **m, struct cr_error *err);

#endif
