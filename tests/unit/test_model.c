/* Tests of src/model: energy of faces, conservation, symmetry, reading of recipes. */
#include "config.h"

#include "model_lib.h"
#include "test.h"

#include "base/file.h"
#include "base/vec.h"
#include "model/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void test_types(void **state) {
    (void)state;
    assert_string_equal(cr_type_word(CR_TYPE_STATION_WAGON), "station-wagon");
    assert_int_equal(cr_type_find("suv"), CR_TYPE_SUV);
    assert_int_equal(cr_type_find("lorry"), -1);
    assert_int_equal(cr_pdof_clock(0), 12);
    assert_int_equal(cr_pdof_clock(CR_PI / 2), 3);
    assert_int_equal(cr_pdof_clock(-CR_PI / 6), 11);
    assert_int_equal(cr_pdof_clock(cr_rad(14.9)), 12);
    assert_int_equal(cr_pdof_clock(cr_rad(15.1)), 1);
    assert_int_equal(cr_pdof_clock(cr_rad(-345.1)), 12);
    assert_int_equal(cr_pdof_clock(cr_rad(719)), 12);
    for (int deg = 0; deg <= 180; deg += 15) { /* half hours too: left is as right */
        int right = cr_pdof_clock(cr_rad(deg)), left = cr_pdof_clock(cr_rad(-deg));
        assert_int_equal(left % 12, (12 - right) % 12);
        assert_int_equal(cr_pdof_clock(cr_rad(360 - deg)), left);
    }
}

/* 1/2 m EES(d)^2 from the knots of the recipe, between them linear in EES (front, rear) */
static double wanted(const struct cr_model_face *f, double mass, double depth) {
    int i = 0;
    while (i + 2 < f->ees.n && depth > f->ees.x[i + 1]) {
        i++;
    }
    double u = (depth - f->ees.x[i]) / (f->ees.x[i + 1] - f->ees.x[i]);
    double a = f->ees.y[i], b = f->ees.y[i + 1];
    double v2 = f->energy_linear ? a * a + u * (b * b - a * a) : pow(a + u * (b - a), 2);
    return 0.5 * mass * v2;
}

/* energy of the first n layers behind a face */
static double face_energy(const struct cr_grid *g, enum cr_face face, int n) {
    double sum = 0;
    for (int iy = 0; iy < g->ny; iy++) {
        for (int ix = 0; ix < g->nx; ix++) {
            int layer[CR_FACES] = {g->nx - 1 - ix, g->ny - 1 - iy, ix, iy};
            sum += layer[face] < n ? g->energy[iy * g->nx + ix] : 0;
        }
    }
    return sum;
}

/* All models, three voxel sizes: crushing the whole loaded face to depth d costs 1/2 m EES(d)^2.
 * The reference vehicles are put on dimensions that are whole numbers of voxels, so that a layer
 * is a layer at both ends and flanks. */
