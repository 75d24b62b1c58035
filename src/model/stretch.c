/* The reference grid: a model is stretched piecewise between the lines that every car has (ends,
 * axles, pillars, wheel planes, roof), onto those of the vehicle (paper, "reference grid"). */
#include "config.h"

#include "model/model_priv.h"

#include "base/vec.h"

static double piecewise(const double *from, const double *to, int n, double x) {
    int i = 0;
    while (i + 2 < n && x >= from[i + 1]) {
        i++;
    }
    double t = (x - from[i]) / (from[i + 1] - from[i]);
    return t == 1 ? to[i + 1] : to[i] + t * (to[i + 1] - to[i]);
}

double cr_model_map_ref(const struct cr_model_map *m, double own) {
    return piecewise(m->own, m->ref, m->n, own);
}

double cr_model_map_own(const struct cr_model_map *m, double ref) {
    return piecewise(m->ref, m->own, m->n, ref);
}

static enum cr_err check_order(const struct cr_model_map *m, const char *const *name,
                               struct cr_error *err) {
    for (int i = 1; i < m->n; i++) {
        if (!(m->own[i] - m->own[i - 1] > 1e-3)) {
            enum cr_err code = cr_err_set(err, CR_ERR_RANGE,
                                          "reference lines out of order: %s at %.3f m must lie "
                                          "beyond %s at %.3f m",
                                          name[i], m->own[i], name[i - 1], m->own[i - 1]);
            cr_err_hint(err, "check length, width, wheelbase, track and front overhang");
            return code;
        }
    }
    return CR_ERR_OK;
}

/* Sets the lines in x: the pillars keep their share of the wheelbase. */
static void lines_x(const struct cr_model_recipe *r, const struct cr_dims *d,
                    struct cr_model_map *m) {
    const struct cr_dims *ref = &r->dims;
    double rear = ref->front_overhang + ref->wheelbase;
    const double ref_x[] = {0, ref->front_overhang, r->a_pillar, r->b_pillar, rear, ref->length};
    m->n = 6;
    for (int i = 0; i < m->n; i++) {
        m->ref[i] = ref_x[i];
    }
    m->own[0] = 0;
    m->own[1] = d->front_overhang;
    for (int i = 2; i < 4; i++) {
        double share = (ref_x[i] - ref->front_overhang) / ref->wheelbase;
        m->own[i] = d->front_overhang + share * d->wheelbase;
    }
    m->own[4] = d->front_overhang + d->wheelbase;
    m->own[5] = d->length;
}

enum cr_err cr_model_stretch_make(const struct cr_model_recipe *r, const struct cr_dims *d,
                                  struct cr_model_stretch *out, struct cr_error *err) {
    static const char *const name_x[] = {"front end", "front axle", "A-pillar",
                                         "B-pillar",  "rear axle",  "rear end"};
    static const char *const name_y[] = {"centre line", "wheel plane", "flank"};
    static const char *const name_z[] = {"road", "bumper line", "roof"};
    lines_x(r, d, &out->x);
    out->y = (struct cr_model_map){
        3, {0, d->track / 2, d->width / 2}, {0, r->dims.track / 2, r->dims.width / 2}};
    /* Bumpers and rails lie at much the same height in all cars of a type. */
    out->z =
        (struct cr_model_map){3, {0, r->keep_below, d->height}, {0, r->keep_below, r->dims.height}};
    enum cr_err code = check_order(&out->x, name_x, err);
    if (code == CR_ERR_OK) {
        code = check_order(&out->y, name_y, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    return check_order(&out->z, name_z, err);
}

enum cr_err cr_model_query_check(const struct cr_model_query *q, struct cr_error *err) {
    const struct {
        const char *name, *unit;
        double v, lo, hi;
    } check[] = {
        {"mass", "kg", q->mass_kg, 50, 100000},
        {"voxel edge", "m", q->voxel, 0.005, 0.1},
        {"length", "m", q->dims.length, 1, 30},
        {"width", "m", q->dims.width, 0.5, 5},
        {"height", "m", q->dims.height, 0.5, 5},
        {"wheelbase", "m", q->dims.wheelbase, 0.5, 25},
        {"track", "m", q->dims.track, 0.3, 4.9},
        {"front overhang", "m", q->dims.front_overhang, 0.05, 5},
        {"distance of the CG behind the front axle", "m", q->dims.cg_behind_front_axle, -5, 25},
    };
    for (size_t i = 0; i < sizeof check / sizeof check[0]; i++) {
        if (!(check[i].v >= check[i].lo && check[i].v <= check[i].hi)) {
            enum cr_err code = cr_err_set(err, CR_ERR_RANGE, "%s %g %s cannot be", check[i].name,
                                          check[i].v, check[i].unit);
            cr_err_hint(err, "%g to %g %s", check[i].lo, check[i].hi, check[i].unit);
            return code;
        }
    }
    if (!isfinite(q->pdof) || isnan(q->z_lo) || isnan(q->z_hi)) {
        return cr_err_set(err, CR_ERR_RANGE, "PDOF or height range is not a number");
    }
    return CR_ERR_OK;
}
