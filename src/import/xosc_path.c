/* Makes points of the trajectories of OpenSCENARIO: polylines, clothoids and rows of clothoids. */
#include "import/xosc_priv.h"

#include "base/grow.h"

#include <math.h>
#include <string.h>

enum { POINTS_MAX = 200000 };
/* The distance in m between points of a curve: at a radius of 5 m a chord is 0.6 mm off. */
static const double chord = 0.15;
static const double longest = 20000; /* m that a curve may be long */

static enum cr_err push(struct cr_xosc_action *a, const struct cr_xosc_point *p,
                        struct cr_error *err) {
    if (a->n == POINTS_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "a trajectory of more than %d points", POINTS_MAX);
    }
    if (!cr_grow(&a->point, &a->size, a->n, sizeof *a->point)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a trajectory");
    }
    a->point[a->n++] = *p;
    return CR_ERR_OK;
}

/* ---- polyline ---- */

/* Has vertices for which no heading is given look along the line. */
static void look_along(struct cr_xosc_action *a, const bool *given) {
    for (int i = 0; i < a->n; i++) {
        struct cr_xosc_point *p = &a->point[i];
        int k = i + 1 < a->n ? i : i - 1;
        struct cr_vec2 d = cr_vec2_sub(a->point[k + 1].pos, a->point[k].pos);
        if (i > 0) {
            p->s = p[-1].s + cr_vec2_len(cr_vec2_sub(p->pos, p[-1].pos));
        }
        if (!given[i] && cr_vec2_len(d) > 0) {
            p->heading = atan2(d.y, d.x);
        } else if (!given[i] && i > 0) {
            p->heading = p[-1].heading;
        }
    }
}

static enum cr_err polyline(struct cr_xosc *x, const struct cr_xml_node *line,
                            struct cr_xosc_action *a, struct cr_error *err) {
    const struct cr_xml_node *v = NULL;
    enum cr_err code = CR_ERR_OK;
    while (code == CR_ERR_OK && (v = cr_xml_next(line, v, "Vertex")) != NULL) {
        struct cr_xosc_point p = {.t = NAN};
        code = cr_xosc_position(x, v, &p.pos, &p.heading, err);
        if (code == CR_ERR_OK && cr_xml_attr(v, "time") != NULL) {
            code = cr_xosc_number(x, v, "time", NAN, &p.t, err);
        }
        if (code == CR_ERR_OK && a->n > 0 && p.t <= a->point[a->n - 1].t) {
            code = cr_xml_fault(x->shown, v, err, CR_ERR_RANGE,
                                "time must rise from vertex to vertex, got %g s", p.t);
        }
        if (code == CR_ERR_OK && a->n > 0 && isnan(p.t) != isnan(a->point[0].t)) {
            code = cr_xml_fault(x->shown, v, err, CR_ERR_MISSING, "time at some vertices only");
        }
        code = code == CR_ERR_OK ? push(a, &p, err) : code;
    }
    if (code == CR_ERR_OK && a->n < 2) {
        code = cr_xml_fault(x->shown, line, err, CR_ERR_MISSING, "fewer than two <Vertex>");
    }
    bool *given = code == CR_ERR_OK ? cr_arena_take(&x->arena, (size_t)a->n, sizeof *given) : NULL;
    if (code != CR_ERR_OK || given == NULL) {
        return code != CR_ERR_OK ? code : cr_err_set(err, CR_ERR_MEMORY, "no memory for a path");
    }
    for (int i = 0; i < a->n; i++) {
        given[i] = !isnan(a->point[i].heading);
        a->point[i].heading = given[i] ? a->point[i].heading : 0;
    }
    look_along(a, given);
    return CR_ERR_OK;
}

/* ---- clothoids ---- */

struct clothoid {
    double k, dk, length; /* curvature at its start, 1/m; its change per m, 1/m2; m */
    double t0, t1;        /* s of its ends, NaN without times */
};

/* Adds the points of a clothoid from the last point on. Each chord is integrated by Gauss's rule
 * with two points, whose error is far below a micrometre. */
static enum cr_err clothoid(struct cr_xosc_action *a, const struct clothoid *c,
                            struct cr_error *err) {
    static const double node[2] = {0.21132486540518712, 0.78867513459481288};
    int n = (int)ceil(c->length / chord);
    double h = c->length / n;
    const struct cr_xosc_point from = a->point[a->n - 1];
    struct cr_xosc_point p = from;
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        for (int j = 0; j < 2; j++) {
            double s = h * (i + node[j]);
            double angle = from.heading + s * (c->k + c->dk * s / 2);
            p.pos = cr_vec2_axpy(p.pos, h / 2, cr_vec2(cos(angle), sin(angle)));
        }
        double s = h * (i + 1);
        p.s = from.s + s;
        p.heading = from.heading + s * (c->k + c->dk * s / 2);
        p.t = c->t0 + (c->t1 - c->t0) * (i + 1) / n; /* The speed is constant. */
        code = push(a, &p, err);
    }
    return code;
}

