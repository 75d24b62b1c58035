/* Measures the damage one impact left on one vehicle: struck faces, depths, crush profile, CDC. */
#include "result/damage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* From this residual depth on a column counts as damaged, m: a tape measure shows no less. */
static const double damaged = 0.01;
/* Front and rear are measured along the bumper beam, whose width is this share of the vehicle's:
 * recorded damage width over overall width of 186 full-width wall tests [RESIDUAL-SHAPE]. */
static const double beam_width = 0.83;
/* Where the undeformed outline lies further back than this, m, the corner begins that leads round
 * to the next face; the crush profile ends there. */
static const double corner = 0.15;
/* The B-pillar stands this share of the wheelbase behind the front axle; only the extent zones of
 * the CDC use it. */
static const double b_pillar = 0.5;
/* Belt line and upper edge of the frame as shares of the height: the paper models' profiles put
 * the sill at 0.3 and the lower edge of the windows at 0.62 of the height. */
static const double belt = 0.62, frame = 0.35;
/* From this share of the height on an object at a flank reaches above the belt line. */
static const double roof = 0.75;
/* SAE J224 counts direct damage of an end as the flank's if it runs along the flank and is no wider
 * than 4 in, m. */
static const double scrape = 0.102;
/* A second face is reported from this share of the energy and this depth on, m. */
static const double second_share = 0.2, second_depth = 0.05;
/* A loss below this share of a voxel's material is rounding. */
static const double nothing = 1e-9;

/* What the steps of measuring one impact on one body share. */
struct damage {
    const struct cr_result *r;
    const struct cr_events *all;
    const struct cr_event *event;
    int side, body;
    struct cr_deform deform; /* after the impact, with the damage of earlier ones to this face */
    double *left;            /* [ny * nx] material left then, where there were several; owned */
    const short *of;         /* impact that crushed each voxel, NULL: this one crushed all */
};

struct face_damage {
    int lo, hi;                       /* first and last damaged column, lo > hi without damage */
    int direct_lo, direct_hi;         /* the same of direct damage */
    double residual_sum, dynamic_sum; /* sums of the columns' depths, m */
    double depth;                     /* deepest mean over 0.1 m, as the grid has it, m */
};

/* The residual and the dynamic depth of a loss: the grid holds one of the two, the springback of
 * the face gives the other. */
static struct cr_depth both(const struct cr_deform *d, enum cr_face face, double lost) {
    double back = d->grid->springback[face];
    return d->residual_curve ? (struct cr_depth){lost, cr_deform_dynamic(lost, back)}
                             : (struct cr_depth){cr_deform_residual(lost, back), lost};
}

static struct cr_vec2 voxel_at(const struct cr_grid *g, int i) {
    return cr_vec2(g->x0 + (i % g->nx + 0.5) * g->h, g->y0 + ((int)(i / g->nx) + 0.5) * g->h);
}

/* ---- which impact crushed a voxel ---- */

static bool same_body(const struct cr_event *e, int body, int *side) {
    *side = e->body[1] == body;
    return e->body[0] == body || e->body[1] == body;
}

/* The impact that crushed a voxel at time t: the impact of the body that lasted then, of several
 * the one that pressed nearest to the voxel; where none lasted (rubbing) the latest before. */
static int owner(const struct cr_events *all, int body, double t, struct cr_vec2 at) {
    int best = -1;
    double nearest = INFINITY;
    bool lasting = false;
    for (int i = 0; i < all->n; i++) {
        const struct cr_event *e = &all->event[i];
        int side;
        if (!same_body(e, body, &side)) {
            continue;
        }
        bool in = t > e->t_begin - 1e-6 && t <= e->t_end + 1e-6;
        double away = cr_vec2_len(cr_vec2_sub(at, e->of[side].coe));
        bool nearer = in == lasting && (in ? away < nearest : e->t_begin < t + 1e-6);
        if (best < 0 || (in && !lasting) || nearer) {
            best = i;
            nearest = away;
            lasting = in;
        }
    }
    return best;
}

