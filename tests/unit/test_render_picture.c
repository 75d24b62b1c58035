/* Pictures, plots and tables of a crash made by hand: what must be where. */
#include "test.h"

#include "base/vec.h"
#include "render/picture.h"
#include "render_double.h"
#include "scene/compiled.h"

#include <stdlib.h>
#include <string.h>

static const struct cr_look plain = {.color = CR_COLOR_NONE};
static const double dv_a = 2 * 200 * 0.080 / CR_PI; /* of the half-sine pulse, m/s */

static struct cr_scene_view view_at(double time) {
    return (struct cr_scene_view){
        .field = CR_FIELD_EES, .time = time, .centre = {0, 0}, .m_per_col = 0.1, .selected = -1};
}

static struct cr_cells picture(const struct render_double *d, const struct cr_scene_view *view,
                               const struct cr_look *look) {
    struct cr_cells c;
    struct cr_error err;
    assert_int_equal(cr_cells_new(120, 30, &c, &err), CR_ERR_OK);
    assert_int_equal(cr_render_scene(&(struct cr_target){&c, {0, 0, 120, 30}, look},
                                     d->result.compiled, &d->result.resolved, &d->result, view,
                                     &err),
                     CR_ERR_OK);
    return c;
}

static int count(const struct cr_cells *c, uint32_t ch) {
    int n = 0;
    for (int i = 0; i < c->w * (c->h - 1); i++) { /* without the legend */
        n += c->cell[i].ch == ch;
    }
    return n;
}

static bool is_shade(uint32_t ch) {
    return ch >= 0x2588 && ch <= 0x2593;
}

/* columns of the first and last shade in a row; first > last: none */
static void extent(const struct cr_cells *c, int y, int *first, int *last) {
    *first = c->w;
    *last = -1;
    for (int x = 0; x < c->w; x++) {
        if (is_shade(c->cell[y * c->w + x].ch)) {
            *first = x < *first ? x : *first;
            *last = x;
        }
    }
}

static void test_motion_between(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    const struct cr_compiled *k = d.result.compiled;
    double v = 56 / 3.6;
    /* half way to the first contact, which is 100 ms after the start */
    struct cr_sample s = cr_render_state(k, &d.result, 0, 0.05);
    check_near(s.pos.x, -2.5 - 0.05 * v, 1e-9);
    check_near(s.vel.x, v, 1e-9);
    s = cr_render_state(k, &d.result, 0, 0.1);
    check_near(s.pos.x, -2.5, 1e-9);
    check_near(cr_vec2_len(s.force), 0, 0);
    /* half way through the pulse half the delta-v is there and the force is at its peak */
    s = cr_render_state(k, &d.result, 0, 0.14);
    check_near(s.vel.x, v - dv_a / 2, 1e-6);
    check_near(s.force.x, -200 * 2400, 1);
    s = cr_render_state(k, &d.result, 0, NAN);
    check_near(s.vel.x, v - dv_a, 1e-6);
    /* without a result: the start */
    s = cr_render_state(k, NULL, 0, NAN);
    check_near(s.pos.x, -2.5 - 0.1 * v, 1e-9);
    render_double_fini(&d);
}

/* a solve under way: "now" is the last slice there is */
static void test_state_while_solving(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_contact k = d.solution.contact[0];
    k.phase = CR_PHASE_PLASTIC;
    k.t_end = (double)NAN;
    d.solution.contact = &k;
    d.solution.samples = 80; /* 40 ms: half of the delta-v */
    d.solution.body[0].t_last = d.solution.body[1].t_last = (double)NAN;
    struct cr_sample s = cr_render_state(d.result.compiled, &d.result, 0, (double)NAN);
    check_near(s.vel.x, 56 / 3.6 - dv_a / 2, 1e-6);
    check_near(cr_render_t_main(&d.solution), 0.14, 1e-9);
    struct cr_scene_view view = view_at((double)NAN);
    struct cr_cells c = picture(&d, &view, &plain);
    assert_true(count(&c, 0xD7) > 5);
    cr_cells_fini(&c);
    render_double_fini(&d);
}

