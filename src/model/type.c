/* Names of the six types, and the twelve sectors of the principal direction of force. */
#include "config.h"

#include "model/model_priv.h"

#include "base/vec.h"

#include <string.h>

static const char *const type_word[] = {
#define X(name, word) word,
    CR_TYPE_LIST(X)
#undef X
};

const char *cr_type_word(enum cr_type type) {
    return (unsigned)type < CR_TYPES ? type_word[type] : "";
}

int cr_type_find(const char *word) {
    for (int i = 0; i < CR_TYPES; i++) {
        if (strcmp(word, type_word[i]) == 0) {
            return i;
        }
    }
    return -1;
}

int cr_pdof_clock(double pdof) {
    double turn = pdof / (2 * CR_PI);
    int sector = (int)floor((turn - floor(turn)) * 12 + 0.5) % 12;
    return sector == 0 ? 12 : sector;
}

/* cos^2 and sin^2 of the middle of a sector, exact where they are 0 and 1 */
static void sector_share(int sector, double share[2]) {
    static const double cos2[6] = {1, 0.75, 0.25, 0, 0.25, 0.75};
    share[0] = cos2[sector % 6];
    share[1] = 1 - share[0];
}

void cr_model_mix(double pdof, bool blend, double share[2]) {
    if (!blend) {
        sector_share(cr_pdof_clock(pdof), share);
        return;
    }
    double turn = pdof / (2 * CR_PI);
    double at = (turn - floor(turn)) * 12, lo = floor(at), u = at - lo;
    double a[2], b[2];
    sector_share((int)lo, a);
    sector_share((int)lo + 1, b);
    share[0] = (1 - u) * a[0] + u * b[0];
    share[1] = 1 - share[0];
}
