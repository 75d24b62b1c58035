#include "solver/solver_priv.h"

#include <stdlib.h>
#include <string.h>

/* Least approach that begins a contact, m/s. What the last slice of a contact gave back still
 * overlaps, and would be crushed again and again by what rounding leaves of the approach. */
static const double begin_speed = 1e-3;
/* Time in which bodies that have crushed each other stop again at the soonest, s: between one and
 * two of the paper's elastic phases of 5 ms. */
static const double touch_time = 8e-3;

const char *cr_stop_word(enum cr_stop stop) {
    static const char *const words[] = {
#define X(name, word) [CR_STOP_##name] = word,
        CR_STOP_LIST(X)
#undef X
    };
    return words[stop];
}

struct cr_opts cr_opts_default(void) {
    return (struct cr_opts){.dt = 0.5e-3,
                            .friction = 0.5,
                            .road_friction = 0.8,
                            .restitution = 0.1,
                            .elastic_s = 5e-3,
                            .induced = true,
                            .end = CR_END_SEPARATION,
                            .max_time = 20,
                            .rest_time = 30};
}

static bool new_lines(struct cr_solver *s, struct cr_moving *m) {
    const struct cr_grid *g = &m->body->grid;
    size_t nx = (size_t)g->nx, ny = (size_t)g->ny;
    m->row = cr_arena_take(&s->arena, ny, sizeof *m->row);
    m->col = cr_arena_take(&s->arena, nx, sizeof *m->col);
    for (int f = 0; f < CR_FACES; f++) {
        size_t n = (size_t)cr_face_lines(g, f);
        m->depth[f] = cr_arena_take(&s->arena, n, sizeof(double));
        m->outline[f] = cr_arena_take(&s->arena, n, sizeof(double));
        m->pitch[f] = cr_arena_take(&s->arena, n, sizeof(double));
        if (m->depth[f] == NULL || m->outline[f] == NULL || m->pitch[f] == NULL) {
            return false;
        }
    }
    return m->row != NULL && m->col != NULL;
}

/* live spans of all lines, and their fullest voxel into the pitch of the front and left faces */
static void span_lines(struct cr_moving *m) {
    const struct cr_grid *g = &m->body->grid;
    double *row_most = m->pitch[CR_FACE_FRONT], *col_most = m->pitch[CR_FACE_LEFT];
    for (int ix = 0; ix < g->nx; ix++) {
        m->col[ix] = (struct cr_span){g->ny, 0};
    }
    for (int iy = 0; iy < g->ny; iy++) {
        const double *left = m->left + iy * g->nx;
        struct cr_span row = {0, g->nx};
        while (row.lo < row.hi && !(left[row.lo] > 0)) {
            row.lo++;
        }
        while (row.lo < row.hi && !(left[row.hi - 1] > 0)) {
            row.hi--;
        }
        double most = 0;
        for (int ix = row.lo; ix < row.hi; ix++) {
            most = left[ix] > most ? left[ix] : most;
            col_most[ix] = left[ix] > col_most[ix] ? left[ix] : col_most[ix];
            m->col[ix].lo = iy < m->col[ix].lo && left[ix] > 0 ? iy : m->col[ix].lo;
            m->col[ix].hi = left[ix] > 0 ? iy + 1 : m->col[ix].hi;
        }
        row_most[iy] = most;
        m->row[iy] = row.lo < row.hi ? row : (struct cr_span){g->nx, 0};
    }
    m->rows = (struct cr_span){0, g->ny};
    m->cols = (struct cr_span){0, g->nx};
}

