/* A scene resolved and compiled: assumed values, bodies, wheels, shapes, heights that meet. */
#include "scene_help.h"

#include "scene/compiled.h"
#include "solver/solver.h"

#include <stdlib.h>
#include <stdio.h>
#include <string.h>

static struct cr_model_lib *lib;

static int open_models(void **state) {
    (void)state;
    lib = scene_models();
    return 0;
}

static int close_models(void **state) {
    (void)state;
    cr_model_lib_free(lib);
    return 0;
}

static void resolve(struct cr_scene *s, struct cr_assumed *assumed) {
    struct cr_error err = {0};
    if (cr_scene_resolve(s, lib, assumed, &err) != CR_ERR_OK) {
        fail_msg("%s: %s", err.where, err.text);
    }
}

static void compile(const struct cr_scene *s, struct cr_compiled *out) {
    static const double pdof[CR_BODY_MAX] = {0};
    struct cr_error err = {0};
    if (cr_scene_compile(s, lib, pdof, out, &err) != CR_ERR_OK) {
        fail_msg("%s: %s", err.where, err.text);
    }
}

#define WALL "\"id\": \"W\", \"kind\": \"object\", \"shape\": \"wall\", \"position_m\": [9, 0]"
#define Q7                                                                                         \
    "\"id\": \"A\", \"kind\": \"vehicle\", \"type\": \"suv\", \"mass_kg\": 2550, \"load_kg\": "    \
    "180,"                                                                                         \
    "\"length_m\": 5.086, \"width_m\": 1.983, \"height_m\": 1.737, \"wheelbase_m\": 3.002,"        \
    "\"position_m\": [0, 0]"

static void test_regressions(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_assumed assumed = {0};
    scene_of(Q7, WALL, &s);
    resolve(&s, &assumed);
    const struct cr_participant *a = &s.part[0];
    const struct cr_dims *ref = cr_model_dims(lib, CR_TYPE_SUV, &(double){0});
    /* [TRACK-MASS] 1.330 + 1.39e-4 m; [CG-SHARE] (0.308 + 7.7e-5 m) WB; [CG-HEIGHT] 0.511 +
     * 8.05e-5 m; [YAW-INERTIA] 0.137 m L
     * WB */
    check_near(a->kerb_mass, 2370, 1e-9);
    check_near(a->track, 1.68445, 1e-9);
    check_near(a->cg_behind_front_axle, 3.002 * 0.50435, 1e-9);
    check_near(a->cg_height, 0.716275, 1e-9);
    check_near(a->yaw_inertia, 5333.93589, 1e-4);
    check_near(a->front_overhang,
               (5.086 - 3.002) * ref->front_overhang / (ref->length - ref->wheelbase), 1e-12);
    check_near(a->course, 0, 0);
    check_near(s.part[1].z_hi, 3, 0);
    static const char *const want[] = {
        "A.track_m",     "A.front_overhang_m", "A.cg.behind_front_axle_m",
        "A.cg.height_m", "A.yaw_inertia_kgm2", "W.height_m"};
    assert_int_equal(assumed.n, 6);
    for (int i = 0; i < 6; i++) {
        assert_string_equal(assumed.key[i], want[i]);
    }
    /* nothing is assumed twice */
    cr_assumed_fini(&assumed);
    resolve(&s, &assumed);
    assert_int_equal(assumed.n, 0);
    cr_assumed_fini(&assumed);
    cr_scene_fini(&s);
}

