/* Deformation measures on small grids whose damage is cut in by hand. */
#include "test.h"

#include "result/deform.h"
#include "result/result_priv.h"

#include <stdlib.h>
#include <string.h>

/* a block 4 m long and 2 m wide of 0.1 m voxels, CG in the middle */
enum { NX = 40, NY = 20, N = NX * NY };
static double fill[N], energy[N], left[N];
static uint8_t how[N];
static struct cr_grid grid;

static struct cr_deform block(void) {
    for (int i = 0; i < N; i++) {
        fill[i] = left[i] = 1;
        energy[i] = 10;
        how[i] = 0;
    }
    grid = (struct cr_grid){
        .nx = NX, .ny = NY, .h = 0.1, .x0 = -2, .y0 = -1, .fill = fill, .energy = energy};
    return (struct cr_deform){.grid = &grid, .left = left, .how = how};
}

static void lose(int x, int y, double share, uint8_t flag) {
    left[y * NX + x] -= share;
    how[y * NX + x] |= flag;
}

static void springback_of_deep_and_shallow_crush(void **state) {
    (void)state;
    /* beyond 0.2 / 0.4 = 0.5 m the whole springback, below 40 %, the first 0.053 m leave nothing */
    check_near(cr_deform_residual(0.6, 0.2), 0.4, 1e-15);
    check_near(cr_deform_residual(0.4, 0.2), 0.24, 1e-15);
    check_near(cr_deform_residual(0.2, 0.2), 0.12, 1e-15);
    check_near(cr_deform_residual(0.1, 0.2), 0.047, 1e-15);
    check_near(cr_deform_residual(0.05, 0.2), 0, 1e-15);
    check_near(cr_deform_residual(0.1, 0.03), 0.07, 1e-15);
    check_near(cr_deform_residual(0.25, 0), 0.25, 0);
    check_near(cr_deform_residual(0, 0.2), 0, 0);
    check_near(cr_deform_residual(-1, 0.2), 0, 0);
    for (double d = 0.01; d < 1; d += 0.07) {
        double residual = cr_deform_residual(d, 0.2); /* what left nothing is not known again */
        check_near(cr_deform_dynamic(residual, 0.2), d <= 0.053 ? 0 : d, 1e-12);
        check_near(cr_deform_dynamic(cr_deform_residual(d, 0), 0), d, 1e-12);
    }
    check_near(cr_deform_dynamic(0, 0.2), 0, 0);
}

static void depth_of_a_crushed_front(void **state) {
    (void)state;
    struct cr_deform d = block();
    for (int y = 0; y < NY; y++) {
        for (int x = NX - 4; x < NX; x++) {
            lose(x, y, 1, CR_CRUSH_CONTACT);
        }
        lose(NX - 5, y, 0.25, CR_CRUSH_CONTACT);
    }
    check_near(cr_deform_max(&d, cr_vec2(-1, 0)), 0.425, 1e-12);
    check_near(cr_deform_column(&d, CR_FACE_FRONT, 3, false), 0.425, 1e-12);
    check_near(cr_deform_column(&d, CR_FACE_REAR, 3, false), 0, 0);
    check_near(cr_deform_column(&d, CR_FACE_LEFT, 3, false), 0, 0);
    assert_int_equal(cr_deform_face(&d, cr_vec2(-1, 0)), CR_FACE_FRONT);
    /* 45 degrees: material lost along the slanted line is longer by sqrt 2 */
    check_near(cr_deform_max(&d, cr_vec2(-sqrt(0.5), -sqrt(0.5))), 0.425 * sqrt(2), 0.01);
}

