/* libcrumple as its users see it: errors with place and hint, values by name, series, voxels,
 * stacks, cancelling, threads. Only crumple.h is included. */
#include "test.h"

#include "lib/crumple.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static crumple *lib;

/* a car against a wall, at a speed in km/h; voxels and slices are coarse, so that it is quick */
static const char *scene_at(double speed_kmh, char buf[1024]) {
    snprintf(buf, 1024,
             "{\"crumple\":1,\"name\":\"wall\",\"settings\":{\"voxel_mm\":100,\"dt_ms\":2},"
             "\"participants\":[{\"id\":\"A\",\"kind\":\"vehicle\",\"type\":\"compact\","
             "\"mass_kg\":1400,\"position_m\":[0,0],\"heading_deg\":0,\"speed_kmh\":%g},"
             "{\"id\":\"wall\",\"kind\":\"object\",\"shape\":\"wall\",\"position_m\":[4,0],"
             "\"heading_deg\":180}]}",
             speed_kmh);
    return buf;
}

static int open_lib(void **state) {
    (void)state;
    crumple_error err = CRUMPLE_ERROR_INIT;
    int code = crumple_open(getenv("SRC"), &lib, &err);
    if (code != CRUMPLE_OK) {
        print_error("%s (is SRC set?)\n", err.text);
    }
    return code;
}

static int close_lib(void **state) {
    (void)state;
    crumple_close(lib);
    return 0;
}

static crumple_result *solve_with(double speed_kmh, const crumple_options *options) {
    char scene[1024];
    crumple_result *r = NULL;
    crumple_error err = CRUMPLE_ERROR_INIT;
    scene_at(speed_kmh, scene);
    if (crumple_solve(lib, scene, strlen(scene), options, &r, &err) != CRUMPLE_OK) {
        fail_msg("%s: %s", err.where, err.text);
    }
    return r;
}

static double value(const crumple_result *r, const char *name) {
    double x;
    if (crumple_value(r, name, &x) != CRUMPLE_OK) {
        fail_msg("no value %s", name);
    }
    return x;
}

static void test_versions(void **state) {
    (void)state;
    assert_int_equal(crumple_version_number(), CRUMPLE_VERSION_NUMBER);
    char text[32];
    snprintf(text, sizeof text, "%d.%d.%d", CRUMPLE_VERSION_MAJOR, CRUMPLE_VERSION_MINOR,
             CRUMPLE_VERSION_MICRO);
    assert_string_equal(crumple_version(), text);
    assert_int_equal(strspn(crumple_data_hash(lib), "0123456789abcdef"), 64);
}

static void test_no_data(void **state) {
    (void)state;
    crumple *none = NULL;
    crumple_error err = CRUMPLE_ERROR_INIT;
    assert_int_equal(crumple_open("/nowhere", &none, &err), CRUMPLE_IO);
    assert_null(none);
    assert_string_equal(crumple_error_word(err.code), "io");
    assert_non_null(strstr(err.source, "/nowhere"));
    assert_int_equal(crumple_open("/nowhere", &none, NULL), CRUMPLE_IO);
}

/* as crumple run says it: line, column, pointer and hint */
static void test_error(void **state) {
    (void)state;
    static const char scene[] = "{\"crumple\":1,\n\"participants\":[{\"id\":\"A\",\"kind\":"
                                "\"vehicle\",\"type\":\"suv\",\"masskg\":1,"
                                "\"position_m\":[0,0],\"heading_deg\":0}]}";
    crumple_result *r = NULL;
    crumple_error err = CRUMPLE_ERROR_INIT;
    crumple_options opt = CRUMPLE_OPTIONS_INIT;
    opt.name = "mine";
    assert_int_equal(crumple_solve(lib, scene, strlen(scene), &opt, &r, &err), CRUMPLE_KEY);
    assert_null(r);
    assert_int_equal(err.line, 2);
    assert_int_equal(err.column, 57);
    assert_string_equal(err.source, "mine");
    assert_string_equal(err.where, "/participants/0/masskg");
    assert_non_null(strstr(err.hint, "mass_kg"));
    assert_string_equal(crumple_error_word(err.code), "unknown-key");
    assert_string_equal(crumple_error_word(4711), "unknown");
}

