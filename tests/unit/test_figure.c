/* Pictures as vectors: what must be where, measured in the numbers of the SVG. */
#include "test.h"

#include "base/vec.h"
#include "figure/pictures.h"
#include "render_double.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Read by LeakSanitizer: what fontconfig keeps of the fonts until the end is not ours to free. */
__attribute__((visibility("default"))) const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libfontconfig";
}

static char *svg_of(struct cr_canvas *canvas) {
    struct cr_str text = {0};
    struct cr_error err;
    assert_int_equal(cr_canvas_svg(canvas, "test", true, &text, &err), CR_ERR_OK);
    cr_canvas_free(canvas);
    return text.s;
}

/* x and y of the n-th <text> with exactly these words */
static bool find_text(const char *svg, const char *words, int nth, double at[2]) {
    char end[120];
    snprintf(end, sizeof end, ">%s</text>", words);
    const char *p = svg;
    for (int i = 0; (p = strstr(p, end)) != NULL; i++, p++) {
        if (i == nth) {
            const char *start = p;
            while (strncmp(start, "<text", 5) != 0) {
                start--;
            }
            return sscanf(start, "<text x=\"%lf\" y=\"%lf\"", &at[0], &at[1]) == 2;
        }
    }
    return false;
}

/* a path that is filled or drawn in this colour; *d is where its data begin */
static bool find_path(const char *svg, const char *colour, int nth, const char **d) {
    const char *p = svg;
    for (int i = 0; (p = strstr(p, colour)) != NULL; p++) {
        const char *start = p;
        while (start > svg && *start != '<') {
            start--;
        }
        if (strncmp(start, "<path", 5) == 0 && i++ == nth) {
            *d = start + strlen("<path d=\"");
            return true;
        }
    }
    return false;
}

static int points_of(const char *d, double (*at)[2], int most) {
    int n = 0;
    while (*d != '"' && n < most) {
        char *end;
        d += strspn(d, "MLCZ ");
        if (*d == '"') {
            break;
        }
        at[n][0] = strtod(d, &end);
        at[n][1] = strtod(end, &end);
        n++;
        d = end;
    }
    return n;
}

static struct cr_picture_source source_of(const struct render_double *d) {
    return (struct cr_picture_source){.result = &d->result,
                                      .body = -1,
                                      .quantity = CR_QUANTITY_AX,
                                      .view = {.field = CR_FIELD_EES,
                                               .time = NAN,
                                               .centre = {NAN, NAN},
                                               .vectors = true,
                                               .selected = -1}};
}

static char *picture(enum cr_picture which, const struct cr_picture_source *source) {
    struct cr_canvas *canvas;
    struct cr_error err;
    if (cr_picture_draw(which, source, &canvas, &err) != CR_ERR_OK) {
        fail_msg("%s: %s", cr_picture_word(which), err.text);
    }
    return svg_of(canvas);
}

/* ---- the canvas ---- */

static void test_svg(void **state) {
    (void)state;
    struct cr_canvas *c = cr_canvas_new(100, 50);
    struct cr_type_face face = {.size = 10, .ink = 0x123456};
    cr_canvas_text(c, 1.005, -0.001, &face, "<a & \"b\"> 1.5 v. \x01\xC3\x28");
    cr_canvas_text(c, 0, 0, &face, "1.2.3 and 12.5");
    cr_canvas_comma(c);
    cr_canvas_move(c, 10, 20);
    cr_canvas_line(c, 11.5, 22.25);
    cr_canvas_paint(c, &(struct cr_paint){.fill = CR_NO_INK, .line = 0xff0000, .width = 2});
    cr_canvas_paint(c, &(struct cr_paint){.fill = 0}); /* an empty path is nothing */
    char *svg = svg_of(c);
    assert_non_null(strstr(svg, "&lt;a &amp; &quot;b&quot;&gt; 1,5 v. \xEF\xBF\xBD\xEF\xBF\xBD("));
    assert_non_null(strstr(svg, ">1.2.3 and 12,5<")); /* a version is no number */
    assert_non_null(strstr(svg, "y=\"0\""));          /* not -0 */
    assert_non_null(strstr(svg, "M10 20L11.5 22.25"));
    assert_non_null(strstr(svg, "stroke=\"#ff0000\" stroke-width=\"2\""));
    assert_null(strstr(svg, "fill=\"#000000\""));
    free(svg);
}

