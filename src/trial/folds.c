/* Cross-validation: fits the models five times, each time without a fifth of the tests. */
#include "trial/folds.h"

#include <stdlib.h>
#include <string.h>

/* rounds of solving and fitting; the recipes begin near the fit of all tests, and a round closes
 * all but a small part of the distance */
enum { ROUNDS = 3 };

int cr_fold_of(int number) {
    return number % CR_FOLDS;
}

/* all tests but those of the fold */
static enum cr_err leave_out(const struct cr_calibration_data *all, int fold, bool walls,
                             bool poles, struct cr_calibration_data *out, struct cr_error *err) {
    *out = *all;
    out->walls = out->poles = 0;
    out->wall = calloc((size_t)all->walls + 1, sizeof *out->wall);
    out->pole = calloc((size_t)all->poles + 1, sizeof *out->pole);
    if (!out->wall || !out->pole) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the tests of a fold");
    }
    for (int i = 0; walls && i < all->walls; i++) {
        if (cr_fold_of(all->wall[i].number) != fold) {
            out->wall[out->walls++] = all->wall[i];
        }
    }
    for (int i = 0; poles && i < all->poles; i++) {
        if (cr_fold_of(all->pole[i].number) != fold) {
            out->pole[out->poles++] = all->pole[i];
        }
    }
    return CR_ERR_OK;
}

enum cr_err cr_folds_open(const char *dir, const char *models, bool walls, bool poles,
                          struct cr_folds *out, struct cr_error *err) {
    memset(out, 0, sizeof *out);
    enum cr_err rc = cr_calibration_read(dir, &out->all, err);
    for (int k = 0; k < CR_FOLDS && !rc; k++) {
        rc = leave_out(&out->all, k, walls, poles, &out->part[k], err);
        rc = rc ? rc : cr_model_lib_open(models, &out->lib[k], err);
        rc = rc ? rc : cr_model_need_all(out->lib[k], err);
    }
    if (rc) {
        cr_folds_close(out);
    }
    return rc;
}

void cr_folds_close(struct cr_folds *folds) {
    for (int k = 0; k < CR_FOLDS; k++) {
        cr_model_lib_free(folds->lib[k]);
        cr_calibration_fini(&folds->part[k]);
    }
    cr_calibration_fini(&folds->all);
    memset(folds, 0, sizeof *folds);
}

enum cr_err cr_folds_fit(struct cr_folds *folds, int fold, const struct cr_context *ctx,
                         struct cr_error *err) {
    return cr_calibration_fit(&folds->part[fold], folds->lib[fold], ctx, ROUNDS, err);
}
