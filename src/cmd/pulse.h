/* Measured curves beside the computed ones. */
#ifndef CR_CMD_PULSE_H
#define CR_CMD_PULSE_H

#include "cmd/cmd_priv.h"

struct cr_measured {
    double *t, *y; /* ms, and the unit that the plot of the quantity shows; owned */
    int n;
};

/* CSV with the time first; the column whose head begins with `word`, else the second. Units come
 * from the heads (t_ms, ax_g, v_kmh ...), without one they are s and that of the plot. kind: index
 * in cr_cmd_quantities(). Errors: IO, SYNTAX with line. */
enum cr_err cr_measured_read(const char *path, const char *word, int kind, struct cr_measured *out,
                             struct cr_error *err);
void cr_measured_fini(struct cr_measured *curve);

/* "a|ax|ay|...": the words of `pulse`. */
const char *cr_cmd_quantities(void);

#endif
