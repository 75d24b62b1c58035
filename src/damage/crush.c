/* The energy behind a measured outline: which voxels lie outside of it, and what they took. */
#include "damage/crush.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

int cr_crush_face_find(const char *word) {
    for (int i = 0; i < CR_FACES; i++) {
        if (strcmp(cr_face_word((enum cr_face)i), word) == 0) {
            return i;
        }
    }
    return -1;
}

double cr_crush_square(enum cr_face face) {
    static const double degrees[CR_FACES] = {
        [CR_FACE_FRONT] = 0, [CR_FACE_LEFT] = 270, [CR_FACE_REAR] = 180, [CR_FACE_RIGHT] = 90};
    return cr_rad(degrees[face]);
}

void cr_crush_init(struct cr_measured *crush) {
    *crush = (struct cr_measured){.length = NAN,
                                  .direct = NAN,
                                  .direct_offset = NAN,
                                  .pdof = NAN,
                                  .z_hi = INFINITY,
                                  .depth_tol = 0.03,
                                  .length_tol = 0.05,
                                  .offset_tol = 0.05,
                                  .pdof_tol = cr_rad(20)};
}

enum cr_model_end cr_crush_end(enum cr_face face) {
    return face == CR_FACE_FRONT  ? CR_MODEL_FRONT
           : face == CR_FACE_REAR ? CR_MODEL_REAR
                                  : CR_MODEL_SIDE;
}

static double face_span(const struct cr_participant *p, enum cr_face face) {
    return cr_face_is_end(face) ? p->width : p->length;
}

static enum cr_err check_stations(const struct cr_measured *m, const struct cr_participant *p,
                                  struct cr_error *err) {
    double reach = cr_face_is_end(m->face) ? p->length : p->width;
    for (int i = 0; i < m->stations; i++) {
        if (!(m->depth[i] >= 0 && m->depth[i] < 0.9 * reach)) {
            cr_err_set(err, CR_ERR_RANGE, "%s: C%d of %.3g m does not fit the vehicle of %.3g m",
                       p->id, i + 1, m->depth[i], reach);
            cr_err_hint(err, "depths are in m in a file, with their unit in commands");
            return CR_ERR_RANGE;
        }
    }
    return CR_ERR_OK;
}

/* Refuses tolerances below nothing and beyond the vehicle: a number less certain than that says
 * nothing, and its interval has no end. */
static enum cr_err check_tolerances(const struct cr_measured *m, const struct cr_participant *p,
                                    struct cr_error *err) {
    double tol = fmax(m->depth_tol, fmax(m->length_tol, m->offset_tol));
    double least = fmin(m->depth_tol, fmin(m->length_tol, m->offset_tol));
    if (!(least >= 0 && m->pdof_tol >= 0 && m->mass_tol >= 0)) {
        cr_err_set(err, CR_ERR_RANGE, "%s: a tolerance is not negative", p->id);
    } else if (tol > p->length) {
        cr_err_set(err, CR_ERR_RANGE,
                   "%s: a tolerance of %.3g m is more than the vehicle of %.3g m", p->id, tol,
                   p->length);
    } else if (m->pdof_tol > CR_PI) {
        cr_err_set(err, CR_ERR_RANGE, "%s: a tolerance of %.4g degrees is more than half a turn",
                   p->id, cr_deg(m->pdof_tol));
    } else if (m->mass_tol > p->mass) {
        cr_err_set(err, CR_ERR_RANGE, "%s: a tolerance of %.4g kg is more than the mass of %.4g kg",
                   p->id, m->mass_tol, p->mass);
    } else {
        return CR_ERR_OK;
    }
    cr_err_hint(err, "leave out what was not measured: usual tolerances are taken");
    return CR_ERR_RANGE;
}

enum cr_err cr_crush_check(const struct cr_measured *m, const struct cr_participant *p,
                           struct cr_error *err) {
    double span = face_span(p, m->face);
    if (m->stations < 2) {
        cr_err_set(err, CR_ERR_MISSING, "%s has fewer than two stations of crush", p->id);
        cr_err_hint(err, "measure C1 to C6, evenly over the damaged field");
        return CR_ERR_MISSING;
    }
    if (!(m->length > 0)) {
        cr_err_set(err, CR_ERR_MISSING, "%s has no length of the damaged field", p->id);
        cr_err_hint(err, "the distance from C1 to the last station");
        return CR_ERR_MISSING;
    }
    /* The field may stand out by a tenth: tape and dimensions are not better than that. */
    if (fabs(m->offset) + m->length / 2 > 0.6 * span) {
        cr_err_set(err, CR_ERR_RANGE,
                   "%s: a field of %.3g m at %+.3g m lies outside the %s of %.3g m", p->id,
                   m->length, m->offset, cr_face_word(m->face), span);
        cr_err_hint(err, "the offset is that of its middle, to the right or forward");
        return CR_ERR_RANGE;
    }
    if (!(m->z_lo < m->z_hi)) {
        return cr_err_set(err, CR_ERR_RANGE, "%s: the heights struck must rise", p->id);
    }
    double off = remainder(m->pdof - cr_crush_square(m->face), 2 * CR_PI);
    if (!isnan(m->pdof) && fabs(off) >= CR_PI / 2) {
        cr_err_set(err, CR_ERR_RANGE, "%s: a force from %.4g degrees pulls at the %s", p->id,
                   cr_deg(m->pdof), cr_face_word(m->face));
        cr_err_hint(err, "PDOF is clockwise from ahead; %.0f is square to that face",
                    cr_deg(cr_crush_square(m->face)));
        return CR_ERR_RANGE;
    }
    enum cr_err code = check_stations(m, p, err);
    return code == CR_ERR_OK ? check_tolerances(m, p, err) : code;
}

