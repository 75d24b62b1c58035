/* Units: one table, and the reading of "number[unit]" against the dimension that is wanted.
 * Everything inside the program is SI; this is the only place that converts. */
#ifndef CR_BASE_UNITS_H
#define CR_BASE_UNITS_H

#include "base/err.h"

#include "base/str.h"

#include <stdbool.h>
#include <stddef.h>

/* X(NAME, what it is called in messages) */
#define CR_DIM_LIST(X)                                                                             \
    X(NUMBER, "a number")                                                                          \
    X(LENGTH, "a length")                                                                          \
    X(MASS, "a mass")                                                                              \
    X(SPEED, "a speed")                                                                            \
    X(ANGLE, "an angle")                                                                           \
    X(TIME, "a time")                                                                              \
    X(FORCE, "a force")                                                                            \
    X(ENERGY, "an energy")                                                                         \
    X(ACCELERATION, "an acceleration")                                                             \
    X(INERTIA, "a moment of inertia")                                                              \
    X(YAW_RATE, "a yaw rate")                                                                      \
    X(YAW_ACCELERATION, "a yaw acceleration")                                                      \
    X(STIFFNESS_A, "a force per width")                                                            \
    X(STIFFNESS_B, "a force per width and depth")                                                  \
    X(AREA, "an area")

enum cr_dim {
#define X(name, text) CR_DIM_##name,
    CR_DIM_LIST(X)
#undef X
        CR_DIMS
};

/* SI value = number * mul / div; the two keep decimal factors exact in both directions. */
struct cr_unit {
    const char *name; /* "km/h"; "" for the bare number */
    enum cr_dim dim;
    double mul, div;
    const char *suffix; /* with which JSON keys in this unit end, "" if none do */
};

/* Unit of a dimension by name or another spelling of it (unit_words.c: kph, sec, m/s^2, lbf ...);
 * an empty name is the SI unit. NULL if there is none. */
const struct cr_unit *cr_unit_find(const char *name, enum cr_dim dim);

/* Unit i of a dimension in the order of the table, NULL after the last (for completion). */
const struct cr_unit *cr_unit_nth(enum cr_dim dim, int i);

/* Unit by a spelling in any case, with blanks, brackets, exponents and signs as people and loggers
 * write them: "[m/s^2]", "m/s²", "G'S", "msec". dim CR_DIMS: of any dimension, where "g" is the
 * acceleration and "lb" the mass. NULL if there is none. */
const struct cr_unit *cr_unit_spelled(const char *text, enum cr_dim dim);

/* The same with an error; "-" and "" are no unit, *unit NULL. Errors: NAME. */
CR_MUST_CHECK enum cr_err cr_unit_read(const char *text, enum cr_dim dim,
                                       const struct cr_unit **unit, struct cr_error *err);

/* Unit that stands in the name of a column: in brackets, "Speed (km/h)", "t [ms]", or behind the
 * quantity, "v_kmh", "yaw_rate_deg_s", "accel_x_g_cfc60"; *unit is NULL where there is none. Where
 * no bracket holds a unit, square ones are at fault, and round ones if there is none behind either.
 * Errors: NAME for what is not known or not of the dimension dim (CR_DIMS: any).
 */
CR_MUST_CHECK enum cr_err cr_unit_of_column(const char *name, enum cr_dim dim,
                                            const struct cr_unit **unit, struct cr_error *err);

/* "a speed" */
const char *cr_dim_word(enum cr_dim dim);

double cr_unit_to_si(const struct cr_unit *unit, double x);

/* The number with the fewest digits that cr_unit_to_si takes to the same SI value, so that 56 km/h
 * is written 56 again. */
double cr_unit_from_si(const struct cr_unit *unit, double si);

/* A decimal number at the start of text (sign, digits, fraction, exponent; no inf, nan or hex);
 * *end is set behind it. Returns 0 and leaves *end at text where there is none. */
double cr_number_scan(const char *text, const char **end);

/* "2,2t", "1,500": hints at what to write where one number is wanted. False: nothing like it. */
bool cr_number_hint_comma(const char *text, struct cr_error *err);

/* ---- output (units_shown.c) ---- */

/* X(NAME, word of the command line). The metric system is km/h, m, kg, kN, kJ as engineers write
 * them; US customary: mph, ft, in (depths), lb, lbf, ft-lb. Files that programs read stay SI. */
#define CR_UNITS_LIST(X) X(SI, "si") X(US, "us")
#define CR_UNITS_WORDS   "si|us"
enum cr_units {
#define X(name, word) CR_UNITS_##name,
    CR_UNITS_LIST(X)
#undef X
};
/* A depth of deformation: m, or in. */
#define CR_SHOWN_DEPTH "m depth"
/* The unit to write in place of a metric one ("km/h", CR_SHOWN_DEPTH ...), with *x (nullable), a
 * number in the latter, taken to it, and *decimals (nullable, >= 0) those that say as much. Units
 * that are in both systems (g, deg, ms, %) stay. */
const char *cr_units_shown(enum cr_units units, const char *unit, double *x, int *decimals);
/* "34.8 mph" */
const char *cr_units_print(enum cr_units units, const char *unit, double x, int decimals, char *buf,
                           size_t size);
/* A line of words with every number before a metric unit as those units have it: "at 56.0 km/h" ->
 * "at 34.8 mph", "(1.20, 0.50) m" -> "(3.94, 1.64) ft". */
void cr_units_text(enum cr_units units, const char *text, struct cr_str *out);
/* The same with the decimal point of another language. */
void cr_units_words(enum cr_units units, char point, const char *text, struct cr_str *out);

/* "number[unit]" -> SI. Without a unit the number is in `plain` (NULL: SI). *unit (nullable)
 * receives the unit that was used. Errors: TYPE for what is no number, NAME for a unit that does
 * not exist or belongs to another dimension (hint: those that fit), RANGE for what is not finite.
 */
CR_MUST_CHECK enum cr_err cr_unit_parse(const char *text, enum cr_dim dim,
                                        const struct cr_unit *plain, double *si,
                                        const struct cr_unit **unit, struct cr_error *err);

#endif
