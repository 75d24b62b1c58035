/* 3D models from side, top and front. */
#include "test.h"

#include "render/project.h"
#include "render_double.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* 1.0 x 0.6 x 0.4 m of voxels of 0.1 m, standing 0.2 m above the road; the upper half is missing in
 * the front 0.4 m, like a bonnet. EES 18, 36 ... km/h: a step per 0.2 m from the front. */
enum { NX = 10, NY = 6, NZ = 6, N = NX * NY * NZ };
struct block {
    double fill[N], ees[N], left[NX * NY], plan[NX * NY], energy[N];
    struct cr_voxels voxels;
    struct cr_grid grid;
    struct cr_projection projection;
};

static void make(struct block *b, enum cr_project view) {
    memset(b, 0, sizeof *b);
    for (int i = 0; i < N; i++) {
        int x = i % NX, z = i / (NX * NY);
        b->fill[i] = z >= 2 && (z < 4 || x < 6);
        b->ees[i] = 5.0 * ((NX - 1 - x) / 2 + 1);
    }
    for (int i = 0; i < NX * NY; i++) {
        b->plan[i] = 1;
        b->left[i] = i % NX >= 7 && i / NX >= 3 ? 0 : 1;
    }
    b->voxels = (struct cr_voxels){.nx = NX,
                                   .ny = NY,
                                   .nz = NZ,
                                   .edge = 0.1,
                                   .x0 = -0.5,
                                   .y0 = -0.3,
                                   .z0 = 0,
                                   .fill = b->fill,
                                   .energy = b->energy};
    strcpy(b->voxels.name, "block/12");
    b->grid = (struct cr_grid){
        .nx = NX, .ny = NY, .h = 0.1, .x0 = -0.5, .y0 = -0.3, .fill = b->plan, .energy = b->energy};
    b->projection = (struct cr_projection){
        .view = view, .voxels = &b->voxels, .ees = b->ees, .m_per_col = 0.1, .face = CR_FACE_FRONT};
}

static void check(const struct block *b, int w, int h, const char *const *want) {
    struct cr_cells c;
    struct cr_error err = {0};
    const struct cr_look look = {.ascii = true};
    assert_int_equal(cr_cells_new(w, h, &c, &err), CR_ERR_OK);
    assert_int_equal(
        cr_render_projection(&c, (struct cr_rect){0, 0, w, h}, &look, &b->projection, &err),
        CR_ERR_OK);
    for (int y = 0; want[y] != NULL; y++) {
        char got[100] = "";
        for (int x = 2; x < w - 2; x++) {
            got[x - 2] = (char)c.cell[(y + 1) * w + x].ch;
        }
        for (size_t n = strlen(got); n > 0 && got[n - 1] == ' '; n--) {
            got[n - 1] = '\0';
        }
        assert_string_equal(got, want[y]);
    }
    cr_cells_fini(&c);
}

/* on the ramp of nine signs over 100 km/h: 18 ':', 36 '=', 54 '+', 72 '#', 90 '@' */
static void test_side(void **state) {
    (void)state;
    struct block b;
    make(&b, CR_PROJECT_SIDE);
    static const char *const want[] = {"", "", "@@##++", "@@##++==::", "", NULL};
    check(&b, 40, 8, want);
}

static void test_deformed_from_the_top(void **state) {
    (void)state;
    struct block b;
    make(&b, CR_PROJECT_TOP);
    b.projection.grid = &b.grid;
    b.projection.left = b.left;
    /* the left half (upper rows) lost 0.3 m from the front; a row is 0.2 m */
    static const char *const want[] = {"@@##++=321", "@@##++=321", "@@##++==::", NULL};
    check(&b, 40, 6, want);
}

static void test_front(void **state) {
    (void)state;
    struct block b;
    make(&b, CR_PROJECT_FRONT);
    /* below: the first 0.5 m, (2 x 18 + 2 x 36 + 54) / 5 = 32.4 km/h; above, behind the bonnet,
     * (2 x 54 + 2 x 72 + 90) / 5 = 68.4 km/h */
    static const char *const want[] = {"", "", "######", "------", NULL};
    check(&b, 40, 8, want);
}

