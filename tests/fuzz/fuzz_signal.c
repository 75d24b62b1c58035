/* Any bytes as a measured curve: either an error with a text, or finite values over rising times.
 */
#include "scratch.h"

#include "result/signal.h"

#include <math.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = scratch_put("signal.csv", data, size);
    struct cr_signal s;
    struct cr_error err = {0};
    enum cr_err code = cr_signal_load(path, size & 1 ? NULL : "ax_g", &s, &err);
    if (code != CR_ERR_OK) {
        if (err.code != code || err.text[0] == '\0') {
            abort();
        }
        return 0;
    }
    for (int i = 0; i < s.n; i++) {
        if (!isfinite(s.t[i]) || !isfinite(s.x[i]) || (i > 0 && !(s.t[i] > s.t[i - 1]))) {
            abort();
        }
    }
    cr_signal_free(&s);
    return 0;
}
