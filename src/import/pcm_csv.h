/* Makes a database of a folder of CSV files that are named like the tables of a PCM. */
#ifndef CR_IMPORT_PCM_CSV_H
#define CR_IMPORT_PCM_CSV_H

#include "import/reader.h"

struct sqlite3;

/* Reads the tables that a PCM needs from the folder im->path into a database in a temporary file.
 * The caller calls sqlite3_close also after an error. Errors: those of cr_csv_open and cr_csv_next,
 * IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_pcm_csv(struct cr_import *im, struct sqlite3 **out,
                                     struct cr_error *err);

#endif