static void test_face_energy(void **state) {
    static const double voxel[] = {0.0125, 0.025, 0.05};
    static const enum cr_face loaded[13] = {
        [12] = CR_FACE_FRONT, [1] = CR_FACE_FRONT, [11] = CR_FACE_FRONT, [2] = CR_FACE_RIGHT,
        [3] = CR_FACE_RIGHT,  [4] = CR_FACE_RIGHT, [5] = CR_FACE_REAR,   [6] = CR_FACE_REAR,
        [7] = CR_FACE_REAR,   [8] = CR_FACE_LEFT,  [9] = CR_FACE_LEFT,   [10] = CR_FACE_LEFT};
    static const enum cr_model_end end[CR_FACES] = {CR_MODEL_FRONT, CR_MODEL_SIDE, CR_MODEL_REAR,
                                                    CR_MODEL_SIDE};
    (void)state;
    for (int k = 0; k < 3 * 12 * CR_TYPES; k++) {
        int clock = 1 + k / 3 % 12;
        struct cr_model_query q = query_of((enum cr_type)(k / 36), clock, voxel[k % 3]);
        struct cr_arena arena = {0};
        struct cr_grid g;
        q.dims.length = floor(q.dims.length / 0.1) * 0.1;
        double ref_width = q.dims.width;
        q.dims.width = floor(q.dims.width / 0.1) * 0.1;
        assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, NULL), CR_ERR_OK);
        const struct cr_model_face *f = cr_model_face(lib, q.type, end[loaded[clock]]);
        for (int n = 4; n * g.h < 0.45; n += 4) {
            /* front and rear overhang of the front are the reference's own, so depth is not
             * stretched there; the flank is narrower by what the width was rounded off */
            double d = n * g.h;
            if (end[loaded[clock]] == CR_MODEL_REAR) {
                double own = q.dims.length - q.dims.front_overhang - q.dims.wheelbase;
                struct cr_dims ref = *cr_model_dims(lib, q.type, NULL);
                d *= (ref.length - ref.front_overhang - ref.wheelbase) / own;
            } else if (end[loaded[clock]] == CR_MODEL_SIDE) {
                double own = (q.dims.width - q.dims.track) / 2,
                       ref = (ref_width - q.dims.track) / 2;
                d = d < own ? d * ref / own : ref + (d - own);
            }
            if (d > f->ees.x[f->ees.n - 1]) { /* the compartment, which `wanted` does not know */
                break;
            }
            check_near(face_energy(&g, loaded[clock], n) / wanted(f, q.mass_kg, d), 1, 1e-9);
        }
        cr_arena_free(&arena);
    }
}

/* A stretched vehicle: the energy per kg of all stays what it is for the reference vehicle. */
static void test_energy_per_kg_kept(void **state) {
    (void)state;
    for (int t = 0; t < CR_TYPES; t++) {
        double per_kg[2];
        for (int k = 0; k < 2; k++) {
            struct cr_model_query q = query_of((enum cr_type)t, 3 * t, 0.025);
            struct cr_arena arena = {0};
            struct cr_grid g;
            if (k == 1) {
                q.dims.length *= 1.13;
                q.dims.wheelbase *= 1.08;
                q.dims.front_overhang *= 1.2;
                q.dims.width *= 1.06;
                q.dims.track *= 1.03;
                q.mass_kg = 2222;
            }
            assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, NULL), CR_ERR_OK);
            per_kg[k] = face_energy(&g, CR_FACE_FRONT, 100000) / q.mass_kg;
            cr_arena_free(&arena);
        }
        check_near(per_kg[1] / per_kg[0], 1, 1e-12);
    }
}

/* The energy of a face pressed by `clock` o'clock of a sedan of a year. */
static double energy_built(double year, int clock, enum cr_face face) {
    struct cr_model_query q = query_of(CR_TYPE_SEDAN, clock, 0.025);
    struct cr_arena arena = {0};
    struct cr_grid g;
    q.built = year;
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, NULL), CR_ERR_OK);
    double e = face_energy(&g, face, 100000);
    cr_arena_free(&arena);
    return e;
}

/* The pole tests know old flanks and new ones; fronts are the same in all years, and a year that is
 * not known is the mean of the tests. The library keeps the substitutes of years apart. */
static void test_flanks_by_year(void **state) {
    (void)state;
    for (int t = 0; t < CR_TYPES; t++) {
        const struct cr_model_face *side = cr_model_face(lib, (enum cr_type)t, CR_MODEL_SIDE);
        double old = cr_model_built_strength(side, 2013), new = cr_model_built_strength(side, 2017);
        assert_true(old < 0.9 && new > 1);
        check_near(new / old, 2, 0.05); /* one ratio for all types */
        check_near(cr_model_built_strength(side, 1998), old, 0);
        check_near(cr_model_built_strength(side, 2024), new, 0);
        check_near(cr_model_built_strength(side, 2015), (old + new) / 2, 1e-12);
        check_near(cr_model_built_strength(side, 0), 1, 0);
        check_near(
            cr_model_built_strength(cr_model_face(lib, (enum cr_type)t, CR_MODEL_FRONT), 2013), 1,
            0);
    }
    const struct cr_model_face *side = cr_model_face(lib, CR_TYPE_SEDAN, CR_MODEL_SIDE);
    double mean = energy_built(0, 3, CR_FACE_LEFT);
    for (int year = 2012; year <= 2018; year += 3) {
        check_near(energy_built(year, 3, CR_FACE_LEFT) / mean, cr_model_built_strength(side, year),
                   1e-12);
        check_near(energy_built(year, 12, CR_FACE_FRONT), energy_built(0, 12, CR_FACE_FRONT), 0);
    }
}

