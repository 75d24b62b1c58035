/* Tests of voxel models as files: 3D models, export, import, what is refused. */
#include "config.h"

#include "model_lib.h"
#include "test.h"

#include "base/file.h"
#include "base/vec.h"
#include "model/model_priv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double sum(const double *v, size_t n) {
    double s = 0;
    for (size_t i = 0; i < n; i++) {
        s += v[i];
    }
    return s;
}

/* layers of the 3D model, summed, are the 2D substitute */
static void test_volume_sums_to_plan(void **state) {
    static const int clock[] = {12, 1, 3, 5};
    (void)state;
    for (int t = 0; t < CR_TYPES; t++) {
        struct cr_model_query q = query_of((enum cr_type)t, clock[t % 4], 0.05);
        struct cr_arena arena = {0};
        struct cr_voxels v;
        struct cr_grid g;
        assert_int_equal(cr_model_voxels(lib, &q, &arena, &v, NULL), CR_ERR_OK);
        assert_int_equal(cr_model_substitute(lib, &q, &arena, &g, NULL), CR_ERR_OK);
        assert_int_equal(v.nx, g.nx);
        assert_int_equal(v.ny, g.ny);
        size_t n = (size_t)v.nx * (size_t)v.ny;
        double whole = sum(g.energy, n);
        for (size_t i = 0; i < n; i++) {
            double column = 0;
            for (int iz = 0; iz < v.nz; iz++) {
                column += v.energy[(size_t)iz * n + i];
            }
            check_near(column, g.energy[i], 1e-14 * whole);
        }
        cr_arena_free(&arena);
    }
}

static void write_text(const char *path, const char *text, size_t len) {
    assert_int_equal(cr_file_write(path, text, len, NULL), CR_ERR_OK);
}

static void check_same(const struct cr_voxels *a, const struct cr_voxels *b) {
    size_t n = (size_t)a->nx * (size_t)a->ny * (size_t)a->nz * sizeof(double);
    assert_int_equal(a->nx, b->nx);
    assert_int_equal(a->ny, b->ny);
    assert_int_equal(a->nz, b->nz);
    assert_true(a->flat == b->flat && a->edge == b->edge && a->mass_kg == b->mass_kg);
    assert_true(a->x0 == b->x0 && a->y0 == b->y0 && a->z0 == b->z0);
    assert_memory_equal(&a->dims, &b->dims, sizeof a->dims);
    assert_memory_equal(a->drag_slope, b->drag_slope, sizeof a->drag_slope);
    assert_memory_equal(a->springback, b->springback, sizeof a->springback);
    assert_memory_equal(a->fill, b->fill, n);
    assert_memory_equal(a->energy, b->energy, n);
}

/* out and in again, 3D and 2D, JSON and CSV: every bit */
static void test_files_bit_exact(void **state) {
    (void)state;
    for (int k = 0; k < 4; k++) {
        bool flat = k % 2 == 1, csv = k >= 2;
        const char *path = csv ? "test_voxels.tmp.csv" : "test_voxels.tmp.json";
        struct cr_model_query q = query_of(CR_TYPE_COMPACT, 1 + k, flat ? 0.025 : 0.1);
        struct cr_arena arena = {0};
        struct cr_voxels v, back;
        struct cr_str text = {0};
        char hash[CR_HASH_SIZE], want[CR_HASH_SIZE];
        assert_int_equal(flat ? cr_model_flat(lib, &q, &arena, &v, NULL)
                              : cr_model_voxels(lib, &q, &arena, &v, NULL),
                         CR_ERR_OK);
        if (csv) {
            cr_voxels_csv(&v, &text);
        } else {
            cr_voxels_json(&v, "{ \"basis\": \"test\" }", &text);
        }
        assert_false(text.failed);
        write_text(path, text.s, text.len);
        assert_int_equal(cr_voxels_read(path, &arena, &back, hash, NULL), CR_ERR_OK);
        check_same(&v, &back);
        cr_hash_hex(text.s, text.len, want);
        assert_string_equal(hash, want);
        assert_string_equal(back.name, v.name);
        /* and the file as a model gives the grid of the type's own model */
        struct cr_grid own, type;
        assert_int_equal(cr_model_from_file(path, &q, &arena, &own, hash, NULL), CR_ERR_OK);
        assert_int_equal(cr_model_substitute(lib, &q, &arena, &type, NULL), CR_ERR_OK);
        size_t n = (size_t)own.nx * (size_t)own.ny;
        if (flat) {
            assert_memory_equal(own.energy, type.energy, n * sizeof(double));
            assert_memory_equal(own.fill, type.fill, n * sizeof(double));
        }
        check_near(sum(own.energy, n), sum(type.energy, n), 1e-12 * sum(type.energy, n));
        remove(path);
        cr_str_fini(&text);
        cr_arena_free(&arena);
    }
}

