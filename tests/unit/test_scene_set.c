/* One value of a scene by name and text: what is set, what is refused. */
#include "scene_help.h"

#include "scene/keys.h"

#include <stdlib.h>
#include <string.h>

static void start(struct cr_scene *s) {
    scene_of(CAR_A,
             "\"id\": \"P\", \"kind\": \"object\", \"shape\": \"pole\", \"radius_m\": 0.2,"
             "\"position_m\": [4, 0]",
             s);
}

static void set(struct cr_scene *s, const char *key, const char *value) {
    struct cr_error err = {0};
    if (cr_scene_set(s, key, value, &err) != CR_ERR_OK) {
        fail_msg("%s=%s: %s (%s)", key, value, err.text, err.hint);
    }
}

static void check_got(const struct cr_scene *s, const char *key, const char *want) {
    struct cr_str out = {0};
    struct cr_error err;
    assert_int_equal(cr_scene_get(s, key, &out, &err), CR_ERR_OK);
    assert_string_equal(cr_str_get(&out), want);
    cr_str_fini(&out);
}

static void test_settings_by_name(void **state) {
    (void)state;
    struct cr_scene s;
    start(&s);
    set(&s, "dt_ms", "0.25");
    check_near(s.set.dt, 0.25e-3, 0);
    set(&s, "dt", "1ms");
    check_near(s.set.dt, 1e-3, 0);
    set(&s, "voxel", "2cm");
    check_got(&s, "voxel_mm", "20");
    set(&s, "friction", "70%");
    check_near(s.set.friction, 0.7, 0);
    set(&s, "restitution", "auto");
    assert_true(s.set.restitution_auto);
    set(&s, "restitution", "0.2");
    assert_false(s.set.restitution_auto);
    set(&s, "method", "paper");
    set(&s, "end", "rest");
    set(&s, "induced", "on");
    assert_int_equal(s.set.induced, 1);
    check_got(&s, "heights", "auto");
    set(&s, "induced", "auto");
    check_got(&s, "induced", "auto");
    set(&s, "name", "a, b");
    assert_string_equal(s.name, "a, b");
    cr_scene_fini(&s);
}

static void test_participants_by_name(void **state) {
    (void)state;
    struct cr_scene s;
    start(&s);
    struct cr_participant *a = &s.part[0];
    set(&s, "A.speed_kmh", "36");
    check_near(a->speed, 10, 1e-14);
    set(&s, "A.speed", "10m/s");
    check_got(&s, "A.speed_kmh", "36");
    set(&s, "A.mass", "2.26t");
    check_near(a->mass, 2260, 0);
    set(&s, "A.cg.height", "55cm");
    check_near(a->cg_height, 0.55, 1e-15);
    set(&s, "A.track", "1.5");
    set(&s, "A.track", "auto");
    assert_true(isnan(a->track));
    set(&s, "A.brake", "1,1,0,0.5");
    check_near(a->brake[3], 0.5, 0);
    set(&s, "A.brake", "30%");
    check_near(a->brake[2], 0.3, 0);
    set(&s, "A.locked", "true,false,false,true");
    assert_true(a->locked[0] && !a->locked[1] && a->locked[3]);
    set(&s, "A.position", "1,-250cm");
    check_near(a->pos.y, -2.5, 0);
    set(&s, "A.model.pdof", "3deg");
    check_near(a->model.pdof, cr_rad(3), 1e-12);
    assert_int_equal(a->model.pdof_kind, CR_PDOF_DEG);
    set(&s, "A.model.pdof_clock", "3");
    check_near(a->model.pdof, cr_rad(90), 1e-12);
    set(&s, "A.model.pdof_clock", "auto");
    assert_int_equal(a->model.pdof_kind, CR_PDOF_AUTO);
    set(&s, "A.model.pdof", "3");
    check_near(a->model.pdof, cr_rad(90), 1e-12);
    set(&s, "A.model.file", "own.csv");
    assert_int_equal(a->model.kind, CR_MODEL_FILE);
    set(&s, "A.model.file", "");
    assert_int_equal(a->model.kind, CR_MODEL_TYPE);
    set(&s, "P.height_m", "0,2");
    check_near(s.part[1].z_hi, 2, 0);
    set(&s, "P.shape", "polygon");
    set(&s, "P.vertices", "[[0, 0], [1, 0], [0, 1]]");
    assert_int_equal(s.part[1].vertices, 3);
    set(&s, "A.id", "Q7");
    check_got(&s, "Q7.type", "compact");
    cr_scene_fini(&s);
}