/* undeformed surface of every line from both its ends, and the depth of its material */
static void measure_faces(struct cr_moving *m) {
    static const enum cr_face end[] = {CR_FACE_FRONT, CR_FACE_LEFT};
    static const enum cr_face begin[] = {CR_FACE_REAR, CR_FACE_RIGHT};
    const struct cr_grid *g = &m->body->grid;
    for (int axis = 0; axis < 2; axis++) {
        enum cr_face hi = end[axis], lo = begin[axis];
        const struct cr_span *span = axis == 0 ? m->row : m->col;
        int lines = axis == 0 ? g->ny : g->nx, length = axis == 0 ? g->nx : g->ny;
        for (int i = 0; i < lines; i++) {
            double most = m->pitch[hi][i];
            m->pitch[hi][i] = m->pitch[lo][i] = g->h / (most > 0 ? most : 1);
            m->outline[hi][i] = (length - span[i].hi) * g->h;
            m->outline[lo][i] = span[i].lo * g->h;
        }
        m->dented[hi] = m->dented[lo] = (struct cr_span){lines, -1};
    }
}

/* energy per unit of material against each partner, shared where the layers are the same */
static bool new_units(struct cr_solver *s, struct cr_moving *m) {
    const struct cr_grid *g = &m->body->grid;
    for (int p = 0; p < s->cs->n; p++) {
        if (m == &s->m[p]) {
            continue;
        }
        const double *energy = m->body->energy_against[p];
        energy = energy != NULL ? energy : g->energy;
        for (int q = 0; q < p; q++) {
            const double *other = m->body->energy_against[q];
            if ((other != NULL ? other : g->energy) == energy) {
                m->unit[p] = m->unit[q];
                m->solid[p] = m->solid[q];
            }
        }
        if (m->unit[p] != NULL) {
            continue;
        }
        size_t n = (size_t)g->nx * (size_t)g->ny;
        double *unit = cr_arena_take_raw(&s->arena, n, sizeof *unit);
        if (unit == NULL) {
            return false;
        }
        m->solid[p] = true;
        for (size_t k = 0; k < n; k++) {
            unit[k] = m->left[k] > 0 ? energy[k] / g->fill[k] : 0;
            m->solid[p] = m->solid[p] && (unit[k] > 0 || !(m->left[k] > 0));
        }
        m->unit[p] = unit;
    }
    return true;
}

static void place_wheels(struct cr_moving *m) {
    const struct cr_grid *g = &m->body->grid;
    for (int i = 0; i < m->body->wheels; i++) {
        struct cr_vec2 at = m->body->wheel[i].at;
        double ix = floor((at.x - g->x0) / g->h), iy = floor((at.y - g->y0) / g->h);
        bool on_grid = ix >= 0 && iy >= 0 && ix < g->nx && iy < g->ny;
        m->wheel_voxel[i] = on_grid ? (int)iy * g->nx + (int)ix : -1;
    }
}

static bool new_grid(struct cr_solver *s, struct cr_moving *m) {
    const struct cr_grid *g = &m->body->grid;
    size_t n = (size_t)g->nx * (size_t)g->ny;
    m->left = cr_arena_take_raw(&s->arena, n, sizeof *m->left);
    m->t_sum = cr_arena_take(&s->arena, n, sizeof *m->t_sum);
    m->how = cr_arena_take(&s->arena, n, sizeof *m->how);
    if (m->left == NULL || m->t_sum == NULL || m->how == NULL || !new_lines(s, m)) {
        return false;
    }
    for (size_t k = 0; k < n; k++) {
        m->left[k] = g->fill[k] > 1e-6 ? g->fill[k] : 0;
    }
    span_lines(m);
    measure_faces(m);
    m->lo = cr_vec2(g->x0, g->y0);
    m->hi = cr_vec2(g->x0 + g->nx * g->h, g->y0 + g->ny * g->h);
    return cr_reach_new(s, m) && new_units(s, m);
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
        s->t = fmin(s->t, b->waypoint[0].t);
    }
    cr_shape_box(&b->shape, &m->lo, &m->hi);
    place_wheels(m);
    if (b->grid.nx > 0 && !new_grid(s, m)) {
        return false;
    }
    double x = fmax(fabs(m->lo.x), fabs(m->hi.x)), y = fmax(fabs(m->lo.y), fabs(m->hi.y));
    m->reach = b->shape.kind == CR_SHAPE_WALL ? (double)INFINITY : sqrt(x * x + y * y);
    float *when =
        b->grid.nx == 0
            ? NULL
            : cr_arena_take_raw(&s->arena, (size_t)b->grid.nx * (size_t)b->grid.ny, sizeof *when);
    s->out.body[i].t_crushed = when;
    return when != NULL || b->grid.nx == 0;
}

