/* Lays the full screen out: one pure function leads from the size of the terminal to rectangles. */
#ifndef CR_RENDER_LAYOUT_H
#define CR_RENDER_LAYOUT_H

#include "render/render.h"

/* X(NAME, title of the tab, word of the command `view`) */
#define CR_AREA_LIST(X)                                                                            \
    X(SCENE, "Scene", "scene")                                                                     \
    X(PULSE, "Pulse", "pulse")                                                                     \
    X(ENERGY, "Energy", "energy")                                                                  \
    X(TABLE, "Table", "table")                                                                     \
    X(SWEEP, "Sweep", "sweep")                                                                     \
    X(LOG, "Log", "log")

/* The words as "scene|pulse|...". */
#define CR_AREA_BAR(name, title, word) "|" word
#define CR_AREA_WORDS                  (&(CR_AREA_LIST(CR_AREA_BAR))[1])

enum cr_area {
#define X(name, title, word) CR_AREA_##name,
    CR_AREA_LIST(X)
#undef X
        CR_AREAS
};

enum cr_layout_kind {
    CR_LAYOUT_PROMPT, /* below 40x12: prompt and log only */
    CR_LAYOUT_NARROW, /* below 80x24, or zoomed: one view, no results pane */
    CR_LAYOUT_ONE,    /* one view with results beside it, pulses as lines below */
    CR_LAYOUT_TWO,    /* from 120x36: scene and another view */
    CR_LAYOUT_ALL     /* from 160x44: all panes */
};

/* Rectangles that tile the screen without overlap or gap; w = 0: not shown. Panes and results come
 * with their frame; the results pane has no left border, it shares that of its neighbour. */
struct cr_layout {
    enum cr_layout_kind kind;
    struct cr_rect title, notice; /* the notice says what a larger terminal would show */
    struct cr_rect pane[CR_AREAS], results;
    struct cr_rect spark;    /* pulses as lines */
    struct cr_rect dialogue; /* the last commands and answers */
    struct cr_rect prompt;
    struct cr_rect hint; /* help for the command being typed */
    struct cr_rect keys;
};

/* The layout of a terminal of w x h cells (at least 1 x 1) showing this view; zoomed: the view
 * alone; talk: so many rows of dialogue should be in view (a lesson), 0: the usual. */
struct cr_layout cr_layout_of(int w, int h, enum cr_area view, bool zoomed, int talk);

/* The title of a pane, "Scene", and its word for the command `view`. */
const char *cr_area_title(enum cr_area pane);
const char *cr_area_word(enum cr_area pane);

#endif
