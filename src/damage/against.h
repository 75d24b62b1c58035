/* Puts a measured damage beside the one that a solve leaves, station by station. */
#ifndef CR_DAMAGE_AGAINST_H
#define CR_DAMAGE_AGAINST_H

#include "damage/crush.h"
#include "result/result.h"

/* Residual depths that a solve leaves on participant `body` at the stations of m, against those
 * that were measured. */
void cr_crush_against(const struct cr_result *result, int body, const struct cr_measured *m,
                      struct cr_crush_against *out);
/* The same as lines for the participant `id`. */
void cr_crush_against_text(const char *id, const struct cr_measured *m,
                           const struct cr_crush_against *against, struct cr_str *out);

#endif
