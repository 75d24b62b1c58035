/* Step 1: the surfaces recede, voxels lose material and give up their energy. */
#include "solver/crush.h"

#include "base/grow.h"
#include "solver/tuning.h"

/* Share of what is left of a voxel that it keeps as its surface rises from one distance to another
 * with the normal n: as far as the surface moves, a normal that turns takes nothing away. What
 * another normal left where this one leaves nothing goes by the time that it would with any. */
static double kept_share(double from, double to, struct cr_vec2 n, double h) {
    double before = cr_surface_left(from, n, h, 1), gone = sqrt(0.5) * h;
    if (before > 0) {
        return cr_surface_left(to, n, h, 1) / before;
    }
    return to < gone ? (gone - to) / (gone - from) : 0;
}

bool cr_crush_lose(struct cr_side *k, int voxel, int at, double phi, struct cr_vec2 n,
                   struct cr_vec2 push) {
    struct cr_surface *f = &k->m->surface;
    double h = f->grid->h, amount = 0, unit = 0;
    if (voxel >= 0) {
        unit = cr_unit_energy(k, voxel, push);
    }
    if (unit > 0) { /* layers that do not meet the opponent stay */
        amount = f->left[voxel];
        amount -= amount * kept_share(f->phi[at], phi, n, h);
    }
    if (!cr_grow(&k->loss, &k->losses_size, k->losses, sizeof *k->loss)) {
        return false;
    }
    if (f->phi[at] <= -f->band) {
        cr_surface_near(f, at);
    }
    double moved = cr_min(phi, f->band) - f->phi[at];
    f->phi[at] += moved;
    if (amount > 0) {
        f->left[voxel] -= amount;
        k->energy += amount * unit;
        k->area += amount * h * h;
    }
    k->loss[k->losses++] = (struct cr_loss){voxel, at, amount, moved};
    return true;
}

/* A voxel further from the surface is as far from it as its neighbours on the way there say, m. */
static double follow(const struct cr_side *k, const struct cr_cell *c) {
    const struct cr_surface *f = &k->m->surface;
    double h = f->grid->h, deeper = c->phi < c->other ? -1 : 1; /* it lies inside or outside */
    double nx = deeper * c->normal.x, ny = deeper * c->normal.y;
    int to_x = nx < 0 ? -1 : 1, to_y = ny < 0 ? -f->stride : f->stride;
    double by_x = f->phi[c->at + to_x] + deeper * fabs(nx) * h;
    double by_y = f->phi[c->at + to_y] + deeper * fabs(ny) * h;
    return nx * nx * by_x + ny * ny * by_y;
}

/* All at once, so that the order of the voxels does not matter: a step outward and inward from the
 * core for each time. */
static bool follow_all(struct cr_side *k) {
    for (int step = 0; step < 2; step++) {
        for (int i = 0; i < k->cells; i++) {
            struct cr_cell *c = &k->cell[i];
            c->next = c->core || c->leaves ? c->phi : follow(k, c);
        }
        for (int i = 0; i < k->cells; i++) {
            struct cr_cell *c = &k->cell[i];
            if (!c->core && !cr_crush_voxel(k, c->voxel, c->at, c->next, c->normal, k->push)) {
                return false;
            }
        }
    }
    return true;
}

static bool recede(struct cr_side *k) {
    double h = k->m->body->grid.h;
    for (int i = 0; i < k->cells; i++) {
        const struct cr_cell *c = &k->cell[i];
        if (!c->core || c->approach <= 0) {
            continue;
        }
        double phi = c->phi + k->share * cr_overlap_at(c, k->share);
        double press = c->met * c->strength * cr_surface_weight(phi, h);
        if (!cr_crush_voxel(k, c->voxel, c->at, phi, c->normal, k->push)) {
            return false;
        }
        k->pressure = cr_vec2_axpy(k->pressure, press, c->normal);
        k->moment = cr_vec2_axpy(k->moment, press, c->place);
        k->weight += press;
    }
    bool ok = follow_all(k);
    k->direct = k->losses;
    return ok;
}

bool cr_crush_contact(struct cr_duo *d) {
    for (int side = 0; side < 2; side++) {
        struct cr_side *k = &d->s->side[side];
        k->advance = k->end > 0 ? k->share * k->thick / k->end : 0;
        if (k->m->soft && !recede(k)) {
            return false;
        }
    }
    return true;
}

/* what was emptied is passed over from now on */
static void renew_lines(struct cr_surface *f, int voxel) {
    int ix = voxel % f->grid->nx, iy = voxel / f->grid->nx;
    for (int face = 0; face < CR_FACES; face++) {
        cr_surface_renew(f, face, cr_face_is_end(face) ? iy : ix);
    }
}

static void book(struct cr_solver *s, struct cr_side *k, double lambda) {
    struct cr_surface *f = &k->m->surface;
    for (int i = 0; i < k->losses; i++) {
        const struct cr_loss *l = &k->loss[i];
        double amount = lambda * l->amount;
        if (amount > 0) {
            s->deformed += f->how[l->voxel] == 0;
            f->t_sum[l->voxel] += amount * s->t;
            f->how[l->voxel] |= i < k->direct ? CR_CRUSH_CONTACT : CR_CRUSH_INDUCED;
            if (f->left[l->voxel] <= cr_crumb * f->dense[l->voxel]) {
                renew_lines(f, l->voxel);
            }
        }
    }
}

void cr_crush_settle(struct cr_duo *d, double lambda) {
    for (int side = 0; side < 2; side++) {
        struct cr_side *k = &d->s->side[side];
        struct cr_surface *f = &k->m->surface;
        double back = 1 - lambda;
        for (int i = 0; i < k->losses && back > 0; i++) {
            if (k->loss[i].amount > 0) {
                f->left[k->loss[i].voxel] += back * k->loss[i].amount;
            }
            f->phi[k->loss[i].at] -= back * k->loss[i].moved;
        }
        k->energy *= lambda;
        k->induced *= lambda;
        k->area *= lambda;
        book(d->s, k, lambda);
        k->m->energy += k->energy;
        k->m->induced += k->induced;
        k->m->crushed += k->area;
        d->s->visits += k->cells;
    }
}
