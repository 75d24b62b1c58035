/* Step 2 of the paper: the force vector from the voxels that were deformed. */
#include "solver/solver_priv.h"

/* Least cosine between normal and relative velocity: a face that slides along exactly has no
 * approach, and E / s would have no limit (method.md 9). Small, because it tilts the force of a
 * sideswipe backwards: at 0.15 that tripled its crush energy. */
static const double cosine_min = 0.02;

/* Spread (standard deviation) of the patch over which its axis takes over from the relative
 * velocity, m, and no less than so many voxels of the default size. */
static const double patch_from = 0.025, patch_to = 0.1, patch_voxel = 0.025;
/* spread (standard deviation) from which a patch knows its own direction better than the slices
 * before it did, m: a flank rubbed along its length, as against a front corner */
static const double patch_sure = 0.25;

/* Time over which the COE is averaged, s, and that in which the normal between two deforming bodies
 * follows the surface between them. */
const double cr_force_memory = 8e-3;
static const double normal_memory = 0.128;

static double smoothstep(double x) {
    x = cr_clamp(x, 0, 1);
    return x * x * (3 - 2 * x);
}

/* Eq. (1) and Eq. (3), the string's pull weighing where it is held */
static double energy_and_coe(const struct cr_solver *s, int a, int b, struct cr_vec2 *coe) {
    struct cr_vec2 sum = {0, 0};
    double energy = 0, weight = 0;
    for (int side = 0; side < 2; side++) {
        const struct cr_losses *losses = &s->losses[side];
        const struct cr_moving *m = &s->m[side == 0 ? a : b];
        if (losses->weight > 0) {
            double per = 1 / losses->weight;
            struct cr_vec2 at = cr_to_world(m, cr_vec2_scale(losses->loaded, per));
            sum = cr_vec2_axpy(sum, losses->weight, at);
            weight += losses->weight;
        }
        energy += losses->energy;
    }
    *coe = weight > 0 ? cr_vec2_scale(sum, 1 / weight) : sum;
    return energy;
}

/* adds the moments of one body's losses about a world point */
static void add_moments(struct cr_moments *mo, const struct cr_moving *m,
                        const struct cr_losses *losses, struct cr_vec2 about) {
    double w = losses->energy, c = m->c, s = m->s;
    if (!(w > 0)) {
        return;
    }
    struct cr_vec2 mean = cr_vec2_scale(losses->first, 1 / w);
    double xx = losses->xx - w * mean.x * mean.x, yy = losses->yy - w * mean.y * mean.y;
    double xy = losses->xy - w * mean.x * mean.y;
    struct cr_vec2 d = cr_vec2_sub(cr_to_world(m, mean), about);
    mo->xx += c * c * xx - 2 * c * s * xy + s * s * yy + w * d.x * d.x;
    mo->yy += s * s * xx + 2 * c * s * xy + c * c * yy + w * d.y * d.y;
    mo->xy += c * s * (xx - yy) + (c * c - s * s) * xy + w * d.x * d.y;
    mo->weight += w;
}

/* The patch of the last slices: which voxels give way in one is chance, and in a short one they are
 * few. */
static struct cr_moments patch_of(const struct cr_solver *s, int pair, int a, int b,
                                  struct cr_vec2 coe) {
    struct cr_moments mo = {0};
    const struct cr_touch *t = &s->touch[pair];
    if (t->record >= 0) {
        double keep = exp(-s->dt / cr_yield_memory);
        mo = (struct cr_moments){keep * t->patch.xx, keep * t->patch.xy, keep * t->patch.yy,
                                 keep * t->patch.weight};
    }
    add_moments(&mo, &s->m[a], &s->losses[0], coe);
    add_moments(&mo, &s->m[b], &s->losses[1], coe);
    return mo;
}