/* another vehicle, other voxels: energy per kg stays, so does the plan area in proportion */
static void test_own_model_stretched(void **state) {
    (void)state;
    struct cr_model_query q = query_of(CR_TYPE_SEDAN, 12, 0.05), other = q;
    struct cr_arena arena = {0};
    struct cr_voxels v;
    struct cr_grid g;
    assert_int_equal(cr_model_voxels(lib, &q, &arena, &v, NULL), CR_ERR_OK);
    size_t n = (size_t)v.nx * (size_t)v.ny * (size_t)v.nz;
    other.dims.length *= 1.1;
    other.dims.width *= 0.9;
    other.dims.wheelbase += 0.2;
    other.dims.track *= 0.93;
    other.mass_kg = 2000;
    other.voxel = 0.03;
    assert_int_equal(cr_voxels_substitute(&v, &other, &arena, &g, NULL), CR_ERR_OK);
    double want = sum(v.energy, n) * 2000 / q.mass_kg;
    check_near(sum(g.energy, (size_t)g.nx * (size_t)g.ny), want, 1e-12 * want);
    for (int i = 0; i < g.nx * g.ny; i++) {
        assert_true(g.fill[i] >= 0 && g.fill[i] <= 1);
    }
    assert_true(v.drag_slope[CR_FACE_LEFT] > 0);
    assert_memory_equal(g.drag_slope, v.drag_slope, sizeof g.drag_slope); /* lengths by lengths */
    cr_arena_free(&arena);
}

/* Four voxels of 0.5 m over the finest grid, 100 cells each: what is alike left and right stays so,
 * and each cell across has as much as the next. */
static void test_coarse_model_spread_evenly(void **state) {
    static const double fill[] = {1, 1, 1, 1}, energy[] = {8e4, 8e4, 8e4, 8e4};
    (void)state;
    struct cr_model_query q = {.mass_kg = 1400, .voxel = 0.005, .z_hi = INFINITY};
    q.dims = (struct cr_dims){4, 2, 1.5, 2.5, 1.6, 0.8, 1.2, 0.5};
    struct cr_voxels v = {.flat = true, .nx = 1, .ny = 4, .nz = 1, .edge = 0.5, .x0 = 1.5};
    struct cr_arena arena = {0};
    struct cr_grid g;
    v.y0 = -1;
    v.mass_kg = q.mass_kg;
    v.dims = q.dims;
    v.fill = fill;
    v.energy = energy;
    assert_int_equal(cr_voxels_substitute(&v, &q, &arena, &g, NULL), CR_ERR_OK);
    assert_int_equal(g.ny, 400);
    for (int iy = 0; iy < g.ny; iy++) {
        check_near(sum(g.energy + iy * g.nx, (size_t)g.nx), 4 * 8e4 / g.ny, 1e-6);
    }
    cr_arena_free(&arena);
}

/* A name that would end a quoted text or a line is cut there, so that what is written can be
 * read. */
