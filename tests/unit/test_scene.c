/* Scenes read, written and copied; drafts; the schema. */
#include "scene_help.h"

#include "base/file.h"
#include "scene/keys.h"

#include <cjson/cJSON.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void check_round_trip(const char *path) {
    struct cr_scene scene, again;
    struct cr_error err = {0};
    if (cr_scene_load(path, &scene, &err) != CR_ERR_OK) {
        fail_msg("%s:%d:%d: %s: %s", path, err.line, err.col, err.where, err.text);
    }
    char *first = scene_text(&scene, false);
    scene_from(first, &again);
    char *second = scene_text(&again, false);
    assert_string_equal(first, second);
    for (int i = 0; i < scene.n; i++) {
        const struct cr_participant *p = &scene.part[i], *q = &again.part[i];
        assert_memory_equal(&p->pos, &q->pos, sizeof p->pos);
        assert_true(p->speed == q->speed && p->heading == q->heading);
        assert_true(p->given == q->given);
    }
    free(first);
    free(second);
    cr_scene_fini(&scene);
    cr_scene_fini(&again);
}

static void test_all_scenes_are_written_as_they_were_read(void **state) {
    (void)state;
    char dir[4096], path[4400];
    snprintf(dir, sizeof dir, "%s", scene_path("share/scenes"));
    DIR *d = opendir(dir);
    assert_non_null(d);
    int n = 0;
    for (struct dirent *e = readdir(d); e != NULL; e = readdir(d)) {
        if (strstr(e->d_name, ".json") != NULL) {
            snprintf(path, sizeof path, "%s/%s", dir, e->d_name);
            check_round_trip(path);
            n++;
        }
    }
    closedir(d);
    assert_true(n >= 10);
}

/* every key there is, in the order and form in which it is written */
static const char everything[] =
    "{\n\t\"crumple\":\t1,\n\t\"name\":\t\"all\",\n\t\"pair\":\t\"p\",\n\t\"settings\":\t{\n"
    "\t\t\"method\":\t\"paper\",\n\t\t\"restitution\":\t\"auto\",\n\t\t\"friction\":\t0.3,\n"
    "\t\t\"road_friction\":\t0.7,\n\t\t\"dt_ms\":\t0.25,\n\t\t\"voxel_mm\":\t20,\n"
    "\t\t\"elastic_ms\":\t4,\n\t\t\"end\":\t\"rest\",\n\t\t\"induced\":\ttrue,\n"
    "\t\t\"heights\":\tfalse,\n\t\t\"residual_curve\":\ttrue,\n\t\t\"x_why\":\t[1]\n\t},\n"
    "\t\"participants\":\t[{\n"
    "\t\t\t\"id\":\t\"A\",\n\t\t\t\"kind\":\t\"vehicle\",\n\t\t\t\"type\":\t\"suv\",\n"
    "\t\t\t\"mass_kg\":\t2500,\n\t\t\t\"length_m\":\t5.086,\n\t\t\t\"width_m\":\t1.983,\n"
    "\t\t\t\"height_m\":\t1.737,\n\t\t\t\"wheelbase_m\":\t3.002,\n\t\t\t\"track_m\":\t1.65,\n"
    "\t\t\t\"front_overhang_m\":\t1,\n\t\t\t\"cg\":\t{\n"
    "\t\t\t\t\"behind_front_axle_m\":\t1.41,\n\t\t\t\t\"height_m\":\t0.7,\n"
    "\t\t\t\t\"x_by\":\t\"scale\"\n\t\t\t},\n\t\t\t\"yaw_inertia_kgm2\":\t5140,\n"
    "\t\t\t\"model\":\t{\n\t\t\t\t\"pdof\":\t11,\n\t\t\t\t\"blend\":\ttrue,\n"
    "\t\t\t\t\"stiffness\":\t{\n\t\t\t\t\t\"front\":\t{\n"
    "\t\t\t\t\t\t\"A_N_per_m\":\t92000,\n\t\t\t\t\t\t\"B_N_per_m2\":\t429000\n"
    "\t\t\t\t\t}\n\t\t\t\t}\n\t\t\t},\n\t\t\t\"brake\":\t[1, 0.5, 0, 0],\n"
    "\t\t\t\"steer_deg\":\t[10, 11, 0, 0],\n\t\t\t\"locked\":\t[true, false, false, false],\n"
    "\t\t\t\"friction\":\t0.4,\n\t\t\t\"position_m\":\t[1, -2.5],\n\t\t\t\"heading_deg\":\t30,\n"
    "\t\t\t\"course_deg\":\t25,\n\t\t\t\"speed_kmh\":\t-56,\n\t\t\t\"yaw_rate_deg_s\":\t12\n"
    "\t\t}, {\n"
    "\t\t\t\"id\":\t\"box\",\n\t\t\t\"kind\":\t\"object\",\n\t\t\t\"shape\":\t\"box\",\n"
    "\t\t\t\"mass_kg\":\t900,\n\t\t\t\"length_m\":\t3,\n\t\t\t\"width_m\":\t1.5,\n"
    "\t\t\t\"height_m\":\t[0.2, 1],\n\t\t\t\"edge_radius_m\":\t0.1,\n"
    "\t\t\t\"trajectory\":\t[{\n"
    "\t\t\t\t\t\"t_s\":\t0,\n\t\t\t\t\t\"x_m\":\t1,\n\t\t\t\t\t\"y_m\":\t2,\n"
    "\t\t\t\t\t\"heading_deg\":\t3,\n\t\t\t\t\t\"speed_kmh\":\t4,\n"
    "\t\t\t\t\t\"x_row\":\tnull\n\t\t\t\t}, {\n"
    "\t\t\t\t\t\"t_s\":\t1,\n\t\t\t\t\t\"x_m\":\t2,\n\t\t\t\t\t\"y_m\":\t3,\n"
    "\t\t\t\t\t\"heading_deg\":\t4,\n\t\t\t\t\t\"speed_kmh\":\t5\n\t\t\t\t}]\n"
    "\t\t}, {\n"
    "\t\t\t\"id\":\t\"shape\",\n\t\t\t\"kind\":\t\"object\",\n\t\t\t\"shape\":\t\"polygon\",\n"
    "\t\t\t\"vertices_m\":\t[[0, 0], [1, 0], [0, 1]],\n"
    "\t\t\t\"position_m\":\t[7, 7],\n\t\t\t\"x_note\":\t{\n\t\t\t\t\"a\":\t1\n\t\t\t}\n"
    "\t\t}],\n\t\"x_source\":\t\"here\"\n}";