static bool new_scratch(struct cr_solver *s) {
    int longest = 1;
    for (int i = 0; i < s->cs->n; i++) {
        const struct cr_grid *g = &s->cs->body[i].grid;
        longest = g->nx > longest ? g->nx : longest;
        longest = g->ny > longest ? g->ny : longest;
    }
    struct cr_drag *d = &s->drag;
    size_t n = (size_t)longest;
    d->w = cr_arena_take(&s->arena, n, sizeof *d->w);
    d->own = cr_arena_take(&s->arena, n, sizeof *d->own);
    s->met = cr_arena_take(&s->arena, n, sizeof *s->met);
    s->freed = cr_arena_take(&s->arena, 1, sizeof *s->freed);
    return d->w != NULL && d->own != NULL && s->met != NULL && s->freed != NULL;
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
    if (s != NULL) {
        free(s->losses[0].loss);
        free(s->losses[1].loss);
        free(s->contact);
        free(s->times);
        free(s->trace);
        free(s->slice);
        cr_arena_free(&s->arena);
        free(s);
    }
}

const struct cr_solution *cr_solver_solution(struct cr_solver *s) {
    cr_record_outcome(s);
    return &s->out;
}

double cr_solver_time(const struct cr_solver *s) {
    return s->t;
}

bool cr_solver_touched(const struct cr_solver *s) {
    return s->touched;
}

/* whether another contact of one of the two presses on */
static bool held_elsewhere(const struct cr_solver *s, int a, int b) {
    for (int i = 0; i < s->cs->n; i++) {
        for (int k = i + 1; k < s->cs->n; k++) {
            bool shared = i == a || i == b || k == a || k == b;
            if (shared && !(i == a && k == b) && s->touch[cr_pair(s, i, k)].record >= 0) {
                return true;
            }
        }
    }
    return false;
}

/* Structures that have crushed each other touch again with all their length at once, and would stop
 * within a slice: they are sprung, and take some ms. */
static void soften(struct cr_solver *s, int pair, int a, int b, struct cr_force *f) {
    struct cr_touch *t = &s->touch[pair];
    double speed = cr_force_approach(s, a, b, f);
    if (!(t->spent > 0) || !(speed > 0) || held_elsewhere(s, a, b)) {
        return;
    }
    double left = cr_impulse_left(s, a, b, f->coe, f->normal, f->direction);
    t->most = fmax(t->most, left / touch_time);
    double share = t->most * speed * s->dt / f->energy;
    if (share < 1) {
        cr_deform_scale(&s->losses[0], share);
        cr_deform_scale(&s->losses[1], share);
        f->energy *= share;
    }
}

/* no more force than strength times width */
static void bound(struct cr_solver *s, int a, int b, struct cr_force *f) {
    double share = cr_deform_bound(s, a, b, f);
    if (share < 1) {
        cr_deform_scale(&s->losses[0], share);
        cr_deform_scale(&s->losses[1], share);
        f->energy *= share;
    }
}

