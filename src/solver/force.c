/* Step 2 of the paper: the force vector from the voxels that were deformed. */
#include "solver/force.h"

#include "base/elementary.h"
#include "solver/tuning.h"

/* Friction by kind of body: the smoother one decides. */
static double friction_of(const struct cr_solver *s, int i) {
    const struct cr_body *b = &s->cs->body[i];
    double by_kind = b->grid.nx == 0 ? cr_friction_smooth : cr_friction_hooked;
    return b->friction >= 0            ? b->friction
           : s->cs->opts.friction_auto ? by_kind
                                       : s->cs->opts.friction;
}

double cr_force_friction(const struct cr_duo *d) {
    return cr_min(friction_of(d->s, d->a), friction_of(d->s, d->b));
}

double cr_force_approach(const struct cr_duo *d, const struct cr_force *force) {
    return cr_vec2_dot(cr_relative_velocity(d, force->coe), force->normal);
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

/* Crushing material presses with its strength on each part of a surface along that part's own
 * normal, however slowly it comes. Each body presses on the other by the share that it gives
 * way. */
static struct cr_vec2 pressure_on_b(const struct cr_duo *d) {
    const struct cr_side *a = &d->s->side[0], *b = &d->s->side[1];
    struct cr_vec2 on_a = cr_vec2_rotate(a->pressure, d->ma->c, d->ma->s);
    struct cr_vec2 on_b = cr_vec2_rotate(b->pressure, d->mb->c, d->mb->s);
    return cr_vec2_sub(cr_vec2_scale(on_b, b->share), cr_vec2_scale(on_a, a->share));
}

/* centre of the strength that presses, world */
static bool centre(const struct cr_duo *d, struct cr_vec2 *coe) {
    struct cr_vec2 sum = {0, 0};
    double weight = 0;
    for (int side = 0; side < 2; side++) {
        const struct cr_side *k = &d->s->side[side];
        double w = k->share * k->weight;
        if (w > 0) {
            struct cr_vec2 at = cr_to_world(k->m, cr_vec2_scale(k->moment, 1 / k->weight));
            sum = cr_vec2_axpy(sum, w, at);
            weight += w;
        }
    }
    *coe = weight > 0 ? cr_vec2_scale(sum, 1 / weight) : sum;
    return weight > 0;
}

/* Second moments of points with weights about a place, 0: x x, 1: x y, 2: y y. */
struct moments {
    double weight, second[3];
    struct cr_vec2 first;
};

static void add_point(struct moments *m, double w, struct cr_vec2 p) {
    m->weight += w;
    m->first = cr_vec2_axpy(m->first, w, p);
    m->second[0] += w * p.x * p.x;
    m->second[1] += w * p.x * p.y;
    m->second[2] += w * p.y * p.y;
}

/* the voxels that a side has lost, by their energies, as seen from a place in the world */
static void add_deformed(const struct cr_side *k, struct cr_vec2 from, struct moments *m) {
    const struct cr_grid *g = &k->m->body->grid;
    for (int i = 0; i < k->losses; i++) {
        const struct cr_loss *l = &k->loss[i];
        if (l->amount > 0) {
            struct cr_vec2 p = {g->x0 + (l->voxel % g->nx + 0.5) * g->h,
                                g->y0 + (l->voxel / g->nx + 0.5) * g->h};
            double energy = l->amount * cr_unit_energy(k, l->voxel, k->push);
            add_point(m, energy, cr_vec2_sub(cr_to_world(k->m, p), from));
        }
    }
}

/* Normal to the plane through the voxels that were deformed in the slice, each by its energy as in
 * Eq. (3): the plane runs where those of the highest EES value lie. A voxel is a piece of the
 * surface itself, as long as its edge and turned as the pressure says; so the first one that is
 * deformed has a plane, too. */
static struct cr_vec2 plane_normal(const struct cr_duo *d, struct cr_vec2 from,
                                   struct cr_vec2 pressure) {
    struct moments m = {0}, of[2] = {m, m};
    double h = 0;
    for (int side = 0; side < 2; side++) {
        const struct cr_side *k = &d->s->side[side];
        add_deformed(k, from, &of[side]);
        h = k->m->soft ? cr_max(h, k->m->body->grid.h) : h;
        m.weight += of[side].weight; /* by sides, so that neither is the first */
        m.first = cr_vec2_add(m.first, of[side].first);
        for (int i = 0; i < 3; i++) {
            m.second[i] += of[side].second[i];
        }
    }
    if (!(m.weight > 0)) {
        return pressure;
    }
    struct cr_vec2 mean = cr_vec2_scale(m.first, 1 / m.weight), along = cr_vec2_perp(pressure);
    double own = h * h / 12; /* second moment of a line as long as an edge */
    double xx = m.second[0] / m.weight - mean.x * mean.x + own * along.x * along.x;
    double xy = m.second[1] / m.weight - mean.x * mean.y + own * along.x * along.y;
    double yy = m.second[2] / m.weight - mean.y * mean.y + own * along.y * along.y;
    double angle = 0.5 * cr_atan2(2 * xy, xx - yy); /* of the plane, from world x */
    struct cr_vec2 n = cr_vec2_perp(cr_vec2_toward(angle));
    return cr_vec2_dot(n, pressure) < 0 ? cr_vec2_scale(n, -1) : n;
}

bool cr_force_find(const struct cr_duo *d, struct cr_force *force) {
    *force = (struct cr_force){.energy = d->s->side[0].energy + d->s->side[1].energy};
    if (!(force->energy > 0) || !centre(d, &force->coe)) {
        return false;
    }
    struct cr_vec2 v = cr_vec2_unit(cr_relative_velocity(d, force->coe), cr_vec2(0, 0));
    force->normal = cr_vec2_unit(pressure_on_b(d), cr_vec2(0, 0));
    if (d->s->cs->opts.plane) {
        force->normal = plane_normal(d, force->coe, force->normal);
    }
    if (!(cr_vec2_dot(force->normal, v) > cr_cosine_least)) {
        return false; /* leaving, or sliding along */
    }
    within_cone(force, v, cr_force_friction(d));
    return true;
}
