/* Face curves: energy per kg over depth, dynamic and residual (share/doc/method.md, "residual_curve
 * and both depths"). */
#include "config.h"

#include "model/model_priv.h"

#include <math.h>

/* Segment of the knots that x lies in, or the nearest one; the ends are extended. */
static int segment(const struct cr_model_knots *k, double x) {
    int i = 0;
    while (i + 2 < k->n && x >= k->x[i + 1]) {
        i++;
    }
    return i;
}

double cr_model_knots_at(const struct cr_model_knots *k, double x) {
    int i = segment(k, x);
    double u = (x - k->x[i]) / (k->x[i + 1] - k->x[i]);
    u = u < 0 ? 0 : u > 1 ? 1 : u;
    return u == 1 ? k->y[i + 1] : k->y[i] + u * (k->y[i + 1] - k->y[i]);
}

/* Force per kg of vehicle mass at the last knot, N/kg: the derivative of EES^2/2. */
static double force_at_end(const struct cr_model_face *f) {
    const struct cr_model_knots *k = &f->ees;
    double a = k->y[k->n - 2], b = k->y[k->n - 1], per = 1 / (k->x[k->n - 1] - k->x[k->n - 2]);
    return f->energy_linear ? (b * b - a * a) / 2 * per : b * (b - a) * per;
}

/* Energy per kg of the dynamic curve; behind the last knot its last slope goes on, or the steady
 * force of the compartment, which is never less than what stands before it. */
static double dynamic_energy(const struct cr_model_face *f, double depth) {
    const struct cr_model_knots *k = &f->ees;
    double last = k->x[k->n - 1];
    if (depth <= 0) {
        return 0;
    }
    if (f->beyond > 0 && depth > last) {
        return k->y[k->n - 1] * k->y[k->n - 1] / 2 +
               fmax(f->beyond, force_at_end(f)) * (depth - last);
    }
    int i = segment(k, depth);
    double u = (depth - k->x[i]) / (k->x[i + 1] - k->x[i]);
    double a = k->y[i], b = k->y[i + 1];
    if (f->energy_linear) {
        return (a * a + u * (b * b - a * a)) / 2;
    }
    double v = a + u * (b - a);
    return v * v / 2;
}

/* The residual curve is the dynamic one moved by the springback. The energy that leaves no residual
 * depth (`hidden`) fades in over the first `spread` metres, so that the curve starts at zero
 * [FRONT-START]. */
double cr_model_face_energy(const struct cr_model_face *f, enum cr_curve curve, double depth) {
    if (depth <= 0) {
        return 0;
    }
    if (curve == CR_CURVE_DYNAMIC || f->springback <= 0) {
        return dynamic_energy(f, depth);
    }
    double hidden = dynamic_energy(f, f->springback);
    double rest = f->spread > depth ? hidden * (1 - depth / f->spread) : 0;
    return dynamic_energy(f, depth + f->springback) - rest;
}

void cr_model_face_scale(struct cr_model_face *face, double by) {
    for (int i = 0; i < face->ees.n; i++) {
        face->ees.y[i] *= by;
    }
}

double cr_model_built_strength(const struct cr_model_face *face, double year) {
    return year > 0 && face->built.n > 0 ? cr_model_knots_at(&face->built, year) : 1;
}