static void test_slice(void **state) {
    (void)state;
    struct block b;
    make(&b, CR_PROJECT_SLICE);
    for (int i = 0; i < N; i++) {
        b.ees[i] = i / NX % NY == 5 ? 5 : 15; /* the leftmost 0.1 m is softer: 18 and 54 km/h */
    }
    static const char *const soft[] = {"", "", "::::::", "::::::::::", NULL};
    static const char *const hard[] = {"", "", "++++++", "++++++++++", NULL};
    b.projection.slice_y = 0.25;
    check(&b, 40, 8, soft);
    b.projection.slice_y = 0.0;
    check(&b, 40, 8, hard);
}

static void test_flat_has_no_side(void **state) {
    (void)state;
    struct block b;
    struct cr_cells c;
    struct cr_error err = {0};
    const struct cr_look look = {.ascii = true};
    make(&b, CR_PROJECT_SIDE);
    b.voxels.flat = true;
    b.voxels.nz = 1;
    assert_int_equal(cr_cells_new(40, 10, &c, &err), CR_ERR_OK);
    assert_int_equal(
        cr_render_projection(&c, (struct cr_rect){0, 0, 40, 10}, &look, &b.projection, &err),
        CR_ERR_RANGE);
    assert_string_equal(err.hint, "use the top view");
    cr_cells_fini(&c);
}

/* the crash made by hand on the real models: the struck half of A's front carries digits */
static void test_body_of_a_result(void **state) {
    (void)state;
    struct render_double d;
    struct cr_model_lib *lib;
    struct cr_cells c;
    struct cr_error err = {0};
    const struct cr_look look = {.ascii = true};
    char dir[600];
    snprintf(dir, sizeof dir, "%s/models", getenv("SRC"));
    assert_int_equal(cr_model_lib_open(dir, &lib, &err), CR_ERR_OK);
    render_double_init(&d);
    struct cr_participant *p = &d.result.resolved.part[0];
    assert_int_equal(cr_model_need(lib, p->type, &err), CR_ERR_OK);
    double mass;
    const struct cr_dims *dims = cr_model_dims(lib, p->type, &mass);
    p->height = dims->height;
    p->wheelbase = dims->wheelbase;
    p->front_overhang = dims->front_overhang;
    p->cg_behind_front_axle = p->length / 2 - p->front_overhang; /* its grid is centred */
    p->cg_height = dims->cg_height;
    const struct cr_rect at = {0, 0, 60, 20};
    assert_int_equal(cr_cells_new(60, 20, &c, &err), CR_ERR_OK);
    struct cr_body_voxels body;
    assert_int_equal(cr_project_body(lib, &d.result, 0, &body, &err), CR_ERR_OK);
    body.projection.view = CR_PROJECT_TOP;
    assert_int_equal(cr_render_projection(&c, at, &look, &body.projection, &err), CR_ERR_OK);
    cr_body_voxels_fini(&body);
    int upper = 0, lower = 0, rear = 0;
    for (int i = 60; i < 60 * 18; i++) { /* without title and legend */
        bool digit = c.cell[i].role == CR_ROLE_CRUSHED;
        upper += digit && i / 60 < 9;
        lower += digit && i / 60 > 10;
        rear += digit && i % 60 < 30;
    }
    assert_true(upper > 10);
    assert_true(upper > 3 * lower);
    assert_int_equal(rear, 0);
    p->kind = CR_KIND_OBJECT;
    assert_int_equal(cr_project_body(lib, &d.result, 0, &body, &err), CR_ERR_NAME);
    assert_string_equal(err.text, "A is an object, it has no vehicle model");
    cr_cells_fini(&c);
    render_double_fini(&d);
    cr_model_lib_free(lib);
}

static void test_words_and_rows(void **state) {
    (void)state;
    struct block b;
    make(&b, CR_PROJECT_SIDE);
    /* 0.6 m at 0.2 m per row and three rows for title, road and legend */
    assert_int_equal(cr_render_projection_rows(&b.projection, 40, 30), 6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_side),
        cmocka_unit_test(test_deformed_from_the_top),
        cmocka_unit_test(test_front),
        cmocka_unit_test(test_slice),
        cmocka_unit_test(test_flat_has_no_side),
        cmocka_unit_test(test_body_of_a_result),
        cmocka_unit_test(test_words_and_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