/* a pole in the left side: 3 columns struck 0.5 m deep, one induced column at either side */
static void depth_of_a_struck_side(void **state) {
    (void)state;
    struct cr_deform d = block();
    for (int x = 14; x < 19; x++) {
        int deep = x == 14 || x == 18 ? 2 : 5;
        for (int k = 0; k < deep; k++) {
            lose(x, NY - 1 - k, 1, deep == 2 ? CR_CRUSH_INDUCED : CR_CRUSH_CONTACT);
        }
    }
    check_near(cr_deform_column(&d, CR_FACE_LEFT, 16, false), 0.5, 1e-12);
    check_near(cr_deform_column(&d, CR_FACE_LEFT, 14, false), 0.2, 1e-12);
    check_near(cr_deform_column(&d, CR_FACE_LEFT, 14, true), 0, 0);
    check_near(cr_deform_column(&d, CR_FACE_LEFT, 13, false), 0, 0);
    /* seen from the front the damage lies behind 2 m of sound material */
    check_near(cr_deform_column(&d, CR_FACE_FRONT, 0, false), 0, 0);
    check_near(cr_deform_max(&d, cr_vec2(0, -1)), 0.5, 1e-12);
    assert_int_equal(cr_deform_face(&d, cr_vec2(0.3, -0.9)), CR_FACE_LEFT);
}

/* the greatest depth is a mean over 0.1 m: a line of one voxel does not set it, whatever its size
 */
static void one_scraped_line_sets_no_maximum(void **state) {
    (void)state;
    for (double h = 0.005; h < 0.11; h *= 1.37) {
        struct cr_deepest top = {.step = h};
        /* 1.8 m of 0.2 m depth, and a strip 0.02 m wide of 2 m in it */
        for (double y = 0; y < 1.8; y += h) {
            double in = fmax(0, fmin(y + h, 0.92) - fmax(y, 0.90)) / h;
            cr_deepest_add(&top, 0.2 + 1.8 * in);
        }
        check_near(cr_deepest_get(&top), 0.2 + 1.8 * 0.02 / 0.1, 1e-9);
    }
    struct cr_deepest narrow = {.step = 0.02}, none = {.step = 0.02};
    cr_deepest_add(&narrow, 0.3);
    cr_deepest_add(&narrow, 0.5);
    check_near(cr_deepest_get(&narrow), 0.4, 1e-12);
    check_near(cr_deepest_get(&none), 0, 0);
}

/* where a contact begins decides the face: a corner driven on straight ahead is the front's */
static void face_is_where_the_contact_began(void **state) {
    (void)state;
    block();
    assert_int_equal(cr_deform_face_at(&grid, cr_vec2(1.95, 0.97), cr_vec2(-1, 0)), CR_FACE_FRONT);
    assert_int_equal(cr_deform_face_at(&grid, cr_vec2(1.6, 0.99), cr_vec2(-1, 0)), CR_FACE_FRONT);
    assert_int_equal(cr_deform_face_at(&grid, cr_vec2(0, 0.99), cr_vec2(-0.7, -0.7)), CR_FACE_LEFT);
    assert_int_equal(cr_deform_face_at(&grid, cr_vec2(0, -1), cr_vec2(0.7, 0.7)), CR_FACE_RIGHT);
    assert_int_equal(cr_deform_face_at(&grid, cr_vec2(-2, -0.5), cr_vec2(0.9, 0.1)), CR_FACE_REAR);
}

/* what an underride leaves begins behind a sound bonnet */
static void damage_behind_sound_material(void **state) {
    (void)state;
    struct cr_deform d = block();
    for (int x = NX - 25; x < NX - 10; x++) {
        lose(x, 9, 1, CR_CRUSH_CONTACT);
    }
    check_near(cr_deform_column(&d, CR_FACE_FRONT, NY - 1 - 9, false), 0, 0);
    d.through = true;
    check_near(cr_deform_column(&d, CR_FACE_FRONT, NY - 1 - 9, false), 1.5, 1e-12);
}

