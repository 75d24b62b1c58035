/* Any bytes as the table of a register of vehicles: either an error with a text, or a table in
 * UTF-8 that the catalogue reads, with as many cars as were told. */
#include "scratch.h"

#include "base/show.h"
#include "catalogue/catalogue.h"

#include <string.h>

/* what was made is UTF-8, and a table of the catalogue */
static void read_back(const struct cr_str *table, int cars) {
    for (size_t i = 0, n; i < table->len; i += n) {
        n = cr_utf8_length(table->s + i, table->len - i);
        if (n == 0) {
            abort();
        }
    }
    const char *dir = scratch_dir();
    struct cr_error err = {0};
    struct cr_catalogue *catalogue;
    scratch_put("made.csv", (const uint8_t *)table->s, table->len);
    if (cr_catalogue_open(&dir, 1, &catalogue, &err) != CR_ERR_OK) {
        fprintf(stderr, "%s:%d: %s\n", err.src, err.line, err.text);
        abort();
    }
    if (cr_catalogue_cars(catalogue) != cars) {
        abort();
    }
    cr_catalogue_free(catalogue);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    for (int form = 0; form < 3; form++) {
        struct cr_str table = {0};
        struct cr_error err = {0};
        int cars;
        const char *path = scratch_put("register", data, size);
        enum cr_err code = cr_catalogue_convert(path, form, &table, &cars, &err);
        if (code == CR_ERR_OK) {
            read_back(&table, cars);
        } else if (err.code != code || err.text[0] == '\0') {
            abort();
        }
        cr_str_fini(&table);
    }
    return 0;
}