/* a load makes no car longer and no structure stronger */
static void test_sizes_from_type(void **state) {
    (void)state;
    double m;
    const struct cr_dims *ref = cr_model_dims(lib, CR_TYPE_COMPACT, &m);
    struct cr_scene s;
    scene_of(CAR_A, CAR_B, &s);
    struct cr_participant *a = &s.part[0], *b = &s.part[1];
    a->mass = m;
    b->mass = m * 1.4;
    resolve(&s, NULL);
    check_near(a->kerb_mass, m - CR_TEST_LOAD, 1e-9);
    check_near(a->load, CR_TEST_LOAD, 1e-9);
    check_near(b->kerb_mass, a->kerb_mass, 1e-9);
    check_near(b->mass, m * 1.4, 1e-9);
    check_near(b->load, m * 1.4 - a->kerb_mass, 1e-9);
    for (int i = 0; i < 2; i++) {
        check_near(s.part[i].length, ref->length, 1e-12);
        check_near(s.part[i].width, ref->width, 1e-12);
        check_near(s.part[i].height, ref->height, 1e-12);
        check_near(s.part[i].wheelbase, ref->wheelbase, 1e-12);
        check_near(cr_scene_query(&s, &s.part[i], 0).mass_kg, m, 1e-9);
    }
    check_near(b->yaw_inertia, 1.4 * a->yaw_inertia, 1e-6);
    cr_scene_fini(&s);
    /* a car that was built heavier is longer, by no more than a fifth */
    scene_of(CAR_A, CAR_B, &s);
    s.part[0].kerb_mass = m * 1.331 - CR_TEST_LOAD;
    s.part[1].kerb_mass = 9000;
    resolve(&s, NULL);
    check_near(s.part[0].length, 1.1 * ref->length, 1e-9);
    check_near(s.part[0].width, sqrt(1.1) * ref->width, 1e-9);
    check_near(s.part[1].length, 1.2 * ref->length, 1e-9);
    cr_scene_fini(&s);
    /* a wheelbase that is known decides the length, and that the kerb mass */
    scene_of(CAR_A ", \"wheelbase_m\": 2.5", CAR_B, &s);
    resolve(&s, NULL);
    check_near(s.part[0].length, ref->length * 2.5 / ref->wheelbase, 1e-11);
    check_near(s.part[0].kerb_mass, (m - CR_TEST_LOAD) * pow(2.5 / ref->wheelbase, 2.7), 1e-6);
    cr_scene_fini(&s);
}

/* any two of mass, kerb mass and load say the third */
static void test_masses(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_error err = {0};
    static const struct {
        double mass, kerb, load, want[3];
    } rows[] = {
        {1600, NAN, 200, {1600, 1400, 200}},
        {NAN, 1400, 200, {1600, 1400, 200}},
        {NAN, 1400, NAN, {1400, 1400, 0}},
        {1600, 1400, NAN, {1600, 1400, 200}},
        {1300, 1400, NAN, {1300, 1400, 0}},
        {900, NAN, NAN, {900, 900, 0}}, /* lighter than its type */
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        scene_of(CAR_A, CAR_B, &s);
        s.part[0].mass = rows[i].mass;
        s.part[0].kerb_mass = rows[i].kerb;
        s.part[0].load = rows[i].load;
        resolve(&s, NULL);
        check_near(s.part[0].mass, rows[i].want[0], 1e-9);
        check_near(s.part[0].kerb_mass, rows[i].want[1], 1e-9);
        check_near(s.part[0].load, rows[i].want[2], 1e-9);
        cr_scene_fini(&s);
    }
    scene_of(CAR_A, CAR_B, &s);
    s.part[0].kerb_mass = 1300;
    s.part[0].load = 400;
    assert_int_equal(cr_scene_resolve(&s, lib, NULL, &err), CR_ERR_RANGE);
    assert_non_null(strstr(err.where, "load_kg"));
    cr_scene_fini(&s);
}

static void test_methods_decide_what_is_not_given(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_error err;
    scene_of(CAR_A, CAR_B, &s);
    resolve(&s, NULL);
    assert_true(s.set.friction_auto);
    assert_true(s.set.induced == 1 && s.set.heights == 1 && s.set.residual_curve == 0);
    cr_scene_fini(&s);
    scene_of(CAR_A, CAR_B, &s);
    assert_int_equal(cr_scene_set(&s, "method", "paper", &err), CR_ERR_OK);
    assert_int_equal(cr_scene_set(&s, "heights", "on", &err), CR_ERR_OK);
    resolve(&s, NULL);
    assert_false(s.set.friction_auto);
    check_near(s.set.friction, 0, 0);
    check_near(s.set.elastic, 5e-3, 0);
    assert_true(s.set.induced == 0 && s.set.heights == 1 && s.set.residual_curve == 1);
    cr_scene_fini(&s);
}

