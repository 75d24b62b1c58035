/* Whether the corners of a polygon make one: no crossing edges, an area, counter-clockwise. */
#include "scene/scene_priv.h"

#include <math.h>

static double signed_area(const struct cr_vec2 *v, int n) {
    double twice = 0;
    for (int i = 0; i < n; i++) {
        twice += cr_vec2_cross(v[i], v[(i + 1) % n]);
    }
    return twice / 2;
}

static int side_of(struct cr_vec2 a, struct cr_vec2 b, struct cr_vec2 p) {
    double c = cr_vec2_cross(cr_vec2_sub(b, a), cr_vec2_sub(p, a));
    return (c > 0) - (c < 0);
}

/* p, which is in line with a and b, lies between them */
static bool between(struct cr_vec2 a, struct cr_vec2 b, struct cr_vec2 p) {
    return fmin(a.x, b.x) <= p.x && p.x <= fmax(a.x, b.x) && fmin(a.y, b.y) <= p.y &&
           p.y <= fmax(a.y, b.y);
}

static bool edges_meet(struct cr_vec2 a, struct cr_vec2 b, struct cr_vec2 c, struct cr_vec2 d) {
    int s1 = side_of(a, b, c), s2 = side_of(a, b, d), s3 = side_of(c, d, a), s4 = side_of(c, d, b);
    if (s1 * s2 < 0 && s3 * s4 < 0) {
        return true;
    }
    return (s1 == 0 && between(a, b, c)) || (s2 == 0 && between(a, b, d)) ||
           (s3 == 0 && between(c, d, a)) || (s4 == 0 && between(c, d, b));
}

enum cr_err cr_scene_polygon_check(struct cr_reader *r, struct cr_vec2 *v, int n) {
    if (n > 3 && v[0].x == v[n - 1].x && v[0].y == v[n - 1].y) {
        cr_scene_fail(r, CR_ERR_RANGE, "the last corner of the polygon repeats the first");
        cr_err_hint(r->err, "leave it out: the ring closes by itself");
        return CR_ERR_RANGE;
    }
    for (int i = 0; i < n; i++) {
        struct cr_vec2 a = v[i], b = v[(i + 1) % n], c = v[(i + 2) % n];
        /* neighbours share a corner; they may not fold back onto each other */
        bool folded =
            side_of(a, b, c) == 0 && cr_vec2_dot(cr_vec2_sub(b, a), cr_vec2_sub(c, b)) < 0;
        if (a.x == b.x && a.y == b.y) {
            return cr_scene_fail(r, CR_ERR_RANGE, "corners %d and %d of the polygon are the same",
                                 i, (i + 1) % n);
        }
        if (folded) {
            return cr_scene_fail(r, CR_ERR_RANGE, "the polygon folds back on itself at corner %d",
                                 (i + 1) % n);
        }
        for (int k = i + 2; k < n - (i == 0); k++) {
            if (edges_meet(a, b, v[k], v[(k + 1) % n])) {
                cr_scene_fail(r, CR_ERR_RANGE, "edges %d and %d of the polygon cross", i, k);
                cr_err_hint(r->err, "list the corners in the order in which they are walked");
                return CR_ERR_RANGE;
            }
        }
    }
    double area = signed_area(v, n);
    if (!(fabs(area) > 1e-6)) {
        return cr_scene_fail(r, CR_ERR_RANGE, "the polygon has no area");
    }
    for (int i = 0, k = n - 1; area < 0 && i < k; i++, k--) {
        struct cr_vec2 swap = v[i];
        v[i] = v[k];
        v[k] = swap;
    }
    return CR_ERR_OK;
}
