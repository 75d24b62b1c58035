/* Cells, glyphs, themes, ticks. */
#include "test.h"

#include "base/vec.h"
#include "render/render_priv.h"
#include "render/theme.h"

#include <stdlib.h>
#include <string.h>

static struct cr_cells grid(int w, int h) {
    struct cr_cells cells;
    struct cr_error err;
    assert_int_equal(cr_cells_new(w, h, &cells, &err), CR_ERR_OK);
    return cells;
}

static char *text_of(const struct cr_cells *cells, struct cr_look look) {
    struct cr_str s = {0};
    cr_cells_text(cells, &look, &s);
    assert_false(s.failed);
    return s.s;
}

static void check_text(const struct cr_cells *cells, struct cr_look look, const char *want) {
    char *got = text_of(cells, look);
    assert_string_equal(got, want);
    free(got);
}

static void test_print_and_cut(void **state) {
    (void)state;
    struct cr_cells c = grid(8, 3);
    assert_int_equal(cr_cells_print(&c, 0, 0, 0, CR_ROLE_TEXT, "exactly8"), 8);
    assert_int_equal(cr_cells_print(&c, 0, 1, 0, CR_ROLE_TEXT, "more than 8"), 8);
    assert_int_equal(cr_cells_print(&c, 2, 2, 4, CR_ROLE_TEXT, "abcdef"), 4);
    check_text(&c, (struct cr_look){0}, "exactly8\nmore th~\n  abc~\n");
    assert_int_equal(cr_cells_print(&c, 8, 0, 0, CR_ROLE_TEXT, "out"), 0);
    assert_int_equal(cr_cells_print(&c, 7, 0, 0, CR_ROLE_TEXT, "xy"), 1);
    cr_cells_fini(&c);
}

static void test_sizes_refused(void **state) {
    (void)state;
    struct cr_cells c;
    struct cr_error err;
    assert_int_equal(cr_cells_new(0, 5, &c, &err), CR_ERR_RANGE);
    assert_int_equal(cr_cells_new(5, 100000, &c, &err), CR_ERR_RANGE);
    assert_null(c.cell);
}

/* A name from a scene file must not be able to steer the terminal. */
static void test_control_characters(void **state) {
    (void)state;
    struct cr_cells c = grid(12, 1);
    cr_cells_print(&c, 0, 0, 0, CR_ROLE_TEXT, "a\033[2Jb\tc\xff\xc2\x9b");
    char *got = text_of(&c, (struct cr_look){.color = CR_COLOR_NONE});
    for (const char *p = got; *p != '\0'; p++) {
        assert_true(*p == '\n' || (unsigned char)*p >= 32);
    }
    assert_null(strstr(got, "\xc2\x9b"));
    free(got);
    cr_cells_fini(&c);
}

static void test_wide_characters(void **state) {
    (void)state;
    struct cr_cells c = grid(6, 2);
    assert_int_equal(cr_glyph_width("\u65e5\u672c"), 4);
    assert_int_equal(cr_glyph_width("e\u0301"), 1);
    assert_int_equal(cr_cells_print(&c, 0, 0, 0, CR_ROLE_TEXT, "\u65e5\u672cx"), 5);
    /* a wide character that does not fit beside the cut mark is left out whole */
    assert_int_equal(cr_cells_print(&c, 0, 1, 4, CR_ROLE_TEXT, "\u65e5\u672c\u65e5"), 3);
    check_text(&c, (struct cr_look){0}, "\u65e5\u672cx\n\u65e5~\n");
    check_text(&c, (struct cr_look){.ascii = true}, "????x\n??~\n");
    cr_cells_fini(&c);
}