enum cr_err cr_damage_owners(const struct cr_result *r, const struct cr_events *all, int body,
                             short **out, struct cr_error *err) {
    const struct cr_grid *g = cr_result_grid(r, body);
    const struct cr_outcome *o = &r->solution->body[body];
    size_t n = (size_t)g->nx * (size_t)g->ny;
    *out = malloc((n > 0 ? n : 1) * sizeof **out);
    if (*out == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the damage of a result");
    }
    for (size_t i = 0; i < n; i++) {
        bool lost = g->fill[i] - o->left[i] > nothing;
        (*out)[i] =
            (short)(lost ? owner(all, body, (double)o->t_crushed[i], voxel_at(g, (int)i)) : -1);
    }
    return CR_ERR_OK;
}

/* ---- faces ---- */

/* Unit vector in which the partner moved over the body at time t, own frame. */
static struct cr_vec2 way_at(const struct cr_solution *sol, const struct cr_event *e, int side,
                             double t) {
    const struct cr_vec2 *way = e->of[side].way;
    int lo = 0, hi = e->samples - 1;
    while (lo < hi) { /* the first slice that ends at t or later */
        int mid = (lo + hi) / 2;
        if (sol->t[e->first + mid] < t - 1e-9) {
            lo = mid + 1;
        } else {
            hi = mid;
        }
    }
    return e->samples > 0 ? way[lo] : cr_vec2(0, 0);
}

/* The first known such direction of an impact; (0, 0) where the solution has no slices. */
static struct cr_vec2 first_way(const struct cr_event *e, int side) {
    for (int i = 0; i < e->samples; i++) {
        if (cr_vec2_len(e->of[side].way[i]) > 0) {
            return e->of[side].way[i];
        }
    }
    return cr_vec2(0, 0);
}

static enum cr_face began_at(const struct damage *m, struct cr_vec2 inward) {
    struct cr_vec2 way = first_way(m->event, m->side), touch = m->event->of[m->side].touch;
    return cr_vec2_len(way) > 0 ? cr_deform_face_at(m->deform.grid, touch, way)
                                : cr_deform_face(&m->deform, inward);
}

/* Splits the energy of this impact by the face through which its partner came, J; with left
 * (nullable, [ny * nx]) also the material that is left if only the damage through `face` counts. */
static void split_faces(const struct damage *m, double energy[CR_FACES], double *left, int face) {
    const struct cr_grid *g = m->deform.grid;
    const float *when = m->r->solution->body[m->body].t_crushed;
    int own = (int)(m->event - m->all->event);
    struct cr_vec2 start = first_way(m->event, m->side);
    for (int i = 0; i < g->nx * g->ny; i++) {
        double lost = g->fill[i] - m->deform.left[i];
        bool here = lost > nothing && (m->of == NULL || m->of[i] == own);
        enum cr_face f = CR_FACES;
        if (here) {
            struct cr_vec2 way =
                when != NULL ? way_at(m->r->solution, m->event, m->side, (double)when[i]) : start;
            f = cr_deform_face_at(g, voxel_at(g, i), cr_vec2_unit(way, start));
            energy[f] += g->energy[i] * lost / g->fill[i];
        }
        if (left != NULL) {
            left[i] = (int)f == face ? m->deform.left[i] : g->fill[i];
        }
    }
}

static struct face_damage scan_face(const struct cr_deform *d, enum cr_face face) {
    int n = cr_face_lines(d->grid, face);
    struct face_damage f = {.lo = n, .hi = -1, .direct_lo = n, .direct_hi = -1};
    struct cr_deepest deepest = {.step = d->grid->h};
    for (int k = 0; k < n; k++) {
        double lost = cr_deform_column(d, face, k, false);
        struct cr_depth all = both(d, face, lost);
        struct cr_depth direct =
            lost > 0 ? both(d, face, cr_deform_column(d, face, k, true)) : (struct cr_depth){0};
        f.residual_sum += all.residual;
        f.dynamic_sum += all.dynamic;
        cr_deepest_add(&deepest, lost);
        if (all.residual > damaged) {
            f.lo = k < f.lo ? k : f.lo;
            f.hi = k;
        }
        if (direct.residual > damaged) {
            f.direct_lo = k < f.direct_lo ? k : f.direct_lo;
            f.direct_hi = k;
        }
    }
    f.depth = cr_deepest_get(&deepest);
    return f;
}

/* Width of the columns from lo to hi, both included, m; 0 for lo > hi, which is none. */
static double width_of(const struct cr_deform *d, int lo, int hi) {
    return hi < lo ? 0 : (hi + 1 - lo) * d->grid->h;
}

