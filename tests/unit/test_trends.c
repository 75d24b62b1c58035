/* What must change smoothly or in one direction when an input does: a wall that is turned, a speed
 * that rises, an overlap that grows, with the real models. */
#include "result_models.h"
#include "test.h"

#include "base/str.h"
#include "solver/solver.h"

#include <string.h>

static struct cr_result *solved(struct cr_str *json) {
    struct cr_scene scene;
    struct cr_result *r;
    struct cr_error err;
    const char *text = cr_str_get(json);
    if (cr_scene_parse(text, strlen(text), "test", &scene, &err) != CR_ERR_OK ||
        cr_result_run(&scene, &ctx, &r, &err) != CR_ERR_OK) {
        fail_msg("%s (%s)", err.text, err.hint);
    }
    cr_scene_fini(&scene);
    cr_str_fini(json);
    return r;
}

static struct cr_result *turned_wall(double deg) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\","
                "\"type\":\"sedan\",\"mass_kg\":1600,\"position_m\":[0,0],\"heading_deg\":0,"
                "\"speed_kmh\":50},{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"wall\","
                "\"position_m\":[6,0],\"heading_deg\":%g}]}",
                180 - deg);
    return solved(&json);
}

/* At 51.5 to 54 degrees the first edition's sectors of the direction of force flipped: the yaw rate
 * jumped from -149 to -65 deg/s. From a wall that is met head on to one along which the car slides
 * no half degree may change it by 8 deg/s, EES by 0.6 and delta-v by 1.1 km/h: the whole way they
 * change by 180, 41 and 45. One step is left and is no flip of the model: from some angle on the
 * tail reaches the wall within 0.3 s and belongs to the crash (what touches later is another). */
static void a_turned_wall_shows_no_jump(void **state) {
    (void)state;
    double before[3] = {0};
    int contacts = 0, changes = 0;
    for (double deg = 10; deg <= 76; deg += 0.5) {
        struct cr_result *r = turned_wall(deg);
        const struct cr_severity *s = &r->of[0];
        const double now[3] = {cr_deg(s->yaw_rate_change), cr_kmh(s->ees), cr_kmh(s->delta_v)};
        if (contacts == r->solution->contacts) {
            check_near(now[0], before[0], 8);
            check_near(now[1], before[1], 0.6);
            check_near(now[2], before[2], 1.1);
        } else {
            changes += contacts > 0;
        }
        contacts = r->solution->contacts;
        memcpy(before, now, sizeof before);
        cr_result_free(r);
    }
    assert_true(changes <= 1);
}

/* What has turned away from a wall presses on it no more until the tail slaps. A millimetre does
 * not decide whether (+54 and +1, +66 and +9 deg/s, when the place of an elastic phase slid from
 * the dent to where the car still came closer). */
static void what_has_parted_presses_no_more(void **state) {
    (void)state;
    static const struct {
        const char *type;
        double mass, speed, heading;
    } hits[] = {{"mini-compact", 1283, 60.6, 123.45}, {"super-compact", 973, 57.7, 121.29}};
    for (int i = 0; i < 2; i++) {
        double first = 0;
        for (int k = 0; k < 5; k++) {
            struct cr_str json = {0};
            cr_str_addf(&json,
                        "{\"crumple\":1,\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\","
                        "\"type\":\"%s\",\"mass_kg\":%g,\"position_m\":[0,%g],"
                        "\"heading_deg\":0,\"speed_kmh\":%g},{\"id\":\"W\",\"kind\":\"object\","
                        "\"shape\":\"wall\",\"position_m\":[6,0],\"heading_deg\":%g}]}",
                        hits[i].type, hits[i].mass, 0.001 * k, hits[i].speed, hits[i].heading);
            struct cr_result *r = solved(&json);
            double yaw = cr_deg(r->of[0].yaw_rate_change);
            first = k == 0 ? yaw : first;
            check_near(yaw, first, 3);
            cr_result_free(r);
        }
    }
}

