/* What is known of a scene before it is solved: when and how its participants will first touch,
 * by the solver itself, run up to that moment. */
#include "tui/tui_priv.h"

#include "base/vec.h"
#include "scene/compiled.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { STEPS_MAX = 20000 };
static const double look_s = 0.3; /* of processor time */

struct cr_preview {
    struct cr_vec2 by; /* dragged by so much */
    enum cr_err code;
    char text[256]; /* why there is no contact */
    double time;    /* s until the first touch */
    int a, b;       /* who touches */
    double closing; /* m/s, of the CGs towards each other */
    double overlap; /* lateral, share of the narrower of two vehicles; NaN: not both */
    double turn;    /* rad between their headings */
};

void cr_preview_forget(struct cr_tui *t) {
    free(t->preview);
    t->preview = NULL;
}

/* extent of a body's grid across a direction, with the body at a place */
static void across(const struct cr_body *body, const struct cr_sample *at, struct cr_vec2 side,
                   double span[2]) {
    const struct cr_grid *g = &body->grid;
    double c = cos(at->heading), s = sin(at->heading);
    span[0] = INFINITY;
    span[1] = -INFINITY;
    for (int i = 0; i < 4; i++) {
        struct cr_vec2 corner = {g->x0 + (i & 1) * g->nx * g->h, g->y0 + (i >> 1) * g->ny * g->h};
        double y = cr_vec2_dot(cr_vec2_add(at->pos, cr_vec2_rotate(corner, c, s)), side);
        span[0] = fmin(span[0], y);
        span[1] = fmax(span[1], y);
    }
}

static void describe_contact(struct cr_preview *p, const struct cr_case *cs,
                             const struct cr_solver *solver, const struct cr_contact *contact) {
    struct cr_sample a = cr_solver_state(solver, contact->a);
    struct cr_sample b = cr_solver_state(solver, contact->b);
    struct cr_vec2 side = cr_vec2(-sin(a.heading), cos(a.heading));
    double sa[2], sb[2];
    p->a = contact->a;
    p->b = contact->b;
    p->closing = contact->closing;
    p->turn = cr_angle_wrap(b.heading - a.heading);
    p->overlap = (double)NAN;
    if (cs->body[p->a].grid.nx > 0 && cs->body[p->b].grid.nx > 0) {
        across(&cs->body[p->a], &a, side, sa);
        across(&cs->body[p->b], &b, side, sb);
        double narrow = fmin(sa[1] - sa[0], sb[1] - sb[0]);
        double common = fmin(sa[1], sb[1]) - fmax(sa[0], sb[0]);
        p->overlap = narrow > 0 ? cr_clamp(common / narrow, 0, 1) : (double)NAN;
    }
}

/* Whether to give up: a signal ends the program, or it took so long that typing would be slow. */
static bool enough(clock_t begun) {
    return cr_signal_ending || (double)(clock() - begun) / CLOCKS_PER_SEC > look_s;
}

static void look_ahead(struct cr_preview *p, const struct cr_compiled *compiled) {
    clock_t begun = clock();
    struct cr_error err = {.text = ""};
    struct cr_solver *solver = NULL;
    const struct cr_solution *sol;
    p->time = (double)NAN;
    p->code = cr_solver_new(&compiled->cs, &solver, &err);
    for (int i = 0; p->code == CR_ERR_OK && i < STEPS_MAX; i++) {
        enum cr_status status = cr_solver_step(solver, &err);
        p->code = status == CR_STATUS_FAILED ? err.code : CR_ERR_OK;
        if (status != CR_STATUS_FAILED && cr_solver_touched(solver)) {
            sol = cr_solver_solution(solver);
            p->time = sol->t_contact;
            describe_contact(p, &compiled->cs, solver, &sol->contact[0]);
            break;
        }
        if (status == CR_STATUS_DONE) {
            break;
        }
        if (i % 16 == 15 && enough(begun)) {
            snprintf(err.text, sizeof err.text, "takes long to find: solve tells");
            break;
        }
    }
    snprintf(p->text, sizeof p->text, "%s", err.text);
    cr_solver_free(solver);
}

