/* Outlines of participants as they are placed, from their dimensions or shape. */
#include "scene/scene_priv.h"

#include "base/elementary.h"

#include <math.h>

/* a wall has no ends; drawn it reaches this far to both sides, and this far back */
static const double wall_half = 25, wall_depth = 0.5;

static int rectangle(double x0, double x1, double half, struct cr_vec2 *out) {
    out[0] = cr_vec2(x0, -half);
    out[1] = cr_vec2(x1, -half);
    out[2] = cr_vec2(x1, half);
    out[3] = cr_vec2(x0, half);
    return 4;
}

/* an arc of radius r about c from angle a by the angle turn, in n + 1 points */
static int arc(struct cr_vec2 c, double r, double a, double turn, int n, struct cr_vec2 *out) {
    for (int i = 0; i <= n; i++) {
        double t = a + turn * i / n;
        out[i] = cr_vec2_axpy(c, r, cr_vec2_toward(t));
    }
    return n + 1;
}

static int box(const struct cr_participant *p, struct cr_vec2 *out, int max) {
    double x = p->length / 2, y = p->width / 2, r = p->edge_radius;
    if (!(r > 0) || max < 24) {
        return rectangle(-x, x, y, out);
    }
    const struct cr_vec2 centre[] = {cr_vec2(x - r, -y + r), cr_vec2(x - r, y - r),
                                     cr_vec2(-x + r, y - r), cr_vec2(-x + r, -y + r)};
    int n = 0;
    for (int i = 0; i < 4; i++) {
        n += arc(centre[i], r, (i - 1) * CR_PI / 2, CR_PI / 2, 5, out + n);
    }
    return n;
}

int cr_scene_outline(const struct cr_participant *p, struct cr_vec2 *out, int max) {
    if (max < 4) {
        return 0;
    }
    double front = p->front_overhang + p->cg_behind_front_axle;
    if (p->kind == CR_KIND_VEHICLE || p->shape == CR_OBJECT_BARRIER) {
        bool known = isfinite(front) && isfinite(p->length) && isfinite(p->width);
        return known ? rectangle(front - p->length, front, p->width / 2, out) : 0;
    }
    switch (p->shape) {
    case CR_OBJECT_WALL:
        return rectangle(-wall_depth, 0, wall_half, out);
    case CR_OBJECT_POLE: {
        int n = max < 33 ? max - 1 : 32;
        return isfinite(p->radius) ? arc(cr_vec2(0, 0), p->radius, 0, 2 * CR_PI, n, out) - 1 : 0;
    }
    case CR_OBJECT_BOX:
        return isfinite(p->length) && isfinite(p->width) ? box(p, out, max) : 0;
    case CR_OBJECT_POLYGON:
        for (int i = 0; i < p->vertices && i < max; i++) {
            out[i] = p->vertex[i];
        }
        return p->vertices <= max ? p->vertices : 0;
    case CR_OBJECT_BARRIER:
        break;
    }
    return 0;
}