static void test_name_can_be_written_again(void **state) {
    static const char text[] =
        "{\"crumple_voxels\": 1, \"name\": \"front\\\"B\\n\", \"edge_m\": 1, \"count\": [4, 2], "
        "\"origin_m\": [-2, -1], \"mass_kg\": 1000, \"vehicle\": {\"length_m\": 4, \"width_m\": 2, "
        "\"height_m\": 1.5, \"wheelbase_m\": 2.5, \"track_m\": 1.5, \"front_overhang_m\": 0.8, "
        "\"cg_behind_front_axle_m\": 1.2}, \"energy_J\": [1, 1, 1, 1, 1, 1, 1, 1]}";
    (void)state;
    struct cr_arena arena = {0};
    struct cr_voxels v;
    write_text("test_voxels_name.tmp.json", text, strlen(text));
    for (int i = 0; i < 3; i++) {
        const char *path = i == 2 ? "test_voxels_name.tmp.csv" : "test_voxels_name.tmp.json";
        struct cr_str out = {0};
        assert_int_equal(cr_voxels_read(path, &arena, &v, NULL, NULL), CR_ERR_OK);
        assert_string_equal(v.name, "front");
        cr_voxels_json(&v, NULL, &out);
        write_text("test_voxels_name.tmp.json", out.s, out.len);
        cr_str_clear(&out);
        cr_voxels_csv(&v, &out);
        write_text("test_voxels_name.tmp.csv", out.s, out.len);
        cr_str_fini(&out);
    }
    remove("test_voxels_name.tmp.json");
    remove("test_voxels_name.tmp.csv");
    cr_arena_free(&arena);
}

#define HEAD                                                                                       \
    "\"crumple_voxels\": 1, \"edge_m\": 1, \"count\": [4, 2], \"origin_m\": [-2, -1], "            \
    "\"mass_kg\": 1000, \"vehicle\": {\"length_m\": 4, \"width_m\": 2, \"height_m\": 1.5, "        \
    "\"wheelbase_m\": 2.5, \"track_m\": 1.5, \"front_overhang_m\": 0.8, "                          \
    "\"cg_behind_front_axle_m\": 1.2}"
#define CSV_HEAD                                                                                   \
    "# edge_m,1\n# count,4,2\n# origin_m,-2,-1\n# mass_kg,1000\n# length_m,4\n# width_m,2\n"       \
    "# height_m,1.5\n# wheelbase_m,2.5\n# track_m,1.5\n# front_overhang_m,0.8\n"                   \
    "# cg_behind_front_axle_m,1.2\n"

struct bad {
    const char *file, *text;
    enum cr_err code;
    int line;
    const char *says;
};

static const struct bad bad_file[] = {
    {"json", "{" HEAD ",\n \"energy_J\": [1,1,1,1,1,1,1]}", CR_ERR_MODEL, 2, "7 numbers"},
    {"json", "{" HEAD ",\n \"energy_J\": [1,1,1,1,1,1,1,1,1]}", CR_ERR_MODEL, 2, "more than the 8"},
    {"json", "{" HEAD ",\n\n \"energy_J\": [1,1,1,NaN,1,1,1,1]}", CR_ERR_SYNTAX, 3, "number"},
    {"json", "{" HEAD ",\n \"energy_J\": [1,1,1,-1,1,1,1,1]}", CR_ERR_MODEL, 1, "(3, 0, 0)"},
    {"json", "{" HEAD ",\n \"energy_J\": [1,1,1,1e999,1,1,1,1]}", CR_ERR_MODEL, 1, "inf"},
    {"json", "{" HEAD ",\n \"energy_J\": [0,0,0,0,0,0,0,0]}", CR_ERR_MODEL, 1, "no voxel"},
    {"json", "{" HEAD ",\n \"energy_J\": [1 1,1,1,1,1,1,1]}", CR_ERR_SYNTAX, 2, "comma"},
    {"json", "{" HEAD ", \"fill\": [1,1,1,1,1,1,1,2], \"energy_J\": [1,1,1,1,1,1,1,1]}",
     CR_ERR_MODEL, 1, "fill 2"},
    {"json", "{" HEAD "}", CR_ERR_MISSING, 1, "missing"},
    {"json", "{" HEAD ", \"energy\": [1], \"energy_J\": [1,1,1,1,1,1,1,1]}", CR_ERR_KEY, 1,
     "energy_J"},
    {"json", "[1, 2]", CR_ERR_TYPE, 1, "object"},
    {"json", "{\"crumple_voxels\": 1,\n \"edge_m\": }", CR_ERR_SYNTAX, 2, "a value is missing"},
    {"json", "", CR_ERR_SYNTAX, 1, "no text"},
    {"json", "{\"crumple_voxels\": 1, \"edge_m\": 0.01, \"count\": [1000, 1000, 1000]}",
     CR_ERR_MISSING, 1, "missing"},
    {"csv", CSV_HEAD "ix,iy,fill,energy_J\n0,0,1,-5\n", CR_ERR_MODEL, 0, "-5"},
    {"csv", CSV_HEAD "ix,iy,fill,energy_J\n0,0,1,nan\n", CR_ERR_SYNTAX, 13, "a row is"},
    {"csv", CSV_HEAD "ix,iy,fill,energy_J\n0,0,1,\n1,0,1,5\n", CR_ERR_SYNTAX, 13, "a row is"},
    {"csv", CSV_HEAD "ix,iy,fill,energy_J\n4,0,1,5\n", CR_ERR_RANGE, 13, "index"},
    {"csv", CSV_HEAD "ix,iy,fill,energy_J\n0,1,1,5\n0,1,1,6\n", CR_ERR_MODEL, 14, "already"},
    {"csv", CSV_HEAD "0,0,1,5\n", CR_ERR_SYNTAX, 12, "column names"},
    {"csv", CSV_HEAD "ix,iy,fill\n0,0,1\n", CR_ERR_SYNTAX, 12, "column names"},
    {"csv", CSV_HEAD "ix,iy,fill,energy_J\n0,0,1,5\n0,1,1\n", CR_ERR_SYNTAX, 14, "a row is"},
    {"csv", "# edge_m,1,2\nix,iy\n", CR_ERR_MODEL, 1, "wrong count"},
    {"csv", "# edge_m,1\nix,iy\n", CR_ERR_MISSING, 2, "missing"},
};