/* the caller was compiled when the struct ended after its column: nothing is written behind it */
static void test_older_caller(void **state) {
    (void)state;
    crumple_error err = CRUMPLE_ERROR_INIT;
    crumple_result *r;
    err.size = offsetof(crumple_error, source);
    err.source[0] = '#';
    assert_int_equal(crumple_solve(lib, "[", 1, NULL, &r, &err), CRUMPLE_SYNTAX);
    assert_int_equal(err.line, 1);
    assert_int_equal(err.source[0], '#');
    assert_int_equal(err.size, offsetof(crumple_error, source));
}

/* EES is the plastic energy as a speed; the car stops at the wall and comes back with the
 * restitution */
static void test_values(void **state) {
    (void)state;
    const char *const set[] = {"restitution=0.1", "A.speed_kmh=40"};
    crumple_options opt = CRUMPLE_OPTIONS_INIT;
    opt.set = set;
    opt.sets = 2;
    crumple_result *r = solve_with(50, &opt);
    check_near(value(r, "A.ees_kmh"), 3.6 * sqrt(2e3 * value(r, "A.energy_kJ") / 1400), 1e-6);
    check_near(value(r, "contacts.0.restitution"), 0.1, 0);
    check_near(value(r, "contacts.0.closing_kmh"), 40, 0.2);
    check_near(value(r, "A.delta_v_kmh"), 40 * 1.1, 0.5);
    check_near(value(r, "A.delta_v"), value(r, "A.delta_v_kmh"), 0);
    assert_true(value(r, "balance.energy_residual") < 1e-9);
    assert_string_equal(crumple_word(r, "A.cdc"), crumple_word(r, "A.cdc"));
    assert_string_equal(crumple_word(r, "A.model"), "compact/12");
    double x;
    assert_int_equal(crumple_value(r, "A.model", &x), CRUMPLE_NAME);
    assert_int_equal(crumple_value(r, "A.ee", &x), CRUMPLE_NAME);
    assert_int_equal(crumple_value(r, "C.ees_kmh", &x), CRUMPLE_NAME);
    assert_true(isnan(x));
    assert_null(crumple_word(r, "A.ees_kmh"));
    crumple_result_free(r);
}

/* every name leads to its value, and no two are the same */
static void test_names(void **state) {
    (void)state;
    crumple_result *r = solve_with(50, NULL);
    size_t n = 0;
    bool injury = false, profile = false;
    for (const char *name; (name = crumple_name(r, n)) != NULL; n++) {
        double x;
        bool number = crumple_value(r, name, &x) == CRUMPLE_OK;
        assert_true(number != (crumple_word(r, name) != NULL));
        injury = injury || strcmp(name, "A.injury.gidas-mais2.probability") == 0;
        profile = profile || strcmp(name, "A.crush_profile_m.5") == 0;
        for (size_t i = 0; i < n; i++) {
            assert_string_not_equal(name, crumple_name(r, i));
        }
    }
    assert_true(n > 60);
    assert_true(injury && profile);
    crumple_result_free(r);
}

