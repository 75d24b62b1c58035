/* Makes the one hash that stands for all data a computation reads, so that results can be told
 * apart that were made with other models, risk functions or damage rules. */
#include "result/result.h"

#include "base/file.h"
#include "base/hash.h"
#include "base/str.h"

#include <stdlib.h>

enum cr_err cr_result_data_hash(const struct cr_model_lib *models, const struct cr_irf_set *irf,
                                const char *rules, char hex[CR_HASH_SIZE], struct cr_error *err) {
    struct cr_str all = {0};
    char *text = NULL;
    size_t len = 0;
    for (int i = 0; i < CR_TYPES; i++) {
        cr_str_add(&all, cr_model_hash(models, (enum cr_type)i));
    }
    cr_str_add(&all, cr_irf_hash(irf));
    enum cr_err code = cr_file_read(rules, &text, &len, err);
    cr_str_addn(&all, text != NULL ? text : "", len);
    free(text);
    if (code == CR_ERR_OK && all.failed) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the hash of the data");
    } else if (code == CR_ERR_OK) {
        cr_hash_hex(all.s, all.len, hex);
    }
    cr_str_fini(&all);
    return code;
}
