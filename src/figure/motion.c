/* Writes the motion of all that moves, evenly sampled, in the axes that other programs want. */
#include "figure/forms.h"

#include "base/vec.h"
#include "render/picture.h"

#include <math.h>

void cr_form_motion(const struct cr_result *r, enum cr_axes_of axes, double step,
                    struct cr_str *out) {
    const struct cr_solution *sol = r->solution;
    double end = sol->samples > 0 ? sol->t[sol->samples - 1] : 0;
    /* SAE J670 has y to the right and z down, so that angles turn the other way. */
    double sign = axes == CR_AXES_SAE ? -1 : 1;
    int n = (int)floor(end / step + 1e-9);
    cr_str_add(out, "t_s,id,x_m,y_m,heading_deg,vx_m_s,vy_m_s,yaw_rate_deg_s\n");
    for (int k = 0; k <= n; k++) {
        for (int body = 0; body < r->resolved.n; body++) {
            if (!cr_result_moves(r, body)) {
                continue;
            }
            struct cr_sample s = cr_render_state(r->compiled, r, body, k * step);
            cr_str_addf(out, "%.6g,", k * step - sol->t_contact);
            cr_str_csv(out, r->resolved.part[body].id);
            cr_str_addf(out, ",%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", s.pos.x, sign * s.pos.y,
                        sign * cr_deg(s.heading), s.vel.x, sign * s.vel.y,
                        sign * cr_deg(s.yaw_rate));
        }
    }
}