/* as a spreadsheet of another country saves it, its columns in another order: the same model */
static void test_csv_of_a_spreadsheet(void **state) {
    static const char *const text[] = {
        CSV_HEAD "# name,\"a, b\"\nix,iy,fill,energy_J\n1,0,0.5,5.25\n3,1,1,7\n",
        "# edge_m;1;;\r\n# count;4;2;\r\n# origin_m;-2;-1;\r\n# mass_kg;1000,0\r\n# length_m;4\r\n"
        "# width_m;2\r\n# height_m;1,5\r\n# wheelbase_m;2,5\r\n# track_m;1,5\r\n# a remark\r\n"
        "# front_overhang_m;0,8\r\n# cg_behind_front_axle_m;1,2\r\n# name;a, b\r\n\r\n"
        "energy_J;fill;iy;ix\r\n5,25;0,5;0;1\r\n7;\"1\";1;3\r\n"};
    struct cr_arena arena = {0};
    struct cr_voxels v[2];
    (void)state;
    for (int i = 0; i < 2; i++) {
        write_text("test_voxels_sheet.tmp.csv", text[i], strlen(text[i]));
        assert_int_equal(cr_voxels_read("test_voxels_sheet.tmp.csv", &arena, &v[i], NULL, NULL),
                         CR_ERR_OK);
        assert_string_equal(v[i].name, "a, b");
        check_near(v[i].energy[1], 5.25, 0);
        check_near(v[i].fill[1], 0.5, 0);
        check_near(v[i].energy[7], 7, 0);
        check_near(v[i].dims.wheelbase, 2.5, 0);
    }
    check_same(&v[0], &v[1]);
    remove("test_voxels_sheet.tmp.csv");
    cr_arena_free(&arena);
}

static void test_refused(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof bad_file / sizeof bad_file[0]; i++) {
        const struct bad *b = &bad_file[i];
        char path[64];
        struct cr_arena arena = {0};
        struct cr_voxels v;
        struct cr_error err = {0};
        snprintf(path, sizeof path, "test_voxels_bad.tmp.%s", b->file);
        write_text(path, b->text, strlen(b->text));
        enum cr_err code = cr_voxels_read(path, &arena, &v, NULL, &err);
        if (code != b->code || strstr(err.text, b->says) == NULL || err.line != b->line) {
            char buf[1024];
            fail_msg("case %zu: code %d, %s", i, (int)code, cr_err_format(&err, buf, sizeof buf));
        }
        assert_string_equal(err.src, path);
        remove(path);
        cr_arena_free(&arena);
    }
}

