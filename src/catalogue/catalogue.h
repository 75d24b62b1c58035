/* Cars by name: dimensions and kerb masses from tables, found by words in any order.
 *
 * A catalogue is the tables *.csv of some folders, those of a later folder before the others; it is
 * read once and then only looked at, so threads may share it. Columns: make, model, from, to, body,
 * type, curb_kg, min_kg, max_kg, length_m, width_m, height_m, wheelbase_m, track_m,
 * cg_behind_front_axle_m, cg_height_m, source; all but make and model may be empty or missing. */
#ifndef CR_CATALOGUE_CATALOGUE_H
#define CR_CATALOGUE_CATALOGUE_H

#include "base/err.h"
#include "base/str.h"

#include <stdbool.h>

/* One row of the tables: a body of one generation of a model. Numbers are NaN where not known. */
struct cr_car {
    const char *make, *model, *body, *type, *source;
    int from, to;                       /* model years, 0: not known */
    double curb, curb_least, curb_most; /* kerb mass, and its range over the variants, kg */
    double length, width, height, wheelbase, track, cg_behind_front_axle, cg_height; /* m */
    const char *file; /* name of its table */
    int line;         /* the line in that table */
    bool own;         /* its table is not in the first folder: it is the user's own */
};

/* What a driver adds to the kerb mass, kg. */
#define CR_CAR_DRIVER 75.0

struct cr_catalogue;

/* Read all tables of n folders; a folder that does not exist is passed over. Errors: IO, SYNTAX,
 * TYPE, RANGE with file and line; MISSING where there is no table at all. */
CR_MUST_CHECK enum cr_err cr_catalogue_open(const char *const *dir, int n,
                                            struct cr_catalogue **out, struct cr_error *err);
void cr_catalogue_free(struct cr_catalogue *catalogue);

int cr_catalogue_cars(const struct cr_catalogue *catalogue);
const struct cr_car *cr_catalogue_car(const struct cr_catalogue *catalogue, int i);

/* Indices of the rows that all words fit, into found[cr_catalogue_cars]; returns how many. A word
 * is a part of make, model or body, a year, or a length in m ("4.25m"); case, accents and signs do
 * not matter. Without
 * words all rows fit. */
int cr_catalogue_search(const struct cr_catalogue *catalogue, const char *words, int *found);

/* The one car of these words. Where they leave several, those of the user's own tables and those
 * whose whole model was named go before the others, and the usual body (sedan, hatchback, SUV, van,
 * pickup) before coupe, convertible and wagon if no body was named. Errors: NAME with the nearest
 * names or with what tells the rest apart. */
CR_MUST_CHECK enum cr_err cr_catalogue_find(const struct cr_catalogue *catalogue, const char *words,
                                            const struct cr_car **out, struct cr_error *err);

/* The model year that the words for a car say, 0: none. */
int cr_car_year(const struct cr_car *car, const char *words);

/* Add the name of a car, "Volkswagen Golf Hatchback 2015-2021". */
void cr_car_name(const struct cr_car *car, struct cr_str *out);

/* Words that such a search could go on with, of the cars that `words` (may be "") leave: the make,
 * then the model, then the years, each without what was said of it; those that begin with `begin`
 * (case does not matter), each once. With a `begin` models are told also before the make.
 * next(user, word, year) is told each. */
void cr_catalogue_complete(const struct cr_catalogue *catalogue, const char *words,
                           const char *begin, void (*next)(void *user, const char *word, bool year),
                           void *user);

/* Registers whose tables can be made tables of the catalogue. */
#define CR_CATALOGUE_FORMS "cvs|rdw|eea"

/* Turn the table of a register (form: its index in CR_CATALOGUE_FORMS) into a table of the
 * catalogue, appended to out; rows of one make, model and size become one. *cars: how many rows it
 * has. Errors: IO, SYNTAX, TYPE with line and column, MISSING for a column or where no car is left,
 * EXPENSIVE for more than a million different cars, MEMORY. */
CR_MUST_CHECK enum cr_err cr_catalogue_convert(const char *path, int form, struct cr_str *out,
                                               int *cars, struct cr_error *err);

#endif