static int write_line(struct cr_tui *t, struct cr_rect at, int y, enum cr_role role,
                      const char *text) {
    struct cr_str shown = {0};
    cr_units_text(cr_session_units(t->session), text, &shown);
    if (y < at.h) {
        cr_cells_print(&t->cells, at.x, at.y + y, at.w, role, cr_str_get(&shown));
    }
    cr_str_fini(&shown);
    return y + 1;
}

static int write_participants(struct cr_tui *t, struct cr_rect at, const struct cr_case *cs) {
    int y = 0;
    const struct cr_scene *scene = cr_session_scene(t->session);
    for (int i = 0; i < scene->n && y < at.h - 6; i++) {
        const struct cr_participant *p = &scene->part[i];
        char text[120];
        if (p->kind == CR_KIND_VEHICLE) {
            snprintf(text, sizeof text, "%-2.8s%6.1f km/h %5.0f kg %.16s", p->id, cr_kmh(p->speed),
                     cs->body[i].mass, cr_type_word(p->type));
        } else {
            snprintf(text, sizeof text, "%.12s  object", p->id);
        }
        y = write_line(t, at, y, cr_render_role_of(i), text);
    }
    return y + 1;
}

static void write_preview(struct cr_tui *t, struct cr_rect at, const struct cr_case *cs,
                          const struct cr_preview *p) {
    const struct cr_scene *scene = cr_session_scene(t->session);
    char text[160];
    int y = write_participants(t, at, cs);
    if (p == NULL) {
        return;
    }
    y = write_line(t, at, y, CR_ROLE_TITLE, "First contact, predicted");
    if (p->code != CR_ERR_OK || !isfinite(p->time)) {
        write_line(t, at, y, CR_ROLE_WARN, p->text[0] != '\0' ? p->text : "none");
        return;
    }
    snprintf(text, sizeof text, "%.10s - %.10s", scene->part[p->a].id, scene->part[p->b].id);
    y = write_line(t, at, y, CR_ROLE_TEXT, text);
    snprintf(text, sizeof text, "in          %8.1f ms", 1e3 * p->time);
    y = write_line(t, at, y, CR_ROLE_TEXT, text);
    snprintf(text, sizeof text, "closing     %8.1f km/h", cr_kmh(p->closing));
    y = write_line(t, at, y, CR_ROLE_TEXT, text);
    if (isfinite(p->overlap)) {
        snprintf(text, sizeof text, "overlap     %8.0f %%", 100 * p->overlap);
        y = write_line(t, at, y, CR_ROLE_TEXT, text);
    }
    snprintf(text, sizeof text, "angle       %8.0f deg", cr_deg(p->turn));
    y = write_line(t, at, y, CR_ROLE_TEXT, text);
    int back = t->dragged < 0 ? cr_session_way_back(t->session) : 0;
    write_line(t, at, y + 1, CR_ROLE_DIM, back != 0 ? "F5 solves it anew" : "F5 solves it");
    if (back != 0) {
        snprintf(text, sizeof text, "%s %d: back to the result", back > 0 ? "undo" : "redo",
                 abs(back));
        write_line(t, at, y + 2, CR_ROLE_DIM, text);
    }
}

void cr_preview_draw(struct cr_tui *t, const struct cr_compiled *compiled) {
    struct cr_rect at = t->layout.results.w > 0 ? t->layout.results : t->layout.pane[CR_AREA_TABLE];
    bool joined = t->layout.results.w > 0;
    const struct cr_scene *scene = cr_session_scene(t->session);
    if (at.w == 0 || scene->n == 0 || compiled == NULL) {
        return;
    }
    at = (struct cr_rect){at.x + (joined ? 0 : 2), at.y + 1, at.w - (joined ? 1 : 3), at.h - 2};
    for (int y = at.y; y < at.y + at.h; y++) {
        for (int x = at.x; x < at.x + at.w; x++) {
            t->cells.cell[y * t->cells.w + x] = (struct cr_cell){.ch = ' ', .role = CR_ROLE_TEXT};
        }
    }
    bool same =
        t->preview != NULL && t->preview->by.x == t->drag_by.x && t->preview->by.y == t->drag_by.y;
    if (!same && scene->n > 1) {
        cr_preview_forget(t);
        t->preview = calloc(1, sizeof *t->preview);
        if (t->preview != NULL) {
            t->preview->by = t->drag_by;
            look_ahead(t->preview, compiled);
        }
    }
    write_preview(t, at, &compiled->cs, scene->n > 1 ? t->preview : NULL);
}