static void test_every_key_is_kept(void **state) {
    (void)state;
    struct cr_scene scene, copy;
    struct cr_error err;
    scene_from(everything, &scene);
    char *text = scene_text(&scene, false);
    assert_string_equal(text, everything);
    free(text);
    assert_int_equal(cr_scene_copy(&scene, &copy, &err), CR_ERR_OK);
    cr_scene_fini(&scene);
    text = scene_text(&copy, false);
    assert_string_equal(text, everything);
    free(text);
    cr_scene_fini(&copy);
}

static void test_values_are_si(void **state) {
    (void)state;
    struct cr_scene s;
    scene_from(everything, &s);
    const struct cr_participant *a = &s.part[0], *box = &s.part[1];
    check_near(s.set.dt, 0.25e-3, 0);
    check_near(s.set.voxel, 0.02, 0);
    check_near(s.set.elastic, 4e-3, 0);
    assert_true(s.set.restitution_auto);
    assert_int_equal(s.set.method, CR_METHOD_PAPER);
    assert_int_equal(s.set.induced, 1);
    assert_int_equal(s.set.heights, 0);
    check_near(a->speed, -56 / 3.6, 1e-15);
    check_near(a->heading, 0.5235987755982988, 1e-15);
    check_near(a->yaw_rate, 0.20943951023931953, 1e-15);
    check_near(a->steer[1], 0.19198621771937624, 1e-15);
    check_near(a->model.pdof, 330 * 0.017453292519943295, 1e-14);
    assert_true(a->model.pdof_is_clock && a->model.blend && a->locked[0] && !a->locked[1]);
    assert_int_equal(a->model.kind, CR_MODEL_STIFFNESS);
    check_near(a->model.face[0].b, 429000, 0);
    assert_int_equal(box->waypoints, 2);
    check_near(box->waypoint[1].speed, 5 / 3.6, 1e-15);
    check_near(box->z_lo, 0.2, 0);
    check_near(box->z_hi, 1, 0);
    assert_true(isnan(s.part[2].mass) && isnan(box->friction) && isnan(box->course));
    cr_scene_fini(&s);
}

