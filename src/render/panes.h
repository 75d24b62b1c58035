/* Panes of the full screen, drawn into cells: frames, title bar, results, sparklines, sweep table,
 * log, key bar. They know nothing of curses and of commands: what they show is passed in. */
#ifndef CR_RENDER_PANES_H
#define CR_RENDER_PANES_H

#include "render/layout.h"

/* Frame of a pane with its title; with tabs (view 0.. as in the layout, all six named) instead when
 * title is NULL. joined: no left border, the neighbour's right one is shared. Returns the inside.
 */
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
    CR_TITLE_INTERRUPTED, /* ^C: shown is what was solved until then */
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

/* The quantities that matter most, in 26 columns and more. time NaN: final; selected: a
 * participant that must be among those there is room for, -1: the first ones are. */
void cr_render_results(struct cr_cells *cells, struct cr_rect at, const struct cr_result *result,
                       double time, int selected);

/* |a| of moving participants, a row each, with its peak: the first ones, and the one selected.
 * view: its time is where the cursor stands. */
CR_MUST_CHECK enum cr_err cr_render_sparks(struct cr_cells *cells, struct cr_rect at,
                                           const struct cr_look *look,
                                           const struct cr_result *result,
                                           const struct cr_scene_view *view, struct cr_error *err);
/* Time of the scene (s) that a column of a spark line stands for; NaN outside of it. */
double cr_render_spark_time(struct cr_rect at, const struct cr_result *result, int column);

/* A table of texts: a heading per column, rows, and one row chosen (-1: none). */
struct cr_sheet {
    int columns, rows;
    const char *const *head; /* [columns] */
    const char *const *cell; /* [rows * columns], NULL: empty */
    int chosen;
    const char *note; /* last row, NULL: none */
    double progress;  /* 0..1: a bar above the note, NaN: none */
};
void cr_render_sheet(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                     const struct cr_sheet *sheet);

struct cr_render_line {
    enum cr_role role; /* KEY: a command, TEXT: an answer, WARN, BAD ... */
    const char *text;
};
/* The last lines that fit, `back` lines further up; each cut with ~, never wrapped. */
void cr_render_log(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                   const struct cr_render_line *line, int n, int back);

struct cr_render_key {
    const char *key, *label;
};
/* Keys in order of weight; those that do not fit are left out. */
void cr_render_keys(struct cr_cells *cells, struct cr_rect at, const struct cr_render_key *key,
                    int n);

/* Box over other panes with a title, for help and the palette; returns the inside. */
struct cr_rect cr_render_overlay(struct cr_cells *cells, const struct cr_look *look, int w, int h,
                                 const char *title);

#endif
