/* Placing one participant against another, and outlines. */
#include "scene_help.h"

#include <cjson/cJSON.h>
#include <stdlib.h>
#include <string.h>

/* A: front end 2.0 m before the CG, rear end 2.5 m behind it, 1.8 m wide.
 * B: front end 1.8 m before, rear end 2.2 m behind, 1.6 m wide. */
#define SIZES_A                                                                                    \
    CAR_A ", \"length_m\": 4.5, \"width_m\": 1.8, \"front_overhang_m\": 0.9,"                      \
          "\"wheelbase_m\": 2.6, \"cg\": { \"behind_front_axle_m\": 1.1 }"
#define SIZES_B                                                                                    \
    CAR_B ", \"length_m\": 4.0, \"width_m\": 1.6, \"front_overhang_m\": 0.8,"                      \
          "\"wheelbase_m\": 2.4, \"cg\": { \"behind_front_axle_m\": 1.0 }"
#define OBJECT(id, shape)                                                                          \
    "\"id\": \"" id "\", \"kind\": \"object\", \"position_m\": [10, 0], \"shape\": \"" shape "\""

static void check_pose(const struct cr_scene *s, int i, double x, double y, double deg) {
    const struct cr_participant *p = &s->part[i];
    check_near(p->pos.x, x, 1e-9);
    check_near(p->pos.y, y, 1e-9);
    check_near(cr_angle_wrap(p->heading - cr_rad(deg)), 0, 1e-12);
}

static void place(struct cr_scene *s, const char *id, const char *other, struct cr_place how) {
    struct cr_error err;
    if (cr_scene_place(s, id, other, &how, &err) != CR_ERR_OK) {
        fail_msg("%s (%s)", err.text, err.hint);
    }
}

static void test_head_on(void **state) {
    (void)state;
    struct cr_scene s;
    scene_of(SIZES_A, SIZES_B, &s);
    place(&s, "B", "A", (struct cr_place){.rel = CR_PLACE_FACING, .overlap = 1, .gap = 0.1});
    check_pose(&s, 1, 2.0 + 1.8 + 0.1, 0, 180);
    place(&s, "B", "A",
          (struct cr_place){.rel = CR_PLACE_FACING, .overlap = 0.4, .overlap_side = 1});
    /* 0.64 m meet: B's edge is at 0.9 - 0.64, its middle 0.8 further */
    check_pose(&s, 1, 3.8, 1.06, 180);
    place(&s, "B", "A",
          (struct cr_place){.rel = CR_PLACE_FACING, .overlap = 0.4, .overlap_side = -1});
    check_pose(&s, 1, 3.8, -1.06, 180);
    place(&s, "B", "A", (struct cr_place){.rel = CR_PLACE_FACING, .overlap = 1, .overlap_side = 1});
    check_pose(&s, 1, 3.8, 0.1, 180);
    cr_scene_fini(&s);
}

static void test_the_other_way_round_is_the_mirror_image(void **state) {
    (void)state;
    struct cr_scene s;
    scene_of(SIZES_A, SIZES_B, &s);
    s.part[1].heading = cr_rad(90);
    place(&s, "A", "B",
          (struct cr_place){.rel = CR_PLACE_FACING, .overlap = 0.25, .overlap_side = 1});
    /* 0.4 m meet; B looks north, its left is west: A's middle is 0.8 - 0.4 + 0.9 to the west */
    check_pose(&s, 0, 9 - 1.3, 1.8 + 2.0, -90);
    cr_scene_fini(&s);
}

static void test_behind_and_beside(void **state) {
    (void)state;
    struct cr_scene s;
    scene_of(SIZES_A, SIZES_B, &s);
    place(&s, "B", "A", (struct cr_place){.rel = CR_PLACE_BEHIND, .overlap = 1, .gap = 0.5});
    check_pose(&s, 1, -2.5 - 0.5 - 1.8, 0, 0);
    place(&s, "B", "A",
          (struct cr_place){.rel = CR_PLACE_BEHIND, .overlap = 0.5, .overlap_side = -1});
    check_pose(&s, 1, -4.3, -(0.9 - 0.8 + 0.8), 0);
    place(&s, "B", "A", (struct cr_place){.rel = CR_PLACE_BESIDE, .side = CR_FACE_LEFT});
    check_pose(&s, 1, 0.2, 0.9 + 0.8, 0);
    place(&s, "B", "A",
          (struct cr_place){.rel = CR_PLACE_BESIDE, .side = CR_FACE_RIGHT, .along = 1, .gap = 0.3});
    check_pose(&s, 1, 0.2 - 1, -(0.9 + 0.8 + 0.3), 0);
    cr_scene_fini(&s);
}