/* the integral of the acceleration is the change of velocity */
static void test_series(void **state) {
    (void)state;
    crumple_result *r = solve_with(50, NULL);
    size_t n = crumple_series(r, "t_s", NULL, 0);
    assert_true(n > 10);
    double *t = calloc(n, sizeof *t), *a = calloc(n, sizeof *a), *v = calloc(n, sizeof *v);
    assert_int_equal(crumple_series(r, "t_s", t, n), n);
    assert_int_equal(crumple_series(r, "A.ax_mps2", a, n), n);
    assert_int_equal(crumple_series(r, "A.vx_mps", v, n), n);
    double sum = v[0];
    for (size_t i = 1; i < n; i++) {
        assert_true(t[i] > t[i - 1]);
        sum += a[i] * (t[i] - t[i - 1]);
    }
    check_near(sum, v[n - 1], 1e-6);
    a[1] = 4711;
    assert_int_equal(crumple_series(r, "A.vx_mps", a, 1), n);
    check_near(a[1], 4711, 0);
    assert_int_equal(crumple_series(r, "A.colour", NULL, 0), 0);
    assert_int_equal(crumple_series(r, "C.vx_mps", NULL, 0), 0);
    assert_int_equal(crumple_series(r, "A", NULL, 0), 0);
    free(t);
    free(a);
    free(v);
    crumple_result_free(r);
}

/* damage is a share; the grid has the size of the car; what is crushed lies at the front */
static void test_field(void **state) {
    (void)state;
    crumple_result *r = solve_with(50, NULL);
    int dims[3];
    double frame[6];
    size_t n = crumple_field(r, "A", CRUMPLE_FIELD_DAMAGE, NULL, 0, dims, frame);
    assert_int_equal(n, dims[0] * dims[1]);
    assert_int_equal(dims[2], 1);
    check_near(frame[2], 0.1, 1e-12);
    check_near(dims[0] * frame[2], 4.3, 0.5);
    float *damage = calloc(n, sizeof *damage), *of = calloc(n, sizeof *of);
    crumple_field(r, "A", CRUMPLE_FIELD_DAMAGE, damage, n, dims, frame);
    double front = 0, rear = 0;
    for (size_t i = 0; i < n; i++) {
        assert_true(damage[i] >= 0 && damage[i] <= 1);
        *((int)(i % (size_t)dims[0]) > dims[0] / 2 ? &front : &rear) += (double)damage[i];
    }
    assert_true(front > 1);
    check_near(rear, 0, 0);
    crumple_field(r, "A", CRUMPLE_FIELD_TIME, of, n, dims, frame);
    for (size_t i = 0; i < n; i++) {
        assert_true(isfinite(of[i]) == (damage[i] > 0));
    }
    crumple_field(r, "A", CRUMPLE_FIELD_EES, of, n, dims, frame);
    for (size_t i = 0; i < n; i++) {
        assert_true(of[i] >= 0);
    }
    assert_int_equal(crumple_field(r, "wall", CRUMPLE_FIELD_DAMAGE, of, n, dims, frame), 0);
    assert_int_equal(crumple_field(r, "A", 99, of, n, dims, frame), 0);
    free(damage);
    free(of);
    crumple_result_free(r);
}

static void test_json(void **state) {
    (void)state;
    crumple_result *r = solve_with(50, NULL);
    size_t length;
    char *text = crumple_json(r, CRUMPLE_TRACE | CRUMPLE_RESOLVED, &length);
    assert_int_equal(strlen(text), length);
    assert_non_null(strstr(text, "\"trace\":{"));
    assert_non_null(strstr(text, "\"resolved\":{"));
    assert_ptr_equal(strchr(text, '\n'), text + length - 1);
    crumple_free(text);
    text = crumple_json(r, CRUMPLE_PRETTY, NULL);
    assert_null(strstr(text, "\"trace\""));
    assert_non_null(strstr(text, "\n\t"));
    crumple_free(text);
    crumple_result_free(r);
}

static void test_svg(void **state) {
    (void)state;
    crumple_result *r = solve_with(50, NULL);
    size_t length;
    char *text = crumple_svg(r, (double)NAN, &length);
    assert_int_equal(strlen(text), length);
    assert_non_null(strstr(text, "<svg"));
    assert_non_null(strstr(text, "</svg>"));
    crumple_free(text);
    crumple_result_free(r);
}