/* the demonstration of the paper with other speeds and overlaps */
static struct cr_result *demo(double speed, double overlap) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"settings\":{\"restitution\":0.1},\"participants\":["
                "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"suv\",\"kerb_mass_kg\":2370,"
                "\"load_kg\":180,\"length_m\":5.086,\"width_m\":1.983,\"height_m\":1.737,"
                "\"wheelbase_m\":3.002,\"position_m\":[0,0],\"heading_deg\":0,\"speed_kmh\":%g},"
                "{\"id\":\"B\",\"kind\":\"vehicle\",\"type\":\"super-compact\","
                "\"kerb_mass_kg\":940,\"load_kg\":180,\"length_m\":3.546,\"width_m\":1.627,"
                "\"height_m\":1.488,\"wheelbase_m\":2.3,\"position_m\":[4.0937,%g],"
                "\"heading_deg\":180,\"speed_kmh\":%g}]}",
                speed, 1.983 / 2 - overlap * 1.627 + 1.627 / 2, speed);
    return solved(&json);
}

static void check_rises(double value, double *before, const char *what, double at) {
    if (value < *before - cr_mps(0.2)) {
        fail_msg("%s falls from %.2f to %.2f km/h at %g", what, cr_kmh(*before), cr_kmh(value), at);
    }
    *before = value;
}

/* Up to 2 x 120 km/h, with the small car's front met by 40 % and more. */
static void delta_v_rises_with_the_speed(void **state) {
    (void)state;
    static const double overlap[] = {0.4, 0.6, 1};
    for (int k = 0; k < 3; k++) {
        double before[2] = {0};
        for (double v = 40; v <= 120; v += k > 0 ? 16 : 4) {
            struct cr_result *r = demo(v, overlap[k]);
            check_rises(r->of[0].delta_v, &before[0], "delta-v of A", v);
            check_rises(r->of[1].delta_v, &before[1], "delta-v of B", v);
            cr_result_free(r);
        }
    }
}

static void delta_v_rises_with_the_overlap(void **state) {
    (void)state;
    double before[2] = {0};
    for (double overlap = 0.2; overlap < 1.01; overlap += 0.1) {
        struct cr_result *r = demo(56, overlap);
        check_rises(r->of[0].delta_v, &before[0], "delta-v of A", overlap);
        check_rises(r->of[1].delta_v, &before[1], "delta-v of B", overlap);
        cr_result_free(r);
    }
}

/* Depth of a flank at the pole of the side tests; the year is not known where it is 0. */
static double depth_at_side_pole(int year) {
    struct cr_str json = {0};
    cr_str_add(&json, "{\"crumple\":1,\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\","
                      "\"type\":\"sedan\",\"mass_kg\":1600,");
    if (year > 0) {
        cr_str_addf(&json, "\"built\":%d,", year);
    }
    cr_str_add(&json, "\"position_m\":[0,0],\"heading_deg\":0,\"course_deg\":75,"
                      "\"speed_kmh\":32},{\"id\":\"P\",\"kind\":\"object\",\"shape\":\"pole\","
                      "\"radius_m\":0.127,\"position_m\":[-0.3,1.07]}]}");
    struct cr_result *r = solved(&json);
    double depth = r->of[0].face_depth;
    cr_result_free(r);
    return depth;
}

/* Of 267 cars at the side pole those of up to 2013 were dented 1.33 times as deep as those of 2017
 * and later, within their types. */
static void newer_flanks_stand_more(void **state) {
    (void)state;
    double old = depth_at_side_pole(2012), unknown = depth_at_side_pole(0),
           new = depth_at_side_pole(2019);
    print_message("# side pole, m: 2012 %.3f, year not known %.3f, 2019 %.3f\n", old, unknown, new);
    assert_true(unknown < old);
    assert_true(new < unknown);
    check_near(old / new, 1.33, 0.05);
    check_near(depth_at_side_pole(1998), old, 0);
}