static void test_symmetric_bits(void **state) {
    (void)state;
    for (int t = 0; t < CR_TYPES; t++) {
        struct cr_model_query q = query_of((enum cr_type)t, 1, 0.025);
        struct cr_arena arena = {0};
        struct cr_grid g;
        struct cr_error err;
        assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, &err), CR_ERR_OK);
        assert_true(g.y0 == -g.ny / 2 * g.h);
        for (int iy = 0; iy < g.ny / 2; iy++) {
            const size_t row = sizeof(double) * (size_t)g.nx;
            int other = g.ny - 1 - iy;
            assert_memory_equal(g.energy + iy * g.nx, g.energy + other * g.nx, row);
            assert_memory_equal(g.fill + iy * g.nx, g.fill + other * g.nx, row);
        }
        cr_arena_free(&arena);
    }
}

/* CRASH3: category 4 front, A 62.3 kN/m, B 234 kN/m2 [FRONT-DEFAULT], 1.8 m wide, residual crush
 * of 0.2 m all over: 1.8 m (12.46 + 4.68 + 8.293) kN = 45.78 kJ. As a dynamic curve the same energy
 * lies the springback deeper. */
static void test_stiffness(void **state) {
    static const struct cr_stiffness face[3] = {{62.3e3, 234e3}, {0, 0}, {0, 0}};
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct cr_model_query q = query_of(CR_TYPE_SEDAN, 12, 0.025);
        struct cr_arena arena = {0};
        struct cr_grid g;
        q.dims.width = 1.8;
        q.mass_kg = 1500;
        q.curve = k == 0 ? CR_CURVE_RESIDUAL : CR_CURVE_DYNAMIC;
        assert_int_equal(cr_model_from_stiffness(lib, &q, face, &arena, &g, NULL), CR_ERR_OK);
        double depth = 0.2 + (k == 0 ? 0 : g.springback[CR_FACE_FRONT]);
        int n = (int)(depth / 0.025);
        double below = face_energy(&g, CR_FACE_FRONT, n),
               above = face_energy(&g, CR_FACE_FRONT, n + 1);
        double u = depth / 0.025 - n;
        double want = 1.8 * (62.3e3 * 0.2 + 234e3 * 0.2 * 0.2 / 2 + 62.3e3 * 62.3e3 / (2 * 234e3));
        check_near(want, 45.78e3, 10);
        check_near(below + u * (above - below), want, k == 0 ? 1e-6 * want : 2e-3 * want);
        assert_true(k == 1 || g.springback[CR_FACE_FRONT] == 0);
        cr_arena_free(&arena);
    }
    struct cr_model_query q = query_of(CR_TYPE_SEDAN, 12, 0.025);
    struct cr_arena arena = {0};
    struct cr_grid g;
    struct cr_error err = {0};
    const struct cr_stiffness bad[3] = {{-1, 234e3}, {0, 0}, {0, 0}};
    assert_int_equal(cr_model_from_stiffness(lib, &q, bad, &arena, &g, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "front stiffness A -1"));
}

/* The residual curve is the dynamic one moved by the springback, once the first metres are passed.
 */
