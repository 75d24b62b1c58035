/* Tests of src/model: energy of faces, conservation, symmetry, reading of recipes. */
#include "config.h"

#include "test.h"

#include "base/vec.h"
#include "model/model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct cr_model_lib *lib;

static int open_lib(void **state) {
    char dir[512];
    struct cr_error err;
    (void)state;
    snprintf(dir, sizeof dir, "%s/models", getenv("SRC"));
    enum cr_err rc = cr_model_lib_open(dir, &lib, &err);
    if (rc) {
        char buf[768];
        print_error("%s\n", cr_err_format(&err, buf, sizeof buf));
    }
    return (int)rc;
}

static int close_lib(void **state) {
    (void)state;
    cr_model_lib_free(lib);
    return 0;
}

static struct cr_model_query query_of(enum cr_type type, int clock, double voxel) {
    struct cr_model_query q = {
        .type = type, .pdof = clock * CR_PI / 6, .voxel = voxel, .z_hi = INFINITY};
    q.dims = *cr_model_dims(lib, type, &q.mass_kg);
    return q;
}

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

/* All 72 models, three voxel sizes: crushing the whole loaded face to depth d costs 1/2 m EES(d)^2.
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
    for (int k = 0; k < 3 * 72; k++) {
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_types),
        cmocka_unit_test(test_face_energy),
        cmocka_unit_test(test_energy_per_kg_kept),
        cmocka_unit_test(test_symmetric_bits),
    };
    return cmocka_run_group_tests(tests, open_lib, close_lib);
}