/* A pole in front that is moved along the grid: depth and peak may not hang on which voxel it
 * meets. With 25 mm they ripple about their mean by 2 and 7 % at most; both halve with half the
 * voxel. */
static void a_pole_meets_no_voxel(void **state) {
    (void)state;
    enum { PLACES = 10 };
    double depth[PLACES], peak[PLACES], mean[2] = {0};
    for (int i = 0; i < PLACES; i++) {
        struct cr_str json = {0};
        cr_str_addf(&json,
                    "{\"crumple\":1,\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\","
                    "\"type\":\"sedan\",\"position_m\":[0,0],\"heading_deg\":0,"
                    "\"speed_kmh\":40},{\"id\":\"P\",\"kind\":\"object\",\"shape\":\"pole\","
                    "\"radius_m\":0.15,\"position_m\":[3.5,%g]}]}",
                    0.1 + 0.005 * i);
        struct cr_result *r = solved(&json);
        depth[i] = r->of[0].face_depth_dynamic;
        peak[i] = r->of[0].acceleration_max;
        mean[0] += depth[i] / PLACES;
        mean[1] += peak[i] / PLACES;
        cr_result_free(r);
    }
    for (int i = 0; i < PLACES; i++) {
        check_near(depth[i] / mean[0], 1, 0.02);
        check_near(peak[i] / mean[1], 1, 0.07);
    }
}

/* energy and depth of a sedan that meets a rigid block with a share of its width, head on */
static void crush(double overlap, double speed, double *depth, double *energy) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"settings\":{\"restitution\":0},\"participants\":["
                "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"sedan\",\"mass_kg\":1666,"
                "\"width_m\":1.833,\"yaw_inertia_kgm2\":9800,\"position_m\":[2.4,%g],"
                "\"heading_deg\":180,\"speed_kmh\":%g},{\"id\":\"W\",\"kind\":\"object\","
                "\"shape\":\"box\",\"length_m\":2,\"width_m\":2,\"position_m\":[-1,0]}]}",
                1 - overlap * 1.833 + 0.9165, speed);
    struct cr_result *r = solved(&json);
    *depth = r->of[0].face_depth_dynamic;
    *energy = r->of[0].energy;
    cr_result_free(r);
}

enum { SPEEDS = 17 };

/* Energy of a front over its depth, linear between speeds 4 km/h apart. */
struct front {
    int n;
    double depth[SPEEDS], energy[SPEEDS];
};

static void front_of(double overlap, struct front *f) {
    for (f->n = 0; f->n < SPEEDS && (f->n == 0 || f->depth[f->n - 1] < 0.75); f->n++) {
        crush(overlap, 20 + 4 * f->n, &f->depth[f->n], &f->energy[f->n]);
    }
    assert_true(f->depth[f->n - 1] >= 0.75);
}

static double energy_at(const struct front *f, double depth) {
    int i = 1;
    while (i + 1 < f->n && f->depth[i] < depth) {
        i++;
    }
    double per = (f->energy[i] - f->energy[i - 1]) / (f->depth[i] - f->depth[i - 1]);
    return f->energy[i - 1] + per * (depth - f->depth[i - 1]);
}

/* mean force in the 0.2 m about a depth */
static double force_at(const struct front *f, double depth) {
    return (energy_at(f, depth + 0.1) - energy_at(f, depth - 0.1)) / 0.2;
}

/* Share of the force that part of the width takes, against the full width at the same depth: of
 * 40 % at 0.6 m it is 55 to 60 % [OFFSET-SHARE]; a quarter, beside the rail, holds less, half holds
 * more. The shares by depth are printed. */
