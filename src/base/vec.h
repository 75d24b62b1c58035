/* Plane vectors, poses and angles. World: x east, y north, headings counter-clockwise from x.
 * Vehicle frame (ISO 8855): x forward, y left. Lengths in m, angles in rad. */
#ifndef CR_BASE_VEC_H
#define CR_BASE_VEC_H

#include <math.h>

#define CR_PI 3.14159265358979323846
#define CR_G  9.80665 /* standard gravity, m/s2 */

struct cr_vec2 {
    double x, y;
};

static inline struct cr_vec2 cr_vec2(double x, double y) {
    return (struct cr_vec2){x, y};
}
static inline struct cr_vec2 cr_vec2_add(struct cr_vec2 a, struct cr_vec2 b) {
    return (struct cr_vec2){a.x + b.x, a.y + b.y};
}
static inline struct cr_vec2 cr_vec2_sub(struct cr_vec2 a, struct cr_vec2 b) {
    return (struct cr_vec2){a.x - b.x, a.y - b.y};
}
static inline struct cr_vec2 cr_vec2_scale(struct cr_vec2 a, double k) {
    return (struct cr_vec2){k * a.x, k * a.y};
}
/* a + k b */
static inline struct cr_vec2 cr_vec2_axpy(struct cr_vec2 a, double k, struct cr_vec2 b) {
    return (struct cr_vec2){a.x + k * b.x, a.y + k * b.y};
}
static inline double cr_vec2_dot(struct cr_vec2 a, struct cr_vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/* z component of a x b */
static inline double cr_vec2_cross(struct cr_vec2 a, struct cr_vec2 b) {
    return a.x * b.y - a.y * b.x;
}
/* counter-clockwise normal of a */
static inline struct cr_vec2 cr_vec2_perp(struct cr_vec2 a) {
    return (struct cr_vec2){-a.y, a.x};
}
static inline double cr_vec2_len(struct cr_vec2 a) {
    return sqrt(a.x * a.x + a.y * a.y);
}
/* unit vector of a, or fallback where a has no length */
static inline struct cr_vec2 cr_vec2_unit(struct cr_vec2 a, struct cr_vec2 fallback) {
    double len = cr_vec2_len(a);
    return len > 0 ? (struct cr_vec2){a.x / len, a.y / len} : fallback;
}
/* rotate by the angle whose cosine and sine are c and s */
static inline struct cr_vec2 cr_vec2_rotate(struct cr_vec2 a, double c, double s) {
    return (struct cr_vec2){c * a.x - s * a.y, s * a.x + c * a.y};
}
static inline struct cr_vec2 cr_vec2_unrotate(struct cr_vec2 a, double c, double s) {
    return (struct cr_vec2){c * a.x + s * a.y, c * a.y - s * a.x};
}

/* The lesser and the greater of two numbers, neither of them NaN: fmin and fmax of the library ask
 * for that and are calls. */
static inline double cr_min(double a, double b) {
    return a < b ? a : b;
}
static inline double cr_max(double a, double b) {
    return a > b ? a : b;
}
static inline double cr_clamp(double x, double lo, double hi) {
    return x < lo ? lo : x > hi ? hi : x;
}
/* angle wrapped to (-pi, pi] */
static inline double cr_angle_wrap(double a) {
    a = fmod(a, 2 * CR_PI);
    return a > CR_PI ? a - 2 * CR_PI : a <= -CR_PI ? a + 2 * CR_PI : a;
}
static inline double cr_rad(double deg) {
    return deg * (CR_PI / 180);
}
static inline double cr_deg(double rad) {
    return rad * (180 / CR_PI);
}
/* a bearing as whole degrees, as it is told: 0 to 359 */
static inline double cr_bearing_deg(double rad) {
    double deg = round(cr_deg(rad));
    return deg - 360 * floor(deg / 360);
}
static inline double cr_kmh(double mps) {
    return mps * 3.6;
}
static inline double cr_mps(double kmh) {
    return kmh / 3.6;
}

#endif
