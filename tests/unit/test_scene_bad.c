/* Every file of tests/cases/scene is refused with exactly the line in the file beside it: its code,
 * its place, what is wrong and the way out. */
#include "scene_help.h"

#include "base/file.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void check_case(const char *dir, const char *name) {
    char path[4200], line[1200], got[1200];
    char *text = NULL, *want = NULL;
    size_t len, n;
    struct cr_error err = {0};
    struct cr_scene scene;
    snprintf(path, sizeof path, "%s/%s", dir, name);
    assert_int_equal(cr_file_read(path, &text, &len, &err), CR_ERR_OK);
    snprintf(path, sizeof path, "%s/%.*s.err", dir, (int)strlen(name) - 5, name);
    assert_int_equal(cr_file_read(path, &want, &n, &err), CR_ERR_OK);
    enum cr_err code = cr_scene_parse(text, len, name, &scene, &err);
    if (code == CR_ERR_OK) {
        fail_msg("%s is accepted", name);
    }
    assert_int_equal(code, err.code);
    assert_int_equal(cr_err_status(code), 3);
    assert_true(err.line > 0 && err.col > 0);
    /* what could not be read is an empty scene */
    assert_int_equal(scene.n, 0);
    assert_null(scene.extra);
    snprintf(got, sizeof got, "%s: %s\n", cr_err_word(code),
             cr_err_format(&err, line, sizeof line));
    assert_string_equal(got, want);
    free(text);
    free(want);
}

static void test_bad_scenes_get_their_message(void **state) {
    (void)state;
    char dir[4096];
    snprintf(dir, sizeof dir, "%s", scene_path("tests/cases/scene"));
    DIR *d = opendir(dir);
    assert_non_null(d);
    int n = 0;
    for (struct dirent *e = readdir(d); e != NULL; e = readdir(d)) {
        size_t len = strlen(e->d_name);
        if (len > 5 && strcmp(e->d_name + len - 5, ".json") == 0) {
            check_case(dir, e->d_name);
            n++;
        }
    }
    closedir(d);
    assert_true(n > 100);
}

static void test_errors_may_go_unseen(void **state) {
    (void)state;
    struct cr_scene scene;
    assert_int_equal(cr_scene_parse("{", 1, NULL, &scene, NULL), CR_ERR_SYNTAX);
    assert_int_equal(cr_scene_parse("{}", 2, NULL, &scene, NULL), CR_ERR_MISSING);
    assert_int_equal(cr_scene_load("nowhere.json", &scene, NULL), CR_ERR_IO);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bad_scenes_get_their_message),
        cmocka_unit_test(test_errors_may_go_unseen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
