/* Draws the whole screen but the prompt line from data into cells, which src/tui copies to the
 * terminal. */
#ifndef CR_RENDER_SCREEN_H
#define CR_RENDER_SCREEN_H

#include "render/panes.h"

struct cr_screen {
    struct cr_title title;
    enum cr_area view, active; /* the pane with the focus is active; CR_AREAS: the prompt has it */
    bool zoomed;
    const struct cr_scene *scene;         /* resolved as far as possible; NULL: none */
    const struct cr_compiled *compiled;   /* NULL: not compiled yet */
    const struct cr_result *result;       /* NULL: not solved yet */
    const struct cr_solution *live;       /* a solve under way, NULL: none; it takes the place of */
    const struct cr_case *live_case;      /* compiled and result; the case it belongs to */
    bool stale;                           /* the result was of the scene as it was before */
    struct cr_scene_view scene_view;      /* its time is that of all panes */
    const struct cr_reference *reference; /* measured values for the table, NULL: none */
    enum cr_quantity quantity;            /* quantity of the pulse pane, CR_QUANTITIES: |a| */
    const struct cr_sheet *sweep;         /* NULL: none yet */
    const struct cr_render_line *log;
    int log_n, log_back; /* how many lines, and how many of them the view is scrolled up */
    int talk, talk_down; /* how many of the last lines are to be read now (a lesson; 0: none in
                            particular), and how many of these are scrolled past */
    int table_down;      /* rows the table is scrolled down */
    const char *hint;    /* help for the command being typed, NULL: none */
    const struct cr_render_key *key;
    int keys;
};

/* Draws everything into cells of the terminal's size; *layout receives the rectangles, for the
 * mouse and the prompt. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_render_screen(struct cr_cells *cells, const struct cr_look *look,
                                           const struct cr_screen *screen, struct cr_layout *layout,
                                           struct cr_error *err);

#endif