static void test_into_the_side(void **state) {
    (void)state;
    struct cr_scene s;
    scene_of(SIZES_A, SIZES_B, &s);
    place(&s, "B", "A",
          (struct cr_place){.rel = CR_PLACE_HITTING, .side = CR_FACE_LEFT, .along = 2});
    check_pose(&s, 1, 0, 0.9 + 1.8, -90);
    place(&s, "B", "A",
          (struct cr_place){.rel = CR_PLACE_HITTING, .side = CR_FACE_RIGHT, .along = 3});
    check_pose(&s, 1, -1, -0.9 - 1.8, 90);
    place(&s, "B", "A",
          (struct cr_place){.rel = CR_PLACE_HITTING, .side = CR_FACE_REAR, .overlap = 1});
    check_pose(&s, 1, -2.5 - 1.8, 0, 0);
    cr_scene_fini(&s);
}

static void test_turned_about_the_first_touch(void **state) {
    (void)state;
    struct cr_scene s;
    double c = cos(cr_rad(10)), d = sin(cr_rad(10));
    scene_of(SIZES_A, SIZES_B, &s);
    place(
        &s, "B", "A",
        (struct cr_place){.rel = CR_PLACE_FACING, .overlap = 1, .angle = cr_rad(10), .gap = 0.05});
    /* turned about (2, 0), then its corner (1.8, -0.8) is what comes first */
    check_pose(&s, 1, 2 + 1.8 * c + 0.8 * d + 0.05, 1.8 * d, 190);
    cr_scene_fini(&s);
}

static void test_poles_walls_and_boxes(void **state) {
    (void)state;
    struct cr_scene s;
    scene_of(SIZES_A, OBJECT("P", "pole") ", \"radius_m\": 0.127", &s);
    place(&s, "P", "A",
          (struct cr_place){.rel = CR_PLACE_HITTING, .side = CR_FACE_LEFT, .along = 2.2});
    check_pose(&s, 1, -0.2, 0.9 + 0.127, -90);
    cr_scene_fini(&s);

    scene_of(SIZES_A, OBJECT("W", "wall") ", \"heading_deg\": 210", &s);
    place(&s, "A", "W", (struct cr_place){.rel = CR_PLACE_FACING, .overlap = 1});
    check_pose(&s, 0, 10 + 2 * cos(cr_rad(210)), 2 * sin(cr_rad(210)), 30);
    cr_scene_fini(&s);

    /* a pole against the rounded corner of a box: inner corner (0.5, 0.5), radii 0.5 + 0.3, pole at
     * y = 1 - 0.3 + 0.3, so 0.5 above the corner and sqrt(0.64 - 0.25) before it */
    scene_of(OBJECT("B", "box") ", \"length_m\": 2, \"width_m\": 2, \"edge_radius_m\": 0.5",
             OBJECT("P", "pole") ", \"radius_m\": 0.3", &s);
    place(&s, "P", "B",
          (struct cr_place){.rel = CR_PLACE_FACING, .overlap = 0.5, .overlap_side = 1});
    check_pose(&s, 1, 10 + 0.5 + sqrt(0.39), 1, 180);
    cr_scene_fini(&s);
}

static void test_trajectories_give_way_and_speed_stays(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_error err;
    scene_of(SIZES_A, SIZES_B ", \"speed_kmh\": 36", &s);
    assert_int_equal(
        cr_scene_set(&s, "A.trajectory",
                     "[{\"t_s\":0,\"x_m\":0,\"y_m\":0,\"heading_deg\":0,\"speed_kmh\":9},"
                     "{\"t_s\":1,\"x_m\":9,\"y_m\":0,\"heading_deg\":0,\"speed_kmh\":9}]",
                     &err),
        CR_ERR_OK);
    place(&s, "A", "B", (struct cr_place){.rel = CR_PLACE_BEHIND, .overlap = 1});
    assert_int_equal(s.part[0].waypoints, 0);
    check_pose(&s, 0, 9 - 2.2 - 2.0, 0, 0);
    char *text = scene_text(&s, false);
    assert_null(strstr(text, "trajectory"));
    free(text);
    place(&s, "B", "A", (struct cr_place){.rel = CR_PLACE_FACING, .overlap = 1});
    check_near(s.part[1].speed, 10, 1e-12);
    cr_scene_fini(&s);
}

