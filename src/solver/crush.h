/* Step 1 of the paper: what of two bodies does not fit into one place, and which of them loses
 * it. */
#ifndef CR_SOLVER_CRUSH_H
#define CR_SOLVER_CRUSH_H

#include "solver/state.h"

/* overlap.c: the voxels of both bodies about their contact, into s->crush. Nothing changes. False
 * when memory is out; `met` says whether anything overlaps and comes closer. */
bool cr_overlap_find(struct cr_duo *d, bool *met);
/* signed distance of the opponent of a side at a place in the side's frame, m, and the opponent's
 * outward normal there, not quite of length 1 */
double cr_overlap_distance(const struct cr_side *k, struct cr_vec2 p);
struct cr_vec2 cr_overlap_normal(const struct cr_side *k, struct cr_vec2 p);
/* plan area that the two share at their present places, m2 */
double cr_overlap_area(struct cr_duo *d);

/* yield.c: by what share of the overlap each of the two gives way */
void cr_yield_share(struct cr_duo *d);

/* crush.c: the surfaces of both recede by their shares; energy, pressure and losses of each. False
 * when memory is out. */
bool cr_crush_contact(struct cr_duo *d);
/* what a voxel loses when the surface recedes to phi with the normal n, pushed along `push`: adds
 * a loss; voxel < 0 in the margin; false when memory is out */
bool cr_crush_lose(struct cr_side *k, int voxel, int at, double phi, struct cr_vec2 n,
                   struct cr_vec2 push);
/* the same if the surface recedes at all, which most often it does not */
static inline bool cr_crush_voxel(struct cr_side *k, int voxel, int at, double phi,
                                  struct cr_vec2 n, struct cr_vec2 push) {
    const struct cr_surface *f = &k->m->surface;
    return !(cr_min(phi, f->band) > f->phi[at]) || cr_crush_lose(k, voxel, at, phi, n, push);
}
/* Give back the share 1 - lambda of the losses and book the rest at time t; lambda = 0 undoes
 * all. */
void cr_crush_settle(struct cr_duo *d, double lambda);

/* drag.c: what lies beside the contact is dragged along (induced deformation); added to the losses
 * of both sides. False when memory is out. */
bool cr_drag_along(struct cr_duo *d);

#endif
