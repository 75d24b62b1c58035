/* Builds the crash made by hand that tests of pictures look at. */
#include "render_double.h"

#include "scene/compiled.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SLICES = 200 };
static const double edge = 0.05, t_contact = 0.1, time_step = 0.0005, pulse = 0.080;

struct car {
    const char *id, *model;
    enum cr_type type;
    double length, width, mass, heading, speed, y;
    double a_peak;      /* of the pulse, m/s2, against the heading */
    double band[2];     /* struck part of the front, own y, m */
    double depth, turn; /* m, rad at the end of the pulse */
};

static void *take(struct render_double *d, size_t n, size_t size) {
    void *p = cr_arena_take(&d->arena, n, size);
    if (p == NULL) {
        abort();
    }
    return p;
}

/* material within 0.25 m of the corners is cut off round; rails and engine are harder */
static void make_grid(struct render_double *d, const struct car *car, struct cr_grid *g) {
    g->nx = (int)lround(car->length / edge);
    g->ny = (int)lround(car->width / edge);
    g->h = edge;
    g->x0 = -0.5 * car->length;
    g->y0 = -0.5 * car->width;
    double *fill = take(d, (size_t)(g->nx * g->ny), sizeof *fill);
    double *energy = take(d, (size_t)(g->nx * g->ny), sizeof *energy);
    for (int i = 0; i < g->nx * g->ny; i++) {
        double x = g->x0 + (i % g->nx + 0.5) * edge, y = g->y0 + (i / g->nx + 0.5) * edge;
        double dx = fmax(fabs(x) - 0.5 * car->length + 0.25, 0);
        double dy = fmax(fabs(y) - 0.5 * car->width + 0.25, 0);
        fill[i] = dx * dx + dy * dy < 0.25 * 0.25;
        double ahead = 0.5 * car->length - x;
        double rail = fabs(fabs(y) - 0.3 * car->width) < 0.1 ? 2.5 : 1;
        double density = fmin(20 + 120 * ahead, 200) * 1e3 * rail; /* J/m2 */
        energy[i] = fill[i] * density * edge * edge;
    }
    g->fill = fill;
    g->energy = energy;
}

/* crushed to full depth in the struck band, and beside it as far as a string at 45 deg pulls */
static void crush(struct render_double *d, const struct car *car, const struct cr_grid *g,
                  struct cr_outcome *o) {
    size_t n = (size_t)(g->nx * g->ny);
    double *left = take(d, n, sizeof *left);
    float *t = take(d, n, sizeof *t);
    uint8_t *how = take(d, n, sizeof *how);
    for (int i = 0; i < g->nx * g->ny; i++) {
        double x = g->x0 + (i % g->nx + 0.5) * edge, y = g->y0 + (i / g->nx + 0.5) * edge;
        double beside = fmax(fmax(car->band[0] - y, y - car->band[1]), 0);
        double in = 0.5 * car->length - x, depth = car->depth - beside;
        left[i] = g->fill[i];
        t[i] = INFINITY;
        if (g->fill[i] > 0 && in < depth) {
            left[i] = 0;
            how[i] = beside > 0 ? CR_CRUSH_INDUCED : CR_CRUSH_CONTACT;
            t[i] = (float)(t_contact + 0.05 * in / car->depth);
        }
    }
    o->left = left;
    o->t_crushed = t;
    o->how = how;
}

static struct cr_sample motion(const struct car *car, double t) {
    double u = fmin(t, pulse), w = CR_PI / pulse;
    double v = car->speed - car->a_peak / w * (1 - cos(w * u));
    double way = car->speed * u - car->a_peak / w * (u - sin(w * u) / w);
    double x0 = -0.5 * car->length;
    double c = cos(car->heading);
    way += (t - u) * v;
    double a = t < pulse ? -car->a_peak * sin(w * t) : 0;
    struct cr_sample s = {.pos = {c * (x0 + way), car->y},
                          .vel = {c * v, 0},
                          .heading = car->heading + car->turn * pow(u / pulse, 2),
                          .acc = {c * a, 0},
                          .force = {c * a * car->mass, 0},
                          .coe = {0, 0.45}};
    s.yaw_rate = t < pulse ? 2 * car->turn * t / (pulse * pulse) : 2 * car->turn / pulse;
    s.energy = 0.5 * car->mass * 120 * pow(fmin(u / 0.05, 1), 2);
    s.crushed = car->depth * (car->band[1] - car->band[0]) * fmin(u / 0.05, 1);
    return s;
}

