/* Gives the colours of bodies, curves and fields, and which ink can be read on which. */
#include "figure/ink.h"

#include "base/vec.h"

#include <math.h>

uint32_t cr_ink_of_body(int body) {
    static const uint32_t inks[] = {0x0072b2, 0xd55e00, 0x009e73, 0xa8558a, 0x6a5acd, 0x7a5c00};
    return inks[(unsigned)body % (sizeof inks / sizeof inks[0])];
}

uint32_t cr_ink_of(enum cr_role role) {
    switch (role) {
    case CR_ROLE_A:
        return cr_ink_of_body(0);
    case CR_ROLE_B:
        return cr_ink_of_body(1);
    case CR_ROLE_C:
        return cr_ink_of_body(2);
    case CR_ROLE_OBJECT:
        return CR_INK_RIGID;
    case CR_ROLE_FORCE:
    case CR_ROLE_BAD:
        return CR_INK_FORCE;
    case CR_ROLE_REFERENCE:
    case CR_ROLE_DIM:
        return CR_INK_DIM;
    default:
        return CR_INK_TEXT;
    }
}

/* This is viridis of matplotlib (CC0) from its light end to its dark one; the light end is paled
 * half way to white, so that letters can be read on it. */
uint32_t cr_ink_ramp(int step) {
    static const uint32_t steps[CR_RAMP] = {0xfbf3b0, 0xd9e68c, 0xa5d785, 0x6cc68c, 0x37aa8c,
                                            0x2b8c90, 0x35688d, 0x3d4a86, 0x3f1d66};
    return steps[step < 0 ? 0 : step >= CR_RAMP ? CR_RAMP - 1 : step];
}

int cr_ink_step(double level) {
    return (int)cr_clamp(floor(level * (CR_RAMP - 1)), 0, CR_RAMP - 1);
}

uint32_t cr_ink_on(uint32_t ink) {
    /* The luma of the video standard is good enough to choose between two inks. */
    double luma = 0.299 * (ink >> 16 & 255) + 0.587 * (ink >> 8 & 255) + 0.114 * (ink & 255);
    return luma > 130 ? CR_INK_TEXT : 0xffffff;
}

const char *cr_figure_say(const struct cr_figure_words *words, const char *english) {
    return words != NULL && words->say != NULL ? words->say(english) : english;
}
