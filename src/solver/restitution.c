/* How much comes back: the coefficient of restitution by closing speed and width. */
#include "solver/phases.h"
#include "solver/tuning.h"

double cr_restitution_auto(double closing, bool rigid_partner) {
    /* falls evenly between the speeds that were read in tests, closing in m/s */
    double slow = rigid_partner ? 4.3 : 2, most = rigid_partner ? 0.33 : 0.3;
    double least = rigid_partner ? 0.16 : 0.10, fast = 10;
    return most + (least - most) * cr_clamp((closing - slow) / (fast - slow), 0, 1);
}

/* Share of the width of an end that is pressed, of what a flat wall would press on at the greatest
 * depth there: the depth of the opponent's surface, not of the voxels beside it. A flank counts as
 * whole, because its tests are narrow. */
static double end_share(const struct cr_side *k, enum cr_face face) {
    const struct cr_surface *s = &k->m->surface;
    double h = s->grid->h, deepest = 0, reached = 0, wide = 0;
    int n = cr_face_lines(s->grid, face);
    struct cr_lines lines = s->lines[face];
    for (int i = 0; i < k->cells; i++) {
        const struct cr_cell *c = &k->cell[i];
        double met = c->met * cr_surface_weight(c->other, h);
        wide += met * h * fabs(cr_vec2_dot(c->normal, lines.in));
        struct cr_vec2 foot = cr_vec2_axpy(c->place, -c->other, c->normal);
        double deep = cr_vec2_dot(cr_vec2_sub(foot, lines.corner), lines.in);
        deepest = met > 0 ? cr_max(deepest, deep) : deepest;
    }
    for (int i = 0; i < n; i++) {
        reached += s->outline[face][i] < deepest ? h : 0;
    }
    return reached > 0 ? cr_clamp(wide / (cr_whole_width * reached), 0, 1) : 1;
}

/* by the direction of the force: ends and flanks fade into each other */
static double width_share(const struct cr_side *k, struct cr_vec2 inward) {
    if (!k->m->soft || k->cells == 0) {
        return 1;
    }
    struct cr_vec2 n = cr_vec2_unrotate(inward, k->m->c, k->m->s);
    double end = n.x * n.x;
    return end > 0 ? end * end_share(k, n.x < 0 ? CR_FACE_FRONT : CR_FACE_REAR) + 1 - end : 1;
}

/* Factor on the restitution of whole ends, 0..1, where only part of an end is pressed: the energy
 * that comes back is stored in the width that is pressed, and goes with the square of the speed. */
static double share_of_ends(const struct cr_duo *d, const struct cr_force *f) {
    const struct cr_contact *c = &d->s->contact[d->touch->record];
    double energy = 0, pressed = 0;
    for (int side = 0; side < 2; side++) {
        const struct cr_side *k = &d->s->side[side];
        double e = c->energy[side] + k->energy;
        energy += e;
        pressed += e * width_share(k, cr_vec2_scale(f->normal, side == 0 ? -1 : 1));
    }
    return energy > 0 ? sqrt(pressed / energy) : 1;
}

/* Factor on the restitution, 0..1: what comes back was stored by the force that presses now, not by
 * the one that crushed before. The energy of a spring goes with the square of its force, and that
 * of the restitution with its own: bodies that slide off each other keep their speed. */
static double share_of_force(const struct cr_touch *t, const struct cr_contact *c) {
    double impulse = c->plastic_impulse - t->plastic_before;
    double part = t->force_sum > 0 ? t->force_level * impulse / t->force_sum : 1;
    return cr_min(part / cr_whole_force, 1);
}

void cr_restitution_update(struct cr_duo *d, const struct cr_force *f) {
    struct cr_touch *t = d->touch;
    struct cr_contact *c = &d->s->contact[t->record];
    struct cr_vec2 n = cr_vec2_unit(cr_vec2_axpy(t->normal_sum, f->energy, f->normal), f->normal);
    c->closing = cr_max(cr_vec2_dot(t->met_at, n), 0);
    if (d->s->cs->opts.restitution_auto) {
        bool rigid = !d->ma->soft || !d->mb->soft;
        c->restitution =
            cr_restitution_auto(c->closing, rigid) * share_of_ends(d, f) * share_of_force(t, c);
    }
}
