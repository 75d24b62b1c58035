/* The sweep's table, for `table sweep`, `view sweep` and `export sweep`. */
#ifndef CR_CMD_SWEEP_H
#define CR_CMD_SWEEP_H

#include "cmd/cmd_priv.h"
#include "cmd/vary.h"

/* What the line says that varies: axes of the sweep, and var[CR_SWEEP_AXES] of the scene. */
enum cr_err cr_sweep_axes(struct cr_call *call, struct cr_sweep *sweep, struct cr_vary *var,
                          struct cr_error *err);

/* The last sweep as lines. Errors: MISSING without one. */
enum cr_err cr_sweep_say(struct cr_session *s, struct cr_error *err);
/* All results of all runs; units in the head. */
enum cr_err cr_sweep_csv(struct cr_session *s, struct cr_str *out, struct cr_error *err);

/* Can the result that plot= names be drawn? It is kept in the sweep. Errors: NAME. */
enum cr_err cr_sweep_plots(struct cr_call *call, struct cr_sweep *sweep, struct cr_error *err);

/* A picture of a sweep: curves over one input, a map over two, one such map for each combination of
 * the others and each participant; of draws the points over each input. */
struct cr_sweep_picture {
    bool is_map;
    struct cr_heat_map map;
    struct cr_plot plot;
    struct cr_curve_line curve[CR_BODY_MAX];
    char title[240], x_name[80], y_name[80];
    struct cr_arena arena; /* of the caller, after success */
};
int cr_sweep_pictures(const struct cr_sweep *sweep);
/* The picture in which a run lies; which: of those it lies in. */
int cr_sweep_picture_of(const struct cr_sweep *sweep, int which, int run);
/* Picture k < cr_sweep_pictures; chosen: a run to mark, -1: none. Errors: MEMORY. */
enum cr_err cr_sweep_make(const struct cr_sweep *sweep, int k, enum cr_units units, int chosen,
                          struct cr_sweep_picture *out, struct cr_error *err);
enum cr_err cr_sweep_cells(const struct cr_sweep_picture *picture, struct cr_cells *cells,
                           struct cr_rect at, const struct cr_look *look, struct cr_error *err);
/* The first pictures, where pictures are shown at all. */
enum cr_err cr_sweep_draw(struct cr_session *s, struct cr_error *err);

#endif
