/* Draws a measured outline over the voxel model of its vehicle, from above and from the side. */
#ifndef CR_DAMAGE_PICTURE_H
#define CR_DAMAGE_PICTURE_H

#include "damage/crush.h"
#include "render/render.h"

/* How it is drawn. */
struct cr_crush_look {
    const struct cr_model_lib *lib;
    const struct cr_look *look;
    int width; /* columns */
};
/* Add the lines of both views: voxels that gave energy are digits, their depth in dm; the others
 * are shades of their EES. Errors: those of the model, MEMORY. */
CR_MUST_CHECK enum cr_err cr_crush_picture(const struct cr_crush_car *car,
                                           const struct cr_crush_rules *rules,
                                           const struct cr_crush_look *how, struct cr_str *out,
                                           struct cr_error *err);

#endif
