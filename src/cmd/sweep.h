/* The sweep's table, for `table sweep`, `view sweep` and `export sweep`. */
#ifndef CR_CMD_SWEEP_H
#define CR_CMD_SWEEP_H

#include "cmd/cmd_priv.h"

/* The last sweep as lines. Errors: MISSING without one. */
enum cr_err cr_sweep_say(struct cr_session *s, struct cr_error *err);
/* All results of all runs; units in the head. */
enum cr_err cr_sweep_csv(struct cr_session *s, struct cr_str *out, struct cr_error *err);

/* Can the result that plot= names be drawn? Asked before the runs. */
enum cr_err cr_sweep_plots(struct cr_call *call, const struct cr_sweep *sweep,
                           struct cr_error *err);
/* Which result of which participant (-1: all) the argument plot= names: "A.ees"; else the EES of
 * all. Errors: NAME. */
struct cr_measure;
enum cr_err cr_sweep_what(struct cr_call *call, const struct cr_sweep *sweep, int *part,
                          const struct cr_measure **measure, struct cr_error *err);
/* Curves over one swept input, maps over two. */
enum cr_err cr_sweep_draw(struct cr_call *call, struct cr_error *err);

#endif