/* How far the patch has an axis, 0..1, and the axis' normal on the side of `outward`. */
static double axis_of_patch(const struct cr_moments *mo, double h, struct cr_vec2 outward,
                            struct cr_vec2 *normal, double *trust) {
    double per = mo->weight > 0 ? 0.5 / mo->weight : 0, xy = 2 * per * mo->xy;
    double mean = per * (mo->xx + mo->yy), diff = per * (mo->xx - mo->yy);
    double root = sqrt(diff * diff + xy * xy);
    double major = sqrt(fmax(mean + root, 0)), minor = sqrt(fmax(mean - root, 0));
    double axis = 0.5 * atan2(xy, diff); /* of the major axis */
    *trust = major * major / (patch_sure * patch_sure);
    struct cr_vec2 n = {-sin(axis), cos(axis)};
    *normal = cr_vec2_dot(n, outward) < 0 ? cr_vec2_scale(n, -1) : n;
    double scale = fmax(h / patch_voxel, 1);
    double size = smoothstep((major / scale - patch_from) / (patch_to - patch_from));
    double shape = major > 0 ? smoothstep((1 - minor / major) / 0.5) : 0;
    return size * shape;
}

static struct cr_vec2 mix(struct cr_vec2 a, double w, struct cr_vec2 b) {
    return cr_vec2_unit(cr_vec2(w * a.x + (1 - w) * b.x, w * a.y + (1 - w) * b.y), b);
}

/* Normal to the line through the deformed voxels (their minor principal axis), faded to the
 * direction v of relative velocity while the patch is too small or too round to have an axis.
 * False where the bodies are leaving each other. */
static bool normal_of_patch(const struct cr_solver *s, int a, int b, struct cr_vec2 v,
                            struct cr_force *force) {
    struct cr_vec2 *normal = &force->normal;
    const struct cr_moving *ma = &s->m[a], *mb = &s->m[b];
    struct cr_vec2 coe = force->coe;
    struct cr_vec2 none = {0, 0};
    struct cr_vec2 out = cr_vec2_sub(cr_vec2_unit(cr_vec2_sub(coe, ma->pos), none),
                                     cr_vec2_unit(cr_vec2_sub(coe, mb->pos), none));
    out = cr_vec2_unit(out, v);
    double w = axis_of_patch(&force->patch, ma->body->grid.h, out, normal, &force->trust);
    if (cr_vec2_dot(mix(*normal, w, out), v) <= 0) {
        return false;
    }
    *normal = mix(*normal, w, v);
    return true;
}

/* Friction by kind of body. Sheet metal and bars that crush each other interlock (0.55 in SMAC,
 * literature.md 2.4); on a smooth rigid surface sheet metal slides at crash speeds. That value is
 * the one at which the fleet is led past the edge of a rigid barrier as in 398 tests with 25 %
 * overlap (validation.md). */
static const double hooking = 0.5, smooth = 0.1;

static double friction_of(const struct cr_solver *s, int i) {
    const struct cr_body *b = &s->cs->body[i];
    double by_kind = b->grid.nx == 0 ? smooth : hooking;
    return b->friction >= 0            ? b->friction
           : s->cs->opts.friction_auto ? by_kind
                                       : s->cs->opts.friction;
}

double cr_force_friction(const struct cr_solver *s, int a, int b) {
    return fmin(friction_of(s, a), friction_of(s, b)); /* the smoother one decides */
}

double cr_force_approach(const struct cr_solver *s, int a, int b, const struct cr_force *force) {
    return cr_vec2_dot(cr_relative_velocity(s, a, b, force->coe), force->normal);
}

/* tilt n towards the unit vector v until their cosine is cosine_min */
static struct cr_vec2 tilt(struct cr_vec2 n, struct cr_vec2 v) {
    double dot = cr_vec2_dot(n, v);
    if (dot >= cosine_min) {
        return n;
    }
    struct cr_vec2 t = cr_vec2_unit(cr_vec2_axpy(n, -dot, v), cr_vec2_perp(v));
    return cr_vec2_add(cr_vec2_scale(v, cosine_min),
                       cr_vec2_scale(t, sqrt(1 - cosine_min * cosine_min)));
}

/* direction of the force within the Coulomb cone about n: along v inside it (sticking) */
static void within_cone(struct cr_force *f, struct cr_vec2 v, double mu) {
    struct cr_vec2 n = f->normal;
    double vn = cr_vec2_dot(v, n);
    struct cr_vec2 vt = cr_vec2_axpy(v, -vn, n);
    double t = cr_vec2_len(vt);
    f->sliding = t > mu * vn;
    if (!f->sliding) {
        f->direction = v;
    } else {
        struct cr_vec2 d = t > 0 ? cr_vec2_axpy(n, mu / t, vt) : n;
        f->direction = cr_vec2_unit(d, n);
    }
    f->cosine = cr_vec2_dot(f->direction, n);
}