/* a result outlives the models it was solved with */
static void test_closed_before(void **state) {
    (void)state;
    crumple *own;
    crumple_result *r;
    char scene[1024];
    scene_at(50, scene);
    assert_int_equal(crumple_open(getenv("SRC"), &own, NULL), CRUMPLE_OK);
    assert_int_equal(crumple_solve(own, scene, strlen(scene), NULL, &r, NULL), CRUMPLE_OK);
    crumple_close(own);
    crumple_free(crumple_svg(r, 0.2, NULL));
    char *text = crumple_json(r, CRUMPLE_TRACE | CRUMPLE_RESOLVED, NULL);
    assert_non_null(text);
    crumple_free(text);
    crumple_result_free(r);
}

/* a car of the user's own table, as `crumple catalogue import` leaves it */
static void test_own_cars(void **state) {
    char dir[] = "/tmp/crumple-own-XXXXXX", path[100];
    static const char *const parts[] = {"", "/crumple", "/crumple/catalogue"};
    static const char scene[] =
        "{\"crumple\":1,\"settings\":{\"voxel_mm\":100,\"dt_ms\":2},\"participants\":[{\"id\":"
        "\"A\","
        "\"kind\":\"vehicle\",\"car\":\"zeta 9\",\"position_m\":[0,0],\"speed_kmh\":50},"
        "{\"id\":\"W\",\"kind\":\"object\",\"shape\":\"wall\",\"position_m\":[4,0],"
        "\"heading_deg\":180}]}";
    crumple *own;
    crumple_result *r;
    (void)state;
    assert_int_equal(crumple_solve(lib, scene, strlen(scene), NULL, &r, NULL), CRUMPLE_NAME);
    assert_non_null(mkdtemp(dir));
    for (int i = 1; i < 3; i++) {
        snprintf(path, sizeof path, "%s%s", dir, parts[i]);
        assert_int_equal(mkdir(path, 0700), 0);
    }
    snprintf(path, sizeof path, "%s/crumple/catalogue/my.csv", dir);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("make,model,type,curb_kg,length_m\nZeta,9,compact,1234,4.2\n", file);
    fclose(file);
    assert_int_equal(setenv("XDG_DATA_HOME", dir, 1), 0);
    assert_int_equal(crumple_open(getenv("SRC"), &own, NULL), CRUMPLE_OK);
    assert_int_equal(crumple_solve(own, scene, strlen(scene), NULL, &r, NULL), CRUMPLE_OK);
    unsetenv("XDG_DATA_HOME");
    char *text = crumple_json(r, CRUMPLE_RESOLVED, NULL);
    assert_non_null(strstr(text, "\"kerb_mass_kg\":1234"));
    crumple_free(text);
    crumple_result_free(r);
    crumple_close(own);
    unlink(path);
    for (int i = 2; i >= 0; i--) {
        snprintf(path, sizeof path, "%s%s", dir, parts[i]);
        rmdir(path);
    }
}

static int cancel_at_third(void *user) {
    return ++*(int *)user >= 3;
}

static void test_cancel(void **state) {
    (void)state;
    int polls = 0;
    char scene[1024];
    crumple_result *r;
    crumple_error err = CRUMPLE_ERROR_INIT;
    crumple_options opt = CRUMPLE_OPTIONS_INIT;
    opt.cancel = cancel_at_third;
    opt.user = &polls;
    scene_at(50, scene);
    assert_int_equal(crumple_solve(lib, scene, strlen(scene), &opt, &r, &err), CRUMPLE_INTERRUPTED);
    assert_null(r);
    assert_int_equal(polls, 3);
}

struct many {
    int n, next, done, stop_at;
    char scene[1024];
    bool ordered;
    double ees[32];
    crumple_options *opt; /* whose name is that of the scene; nullable */
    char name[16];
};

