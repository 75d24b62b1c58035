/* What the files of src/catalogue share: the tables and their rows. */
#ifndef CR_CATALOGUE_CATALOGUE_PRIV_H
#define CR_CATALOGUE_CATALOGUE_PRIV_H

#include "catalogue/catalogue.h"

struct cr_records;

struct cr_catalogue {
    struct cr_records **table; /* their texts are those of the cars */
    int tables, table_size;
    struct cr_car *car;
    int n, size;
};

/* Whether a car can have the number x in a column of the tables; false for NaN. */
bool cr_car_in_range(const char *column, double x);

#endif