/* Mean of the COE of the last slices, weighted by energy and carried along with the bodies: which
 * voxels give way in a slice is chance of where the grid lies, and would toss the moment about. */
static struct cr_vec2 steady_coe(const struct cr_solver *s, int pair, double energy,
                                 struct cr_vec2 coe) {
    const struct cr_touch *t = &s->touch[pair];
    double recent = t->record >= 0 ? t->energy_recent * exp(-s->dt / cr_force_memory) : 0;
    double share = energy > 0 ? energy / (energy + recent) : 0;
    return cr_vec2_add(cr_vec2_scale(coe, share), cr_vec2_scale(t->coe, 1 - share));
}

void cr_force_update(struct cr_solver *s, int pair, int a, int b, struct cr_force *force) {
    struct cr_force whole = *force;
    whole.energy = energy_and_coe(s, a, b, &whole.coe);
    whole.coe = steady_coe(s, pair, whole.energy, whole.coe);
    struct cr_vec2 v = cr_vec2_unit(cr_relative_velocity(s, a, b, whole.coe), cr_vec2(0, 0));
    if (cr_vec2_dot(v, force->normal) < cosine_min) {
        force->energy = whole.energy; /* far out the bodies part: the force stays in the contact */
        return;
    }
    within_cone(&whole, v, cr_force_friction(s, a, b));
    *force = whole;
}

/* The normal so far, drawn towards that of this slice: structures that have hooked into each other
 * do not glide off along every surface that the crush leaves behind. */
static struct cr_vec2 steady(const struct cr_solver *s, int pair, const struct cr_force *force,
                             struct cr_vec2 v) {
    const struct cr_touch *t = &s->touch[pair];
    if (t->record < 0) {
        return t->spent > 0 ? force->normal : mix(force->normal, fmin(1, force->trust), v);
    }
    double share = fmax(1, force->trust) * s->dt / normal_memory;
    return cr_vec2_unit(cr_vec2_axpy(t->normal, share, force->normal), force->normal);
}

/* What the parts of a rigid surface are pressed with together in the last slices, on b; nothing
 * where the bodies leave each other. */
static struct cr_vec2 thrust_on_surface(const struct cr_solver *s, int pair, int a, int b) {
    const struct cr_touch *t = &s->touch[pair];
    bool on_b = s->m[b].body->grid.nx == 0;
    const struct cr_moving *rigid = &s->m[on_b ? b : a];
    struct cr_vec2 now = cr_vec2_rotate(s->losses[on_b ? 0 : 1].normal, rigid->c, rigid->s);
    double keep = t->record >= 0 ? exp(-s->dt / cr_yield_memory) : 0;
    return cr_vec2_axpy(cr_vec2_scale(now, on_b ? -1 : 1), keep, t->thrust);
}

bool cr_force_find(struct cr_solver *s, int pair, int a, int b, struct cr_force *force) {
    *force = (struct cr_force){0};
    force->energy = energy_and_coe(s, a, b, &force->coe);
    if (!(force->energy > 0)) {
        return false;
    }
    force->coe = steady_coe(s, pair, force->energy, force->coe);
    const struct cr_moving *ma = &s->m[a], *mb = &s->m[b];
    struct cr_vec2 rel = cr_relative_velocity(s, a, b, force->coe);
    struct cr_vec2 v = cr_vec2_unit(rel, cr_vec2(0, 0));
    if (v.x == 0 && v.y == 0) {
        return false;
    }
    if (ma->body->grid.nx == 0 || mb->body->grid.nx == 0) {
        force->thrust = thrust_on_surface(s, pair, a, b);
        force->normal = cr_vec2_unit(force->thrust, cr_vec2(0, 0));
    } else {
        force->patch = patch_of(s, pair, a, b, force->coe);
        if (!normal_of_patch(s, a, b, v, force)) {
            return false;
        }
    }
    if (cr_vec2_dot(force->normal, v) <= 0) {
        return false; /* leaving */
    }
    if (ma->body->grid.nx > 0 && mb->body->grid.nx > 0) {
        force->normal = tilt(steady(s, pair, force, v), v);
    }
    within_cone(force, v, cr_force_friction(s, a, b));
    return true;
}