static void force_share_of_an_offset(void **state) {
    (void)state;
    static const double overlap[] = {1.05, 0.5, 0.4, 0.25};
    struct front of[4];
    for (int i = 0; i < 4; i++) {
        front_of(overlap[i], &of[i]);
    }
    print_message("# depth, m  full, kN   50 %%   40 %%   25 %%\n");
    for (int k = 4; k < 7; k++) {
        double depth = 0.1 * k, full = force_at(&of[0], depth), share[4];
        for (int i = 1; i < 4; i++) {
            share[i] = force_at(&of[i], depth) / full;
        }
        print_message("# %7.1f %11.0f %7.2f %6.2f %6.2f\n", depth, full / 1e3, share[1], share[2],
                      share[3]);
        assert_true(share[3] > 0.2 && share[3] < 0.85 * share[2] && share[2] < share[1] + 0.02);
    }
    check_near(force_at(&of[2], 0.6) / force_at(&of[0], 0.6), 0.575, 0.06);
}

/* a compact car of 1200 kg kerb mass on a wall */
static struct cr_result *laden(double load, double energy) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"settings\":{\"restitution\":0},\"participants\":["
                "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"compact\","
                "\"kerb_mass_kg\":1200,\"load_kg\":%g,\"position_m\":[0,0],"
                "\"heading_deg\":0,\"speed_kmh\":%.12g},{\"id\":\"W\",\"kind\":\"object\","
                "\"shape\":\"wall\",\"position_m\":[2.4,0],\"heading_deg\":180}]}",
                load, cr_kmh(sqrt(2 * energy / (1200 + load))));
    return solved(&json);
}

/* A load makes no structure stronger: at the same energy an empty car and one with 400 kg in it
 * are crushed to the same depth, at the same speed the laden one deeper. */
static void a_load_is_no_stiffness(void **state) {
    (void)state;
    for (double kj = 20; kj <= 140; kj += 60) {
        struct cr_result *empty = laden(0, kj * 1e3), *full = laden(400, kj * 1e3);
        struct cr_result *fast = laden(400, kj * 1e3 * 1600 / 1200);
        double depth = empty->of[0].face_depth_dynamic;
        check_near(full->of[0].face_depth_dynamic, depth, 0.005 * depth);
        assert_true(fast->of[0].face_depth_dynamic > 1.1 * depth);
        cr_result_free(empty);
        cr_result_free(full);
        cr_result_free(fast);
    }
}

static struct cr_result *bump(const char *type, double speed) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\","
                "\"type\":\"%s\",\"position_m\":[0,0],\"heading_deg\":0,\"speed_kmh\":%g},"
                "{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"wall\",\"position_m\":[2.6,0],"
                "\"heading_deg\":180}]}",
                type, speed);
    return solved(&json);
}

/* Below the threshold of damage, about 8 km/h on a wall [LOW-SPEED], nothing is left of a crush:
 * no depth, no area, no width. From there the residual depth rises without a step. */
static void a_bump_leaves_nothing(void **state) {
    (void)state;
    static const char *const type[] = {"super-compact", "mini-compact", "compact",
                                       "station-wagon", "sedan",        "suv"};
    for (size_t t = 0; t < sizeof type / sizeof type[0]; t++) {
        double before = 0;
        for (double v = 5; v <= 16; v += v < 9 ? 1 : 0.5) {
            struct cr_result *r = bump(type[t], v);
            const struct cr_severity *s = &r->of[0];
            if (v < 7.5) {
                assert_true(s->face_depth == 0 && s->deformation_area == 0 && s->damage_width == 0);
                assert_true(s->face_depth_dynamic > 0);
            }
            assert_true(v < 9.5 || s->face_depth > 0);
            assert_true(s->face_depth >= before && s->face_depth - before < 0.012);
            before = s->face_depth;
            cr_result_free(r);
        }
    }
}

/* Of whole fronts on a wall comes back 0.2 to 0.4 below 15 km/h and less the faster it is, 0.14 to
 * 0.18 from 40 km/h on [RESTITUTION-SPEED]; voxels make no ripple. */
static void less_comes_back_of_a_faster_crash(void **state) {
    (void)state;
    double before = 0.4;
    for (double v = 3; v <= 60; v += v < 15 ? 0.5 : 4) {
        struct cr_result *r = bump("sedan", v);
        double e = r->solution->contact[0].restitution;
        assert_true(e > (v < 15 ? 0.2 : 0.14) && e < (v < 38 ? 0.4 : 0.18));
        assert_true(e < before + 0.002);
        before = e;
        cr_result_free(r);
    }
}

