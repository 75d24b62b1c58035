/* A measured damage beside the one that a solve leaves, station by station. */
#ifndef CR_DAMAGE_AGAINST_H
#define CR_DAMAGE_AGAINST_H

#include "damage/crush.h"
#include "result/result.h"

/* What participant `body` of a solve looks like at the stations of m. */
void cr_crush_against(const struct cr_result *result, int body, const struct cr_measured *m,
                      struct cr_crush_against *out);
void cr_crush_against_text(const char *id, const struct cr_measured *m,
                           const struct cr_crush_against *against, struct cr_str *out);

#endif