static void test_what_cannot_be_placed(void **state) {
    (void)state;
    struct cr_scene s;
    const struct cr_place facing = {.rel = CR_PLACE_FACING, .overlap = 1};
    static const struct {
        const char *id, *other;
        struct cr_place how;
        enum cr_err code;
        const char *part;
    } row[] = {
        {"A", "A", {.rel = CR_PLACE_FACING, .overlap = 1}, CR_ERR_NAME, "itself"},
        {"A", "C", {.rel = CR_PLACE_FACING, .overlap = 1}, CR_ERR_NAME, "\"C\""},
        {"B", "A", {.rel = CR_PLACE_FACING, .overlap = 0}, CR_ERR_RANGE, "overlap"},
        {"B", "A", {.rel = CR_PLACE_FACING, .overlap = 1.1}, CR_ERR_RANGE, "100 %"},
        {"B", "A", {.rel = CR_PLACE_FACING, .overlap = 0.4}, CR_ERR_RANGE, "side"},
        {"B", "A", {.rel = CR_PLACE_FACING, .overlap = 1, .gap = -1}, CR_ERR_RANGE, "gap"},
        {"B", "A", {.rel = CR_PLACE_FACING, .overlap = 1, .angle = NAN}, CR_ERR_RANGE, "angle"},
        {"B", "A", {.rel = CR_PLACE_HITTING, .side = CR_FACE_LEFT, .along = 9}, CR_ERR_RANGE, "by"},
    };
    scene_of(SIZES_A, SIZES_B, &s);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct cr_error err = {0};
        enum cr_err code = cr_scene_place(&s, row[i].id, row[i].other, &row[i].how, &err);
        if (code != row[i].code || strstr(err.text, row[i].part) == NULL) {
            fail_msg("row %zu: code %d: %s", i, (int)code, err.text);
        }
        check_pose(&s, 1, 9, 0, 0);
    }
    cr_scene_fini(&s);
    scene_of(CAR_A, SIZES_B, &s);
    assert_int_equal(cr_scene_place(&s, "B", "A", &facing, NULL), CR_ERR_MISSING);
    cr_scene_fini(&s);
}

static void check_outline(const struct cr_participant *p, double area, double tol) {
    struct cr_vec2 v[CR_VERTEX_MAX];
    double sum = 0;
    int n = cr_scene_outline(p, v, CR_VERTEX_MAX);
    assert_true(n >= 3);
    for (int i = 0; i < n; i++) {
        sum += cr_vec2_cross(v[i], v[(i + 1) % n]) / 2;
    }
    check_near(sum, area, tol);
}

static void test_outlines_go_round_counter_clockwise(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_vec2 v[CR_VERTEX_MAX];
    scene_of(SIZES_A,
             OBJECT("B", "box") ", \"length_m\": 2, \"width_m\": 2, \"edge_radius_m\": 0.5", &s);
    check_outline(&s.part[0], 4.5 * 1.8, 1e-12);
    /* the corners lose (4 - pi) r2; the arcs are drawn in five chords each */
    check_outline(&s.part[1], 4 - (4 - CR_PI) * 0.25, 0.02);
    assert_int_equal(cr_scene_outline(&s.part[0], v, 3), 0);
    cr_scene_fini(&s);
    scene_of(CAR_A, OBJECT("P", "pole") ", \"radius_m\": 0.5", &s);
    check_outline(&s.part[1], CR_PI / 4, 0.01);
    assert_int_equal(cr_scene_outline(&s.part[0], v, CR_VERTEX_MAX), 0);
    cr_scene_fini(&s);
}

/* ---- relations that are kept ---- */

#define BOX_AT(x)                                                                                  \
    "\"id\": \"A\", \"kind\": \"object\", \"shape\": \"box\", \"length_m\": 2, \"width_m\": 2,"    \
    "\"position_m\": [" x ", 0]"
#define AGAINST(other, more)                                                                       \
    "\"id\": \"B\", \"kind\": \"object\", \"shape\": \"box\", \"length_m\": 4, \"width_m\": 2,"    \
    "\"mass_kg\": 900, \"place\": { \"against\": \"" other "\"" more " }"