/* damage at both ends: each end has its own depth */
static void far_damage_does_not_count(void **state) {
    (void)state;
    struct cr_deform d = block();
    for (int y = 0; y < NY; y++) {
        lose(0, y, 1, CR_CRUSH_CONTACT);
        lose(1, y, 1, CR_CRUSH_CONTACT);
        lose(NX - 1, y, 1, CR_CRUSH_CONTACT);
    }
    check_near(cr_deform_column(&d, CR_FACE_FRONT, 5, false), 0.1, 1e-12);
    check_near(cr_deform_column(&d, CR_FACE_REAR, 5, false), 0.2, 1e-12);
    check_near(cr_deform_max(&d, cr_vec2(-1, 0)), 0.1, 1e-12);
    check_near(cr_deform_max(&d, cr_vec2(1, 0)), 0.2, 1e-12);
}

/* small overlap on the left: nearly all of it is nearer to the flank than to the front */
static void small_overlap_is_a_frontal_hit(void **state) {
    (void)state;
    struct cr_deform d = block();
    for (int y = NY - 4; y < NY; y++) {
        for (int x = NX - 12; x < NX; x++) {
            lose(x, y, 1, CR_CRUSH_CONTACT);
        }
    }
    assert_int_equal(cr_deform_face(&d, cr_vec2(-cos(0.26), -sin(0.26))), CR_FACE_FRONT);
    /* columns run from left to right */
    check_near(cr_deform_column(&d, CR_FACE_FRONT, 0, false), 1.2, 1e-12);
    check_near(cr_deform_column(&d, CR_FACE_FRONT, 4, false), 0, 0);
}

static double area_of(const struct cr_vec2 *p, int n) {
    double a = 0;
    for (int i = 0; i < n; i++) {
        a += cr_vec2_cross(p[i], p[(i + 1) % n]) / 2;
    }
    return a;
}

static bool cross(struct cr_vec2 a, struct cr_vec2 b, struct cr_vec2 c, struct cr_vec2 d) {
    struct cr_vec2 ab = cr_vec2_sub(b, a), cd = cr_vec2_sub(d, c);
    double s = cr_vec2_cross(ab, cr_vec2_sub(c, a)), t = cr_vec2_cross(ab, cr_vec2_sub(d, a));
    double u = cr_vec2_cross(cd, cr_vec2_sub(a, c)), v = cr_vec2_cross(cd, cr_vec2_sub(b, c));
    return s * t < 0 && u * v < 0;
}

static void check_simple(const struct cr_vec2 *p, int n) {
    for (int i = 0; i < n; i++) {
        for (int k = i + 2; k < n; k++) {
            if ((k + 1) % n != i) {
                assert_false(cross(p[i], p[i + 1], p[k], p[(k + 1) % n]));
            }
        }
    }
}

static void outline_of_a_block(void **state) {
    (void)state;
    block();
    struct cr_vec2 *p;
    int n;
    assert_int_equal(cr_deform_outline(&grid, left, 1e-9, &p, &n, NULL), CR_ERR_OK);
    /* four corners, each cut by half a voxel: 8 points, 4 triangles of 0.05 x 0.05 / 2 missing */
    assert_int_equal(n, 8);
    check_near(area_of(p, n), 8 - 4 * 0.05 * 0.05 / 2, 1e-12);
    free(p);
}

static void outline_of_a_damaged_block(void **state) {
    (void)state;
    block();
    for (int x = 10; x < 16; x++) {
        for (int y = 14 + abs(x - 13); y < NY; y++) {
            lose(x, y, 1, CR_CRUSH_CONTACT);
        }
    }
    for (int y = 3; y < 6; y++) {
        /* a hole inside and an island that was cut off in front */
        lose(30, y, 1, 0);
        lose(NX - 3, y, 1, 0);
    }
    lose(NX - 3, 6, 1, 0);
    lose(NX - 3, 2, 1, 0);
    for (int x = NX - 3; x < NX; x++) {
        lose(x, 7, 1, 0);
        lose(x, 1, 1, 0);
    }
    struct cr_vec2 *p;
    int n;
    assert_int_equal(cr_deform_outline(&grid, left, 0.025, &p, &n, NULL), CR_ERR_OK);
    double lost = 0;
    for (int x = 10; x < 16; x++) {
        lost += NY - (14 + abs(x - 13));
    }
    /* the ring about the island and the island itself: 7 rows of 3 */
    lost += 21;
    check_near(area_of(p, n), 8 - lost * 0.01, 0.08);
    check_simple(p, n);
    free(p);
}

