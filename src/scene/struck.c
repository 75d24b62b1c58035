/* Which face of a vehicle a partner comes at, before they touch: that on whose side the boxes of
 * the two come to overlap last. The direction of the relative velocity alone would call a car that
 * is struck in the flank, while it drives faster than what strikes it, struck at its front. */
#include "scene/scene_priv.h"

#include "base/elementary.h"
#include "scene/compiled.h"

#include <math.h>

/* A stretch of one axis of the vehicle's frame, m. */
struct stretch {
    double lo, hi;
};

struct box {
    struct stretch x, y;
};

/* What has no extent given (a wall, a polygon) counts as this long and wide, m: its sides are met
 * where its reference point is. */
static const double small = 0.5;

/* box of a participant about the origin of its body */
static struct box box_of(const struct cr_participant *p) {
    bool from_front = p->kind == CR_KIND_VEHICLE || p->shape == CR_OBJECT_BARRIER;
    bool box = from_front || p->shape == CR_OBJECT_BOX;
    double length = box ? p->length : 2 * p->radius, width = box ? p->width : 2 * p->radius;
    length = isfinite(length) ? length : small;
    width = isfinite(width) ? width : small;
    double front = from_front ? p->cg_behind_front_axle + p->front_overhang : length / 2;
    return (struct box){{front - length, front}, {-width / 2, width / 2}};
}

/* the box about a box that stands at `at`, turned */
static struct box turned(struct box of, struct cr_vec2 at, double turn) {
    double c, s;
    cr_sincos(turn, &s, &c);
    struct box out = {{INFINITY, -(double)INFINITY}, {INFINITY, -(double)INFINITY}};
    for (int n = 0; n < 4; n++) {
        struct cr_vec2 corner = {n & 1 ? of.x.hi : of.x.lo, n & 2 ? of.y.hi : of.y.lo};
        struct cr_vec2 p = cr_vec2_add(at, cr_vec2_rotate(corner, c, s));
        out.x.lo = fmin(out.x.lo, p.x);
        out.x.hi = fmax(out.x.hi, p.x);
        out.y.lo = fmin(out.y.lo, p.y);
        out.y.hi = fmax(out.y.hi, p.y);
    }
    return out;
}

/* Time at which one stretch, moving at v, begins to overlap a still one, s: negative where they do
 * already, the more so the slower, infinite where they never do. */
static double meets(struct stretch moving, double v, struct stretch still) {
    double gap = fmax(moving.lo - still.hi, still.lo - moving.hi);
    double speed = gap <= 0 ? fabs(v) : moving.lo > still.hi ? -v : v;
    return speed > 0 ? gap / speed : gap > 0 ? (double)INFINITY : -(double)INFINITY;
}

enum cr_face cr_scene_struck_face(const struct cr_scene *scene, const struct cr_case *cs, int i,
                                  int k) {
    const struct cr_body *a = &cs->body[i], *b = &cs->body[k];
    double c, s;
    cr_sincos(a->heading, &s, &c);
    struct cr_vec2 v = cr_vec2_unrotate(cr_vec2_sub(b->vel, a->vel), c, s);
    struct cr_vec2 at = cr_vec2_unrotate(cr_vec2_sub(b->pos, a->pos), c, s);
    struct box own = box_of(&scene->part[i]);
    struct box other = turned(box_of(&scene->part[k]), at, b->heading - a->heading);
    double tx = meets(other.x, v.x, own.x), ty = meets(other.y, v.y, own.y);
    /* side by side in both, or never: where the motion is */
    bool end = tx == ty || isinf(ty) > 0 ? fabs(v.x) >= fabs(v.y) : tx > ty;
    if (end) {
        return v.x <= 0 ? CR_FACE_FRONT : CR_FACE_REAR;
    }
    return v.y < 0 ? CR_FACE_LEFT : CR_FACE_RIGHT;
}