/* elastic phases: from the force in the extended profile, 5 ms in the paper's, unless given */
static void test_elastic_phases_of_the_methods(void **state) {
    (void)state;
    static const struct {
        const char *method, *value;
        bool by_itself;
        double s;
    } row[] = {{"extended", NULL, true, 0},
               {"paper", NULL, false, 5e-3},
               {"paper", "auto", true, 0},
               {"extended", "3ms", false, 3e-3}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct cr_scene s;
        struct cr_compiled c;
        struct cr_error err;
        scene_of(CAR_A, CAR_B, &s);
        assert_int_equal(cr_scene_set(&s, "method", row[i].method, &err), CR_ERR_OK);
        if (row[i].value != NULL) {
            assert_int_equal(cr_scene_set(&s, "elastic", row[i].value, &err), CR_ERR_OK);
        }
        resolve(&s, NULL);
        compile(&s, &c);
        assert_int_equal(s.set.elastic_auto, row[i].by_itself);
        check_near(c.cs.opts.elastic_s, row[i].s, 1e-18);
        cr_compiled_fini(&c);
        cr_scene_fini(&s);
    }
}

static void test_contradictions_show_once_all_is_known(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_error err = {0};
    scene_of(CAR_A ", \"wheelbase_m\": 2.7, \"length_m\": 4.5, \"front_overhang_m\": 0.8", CAR_B,
             &s);
    s.part[0].cg_behind_front_axle = 2.8;
    assert_int_equal(cr_scene_resolve(&s, lib, NULL, &err), CR_ERR_RANGE);
    assert_string_equal(err.where, "/participants/0/cg/behind_front_axle_m");
    assert_string_equal(err.hint, "the centre of gravity lies between the axles");
    cr_scene_fini(&s);

    cr_scene_init(&s);
    assert_int_equal(cr_scene_add(&s, "A", CR_KIND_VEHICLE, NULL, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_resolve(&s, lib, NULL, &err), CR_ERR_MISSING);
    assert_int_equal(cr_scene_add(&s, "B", CR_KIND_OBJECT, NULL, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_resolve(&s, lib, NULL, &err), CR_ERR_MISSING);
    assert_string_equal(err.where, "/participants/0");
    assert_string_equal(err.text, "vehicle \"A\" has neither type, car, mass nor size");
    cr_scene_fini(&s);
}

/* what is not said comes from the catalogue, else from size or mass, and is told */
static void test_kind_and_mass_are_assumed(void **state) {
    (void)state;
    static const struct {
        const char *keys;
        enum cr_type type;
        double lo, hi, spread; /* mass */
    } row[] = {
        {"\"length_m\": 4.857, \"width_m\": 1.833, \"height_m\": 1.454", CR_TYPE_SEDAN, 1600, 1700,
         0.11},
        {"\"length_m\": 3.5", CR_TYPE_SUPER_COMPACT, 1100, 1140, 0.11},
        {"\"length_m\": 4.1, \"height_m\": 1.8", CR_TYPE_SUV, 1500, 1900, 0.11},
        {"\"mass_kg\": 1400", CR_TYPE_COMPACT, 1400, 1400, 0},
        {"\"type\": \"auto\"", CR_TYPE_SEDAN, 1600, 1700, 0.15},
        {"\"car\": \"volkswagen golf 2015\"", CR_TYPE_COMPACT, 1390, 1480, 0.06},
        {"\"car\": \"2015 GOLF vw\", \"mass_kg\": 1500", CR_TYPE_COMPACT, 1500, 1500, 0},
        {"\"car\": \"vw golf 2015\", \"type\": \"suv\"", CR_TYPE_SUV, 1390, 1480, 0.06},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        char a[300];
        struct cr_scene s;
        struct cr_assumed assumed = {0};
        snprintf(a, sizeof a, "\"id\": \"A\", \"kind\": \"vehicle\", %s, \"position_m\": [0, 0]",
                 row[i].keys);
        scene_of(a, WALL, &s);
        resolve(&s, &assumed);
        assert_int_equal(s.part[0].type, row[i].type);
        assert_true(s.part[0].mass >= row[i].lo && s.part[0].mass <= row[i].hi);
        check_near(assumed.mass_spread[0], row[i].spread, 1e-12);
        cr_assumed_fini(&assumed);
        cr_scene_fini(&s);
    }
    struct cr_scene s;
    struct cr_error err;
    scene_of(
        "\"id\": \"A\", \"kind\": \"vehicle\", \"car\": \"toyota corola\", \"position_m\": [0, 0]",
        WALL, &s);
    assert_int_equal(cr_scene_resolve(&s, lib, NULL, &err), CR_ERR_NAME);
    assert_string_equal(err.where, "/participants/0/car");
    assert_non_null(strstr(err.hint, "corolla"));
    cr_scene_fini(&s);
}

static void test_wheels_carry_the_weight(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_compiled c;
    scene_of(CAR_A ", \"length_m\": 4.5, \"wheelbase_m\": 2.5, \"track_m\": 1.5,"
                   "\"cg\": { \"behind_front_axle_m\": 1.0 }, \"yaw_inertia_kgm2\": 2100,"
                   "\"brake\": [1, 0.5, 0, 0], \"steer_deg\": 90, \"locked\": [false, false, true, "
                   "false], \"heading_deg\": 90, \"course_deg\": 180, \"speed_kmh\": 36,"
                   "\"yaw_rate_deg_s\": 180",
             WALL, &s);
    resolve(&s, NULL);
    compile(&s, &c);
    const struct cr_body *a = &c.cs.body[0];
    assert_int_equal(a->wheels, 4);
    /* the front axle is nearer: 1.5/2.5 of 1400 kg g, half on each side */
    check_near(a->wheel[0].load, 1400 * 9.80665 * 0.6 / 2, 1e-9);
    check_near(a->wheel[3].load, 1400 * 9.80665 * 0.4 / 2, 1e-9);
    static const struct cr_vec2 at[] = {{1, 0.75}, {1, -0.75}, {-1.5, 0.75}, {-1.5, -0.75}};
    for (int w = 0; w < 4; w++) {
        check_near(a->wheel[w].at.x, at[w].x, 1e-12);
        check_near(a->wheel[w].at.y, at[w].y, 1e-12);
        check_near(a->wheel[w].steer, CR_PI / 2, 1e-15);
        assert_int_equal(a->wheel[w].locked, w == 2);
    }
    check_near(a->wheel[1].brake, 0.5, 0);
    check_near(a->vel.x, -10, 1e-12);
    check_near(a->vel.y, 0, 1e-12);
    check_near(a->yaw_rate, CR_PI, 1e-12);
    check_near(a->inertia, 2100, 0);
    assert_true(a->friction < 0);
    assert_int_equal(c.cs.body[1].shape.kind, CR_SHAPE_WALL);
    assert_true(c.cs.body[1].mass <= 0);
    assert_int_equal(c.cs.body[1].wheels, 0);
    assert_string_equal(c.model[0], "compact/12");
    assert_string_equal(c.hash[0], cr_model_hash(lib, CR_TYPE_COMPACT));
    cr_compiled_fini(&c);
    cr_scene_fini(&s);
}

static void test_settings_become_options(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_compiled c;
    scene_from("{ \"crumple\": 1, \"settings\": { \"method\": \"paper\", \"restitution\": 0.2,"
               "\"road_friction\": 0.6, \"dt_ms\": 0.2, \"voxel_mm\": 50, \"elastic_ms\": 3,"
               "\"end\": \"rest\" }, \"participants\": [ { " CAR_A " }, { " WALL
               ", \"friction\": 0.7 } ] }",
               &s);
    resolve(&s, NULL);
    compile(&s, &c);
    const struct cr_opts *o = &c.cs.opts;
    check_near(o->restitution, 0.2, 0);
    check_near(o->road_friction, 0.6, 0);
    check_near(o->friction, 0, 0);
    check_near(o->dt, 2e-4, 1e-18);
    check_near(o->elastic_s, 3e-3, 1e-18);
    assert_true(o->end == CR_END_REST && !o->induced && !o->restitution_auto);
    check_near(c.cs.body[0].grid.h, 0.05, 0);
    check_near(c.cs.body[1].friction, 0.7, 0);
    cr_compiled_fini(&c);
    cr_scene_fini(&s);
}

#define BOX                                                                                        \
    "\"id\": \"O\", \"kind\": \"object\", \"shape\": \"box\", \"length_m\": 4, \"width_m\": 2,"    \
    "\"edge_radius_m\": 0.25, \"mass_kg\": 1200, \"position_m\": [9, 0]"

static void test_objects_have_the_inertia_of_their_shape(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_compiled c;
    scene_of(CAR_A, BOX, &s);
    resolve(&s, NULL);
    compile(&s, &c);
    const struct cr_body *o = &c.cs.body[1];
    check_near(o->inertia, 1200 * (16 + 4) / 12.0, 1e-9);
    assert_int_equal(o->shape.kind, CR_SHAPE_POLYGON);
    assert_int_equal(o->shape.n, 4);
    check_near(o->shape.edge_radius, 0.25, 0);
    check_near(o->shape.vertex[2].x, 1.75, 1e-12);
    check_near(o->shape.vertex[2].y, 0.75, 1e-12);
    cr_compiled_fini(&c);
    cr_scene_fini(&s);

    scene_of(CAR_A,
             "\"id\": \"O\", \"kind\": \"object\", \"shape\": \"pole\", \"radius_m\": 0.4,"
             "\"mass_kg\": 50, \"position_m\": [9, 0]",
             &s);
    resolve(&s, NULL);
    compile(&s, &c);
    check_near(c.cs.body[1].inertia, 50 * 0.16 / 2, 1e-12);
    check_near(c.cs.body[1].shape.radius, 0.4, 0);
    cr_compiled_fini(&c);
    cr_scene_fini(&s);

    /* right triangle with legs of 3 m: centroid (1, 1), polar moment over area (9 + 9 + 18)/36 */
    scene_of(
        CAR_A,
        "\"id\": \"O\", \"kind\": \"object\", \"shape\": \"polygon\", \"mass_kg\": 70,"
        "\"vertices_m\": [[0, 0], [3, 0], [0, 3]], \"position_m\": [9, 0], \"heading_deg\": 90",
        &s);
    resolve(&s, NULL);
    compile(&s, &c);
    o = &c.cs.body[1];
    check_near(o->inertia, 70, 1e-9);
    check_near(o->pos.x, 9 - 1, 1e-12);
    check_near(o->pos.y, 1, 1e-12);
    check_near(o->shape.vertex[1].x, 2, 1e-12);
    check_near(o->shape.vertex[1].y, -1, 1e-12);
    cr_compiled_fini(&c);
    cr_scene_fini(&s);
}

static void test_trajectories_are_followed_by_the_centroid(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_compiled c;
    scene_of(CAR_A,
             "\"id\": \"O\", \"kind\": \"object\", \"shape\": \"polygon\", \"mass_kg\": 70,"
             "\"vertices_m\": [[0, 0], [3, 0], [0, 3]], \"trajectory\": ["
             "{ \"t_s\": 0, \"x_m\": 20, \"y_m\": 0, \"heading_deg\": 180, \"speed_kmh\": 36 },"
             "{ \"t_s\": 1, \"x_m\": 10, \"y_m\": 0, \"heading_deg\": 180, \"speed_kmh\": 36 } ]",
             &s);
    resolve(&s, NULL);
    compile(&s, &c);
    const struct cr_body *o = &c.cs.body[1];
    assert_int_equal(o->waypoints, 2);
    check_near(o->pos.x, 19, 1e-12);
    check_near(o->pos.y, -1, 1e-12);
    check_near(o->waypoint[1].pos.x, 9, 1e-12);
    check_near(o->vel.x, -10, 1e-12);
    check_near(o->heading, CR_PI, 1e-12);
    cr_compiled_fini(&c);
    cr_scene_fini(&s);
}

static double sum(const double *x, const struct cr_grid *g) {
    double e = 0;
    for (int i = 0; i < g->nx * g->ny; i++) {
        e += x[i];
    }
    return e;
}

static void test_heights_that_meet(void **state) {
    (void)state;
    struct cr_scene s;
    struct cr_compiled c;
    struct cr_error err;
    scene_of(CAR_A, BOX ", \"height_m\": [0, 0.3]", &s);
    assert_int_equal(cr_scene_add(&s, "W", CR_KIND_OBJECT, NULL, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_add(&s, "sign", CR_KIND_OBJECT, NULL, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_set(&s, "sign.height_m", "2.5,3", &err), CR_ERR_OK);
    assert_int_equal(cr_scene_add(&s, "kerb", CR_KIND_OBJECT, NULL, &err), CR_ERR_OK);
    assert_int_equal(cr_scene_set(&s, "kerb.height_m", "0,0.3", &err), CR_ERR_OK);
    resolve(&s, NULL);
    compile(&s, &c);
    const struct cr_body *a = &c.cs.body[0];
    double whole = sum(a->grid.energy, &a->grid);
    assert_non_null(a->against[1].energy[0]);
    assert_true(sum(a->against[1].energy[0], &a->grid) < 0.5 * whole);
    assert_null(a->against[2].energy[0]);
    assert_non_null(a->against[3].energy[0]);
    check_near(sum(a->against[3].energy[0], &a->grid), 0, 0);
    assert_ptr_equal(a->against[4].energy[0], a->against[1].energy[0]);
    cr_compiled_fini(&c);
    s.set.heights = 0;
    compile(&s, &c);
    assert_null(c.cs.body[0].against[1].energy[0]);
    cr_compiled_fini(&c);
    cr_scene_fini(&s);
}

static void test_stiffness_and_missing_files(void **state) {
    (void)state;
    static const double pdof[CR_BODY_MAX] = {0};
    struct cr_scene s;
    struct cr_compiled c;
    struct cr_error err = {0};
    scene_of(CAR_A ", \"model\": { \"stiffness\": { \"front\": { \"A_N_per_m\": 92000,"
                   "\"B_N_per_m2\": 429000 } } }",
             CAR_B ", \"model\": { \"pdof\": 100 }", &s);
    resolve(&s, NULL);
    compile(&s, &c);
    assert_string_equal(c.model[0], "stiffness");
    assert_string_equal(c.model[1], "compact/3");
    cr_compiled_fini(&c);
    cr_scene_fini(&s);
    scene_of(CAR_A ", \"model\": { \"file\": \"nowhere.json\" }", CAR_B, &s);
    resolve(&s, NULL);
    assert_int_equal(cr_scene_compile(&s, lib, pdof, &c, &err), CR_ERR_IO);
    assert_string_equal(err.where, "/participants/0/model");
    assert_int_equal(c.cs.n, 0);
    cr_scene_fini(&s);
}

static void test_placed_without_gap_is_no_overlap(void **state) {
    (void)state;
    static const struct cr_place how[] = {
        {.rel = CR_PLACE_FACING, .overlap = 0.4, .overlap_side = 1},
        {.rel = CR_PLACE_FACING, .overlap = 1, .angle = 0.3},
        {.rel = CR_PLACE_BEHIND, .overlap = 1},
        {.rel = CR_PLACE_BESIDE, .side = CR_FACE_LEFT},
        {.rel = CR_PLACE_HITTING, .side = CR_FACE_RIGHT, .along = 2},
    };
    struct cr_scene s;
    struct cr_compiled c;
    struct cr_error err = {0};
    scene_of(CAR_A ", \"heading_deg\": 33, \"length_m\": 3.8", CAR_B ", \"length_m\": 3.8", &s);
    resolve(&s, NULL);
    for (size_t i = 0; i < sizeof how / sizeof how[0]; i++) {
        struct cr_solver *solver = NULL;
        assert_int_equal(cr_scene_place(&s, "B", "A", &how[i], &err), CR_ERR_OK);
        compile(&s, &c);
        if (cr_solver_new(&c.cs, &solver, &err) != CR_ERR_OK) {
            fail_msg("placement %zu: %s", i, err.text);
        }
        cr_solver_free(solver);
        cr_compiled_fini(&c);
    }
    cr_scene_fini(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_regressions),
        cmocka_unit_test(test_kind_and_mass_are_assumed),
        cmocka_unit_test(test_sizes_from_type),
        cmocka_unit_test(test_masses),
        cmocka_unit_test(test_methods_decide_what_is_not_given),
        cmocka_unit_test(test_elastic_phases_of_the_methods),
        cmocka_unit_test(test_contradictions_show_once_all_is_known),
        cmocka_unit_test(test_wheels_carry_the_weight),
        cmocka_unit_test(test_settings_become_options),
        cmocka_unit_test(test_objects_have_the_inertia_of_their_shape),
        cmocka_unit_test(test_trajectories_are_followed_by_the_centroid),
        cmocka_unit_test(test_heights_that_meet),
        cmocka_unit_test(test_stiffness_and_missing_files),
        cmocka_unit_test(test_placed_without_gap_is_no_overlap),
    };
    return cmocka_run_group_tests(tests, open_models, close_models);
}
