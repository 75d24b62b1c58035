/* Pictures of a crash made by hand against the texts in tests/golden/render, which were reviewed
 * by eye; make update-golden writes them anew. */
#include "golden.h"

#include "base/vec.h"
#include "render/screen.h"
#include "render_double.h"
#include "scene/compiled.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct golden {
    const char *name;
    int w, h; /* h 0: the report */
    struct cr_look look;
    bool wall;
    void (*draw)(struct cr_cells *cells, const struct golden *g, struct render_double *d);
    double time;
    enum cr_field field;
};

static void ok(enum cr_err code) {
    assert_int_equal(code, CR_ERR_OK);
}

static void draw_scene(struct cr_cells *cells, const struct golden *g, struct render_double *d) {
    struct cr_scene_view view = {
        .field = g->field, .time = g->time, .centre = {NAN, NAN}, .vectors = true, .selected = 0};
    ok(cr_render_scene(&(struct cr_target){cells, {0, 0, g->w, g->h}, &g->look}, NULL, NULL,
                       &d->result, &view, NULL));
}

static void draw_instant(struct cr_cells *cells, const struct golden *g, struct render_double *d) {
    ok(cr_render_table(cells, (struct cr_rect){1, 0, g->w - 1, g->h}, &g->look, &d->result, g->time,
                       NULL));
}

static void draw_energy(struct cr_cells *cells, const struct golden *g, struct render_double *d) {
    ok(cr_render_energy(cells, (struct cr_rect){0, 0, g->w, g->h}, &g->look, &d->result, g->time,
                        NULL));
}

static void draw_force(struct cr_cells *cells, const struct golden *g, struct render_double *d) {
    ok(cr_render_pulse(&(struct cr_target){cells, {0, 0, g->w, g->h}, &g->look}, &d->result,
                       CR_QUANTITY_FORCE, g->time, NULL));
}

static const struct cr_render_line log_lines[] = {
    {CR_ROLE_KEY, "crumple> load by-hand.json"},
    {CR_ROLE_TEXT, "  scene: A suv, B mini-compact; settings dt=0.5ms restitution=0.1"},
    {CR_ROLE_KEY, "crumple> solve"},
    {CR_ROLE_TEXT, "  200 steps: EES A 39.4 B 39.4, delta-v A 36.7 B 73.3 km/h"},
    {CR_ROLE_WARN, "  warning: a sentence that is longer than the narrow panes of this layout, "
                   "so it is cut"},
};

static const struct cr_render_key key_rows[] = {
    {"F1", "help"},     {"F5", "solve"},   {"F6", "panes"},  {"Tab", "complete"},
    {"^R", "history"},  {"^C", "cancel"},  {"F10", "quit"},  {"F2", "save"},
    {"F7/F8", "frame"}, {"F9", "palette"}, {"^L", "redraw"}, {"u", "undo"},
};

static void draw_screen(struct cr_cells *cells, const struct golden *g, struct render_double *d);

/* the same screen while the solver is at 40 ms of it */
static void draw_live(struct cr_cells *cells, const struct golden *g, struct render_double *d) {
    struct cr_contact *k = (struct cr_contact *)d->solution.contact;
    k->phase = CR_PHASE_PLASTIC;
    k->t_end = k->t_elastic_end = k->t_plastic_end = (double)NAN;
    d->solution.samples = 80;
    d->solution.body[0].t_last = d->solution.body[1].t_last = (double)NAN;
    draw_screen(cells, g, d);
}

static void draw_screen(struct cr_cells *cells, const struct golden *g, struct render_double *d) {
    static const char *const head[] = {"overlap", "EES A", "EES B", "delta-v A", "delta-v B"};
    static const char *const cell[] = {"20 %", "26.6", "44.9", "19.8", "42.2", "30 %", "34.6",
                                       "58.1", "27.0", "57.6", "40 %", "40.5", "67.6", "33.0",
                                       "70.4", "50 %", NULL,   NULL,   NULL,   NULL};
    const struct cr_sheet sheet = {5, 4, head, cell, 2, "Up Down choose, Enter loads", 0.67};
    struct cr_screen screen = {.title = {.file = "by-hand.json",
                                         .unsaved = true,
                                         .state = CR_TITLE_SOLVED,
                                         .vehicles = 2,
                                         .undo = 3,
                                         .time = g->time - 0.1,
                                         .t_end = 0.08,
                                         .frame = 80,
                                         .frames = 200,
                                         .dt = 0.0005,
                                         .field = "EES",
                                         .theme = "dark"},
                               .view = CR_AREA_SCENE,
                               .active = CR_AREAS,
                               .scene = &d->result.resolved,
                               .compiled = d->result.compiled,
                               .result = &d->result,
                               .scene_view = {.field = g->field,
                                              .time = g->time,
                                              .centre = {NAN, NAN},
                                              .vectors = true,
                                              .selected = 0},
                               .quantity = CR_QUANTITIES,
                               .sweep = &sheet,
                               .log = log_lines,
                               .log_n = (int)(sizeof log_lines / sizeof log_lines[0]),
                               .key = key_rows,
                               .keys = (int)(sizeof key_rows / sizeof key_rows[0]),
                               .hint =
                                   "       pulse NAME ax|ay|a|v|yaw [vs=FILE.csv] [filter=cfc60]"};
    struct cr_layout layout;
    if (g->draw == draw_live) {
        screen.live = &d->solution;
        screen.live_case = &d->result.compiled->cs;
        screen.result = NULL;
        screen.title.state = CR_TITLE_SOLVING;
        screen.title.progress = 0.5;
    }
    ok(cr_render_screen(cells, &g->look, &screen, &layout, NULL));
    cr_cells_print(cells, layout.prompt.x, layout.prompt.y, layout.prompt.w, CR_ROLE_TEXT,
                   "crumple> pulse B ax");
}