/* The flank that lies nearer to the damage of an end. */
static enum cr_face flank_beside(const struct damage *m, const struct face_damage *f) {
    int n = cr_face_lines(m->deform.grid, CR_FACE_FRONT);
    return f->lo + f->hi < n - 1 ? CR_FACE_LEFT : CR_FACE_RIGHT;
}

/* The struck face is where the contact began; but a partner that only scrapes past an end has
 * struck the flank. */
static struct face_damage choose_face(struct damage *m, struct cr_severity *s,
                                      struct cr_vec2 inward) {
    s->face = began_at(m, inward);
    struct face_damage f = scan_face(&m->deform, s->face);
    if (cr_face_is_end(s->face) && f.direct_hi >= f.direct_lo &&
        width_of(&m->deform, f.direct_lo, f.direct_hi) <= scrape) {
        enum cr_face flank = flank_beside(m, &f);
        struct face_damage g = scan_face(&m->deform, flank);
        if (width_of(&m->deform, g.direct_lo, g.direct_hi) > scrape) {
            s->face = flank;
            return g;
        }
    }
    return f;
}

static enum cr_err second_face(struct damage *m, struct cr_severity *s, struct cr_error *err) {
    double energy[CR_FACES] = {0}, sum = 0;
    s->second.face = CR_FACES;
    split_faces(m, energy, NULL, CR_FACES);
    int best = -1;
    for (int f = 0; f < CR_FACES; f++) {
        sum += energy[f];
        best = f != (int)s->face && (best < 0 || energy[f] > energy[best]) ? f : best;
    }
    /* In a scrape along the flank the partner's direction may count all its energy for the end:
     * then the struck face has none, and the energy of the end makes no second face. */
    bool beside = !(energy[s->face] > 0);
    if (beside || !(energy[best] > second_share * sum)) {
        return CR_ERR_OK;
    }
    const struct cr_grid *g = m->deform.grid;
    double *left = malloc((size_t)g->nx * (size_t)g->ny * sizeof *left);
    if (left == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the damage of a result");
    }
    split_faces(m, energy, left, best);
    struct cr_deform d = m->deform;
    d.left = left;
    d.through = true;
    struct face_damage f = scan_face(&d, (enum cr_face)best);
    struct cr_depth deep = both(&d, (enum cr_face)best, f.depth);
    if (deep.residual >= second_depth) {
        s->second = (struct cr_second_face){.face = (enum cr_face)best,
                                            .depth = deep.residual,
                                            .depth_dynamic = deep.dynamic,
                                            .width = width_of(&d, f.lo, f.hi)};
        m->deform.through = false; /* damage behind intact material belongs to the second face */
    }
    free(left);
    return CR_ERR_OK;
}

/* ---- C1..C6 ---- */

/* Depth of the face at position x, in columns, whose middles lie at 0.5, 1.5, ...; linear between
 * the middles. *setback gets how far the undeformed outline lies back there, both m. */
static double depth_at(const struct cr_deform *d, enum cr_face face, double x, double *setback) {
    int n = cr_face_lines(d->grid, face);
    double at = cr_clamp(x - 0.5, 0, n - 1);
    int k = (int)at < n - 1 ? (int)at : n - 2, l = n > 1 ? k + 1 : 0;
    double f = n > 1 ? at - k : 0;
    k = n > 1 ? k : 0;
    double a = cr_deform_column(d, face, k, false), b = cr_deform_column(d, face, l, false);
    double u = cr_deform_setback(d->grid, face, k), v = cr_deform_setback(d->grid, face, l);
    *setback = u + f * (v - u);
    return a + f * (b - a);
}

/* Takes C1..C6 at six equally spaced points of the damaged width [CRUSH-POINTS]: once from a
 * straight line along the foremost point of the undeformed face, as a string is stretched, and once
 * from the undeformed outline, so that the curvature of the face does not count as crush. */
