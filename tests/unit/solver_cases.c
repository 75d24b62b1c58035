/* Builds the bodies and cases that tests of the solver share. */
#include "solver_cases.h"
#include "test.h"

static double overlap(double lo, double hi, double a, double b) {
    return fmax(0, fmin(hi, b) - fmax(lo, a));
}

struct cr_grid block_grid(struct cr_arena *arena, double length, double width, double h,
                          strength_fn strength, const void *arg) {
    return block_grid_of(arena, &(struct block){length, width, h, strength, arg, {0, 0}});
}

struct cr_grid block_grid_of(struct cr_arena *arena, const struct block *b) {
    const double length = b->length, width = b->width, h = b->h;
    const struct cr_vec2 phase = b->phase;
    int nx = (int)ceil(length / h - 1e-9), ny = (int)ceil(width / h - 1e-9);
    ny += ny % 2; /* the centre line is a voxel boundary */
    double x0 = length / 2 - nx * h + phase.x * h, y0 = -0.5 * ny * h - phase.y * h;
    nx += phase.x > 0;
    x0 -= phase.x > 0 ? h : 0;
    ny += phase.y > 0;
    double *fill = cr_arena_take(arena, (size_t)(nx * ny), sizeof *fill);
    double *energy = cr_arena_take(arena, (size_t)(nx * ny), sizeof *energy);
    for (int iy = 0; iy < ny; iy++) {
        for (int ix = 0; ix < nx; ix++) {
            double xl = x0 + ix * h, yl = y0 + iy * h;
            double in_x = overlap(xl, xl + h, -length / 2, length / 2);
            double in_y = overlap(yl, yl + h, -width / 2, width / 2);
            /* strength at the middle of what is filled */
            double x = 0.5 * (fmax(xl, -length / 2) + fmin(xl + h, length / 2));
            double y = 0.5 * (fmax(yl, -width / 2) + fmin(yl + h, width / 2));
            int k = iy * nx + ix;
            double q = b->strength(length / 2 - x, width / 2 - fabs(y), b->arg);
            fill[k] = q < 0 ? 0 : in_x * in_y / (h * h);
            energy[k] = q < 0 ? 0 : in_x * in_y * q;
        }
    }
    return (struct cr_grid){
        .nx = nx, .ny = ny, .h = h, .x0 = x0, .y0 = y0, .fill = fill, .energy = energy};
}

struct pose at(double x, double y, double heading, double speed) {
    return (struct pose){x, y, heading, speed};
}

struct cr_body block_body(struct cr_grid grid, double mass, double length, double width,
                          struct pose p) {
    return (struct cr_body){.mass = mass,
                            .inertia = mass * (length * length + width * width) / 12,
                            .pos = {p.x, p.y},
                            .heading = p.heading,
                            .vel = {p.speed * cos(p.heading), p.speed * sin(p.heading)},
                            .grid = grid,
                            .friction = -1};
}

struct cr_body wall_body(double x, double y, double heading) {
    return (struct cr_body){
        .pos = {x, y}, .heading = heading, .friction = -1, .shape = {.kind = CR_SHAPE_WALL}};
}

struct cr_body pole_body(double x, double y, double radius) {
    return (struct cr_body){
        .pos = {x, y}, .friction = -1, .shape = {.kind = CR_SHAPE_POLE, .radius = radius}};
}

struct cr_body polygon_body(double x, double y, double heading, const struct cr_vec2 *vertex,
                            int n) {
    return (struct cr_body){.pos = {x, y},
                            .heading = heading,
                            .friction = -1,
                            .shape = {.kind = CR_SHAPE_POLYGON, .n = n, .vertex = vertex}};
}

const double car_mass = 1400, car_length = 4.4, car_width = 1.8;

double car_strength(double depth, double side, const void *arg) {
    (void)arg;
    double end = fmin(depth, car_length - depth);
    return fmin(40e3 + 400e3 * end, 120e3 + 200e3 * side);
}

void set_wheels(struct cr_body *body, double wheelbase, double track, double brake, bool locked) {
    body->wheels = CR_WHEELS;
    for (int i = 0; i < CR_WHEELS; i++) {
        body->wheel[i] = (struct cr_wheel){
            .at = {(i < 2 ? 0.5 : -0.5) * wheelbase, (i % 2 == 0 ? 0.5 : -0.5) * track},
            .load = body->mass * CR_G / CR_WHEELS,
            .brake = brake,
            .locked = locked};
    }
}

