/* What the files of the library share: what is behind its two opaque types, errors, the locale. */
#ifndef CR_LIB_LIB_PRIV_H
#define CR_LIB_LIB_PRIV_H

#include "lib/crumple.h"

#include "damage/crush.h"
#include "result/names.h"
#include "result/result.h"

#include <locale.h>
#include <stdatomic.h>

struct crumple {
    atomic_int users; /* the caller until it closes, and each result: its grids lie in the models */
    struct cr_model_lib *models;
    struct cr_irf_set *irf;
    struct cr_crush_rules rules; /* of measured deformations */
    locale_t c_locale; /* numbers with a point, messages in English, for the time of a call */
    char hash[CR_HASH_SIZE];
};

struct crumple_result {
    struct crumple *lib;
    struct cr_result *result;
    struct cr_arena arena; /* owns the names */
    struct cr_named *value;
    int values;
};

/* Translate code and error of the program into those of the library (err NULL: the code alone);
 * out is nullable. Returns the code of the library. */
int cr_lib_error(enum cr_err code, const struct cr_error *err, crumple_error *out);

/* Hand a text to the caller, who frees it, and its length (nullable); NULL after an error. */
char *cr_lib_text(enum cr_err code, struct cr_str *text, size_t *length);

/* The options with what an older caller does not know of left at its default. */
crumple_options cr_lib_options(const crumple_options *given);

#endif