static void test_what_cannot_be_set_leaves_the_scene_alone(void **state) {
    (void)state;
    static const struct {
        const char *key, *value;
        enum cr_err code;
        const char *part;
    } row[] = {
        {"dt_m", "1", CR_ERR_KEY, "dt_ms"},
        {"speed_kmh", "50", CR_ERR_KEY, "A.speed_kmh"},
        {"C.speed_kmh", "50", CR_ERR_NAME, "\"C\""},
        {"A.sped", "50", CR_ERR_KEY, "speed_kmh"},
        {"A.radius_m", "1", CR_ERR_KEY, "a vehicle"},
        {"A.speed", "fast", CR_ERR_TYPE, "km/h"},
        {"A.speed", "50kg", CR_ERR_NAME, "m/s"},
        {"A.mass_kg", "5", CR_ERR_RANGE, "100 to 60000"},
        {"A.type", "lorry", CR_ERR_NAME, "suv"},
        {"A.brake", "1,1", CR_ERR_TYPE, "four"},
        {"A.brake", "1,1,0,2", CR_ERR_RANGE, "0 to 1"},
        {"A.brake", "[1,1,", CR_ERR_SYNTAX, "value"},
        {"A.id", "P", CR_ERR_DUPLICATE, "P"},
        {"A.id", "a.b", CR_ERR_RANGE, "'.'"},
        {"A.locked", "maybe", CR_ERR_TYPE, "true or false"},
        {"induced", "2", CR_ERR_TYPE, "true or false"},
        {"method", "papre", CR_ERR_NAME, "paper"},
        {"P.vertices_m", "[[0, 0], [1, 1]]", CR_ERR_KEY, "a pole"},
        {"A.trajectory", "[{\"t_s\": 0}]", CR_ERR_RANGE, "rows"},
        {"", "1", CR_ERR_KEY, "\"\""},
        {".speed", "1", CR_ERR_NAME, "participant"},
    };
    struct cr_scene s;
    start(&s);
    char *before = scene_text(&s, true);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct cr_error err = {0};
        enum cr_err code = cr_scene_set(&s, row[i].key, row[i].value, &err);
        char *after = scene_text(&s, true);
        if (code != row[i].code || strcmp(before, after) != 0 ||
            (strstr(err.text, row[i].part) == NULL && strstr(err.hint, row[i].part) == NULL)) {
            fail_msg("%s=%s: code %d: %s (%s)", row[i].key, row[i].value, (int)code, err.text,
                     err.hint);
        }
        free(after);
    }
    free(before);
    cr_scene_fini(&s);
}

static void test_what_was_set_is_written(void **state) {
    (void)state;
    struct cr_scene s;
    cr_scene_init(&s);
    struct cr_error err;
    assert_int_equal(cr_scene_add(&s, "A", CR_KIND_VEHICLE, NULL, &err), CR_ERR_OK);
    set(&s, "friction", "0.5");
    set(&s, "A.heading", "0");
    char *text = scene_text(&s, false);
    /* also a value that is the one it would have anyway; nothing else */
    assert_non_null(strstr(text, "\"friction\":\t0.5"));
    assert_non_null(strstr(text, "\"heading_deg\":\t0"));
    assert_null(strstr(text, "dt_ms"));
    assert_null(strstr(text, "speed_kmh"));
    free(text);
    cr_scene_fini(&s);
}

static void test_tables_hold_together(void **state) {
    (void)state;
    for (int t = 0; t < CR_KEY_TABLES; t++) {
        int n;
        const struct cr_key *row = cr_scene_keys(t, &n);
        for (int i = 0; i < n; i++) {
            assert_non_null(row[i].help);
            assert_non_null(cr_scene_key_unit(&row[i]));
            assert_true((row[i].required & ~row[i].for_kinds) == 0);
            for (int k = 0; k < i; k++) {
                bool same = strcmp(row[i].name, row[k].name) == 0;
                assert_false(same && (row[i].for_kinds & row[k].for_kinds) != 0);
            }
        }
    }
}

/* of mass, kerb mass and load two say the third: which of them follows when one is varied */
static void test_a_mass_that_is_varied(void **state) {
    (void)state;
    static const struct {
        const char *key, *value;
        double mass, kerb, load;
    } rows[] = {
        {"A.mass_kg", "1800", 1800, 1400, NAN},
        {"A.kerb_mass_kg", "1500", NAN, 1500, 200},
        {"A.load_kg", "300", NAN, 1400, 300},
        {"A.speed_kmh", "30", 1600, 1400, 200},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct cr_scene s;
        start(&s);
        set(&s, "A.mass_kg", "1600");
        set(&s, "A.kerb_mass_kg", "1400");
        set(&s, "A.load_kg", "200");
        set(&s, rows[i].key, rows[i].value);
        cr_scene_mass_follows(&s, rows[i].key);
        const double now[3] = {s.part[0].mass, s.part[0].kerb_mass, s.part[0].load};
        const double want[3] = {rows[i].mass, rows[i].kerb, rows[i].load};
        for (int k = 0; k < 3; k++) {
            assert_true(now[k] == want[k] || (isnan(now[k]) && isnan(want[k])));
        }
        cr_scene_fini(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_settings_by_name),
        cmocka_unit_test(test_participants_by_name),
        cmocka_unit_test(test_what_cannot_be_set_leaves_the_scene_alone),
        cmocka_unit_test(test_what_was_set_is_written),
        cmocka_unit_test(test_a_mass_that_is_varied),
        cmocka_unit_test(test_tables_hold_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