static void crush_profile(const struct cr_deform *d, const struct face_damage *f,
                          struct cr_severity *s) {
    int n = cr_face_lines(d->grid, s->face);
    double lo = f->lo + 0.5, hi = f->hi + 0.5; /* these are middles of columns */
    double foremost = INFINITY, setback;
    for (int k = 0; k < n; k++) {
        foremost = fmin(foremost, cr_deform_setback(d->grid, s->face, k));
    }
    if (cr_face_is_end(s->face)) {
        lo = fmax(lo, n * (1 - beam_width) / 2);
        hi = fmin(hi, n * (1 + beam_width) / 2);
    }
    if (!(hi >= lo)) {
        return;
    }
    while (lo < hi && cr_deform_setback(d->grid, s->face, (int)lo) - foremost > corner) {
        lo = (int)lo + 1.5;
    }
    while (lo < hi && cr_deform_setback(d->grid, s->face, (int)hi) - foremost > corner) {
        hi = (int)hi - 0.5;
    }
    /* The whole face springs back by one share, so that a straight line stays straight. */
    struct cr_depth deep = both(d, s->face, f->depth);
    double residual = f->depth > 0 ? deep.residual / f->depth : 1;
    double dynamic = f->depth > 0 ? deep.dynamic / f->depth : 1;
    for (int i = 0; i < CR_PROFILE; i++) {
        double x = lo + (hi - lo) * i / (CR_PROFILE - 1);
        double lost = depth_at(d, s->face, x, &setback);
        struct cr_depth c = both(d, s->face, lost);
        s->profile[i] = residual * (lost + setback - foremost);
        s->profile_dynamic[i] = dynamic * (lost + setback - foremost);
        s->profile_outline[i] = c.residual;
    }
    /* Columns run from left to right on the ends, and y is positive to the left. */
    double mid = (lo + hi) / 2 * d->grid->h;
    s->profile_width = (hi - lo) * d->grid->h;
    s->profile_middle =
        cr_face_is_end(s->face) ? d->grid->y0 + n * d->grid->h - mid : d->grid->x0 + mid;
}

/* ---- CDC ---- */

static double or_else(double x, double fallback) {
    return isfinite(x) && x > 0 ? x : fallback;
}

/* A sideswipe changes the body's velocity by little of the closing speed and leaves most of it. */
static bool is_sideswipe(const struct damage *m) {
    const struct cr_event *e = m->event;
    int other = e->body[!m->side];
    struct cr_vec2 before = cr_vec2_sub(cr_event_before(m->r->solution, e, m->body)->vel,
                                        cr_event_before(m->r->solution, e, other)->vel);
    struct cr_vec2 change = cr_vec2_sub(e->of[m->side].delta_v, e->of[!m->side].delta_v);
    double speed = cr_vec2_len(before), after = cr_vec2_len(cr_vec2_add(before, change));
    return after > speed / 2 && cr_vec2_len(e->of[m->side].delta_v) < speed / 4;
}

/* Column 5 of J224, the heights that were struck: of an object they follow from its lower and upper
 * edge; vehicles meet each other below the belt line. */
static char vertical(const struct damage *m, enum cr_face face) {
    const struct cr_participant *p = &m->r->resolved.part[m->body];
    const struct cr_participant *q = &m->r->resolved.part[m->event->body[!m->side]];
    if (q->kind != CR_KIND_OBJECT) {
        return 'E';
    }
    if (q->z_lo >= belt * p->height) {
        return 'G';
    }
    if (q->z_lo >= frame * p->height) {
        return q->z_hi > belt * p->height ? 'H' : 'M';
    }
    if (q->z_hi <= frame * p->height) {
        return 'L';
    }
    /* J224 counts a tall object at a flank as a hit up to the roof, at an end below the belt
     * line. */
    return !cr_face_is_end(face) && q->z_hi > roof * p->height ? 'A' : 'E';
}

static void classify(const struct damage *m, const struct face_damage *f, struct cr_severity *s) {
    const struct cr_grid *g = m->deform.grid;
    const struct cr_participant *p = &m->r->resolved.part[m->body];
    int n = cr_face_lines(g, s->face);
    double length = or_else(p->length, g->nx * g->h), width = or_else(p->width, g->ny * g->h);
    double pillar = or_else(p->front_overhang + b_pillar * p->wheelbase, length / 2);
    struct cr_cdc_case what = {
        .pdof = s->pdof,
        .face = s->face,
        .lo = (double)f->direct_lo / n,
        .hi = (double)(f->direct_hi + 1) / n,
        .width = s->contact_width,
        .depth = s->face_depth,
        .zone = s->face == CR_FACE_FRONT  ? pillar
                : s->face == CR_FACE_REAR ? length - pillar
                                          : width,
        .vertical = vertical(m, s->face),
        .sideswipe = is_sideswipe(m),
    };
    cr_cdc_write(&what, s->cdc);
}