/* Helvetica: "il" 222 each, "W" 944, digits 556 of 1000 */
static void test_width(void **state) {
    (void)state;
    struct cr_type_face face = {.size = 10};
    check_near(cr_text_width(&face, "ilW0"), (222 + 222 + 944 + 556) / 100.0, 1e-9);
    check_near(cr_text_width(&face, "\xC3\xBC"), 5.56, 1e-9); /* one letter, not two */
    face.mono = true;
    check_near(cr_text_width(&face, "ilW0"), 24, 1e-9);
}

/* ---- the scene ---- */

/* distances on the paper are those of the world: the grid's numbers are the scale */
static void test_plan_is_to_scale(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_picture_source source = source_of(&d);
    char *svg = picture(CR_PICTURE_CONTACT, &source);
    double x1[2], x2[2], a[2], b[2];
    assert_true(find_text(svg, "1", 0, x1) && find_text(svg, "2", 0, x2));
    assert_true(find_text(svg, "A", 0, a) && find_text(svg, "B", 0, b));
    double k = x2[0] - x1[0]; /* points per m */
    assert_true(k > 10);
    /* at first contact the CGs are half of both lengths apart, and B is 0.9 m to the left */
    check_near((b[0] - a[0]) / k, 0.5 * (5.0 + 3.6), 0.002);
    check_near((a[1] - b[1]) / k, 0.9, 0.002);
    /* the firm outline of A is as long and wide as A */
    const char *data = NULL;
    static double at[4000][2];
    assert_true(find_path(svg, "stroke=\"#0072b2\" stroke-width=\"1.2\"", 0, &data));
    int n = points_of(data, at, 4000);
    double lo = INFINITY, hi = -INFINITY;
    for (int i = 0; i < n; i++) {
        lo = fmin(lo, at[i][0]);
        hi = fmax(hi, at[i][0]);
    }
    check_near((hi - lo) / k, 5.0, 0.06); /* a voxel is 0.05 m */
    free(svg);
    render_double_fini(&d);
}

static void test_plan_says_what_happened(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_picture_source source = source_of(&d);
    char *before = picture(CR_PICTURE_BEFORE, &source);
    char *engaged = picture(CR_PICTURE_ENGAGED, &source);
    char *after = picture(CR_PICTURE_AFTER, &source);
    assert_non_null(strstr(before, ">Before: 100 ms before first contact</text>"));
    assert_null(strstr(before, ">crushed</text>"));
    assert_non_null(strstr(engaged, ">Greatest engagement: 70.0 ms after first contact</text>"));
    assert_non_null(strstr(engaged, ">force "));
    assert_non_null(strstr(after, ">After: 80.0 ms after first contact</text>"));
    assert_non_null(strstr(after, ">crushed</text>"));
    assert_non_null(strstr(after, ">induced</text>"));
    assert_null(strstr(after, ">force ")); /* after the crash there is none */
    assert_non_null(strstr(after, ">N</text>"));
    assert_non_null(strstr(after, ">1 m</text>"));
    assert_non_null(strstr(after, "A  suv 2400 kg"));
    free(before);
    free(engaged);
    free(after);
    render_double_fini(&d);
}

static void test_plan_of_a_wall(void **state) {
    (void)state;
    struct render_double d;
    render_double_wall(&d);
    struct cr_picture_source source = source_of(&d);
    char *svg = picture(CR_PICTURE_AFTER, &source);
    const char *data = NULL;
    double at[8][2];
    assert_true(find_path(svg, "fill=\"#e6e6e6\"", 0, &data));
    assert_true(points_of(data, at, 8) >= 4);
    free(svg);
    render_double_fini(&d);
}

/* ---- curves ---- */

/* the half sine of 200 m/s2 of A, unfiltered as force: its peak is 2400 kg * 200 m/s2 = 480 kN */
static void test_plot_is_to_scale(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_picture_source source = source_of(&d);
    source.quantity = CR_QUANTITY_FORCE;
    char *svg = picture(CR_PICTURE_PULSE, &source);
    double low[2], high[2], t20[2], t40[2];
    static double at[600][2];
    const char *data = NULL;
    assert_true(find_text(svg, "200", 0, low) && find_text(svg, "400", 0, high));
    assert_true(find_text(svg, "20", 0, t20) && find_text(svg, "40", 0, t40));
    /* the first is the line of the legend */
    assert_true(find_path(svg, "stroke=\"#0072b2\" stroke-width=\"1.3\"", 1, &data));
    int n = points_of(data, at, 600), best = 0;
    for (int i = 0; i < n; i++) {
        best = at[i][1] < at[best][1] ? i : best;
    }
    double per_kn = (low[1] - high[1]) / 200, per_ms = (t40[0] - t20[0]) / 20;
    check_near((high[1] - 2.8 - at[best][1]) / per_kn + 400, 480, 2);
    check_near((at[best][0] - t40[0]) / per_ms + 40, 40, 0.6);
    free(svg);
    render_double_fini(&d);
}