#define UTF8                                                                                       \
    { .ascii = false }
#define ASCII                                                                                      \
    { .ascii = true }
static const struct golden golden_cases[] = {
    {"report-80", 80, 0, UTF8, false, NULL, NAN, CR_FIELD_EES},
    {"report-80-ascii", 80, 0, ASCII, false, NULL, NAN, CR_FIELD_EES},
    {"report-120", 120, 0, UTF8, false, NULL, NAN, CR_FIELD_EES},
    {"report-160", 160, 0, UTF8, false, NULL, NAN, CR_FIELD_EES},
    {"report-wall-80", 80, 0, UTF8, true, NULL, NAN, CR_FIELD_EES},
    {"scene-ees", 80, 20, UTF8, false, draw_scene, 0.13, CR_FIELD_EES},
    {"scene-256", 80, 20, {.color = CR_COLOR_256}, false, draw_scene, 0.13, CR_FIELD_EES},
    {"scene-16-ascii",
     80,
     20,
     {.ascii = true, .color = CR_COLOR_16},
     false,
     draw_scene,
     0.13,
     CR_FIELD_EES},
    {"scene-energy", 80, 20, UTF8, false, draw_scene, NAN, CR_FIELD_ENERGY},
    {"scene-depth", 80, 20, UTF8, false, draw_scene, NAN, CR_FIELD_DEPTH},
    {"scene-crush-ascii", 80, 20, ASCII, false, draw_scene, 0.12, CR_FIELD_CRUSH},
    {"scene-none", 80, 20, UTF8, false, draw_scene, 0.13, CR_FIELD_NONE},
    {"scene-start", 100, 20, UTF8, false, draw_scene, 0, CR_FIELD_EES},
    {"energy", 80, 16, UTF8, false, draw_energy, 0.13, CR_FIELD_EES},
    {"force-ascii", 80, 16, ASCII, false, draw_force, 0.12, CR_FIELD_EES},
    {"table-instant", 60, 14, UTF8, false, draw_instant, 0.14, CR_FIELD_EES},
    {"screen-30x8", 30, 8, UTF8, false, draw_screen, 0.14, CR_FIELD_EES},
    {"screen-60x20", 60, 20, UTF8, false, draw_screen, 0.14, CR_FIELD_EES},
    {"screen-80x24", 80, 24, UTF8, false, draw_screen, 0.14, CR_FIELD_EES},
    {"screen-80x24-ascii", 80, 24, ASCII, false, draw_screen, 0.14, CR_FIELD_EES},
    {"screen-120x36", 120, 36, UTF8, false, draw_screen, 0.14, CR_FIELD_EES},
    {"screen-200x50", 200, 50, UTF8, false, draw_screen, 0.14, CR_FIELD_EES},
    {"screen-live-80x24", 80, 24, UTF8, false, draw_live, 0.14, CR_FIELD_EES},
    {"screen-live-160x44", 160, 44, UTF8, false, draw_live, 0.14, CR_FIELD_EES},
};

static void test_golden(void **state) {
    const struct golden *g = *state;
    struct render_double d;
    struct cr_str text = {0};
    (g->wall ? render_double_wall : render_double_init)(&d);
    if (g->h == 0) {
        ok(cr_render_report(&d.result, &g->look, g->w, &text, NULL));
    } else {
        struct cr_cells cells;
        ok(cr_cells_new(g->w, g->h, &cells, NULL));
        g->draw(&cells, g, &d);
        cr_cells_text(&cells, &g->look, &text);
        cr_cells_fini(&cells);
    }
    against_golden("render", g->name, cr_str_get(&text));
    cr_str_fini(&text);
    render_double_fini(&d);
}

int main(void) {
    enum { N = sizeof golden_cases / sizeof golden_cases[0] };
    struct CMUnitTest tests[N];
    struct golden cases[N];
    for (int i = 0; i < N; i++) {
        cases[i] = golden_cases[i];
        tests[i] = (struct CMUnitTest){golden_cases[i].name, test_golden, NULL, NULL, &cases[i]};
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
