/* The option --picture of `crumple run`. */
#ifndef CR_CLI_PICTURES_H
#define CR_CLI_PICTURES_H

#include "cli/word.h"

/* Are all values of --picture, "[WHAT=]FILE", understood? Asked before the solve. Errors: USAGE. */
CR_MUST_CHECK enum cr_err cr_cli_check_pictures(const struct cr_option_values *pictures,
                                                struct cr_error *err);
/* Draw them. Errors: those of the pictures and of the files. */
CR_MUST_CHECK enum cr_err cr_cli_pictures(const struct cr_option_values *pictures,
                                          const struct cr_result *result,
                                          const struct cr_context *ctx, struct cr_error *err);

#endif
