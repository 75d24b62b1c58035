/* Any bytes as a table or scene of crash tests: either an error with a text, or scenes that can be
 * read. */
#include "scratch.h"

#include "trial/crashtest.h"
#include "trial/types.h"

#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static struct cr_type_rules rules;
    static int have;
    struct cr_error err = {0};
    if (have == 0 && cr_type_rules_read(data_dir(), &rules, &err) != CR_ERR_OK) {
        exit(3);
    }
    have = 1;
    const char *name = size > 0 && data[0] == '{' ? "tests.json" : "tests.csv";
    const char *path = scratch_put(name, data, size);
    struct cr_test_list list = {0};
    enum cr_err code = cr_test_load_own(path, &rules, &list, &err);
    if (code != CR_ERR_OK && err.text[0] == '\0') {
        abort();
    }
    cr_test_list_fini(&list);
    return 0;
}
