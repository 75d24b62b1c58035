/* Cross-validation: fits the models five times, each time without a fifth of the tests. */
#include "trial/folds.h"

#include <stdlib.h>
#include <string.h>

/* Rounds of solving and fitting: the recipes begin near the fit of all tests, and a round closes
 * all but a small part of the distance. */
enum { ROUNDS = 3 };

int cr_fold_of(int number) {
    return (int)((unsigned)number % CR_FOLDS);
}

/* Gathers the tests of a set but those of the fold. */
static enum cr_err leave_out(const struct cr_test_set *all, int fold, struct cr_test_set *out,
                             struct cr_error *err) {
    *out = (struct cr_test_set){.item = calloc((size_t)all->n + 1, sizeof *out->item)};
    if (out->item == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the tests of a fold");
    }
    for (int i = 0; i < all->n; i++) {
        if (cr_fold_of(all->item[i]->number) != fold) {
            out->item[out->n++] = all->item[i];
        }
    }
    return CR_ERR_OK;
}

static enum cr_err open_fold(struct cr_folds *f, int fold, const char *models, bool walls,
                             bool poles, struct cr_error *err) {
    struct cr_calibration_data *part = &f->part[fold];
    enum cr_err code = CR_ERR_OK;
    part->ties = f->all.ties;
    if (walls) {
        code = leave_out(&f->all.walls, fold, &part->walls, err);
    }
    if (code == CR_ERR_OK && poles) {
        code = leave_out(&f->all.poles, fold, &part->poles, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_model_lib_open(models, &f->lib[fold], err);
    }
    if (code == CR_ERR_OK) {
        code = cr_model_need_all(f->lib[fold], err);
    }
    return code;
}

enum cr_err cr_folds_open(const char *dir, const char *models, bool walls, bool poles,
                          struct cr_folds *out, struct cr_error *err) {
    memset(out, 0, sizeof *out);
    enum cr_err code = cr_calibration_read(dir, &out->all, err);
    for (int k = 0; k < CR_FOLDS && code == CR_ERR_OK; k++) {
        code = open_fold(out, k, models, walls, poles, err);
    }
    if (code != CR_ERR_OK) {
        cr_folds_close(out);
    }
    return code;
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
