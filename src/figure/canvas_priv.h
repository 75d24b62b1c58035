/* The inside of a canvas: what was drawn, as its writers walk through it. */
#ifndef CR_FIGURE_CANVAS_PRIV_H
#define CR_FIGURE_CANVAS_PRIV_H

#include "figure/canvas.h"

enum cr_verb { CR_VERB_MOVE, CR_VERB_LINE, CR_VERB_CURVE, CR_VERB_CLOSE };

/* One step of a path; a curve has two control points before its end. */
struct cr_step {
    enum cr_verb verb;
    double x[3], y[3];
};

enum cr_act { CR_ACT_PATH, CR_ACT_TEXT, CR_ACT_CLIP, CR_ACT_UNCLIP };

struct cr_item {
    enum cr_act act;
    int from, n; /* steps of the path, or bytes of the text */
    struct cr_paint paint;
    struct cr_type_face face;
    double x, y, w, h; /* place of a text and how wide it is set; rectangle of a clip */
};

struct cr_canvas {
    double w, h;
    bool failed; /* memory was out */
    int items, item_size, steps, step_size;
    int painted; /* steps before the open path */
    struct cr_item *item;
    struct cr_step *step;
    struct cr_str words;
};

/* Lengths of dashes and of the gaps after them for a line of width 1; 0 ends the list. */
extern const double cr_dash_lengths[CR_DASHES][4];

#endif
