/* The collision deformation classification of SAE J224: seven characters that say from where, on
 * which face, how wide and how deep a car was struck, "12FDEW2". */
#ifndef CR_RESULT_CDC_H
#define CR_RESULT_CDC_H

#include "model/grid.h"

#include <stdbool.h>

/* What the classification is made of [CDC-J224]. */
struct cr_cdc_case {
    double pdof;       /* rad clockwise */
    enum cr_face face; /* struck face */
    double lo, hi;     /* the direct damage reaches from lo to hi, as shares of the face, 0..1:
                          left to right on the ends, rear to front on the sides */
    double width;      /* of the direct damage, m */
    double depth;      /* residual, square to the face, m */
    double zone;       /* depth of nine extent zones, m */
    char vertical;     /* column 5: which heights were struck, A E G H M L; 0: E */
    bool sideswipe;    /* the partner slid along, with little change of velocity */
};
void cr_cdc_write(const struct cr_cdc_case *what, char cdc[12]);

/* "front", "left", "rear" or "right"; "" for CR_FACES, which stands for no face. */
const char *cr_face_word(enum cr_face face);

#endif
