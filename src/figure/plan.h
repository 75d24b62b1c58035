/* What the files that draw the scene from above share: a sheet with its scale, and what is written
 * over the bodies. */
#ifndef CR_FIGURE_PLAN_H
#define CR_FIGURE_PLAN_H

#include "figure/ink.h"
#include "render/picture.h"

struct cr_sheet {
    struct cr_canvas *canvas;
    const struct cr_figure_words *words;
    const struct cr_scene_view *view;
    struct cr_pic pic;
    struct cr_box map;     /* the part of the canvas into which the world is drawn */
    double k;              /* points per m */
    struct cr_vec2 centre; /* the world's point in the middle of the map, m */
};

/* The place on the canvas of a point of the world. */
struct cr_vec2 cr_sheet_at(const struct cr_sheet *sheet, struct cr_vec2 world);
/* Draws trails, letters, arrows, labels, north. */
void cr_sheet_marks(struct cr_sheet *sheet);
/* Draws scale bar, colours and hatches at the foot of the box. */
void cr_sheet_legend(const struct cr_sheet *sheet, struct cr_box at);

#endif
