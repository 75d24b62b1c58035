/* Names for the values of a result: the keys of its JSON joined by dots, as libcrumple, stacks and
 * their tables use them. A participant goes by its id, an injury risk by its function, another
 * element of a list by its number: "A.ees_kmh", "A.injury.NAME.probability",
 * "contacts.0.restitution". */
#ifndef CR_RESULT_NAMES_H
#define CR_RESULT_NAMES_H

#include "base/arena.h"
#include "base/err.h"

#include <stdbool.h>

enum { CR_VALUE_NAME_MAX = 160 };

struct cJSON;

/* The item in the JSON of a result that a name stands for, NULL if there is none. The unit at the
 * end of a name may be left out: "A.ees" is "A.ees_kmh". */
const struct cJSON *cr_names_find(const struct cJSON *result, const char *name);

/* One value: a number (NaN for null), or a text. */
struct cr_named {
    const char *name;
    const char *text; /* NULL: a number */
    double number;
};

/* Lists all values of a result in the order of its JSON, in memory of the arena. Left out are the
 * time series, the resolved scene, the messages and lists of points. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_names_list(const struct cJSON *result, struct cr_arena *arena,
                                        struct cr_named **out, int *n, struct cr_error *err);

/* Whether a key is the name with a unit behind it: "ees_kmh" of "ees". */
bool cr_names_is_short(const char *key, const char *name, size_t len);

#endif