static void test_size_on_the_screen(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_scene_view view = view_at(0.08);
    struct cr_cells c = picture(&d, &view, &plain);
    int rows = 0, widest = 0;
    for (int y = 0; y < c.h - 1; y++) {
        int first, last;
        extent(&c, y, &first, &last);
        if (first < 60 && last >= 0) { /* A is left of the middle */
            int a_last = first;
            while (is_shade(c.cell[y * c.w + a_last + 1].ch) && a_last < 60) {
                a_last++;
            }
            rows++;
            widest = a_last - first + 1 > widest ? a_last - first + 1 : widest;
        }
    }
    /* 5.0 m at 0.1 m per column and 2.0 m at 0.2 m per row */
    assert_in_range(widest, 49, 51);
    assert_in_range(rows, 9, 11);
    assert_int_equal(count(&c, 0xD7), 0);
    cr_cells_fini(&c);
    render_double_fini(&d);
}

static void test_crushed_only_when_it_happened(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    int before = 0, middle, after;
    struct cr_scene_view view = view_at(0.05);
    for (int i = 0; i < 2; i++) { /* on the way and at the first contact */
        struct cr_cells c = picture(&d, &view, &plain);
        before += count(&c, 0xD7) + count(&c, '~');
        cr_cells_fini(&c);
        view.time = 0.1;
    }
    view.time = 0.125;
    struct cr_cells c = picture(&d, &view, &plain);
    middle = count(&c, 0xD7);
    cr_cells_fini(&c);
    view.time = NAN;
    c = picture(&d, &view, &plain);
    after = count(&c, 0xD7);
    assert_int_equal(before, 0);
    assert_true(middle > 5);
    assert_true(after > middle);
    assert_true(count(&c, '~') > 0);
    cr_cells_fini(&c);
    render_double_fini(&d);
}

/* bodies placed into each other are marked while there is no result */
static void test_overlap_before_the_crash(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_scene_view view = view_at((double)NAN);
    for (int i = 0; i < 2; i++) {
        struct cr_cells c;
        struct cr_error err;
        assert_int_equal(cr_cells_new(120, 30, &c, &err), CR_ERR_OK);
        assert_int_equal(cr_render_scene(&(struct cr_target){&c, {0, 0, 120, 30}, &plain},
                                         d.result.compiled, &d.result.resolved, NULL, &view, &err),
                         CR_ERR_OK);
        if (i == 0) {
            assert_int_equal(count(&c, '!'), 0);
        } else {
            /* 0.5 m x 0.9 m or a little less at the round corners, cells of 0.1 x 0.2 m */
            assert_in_range(count(&c, '!'), 12, 25);
        }
        cr_cells_fini(&c);
        d.result.compiled->cs.body[0].pos = cr_vec2(-2.25, 0);
        d.result.compiled->cs.body[1].pos = cr_vec2(1.55, 0.9);
    }
    render_double_fini(&d);
}

static void test_forces_end_with_the_crash(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_scene_view view = view_at(0.14);
    view.vectors = true;
    struct cr_cells c = picture(&d, &view, &plain);
    int force = 0;
    for (int i = 0; i < c.w * (c.h - 1); i++) {
        force += c.cell[i].role == CR_ROLE_FORCE;
    }
    assert_true(force > 10);
    cr_cells_fini(&c);
    view.time = NAN;
    c = picture(&d, &view, &plain);
    for (int i = 0; i < c.w * c.h; i++) {
        assert_int_not_equal(c.cell[i].role, CR_ROLE_FORCE);
    }
    cr_cells_fini(&c);
    render_double_fini(&d);
}