static void test_residual_curve(void **state) {
    (void)state;
    for (int t = 0; t < CR_TYPES; t++) {
        struct cr_model_query q = query_of((enum cr_type)t, 12, 0.025);
        struct cr_arena arena = {0};
        struct cr_grid g;
        q.curve = CR_CURVE_RESIDUAL;
        assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, NULL), CR_ERR_OK);
        const struct cr_model_face *f = cr_model_face(lib, q.type, CR_MODEL_FRONT);
        double want = wanted(f, q.mass_kg, 0.4 + f->springback);
        check_near(face_energy(&g, CR_FACE_FRONT, 16), want, 1e-9 * want);
        check_near(face_energy(&g, CR_FACE_FRONT, 0), 0, 0);
        cr_arena_free(&arena);
    }
}

/* What is below a height and what is above it are together the whole; bumper and rails of a sedan
 * lie between 0.33 and 0.58 m with two thirds of the front's energy [FRONT-GRID]. */
static void test_heights(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_grid part[3], whole;
    struct cr_model_query q = query_of(CR_TYPE_SEDAN, 12, 0.025);
    static const double cut[] = {0, 0.33, 0.58, 99};
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &whole, NULL), CR_ERR_OK);
    for (int k = 0; k < 3; k++) {
        q.z_lo = cut[k];
        q.z_hi = cut[k + 1];
        assert_int_equal(cr_model_substitute(lib, &q, &arena, &part[k], NULL), CR_ERR_OK);
    }
    for (int i = 0; i < whole.nx * whole.ny; i++) {
        double sum = part[0].energy[i] + part[1].energy[i] + part[2].energy[i];
        check_near(sum, whole.energy[i], 1e-12 * (1 + whole.energy[i]));
        assert_true(part[1].fill[i] >= 0 && part[1].fill[i] <= whole.fill[i]);
    }
    double share =
        face_energy(&part[1], CR_FACE_FRONT, 30) / face_energy(&whole, CR_FACE_FRONT, 30);
    check_near(share, 0.62, 0.05);
    /* nothing of a car is above its roof */
    q.z_lo = 2;
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &part[0], NULL), CR_ERR_OK);
    check_near(face_energy(&part[0], CR_FACE_FRONT, 100000), 0, 0);
    cr_arena_free(&arena);
}

/* Half way between the middles of two sectors: the mean of both models. */
static void test_blend(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_grid one, two, mixed;
    struct cr_model_query q = query_of(CR_TYPE_COMPACT, 1, 0.05);
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &one, NULL), CR_ERR_OK);
    q.pdof = 2 * CR_PI / 6;
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &two, NULL), CR_ERR_OK);
    q.pdof = 1.5 * CR_PI / 6;
    q.blend = true;
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &mixed, NULL), CR_ERR_OK);
    for (int i = 0; i < one.nx * one.ny; i++) {
        double mean = (one.energy[i] + two.energy[i]) / 2;
        check_near(mixed.energy[i], mean, 1e-12 * (1 + mean));
    }
    cr_arena_free(&arena);
}

static void test_queries_refused(void **state) {
    (void)state;
    struct cr_arena arena = {0};
    struct cr_grid g;
    struct cr_error err = {0};
    struct cr_model_query q = query_of(CR_TYPE_SUV, 12, 0.025);
    q.mass_kg = 0;
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "mass 0 kg"));
    q = query_of(CR_TYPE_SUV, 12, NAN);
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, &err), CR_ERR_RANGE);
    q = query_of(CR_TYPE_SUV, 12, 0.025);
    q.dims.wheelbase = q.dims.length;
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "rear end"));
    q = query_of(CR_TYPE_SUV, 12, 0.025);
    q.dims.track = q.dims.width + 0.1;
    assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "flank"));
}

/* ---- recipes that are wrong ---- */

/* The sedan's recipe with one text in place of another, read from a folder of its own: by a grid
 * that is asked for, while that of another type can still be had. */
