/* A case becomes a solver: bodies in their places, their surfaces, scratch. */
#include "solver/setup.h"

#include "solver/motion.h"
#include "solver/shape.h"

#include <stdlib.h>
#include <string.h>

/* energies per unit of material of those of a grid; NULL when memory is out */
static const double *units_of(struct cr_solver *s, const struct cr_grid *g, const double *energy) {
    size_t n = (size_t)g->nx * (size_t)g->ny;
    double *unit = cr_arena_take_raw(&s->arena, n, sizeof *unit);
    for (size_t k = 0; unit != NULL && k < n; k++) {
        unit[k] = g->fill[k] > 0 ? energy[k] / g->fill[k] : 0;
    }
    return unit;
}

/* the energies of a body against a partner for one way to be pushed */
static const double *energy_of(const struct cr_body *b, int partner, int push) {
    const double *own = b->against[partner].energy[push];
    own = own != NULL ? own : b->strength.energy[push];
    return own != NULL ? own : b->grid.energy;
}

/* Energy per unit of material against each partner, shared where the layers are the same. */
static bool new_units(struct cr_solver *s, struct cr_moving *m) {
    const struct cr_body *b = m->body;
    for (int p = 0; p < s->cs->n * CR_PUSHES; p++) {
        int partner = p / CR_PUSHES, push = p % CR_PUSHES;
        const double *energy = energy_of(b, partner, push), **unit = &m->unit[partner][push];
        for (int q = 0; q < p && *unit == NULL; q++) {
            if (energy_of(b, q / CR_PUSHES, q % CR_PUSHES) == energy) {
                *unit = m->unit[q / CR_PUSHES][q % CR_PUSHES];
            }
        }
        *unit = *unit != NULL ? *unit : units_of(s, &b->grid, energy);
        if (*unit == NULL) {
            return false;
        }
    }
    return true;
}

static bool new_grid(struct cr_solver *s, struct cr_moving *m) {
    const struct cr_grid *g = &m->body->grid;
    m->soft = true;
    m->lo = cr_vec2(g->x0, g->y0);
    m->hi = cr_vec2(g->x0 + g->nx * g->h, g->y0 + g->ny * g->h);
    return cr_surface_new(&m->surface, g, &s->arena) && new_units(s, m);
}

static bool new_body(struct cr_solver *s, int i) {
    struct cr_moving *m = &s->m[i];
    const struct cr_body *b = &s->cs->body[i];
    m->body = b;
    m->inv_mass = b->mass > 0 ? 1 / b->mass : 0;
    m->inv_inertia = b->mass > 0 && b->inertia > 0 ? 1 / b->inertia : 0;
    m->vel = b->mass > 0 || b->waypoints > 0 ? b->vel : cr_vec2(0, 0);
    m->yaw_rate = b->mass > 0 ? b->yaw_rate : 0;
    m->driven = b->waypoints > 1;
    m->t_first = m->t_last = m->t_rest = NAN;
    cr_kinematics_place(m, b->pos, b->heading);
    if (m->driven) {
        cr_kinematics_place(m, b->waypoint[0].pos, b->waypoint[0].heading);
        s->t = cr_min(s->t, b->waypoint[0].t);
    }
    cr_shape_box(&b->shape, &m->lo, &m->hi);
    if (b->grid.nx > 0 && !new_grid(s, m)) {
        return false;
    }
    double x = cr_max(fabs(m->lo.x), fabs(m->hi.x)), y = cr_max(fabs(m->lo.y), fabs(m->hi.y));
    m->reach = b->shape.kind == CR_SHAPE_WALL ? (double)INFINITY : sqrt(x * x + y * y);
    float *when =
        b->grid.nx == 0
            ? NULL
            : cr_arena_take_raw(&s->arena, (size_t)b->grid.nx * (size_t)b->grid.ny, sizeof *when);
    s->out.body[i].t_crushed = when;
    return when != NULL || b->grid.nx == 0;
}

static bool new_scratch(struct cr_solver *s) {
    int longest = 2;
    for (int i = 0; i < s->cs->n; i++) {
        const struct cr_grid *g = &s->cs->body[i].grid;
        longest = g->nx > longest ? g->nx : longest;
        longest = g->ny > longest ? g->ny : longest;
    }
    s->longest = longest;
    s->line = cr_arena_take(&s->arena, 2 * CR_FACES * (size_t)longest, sizeof *s->line);
    s->freed = cr_arena_take(&s->arena, 1, sizeof *s->freed);
    return s->line != NULL && s->freed != NULL;
}

/* the bodies of a checked case in their places; NULL when memory is out */
static struct cr_solver *new_solver(const struct cr_case *cs) {
    struct cr_solver *s = calloc(1, sizeof *s);
    if (s == NULL) {
        return NULL;
    }
    s->cs = cs;
    s->t_free = NAN;
    bool ok = new_scratch(s);
    for (int i = 0; ok && i < cs->n; i++) {
        ok = new_body(s, i);
    }
    for (int p = 0; ok && p < CR_PAIR_MAX; p++) {
        s->touch[p].record = -1;
    }
    if (!ok) {
        cr_solver_free(s);
        return NULL;
    }
    return s;
}

enum cr_err cr_solver_new(const struct cr_case *cs, struct cr_solver **out, struct cr_error *err) {
    *out = NULL;
    enum cr_err code = cr_check_case(cs, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_solver *s = new_solver(cs);
    if (s == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the solve");
    }
    code = cr_start_check(s, err);
    if (code != CR_ERR_OK) {
        cr_solver_free(s);
        return code;
    }
    *out = s;
    return CR_ERR_OK;
}

bool cr_solver_overlap(const struct cr_case *cs, struct cr_overlap *out) {
    struct cr_solver *s = cr_check_case(cs, NULL) == CR_ERR_OK ? new_solver(cs) : NULL;
    bool found = s != NULL && cr_start_overlap(s, out);
    cr_solver_free(s);
    return found;
}

void cr_solver_free(struct cr_solver *s) {
    if (s == NULL) {
        return;
    }
    for (int side = 0; side < 2; side++) {
        free(s->side[side].cell);
        free(s->side[side].loss);
    }
    free(s->contact);
    free(s->times);
    free(s->trace);
    free(s->slice);
    cr_arena_free(&s->arena);
    free(s);
}
