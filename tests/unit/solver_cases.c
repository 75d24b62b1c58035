#include "solver_cases.h"
#include "test.h"

static double overlap(double lo, double hi, double a, double b) {
    return fmax(0, fmin(hi, b) - fmax(lo, a));
}

struct cr_grid block_grid(struct cr_arena *arena, double length, double width, double h,
                          strength_fn strength, const void *arg) {
    int nx = (int)ceil(length / h - 1e-9), ny = (int)ceil(width / h - 1e-9);
    ny += ny % 2; /* the centre line is a voxel boundary */
    double x0 = length / 2 - nx * h, y0 = -0.5 * ny * h;
    double *fill = cr_arena_take(arena, (size_t)(nx * ny), sizeof *fill);
    double *energy = cr_arena_take(arena, (size_t)(nx * ny), sizeof *energy);
    for (int iy = 0; iy < ny; iy++) {
        for (int ix = 0; ix < nx; ix++) {
            double xl = x0 + ix * h, yl = y0 + iy * h;
            double part = overlap(xl, xl + h, -length / 2, length / 2) / h *
                          overlap(yl, yl + h, -width / 2, width / 2) / h;
            double depth = length / 2 - (xl + h / 2), side = width / 2 - fabs(yl + h / 2);
            fill[iy * nx + ix] = part;
            energy[iy * nx + ix] = part * h * h * strength(depth, side, arg);
        }
    }
    return (struct cr_grid){.nx = nx, .ny = ny, .h = h, .x0 = x0, .y0 = y0, .fill = fill,
                            .energy = energy};
}

struct cr_body block_body(struct cr_grid grid, double mass, double length, double width,
                          double x, double y, double heading, double speed) {
    return (struct cr_body){.mass = mass, .inertia = mass * (length * length + width * width) / 12,
                            .pos = {x, y}, .heading = heading,
                            .vel = {speed * cos(heading), speed * sin(heading)}, .grid = grid,
                            .friction = -1};
}

struct cr_body wall_body(double x, double y, double heading) {
    return (struct cr_body){.pos = {x, y}, .heading = heading, .friction = -1,
                            .shape = {.kind = CR_SHAPE_WALL}};
}

struct cr_body pole_body(double x, double y, double radius) {
    return (struct cr_body){.pos = {x, y}, .friction = -1,
                            .shape = {.kind = CR_SHAPE_POLE, .radius = radius}};
}

struct cr_solver *solved(const struct cr_case *cs) {
    struct cr_error err = {0};
    struct cr_solver *s = NULL;
    if (cr_solver_new(cs, &s, &err) != CR_ERR_OK || cr_solver_run(s, NULL, NULL, &err) != 0) {
        fail_msg("%s", err.text);
    }
    return s;
}

double linear_front(double depth, double side, const void *arg) {
    (void)side;
    const struct linear_front *f = arg;
    return f->mass * f->omega * f->omega * depth / f->width;
}

double constant_strength(double depth, double side, const void *arg) {
    (void)depth;
    (void)side;
    return *(const double *)arg;
}