static void test_pdof_is_clock_or_degrees(void **state) {
    (void)state;
    static const struct {
        const char *key, *json;
        enum cr_pdof_kind kind;
        double deg;
        const char *written;
    } row[] = {{"pdof", "12", CR_PDOF_OLD, 0, "12"},
               {"pdof", "1", CR_PDOF_OLD, 30, "1"},
               {"pdof", "0", CR_PDOF_OLD, 0, "0"},
               {"pdof", "13", CR_PDOF_OLD, 13, "13"},
               {"pdof", "2.5", CR_PDOF_OLD, 2.5, "2.5"},
               {"pdof", "-30", CR_PDOF_OLD, -30, "-30"},
               {"pdof", "363", CR_PDOF_OLD, 363, "363"},
               {"pdof", "\"auto\"", CR_PDOF_AUTO, 0, "auto"},
               {"pdof_clock", "10", CR_PDOF_CLOCK, 300, "10"},
               {"pdof_clock", "12", CR_PDOF_CLOCK, 0, "12"},
               {"pdof_deg", "10", CR_PDOF_DEG, 10, "10"},
               {"pdof_deg", "-30", CR_PDOF_DEG, -30, "-30"}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        char members[200], key[40];
        struct cr_scene s;
        struct cr_str out = {0};
        struct cr_error err;
        snprintf(members, sizeof members, CAR_A ", \"model\": { \"%s\": %s }", row[i].key,
                 row[i].json);
        snprintf(key, sizeof key, "A.model.%s", row[i].key);
        scene_of(members, CAR_B, &s);
        assert_int_equal(s.part[0].model.pdof_kind, row[i].kind);
        check_near(s.part[0].model.pdof, row[i].deg * 0.017453292519943295, 1e-12);
        assert_int_equal(cr_scene_get(&s, key, &out, &err), CR_ERR_OK);
        assert_string_equal(cr_str_get(&out), row[i].written);
        cr_str_fini(&out);
        cr_scene_fini(&s);
    }
}

static void test_clockwise_polygons_are_turned_round(void **state) {
    (void)state;
    struct cr_scene s;
    scene_of(CAR_A,
             "\"id\": \"P\", \"kind\": \"object\", \"shape\": \"polygon\", \"position_m\": [5, 0],"
             "\"vertices_m\": [[0, 0], [0, 2], [1, 2], [1, 0]]",
             &s);
    const struct cr_vec2 want[] = {{1, 0}, {1, 2}, {0, 2}, {0, 0}};
    assert_int_equal(s.part[1].vertices, 4);
    assert_memory_equal(s.part[1].vertex, want, sizeof want);
    cr_scene_fini(&s);
}

static void test_participants_come_and_go(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_error err = {0};
    struct cr_participant *p = NULL;
    cr_scene_init(&s);
    assert_int_equal(cr_scene_add(&s, "A", CR_KIND_VEHICLE, &p, &err), CR_ERR_OK);
    assert_true(isnan(p->mass) && isnan(p->length) && isnan(p->course) && p->type == CR_TYPES);
    assert_true(p->speed == 0 && p->heading == 0);
    assert_int_equal(cr_scene_add(&s, "A", CR_KIND_OBJECT, &p, &err), CR_ERR_DUPLICATE);
    assert_int_equal(cr_scene_add(&s, "a b", CR_KIND_OBJECT, &p, &err), CR_ERR_RANGE);
    assert_int_equal(cr_scene_add(&s, "wall", CR_KIND_OBJECT, &p, &err), CR_ERR_OK);
    assert_ptr_equal(cr_scene_find(&s, "wall"), p);
    assert_int_equal(cr_scene_remove(&s, "wal", &err), CR_ERR_NAME);
    assert_string_equal(err.hint, "did you mean \"wall\"?");
    assert_int_equal(cr_scene_remove(&s, "A", &err), CR_ERR_OK);
    assert_int_equal(s.n, 1);
    assert_string_equal(s.part[0].id, "wall");
    char id[8];
    for (int i = 1; i < CR_BODY_MAX; i++) {
        snprintf(id, sizeof id, "V%d", i);
        assert_int_equal(cr_scene_add(&s, id, CR_KIND_VEHICLE, &p, &err), CR_ERR_OK);
    }
    assert_int_equal(cr_scene_add(&s, "late", CR_KIND_VEHICLE, &p, &err), CR_ERR_RANGE);
    cr_scene_fini(&s);
}

