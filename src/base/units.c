/* The one table of units. */
#include "base/units.h"

#include "base/number.h"
#include "base/vec.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* the first row of a dimension is its SI unit */
static const struct cr_unit units[] = {
    {"", CR_DIM_NUMBER, 1, 1, ""},
    {"%", CR_DIM_NUMBER, 1, 100, ""},
    {"m", CR_DIM_LENGTH, 1, 1, "_m"},
    {"cm", CR_DIM_LENGTH, 1, 100, ""},
    {"mm", CR_DIM_LENGTH, 1, 1000, "_mm"},
    {"km", CR_DIM_LENGTH, 1000, 1, ""},
    {"ft", CR_DIM_LENGTH, 0.3048, 1, ""},
    {"in", CR_DIM_LENGTH, 0.0254, 1, ""},
    {"kg", CR_DIM_MASS, 1, 1, "_kg"},
    {"t", CR_DIM_MASS, 1000, 1, ""},
    {"lb", CR_DIM_MASS, 0.45359237, 1, ""},
    {"g", CR_DIM_MASS, 1, 1000, ""},
    {"m/s", CR_DIM_SPEED, 1, 1, "_mps"},
    {"km/h", CR_DIM_SPEED, 1, 3.6, "_kmh"},
    {"mph", CR_DIM_SPEED, 0.44704, 1, ""},
    {"ft/s", CR_DIM_SPEED, 0.3048, 1, ""},
    {"rad", CR_DIM_ANGLE, 1, 1, ""},
    {"deg", CR_DIM_ANGLE, CR_PI / 180, 1, "_deg"},
    {"s", CR_DIM_TIME, 1, 1, "_s"},
    {"ms", CR_DIM_TIME, 1, 1000, "_ms"},
    {"us", CR_DIM_TIME, 1, 1000000, ""},
    {"N", CR_DIM_FORCE, 1, 1, ""},
    {"kN", CR_DIM_FORCE, 1000, 1, "_kN"},
    {"lbf", CR_DIM_FORCE, 4.4482216152605, 1, ""},
    {"kip", CR_DIM_FORCE, 4448.2216152605, 1, ""},
    {"J", CR_DIM_ENERGY, 1, 1, ""},
    {"kJ", CR_DIM_ENERGY, 1000, 1, "_kJ"},
    {"m/s2", CR_DIM_ACCELERATION, 1, 1, "_mps2"},
    {"g", CR_DIM_ACCELERATION, CR_G, 1, "_g"},
    {"ft/s2", CR_DIM_ACCELERATION, 0.3048, 1, ""},
    {"kgm2", CR_DIM_INERTIA, 1, 1, "_kgm2"},
    {"rad/s", CR_DIM_YAW_RATE, 1, 1, ""},
    {"deg/s", CR_DIM_YAW_RATE, CR_PI / 180, 1, "_deg_s"},
    {"rad/s2", CR_DIM_YAW_ACCELERATION, 1, 1, ""},
    {"deg/s2", CR_DIM_YAW_ACCELERATION, CR_PI / 180, 1, ""},
    {"N/m", CR_DIM_STIFFNESS_A, 1, 1, "_N_per_m"},
    {"kN/m", CR_DIM_STIFFNESS_A, 1000, 1, ""},
    {"lb/in", CR_DIM_STIFFNESS_A, 175.126835246, 1, ""}, /* 4.4482216 N / 0.0254 m */
    {"N/m2", CR_DIM_STIFFNESS_B, 1, 1, "_N_per_m2"},
    {"kN/m2", CR_DIM_STIFFNESS_B, 1000, 1, ""},
    {"psi", CR_DIM_STIFFNESS_B, 6894.757293168, 1, ""}, /* 4.4482216 N / (0.0254 m)^2 */
    {"m2", CR_DIM_AREA, 1, 1, "_m2"},
};
enum { UNITS = sizeof units / sizeof units[0] };

static const char *const dim_words[CR_DIMS] = {
#define X(name, text) [CR_DIM_##name] = text,
    CR_DIM_LIST(X)
#undef X
};

const char *cr_dim_word(enum cr_dim dim) {
    return dim_words[dim];
}

const struct cr_unit *cr_unit_nth(enum cr_dim dim, int i) {
    for (int k = 0; k < UNITS; k++) {
        if (units[k].dim == dim && i-- == 0) {
            return &units[k];
        }
    }
    return NULL;
}

double cr_unit_to_si(const struct cr_unit *unit, double x) {
    return x * unit->mul / unit->div;
}

double cr_unit_from_si(const struct cr_unit *unit, double si) {
    double x = si * unit->div / unit->mul;
    for (int k = 0; k <= 15; k++) {
        double y = cr_round_decimals(x, k);
        if (cr_unit_to_si(unit, y) == si) {
            return y;
        }
    }
    for (int digits = 15; digits <= 17; digits++) {
        char buf[40];
        snprintf(buf, sizeof buf, "%.*g", digits, x);
        double y = strtod(buf, NULL);
        if (cr_unit_to_si(unit, y) == si) {
            return y;
        }
    }
    return x;
}