static void test_ascii_has_no_other(void **state) {
    (void)state;
    for (uint32_t ch = 1; ch < 0x3000; ch++) {
        char a = cr_glyph_ascii(ch);
        assert_true(a >= 32 && a < 127);
    }
    assert_int_equal(cr_glyph_ascii(0xD7), 'x');
    /* the console keeps frames and blocks */
    assert_int_equal(cr_glyph_console('x'), 'x');
    assert_int_equal(cr_glyph_console(0x2592), 0x2592);
    assert_int_equal(cr_glyph_console(0x250C), 0x250C);
    assert_int_equal(cr_glyph_console(0x2581), '_');
    assert_int_equal(cr_glyph_console(0x2587), 0x2588);
    assert_int_equal(cr_glyph_console(0x2809), '\''); /* two dots in the top row */
    assert_int_equal(cr_glyph_console(0x28C0), '.');  /* in the bottom row */
    assert_int_equal(cr_glyph_console(0x28FF), ':');
    assert_int_equal(cr_glyph_console(0x2501), '=');
    assert_int_equal(cr_glyph_ascii(0x2500), '-');
}

static void test_colour_text(void **state) {
    (void)state;
    struct cr_cells c = grid(4, 1);
    cr_cells_put(&c, 0, 0, CR_ROLE_CRUSHED, 'x');
    char *plain = text_of(&c, (struct cr_look){.color = CR_COLOR_NONE});
    assert_string_equal(plain, "x\n");
    char *full = text_of(&c, (struct cr_look){.color = CR_COLOR_256});
    assert_non_null(strstr(full, "38;5;"));
    assert_non_null(strstr(full, "x\033[0m\n"));
    char *few = text_of(&c, (struct cr_look){.color = CR_COLOR_16});
    assert_null(strstr(few, "38;5;"));
    assert_non_null(strstr(few, "\033["));
    free(plain);
    free(full);
    free(few);
    cr_cells_fini(&c);
}

/* a theme with its own ground paints whole rows, the others leave blanks alone */
static void test_ground_of_a_theme(void **state) {
    (void)state;
    struct cr_cells c = grid(5, 1);
    cr_cells_put(&c, 0, 0, CR_ROLE_TEXT, 'x');
    struct cr_look look = {.color = CR_COLOR_256, .theme = cr_theme_find("contrast")};
    char *got = text_of(&c, look);
    assert_non_null(strstr(got, "x    \033[0m\n"));
    assert_non_null(strstr(got, "48;5;16"));
    free(got);
    look.theme = cr_theme_find("dark");
    got = text_of(&c, look);
    assert_string_equal(got, "x\n");
    free(got);
    cr_cells_fini(&c);
}

static void test_mono_theme_has_no_colour(void **state) {
    (void)state;
    const struct cr_theme *mono = cr_theme_find("mono");
    assert_non_null(mono);
    for (int i = 0; i < CR_ROLES; i++) {
        assert_int_equal(mono->role[i].fg256, -1);
        assert_int_equal(mono->role[i].bg16, -1);
    }
    assert_null(cr_theme_find("nosuch"));
    assert_ptr_equal(cr_theme_get(0), cr_theme_find("auto"));
    assert_true(cr_theme_count() >= 5);
}

/* relative luminance of an entry of the xterm palette (6x6x6 cube and greys, IEC 61966-2-1 sRGB) */
static double luminance(int i) {
    static const int level[] = {0, 95, 135, 175, 215, 255};
    double rgb[3], y = 0;
    static const double weight[] = {0.2126, 0.7152, 0.0722};
    assert_true(i >= 16 && i <= 255);
    for (int k = 0; k < 3; k++) {
        int v = i >= 232 ? 8 + 10 * (i - 232)
                         : level[k == 0   ? (i - 16) / 36
                                 : k == 1 ? (i - 16) / 6 % 6
                                          : (i - 16) % 6];
        rgb[k] = v / 255.0;
        rgb[k] = rgb[k] <= 0.04045 ? rgb[k] / 12.92 : pow((rgb[k] + 0.055) / 1.055, 2.4);
        y += weight[k] * rgb[k];
    }
    return y;
}

