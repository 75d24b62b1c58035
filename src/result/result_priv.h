/* What the files of src/result share: risk functions, damage classification, warnings. */
#ifndef CR_RESULT_RESULT_PRIV_H
#define CR_RESULT_RESULT_PRIV_H

#include "result/result.h"

/* What a risk function is asked for. */
struct cr_irf_case {
    double delta_v, closing, ees; /* m/s; closing NaN if there was no partner */
    double pdof;                  /* rad clockwise */
    bool vehicle_partner;         /* the main partner is a vehicle */
};

/* Probabilities of all functions that apply to the case into severity->injury. */
void cr_irf_apply(const struct cr_irf_set *set, const struct cr_irf_case *what,
                  struct cr_severity *severity);

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

/* Contact of a body in which it took the greatest impulse; -1 without contacts. */
int cr_result_main_contact(const struct cr_solution *sol, int body);

/* PDOF, rad clockwise 0..2 pi, of a velocity change in the vehicle's frame. */
double cr_result_pdof(struct cr_vec2 delta_v_body);

/* Adds a warning, cut to its length; the last place says that there were more. code: a word for
 * programs, that stays the same. */
void cr_result_warn(struct cr_result *result, const char *code, const char *fmt, ...)
    CR_PRINTF(3, 4);

/* Warnings for all limits of validity the measured result leaves. */
void cr_result_check(struct cr_result *result);

#endif