/* steps 1 to 3 for a pair whose materials meet; false when memory is out */
static bool crush(struct cr_solver *s, int pair, int a, int b, struct cr_force *f) {
    struct cr_moving *ma = &s->m[a], *mb = &s->m[b];
    if (s->touch[pair].record < 0) {
        if (!s->touched) {
            s->touched = true;
            s->dt_contact = s->dt;
            cr_record_before(s);
        }
        if (!cr_record_contact(s, pair, a, b, f)) {
            return false;
        }
    }
    bound(s, a, b, f);
    soften(s, pair, a, b, f);
    struct cr_vec2 v = cr_relative_velocity(s, a, b, f->coe);
    struct cr_vec2 back = cr_vec2_scale(v, -1), inward = cr_vec2_scale(f->normal, -1);
    cr_losses_turn(ma, &s->losses[0], inward, back);
    cr_losses_turn(mb, &s->losses[1], f->normal, v);
    s->touch[pair].face[0] = s->losses[0].face;
    s->touch[pair].face[1] = s->losses[1].face;
    cr_deform_apply(ma, &s->losses[0], 0);
    cr_deform_apply(mb, &s->losses[1], 0);
    if (s->cs->opts.induced) {
        double most = cr_deform_made_up * cr_vec2_len(v) * s->dt;
        if (!cr_drag_along(s, ma, &s->losses[0], most) ||
            !cr_drag_along(s, mb, &s->losses[1], most)) {
            return false;
        }
        cr_force_update(s, pair, a, b, f);
    }
    return cr_kinetics_slice(s, pair, a, b, f);
}

static bool work_pair(struct cr_solver *s, int pair, int a, int b) {
    struct cr_moving *ma = &s->m[a], *mb = &s->m[b];
    struct cr_touch *t = &s->touch[pair];
    if ((ma->inv_mass == 0 && mb->inv_mass == 0) || (ma->at_rest && mb->at_rest)) {
        return true;
    }
    if (t->record >= 0 && s->contact[t->record].phase != CR_PHASE_PLASTIC) {
        return cr_elastic_slice(s, pair, a, b);
    }
    if (!cr_deform_collect(s, a, b)) {
        return false;
    }
    struct cr_force f;
    bool deformed = s->losses[0].n + s->losses[1].n > 0 && cr_force_find(s, pair, a, b, &f);
    deformed = deformed && (t->record >= 0 || cr_force_approach(s, a, b, &f) > begin_speed);
    if (deformed && !crush(s, pair, a, b, &f)) {
        return false;
    }
    if (t->record >= 0) {
        cr_abort_check(s, pair, a, b, deformed);
    }
    return true;
}

/* a wheel whose place was crushed to more than half slides (issue: after the impact) */
static void drag_wheels(struct cr_moving *m) {
    for (int i = 0; i < m->body->wheels; i++) {
        int k = m->wheel_voxel[i];
        m->drag[i] = m->drag[i] || (k >= 0 && m->left[k] < 0.5 * m->body->grid.fill[k]);
    }
}

static void begin_slice(struct cr_solver *s) {
    for (int i = 0; i < s->cs->n; i++) {
        struct cr_moving *m = &s->m[i];
        m->vel_begin = m->vel;
        m->yaw_begin = m->yaw_rate;
        m->slice_impulse = m->slice_coe = cr_vec2(0, 0);
        m->slice_weight = 0;
    }
}

/* velocity changes of the slice count into delta-v for the bodies that are in contact */
static void end_slice(struct cr_solver *s, const bool in_contact[]) {
    for (int i = 0; i < s->cs->n; i++) {
        struct cr_moving *m = &s->m[i];
        if (in_contact[i]) {
            m->delta_v = cr_vec2_add(m->delta_v, cr_vec2_sub(m->vel, m->vel_begin));
            m->yaw_change += m->yaw_rate - m->yaw_begin;
            m->t_last = s->t_struck = s->t;
            s->out.body[i].after = cr_solver_state(s, i);
            drag_wheels(m);
        }
    }
}

static enum cr_status failed(struct cr_error *err, enum cr_err code, const char *text) {
    cr_err_set(err, code, "%s", text);
    return CR_STATUS_FAILED;
}

static bool finite_state(const struct cr_solver *s) {
    for (int i = 0; i < s->cs->n; i++) {
        const struct cr_moving *m = &s->m[i];
        if (!isfinite(m->pos.x + m->pos.y + m->vel.x + m->vel.y + m->heading + m->yaw_rate)) {
            return false;
        }
    }
    return true;
}