static int next_scene(void *user, const char **scene, size_t *length) {
    struct many *m = user;
    if (m->next == m->n) {
        return 0;
    }
    /* every fifth is none */
    *scene = m->next % 5 == 4 ? "{}" : scene_at(30 + m->next, m->scene);
    if (m->opt != NULL) {
        snprintf(m->name, sizeof m->name, "%d.json", m->next);
        m->opt->name = m->name;
    }
    m->next++;
    *length = strlen(*scene);
    return 1;
}

static int scene_done(void *user, size_t index, crumple_result *result, const crumple_error *err) {
    struct many *m = user;
    m->ordered = m->ordered && (int)index == m->done;
    m->ees[index] = (double)NAN;
    if (result != NULL) {
        crumple_value(result, "A.ees_kmh", &m->ees[index]);
    } else {
        char name[16] = "scene";
        if (m->opt != NULL) {
            snprintf(name, sizeof name, "%d.json", (int)index);
        }
        m->ordered = m->ordered && err->code == CRUMPLE_MISSING && index % 5 == 4 &&
                     strcmp(err->source, name) == 0;
    }
    crumple_result_free(result);
    m->done++;
    return m->done == m->stop_at;
}

static void test_stack(void **state) {
    (void)state;
    crumple_options opt = CRUMPLE_OPTIONS_INIT;
    struct many one = {.n = 12, .ordered = true}, four = one, stopped = one;
    four.opt = &opt; /* each scene has a name of its own, though threads take them */
    crumple_error err = CRUMPLE_ERROR_INIT;
    assert_int_equal(crumple_stack(lib, 1, NULL, next_scene, scene_done, &one, NULL), CRUMPLE_OK);
    assert_int_equal(crumple_stack(lib, 4, &opt, next_scene, scene_done, &four, NULL), CRUMPLE_OK);
    assert_true(one.ordered && four.ordered && one.done == 12 && four.done == 12);
    for (int i = 0; i < 12; i++) {
        assert_true(one.ees[i] == four.ees[i] || i % 5 == 4);
        assert_true(i < 1 || i % 5 == 4 || i % 5 == 0 || one.ees[i] > one.ees[i - 1]);
    }
    stopped.stop_at = 3;
    assert_int_equal(crumple_stack(lib, 2, NULL, next_scene, scene_done, &stopped, &err),
                     CRUMPLE_INTERRUPTED);
    assert_int_equal(stopped.done, 3);
    assert_int_equal(crumple_stack(lib, 257, NULL, next_scene, scene_done, &one, &err),
                     CRUMPLE_USAGE);
}

static const char cases_csv[] = "case,time [s],id,x [m],y [m],heading [deg],speed [km/h]\n"
                                "1,0,A,0,0,0,54\n"
                                "1,0,B,20,0.5,180,54\n"
                                "2,0,A,0,0,0,\n"
                                "2,0,B,20,0.5,180,54\n"
                                "3,0,A,0,0,0,36\n"
                                "3,0,B,20,0.5,180,54\n";

struct taken {
    int n, stop_at;
    char got[8]; /* s: a scene that can be solved, e: an error with its place */
};

static int take_case(void *user, const char *scene, size_t length, const crumple_error *err) {
    struct taken *t = user;
    crumple_result *r = NULL;
    char word = 'e';
    if (scene != NULL) {
        assert_int_equal(length, strlen(scene));
        word = crumple_solve(lib, scene, length, NULL, &r, NULL) == CRUMPLE_OK ? 's' : '?';
    } else {
        assert_int_equal(err->code, CRUMPLE_MISSING);
        assert_int_equal(err->line, 4);
    }
    t->got[t->n++] = word;
    crumple_result_free(r);
    return t->n == t->stop_at;
}

