/* Cross-validation: models are calibrated on four fifths of the tests and judged by the fifth that
 * they have not seen. */
#ifndef CR_TRIAL_FOLDS_H
#define CR_TRIAL_FOLDS_H

#include "trial/calibrate.h"

enum { CR_FOLDS = 5 };

/* Fold of a test by its number: 0 up to CR_FOLDS - 1. */
int cr_fold_of(int number);

struct cr_folds {
    struct cr_calibration_data all, part[CR_FOLDS]; /* all tests, and those that a fold may see */
    struct cr_model_lib *lib[CR_FOLDS];             /* the models of a fold */
};

/* Read the calibration data below the data folder, and open the recipes of `models` for each fold.
 * walls, poles: which faces are to be calibrated. Errors: IO, SYNTAX, MODEL, MEMORY. */
CR_MUST_CHECK enum cr_err cr_folds_open(const char *dir, const char *models, bool walls, bool poles,
                                        struct cr_folds *out, struct cr_error *err);
void cr_folds_close(struct cr_folds *folds);

/* Calibrate the models of a fold on all tests but its own; folds may be worked side by side. */
CR_MUST_CHECK enum cr_err cr_folds_fit(struct cr_folds *folds, int fold,
                                       const struct cr_context *ctx, struct cr_error *err);

#endif
