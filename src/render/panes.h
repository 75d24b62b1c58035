/* Draws the panes of the full screen into cells: frames, title bar, results, sparklines, sweep
 * table, log, key bar. They know nothing of curses and of commands: what they show is passed in. */
#ifndef CR_RENDER_PANES_H
#define CR_RENDER_PANES_H

#include "render/layout.h"

/* Draws the frame of a pane with its title, for title NULL with tabs of all views instead, `view`
 * marked. joined: it shares the right border of its left neighbour. Returns the inside. */
struct cr_rect cr_render_frame(const struct cr_target *target, const char *title, enum cr_area view,
                               bool active, bool joined);

enum cr_title_state {
    CR_TITLE_EMPTY,
    CR_TITLE_UNSOLVED,
    CR_TITLE_EDITED,
    CR_TITLE_SOLVING,
    CR_TITLE_SOLVED,
    CR_TITLE_STALE,
    CR_TITLE_FAILED,
    CR_TITLE_INTERRUPTED, /* by ^C: the screen shows what was solved until then */
    CR_TITLE_STATES
};

struct cr_title {
    const char *file; /* NULL: none yet */
    bool unsaved;
    enum cr_title_state state;
    double progress; /* 0..1 while solving */
    int vehicles, objects, undo;
    double time, t_end; /* s after first contact, NaN: none */
    int frame, frames;  /* time slices */
    double dt;          /* s */
    const char *field, *theme;
};
void cr_render_title(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                     const struct cr_title *title);

/* Draws the quantities that matter most, in 26 columns and more. time NaN: the final ones;
 * selected: a participant that must be among those for which there is room, -1: the first ones
 * are. */
void cr_render_results(struct cr_cells *cells, struct cr_rect at, const struct cr_result *result,
                       double time, int selected);

/* Draws |a| of moving participants, a row each, with its peak: the first ones, and the selected
 * one. The cursor stands at the time of the view. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_render_sparks(struct cr_cells *cells, struct cr_rect at,
                                           const struct cr_look *look,
                                           const struct cr_result *result,
                                           const struct cr_scene_view *view, struct cr_error *err);
/* The time of the scene, s, for which a column of a spark line stands; NaN outside of the line. */
double cr_render_spark_time(struct cr_rect at, const struct cr_result *result, int column);

/* A table of texts. */
struct cr_sheet {
    int columns, rows;
    const char *const *head; /* [columns] */
    const char *const *cell; /* [rows * columns], NULL: empty */
    int chosen;              /* row that is marked, -1: none */
    const char *note;        /* last row, NULL: none */
    double progress;         /* length of a bar above the note, 0..1, NaN: none */
};
void cr_render_sheet(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                     const struct cr_sheet *sheet);

struct cr_render_line {
    enum cr_role role; /* KEY: a command, TEXT: an answer, WARN, BAD ... */
    const char *text;
};
/* Draws the last lines that fit, or those `back` lines further up; each is cut with ~, not
 * wrapped. */
void cr_render_log(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                   const struct cr_render_line *line, int n, int back);

struct cr_render_key {
    const char *key, *label;
};
/* Draws the keys with their labels, the most important first; those that do not fit are left
 * out. */
void cr_render_keys(struct cr_cells *cells, struct cr_rect at, const struct cr_render_key *key,
                    int n);

/* Draws a box with a title over other panes, for help and the palette; returns the inside. */
struct cr_rect cr_render_overlay(struct cr_cells *cells, const struct cr_look *look, int w, int h,
                                 const char *title);

#endif
