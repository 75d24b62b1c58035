/* Computes the injury risk a participant would have had in a harder or milder crash of the same
 * kind: what a risk curve shows. */
#include "result/result_priv.h"

#include "base/vec.h"

#include <math.h>
#include <string.h>

void cr_result_risk(const struct cr_result *r, const struct cr_irf_set *irf, int body,
                    double delta_v, struct cr_severity *out) {
    const struct cr_severity *own = &r->of[body];
    const struct cr_solution *sol = r->solution;
    int main = cr_result_main_contact(sol, body);
    double share = own->delta_v > 0 ? delta_v / own->delta_v : 0;
    struct cr_irf_case what = {.words = r->resolved.set.injury,
                               .delta_v = delta_v,
                               .closing = NAN,
                               .ees = own->ees * share,
                               .pdof = own->pdof};
    memset(out, 0, sizeof *out);
    if (irf == NULL) {
        return;
    }
    if (main >= 0) {
        const struct cr_contact *c = &sol->contact[main];
        int other = c->a == body ? c->b : c->a;
        struct cr_vec2 v = cr_vec2_sub(sol->body[body].before.vel, sol->body[other].before.vel);
        what.closing = cr_vec2_len(v) * share;
        what.vehicle_partner = r->resolved.part[other].kind == CR_KIND_VEHICLE;
    }
    cr_irf_apply(irf, &what, out);
}