static void outline_of_nothing(void **state) {
    (void)state;
    block();
    memset(left, 0, sizeof left);
    struct cr_vec2 *p;
    int n;
    assert_int_equal(cr_deform_outline(&grid, left, 0.025, &p, &n, NULL), CR_ERR_OK);
    assert_int_equal(n, 0);
    assert_null(p);
}

static void cdc_of_known_crashes(void **state) {
    (void)state;
    char cdc[12];
    /* 2018 Camry on a full wall, 0.518 m: 12FDEW2 [CAMRY-CDC]; pillar 2.4 m behind the
     * bumper */
    struct cr_cdc_case what = {.pdof = 0,
                               .face = CR_FACE_FRONT,
                               .lo = 0.05,
                               .hi = 0.95,
                               .width = 1.6,
                               .depth = 0.518,
                               .zone = 2.4};
    cr_cdc_write(&what, cdc);
    assert_string_equal(cdc, "12FDEW2");
    /* left two thirds of the front, from 11 o'clock */
    what = (struct cr_cdc_case){.pdof = cr_rad(333),
                                .face = CR_FACE_FRONT,
                                .lo = 0,
                                .hi = 0.6,
                                .width = 1,
                                .depth = 0.2,
                                .zone = 2.4};
    cr_cdc_write(&what, cdc);
    assert_string_equal(cdc, "11FYEW1");
    /* narrow pole in the middle of the right side, above the belt line */
    what = (struct cr_cdc_case){.pdof = cr_rad(75),
                                .face = CR_FACE_RIGHT,
                                .lo = 0.45,
                                .hi = 0.5,
                                .width = 0.25,
                                .depth = 0.37,
                                .zone = 1.8,
                                .vertical = 'A'};
    cr_cdc_write(&what, cdc);
    assert_string_equal(cdc, "03RPAN2");
}

static void cdc_of_rear_and_flank(void **state) {
    (void)state;
    char cdc[12];
    struct cr_cdc_case what;
    /* rear, right third; back third of the left side; all of a side; deep */
    what = (struct cr_cdc_case){.pdof = CR_PI,
                                .face = CR_FACE_REAR,
                                .lo = 0.7,
                                .hi = 1,
                                .width = 0.5,
                                .depth = 9,
                                .zone = 1.8};
    cr_cdc_write(&what, cdc);
    assert_string_equal(cdc, "06BREW9");
    what = (struct cr_cdc_case){.pdof = cr_rad(270),
                                .face = CR_FACE_LEFT,
                                .lo = 0.1,
                                .hi = 0.3,
                                .width = 0.8,
                                .depth = 0,
                                .zone = 1.8,
                                .sideswipe = true};
    cr_cdc_write(&what, cdc);
    assert_string_equal(cdc, "09LBES1");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(springback_of_deep_and_shallow_crush),
        cmocka_unit_test(depth_of_a_crushed_front),
        cmocka_unit_test(depth_of_a_struck_side),
        cmocka_unit_test(far_damage_does_not_count),
        cmocka_unit_test(one_scraped_line_sets_no_maximum),
        cmocka_unit_test(face_is_where_the_contact_began),
        cmocka_unit_test(damage_behind_sound_material),
        cmocka_unit_test(small_overlap_is_a_frontal_hit),
        cmocka_unit_test(outline_of_a_block),
        cmocka_unit_test(outline_of_a_damaged_block),
        cmocka_unit_test(outline_of_nothing),
        cmocka_unit_test(cdc_of_known_crashes),
        cmocka_unit_test(cdc_of_rear_and_flank),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
