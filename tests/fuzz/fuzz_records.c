/* Any bytes as the files that import reads beside another one: descriptions and records of
 * CarMaker, records and channels of crash tests, and as an expression of OpenSCENARIO. */
#include "fuzz.h"

#include "result/channel.h"
#include "import/erg_priv.h"
#include "result/ev5.h"
#include "import/formula.h"
#include "result/mme.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void judge(enum cr_err code, const struct cr_error *err) {
    if (code != CR_ERR_OK && err->text[0] == '\0') {
        abort();
    }
}

/* every quantity lies within the record */
static void carmaker(const char *text) {
    struct cr_error err = {0};
    struct cr_erg erg;
    enum cr_err code = cr_erg_parse(text, "fuzz", &erg, &err);
    judge(code, &err);
    unsigned char *record = code == CR_ERR_OK ? calloc(1, (size_t)erg.record) : NULL;
    for (int i = 0; record != NULL && i < erg.n; i++) {
        memset(record, 0xff, (size_t)erg.record);
        cr_erg_value(&erg, i, record);
    }
    free(record);
    cr_erg_fini(&erg);
}

static void tests(const char *text) {
    struct cr_error err = {0};
    struct cr_mme_channel ch;
    struct cr_channel pairs;
    struct cr_ev5 ev5;
    judge(cr_mme_channel(text, "fuzz", &ch, &err), &err);
    cr_channel_fini(&ch.samples);
    enum cr_err code = cr_channel_pairs(text, "fuzz", &pairs, &err);
    judge(code, &err);
    if (code == CR_ERR_OK && isnan(cr_channel_integral(&pairs, cr_channel_furthest(&pairs)))) {
        abort();
    }
    cr_channel_fini(&pairs);
    double x;
    code = cr_ev5_parse(text, "fuzz", &ev5, &err);
    judge(code, &err);
    for (int i = 0; i < ev5.n; i++) {
        judge(cr_ev5_number(&ev5, &ev5.record[i], 1 + i % CR_EV5_FIELDS, false, &x, &err), &err);
    }
    cr_ev5_fini(&ev5);
}

static enum cr_err value(void *user, const char *name, double *out, struct cr_error *err) {
    (void)user, (void)err;
    *out = (double)strlen(name);
    return CR_ERR_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const struct cr_formula_names names = {value, NULL};
    struct cr_error err = {0};
    double x;
    char *text = malloc(size + 1);
    if (text == NULL) {
        return 0;
    }
    memcpy(text, data, size);
    text[size] = '\0';
    carmaker(text);
    tests(text);
    enum cr_err code = cr_formula(text, &names, &x, &err);
    judge(code, &err);
    if (code == CR_ERR_OK && !isfinite(x)) {
        abort();
    }
    free(text);
    return 0;
}
