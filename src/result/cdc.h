/* Collision deformation classification of SAE J224. */
#ifndef CR_RESULT_CDC_H
#define CR_RESULT_CDC_H

#include "model/grid.h"

#include <stdbool.h>

/* What the collision deformation classification of SAE J224 is made of [CDC-J224]. */
struct cr_cdc_case {
    double pdof;       /* rad clockwise */
    enum cr_face face; /* struck face */
    double lo, hi;     /* direct damage along the face, 0..1: left to right, rear to front */
    double width;      /* of the direct damage, m */
    double depth;      /* residual, square to the face, m */
    double zone;       /* depth of nine extent zones, m */
    char vertical;     /* column 5: which heights were struck, A E G H M L; 0: E */
    bool sideswipe;    /* slid along, with little change of velocity */
};
void cr_cdc_write(const struct cr_cdc_case *what, char cdc[12]);

#endif