static void test_a_scene_in_the_making_is_kept(void **state) {
    (void)state;
    char dir[] = "cr_scene_XXXXXX", path[64];
    struct cr_scene s, again;
    struct cr_error err = {0};
    assert_non_null(mkdtemp(dir));
    snprintf(path, sizeof path, "%s/draft.json", dir);
    cr_scene_init(&s);
    assert_int_equal(cr_scene_add(&s, "A", CR_KIND_VEHICLE, NULL, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_set(&s, "A.width", "1.8m", &err), CR_ERR_OK);
    assert_int_equal(cr_scene_save(&s, path, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_load(path, &again, &err), CR_ERR_MISSING);
    assert_int_equal(cr_scene_load_draft(path, &again, &err), CR_ERR_OK);
    assert_int_equal(again.n, 1);
    assert_true(isnan(again.part[0].mass) && again.part[0].type == CR_TYPES);
    check_near(again.part[0].width, 1.8, 0);
    cr_scene_fini(&s);
    cr_scene_fini(&again);
    unlink(path);
    rmdir(dir);
}

static void test_model_files_are_found_from_a_new_folder(void **state) {
    (void)state;
    char dir[] = "cr_scene_XXXXXX", path[64], cwd[2048];
    struct cr_scene s, again;
    struct cr_error err = {0};
    assert_non_null(mkdtemp(dir));
    assert_non_null(getcwd(cwd, sizeof cwd));
    scene_of(CAR_A ", \"model\": { \"file\": \"own.csv\" }", CAR_B, &s);
    snprintf(path, sizeof path, "%s/moved.json", dir);
    assert_int_equal(cr_scene_save(&s, path, &err), CR_ERR_OK);
    assert_string_equal(s.part[0].model.file, "own.csv");
    assert_int_equal(cr_scene_load(path, &again, &err), CR_ERR_OK);
    assert_string_equal(again.dir, dir);
    snprintf(path, sizeof path, "/own.csv");
    assert_memory_equal(again.part[0].model.file, cwd, strlen(cwd));
    assert_string_equal(again.part[0].model.file + strlen(cwd), path);
    snprintf(path, sizeof path, "%s/moved.json", dir);
    cr_scene_fini(&again);
    unlink(path);
    snprintf(path, sizeof path, "%s.json", dir);
    assert_int_equal(cr_scene_save(&s, path, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_load(path, &again, &err), CR_ERR_OK);
    assert_string_equal(again.part[0].model.file, "own.csv");
    unlink(path);
    rmdir(dir);
    cr_scene_fini(&s);
    cr_scene_fini(&again);
}

static void test_a_pointer_gets_its_line_from_the_file(void **state) {
    (void)state;
    struct cr_error err;
    cr_err_set(&err, CR_ERR_RANGE, "too fast");
    snprintf(err.where, sizeof err.where, "/participants/1/id");
    const char *path = scene_path("tests/cases/scene/sense-track.json");
    cr_scene_locate_file(path, "named", &err);
    assert_string_equal(err.src, "named");
    /* the line of the second participant there is `    { "id": "W", ...` */
    assert_int_equal(err.line, 6);
    assert_int_equal(err.col, 13);
    cr_scene_locate_file("nowhere.json", "nowhere.json", &err);
    assert_string_equal(err.src, "nowhere.json");
    assert_int_equal(err.line, 0);
    cr_scene_locate_file("-", "standard input", &err);
    assert_string_equal(err.src, "standard input");
    assert_int_equal(err.line, 0);
}

static void test_a_scene_out_of_a_stack(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_error err = {0};
    cJSON *json = cJSON_Parse(everything);
    assert_int_equal(cr_scene_from_json(json, &s, &err), CR_ERR_OK);
    assert_int_equal(s.n, 3);
    cr_scene_fini(&s);
    cJSON_Delete(json);
    json = cJSON_Parse("{ \"crumple\": 1, \"participants\": [ { } ] }");
    assert_int_equal(cr_scene_from_json(json, &s, &err), CR_ERR_MISSING);
    assert_string_equal(err.where, "/participants/0");
    assert_int_equal(err.line, 0);
    cJSON_Delete(json);
}

static void test_the_schema_is_the_one_of_the_tables(void **state) {
    (void)state;
    struct cr_str made = {0};
    struct cr_error err = {0};
    char *shipped = NULL;
    size_t n;
    assert_int_equal(cr_scene_schema(&made, &err), CR_ERR_OK);
    const char *path = scene_path("share/schema/scene.schema.json");
    assert_int_equal(cr_file_read(path, &shipped, &n, &err), CR_ERR_OK);
    if (strcmp(shipped, made.s) != 0) {
        FILE *f = fopen("scene.schema.json.new", "w");
        assert_non_null(f);
        fputs(made.s, f);
        fclose(f);
        fail_msg("share/schema/scene.schema.json is not what the tables say; see "
                 "scene.schema.json.new in the build folder");
    }
    free(shipped);
    cr_str_fini(&made);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_scenes_are_written_as_they_were_read),
        cmocka_unit_test(test_every_key_is_kept),
        cmocka_unit_test(test_values_are_si),
        cmocka_unit_test(test_pdof_is_clock_or_degrees),
        cmocka_unit_test(test_clockwise_polygons_are_turned_round),
        cmocka_unit_test(test_participants_come_and_go),
        cmocka_unit_test(test_a_scene_in_the_making_is_kept),
        cmocka_unit_test(test_model_files_are_found_from_a_new_folder),
        cmocka_unit_test(test_a_pointer_gets_its_line_from_the_file),
        cmocka_unit_test(test_a_scene_out_of_a_stack),
        cmocka_unit_test(test_the_schema_is_the_one_of_the_tables),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
