/* Step 2 of the paper: the force vector from the voxels that were deformed. */
#include "solver/solver_priv.h"

/* Least cosine between normal and relative velocity: a face that slides along exactly has no
 * approach, and E / s would have no limit (method.md 9). Small, because it tilts the force of a
 * sideswipe backwards: at 0.15 that tripled its crush energy. */
static const double cosine_min = 0.02;

/* Time over which the COE is averaged, s, and that over which the normal is: which voxels give way
 * in a slice is chance. */
const double cr_force_memory = 8e-3;
static const double thrust_memory = 2e-3;

/* Eq. (1) and Eq. (3); what is dragged along is paid for in the contact */
static double energy_and_coe(const struct cr_solver *s, int a, int b, struct cr_vec2 *coe) {
    struct cr_vec2 sum = {0, 0};
    double energy = 0, weight = 0;
    for (int side = 0; side < 2; side++) {
        const struct cr_losses *losses = &s->losses[side];
        const struct cr_moving *m = &s->m[side == 0 ? a : b];
        double held = losses->energy - losses->induced;
        if (held > 0) {
            struct cr_vec2 at = cr_to_world(m, cr_vec2_scale(losses->first, 1 / held));
            sum = cr_vec2_axpy(sum, losses->energy, at);
            weight += losses->energy;
        }
        energy += losses->energy;
    }
    *coe = weight > 0 ? cr_vec2_scale(sum, 1 / weight) : sum;
    return energy;
}

/* Friction by kind of body. Sheet metal and bars that crush each other interlock (0.55 in SMAC,
 * literature.md 2.4); on a smooth rigid surface sheet metal slides at crash speeds. That value is
 * the one at which the fleet is led past the edge of a rigid barrier as in 398 tests with 25 %
 * overlap (validation.md). */
static const double hooking = 0.8, smooth = 0.1;

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

/* What the parts of the surfaces are pressed with together in the last slices, on b; each body
 * presses on the other's surface. */
static struct cr_vec2 thrust_on_b(const struct cr_solver *s, int pair, int a, int b) {
    const struct cr_touch *t = &s->touch[pair];
    const struct cr_moving *ma = &s->m[a], *mb = &s->m[b];
    struct cr_vec2 now = cr_vec2_sub(cr_vec2_rotate(s->losses[1].normal, ma->c, ma->s),
                                     cr_vec2_rotate(s->losses[0].normal, mb->c, mb->s));
    double keep = t->record >= 0 ? exp(-s->dt / thrust_memory) : 0;
    return cr_vec2_axpy(now, keep, t->thrust);
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
    force->thrust = thrust_on_b(s, pair, a, b);
    force->normal = cr_vec2_unit(force->thrust, cr_vec2(0, 0));
    if (cr_vec2_dot(force->normal, v) <= 0) {
        return false; /* leaving */
    }
    if (ma->body->grid.nx > 0 && mb->body->grid.nx > 0) {
        force->normal = tilt(force->normal, v);
    }
    within_cone(force, v, cr_force_friction(s, a, b));
    return true;
}
