/* The scene from above, inside: a sheet with its scale, and what is written over the bodies. */
#ifndef CR_FIGURE_PLAN_H
#define CR_FIGURE_PLAN_H

#include "figure/ink.h"
#include "render/picture.h"

struct cr_sheet {
    struct cr_canvas *canvas;
    const struct cr_figure_words *words;
    const struct cr_scene_view *view;
    struct cr_pic pic;
    struct cr_box map;     /* what the world is drawn into */
    double k;              /* points per m */
    struct cr_vec2 centre; /* world point in its middle */
};

struct cr_vec2 cr_sheet_at(const struct cr_sheet *sheet, struct cr_vec2 world);
/* Trails, letters, arrows, labels, north. */
void cr_sheet_marks(struct cr_sheet *sheet);
/* Scale bar, colours, hatches. */
void cr_sheet_legend(const struct cr_sheet *sheet, struct cr_box at);

#endif
