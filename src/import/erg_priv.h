/* Declares what the two halves of the reader of CarMaker share: the description of an ERG file. */
#ifndef CR_IMPORT_ERG_PRIV_H
#define CR_IMPORT_ERG_PRIV_H

#include "import/reader.h"

enum { CR_ERG_NAME = 128, CR_ERG_QUANTITIES = 20000, CR_ERG_HEADER = 16 };

enum cr_erg_kind { CR_ERG_FLOAT, CR_ERG_SIGNED, CR_ERG_UNSIGNED, CR_ERG_PADDING };

/* A quantity of a record. Its value is factor * raw + offset, in its unit. */
struct cr_erg_quantity {
    char name[CR_ERG_NAME], unit[32];
    enum cr_erg_kind kind;
    int bytes, at; /* its length, and the byte of the record where it begins */
    double factor, offset;
};

struct cr_erg {
    bool big_endian;
    int n, size, record; /* record: bytes of one */
    struct cr_erg_quantity *quantity;
};

/* Reads the text of NAME.erg.info, called `shown` in errors. out needs cr_erg_fini also after an
 * error. Errors: SYNTAX, MISSING, RANGE, MEMORY, with the line. */
CR_MUST_CHECK enum cr_err cr_erg_parse(const char *text, const char *shown, struct cr_erg *out,
                                       struct cr_error *err);
void cr_erg_fini(struct cr_erg *erg);

/* Index of a quantity, -1 if there is none. */
int cr_erg_find(const struct cr_erg *erg, const char *name);
/* Value of quantity i of a record, in its unit. */
double cr_erg_value(const struct cr_erg *erg, int i, const unsigned char *record);

#endif
