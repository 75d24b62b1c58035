/* What the reader of tables of crash tests does for the reader of their classes. */
#ifndef CR_TRIAL_CRASHTEST_READ_H
#define CR_TRIAL_CRASHTEST_READ_H

#include "trial/crashtest.h"

/* Append the tests of a table: walls, known by the columns c1 to c6, or side poles, known by
 * crush_mm. Errors: IO, SYNTAX, TYPE, MISSING, MODEL (a car of no type), with the line. */
CR_MUST_CHECK enum cr_err cr_test_load_table(const char *path, enum cr_test_class class,
                                             const struct cr_type_rules *rules,
                                             struct cr_test_list *list, struct cr_error *err);

/* Give the walls from number `from` of the list their dynamic crush and peak from a table of
 * signals. Errors: as above. */
CR_MUST_CHECK enum cr_err cr_test_add_pulses(const char *path, struct cr_test_list *list, int from,
                                             struct cr_error *err);

#endif
