/* Rigid outlines: walls, poles, polygons with rounded edges. */
#include "solver/shape.h"
#include "solver/tuning.h"

/* closest point of a segment */
static struct cr_vec2 closest(struct cr_vec2 a, struct cr_vec2 b, struct cr_vec2 p) {
    struct cr_vec2 d = cr_vec2_sub(b, a);
    double len2 = cr_vec2_dot(d, d);
    double t = len2 > 0 ? cr_clamp(cr_vec2_dot(cr_vec2_sub(p, a), d) / len2, 0, 1) : 0;
    return cr_vec2_axpy(a, t, d);
}

/* distance to a closed polygon by its nearest edge; inside by crossing number */
static double polygon_distance(const struct cr_shape *shape, struct cr_vec2 p,
                               struct cr_vec2 *normal) {
    double best = INFINITY;
    struct cr_vec2 nearest = {0, 0}, edge = {1, 0};
    bool inside = false;
    for (int i = 0, j = shape->n - 1; i < shape->n; j = i++) {
        struct cr_vec2 a = shape->vertex[j], b = shape->vertex[i];
        struct cr_vec2 q = closest(a, b, p);
        struct cr_vec2 d = cr_vec2_sub(p, q);
        double d2 = cr_vec2_dot(d, d);
        if (d2 < best) {
            best = d2;
            nearest = q;
            edge = cr_vec2_sub(b, a);
        }
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            inside = !inside;
        }
    }
    double dist = sqrt(best) * (inside ? -1 : 1);
    /* on the edge itself the direction comes from the edge: outward is to its right */
    struct cr_vec2 outward = cr_vec2_unit(cr_vec2(edge.y, -edge.x), cr_vec2(1, 0));
    struct cr_vec2 away = cr_vec2_scale(cr_vec2_sub(p, nearest), inside ? -1 : 1);
    *normal = sqrt(best) > 1e-9 ? cr_vec2_unit(away, outward) : outward;
    return dist;
}

double cr_shape_distance(const struct cr_shape *shape, struct cr_vec2 p, struct cr_vec2 *normal) {
    double r;
    switch (shape->kind) {
    case CR_SHAPE_WALL:
        *normal = cr_vec2(1, 0);
        return p.x;
    case CR_SHAPE_POLE:
        r = cr_vec2_len(p);
        *normal = r > 0 ? cr_vec2_scale(p, 1 / r) : cr_vec2(1, 0);
        return r - shape->radius;
    case CR_SHAPE_POLYGON:
        /* the vertices are already drawn in by edge_radius: rounding gives it back */
        return polygon_distance(shape, p, normal) - shape->edge_radius;
    case CR_SHAPE_NONE:
        break;
    }
    *normal = cr_vec2(1, 0);
    return INFINITY;
}

void cr_shape_box(const struct cr_shape *shape, struct cr_vec2 *lo, struct cr_vec2 *hi) {
    *lo = cr_vec2(0, 0);
    *hi = cr_vec2(0, 0);
    if (shape->kind == CR_SHAPE_WALL) {
        *lo = cr_vec2(-cr_wall_extent, -cr_wall_extent);
        *hi = cr_vec2(0, cr_wall_extent);
    } else if (shape->kind == CR_SHAPE_POLE) {
        *lo = cr_vec2(-shape->radius, -shape->radius);
        *hi = cr_vec2(shape->radius, shape->radius);
    } else if (shape->kind == CR_SHAPE_POLYGON) {
        *lo = cr_vec2(INFINITY, INFINITY);
        *hi = cr_vec2(-INFINITY, -INFINITY);
        for (int i = 0; i < shape->n; i++) {
            struct cr_vec2 v = shape->vertex[i];
            *lo = cr_vec2(cr_min(lo->x, v.x - shape->edge_radius),
                          cr_min(lo->y, v.y - shape->edge_radius));
            *hi = cr_vec2(cr_max(hi->x, v.x + shape->edge_radius),
                          cr_max(hi->y, v.y + shape->edge_radius));
        }
    }
}