static void test_ascii_everywhere(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    for (int color = CR_COLOR_NONE; color <= CR_COLOR_256; color++) {
        struct cr_look look = {.ascii = true, .color = (enum cr_color)color};
        struct cr_str s = {0};
        struct cr_error err;
        assert_int_equal(cr_render_report(&d.result, &look, 80, &s, &err), CR_ERR_OK);
        for (const char *p = cr_str_get(&s); *p != '\0'; p++) {
            assert_true(*p == '\n' || *p == '\033' || (*p >= 32 && *p < 127));
        }
        assert_null(strchr(cr_str_get(&s), '?')); /* a stand-in for every sign that is used */
        cr_str_fini(&s);
    }
    render_double_fini(&d);
}

static void test_report_fits_its_width(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    for (int width = 60; width <= 220; width += 7) {
        struct cr_str s = {0};
        struct cr_error err;
        assert_int_equal(cr_render_report(&d.result, &plain, width, &s, &err), CR_ERR_OK);
        char *line = s.s;
        while (*line != '\0') {
            char *end = strchr(line, '\n');
            *end = '\0';
            if (cr_glyph_width(line) > width) {
                fail_msg("width %d: %s", width, line);
            }
            line = end + 1;
        }
        cr_str_fini(&s);
    }
    render_double_fini(&d);
}

static char *report_of(const struct render_double *d) {
    struct cr_str s = {0};
    struct cr_error err;
    assert_int_equal(cr_render_report(&d->result, &plain, 80, &s, &err), CR_ERR_OK);
    return s.s;
}

/* a scene that runs to rest has a picture of it, which says when not all are at rest */
static void test_rest_picture(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    char *text = report_of(&d);
    assert_null(strstr(text, "rest \u2500"));
    free(text);
    d.result.resolved.set.end = CR_END_REST;
    text = report_of(&d);
    assert_non_null(strstr(text, " At the end, not all at rest "));
    free(text);
    d.solution.body[0].t_rest = d.solution.body[1].t_rest = 0.19;
    text = report_of(&d);
    assert_non_null(strstr(text, " At rest "));
    free(text);
    render_double_fini(&d);
}

/* many light contacts are counted, not listed */
static void test_many_contacts(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_contact k[20];
    for (int i = 0; i < 20; i++) {
        k[i] = d.solution.contact[0];
        k[i].impulse = cr_vec2(i < 3 ? 10000 : 100, 0);
    }
    d.solution.contact = k;
    d.solution.contacts = 12;
    char *text = report_of(&d);
    assert_null(strstr(text, "light contacts"));
    free(text);
    d.solution.contacts = 20;
    text = report_of(&d);
    assert_non_null(strstr(text, "and 17 light contacts"));
    free(text);
    render_double_fini(&d);
}

static void test_table_values(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_cells c;
    struct cr_error err;
    int rows = cr_render_table_rows(&d.result);
    assert_int_equal(cr_cells_new(78, rows, &c, &err), CR_ERR_OK);
    assert_int_equal(
        cr_render_table(&c, (struct cr_rect){0, 0, 78, rows}, &plain, &d.result, NAN, &err),
        CR_ERR_OK);
    struct cr_str s = {0};
    cr_cells_text(&c, &plain, &s);
    /* delta-v 10.186 m/s = 36.7 km/h for A, twice that for B; EES sqrt(120) m/s = 39.4 km/h;
     * 200 m/s2 = 20.4 g; 60 kg-1 J x 2400 kg = 144 kJ */
    static const char *const want[][4] = {
        {"delta-v", "36.7", "73.3", "km/h"},
        {"EES", "39.4", "39.4", "km/h"},
        {"maximum, CFC 60", "20.4", "40.8", "g"},
        {"energy", "144.0", "72.0", "kJ"},
        {"greatest depth, residual", "0.30", "0.40", "m"},
        {"MAIS3+ frontal", "12.5", "12.5", "%"},
        {"mass", "2400", "1200", "kg"},
    };
    for (size_t i = 0; i < sizeof want / sizeof want[0]; i++) {
        char *row = strstr(s.s, want[i][0]);
        assert_non_null(row);
        char line[200];
        size_t n = strcspn(row, "\n");
        assert_true(n < sizeof line);
        memcpy(line, row, n);
        line[n] = '\0';
        const char *at = line;
        for (int k = 1; k < 4; k++) {
            at = strstr(at, want[i][k]);
            if (at == NULL) {
                fail_msg("no %s in: %s", want[i][k], line);
            }
            at += strlen(want[i][k]);
        }
    }
    cr_str_fini(&s);
    cr_cells_fini(&c);
    render_double_fini(&d);
}

