/* What a case must hold before it is solved: numbers, extents, options. */
#include "solver/setup.h"
#include "solver/tuning.h"

static bool all_finite(const double *number, size_t n) {
    for (size_t k = 0; k < n; k++) {
        if (!isfinite(number[k])) {
            return false;
        }
    }
    return true;
}

static bool has_area(const struct cr_shape *shape) {
    bool ok = shape->n >= 3 && shape->vertex != NULL && isfinite(shape->edge_radius) &&
              shape->edge_radius >= 0;
    for (int i = 0; ok && i < shape->n; i++) {
        ok = isfinite(shape->vertex[i].x) && isfinite(shape->vertex[i].y);
    }
    return ok;
}

static bool has_outline(const struct cr_shape *shape) {
    switch (shape->kind) {
    case CR_SHAPE_POLE:
        return isfinite(shape->radius) && shape->radius > 0;
    case CR_SHAPE_POLYGON:
        return has_area(shape);
    default:
        return true;
    }
}

static bool times_rise(const struct cr_waypoint *w, int n) {
    for (int i = 0; i < n; i++) {
        double row[] = {w[i].t, w[i].pos.x, w[i].pos.y, w[i].heading, w[i].speed};
        if (!all_finite(row, sizeof row / sizeof *row) || (i > 0 && !(w[i].t > w[i - 1].t))) {
            return false;
        }
    }
    return true;
}

static enum cr_err check_body(const struct cr_body *b, int number, struct cr_error *err) {
    double numbers[] = {b->mass,  b->inertia, b->pos.x,    b->pos.y,   b->vel.x,
                        b->vel.y, b->heading, b->yaw_rate, b->friction};
    if (!all_finite(numbers, sizeof numbers / sizeof *numbers)) {
        return cr_err_set(err, CR_ERR_RANGE, "participant %d has a number that is not finite",
                          number);
    }
    if (cr_vec2_len(b->vel) > cr_speed_most || fabs(b->yaw_rate) > cr_speed_most) {
        return cr_err_set(err, CR_ERR_RANGE, "participant %d is faster than %g m/s or rad/s",
                          number, cr_speed_most);
    }
    const struct cr_grid *g = &b->grid;
    if (g->nx == 0 && b->shape.kind == CR_SHAPE_NONE) {
        return cr_err_set(err, CR_ERR_RANGE, "participant %d has neither voxels nor a shape",
                          number);
    }
    double place[] = {g->h, g->x0, g->y0};
    if (g->nx < 0 || g->ny < 0 || (g->nx > 0 && (g->ny == 0 || !(g->h > 0))) ||
        !all_finite(place, 3)) {
        return cr_err_set(err, CR_ERR_RANGE, "participant %d has an empty voxel grid", number);
    }
    if (g->nx == 0 && !has_outline(&b->shape)) {
        return cr_err_set(err, CR_ERR_RANGE, "participant %d has no outline", number);
    }
    if (!times_rise(b->waypoint, b->waypoints)) {
        return cr_err_set(err, CR_ERR_RANGE, "the path of participant %d has no rising times",
                          number);
    }
    return CR_ERR_OK;
}

static enum cr_err check_options(const struct cr_opts *o, struct cr_error *err) {
    const struct {
        const char *name;
        double value, least, most;
    } options[] = {{"time slice", o->dt, 1e-9, 1},
                   {"friction", o->friction, 0, INFINITY},
                   {"road friction", o->road_friction, 0, INFINITY},
                   {"restitution", o->restitution, 0, 1},
                   {"elastic phase", o->elastic_s, 0, 10},
                   {"longest wait", o->max_time, 0, INFINITY},
                   {"time to rest", o->rest_time, 0, INFINITY}};
    for (size_t k = 0; k < sizeof options / sizeof *options; k++) {
        double v = options[k].value;
        if (!(isfinite(v) && v >= options[k].least && v <= options[k].most)) {
            return cr_err_set(err, CR_ERR_RANGE, "option %s out of range: %g", options[k].name, v);
        }
    }
    return CR_ERR_OK;
}

enum cr_err cr_check_case(const struct cr_case *cs, struct cr_error *err) {
    if (cs->n < 1 || cs->n > CR_BODY_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "a case has 1 to %d bodies", CR_BODY_MAX);
    }
    for (int i = 0; i < cs->n; i++) {
        enum cr_err code = check_body(&cs->body[i], i + 1, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    return check_options(&cs->opts, err);
}