static void severity(const struct car *car, struct cr_severity *of) {
    double dv = 2 * car->a_peak * pulse / CR_PI;
    *of = (struct cr_severity){.ees = sqrt(120),
                               .energy = 60 * car->mass,
                               .energy_induced = 3 * car->mass,
                               .delta_v = dv,
                               .delta_v_world = {-dv * cos(car->heading), 0},
                               .delta_v_body = {-dv, 0},
                               .pdof = 0,
                               .pdof_clock = 12,
                               .cdc = "12FYEW3",
                               .yaw_rate_change = 2 * car->turn / pulse,
                               .speed_after = fabs(car->speed - dv),
                               .yaw_rate_after = 2 * car->turn / pulse,
                               .deformation_max = car->depth - 0.195,
                               .deformation_dynamic_max = car->depth,
                               .deformation_area = 0.5,
                               .area_contact = 0.4,
                               .area_induced = 0.1,
                               .acceleration_max = car->a_peak,
                               .acceleration_mean = car->a_peak * 2 / CR_PI,
                               .t_max = 0.04,
                               .pulse = pulse,
                               .olc = 0.8 * car->a_peak,
                               .asi = car->a_peak / 120,
                               .vpi = 1.2 * car->a_peak,
                               .thiv = dv,
                               .phd = 0.2 * car->a_peak,
                               .injuries = 1};
    snprintf(of->model, sizeof of->model, "%s", car->model);
    snprintf(of->injury[0].function, sizeof of->injury[0].function, "front-mais3");
    snprintf(of->injury[0].title, sizeof of->injury[0].title, "MAIS3+ frontal");
    of->injury[0].probability = 0.125;
    for (int i = 0; i < CR_PROFILE; i++) {
        of->profile[i] = fmax(car->depth - 0.195 - 0.1 * i, 0);
        of->profile_dynamic[i] = of->profile[i] + 0.195;
    }
}

static void add_car(struct render_double *d, int i, const struct car *car) {
    struct cr_participant *part = &d->result.resolved.part[i];
    struct cr_body *body = &d->result.compiled->cs.body[i];
    struct cr_outcome *o = &d->solution.body[i];
    snprintf(part->id, sizeof part->id, "%s", car->id);
    *body = (struct cr_body){
        .mass = car->mass, .inertia = car->mass * 1.8, .heading = car->heading, .friction = -1};
    part->kind = CR_KIND_VEHICLE;
    part->type = car->type;
    part->length = car->length;
    part->width = car->width;
    part->mass = car->mass;
    part->track = 1.5;
    make_grid(d, car, &body->grid);
    crush(d, car, &body->grid, o);
    o->before = motion(car, 0);
    o->after = o->rest = motion(car, pulse);
    o->t_first = t_contact;
    o->t_last = t_contact + pulse;
    o->t_rest = NAN;
    body->vel = cr_vec2(cos(car->heading) * car->speed, 0);
    body->pos = cr_vec2_axpy(o->before.pos, -t_contact, body->vel);
    o->delta_v = cr_vec2_sub(o->after.vel, o->before.vel);
    severity(car, &d->result.of[i]);
}

static void add_trace(struct render_double *d, const struct car *car, int n) {
    double *t = take(d, SLICES, sizeof *t);
    struct cr_sample *trace = take(d, (size_t)SLICES * (size_t)n, sizeof *trace);
    for (int k = 0; k < SLICES; k++) {
        t[k] = t_contact + (k + 1) * time_step;
        for (int i = 0; i < n; i++) {
            if (car[i].mass > 0) {
                trace[k * n + i] = motion(&car[i], (k + 1) * time_step);
            }
        }
    }
    d->solution.t = t;
    d->solution.trace = trace;
    d->solution.samples = SLICES;
}

