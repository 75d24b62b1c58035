/* Tells in lines of text how far the numbers of a result depend on chance. */
#include "render/render.h"
#include "result/robust.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The table shows the measures that are judged, and the direction of force. */
static bool is_shown(const struct cr_measure *m) {
    return cr_robust_is_judged(m) || strcmp(m->name, "pdof") == 0;
}

static void add_line(const struct cr_result *r, int part, int i, struct cr_str *out) {
    int n;
    const struct cr_measure *m = &cr_measures(&n)[i];
    const struct cr_unit *unit = cr_measure_unit(m);
    char value[32], spread[32], share[32];
    double most = cr_unit_from_si(unit, cr_robust_spread(r->robust, part, i));
    cr_measure_text(m, cr_measure_shown(m, &r->of[part]), value, sizeof value);
    snprintf(spread, sizeof spread, "%.*f", m->decimals + 1, most);
    cr_str_addf(out, "  %-8.8s %-15s %8s +- %6s %s", r->resolved.part[part].id, m->name, value,
                spread, m->unit);
    if (isfinite(cr_robust_share(r, part, i))) {
        snprintf(share, sizeof share, "%.1f %%", 100 * cr_robust_share(r, part, i));
        cr_str_addf(out, "%*s", 13 - (int)strlen(m->unit), share);
    }
    cr_str_add(out, cr_robust_is_unresolved(r, part, i) ? "  not resolved\n" : "\n");
}

void cr_render_robust(const struct cr_result *r, struct cr_str *out) {
    int n;
    const struct cr_measure *m = cr_measures(&n);
    cr_str_addf(out, "solved %d times more, nudged: %s\n", r->robust->solves, CR_ROBUST_NUDGES);
    if (r->robust->failed > 0) {
        cr_str_addf(out, "%d of them without a result: %s\n", r->robust->failed,
                    r->robust->failure);
    }
    for (int p = 0; p < r->resolved.n; p++) {
        for (int i = 0; i < n && r->resolved.part[p].kind == CR_KIND_VEHICLE; i++) {
            if (is_shown(&m[i])) {
                add_line(r, p, i, out);
            }
        }
    }
    cr_str_add(out, "+- is half the range of all solves\n");
}