/* a standing car that is struck in the middle of its flank by another of its type */
static struct cr_result *struck(const char *type, double speed) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\","
                "\"type\":\"%s\",\"position_m\":[0,0],\"heading_deg\":0,\"speed_kmh\":0},"
                "{\"id\":\"B\",\"kind\":\"vehicle\",\"type\":\"%s\",\"position_m\":[0,3.6],"
                "\"heading_deg\":270,\"speed_kmh\":%g}]}",
                type, type, speed);
    struct cr_result *r = solved(&json);
    assert_true(r->of[0].face == CR_FACE_LEFT && r->of[1].face == CR_FACE_FRONT);
    return r;
}

static const char *const six[] = {"super-compact", "mini-compact", "compact",
                                  "station-wagon", "sedan",        "suv"};

/* A door is soft first, a bumper has a threshold: a standing car that is struck in the flank by the
 * front of another of its type at 20 km/h is dented deeper than what struck it. */
static void a_door_is_softer_than_a_bumper(void **state) {
    (void)state;
    for (size_t t = 0; t < sizeof six / sizeof six[0]; t++) {
        struct cr_result *r = struck(six[t], 20);
        assert_true(r->of[0].face_depth > 0.03);
        assert_true(r->of[0].face_depth > 2 * r->of[1].face_depth);
        cr_result_free(r);
    }
}

/* Deep in, the flank is the harder one (sill, pillars, floor): at a lateral delta-v of 31 km/h real
 * flanks were 21 and the fronts that struck them 34 cm deep (medians, NHTSA CISS). From 40 to 60
 * km/h a front gains more than twice what the flank does, and is the deeper one then. */
static void a_deep_flank_is_harder_than_a_bumper(void **state) {
    (void)state;
    for (size_t t = 0; t < sizeof six / sizeof six[0]; t++) {
        struct cr_result *slow = struck(six[t], 40), *fast = struck(six[t], 60);
        double flank = fast->of[0].face_depth, front = fast->of[1].face_depth;
        check_near(cr_kmh(fast->of[0].delta_v), 31, 1.5);
        assert_true(flank < 0.25 && front > flank);
        assert_true(front - slow->of[1].face_depth > 2 * (flank - slow->of[0].face_depth));
        cr_result_free(slow);
        cr_result_free(fast);
    }
}

/* A car of a mass against the MPDB with 50 % overlap, 50 km/h each (`at` 0), the ODB with 40 % at
 * 64 km/h (1) or a wall at 50 km/h (2). */
static struct cr_severity test_of(const char *type, double mass, double width, int at) {
    struct cr_str json = {0};
    static const char *const barrier[] = {
        "\"shape\":\"barrier\",\"barrier\":\"mpdb\",\"speed_kmh\":50",
        "\"shape\":\"barrier\",\"barrier\":\"odb\"", "\"shape\":\"wall\""};
    const double y[] = {0.5, 0.5 + 0.1 * width, 0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\","
                "\"type\":\"%s\",\"mass_kg\":%g,\"width_m\":%g,\"position_m\":[4.6,%g],"
                "\"heading_deg\":180,\"speed_kmh\":%d},{\"id\":\"W\",\"kind\":\"object\",%s,"
                "\"position_m\":[0,0],\"heading_deg\":0}]}",
                type, mass, width, y[at], at == 1 ? 64 : 50, barrier[at]);
    struct cr_result *r = solved(&json);
    struct cr_severity s = r->of[0];
    cr_result_free(r);
    return s;
}

/* Published on the severity of the MPDB [MPDB-SEVERITY]: the pulse is clearly severer than on the
 * ODB, it comes earlier, and is like that of a wall at 50 km/h, while the car is deformed as on the
 * ODB; and the severity is the higher beside the fixed barrier the lighter the car is. */