struct cr_grid car_grid(struct cr_arena *arena, double h, struct cr_vec2 phase) {
    return block_grid_of(arena,
                         &(struct block){car_length, car_width, h, car_strength, NULL, phase});
}

struct cr_body car_body(struct cr_arena *arena, double h, double x, double y, double heading,
                        double speed) {
    struct cr_grid grid = car_grid(arena, h, cr_vec2(0, 0));
    struct cr_body car =
        block_body(grid, car_mass, car_length, car_width, at(x, y, heading, speed));
    set_wheels(&car, 2.6, 1.5, 0, false);
    return car;
}

struct cr_case case_of(struct cr_body a, struct cr_body b) {
    struct cr_case cs = {.n = 2, .body = {a, b}, .opts = cr_opts_default()};
    cs.opts.induced = false;
    return cs;
}

const char *const typical_name[TYPICAL_COUNT] = {"offset",  "side", "pole",
                                                 "oblique", "rear", "wall"};

static struct cr_body light_car(struct cr_arena *arena, double h, double x, double y,
                                double heading, double speed) {
    struct cr_body car = car_body(arena, h, x, y, heading, speed);
    car.mass *= 5.0 / 7;
    car.inertia *= 5.0 / 7;
    set_wheels(&car, 2.6, 1.5, 0, false);
    return car;
}

/* as in the median side pole test at the flanks, and between the rails and the corners at the ends
 */
static void add_drag(struct cr_body *car) {
    for (int f = 0; f < CR_FACES; f++) {
        car->grid.drag_slope[f] = f == CR_FACE_LEFT || f == CR_FACE_RIGHT ? 0.555 : 1.4;
    }
}

static struct cr_body partner(struct cr_arena *arena, enum typical which, double h) {
    switch (which) {
    case TYPICAL_OFFSET:
        return light_car(arena, h, 2.5, 0.6 * car_width, CR_PI, 56 / 3.6);
    case TYPICAL_SIDE:
        return light_car(arena, h, 1.3, 0.5, CR_PI / 2, 20 / 3.6);
    case TYPICAL_POLE:
        return pole_body(-2.25, 1.25, 0.127);
    case TYPICAL_OBLIQUE:
        return wall_body(0.6, 0, CR_PI - cr_rad(30));
    case TYPICAL_REAR:
        return light_car(arena, h, 2.5, -0.5 * car_width, 0, 0);
    default:
        return wall_body(0, 0, CR_PI);
    }
}

struct cr_case typical_case(struct cr_arena *arena, enum typical which, double h,
                            struct cr_vec2 phase) {
    struct cr_body a = car_body(arena, h, -2.5, 0, 0, 56 / 3.6), b = partner(arena, which, h);
    a.vel = which == TYPICAL_POLE   ? cr_vec2(0, 32 / 3.6)
            : which == TYPICAL_SIDE ? cr_vec2(50 / 3.6, 0)
                                    : a.vel;
    a.grid = car_grid(arena, h, phase);
    add_drag(&a);
    if (b.grid.nx > 0) {
        add_drag(&b);
    }
    return (struct cr_case){.n = 2, .body = {a, b}, .opts = cr_opts_default()};
}

struct cr_case case_moved(struct cr_case cs, double angle, double dx, double dy) {
    double c = cos(angle), s = sin(angle);
    for (int i = 0; i < cs.n; i++) {
        struct cr_body *b = &cs.body[i];
        b->pos = cr_vec2_add(cr_vec2_rotate(b->pos, c, s), cr_vec2(dx, dy));
        b->vel = cr_vec2_rotate(b->vel, c, s);
        b->heading += angle;
    }
    return cs;
}

double ees_of(const struct cr_solution *o, const struct cr_case *cs, int i) {
    return sqrt(2 * o->body[i].energy / cs->body[i].mass);
}

double random_between(uint64_t *state, double lo, double hi) {
    /* splitmix64 (Steele, Lea, Flood 2014) */
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return lo + (hi - lo) * (double)(z >> 11) / 9007199254740992.0;
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
