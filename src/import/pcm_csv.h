/* A folder of CSV files named like the tables of a PCM as a database. */
#ifndef CR_IMPORT_PCM_CSV_H
#define CR_IMPORT_PCM_CSV_H

#include "import/reader.h"

struct sqlite3;

/* Read the tables that a PCM needs of the folder im->path into a database in a temporary file. The
 * caller calls sqlite3_close also after an error. Errors: those of cr_csv_open and cr_csv_next,
 * IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_pcm_csv(struct cr_import *im, struct sqlite3 **out,
                                     struct cr_error *err);

#endif
