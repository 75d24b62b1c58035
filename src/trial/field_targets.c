/* Targets of real crashes: what damage says of delta-v must have no bias and be nearer to the
 * recorders than NHTSA's own program is. */
#include "trial/field.h"
#include "trial/verdict.h"

#include <stdio.h>

/* Most that the mean error of all rows and of a kind may be, %; a kind of fewer rows is not judged
 * [FIELD-TARGETS]. */
static const double bias_all = 3, bias_kind = 8;
enum { LEAST = 40 };

/* Adds the targets of a kind; both are judged on the rows that both have. */
static enum cr_err judge(struct cr_verdict *v, const char *kind, double bias,
                         const struct cr_field_result *r) {
    const struct {
        const char *what;
        double value, limit;
        bool at_least;
    } all[] = {
        {"bias, %", r->same.bias, bias, false},
        {"MAPE below WinSMASH, points", r->smash.mape - r->same.mape, 0, true},
        {"log SD below WinSMASH, %", 100 * (r->smash.log_sd - r->same.log_sd), 0, true},
    };
    enum cr_err code = CR_ERR_OK;
    for (size_t i = 0; i < sizeof all / sizeof all[0] && code == CR_ERR_OK; i++) {
        char name[96];
        snprintf(name, sizeof name, "field, %s: %s", kind, all[i].what);
        code = cr_verdict_target(v, name, all[i].value, all[i].limit, all[i].at_least);
    }
    return code;
}

enum cr_err cr_field_targets(const struct cr_field_table *field, struct cr_verdict *out,
                             struct cr_error *err) {
    struct cr_field_result r;
    enum cr_err code = cr_field_result(field, -1, -1, &r, err);
    if (code == CR_ERR_OK) {
        code = judge(out, "all", bias_all, &r);
    }
    for (int k = 0; k < CR_FIELD_KINDS && code == CR_ERR_OK; k++) {
        code = cr_field_result(field, k, -1, &r, err);
        if (code == CR_ERR_OK && r.same.n > LEAST) {
            code = judge(out, cr_field_kind_word((enum cr_field_kind)k), bias_kind, &r);
        }
    }
    return code;
}
