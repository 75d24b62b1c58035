/* Measured curves out of files of crash tests, by hand: -20 g and 5 g to the right in vtv.EV5, -160
 * m/s2 in wall.mme (tests/data/import). */
#include "test.h"

#include "base/vec.h"
#include "result/signal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *sample(const char *name) {
    static char path[4096];
    const char *src = getenv("SRC");
    snprintf(path, sizeof path, "%s/tests/data/import/%s", src != NULL ? src : "..", name);
    return path;
}

/* what is told of a file's curve at 50 ms */
static void curves_by_file_and_by_test(void **state) {
    static const struct {
        const char *file, *column;
        int object;
        bool left;
        char axis;
        const char *unit;
        double value;
    } row[] = {
        {"vtv.EV5", NULL, 1, false, 'X', "m/s2", -20 * CR_G},
        {"vtv.EV5", NULL, 1, true, 'Y', "m/s2", -5 * CR_G},
        {"vtv.EV5", "9", 1, false, 'Y', "m/s2", -5 * CR_G},
        {"vtv.008", NULL, 7, true, 'X', "m/s2", -20 * CR_G},
        {"wall.mme", NULL, 1, false, 'X', "m/s2", -160},
        {"wall.mme/wall.mme", NULL, 1, false, 'X', "m/s2", -160},
        {"wall.mme", NULL, 2, false, 'X', "m/s2", -160}, /* the only one that has any */
        {"wall.mme", "11vehccg0000acxa", 2, true, 'X', "m/s2", -160},
        {"wall.mme", "001", 1, true, 'X', "m/s2", -160},
        {"wall.mme/Channel/wall.001", NULL, 1, true, 'X', "m/s2", -160},
        {"edr-deltav.csv", NULL, 1, false, '\0', "m/s", NAN},
    };
    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        const struct cr_signal_pick pick = {row[i].column, row[i].object, row[i].left};
        struct cr_signal s;
        struct cr_error err = {0};
        const char *path = sample(row[i].file);
        assert_true(cr_signal_is(path));
        assert_int_equal(cr_signal_load_any(path, &pick, &s, &err), CR_ERR_OK);
        assert_int_equal(s.axis, row[i].axis);
        assert_string_equal(s.unit, row[i].unit);
        if (!isnan(row[i].value)) {
            check_near(cr_signal_at(&s, 0.05, 0), row[i].value, 1e-9);
        }
        cr_signal_free(&s);
    }
}

static void faults_say_the_way_out(void **state) {
    static const struct {
        const char *file, *column;
        bool left;
        enum cr_err code;
        const char *words, *hint;
    } bad[] = {
        {"vtv.EV5", "1", false, CR_ERR_NAME, "no curve '1'", "column="},
        {"vtv.EV5", "7", false, CR_ERR_MISSING, "curve 7 is not beside", ""},
        {"pole.EV5", NULL, false, CR_ERR_MISSING, "no acceleration", "column="},
        {"wall.mme", "x2", false, CR_ERR_NAME, "no channel 'x2'", "11VEHCCG0000ACXA"},
        {"wall.mme", NULL, true, CR_ERR_NAME, "1?VEHC...ACY?", "column="},
        {"pcm5", NULL, false, CR_ERR_NAME, "test object 1", "Channel/"},
        {"wall.zip", NULL, false, CR_ERR_TYPE, "archive", "unzip"},
        {"none.001", NULL, false, CR_ERR_IO, "cannot open", ""},
    };
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const struct cr_signal_pick pick = {bad[i].column, 1, bad[i].left};
        struct cr_signal s;
        struct cr_error err = {0};
        assert_int_equal(cr_signal_load_any(sample(bad[i].file), &pick, &s, &err), bad[i].code);
        assert_non_null(strstr(err.text, bad[i].words));
        assert_non_null(strstr(err.hint, bad[i].hint));
        assert_null(s.memory);
    }
}

/* a channel alone has neither unit nor axis */
static void a_channel_needs_its_test(void **state) {
    char dir[] = "/tmp/crumple-measured-XXXXXX", path[64];
    const struct cr_signal_pick pick = {NULL, 1, false};
    struct cr_signal s;
    struct cr_error err;
    (void)state;
    assert_non_null(mkdtemp(dir));
    snprintf(path, sizeof path, "%s/test.001", dir);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("0\t1\n0.1\t2\n", file);
    fclose(file);
    assert_int_equal(cr_signal_load_any(path, &pick, &s, &err), CR_ERR_MISSING);
    assert_non_null(strstr(err.text, "the test of this channel is not beside it"));
    unlink(path);
    rmdir(dir);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_by_file_and_by_test),
        cmocka_unit_test(faults_say_the_way_out),
        cmocka_unit_test(a_channel_needs_its_test),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
