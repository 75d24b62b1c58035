/* Writes the collision deformation classification of SAE J224, and the words of the faces. */
#include "result/result_priv.h"

#include <math.h>
#include <stdio.h>

/* Direct damage narrower than 16 in counts as narrow, m [CDC-J224]. */
static const double narrow = 0.41;
/* This share of a third must be struck for the third to count (our choice). */
static const double touched = 0.1;

const char *cr_face_word(enum cr_face face) {
    static const char *const words[CR_FACES] = {[CR_FACE_FRONT] = "front",
                                                [CR_FACE_LEFT] = "left",
                                                [CR_FACE_REAR] = "rear",
                                                [CR_FACE_RIGHT] = "right"};
    return face < CR_FACES ? words[face] : "";
}

/* The letter of column 4 tells which thirds of the face were struck; bit 0 is the first third. */
static char lateral(enum cr_face face, int thirds) {
    /* front and rear from left to right: L C R, Y = L + C, Z = C + R */
    static const char end_letter[8] = {'C', 'L', 'C', 'Y', 'R', 'D', 'Z', 'D'};
    /* sides from rear to front: B P F, Z = P + B, Y = F + P */
    static const char side_letter[8] = {'P', 'B', 'P', 'Z', 'F', 'D', 'Y', 'D'};
    return cr_face_is_end(face) ? end_letter[thirds] : side_letter[thirds];
}

void cr_cdc_write(const struct cr_cdc_case *what, char cdc[12]) {
    static const char face_letter[CR_FACES] = {
        [CR_FACE_FRONT] = 'F', [CR_FACE_LEFT] = 'L', [CR_FACE_REAR] = 'B', [CR_FACE_RIGHT] = 'R'};
    int thirds = 0;
    for (int i = 0; i < 3; i++) {
        double in = fmin(what->hi, (i + 1) / 3.0) - fmax(what->lo, i / 3.0);
        thirds |= (in > touched / 3) << i;
    }
    char kind = what->sideswipe ? 'S' : what->width < narrow ? 'N' : 'W';
    int extent = what->zone > 0 ? (int)ceil(9 * what->depth / what->zone - 1e-9) : 1;
    extent = extent < 1 ? 1 : extent > 9 ? 9 : extent;
    snprintf(cdc, 12, "%02d%c%c%c%c%d", cr_pdof_clock(what->pdof), face_letter[what->face],
             lateral(what->face, thirds), what->vertical != '\0' ? what->vertical : 'E', kind,
             extent);
}