/* ---- the whole ---- */

/* The material that is left after this impact: it and earlier impacts of the same face have taken
 * theirs, the damage of later ones and of other faces is undone. */
static enum cr_err take_left(struct damage *m, enum cr_face face, const struct cr_impact *before,
                             struct cr_error *err) {
    const struct cr_grid *g = m->deform.grid;
    const double *left = m->r->solution->body[m->body].left;
    int own = (int)(m->event - m->all->event), n = g->nx * g->ny;
    m->left = malloc((size_t)n * sizeof *m->left);
    if (m->left == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the damage of a result");
    }
    for (int i = 0; i < n; i++) {
        int by = m->of[i], side;
        bool earlier = by >= 0 && by < own && same_body(&m->all->event[by], m->body, &side) &&
                       before[by].of[side].face == face;
        m->left[i] = by == own || earlier ? left[i] : g->fill[i];
    }
    m->deform.left = m->left;
    return CR_ERR_OK;
}

static void measure_area(const struct damage *m, const struct face_damage *f,
                         struct cr_severity *s) {
    const struct cr_grid *g = m->deform.grid;
    int own = (int)(m->event - m->all->event);
    double area = 0;
    for (int i = 0; i < g->nx * g->ny; i++) {
        double lost = m->of == NULL || m->of[i] == own ? g->fill[i] - m->deform.left[i] : 0;
        bool induced = m->deform.how != NULL && !(m->deform.how[i] & CR_CRUSH_CONTACT);
        area += lost;
        s->area_induced += induced ? lost : 0;
    }
    area *= g->h * g->h;
    s->area_induced *= g->h * g->h;
    s->area_contact = area - s->area_induced;
    /* The area springs back by the same share as the columns of the struck face. */
    double lost = m->deform.residual_curve ? f->residual_sum : f->dynamic_sum;
    s->deformation_area = lost > 0 ? area * f->residual_sum / lost : 0;
}

struct cr_deform cr_damage_of(const struct cr_result *r, int body) {
    const struct cr_outcome *o = &r->solution->body[body];
    int residual = r->resolved.set.residual_curve;
    bool paper = r->resolved.set.method == CR_METHOD_PAPER;
    return (struct cr_deform){.grid = cr_result_grid(r, body),
                              .left = o->left,
                              .how = o->how,
                              .residual_curve = residual < 0 ? paper : residual > 0};
}

enum cr_err cr_damage_measure(const struct cr_damage_case *what, struct cr_severity *s,
                              struct cr_error *err) {
    const struct cr_event *e = &what->all->event[what->event];
    struct damage m = {.r = what->result,
                       .all = what->all,
                       .event = e,
                       .side = what->side,
                       .body = e->body[what->side],
                       .of = what->owner};
    struct cr_vec2 inward = cr_vec2_unit(s->delta_v_body, cr_vec2(-1, 0));
    m.deform = cr_damage_of(what->result, m.body);
    m.deform.through = first_way(e, m.side).x != 0 || first_way(e, m.side).y != 0;
    enum cr_err code = CR_ERR_OK;
    if (m.of != NULL) {
        code = take_left(&m, began_at(&m, inward), what->result->impact, err);
    }
    if (code == CR_ERR_OK) {
        s->face = began_at(&m, inward);
        code = second_face(&m, s, err);
    }
    if (code == CR_ERR_OK) {
        struct face_damage f = choose_face(&m, s, inward);
        struct cr_depth deep = both(&m.deform, s->face, f.depth);
        struct cr_depth most = both(&m.deform, s->face, cr_deform_max(&m.deform, inward));
        s->face_depth = deep.residual;
        s->face_depth_dynamic = deep.dynamic;
        s->deformation_max = most.residual;
        s->deformation_dynamic_max = most.dynamic;
        s->damage_width = width_of(&m.deform, f.lo, f.hi);
        s->contact_width = width_of(&m.deform, f.direct_lo, f.direct_hi);
        measure_area(&m, &f, s);
        crush_profile(&m.deform, &f, s);
        classify(&m, &f, s);
    }
    free(m.left);
    return code;
}