static void severity_of_the_mpdb(void **state) {
    (void)state;
    static const struct {
        const char *type;
        double mass, width;
    } car[] = {{"mini-compact", 1150, 1.7},
               {"compact", 1400, 1.783},
               {"sedan", 1700, 1.833},
               {"suv", 2000, 1.88}};
    double before = INFINITY;
    for (size_t i = 0; i < sizeof car / sizeof car[0]; i++) {
        struct cr_severity mpdb = test_of(car[i].type, car[i].mass, car[i].width, 0);
        struct cr_severity odb = test_of(car[i].type, car[i].mass, car[i].width, 1);
        struct cr_severity wall = test_of(car[i].type, car[i].mass, car[i].width, 2);
        print_message("# %-13s OLC, g: %.1f %.1f %.1f; residual depth, m: %.2f %.2f %.2f\n",
                      car[i].type, mpdb.olc / CR_G, odb.olc / CR_G, wall.olc / CR_G,
                      mpdb.face_depth, odb.face_depth, wall.face_depth);
        assert_true(mpdb.olc / odb.olc < before);
        before = mpdb.olc / odb.olc;
        assert_true(mpdb.t_depth_max < 0.85 * odb.t_depth_max);
        if (i == 1) { /* a car as heavy as the barrier */
            assert_true(mpdb.olc > 1.1 * odb.olc);
            check_near(mpdb.olc / wall.olc, 1, 0.1);
            check_near(mpdb.face_depth / odb.face_depth, 1, 0.1);
        }
    }
}

/* energy that the ODB takes from a sedan with 40 % overlap, 64 km/h, J */
static double taken_by_the_odb(double gap, double voxel_mm, double dt_ms) {
    struct cr_str json = {0};
    cr_str_addf(&json,
                "{\"crumple\":1,\"settings\":{\"voxel_mm\":%g,\"dt_ms\":%g},\"participants\":["
                "{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"sedan\",\"mass_kg\":1700,"
                "\"width_m\":1.833,\"position_m\":[%g,0.6833],\"heading_deg\":180,"
                "\"speed_kmh\":64},{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"barrier\","
                "\"barrier\":\"odb\",\"position_m\":[0,0],\"heading_deg\":0}]}",
                voxel_mm, dt_ms, 2.6 + gap);
    struct cr_result *r = solved(&json);
    double energy = r->of[1].energy;
    cr_result_free(r);
    return energy;
}

/* Who of car and barrier takes how much hangs neither on voxels and slices nor on a millimetre:
 * half the voxel and a quarter of the slice change it by less than 15 %, a millimetre by less than
 * 4 % (with a pack of 20 MPa, which the car touches from its side, by 50 %). */
static void a_barrier_takes_its_part(void **state) {
    (void)state;
    double usual = taken_by_the_odb(0, 25, 1);
    check_near(taken_by_the_odb(0, 12.5, 0.25) / usual, 1, 0.15);
    for (int i = 1; i < 5; i++) {
        check_near(taken_by_the_odb(0.001 * i, 25, 1) / usual, 1, 0.04);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_turned_wall_shows_no_jump),
        cmocka_unit_test(what_has_parted_presses_no_more),
        cmocka_unit_test(delta_v_rises_with_the_speed),
        cmocka_unit_test(delta_v_rises_with_the_overlap),
        cmocka_unit_test(newer_flanks_stand_more),
        cmocka_unit_test(a_pole_meets_no_voxel),
        cmocka_unit_test(force_share_of_an_offset),
        cmocka_unit_test(a_load_is_no_stiffness),
        cmocka_unit_test(a_bump_leaves_nothing),
        cmocka_unit_test(less_comes_back_of_a_faster_crash),
        cmocka_unit_test(a_door_is_softer_than_a_bumper),
        cmocka_unit_test(a_deep_flank_is_harder_than_a_bumper),
        cmocka_unit_test(severity_of_the_mpdb),
        cmocka_unit_test(a_barrier_takes_its_part),
    };
    return cmocka_run_group_tests(tests, open_models, close_models);
}