static enum cr_err read_changed(const char *from, const char *to, struct cr_error *err) {
    const char *dir = "test_model.tmp";
    enum cr_err code = CR_ERR_OK;
    mkdir(dir, 0700);
    for (int i = 0; i < CR_TYPES; i++) {
        char path[600], *text = NULL;
        size_t len = 0;
        struct cr_str out = {0};
        const char *word = cr_type_word((enum cr_type)i);
        snprintf(path, sizeof path, "%s/models/%s.json", getenv("SRC"), word);
        assert_int_equal(cr_file_read(path, &text, &len, NULL), CR_ERR_OK);
        const char *at = i == CR_TYPE_SEDAN ? strstr(text, from) : NULL;
        assert_true(i != CR_TYPE_SEDAN || at != NULL);
        cr_str_addn(&out, text, at != NULL ? (size_t)(at - text) : len);
        if (at != NULL) {
            cr_str_add(&out, to);
            cr_str_add(&out, at + strlen(from));
        }
        snprintf(path, sizeof path, "%s/%s.json", dir, word);
        assert_int_equal(cr_file_write(path, out.s, out.len, NULL), CR_ERR_OK);
        cr_str_fini(&out);
        free(text);
    }
    struct cr_model_lib *other = NULL;
    assert_int_equal(cr_model_lib_open(dir, &other, err), CR_ERR_OK);
    struct cr_arena arena = {0};
    struct cr_grid g;
    struct cr_model_query q = query_of(CR_TYPE_SUV, 12, 0.05);
    assert_int_equal(cr_model_substitute(other, &q, &arena, &g, NULL), CR_ERR_OK);
    q = query_of(CR_TYPE_SEDAN, 12, 0.05);
    code = cr_model_need_all(other, err);
    assert_int_equal(cr_model_substitute(other, &q, &arena, &g, err), code);
    cr_arena_free(&arena);
    cr_model_lib_free(other);
    for (int i = 0; i < CR_TYPES; i++) {
        char path[600];
        snprintf(path, sizeof path, "%s/%s.json", dir, cr_type_word((enum cr_type)i));
        remove(path);
    }
    rmdir(dir);
    return code;
}

/* Force of the layer at a depth of n voxels behind the foremost, over the whole width of a face, N.
 */
static double layer_force(const struct cr_grid *g, enum cr_face face, int n) {
    bool end = face == CR_FACE_FRONT || face == CR_FACE_REAR;
    bool high = face == CR_FACE_FRONT || face == CR_FACE_LEFT;
    int along = high ? (end ? g->nx : g->ny) - 1 - n : n;
    double sum = 0;
    for (int i = 0; i < (end ? g->ny : g->nx); i++) {
        sum += end ? g->energy[i * g->nx + along] : g->energy[along * g->nx + i];
    }
    return sum / g->h;
}

/* Two structures in series have one history only where neither force falls with depth (which gives
 * way would be chance): none does, of all models, from the front to the rear end of the
 * compartment, from the rear and the flanks to the middle. Recipes are written with four digits of
 * depth and six of EES. */
static void test_no_force_falls_with_depth(void **state) {
    static const enum cr_face loaded[12] = {
        CR_FACE_FRONT, CR_FACE_FRONT, CR_FACE_RIGHT, CR_FACE_RIGHT, CR_FACE_RIGHT, CR_FACE_REAR,
        CR_FACE_REAR,  CR_FACE_REAR,  CR_FACE_LEFT,  CR_FACE_LEFT,  CR_FACE_LEFT,  CR_FACE_FRONT};
    (void)state;
    for (int type = 0; type < CR_TYPES; type++) {
        for (int clock = 12; clock < 24; clock++) {
            struct cr_model_query q =
                query_of((enum cr_type)type, clock == 12 ? 12 : clock - 12, 0.025);
            enum cr_face face = loaded[clock - 12];
            struct cr_arena arena = {0};
            struct cr_grid g;
            assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, NULL), CR_ERR_OK);
            bool end = face == CR_FACE_FRONT || face == CR_FACE_REAR;
            /* a front through the whole compartment, to where the rear begins */
            const struct cr_model_knots *rear =
                &cr_model_face(lib, (enum cr_type)type, CR_MODEL_REAR)->ees;
            double compartment = q.dims.length - rear->x[rear->n - 1] - 2 * g.h;
            int layers = face == CR_FACE_FRONT ? (int)(compartment / g.h)
                         : end                 ? g.nx / 2
                                               : g.ny / 2;
            /* the last voxel of a grid hangs over the outline in part, at one end or both */
            for (int n = 2; n + 1 < layers; n++) {
                double before = layer_force(&g, face, n - 1), force = layer_force(&g, face, n);
                if (force < before * (1 - 5e-4)) {
                    fail_msg("%s/%d: %g kN at %g m, %g kN behind it",
                             cr_type_word((enum cr_type)type), clock - 12, before / 1e3,
                             (n - 0.5) * g.h, force / 1e3);
                }
            }
            cr_arena_free(&arena);
        }
    }
}