/* CIE L* */
static double lightness(int i) {
    double y = luminance(i);
    return y > 0.008856 ? 116 * cbrt(y) - 16 : 903.3 * y;
}

static void test_colour_maps_rise(void **state) {
    (void)state;
    for (int map = 0; map < CR_COLORMAPS; map++) {
        double last = -1;
        for (int step = 1; step <= CR_STEPS; step++) {
            double l = lightness(cr_theme_ramp((enum cr_colormap)map, CR_COLOR_256, step));
            if (!(l > last + 2)) {
                fail_msg("map %d step %d: L* %.1f after %.1f", map, step, l, last);
            }
            last = l;
        }
    }
    /* [COLOUR-RAMP] gives L* 8 for the first and 87 for the last step of viridis */
    /* what is beyond the scale is a colour: no grey (232..255, equal parts of the cube), no step */
    for (int i = 0; i < cr_theme_count(); i++) {
        int beyond = cr_theme_get(i)->beyond256, c = beyond - 16;
        if (beyond < 0) {
            continue; /* without colours it has a glyph */
        }
        assert_true(beyond < 232 && !(c / 36 == c / 6 % 6 && c / 6 % 6 == c % 6));
        for (int step = 1; step <= 8 * CR_COLORMAPS; step++) {
            assert_int_not_equal(beyond, cr_theme_ramp((enum cr_colormap)((step - 1) / 8),
                                                       CR_COLOR_256, 1 + (step - 1) % 8));
        }
    }
    check_near(lightness(cr_theme_ramp(CR_COLORMAP_VIRIDIS, CR_COLOR_256, 1)), 8, 1);
    check_near(lightness(cr_theme_ramp(CR_COLORMAP_VIRIDIS, CR_COLOR_256, 8)), 87, 1);
}

/* every word can be read on the backgrounds that a theme is for: contrast ratio of WCAG 2.1 */
static void test_themes_can_be_read(void **state) {
    (void)state;
    static const struct {
        const char *theme;
        int ground;
    } rows[] = {{"auto", 16},   {"auto", 231},  {"dark", 16},     {"dark", 234},
                {"light", 231}, {"light", 254}, {"contrast", 16}, {"contrast", 231}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct cr_theme *theme = cr_theme_find(rows[i].theme);
        for (int r = 0; r < CR_ROLES; r++) {
            const struct cr_style *s = &theme->role[r];
            int ground = s->bg256 >= 0 ? s->bg256 : rows[i].ground;
            if (s->fg256 < 0) { /* the terminal's own word on its own ground */
                assert_true(s->bg256 < 0);
                continue;
            }
            double a = luminance(s->fg256) + 0.05, b = luminance(ground) + 0.05;
            double ratio = a > b ? a / b : b / a;
            if (!(ratio >= 3)) {
                fail_msg("%s, role %d on %d: contrast %.2f", rows[i].theme, r, ground, ratio);
            }
        }
    }
}

static void test_shades(void **state) {
    (void)state;
    assert_int_equal(cr_glyph_shade(0, false), 0x2591);
    assert_int_equal(cr_glyph_shade(0.99, false), 0x2588);
    assert_int_equal(cr_glyph_shade(7, true), '@');
    assert_int_equal(cr_glyph_shade(-1, true), '.');
    assert_int_equal(cr_shade_step(0), 1);
    assert_int_equal(cr_shade_step(0.49), 4);
    assert_int_equal(cr_shade_step(1), CR_STEPS);
}

static void test_arrows(void **state) {
    (void)state;
    assert_int_equal(cr_glyph_arrow(0, false), 0x2192);
    assert_int_equal(cr_glyph_arrow(CR_PI / 2, false), 0x2191);
    assert_int_equal(cr_glyph_arrow(CR_PI, false), 0x2190);
    assert_int_equal(cr_glyph_arrow(-CR_PI / 2, false), 0x2193);
    assert_int_equal(cr_glyph_arrow(9 * CR_PI / 4, false), 0x2197);
    assert_int_equal(cr_glyph_arrow(CR_PI, true), '<');
}