/* the plotted pulse has the height of the half sine whatever the length of the slices */
static void test_pulse_of_uneven_slices(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    double y[200], most[2] = {0, 0};
    for (int pass = 0; pass < 2; pass++) {
        int n = cr_render_samples(&d.solution);
        assert_in_range(n, pass == 0 ? 170 : 130, pass == 0 ? 180 : 140);
        assert_true(cr_render_series(&d.result, 0, CR_QUANTITIES, n, y));
        for (int i = 0; i < n; i++) {
            most[pass] = fmax(most[pass], y[i]);
        }
        /* 200 m/s2 = 20.39 g; CFC 60 takes little from a half sine of 80 ms */
        check_near(most[pass], 20.39, 0.25);
        /* leave out every second slice before 140 ms */
        double *t = (double *)d.solution.t;
        struct cr_sample *trace = (struct cr_sample *)d.solution.trace;
        int k = 0;
        for (int i = 1; pass == 0 && i < d.solution.samples; i += i < 80 ? 2 : 1) {
            t[k] = t[i];
            memcpy(&trace[2 * k++], &trace[2 * i], 2 * sizeof *trace);
        }
        d.solution.samples = pass == 0 ? k : d.solution.samples;
        assert_in_range(d.solution.samples, 150, 165);
    }
    render_double_fini(&d);
}

static void test_plot_peak(void **state) {
    (void)state;
    double x[101], y[101];
    for (int i = 0; i <= 100; i++) {
        x[i] = i;
        y[i] = i <= 50 ? i : 100 - i;
    }
    struct cr_curve_line curve = {x, y, 101, 'A', "triangle", CR_ROLE_A, false, false};
    struct cr_plot plot = {"y", "ms", "m", NULL, false, 1, &curve, 25, CR_UNITS_SI};
    struct cr_cells c;
    struct cr_error err;
    assert_int_equal(cr_cells_new(60, 15, &c, &err), CR_ERR_OK);
    assert_int_equal(cr_render_plot(&c, (struct cr_rect){0, 0, 60, 15}, &plain, &plot, &err),
                     CR_ERR_OK);
    int top_x = 0, top_n = 0, cursor = 0;
    for (int i = 0; i < 60; i++) {
        uint32_t ch = c.cell[60 + i].ch; /* first row of the curve's area */
        if (ch > 0x2800 && ch < 0x2900) {
            top_x += i;
            top_n++;
        }
        cursor = c.cell[5 * 60 + i].ch == 0x2506 ? i : cursor;
    }
    /* the area begins after the labels (2 columns) and the axis; the peak is in its middle */
    assert_true(top_n > 0);
    check_near((double)top_x / top_n, 3 + 57 / 2.0, 1.5);
    check_near(cursor, 3 + 57 / 4.0, 1);
    cr_cells_fini(&c);
}