/* a scene can name any file as a model: what it holds is not told, whatever it is */
static void test_no_words_of_the_file(void **state) {
    (void)state;
    static const char *const texts[] = {"secret:x:0:0:root:/root:/bin/sh\n",
                                        "{\"secret\": 1}",
                                        "[secret]",
                                        "{\"edge_m\": secret}",
                                        "{\"name\": \"secret",
                                        "Infsecret",
                                        "{\"crumple_voxels\": 1, \"secret\": {\"secret\": 2}}",
                                        "# secret,secret\nsecret\n",
                                        "\xFFsecret",
                                        "{\"vehicle\": {\"secret\": \"secret\"}}"};
    static const char *const suffix[] = {"json", "csv"};
    for (size_t i = 0; i < 2 * sizeof texts / sizeof texts[0]; i++) {
        char path[64], buf[1200];
        struct cr_arena arena = {0};
        struct cr_voxels v;
        struct cr_error err = {0};
        snprintf(path, sizeof path, "test_voxels_words.tmp.%s", suffix[i % 2]);
        write_text(path, texts[i / 2], strlen(texts[i / 2]));
        assert_int_not_equal(cr_voxels_read(path, &arena, &v, NULL, &err), CR_ERR_OK);
        assert_null(strstr(cr_err_format(&err, buf, sizeof buf), "ecret"));
        remove(path);
        cr_arena_free(&arena);
    }
}

/* Behind a text that breaks off in a key lies what is none of its own, here something that looks
 * like an array of a megabyte. */
static void test_text_that_ends_in_a_key(void **state) {
    (void)state;
    static const char text[] = "{\"crumple_voxels\": 1, \"energy_J";
    static char memory[1 << 20];
    struct cr_arena arena = {0};
    struct cr_voxels v;
    struct cr_error err = {0};
    memset(memory, '1', sizeof memory - 1);
    memcpy(memory, text, sizeof text);
    memcpy(memory + sizeof text, ":[", 2);
    assert_int_equal(cr_voxels_read_json(memory, sizeof text - 1, "x", &arena, &v, &err),
                     CR_ERR_SYNTAX);
    cr_arena_free(&arena);
}

/* 400 x 400 x 400 voxels are 64 million: refused before any memory is taken */
static void test_too_many(void **state) {
    static const char text[] =
        "{\"crumple_voxels\": 1, \"edge_m\": 0.01, \"count\": [400, 400, 400],"
        "\"origin_m\": [-2, -1, 0], \"mass_kg\": 1000, \"vehicle\": {\"length_m\": 4, "
        "\"width_m\": 4, \"height_m\": 1.5, \"wheelbase_m\": 2.5, \"track_m\": 1.5, "
        "\"front_overhang_m\": 0.8, \"cg_behind_front_axle_m\": 1.2}, \"energy_J\": [1]}";
    (void)state;
    struct cr_arena arena = {0};
    struct cr_voxels v;
    struct cr_error err = {0};
    write_text("test_voxels_many.tmp.json", text, strlen(text));
    assert_int_equal(cr_voxels_read("test_voxels_many.tmp.json", &arena, &v, NULL, &err),
                     CR_ERR_RANGE);
    assert_non_null(strstr(err.text, "64000000 voxels are more than 50 million"));
    assert_string_equal(err.where, "/count");
    assert_int_equal(arena.total, 0);
    remove("test_voxels_many.tmp.json");
    struct cr_model_query q = query_of(CR_TYPE_SEDAN, 12, 0.005);
    assert_int_equal(cr_model_voxels(lib, &q, &arena, &v, &err), CR_ERR_RANGE);
    assert_int_equal(arena.total, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_volume_sums_to_plan),
        cmocka_unit_test(test_files_bit_exact),
        cmocka_unit_test(test_own_model_stretched),
        cmocka_unit_test(test_coarse_model_spread_evenly),
        cmocka_unit_test(test_name_can_be_written_again),
        cmocka_unit_test(test_csv_of_a_spreadsheet),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_no_words_of_the_file),
        cmocka_unit_test(test_text_that_ends_in_a_key),
        cmocka_unit_test(test_too_many),
    };
    return cmocka_run_group_tests(tests, open_lib, close_lib);
}
