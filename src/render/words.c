/* Numbers and words as all tables show them. */
#include "render/table.h"

#include <math.h>
#include <stdio.h>

void cr_render_number(double x, int decimals, char *buf, int size) {
    if (!isfinite(x)) {
        snprintf(buf, (size_t)size, "-");
        return;
    }
    x = fabs(x) < 0.5 * pow(10, -decimals) ? 0 : x; /* no "-0.0" */
    snprintf(buf, (size_t)size, "%.*f", decimals, x);
}

const char *cr_render_face(enum cr_face face) {
    static const char *const words[CR_FACES] = {"front", "left", "rear", "right"};
    return face < CR_FACES ? words[face] : "-";
}
