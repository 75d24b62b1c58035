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

/* energy of the columns within depth behind the front end */
static double front_energy(const struct cr_grid *g, int columns) {
    double sum = 0;
    for (int iy = 0; iy < g->ny; iy++) {
        for (int ix = g->nx - columns; ix < g->nx; ix++) {
            sum += g->energy[iy * g->nx + ix];
        }
    }
    return sum;
}

/* Sedan, 0.5 m by frontal wall: EES = 23.7 1/s * 0.5 m up to the knot at 0.8 m, so
 * E = 1666 kg / 2 * (11.85 m/s)^2 = 116.97 kJ, at any voxel size. */
static void test_front_energy(void **state) {
    static const double voxel[] = {0.0125, 0.025, 0.05, 0.1};
    (void)state;
    for (int i = 0; i < 4; i++) {
        struct cr_model_query q = query_of(CR_TYPE_SEDAN, 12, voxel[i]);
        struct cr_arena arena = {0};
        struct cr_grid g;
        struct cr_error err;
        assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, &err), CR_ERR_OK);
        check_near(front_energy(&g, (int)(0.5 / voxel[i] + 0.5)), 1666 / 2.0 * 11.85 * 11.85,
                   1e-9 * 116970);
        cr_arena_free(&arena);
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
        cmocka_unit_test(test_front_energy),
        cmocka_unit_test(test_symmetric_bits),
    };
    return cmocka_run_group_tests(tests, open_lib, close_lib);
}
