/* Exponential, logarithm, power, sine, cosine and the angle of a vector by sums, products and
 * quotients alone, which IEEE 754 rounds alike everywhere: the same bits on every processor and
 * with every C library. Those of the libraries differ in the last place. */
#ifndef CR_BASE_ELEMENTARY_H
#define CR_BASE_ELEMENTARY_H

#include "base/vec.h"

/* Within one unit of the last place of the true value, as is the logarithm. */
double cr_exp(double x);
/* Natural logarithm; of 0 it is minus infinite, of less no number. */
double cr_log(double x);
/* x >= 0 to the power y != 0, by the two above: within 1 + 3 |y log x| units of the last place. */
double cr_pow(double x, double y);
/* Sine and cosine within one unit of the last place up to 1e5 rad; beyond, the angle counts by
 * whole turns of 2 pi as it is rounded. Odd and even to the bit. */
void cr_sincos(double x, double *sine, double *cosine);
double cr_sin(double x);
double cr_cos(double x);
/* Angle of (x, y) from the x axis, -pi to pi, as atan2 of C with all its zeros and infinities;
 * within two and a half units of the last place. */
double cr_atan2(double y, double x);

/* unit vector at an angle from the x axis */
struct cr_vec2 cr_vec2_toward(double angle);
/* a turned counter-clockwise by an angle */
struct cr_vec2 cr_vec2_turn(struct cr_vec2 a, double by);

#endif
