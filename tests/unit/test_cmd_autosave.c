/* Which autosave is offered: of a session that has ended, and the newest. */
#include "test.h"

#include "cmd/cmd_priv.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void a_number_that_another_program_has(void **state) {
    (void)state;
    char dir[] = "cr_state_XXXXXX", path[64], found[64];
    assert_non_null(mkdtemp(dir));
    snprintf(path, sizeof path, "%s/autosave-%ld.json", dir, (long)getpid());
    fclose(fopen(path, "w"));
    assert_false(cr_autosave_find(dir, found, sizeof found)); /* a session that goes on */
    assert_int_equal(unlink(path), 0);
    snprintf(path, sizeof path, "%s/autosave-1.json", dir); /* init, or what stands for it */
    fclose(fopen(path, "w"));
    assert_int_equal(cr_autosave_find(dir, found, sizeof found),
                     access("/proc/self/stat", R_OK) == 0);
    assert_int_equal(unlink(path), 0);
    assert_int_equal(rmdir(dir), 0);
}

static void the_newest_within_a_second(void **state) {
    (void)state;
    static const struct {
        const char *name;
        long nsec;
    } left[] = {{"autosave-999999991.json", 1000000}, /* process numbers beyond any kernel's */
                {"autosave-999999993.json", 900000000},
                {"autosave-999999992.json", 899000000}};
    char dir[] = "cr_state_XXXXXX", path[64], found[64];
    bool kept = true; /* by the file system: some have whole seconds */
    assert_non_null(mkdtemp(dir));
    for (int i = 0; i < 3; i++) {
        struct timespec when[2] = {{1000, left[i].nsec}, {1000, left[i].nsec}};
        snprintf(path, sizeof path, "%s/%s", dir, left[i].name);
        fclose(fopen(path, "w"));
        assert_int_equal(utimensat(AT_FDCWD, path, when, 0), 0);
        struct stat st;
        assert_int_equal(stat(path, &st), 0);
        kept = kept && st.st_mtim.tv_nsec != 0;
    }
    static const int newest_first[] = {1, 2, 0};
    for (int i = 0; i < 3; i++) {
        assert_true(cr_autosave_find(dir, found, sizeof found));
        if (kept) {
            assert_string_equal(found + strlen(dir) + 1, left[newest_first[i]].name);
        }
        assert_int_equal(unlink(found), 0);
    }
    assert_false(cr_autosave_find(dir, found, sizeof found));
    assert_int_equal(rmdir(dir), 0);
}

/* ---- where none can be written ---- */

static void hear(void *user, enum cr_tone tone, const char *line) {
    struct cr_str *said = user;
    (void)tone;
    cr_str_addf(said, "%s\n", line);
}

static struct cr_session *session(struct cr_str *said, const char *state_dir, const char *why) {
    struct cr_session *s;
    const struct cr_session_opts opts = {.data_dir = getenv("SRC"),
                                         .state_dir = state_dir,
                                         .stateless = why,
                                         .out = {.user = said, .text = hear}};
    cr_str_clear(said);
    assert_int_equal(cr_session_new(&opts, &s, NULL), CR_ERR_OK);
    assert_int_equal(cr_session_run(s, "vehicle A type=suv mass=2000kg"), CR_ERR_OK);
    return s;
}

/* Told once, with the way out, and tried again: a full disk may have room later. */
static void test_no_autosave_is_told_once(void **state) {
    (void)state;
    struct cr_str said = {0};
    char dir[] = "cr_state_XXXXXX";
    struct cr_session *s = session(&said, "/dev/null/crumple", NULL);
    const char *told = strstr(cr_str_get(&said), "no autosave: cannot write: Not a directory");
    assert_non_null(told);
    assert_non_null(strstr(told, "save FILE; XDG_STATE_HOME names another folder"));
    cr_str_clear(&said);
    assert_int_equal(cr_session_run(s, "vehicle A speed=47km/h; undo"), CR_ERR_OK);
    assert_null(strstr(cr_str_get(&said), "no autosave"));
    cr_session_free(s);
    s = session(&said, "", NULL); /* no home at all */
    assert_non_null(strstr(cr_str_get(&said), "neither XDG_STATE_HOME nor HOME names a folder"));
    cr_session_free(s);
    s = session(&said, "/nowhere", "Read-only file system");
    assert_non_null(strstr(cr_str_get(&said), "cannot make /nowhere: Read-only file system"));
    cr_session_free(s);
    assert_non_null(mkdtemp(dir));
    assert_int_equal(rmdir(dir), 0);
    s = session(&said, dir, NULL);
    assert_non_null(strstr(cr_str_get(&said), "no autosave"));
    assert_int_equal(mkdir(dir, 0700), 0);
    assert_int_equal(cr_session_run(s, "vehicle A speed=47km/h"), CR_ERR_OK);
    assert_int_equal(rmdir(dir), -1); /* there is one now */
    cr_session_free(s);
    assert_int_equal(rmdir(dir), 0);
    cr_str_fini(&said);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_that_another_program_has),
        cmocka_unit_test(the_newest_within_a_second),
        cmocka_unit_test(test_no_autosave_is_told_once),
    };
    return cmocka_run_group_tests_name("autosave", tests, NULL, NULL);
}
