/* Names of the vehicle types, and the twelve sectors (clock hours) that the principal direction of
 * force, PDOF, is sorted into. */
#include "config.h"

#include "model/model_priv.h"

#include "base/str.h"
#include "base/vec.h"

#include <stdio.h>
#include <stdlib.h>
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

enum cr_err cr_model_name_read(const char *text, struct cr_model_name *out, struct cr_error *err) {
    char word[32];
    size_t len = strcspn(text, "/");
    snprintf(word, sizeof word, "%.*s", (int)(len < 31 ? len : 31), text);
    int type = cr_type_find(word);
    if (type < 0) {
        const char *known[CR_TYPES], *near;
        for (int i = 0; i < CR_TYPES; i++) {
            known[i] = cr_type_word((enum cr_type)i);
        }
        near = cr_str_nearest(word, known, CR_TYPES);
        enum cr_err code = cr_err_set(err, CR_ERR_NAME, "no model \"%.80s\"", text);
        if (near != NULL) {
            cr_err_hint(err, "did you mean %s%.40s?", near, text + len);
        } else {
            cr_err_hint(err, CR_TYPE_WORDS "; also with an hour, sedan/12");
        }
        return code;
    }
    *out = (struct cr_model_name){.type = (enum cr_type)type};
    if (text[len] == '/') {
        char *end = NULL;
        long clock = strtol(text + len + 1, &end, 10);
        if (end == text + len + 1 || *end != '\0' || clock < 1 || clock > 12) {
            enum cr_err code = cr_err_set(err, CR_ERR_RANGE, "no model \"%.80s\"", text);
            cr_err_hint(err, "the direction of force is a clock hour, %s/1 to %s/12", word, word);
            return code;
        }
        out->clock = (int)clock;
    }
    return CR_ERR_OK;
}

int cr_pdof_clock(double pdof) {
    /* half an hour, to rounding, belongs to the hour further from 12 on both sides */
    double turn = remainder(pdof, 2 * CR_PI);
    int hours = (int)floor(fabs(turn) * (6 / CR_PI) + 0.5 + 1e-9);
    int sector = turn < 0 ? 12 - hours : hours;
    return sector == 0 ? 12 : sector;
}

static struct cr_model_sector sector_of(int clock, double part) {
    /* cos^2 of the hour's angle; cos() itself would not be 0 at 3 o'clock. */
    static const double cos2[6] = {1, 0.75, 0.25, 0, 0.25, 0.75};
    double c2 = cos2[clock % 6];
    return (struct cr_model_sector){{c2, 1 - c2}, clock, c2 < 0.5, part};
}

int cr_model_sectors(double pdof, bool blend, struct cr_model_sector out[2]) {
    if (!blend) {
        out[0] = sector_of(cr_pdof_clock(pdof), 1);
        return 1;
    }
    double turn = pdof / (2 * CR_PI);
    double at = (turn - floor(turn)) * 12, lo = floor(at), u = at - lo;
    out[0] = sector_of((int)lo, 1 - u);
    out[1] = sector_of((int)lo + 1, u);
    return u > 0 ? 2 : 1;
}