static void test_ticks(void **state) {
    (void)state;
    check_near(cr_tick_step(10, 5), 2, 1e-12);
    check_near(cr_tick_step(100, 5), 20, 1e-12);
    check_near(cr_tick_step(0.07, 7), 0.01, 1e-12);
    check_near(cr_tick_step(59.5, 7), 10, 1e-12);
    check_near(cr_tick_step(45, 3), 20, 1e-12);
    for (double span = 1e-6; span < 1e9; span *= 1.37) {
        for (int most = 1; most < 12; most++) {
            double step = cr_tick_step(span, most),
                   digit = step / pow(10, floor(log10(step) + 1e-9));
            assert_true(fabs(digit - 1) < 1e-6 || fabs(digit - 2) < 1e-6 || fabs(digit - 5) < 1e-6);
            assert_true(span / step <= most + 1e-6);
            assert_true(span / step > most / 2.6 || most == 1);
        }
    }
    char buf[32];
    struct cr_ticks ticks = cr_ticks(-0.3, 0.3, 0.1);
    assert_int_equal(ticks.n, 7);
    check_near(cr_tick_at(&ticks, 0), -0.3, 1e-12);
    check_near(cr_tick_at(&ticks, 6), 0.3, 1e-12);
    ticks = cr_ticks(0.5, 1.5, 2);
    assert_int_equal(ticks.n, 0);
    ticks = cr_ticks((double)NAN, 1, 2);
    assert_int_equal(ticks.n, 0);
    ticks = cr_ticks(1e17, 1e17 + 16, 2); /* 1e17 + 2 is 1e17 in double precision */
    assert_in_range(ticks.n, 1, 10);
    ticks = cr_ticks(0, 1, 1e-300);
    assert_in_range(ticks.n, 1, 1000);
    cr_tick_text(-1e-17, 0.5, buf, sizeof buf);
    assert_string_equal(buf, "0.0");
    cr_tick_text(40, 20, buf, sizeof buf);
    assert_string_equal(buf, "40");
}

static void test_dots(void **state) {
    (void)state;
    struct cr_dots dots;
    struct cr_error err;
    struct cr_cells c = grid(3, 2);
    assert_int_equal(cr_dots_new(3, 2, &dots, &err), CR_ERR_OK);
    struct cr_pen pen = {.role = CR_ROLE_A, .mark = '*'};
    cr_dots_line(&dots, (int[2]){0, 0}, (int[2]){5, 0}, &pen);
    cr_dots_set(&dots, 0, 7, CR_ROLE_A, '*');
    cr_dots_set(&dots, -1, 0, CR_ROLE_A, '*');
    cr_dots_set(&dots, 6, 8, CR_ROLE_A, '*');
    cr_cells_put(&c, 1, 0, CR_ROLE_TEXT, 'T');
    cr_dots_draw(&dots, &c, 0, 0, false);
    /* upper two dots are 0x09, the lower left one is 0x40; what is written stays */
    check_text(&c, (struct cr_look){0}, "\u2809T\u2809\n\u2840\n");
    cr_dots_fini(&dots);
    cr_cells_fini(&c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_print_and_cut),
        cmocka_unit_test(test_sizes_refused),
        cmocka_unit_test(test_control_characters),
        cmocka_unit_test(test_wide_characters),
        cmocka_unit_test(test_ascii_has_no_other),
        cmocka_unit_test(test_colour_text),
        cmocka_unit_test(test_ground_of_a_theme),
        cmocka_unit_test(test_mono_theme_has_no_colour),
        cmocka_unit_test(test_themes_can_be_read),
        cmocka_unit_test(test_colour_maps_rise),
        cmocka_unit_test(test_shades),
        cmocka_unit_test(test_arrows),
        cmocka_unit_test(test_ticks),
        cmocka_unit_test(test_dots),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