static void test_import(void **state) {
    (void)state;
    char path[] = "/tmp/crumple-lib-XXXXXX";
    const char *const third[] = {"format=csv", "case=3"}, *const none[] = {"case=4"};
    const char *const wrong[] = {"reference"};
    struct taken all = {0}, one = {0}, stopped = {.stop_at = 1}, no = {0};
    crumple_error err = CRUMPLE_ERROR_INIT;
    crumple_options opt = CRUMPLE_OPTIONS_INIT;
    int polls = 2, fd = mkstemp(path);
    assert_int_equal(write(fd, cases_csv, strlen(cases_csv)), strlen(cases_csv));
    close(fd);
    assert_int_equal(crumple_import(lib, path, NULL, take_case, &all, &err), CRUMPLE_OK);
    assert_string_equal(all.got, "ses");
    assert_int_equal(crumple_import(lib, path, NULL, take_case, &stopped, &err),
                     CRUMPLE_INTERRUPTED);
    assert_string_equal(stopped.got, "s");
    opt.set = third;
    opt.sets = 2;
    assert_int_equal(crumple_import(lib, path, &opt, take_case, &one, &err), CRUMPLE_OK);
    assert_string_equal(one.got, "s");
    opt.set = none;
    opt.sets = 1;
    assert_int_equal(crumple_import(lib, path, &opt, take_case, &no, &err), CRUMPLE_NAME);
    opt.set = wrong;
    assert_int_equal(crumple_import(lib, path, &opt, take_case, &no, &err), CRUMPLE_USAGE);
    opt.sets = 0;
    opt.cancel = cancel_at_third;
    opt.user = &polls;
    assert_int_equal(crumple_import(lib, path, &opt, take_case, &no, &err), CRUMPLE_INTERRUPTED);
    unlink(path);
    assert_int_equal(crumple_import(lib, path, NULL, take_case, &no, &err), CRUMPLE_IO);
    assert_string_equal(err.source, path);
    assert_int_equal(crumple_import(lib, "-", NULL, take_case, &no, &err), CRUMPLE_IO);
    assert_string_equal(no.got, "");
}

/* the rule of threads: one handle, solves side by side, and one result read by both; for
 * ThreadSanitizer */
static void *many_solves(void *user) {
    double *sum = user;
    for (int i = 0; i < 6; i++) {
        crumple_result *r = solve_with(40 + i, NULL);
        *sum += value(r, "A.ees_kmh");
        crumple_result_free(r);
    }
    return NULL;
}

static crumple_result *shared;

static void *many_reads(void *user) {
    double *sum = user;
    for (int i = 0; i < 20; i++) {
        char *text = crumple_json(shared, CRUMPLE_TRACE, NULL);
        *sum += value(shared, "A.ees_kmh") + (double)strlen(text) +
                (double)crumple_series(shared, "t_s", NULL, 0);
        crumple_free(text);
    }
    return NULL;
}

static void test_threads(void **state) {
    (void)state;
    pthread_t thread[4];
    double sum[4] = {0};
    shared = solve_with(50, NULL);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(
            pthread_create(&thread[i], NULL, i < 2 ? many_solves : many_reads, &sum[i]), 0);
    }
    for (int i = 0; i < 4; i++) {
        pthread_join(thread[i], NULL);
    }
    crumple_result_free(shared);
    check_near(sum[0], sum[1], 0);
    check_near(sum[2], sum[3], 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_versions), cmocka_unit_test(test_no_data),
        cmocka_unit_test(test_error),    cmocka_unit_test(test_older_caller),
        cmocka_unit_test(test_values),   cmocka_unit_test(test_names),
        cmocka_unit_test(test_series),   cmocka_unit_test(test_field),
        cmocka_unit_test(test_json),     cmocka_unit_test(test_cancel),
        cmocka_unit_test(test_svg),      cmocka_unit_test(test_closed_before),
        cmocka_unit_test(test_own_cars), cmocka_unit_test(test_stack),
        cmocka_unit_test(test_threads),  cmocka_unit_test(test_import),
    };
    return cmocka_run_group_tests_name("lib", tests, open_lib, close_lib);
}
