/* Reads crash tests in ISO-MME (ISO/TS 13499), the exchange format of test laboratories: descriptor
 * files, channels, and the folder in which the channels of a test lie. */
#ifndef CR_RESULT_MME_H
#define CR_RESULT_MME_H

#include "base/str.h"
#include "result/channel.h"

#include <stdbool.h>

enum { CR_MME_CODE = 17 };

/* The lines "key :value" of a text, UTF-8 or Latin-1. */
struct cr_mme {
    char *text; /* owned UTF-8, cut into keys and values */
    int n, size, lines;
    struct cr_mme_line {
        const char *key, *value;
        int line;
    } * item;
};

/* Reads the descriptors at the begin of a file, up to the first line that has no colon. cr_mme_fini
 * gives back, also after an error. Errors: IO, RANGE (too many descriptors), MEMORY. */
CR_MUST_CHECK enum cr_err cr_mme_load(const char *path, struct cr_mme *out, struct cr_error *err);
void cr_mme_fini(struct cr_mme *mme);

/* Value of a key, in any case; NULL if there is none or it is NOVALUE. *line (nullable) is its
 * line. */
const char *cr_mme_get(const struct cr_mme *mme, const char *key, int *line);
/* The value of a key as a number, NaN where there is none. Errors: TYPE with the line. */
CR_MUST_CHECK enum cr_err cr_mme_number(const struct cr_mme *mme, const char *shown,
                                        const char *key, double *out, struct cr_error *err);

/* A channel file: its code, its unit, its samples. */
struct cr_mme_channel {
    char code[CR_MME_CODE], unit[32];
    struct cr_channel samples;
};
/* Reads a channel from a text, with `shown` as its name in errors, or from a file. cr_channel_fini
 * of the samples gives back, also after an error. Errors: IO, MISSING, SYNTAX, RANGE, MEMORY; TYPE
 * for what is no number, and for a channel over another one instead of over time. */
CR_MUST_CHECK enum cr_err cr_mme_channel(const char *text, const char *shown,
                                         struct cr_mme_channel *out, struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_mme_channel_load(const char *path, struct cr_mme_channel *out,
                                              struct cr_error *err);

/* Whether a code is that of a vehicle's acceleration along an axis ('X', 'Y'), as
 * "10VEHCCG0000ACXC" is; its first character is the number of the test object. */
bool cr_mme_is_accel(const char *code, char axis);

/* Tells take() each channel file of the test in folder `dir`, "dir/Channel/NAME.001", in the order
 * of their names; the first error ends the walk. */
typedef enum cr_err cr_mme_take(void *user, const char *path, const char *name,
                                struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_mme_channels(const char *dir, cr_mme_take *take, void *user,
                                          struct cr_error *err);

#endif