static void begin(struct render_double *d, int n) {
    memset(d, 0, sizeof *d);
    d->result.compiled = take(d, 1, sizeof *d->result.compiled);
    d->result.solution = &d->solution;
    d->solution.bodies = n;
    d->solution.t_contact = t_contact;
    d->solution.dt = time_step;
    d->result.resolved.n = n;
    d->result.resolved.set.dt = time_step;
    d->result.resolved.set.voxel = edge;
    d->result.compiled->cs.n = n;
}

static void add_contact(struct render_double *d, double impulse) {
    struct cr_contact *c = take(d, 1, sizeof *c);
    *c = (struct cr_contact){.a = 0,
                             .b = 1,
                             .t_begin = t_contact,
                             .t_plastic_end = 0.17,
                             .t_elastic_end = 0.175,
                             .t_end = 0.18,
                             .stop = CR_STOP_MOMENTUM,
                             .closing = 31,
                             .restitution = 0.1,
                             .impulse = {impulse, 0},
                             .friction = 1500};
    d->solution.contact = c;
    d->solution.contacts = 1;
    d->solution.balance = (struct cr_balance){.kinetic_before = 435.6e3,
                                              .kinetic_after = 210e3,
                                              .plastic = 216e3,
                                              .friction = 9e3,
                                              .tyre = 0.6e3,
                                              .momentum_residual = 2e-13,
                                              .angular_residual = 3e-13,
                                              .energy_residual = 4e-14};
}

void render_double_init(struct render_double *d) {
    const struct car cars[2] = {
        {"A", "suv/12", CR_TYPE_SUV, 5.0, 2.0, 2400, 0, 56 / 3.6, 0, 200, {-0.1, 1.0}, 0.5, 0.05},
        {"B",
         "mini-compact/12",
         CR_TYPE_MINI_COMPACT,
         3.6,
         1.6,
         1200,
         CR_PI,
         56 / 3.6,
         0.9,
         400,
         {-0.1, 0.8},
         0.6,
         0.15},
    };
    begin(d, 2);
    snprintf(d->result.resolved.name, sizeof d->result.resolved.name, "by-hand");
    for (int i = 0; i < 2; i++) {
        add_car(d, i, &cars[i]);
    }
    add_trace(d, cars, 2);
    add_contact(d, 2400 * 2 * 200 * pulse / CR_PI);
    static char keys[][CR_NAME_MAX + 32] = {"A.track_m", "A.cg.height_m", "B.track_m"};
    d->result.resolved.part[0].cg_height = 0.7;
    static char from[3][CR_FROM_MAX];
    d->result.assumed = (struct cr_assumed){.n = 3, .key = keys, .from = from};
    d->result.warnings = 1;
    snprintf(d->result.warning[0], sizeof d->result.warning[0],
             "A: 38 kJ went into a crush deeper than the tests of its model reach, 0.55 m");
}

void render_double_wall(struct render_double *d) {
    const struct car cars[2] = {
        {"A", "sedan/12", CR_TYPE_SEDAN, 4.6, 1.8, 1500, 0, 50 / 3.6, 0, 300, {-1, 1}, 0.5, 0},
        {.mass = 0},
    };
    begin(d, 2);
    snprintf(d->result.resolved.name, sizeof d->result.resolved.name, "wall-by-hand");
    add_car(d, 0, &cars[0]);
    struct cr_participant *wall = &d->result.resolved.part[1];
    snprintf(wall->id, sizeof wall->id, "wall");
    wall->kind = CR_KIND_OBJECT;
    wall->shape = CR_OBJECT_WALL;
    wall->heading = CR_PI;
    wall->length = 4;
    wall->mass = NAN;
    d->result.compiled->cs.body[1] = (struct cr_body){.mass = 0, .heading = CR_PI};
    d->solution.body[1].t_first = t_contact;
    d->solution.body[1].t_last = NAN;
    d->solution.body[1].before.heading = CR_PI;
    add_trace(d, cars, 2);
    for (int k = 0; k < SLICES; k++) {
        ((struct cr_sample *)d->solution.trace)[2 * k + 1].heading = CR_PI;
    }
    add_contact(d, 1500 * 2 * 300 * pulse / CR_PI);
}

void render_double_fini(struct render_double *d) {
    cr_arena_free(&d->arena);
}