static void test_recipes_refused(void **state) {
    static const struct {
        const char *from, *to;
        enum cr_err code;
        const char *where, *says;
    } bad[] = {
        {"\"mass_kg\": 1666", "\"mass_kg\": -1", CR_ERR_RANGE, "/reference/mass_kg",
         "-1 is outside"},
        {"\"mass_kg\": 1666,", "", CR_ERR_MISSING, "/reference/mass_kg", "missing"},
        {"\"drag_bend_per_m\": 2.4,", "", CR_ERR_MISSING, "/faces/front/drag_slope", "missing"},
        {"\"between\": \"energy\"", "\"between\": \"enery\"", CR_ERR_NAME, "/faces/front/between",
         "energy"},
        {"\"front_m\": [[0, 0]", "\"front_m\": [[0, 0.1]", CR_ERR_MODEL, "/shape/front_m",
         "[0, 0]"},
        {"\"lateral\": 0.2 }", "\"latreal\": 0.2 }", CR_ERR_KEY, "/structures/0/latreal",
         "lateral"},
        {"\"depth_m_ees_kmh\": [[0, 0], ", "\"depth_m_ees_kmh\": [[0, 0], [0.01, 500], ",
         CR_ERR_MODEL, "/faces/front/depth_m_ees_kmh", "never fall"},
        {"\"built_strength\": [[2013, 0.", "\"built_strength\": [[2013, 70.", CR_ERR_RANGE,
         "/faces/side/built_strength", "0.1 to 10"},
        {"\"built_strength\": [[2013, ", "\"built_strength\": [[2018, ", CR_ERR_RANGE,
         "/faces/side/built_strength", "increase"},
        {"\"body_weight\": {", "\"body_weight\": [", CR_ERR_SYNTAX, "", ""},
        {"\"y_m\": [0, ", "\"y_m\": [9, ", CR_ERR_RANGE, "/structures/0/y_m", "9 is outside"},
        {"\"track_m\": 1", "\"track_m\": 2.2, \"x_1\": 1", CR_ERR_MODEL, "/reference", "flank"},
    };
    (void)state;
    struct cr_error err = {0};
    assert_int_equal(read_changed("\"label\"", "\"label\"", &err), CR_ERR_OK);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        memset(&err, 0, sizeof err);
        enum cr_err code = read_changed(bad[i].from, bad[i].to, &err);
        if (code != bad[i].code || strcmp(err.where, bad[i].where) != 0 ||
            strstr(err.text, bad[i].says) == NULL || err.line == 0 ||
            strstr(err.src, "sedan.json") == NULL) {
            char buf[1024];
            fail_msg("case %zu: code %d: %s", i, (int)code, cr_err_format(&err, buf, sizeof buf));
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_types),
        cmocka_unit_test(test_face_energy),
        cmocka_unit_test(test_energy_per_kg_kept),
        cmocka_unit_test(test_flanks_by_year),
        cmocka_unit_test(test_symmetric_bits),
        cmocka_unit_test(test_stiffness),
        cmocka_unit_test(test_residual_curve),
        cmocka_unit_test(test_heights),
        cmocka_unit_test(test_blend),
        cmocka_unit_test(test_queries_refused),
        cmocka_unit_test(test_no_force_falls_with_depth),
        cmocka_unit_test(test_recipes_refused),
    };
    return cmocka_run_group_tests(tests, open_lib, close_lib);
}