/* Work all pairs, in the order of the scene and backwards in turns: a body between two others feels
 * the first of its contacts before the second, and the lead changes from slice to slice. */
static bool work_pairs(struct cr_solver *s, bool in_contact[], bool *any, bool *rubbing) {
    int n = s->cs->n, pairs = n * (n - 1) / 2;
    s->backwards = !s->backwards;
    for (int k = 0; k < pairs; k++) {
        int p = s->backwards ? pairs - 1 - k : k, a = 0, first = 0;
        while (p - first >= n - 1 - a) { /* pair first is (a, a + 1) */
            first += n - 1 - a++;
        }
        int b = a + 1 + p - first;
        bool before = s->touch[p].record >= 0;
        double pushed = s->m[a].slice_weight;
        if (!work_pair(s, p, a, b)) {
            return false;
        }
        bool met = before || s->touch[p].record >= 0 || s->m[a].slice_weight > pushed;
        const struct cr_touch *t = &s->touch[p];
        /* what an elastic phase has taken it must give back, be it only rubbing */
        bool elastic = t->record >= 0 && s->contact[t->record].phase != CR_PHASE_PLASTIC;
        *any = *any || (met && (elastic || !t->rubbing));
        *rubbing = *rubbing || (met && t->rubbing);
        if (met && !t->rubbing) {
            in_contact[a] = in_contact[b] = true;
        }
    }
    return true;
}

enum cr_status cr_solver_step(struct cr_solver *s, struct cr_error *err) {
    if (s->done) {
        return CR_STATUS_DONE;
    }
    bool in_contact[CR_BODY_MAX] = {false}, any = false, rubbing = false;
    s->dt = cr_kinematics_slice_length(s);
    begin_slice(s);
    cr_kinematics_move(s);
    if (!work_pairs(s, in_contact, &any, &rubbing)) {
        return failed(err, CR_ERR_MEMORY, "no memory for the solve");
    }
    for (int i = 0; i < s->cs->n; i++) {
        cr_tyres_apply(s, i);
    }
    if (!finite_state(s)) {
        return failed(err, CR_ERR_SOLVER, "a velocity is no longer finite");
    }
    end_slice(s, in_contact);
    if (!s->touched) {
        if (s->t > s->cs->opts.max_time) {
            cr_err_set(err, CR_ERR_NO_CONTACT, "the participants never meet within %g s",
                       s->cs->opts.max_time);
            cr_err_hint(err, "check positions, headings, speeds and height ranges");
            return CR_STATUS_FAILED;
        }
        return CR_STATUS_RUNNING;
    }
    if (s->cs->opts.end == CR_END_REST) {
        cr_ending_rest(s, in_contact);
    }
    if (!cr_record_sample(s)) {
        return failed(err, CR_ERR_MEMORY, "no memory for the trace");
    }
    cr_ending_check(s, any, rubbing);
    return s->done ? CR_STATUS_DONE : CR_STATUS_RUNNING;
}

/* the caller's doing, or its going on: no criterion has ended the contacts that are plastic */
static void mark_interrupted(struct cr_solver *s, bool interrupted) {
    s->out.interrupted = interrupted;
    for (int i = 0; i < s->contacts; i++) {
        if (s->contact[i].phase == CR_PHASE_PLASTIC) {
            s->contact[i].stop = interrupted ? CR_STOP_INTERRUPTED : CR_STOP_NONE;
        }
    }
}

enum cr_err cr_solver_run(struct cr_solver *s, int (*cancel)(void *), void *user,
                          struct cr_error *err) {
    struct cr_error unasked;
    err = err != NULL ? err : &unasked;
    enum cr_status status = CR_STATUS_RUNNING;
    mark_interrupted(s, false);
    while (status == CR_STATUS_RUNNING) {
        if (cancel != NULL && cancel(user) != 0) {
            mark_interrupted(s, true);
            return cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted at t = %.4g s", s->t);
        }
        status = cr_solver_step(s, err);
    }
    return status == CR_STATUS_DONE ? CR_ERR_OK : err->code;
}
