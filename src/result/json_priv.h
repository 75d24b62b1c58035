/* What the writers of a result's JSON share. None of them reports a lack of memory: an object that
 * could not be made leaves its mark in the tree (base/tree.h), and cr_result_tree tells in the
 * end. */
#ifndef CR_RESULT_JSON_PRIV_H
#define CR_RESULT_JSON_PRIV_H

#include "result/result_priv.h"

struct cJSON; /* as cJSON.h has it: its type is opaque here */

/* Add numbers; they go through cr_round12, and NaN and infinity become null. */
void cr_json_put(struct cJSON *to, const char *key, double x);
struct cJSON *cr_json_point(struct cr_vec2 p);
struct cJSON *cr_json_numbers(const double *x, int n);

/* Add groups of the keys of a participant to p, from its severity in all or in one impact; version
 * is that of the result's JSON. */
void cr_json_motion(const struct cr_severity *s, int version, struct cJSON *p);
void cr_json_deformation(const struct cr_severity *s, int version, struct cJSON *p);
void cr_json_outline(const struct cr_severity *s, struct cJSON *p);
void cr_json_pulse(const struct cr_severity *s, struct cJSON *p);
void cr_json_occupant(const struct cr_severity *s, struct cJSON *p);
void cr_json_injury(const struct cr_severity *s, struct cJSON *p);

/* Add what is told only of all impacts together. */
void cr_json_barrier(const struct cr_result *r, int i, struct cJSON *p);
void cr_json_totals(const struct cr_severity *s, struct cJSON *p);
void cr_json_quality(const struct cr_result *r, struct cJSON *json);
void cr_json_robust(const struct cr_result *r, struct cJSON *json); /* nothing where unchecked */
void cr_json_impacts(const struct cr_result *r, struct cJSON *json);
/* Warning i: its code and text, in version 1 the text alone. */
struct cJSON *cr_json_warning(const struct cr_result *r, int i, int version);

#endif