enum cr_err cr_crush_open(const struct cr_model_lib *lib, const struct cr_participant *p,
                          const struct cr_measured *measured, struct cr_arena *arena,
                          struct cr_crush_car *out, struct cr_error *err) {
    struct cr_scene scene;
    cr_scene_init(&scene);
    *out = (struct cr_crush_car){.p = p, .m = *measured};
    snprintf(out->id, sizeof out->id, "%s", p->id);
    enum cr_err code = cr_crush_check(measured, p, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (isnan(out->m.pdof)) {
        out->m.pdof = cr_crush_square(out->m.face);
    }
    if (out->m.mass_tol <= 0) {
        cr_crush_mass(p, 0, &out->m);
    }
    scene.set.voxel = 0.025;
    /* The model is the one square to the face: an oblique force still crushes that face. */
    struct cr_model_query q = cr_scene_query(&scene, p, cr_crush_square(out->m.face));
    q.curve = CR_CURVE_DYNAMIC;
    q.built = 0; /* the levels are those of the field's cars, whose recorders tell no years apart */
    q.z_lo = fmax(0, measured->z_lo);
    q.z_hi = measured->z_hi;
    return p->model.kind == CR_MODEL_STIFFNESS
               ? cr_model_from_stiffness(lib, &q, p->model.face, arena, &out->grid, err)
               : cr_model_substitute(lib, &q, arena, &out->grid, err);
}

static double deepest(const struct cr_measured *m) {
    double depth = 0;
    for (int i = 0; i < m->stations; i++) {
        depth = fmax(depth, m->depth[i]);
    }
    return depth;
}

/* Width of what was struck directly, and its middle along the face, m. */
static double struck_width(const struct cr_measured *m, double *middle) {
    *middle = isnan(m->direct_offset) ? m->offset : m->direct_offset;
    return isnan(m->direct) ? m->length : m->direct;
}

/* Residual depth at a place along the face, linear between stations; beyond the field the depth of
 * its end holds. */
static double residual_at(const struct cr_measured *m, double at) {
    double s = ((at - m->offset) / m->length + 0.5) * (m->stations - 1);
    s = cr_clamp(s, 0, m->stations - 1);
    int k = (int)fmin(floor(s), m->stations - 2);
    return m->depth[k] + (s - k) * (m->depth[k + 1] - m->depth[k]);
}

double cr_crush_dynamic(const struct cr_measured *m, const struct cr_crush_rules *rules, double at,
                        bool *direct) {
    double middle, wide = struck_width(m, &middle);
    bool in_field = fabs(at - m->offset) <= m->length / 2;
    *direct = fabs(at - middle) <= wide / 2;
    if (!in_field && !*direct) {
        return 0;
    }
    double c = residual_at(m, at), rise = rules->rise[cr_crush_end(m->face)];
    /* What was struck was pressed in by the rise even where no depth is left; what was dragged in
     * beside it springs back less the shallower it is. */
    return c + (*direct ? rise : rise * fmin(1, c / rules->ramp));
}

/* Index of the k-th voxel from outside in a line of voxels square to the face. */
static int voxel_at(const struct cr_grid *g, enum cr_face face, int line, int k) {
    int n = cr_face_line_length(g, face);
    int along = cr_face_from_high(face) ? n - 1 - k : k;
    return cr_face_is_end(face) ? line * g->nx + along : along * g->nx + line;
}

/* Where a line lies in the body frame, m: its y at an end, its x at a side. */
static double line_at(const struct cr_crush_car *car, int line) {
    const struct cr_grid *g = &car->grid;
    return (cr_face_is_end(car->m.face) ? g->y0 : g->x0) + (line + 0.5) * g->h;
}

/* Place of a line along the face as it is measured: from the middle to the right, or forward. */
static double line_place(const struct cr_crush_car *car, int line) {
    double at = line_at(car, line);
    double middle = car->p->front_overhang + car->p->cg_behind_front_axle - car->p->length / 2;
    return cr_face_is_end(car->m.face) ? -at : at - middle;
}

struct line_sum {
    double energy; /* J */
    double moment; /* energy times its place along the line in the body frame, J m */
    double force;  /* of the innermost voxel that counts, N */
};

/* Sums the outer material of a line down to a depth of material (m), and takes it off left
 * (nullable). */
static struct line_sum sum_line(const struct cr_crush_car *car, int line, double depth,
                                double *left) {
    const struct cr_grid *g = &car->grid;
    enum cr_face face = car->m.face;
    struct line_sum sum = {0, 0, 0};
    int n = cr_face_line_length(g, face);
    for (int k = 0; k < n && depth > 1e-9; k++) {
        int i = voxel_at(g, face, line, k);
        if (g->fill[i] <= 0) {
            continue;
        }
        double share = fmin(1, depth / (g->fill[i] * g->h));
        double e = share * g->energy[i];
        int along = cr_face_is_end(face) ? i % g->nx : i / g->nx;
        double at = (cr_face_is_end(face) ? g->x0 : g->y0) + (along + 0.5) * g->h;
        sum.energy += e;
        sum.moment += e * at;
        sum.force = g->energy[i] / (g->fill[i] * g->h);
        depth -= share * g->fill[i] * g->h;
        if (left != NULL) {
            left[i] -= share * g->fill[i];
        }
    }
    return sum;
}

static double oblique_factor(const struct cr_measured *m, const struct cr_crush_rules *rules) {
    double off = remainder(m->pdof - cr_crush_square(m->face), 2 * CR_PI);
    /* CRASH3 stops at 45 degrees, where the work along the face is as much as that into it. */
    double t = tan(fmin(fabs(off), CR_PI / 4));
    return 1 + rules->oblique * t * t;
}

void cr_crush_energy(const struct cr_crush_car *car, const struct cr_crush_rules *rules,
                     struct cr_crush_energy *out) {
    const struct cr_measured *m = &car->m;
    double along = 0, across = 0;
    double factor = rules->level[cr_crush_end(m->face)] * car->p->model.energy_factor *
                    oblique_factor(m, rules);
    *out = (struct cr_crush_energy){.energy = 0};
    for (int line = 0; line < cr_face_lines(&car->grid, m->face); line++) {
        bool direct;
        double at = line_place(car, line), w = cr_crush_dynamic(m, rules, at, &direct);
        struct line_sum sum = sum_line(car, line, w, NULL);
        out->energy += factor * sum.energy;
        out->induced += direct ? 0 : factor * sum.energy;
        out->force += factor * sum.force;
        across += sum.energy * line_at(car, line);
        along += sum.moment;
        if (fabs(at - m->offset) <= m->length / 2) {
            out->area += residual_at(m, at) * car->grid.h;
        }
    }
    out->depth = deepest(m);
    double raw = out->energy / factor;
    if (raw > 0) {
        out->coe = cr_face_is_end(m->face) ? cr_vec2(along / raw, across / raw)
                                           : cr_vec2(across / raw, along / raw);
    }
}

void cr_crush_left(const struct cr_crush_car *car, const struct cr_crush_rules *rules,
                   bool residual, double *left) {
    const struct cr_grid *g = &car->grid;
    memcpy(left, g->fill, (size_t)g->nx * (size_t)g->ny * sizeof *left);
    for (int line = 0; line < cr_face_lines(g, car->m.face); line++) {
        bool direct;
        double at = line_place(car, line), w = cr_crush_dynamic(&car->m, rules, at, &direct);
        bool in_field = fabs(at - car->m.offset) <= car->m.length / 2;
        sum_line(car, line, !residual ? w : in_field ? residual_at(&car->m, at) : 0, left);
    }
}

void cr_crush_cdc(const struct cr_crush_car *car, char cdc[12]) {
    const struct cr_measured *m = &car->m;
    const struct cr_participant *p = car->p;
    double span = face_span(p, m->face);
    double middle, wide = struck_width(m, &middle);
    /* The nine zones of depth of an end reach to the far end of the passengers' room [CDC-J224],
     * here to the middle of the vehicle; those of a side reach across it. */
    double zone = cr_face_is_end(m->face) ? p->length / 2 : p->width;
    const struct cr_cdc_case what = {.pdof = m->pdof,
                                     .face = m->face,
                                     .lo = (middle - wide / 2) / span + 0.5,
                                     .hi = (middle + wide / 2) / span + 0.5,
                                     .width = wide,
                                     .depth = deepest(m),
                                     .zone = zone};
    cr_cdc_write(&what, cdc);
}