/* ---- charts ---- */

static void test_histogram(void **state) {
    (void)state;
    static const int count[4] = {10, 40, 20, 0};
    static const double mark[1] = {2};
    static const char *const name[1] = {"median"};
    struct cr_histogram h = {"delta-v", "km/h", 4, 0, 4, count, 1, mark, name, NAN};
    struct cr_canvas *c = cr_canvas_new(300, 200);
    cr_figure_histogram(c, (struct cr_box){0, 0, 300, 200}, &h, NULL);
    char *svg = svg_of(c);
    const char *data = NULL;
    double at[16][2], ten[2], median[2];
    assert_true(find_path(svg, "fill=\"#a5d785\"", 0, &data));
    assert_int_equal(points_of(data, at, 16), 12); /* three bars; no bar for nothing */
    double high[3];
    for (int i = 0; i < 3; i++) {
        high[i] = at[4 * i + 2][1] - at[4 * i][1];
    }
    check_near(high[1] / high[0], 4, 0.02);
    check_near(high[2] / high[0], 2, 0.02);
    assert_true(find_text(svg, "median 2", 0, median));
    check_near(median[0], at[8][0], 0.02); /* the left edge of the third bar is at 2 */
    assert_true(find_text(svg, "1", 0, ten));
    check_near(ten[0], at[4][0], 0.02);
    free(svg);
}

static void test_tornado(void **state) {
    (void)state;
    static const struct cr_tornado_bar bar[2] = {{"A.speed", 46, 54}, {"stiffness", 52, 49}};
    struct cr_tornado t = {"EES of A", "km/h", 50, 2, bar};
    struct cr_canvas *c = cr_canvas_new(400, 200);
    cr_figure_tornado(c, (struct cr_box){0, 0, 400, 200}, &t, NULL);
    char *svg = svg_of(c);
    double p46[2], p50[2], low[2][2], at[2][5][2];
    const char *data = NULL;
    assert_true(find_text(svg, "46", 0, p46) && find_text(svg, "50", 0, p50));
    double k = (p50[0] - p46[0]) / 4;
    for (int i = 0; i < 2; i++) { /* pale: the lower end of the input */
        assert_true(find_path(svg, "fill=\"#d9e68c\"", i, &data));
        points_of(data, at[i], 5);
        low[i][0] = (at[i][0][0] - p50[0]) / k + 50;
        low[i][1] = (at[i][1][0] - p50[0]) / k + 50;
    }
    check_near(low[0][0], 46, 0.02);
    check_near(low[0][1], 50, 0.02);
    check_near(low[1][0], 50, 0.02); /* stiffer goes with less: the bar lies on the other side */
    check_near(low[1][1], 52, 0.02);
    free(svg);
}

static void test_scatter(void **state) {
    (void)state;
    static const double x[2] = {10, 40}, y[2] = {20, 40};
    static const int kind[2] = {1, 1};
    static const char *const kinds[2] = {"front", "pole"};
    struct cr_scatter_plot s = {
        "delta-v", "recorder, km/h", "computed, km/h", 2, 2, x, y, kind, kinds, 0.2};
    struct cr_canvas *c = cr_canvas_new(400, 300);
    cr_figure_scatter(c, (struct cr_box){0, 0, 400, 300}, &s, NULL);
    char *svg = svg_of(c);
    double at[2][5][2], line[2][2];
    const char *data = NULL;
    for (int i = 0; i < 2; i++) {
        assert_true(find_path(svg, "stroke=\"#d55e00\"", i, &data));
        assert_int_equal(points_of(data, at[i], 5), 4); /* squares */
    }
    assert_true(find_path(svg, "stroke=\"#1a1a1a\" stroke-width=\"1\"", 0, &data));
    assert_int_equal(points_of(data, line, 2), 2);
    double mx = (at[1][0][0] + at[1][1][0]) / 2, my = (at[1][0][1] + at[1][2][1]) / 2;
    double slope = (line[1][1] - line[0][1]) / (line[1][0] - line[0][0]);
    check_near(slope, -1, 0.001);                                 /* equality at 45 degrees */
    check_near(my, line[0][1] + slope * (mx - line[0][0]), 0.02); /* 40, 40 lies on it */
    assert_non_null(strstr(svg, ">\xC2\xB1"
                                "20 %</text>"));
    free(svg);
}

