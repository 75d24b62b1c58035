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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_that_another_program_has),
        cmocka_unit_test(the_newest_within_a_second),
    };
    return cmocka_run_group_tests_name("autosave", tests, NULL, NULL);
}