/* an axis that is close to its curve begins near it, and its last tick has its number */
static void test_close_axis(void **state) {
    (void)state;
    static const double x[3] = {40, 50, 60}, y[3] = {80, 85, 90};
    struct cr_curve_line curve = {x, y, 3, 'A', "A", CR_ROLE_A, false, false};
    struct cr_plot plot = {"ees", NULL, "km/h", "A.speed, km/h", true, 1, &curve, NAN, CR_UNITS_SI};
    struct cr_plot_range r = cr_plot_range(&plot);
    assert_true(r.y_lo > 79 && r.y_lo < 80 && r.y_hi > 90 && r.y_hi < 91);
    struct cr_cells c;
    struct cr_str text = {0};
    assert_int_equal(cr_cells_new(60, 15, &c, NULL), CR_ERR_OK);
    assert_int_equal(cr_render_plot(&c, (struct cr_rect){0, 0, 60, 15}, &plain, &plot, NULL),
                     CR_ERR_OK);
    cr_cells_text(&c, &plain, &text);
    assert_non_null(strstr(cr_str_get(&text), "A.speed, km/h \u2192\n"));
    assert_non_null(strstr(cr_str_get(&text), "60\n"));
    assert_non_null(strstr(cr_str_get(&text), "80\u2524"));
    cr_str_fini(&text);
    cr_cells_fini(&c);
    plot.close = false; /* else zero belongs to it where the curve is not far above */
    static const double low[3] = {6, 12, 9};
    curve.y = low;
    assert_true(cr_plot_range(&plot).y_lo == 0);
}

static void test_plot_of_nothing(void **state) {
    (void)state;
    struct cr_plot plot = {"y", "ms", "m", NULL, false, 0, NULL, NAN, CR_UNITS_SI};
    double x[2] = {0, 1}, y[2] = {NAN, INFINITY};
    struct cr_curve_line curve = {x, y, 2, 'A', "none", CR_ROLE_A, false, false};
    struct cr_cells c;
    struct cr_error err;
    assert_int_equal(cr_cells_new(40, 10, &c, &err), CR_ERR_OK);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(cr_render_plot(&c, (struct cr_rect){0, 0, 40, 10}, &plain, &plot, &err),
                         CR_ERR_OK);
        assert_int_equal(cr_render_plot(&c, (struct cr_rect){0, 0, 5, 2}, &plain, &plot, &err),
                         CR_ERR_OK);
        plot.curves = 1;
        plot.curve = &curve;
    }
    for (int i = 0; i < 400; i++) {
        assert_false(c.cell[i].ch > 0x2800 && c.cell[i].ch < 0x2900);
    }
    cr_cells_fini(&c);
}

/* any rectangle, however small, is drawn in without touching what is outside of it */
static void test_small_rectangles(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_scene_view view = view_at(0.13);
    view.m_per_col = 0;
    view.vectors = true;
    for (int w = 1; w <= 40; w += 3) {
        for (int h = 1; h <= 12; h++) {
            struct cr_cells c;
            struct cr_error err;
            struct cr_rect at = {2, 1, w, h};
            assert_int_equal(cr_cells_new(w + 4, h + 2, &c, &err), CR_ERR_OK);
            assert_int_equal(cr_render_scene(&(struct cr_target){&c, at, &plain}, NULL, NULL,
                                             &d.result, &view, &err),
                             CR_ERR_OK);
            for (int i = 0; i < c.w * c.h; i++) {
                int x = i % c.w, y = i / c.w;
                if (x < 2 || x >= 2 + w || y < 1 || y >= 1 + h) {
                    assert_int_equal(c.cell[i].ch, ' ');
                }
            }
            cr_cells_fini(&c);
        }
    }
    render_double_fini(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_motion_between),
        cmocka_unit_test(test_state_while_solving),
        cmocka_unit_test(test_size_on_the_screen),
        cmocka_unit_test(test_crushed_only_when_it_happened),
        cmocka_unit_test(test_overlap_before_the_crash),
        cmocka_unit_test(test_forces_end_with_the_crash),
        cmocka_unit_test(test_ascii_everywhere),
        cmocka_unit_test(test_report_fits_its_width),
        cmocka_unit_test(test_rest_picture),
        cmocka_unit_test(test_many_contacts),
        cmocka_unit_test(test_table_values),
        cmocka_unit_test(test_pulse_of_uneven_slices),
        cmocka_unit_test(test_plot_peak),
        cmocka_unit_test(test_close_axis),
        cmocka_unit_test(test_plot_of_nothing),
        cmocka_unit_test(test_small_rectangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