/* a scene of two boxes needs no models */
static enum cr_err settled(const char *a, const char *b, struct cr_scene *s, struct cr_error *err) {
    scene_of(a, b, s);
    return cr_scene_settle(s, NULL, err);
}

static void set(struct cr_scene *s, const char *key, const char *value) {
    struct cr_error err;
    if (cr_scene_set(s, key, value, &err) != CR_ERR_OK) {
        fail_msg("%s=%s: %s", key, value, err.text);
    }
}

static void test_a_relation_is_followed(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_error err = {0};
    /* half lengths 1 and 2 m, 0.5 m apart */
    assert_int_equal(settled(BOX_AT("0"), AGAINST("A", ", \"gap_m\": 0.5"), &s, &err), CR_ERR_OK);
    check_pose(&s, 1, 3.5, 0, 180);
    set(&s, "A.length_m", "3");
    assert_int_equal(cr_scene_settle(&s, NULL, &err), CR_ERR_OK);
    check_pose(&s, 1, 4, 0, 180);
    set(&s, "A.heading_deg", "90");
    assert_int_equal(cr_scene_settle(&s, NULL, &err), CR_ERR_OK);
    check_pose(&s, 1, 0, 4, 270);
    set(&s, "B.place.overlap_percent", "25");
    set(&s, "B.place.side", "left");
    set(&s, "A.heading_deg", "0");
    assert_int_equal(cr_scene_settle(&s, NULL, &err), CR_ERR_OK);
    /* 0.5 of 2 m meet: its middle 1.5 m to the left */
    check_pose(&s, 1, 4, 1.5, 180);
    /* a new name of the other one is followed, a place of its own ends it */
    set(&s, "A.id", "Z");
    assert_string_equal(s.part[1].place.against, "Z");
    set(&s, "B.position_m", "20,0");
    assert_false(cr_scene_is_placed(&s.part[1]));
    cr_scene_fini(&s);
}

static void test_a_relation_is_written_and_read(void **state) {
    (void)state;
    struct cr_scene s, again;
    struct cr_error err = {0};
    assert_int_equal(
        settled(BOX_AT("0"), AGAINST("A", ", \"how\": \"behind\", \"gap_m\": 1"), &s, &err),
        CR_ERR_OK);
    check_pose(&s, 1, -1 - 2 - 1, 0, 0);
    cJSON *json = cr_scene_to_json(&s, false);
    assert_int_equal(cr_scene_from_json(json, &again, &err), CR_ERR_OK);
    assert_string_equal(again.part[1].place.against, "A");
    assert_int_equal(again.part[1].place.how, CR_PLACE_BEHIND);
    check_pose(&again, 1, -4, 0, 0); /* the resolved place stands beside it */
    cJSON_Delete(json);
    cr_scene_fini(&again);
    cr_scene_fini(&s);
}

static void test_relations_that_cannot_be(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_error err = {0};
    assert_int_equal(settled(BOX_AT("0"), AGAINST("C", ""), &s, &err), CR_ERR_NAME);
    assert_string_equal(err.where, "/participants/1/place/against");
    cr_scene_fini(&s);
    err = (struct cr_error){0};
    assert_int_equal(
        settled(BOX_AT("0") ", \"place\": { \"against\": \"B\" }", AGAINST("A", ""), &s, &err),
        CR_ERR_NAME);
    assert_non_null(strstr(err.text, "circle"));
    cr_scene_fini(&s);
    err = (struct cr_error){0};
    assert_int_equal(settled(BOX_AT("0"), AGAINST("B", ""), &s, &err), CR_ERR_NAME);
    cr_scene_fini(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_relation_is_followed),
        cmocka_unit_test(test_a_relation_is_written_and_read),
        cmocka_unit_test(test_relations_that_cannot_be),
        cmocka_unit_test(test_head_on),
        cmocka_unit_test(test_the_other_way_round_is_the_mirror_image),
        cmocka_unit_test(test_behind_and_beside),
        cmocka_unit_test(test_into_the_side),
        cmocka_unit_test(test_turned_about_the_first_touch),
        cmocka_unit_test(test_poles_walls_and_boxes),
        cmocka_unit_test(test_trajectories_give_way_and_speed_stays),
        cmocka_unit_test(test_what_cannot_be_placed),
        cmocka_unit_test(test_outlines_go_round_counter_clockwise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