static enum cr_err check_length(struct cr_xosc *x, const struct cr_xml_node *node, double length,
                                struct cr_error *err) {
    return length > 0 && length <= longest
               ? CR_ERR_OK
               : cr_xml_fault(x->shown, node, err, CR_ERR_RANGE,
                              "length must be above 0 and at most %g m, got %g m", longest, length);
}

/* Reads an attribute that may be missing, which gives NaN. */
static enum cr_err optional(struct cr_xosc *x, const struct cr_xml_node *node, const char *name,
                            double *out, struct cr_error *err) {
    *out = NAN;
    return cr_xml_attr(node, name) != NULL ? cr_xosc_number(x, node, name, NAN, out, err)
                                           : CR_ERR_OK;
}

static enum cr_err one_clothoid(struct cr_xosc *x, const struct cr_xml_node *node,
                                struct cr_xosc_action *a, struct cr_error *err) {
    struct cr_xosc_point p = {.t = NAN};
    struct clothoid c;
    /* Version 1.0 calls it curvatureDot. */
    const char *prime =
        cr_xml_attr(node, "curvaturePrime") != NULL ? "curvaturePrime" : "curvatureDot";
    enum cr_err code = cr_xosc_position(x, node, &p.pos, &p.heading, err);
    code = code == CR_ERR_OK ? cr_xosc_number(x, node, "curvature", NAN, &c.k, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_number(x, node, prime, NAN, &c.dk, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_number(x, node, "length", NAN, &c.length, err) : code;
    code = code == CR_ERR_OK ? optional(x, node, "startTime", &c.t0, err) : code;
    code = code == CR_ERR_OK ? optional(x, node, "stopTime", &c.t1, err) : code;
    code = code == CR_ERR_OK ? check_length(x, node, c.length, err) : code;
    if (code == CR_ERR_OK && (isnan(c.t0) != isnan(c.t1) || c.t1 <= c.t0)) {
        code = cr_xml_fault(x->shown, node, err, CR_ERR_RANGE,
                            "stopTime must come after startTime, or both be missing");
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    p.heading = isnan(p.heading) ? 0 : p.heading;
    p.t = c.t0;
    code = push(a, &p, err);
    return code == CR_ERR_OK ? clothoid(a, &c, err) : code;
}

static enum cr_err spline_start(struct cr_xosc *x, const struct cr_xml_node *segment,
                                struct cr_xosc_action *a, struct cr_error *err) {
    const struct cr_xml_node *start = cr_xml_find(segment, "PositionStart");
    struct cr_xosc_point p = {.t = NAN};
    if (start == NULL && a->n > 0) {
        return CR_ERR_OK;
    }
    if (start == NULL) {
        return cr_xml_fault(x->shown, segment, err, CR_ERR_MISSING, "no <PositionStart>");
    }
    if (a->n > 0) {
        return cr_xosc_refuse(x, start, err, "a row of clothoids that is not joined");
    }
    /* PositionStart is a Position itself, so cr_xosc_position would look for one in it in vain. */
    const struct cr_xml_node *at = start->child;
    if (at == NULL || strcmp(at->name, "WorldPosition") != 0) {
        return cr_xosc_refuse(x, start, err, "only a WorldPosition can be read without the road");
    }
    enum cr_err code = cr_xosc_number(x, at, "x", NAN, &p.pos.x, err);
    code = code == CR_ERR_OK ? cr_xosc_number(x, at, "y", NAN, &p.pos.y, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_number(x, at, "h", 0, &p.heading, err) : code;
    code = code == CR_ERR_OK ? optional(x, segment, "timeStart", &p.t, err) : code;
    return code == CR_ERR_OK ? push(a, &p, err) : code;
}

/* Reads a spline of version 1.3: segments whose curvature goes from one value to another; the times
 * of a segment end where those of the next begin. */
static enum cr_err spline(struct cr_xosc *x, const struct cr_xml_node *node,
                          struct cr_xosc_action *a, struct cr_error *err) {
    const struct cr_xml_node *seg = cr_xml_next(node, NULL, "ClothoidSplineSegment");
    enum cr_err code = CR_ERR_OK;
    if (seg == NULL) {
        return cr_xml_fault(x->shown, node, err, CR_ERR_MISSING, "no <ClothoidSplineSegment>");
    }
    while (seg != NULL && code == CR_ERR_OK) {
        const struct cr_xml_node *next = cr_xml_next(node, seg, "ClothoidSplineSegment");
        struct clothoid c = {0};
        double k1 = 0, turn = 0;
        code = spline_start(x, seg, a, err);
        code = code == CR_ERR_OK ? cr_xosc_number(x, seg, "curvatureStart", NAN, &c.k, err) : code;
        code = code == CR_ERR_OK ? cr_xosc_number(x, seg, "curvatureEnd", NAN, &k1, err) : code;
        code = code == CR_ERR_OK ? cr_xosc_number(x, seg, "length", NAN, &c.length, err) : code;
        code = code == CR_ERR_OK ? cr_xosc_number(x, seg, "hOffset", 0, &turn, err) : code;
        code = code == CR_ERR_OK ? check_length(x, seg, c.length, err) : code;
        code = code == CR_ERR_OK ? optional(x, next != NULL ? next : node,
                                            next != NULL ? "timeStart" : "timeEnd", &c.t1, err)
                                 : code;
        if (code == CR_ERR_OK) {
            c.dk = (k1 - c.k) / c.length;
            c.t0 = a->point[a->n - 1].t;
            a->point[a->n - 1].heading += turn;
            code = isnan(c.t0) != isnan(c.t1) || c.t1 <= c.t0
                       ? cr_xml_fault(x->shown, seg, err, CR_ERR_RANGE,
                                      "times must rise, and be at all segments or none")
                       : clothoid(a, &c, err);
        }
        seg = next;
    }
    return code;
}

/* ---- the trajectory ---- */

/* Sets the times of a path. They count from where the scenario or the action begins, and may be
 * scaled. */
static enum cr_err set_times(struct cr_xosc *x, const struct cr_xml_node *follow,
                             struct cr_xosc_action *a, struct cr_error *err) {
    const struct cr_xml_node *timing = cr_xml_find(follow, "TimeReference/Timing");
    const char *domain;
    double offset = 0, scale = 1;
    if (timing == NULL || isnan(a->point[0].t)) {
        return CR_ERR_OK; /* The path is driven at the speed that the entity has. */
    }
    enum cr_err code = cr_xosc_text(x, timing, "domainAbsoluteRelative", NULL, &domain, err);
    code = code == CR_ERR_OK ? cr_xosc_number(x, timing, "offset", 0, &offset, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_number(x, timing, "scale", 1, &scale, err) : code;
    if (code == CR_ERR_OK && !(scale > 0)) {
        code = cr_xml_fault(x->shown, timing, err, CR_ERR_RANGE, "scale must be above 0");
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    offset += strcmp(domain, "relative") == 0 ? a->t : 0;
    for (int i = 0; i < a->n; i++) {
        a->point[i].t = a->point[i].t * scale + offset;
    }
    a->timed = true;
    return CR_ERR_OK;
}

/* Finds the trajectory of an action: version 1.0 has it in the action, later ones in a
 * TrajectoryRef; either may refer to a catalogue. */
static enum cr_err find_trajectory(struct cr_xosc *x, const struct cr_xml_node *follow,
                                   const struct cr_xml_node **out, struct cr_error *err) {
    const struct cr_xml_node *ref = cr_xml_find(follow, "TrajectoryRef");
    ref = ref != NULL ? ref : follow;
    *out = cr_xml_find(ref, "Trajectory");
    const struct cr_xml_node *entry = cr_xml_find(ref, "CatalogReference");
    if (*out == NULL && entry != NULL) {
        return cr_xosc_entry(x, entry, out, err);
    }
    return *out != NULL ? cr_xosc_enter(x, *out, err)
                        : cr_xml_fault(x->shown, ref, err, CR_ERR_MISSING, "no <Trajectory>");
}

enum cr_err cr_xosc_path(struct cr_xosc *x, const struct cr_xml_node *follow,
                         struct cr_xosc_action *out, struct cr_error *err) {
    static const struct {
        const char *name;
        enum cr_err (*read)(struct cr_xosc *x, const struct cr_xml_node *node,
                            struct cr_xosc_action *a, struct cr_error *err);
    } shapes[] = {{"Polyline", polyline}, {"Clothoid", one_clothoid}, {"ClothoidSpline", spline}};
    const struct cr_xml_node *trajectory;
    const char *shown = x->shown;
    int scope = x->scope.n, i = 0;
    out->path = true;
    enum cr_err code = find_trajectory(x, follow, &trajectory, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_xml_node *shape = cr_xml_find(trajectory, "Shape");
    const struct cr_xml_node *form = shape != NULL ? shape->child : NULL;
    while (form != NULL && i < 3 && strcmp(form->name, shapes[i].name) != 0) {
        i++;
    }
    if (form == NULL) {
        code = cr_xml_fault(x->shown, trajectory, err, CR_ERR_MISSING, "no <Shape> with a form");
    } else if (i == 3) {
        code = cr_xosc_refuse(x, form, err, "this form of a trajectory is not read");
    } else {
        code = shapes[i].read(x, form, out, err);
    }
    x->shown = shown;
    code = code == CR_ERR_OK ? set_times(x, follow, out, err) : code;
    cr_xosc_leave(x, scope);
    return code;
}