static void test_map(void **state) {
    (void)state;
    static const double x[2] = {1, 2}, y[2] = {10, 20}, value[4] = {1, 2, 3, NAN};
    struct cr_heat_map m = {"EES", "x", "y", 2, 2, x, y, value, 1, NULL, NULL, 0};
    struct cr_canvas *c = cr_canvas_new(300, 200);
    cr_figure_map(c, (struct cr_box){0, 0, 300, 200}, &m, NULL);
    char *svg = svg_of(c);
    double one[2], two[2], three[2], none[2];
    assert_true(find_text(svg, "1.0", 0, one) && find_text(svg, "2.0", 0, two));
    assert_true(find_text(svg, "3.0", 0, three) && find_text(svg, "-", 0, none));
    assert_true(one[0] < two[0] && one[1] == two[1]);     /* x to the right */
    assert_true(three[1] < one[1] && three[0] == one[0]); /* y up */
    assert_true(none[0] == two[0] && none[1] == three[1]);
    free(svg);
}

struct pieces {
    double level, length;
    int n;
};

/* all ends of the pieces lie where x + 2 y is the level */
static void on_plane(void *user, const double from[2], const double to[2]) {
    struct pieces *p = user;
    check_near(from[0] + 2 * from[1], p->level, 1e-12);
    check_near(to[0] + 2 * to[1], p->level, 1e-12);
    p->length += hypot(to[0] - from[0], to[1] - from[1]);
    p->n++;
}

static void count(void *user, const double from[2], const double to[2]) {
    (void)from;
    (void)to;
    ++*(int *)user;
}

/* the line x + 2 y = 3 in a grid of 4 x 3: from (3, 0) to (0, 1.5) */
static void test_contour(void **state) {
    (void)state;
    static const double x[4] = {0, 1, 2, 3}, y[3] = {0, 1, 2};
    static const char *const words[4] = {"a", "b", "c", "d"};
    double value[12], lo, hi;
    for (int i = 0; i < 12; i++) {
        value[i] = i % 4 + 2 * (i / 4);
    }
    struct cr_heat_map m = {"", "", "", 4, 3, x, y, value, 1, NULL, NULL, 0};
    struct pieces p = {.level = 3};
    cr_heat_contour(&m, 3, on_plane, &p);
    assert_true(p.n >= 5);
    check_near(p.length, hypot(3, 1.5), 1e-9);
    assert_true(cr_heat_range(&m, &lo, &hi) && lo == 0 && hi == 7);
    int n = 0;
    cr_heat_contour(&m, 7.5, count, &n);
    assert_int_equal(n, 0); /* beyond the values */
    m.x_word = words;
    cr_heat_contour(&m, 3, count, &n);
    assert_int_equal(n, 0); /* there is nothing between words */
    m.x_word = NULL;
    for (int i = 0; i < 12; i++) {
        value[i] = NAN;
    }
    cr_heat_contour(&m, 3, count, &n);
    assert_int_equal(n, 0);
    assert_false(cr_heat_range(&m, &lo, &hi));
}

/* ---- damage ---- */

static void test_damage(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    static const double measured[3] = {0.30, 0.20, 0.10};
    struct cr_picture_source source = source_of(&d);
    d.result.of[0].profile_width = 1.5;
    d.result.of[0].profile_middle = 0.2; /* left of the centre line */
    const struct cr_face_measured taken = {.face = d.result.of[0].face,
                                           .n = 3,
                                           .from = -0.6,
                                           .to = 0.4,
                                           .depth = {measured[0], measured[1], measured[2]}};
    source.measured = &taken;
    char *svg = picture(CR_PICTURE_DAMAGE, &source);
    double at[3][2], own[6][2], face[2][2];
    const char *data = NULL;
    assert_true(find_path(svg, "stroke=\"#0072b2\" stroke-width=\"1.4\"", 0, &data));
    assert_int_equal(points_of(data, own, 6), 6);
    assert_true(find_path(svg, "stroke=\"#d55e00\" stroke-width=\"1.4\"", 0, &data));
    assert_int_equal(points_of(data, at, 3), 3);
    assert_true(find_path(svg, "stroke=\"#1a1a1a\" stroke-width=\"0.8\"", 0, &data));
    assert_int_equal(points_of(data, face, 2), 2);
    double k = (face[1][0] - face[0][0]) / 2.0; /* A is 2 m wide */
    for (int i = 0; i < 3; i++) {
        check_near((at[i][1] - face[0][1]) / k, measured[i], 0.001);
    }
    double middle = (face[0][0] + face[1][0]) / 2; /* left is at the left */
    check_near((at[0][0] - middle) / k, taken.from, 0.001);
    check_near((at[2][0] - middle) / k, taken.to, 0.001);
    check_near((own[0][0] - middle) / k, -0.2 - 0.75, 0.001);
    check_near((own[5][0] - middle) / k, -0.2 + 0.75, 0.001);
    for (int i = 0; i < 6; i++) {
        check_near((own[i][1] - face[0][1]) / k, d.result.of[0].profile[i], 0.001);
    }
    assert_non_null(strstr(svg, ">measured, cm</text>"));
    free(svg);
    render_double_fini(&d);
}

/* ---- files ---- */

static void test_same_bytes(void **state) {
    (void)state;
    struct render_double d;
    render_double_init(&d);
    struct cr_picture_source source = source_of(&d);
    for (int format = 0; format < CR_PICTURE_FORMATS; format++) {
        struct cr_str text[2] = {{0}, {0}};
        struct cr_error err;
        if (format != CR_FORMAT_SVG && cr_canvas_need_cairo(NULL) != CR_ERR_OK) {
            struct cr_canvas *c = cr_canvas_new(10, 10);
            assert_int_equal(cr_picture_text(c, (enum cr_picture_format)format, "", &text[0], &err),
                             CR_ERR_USAGE);
            assert_non_null(strstr(err.hint, "libcairo2-dev"));
            cr_canvas_free(c);
            continue;
        }
        for (int i = 0; i < 2; i++) {
            struct cr_canvas *canvas;
            assert_int_equal(cr_picture_draw(CR_PICTURE_OVERVIEW, &source, &canvas, &err),
                             CR_ERR_OK);
            assert_int_equal(
                cr_picture_text(canvas, (enum cr_picture_format)format, "crash", &text[i], &err),
                CR_ERR_OK);
            cr_canvas_free(canvas);
        }
        assert_int_equal(text[0].len, text[1].len);
        assert_memory_equal(text[0].s, text[1].s, text[0].len);
        static const char *const begin[] = {"<?xml", "%PDF-1.", "\x89PNG"};
        assert_memory_equal(text[0].s, begin[format], strlen(begin[format]));
        for (int i = 0; i < 2; i++) {
            cr_str_fini(&text[i]);
        }
    }
    render_double_fini(&d);
}

static void test_errors(void **state) {
    (void)state;
    struct render_double d;
    struct cr_error err;
    struct cr_canvas *canvas;
    struct cr_picture_source none = {.body = -1};
    assert_int_equal(cr_picture_draw(CR_PICTURE_AFTER, &none, &canvas, &err), CR_ERR_MISSING);
    assert_null(canvas);
    render_double_wall(&d);
    struct cr_picture_source wall = source_of(&d);
    wall.body = 1;
    assert_int_equal(cr_picture_draw(CR_PICTURE_DAMAGE, &wall, &canvas, &err), CR_ERR_NAME);
    assert_int_equal(cr_picture_find("after"), CR_PICTURE_AFTER);
    assert_int_equal(cr_picture_find("nothing"), -1);
    assert_int_equal(cr_picture_format_of("a/b.SVG"), CR_FORMAT_SVG);
    assert_int_equal(cr_picture_format_of("b.svgz"), -1);
    render_double_fini(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_svg),
        cmocka_unit_test(test_width),
        cmocka_unit_test(test_plan_is_to_scale),
        cmocka_unit_test(test_plan_says_what_happened),
        cmocka_unit_test(test_plan_of_a_wall),
        cmocka_unit_test(test_plot_is_to_scale),
        cmocka_unit_test(test_histogram),
        cmocka_unit_test(test_tornado),
        cmocka_unit_test(test_scatter),
        cmocka_unit_test(test_map),
        cmocka_unit_test(test_contour),
        cmocka_unit_test(test_damage),
        cmocka_unit_test(test_same_bytes),
        cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
