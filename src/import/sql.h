/* Reads SQLite databases that may be hostile: they are opened for reading only, with bounds, and
 * errors name the file. */
#ifndef CR_IMPORT_SQL_H
#define CR_IMPORT_SQL_H

#include "import/reader.h"

struct sqlite3;
struct sqlite3_stmt;

/* Opens a file, or with path "" an empty database that lives in a temporary file. The caller calls
 * sqlite3_close also after an error. Errors: IO, SYNTAX, MEMORY. */
CR_MUST_CHECK enum cr_err cr_sql_open(struct cr_import *im, const char *path, struct sqlite3 **out,
                                      struct cr_error *err);
/* Prepares a statement; the caller calls sqlite3_finalize also after an error. Errors: SYNTAX, IO,
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_sql_prepare(struct cr_import *im, struct sqlite3 *db,
                                         const struct cr_str *text, struct sqlite3_stmt **out,
                                         struct cr_error *err);
/* Goes to the next row; *row is false after the last. Errors: SYNTAX for a database that is broken,
 * IO, MEMORY, EXPENSIVE for one that would take hours, INTERRUPTED. */
CR_MUST_CHECK enum cr_err cr_sql_step(struct cr_import *im, struct sqlite3 *db,
                                      struct sqlite3_stmt *stmt, bool *row, struct cr_error *err);
/* Looks whether there is the table and in it the column (NULL: any). Errors: those of
 * cr_sql_step. */
CR_MUST_CHECK enum cr_err cr_sql_has(struct cr_import *im, struct sqlite3 *db, const char *table,
                                     const char *column, bool *there, struct cr_error *err);
/* Refuses a table that is a view or a virtual one or has computed columns. Errors: TYPE, those of
 * cr_sql_step. */
CR_MUST_CHECK enum cr_err cr_sql_need_plain(struct cr_import *im, struct sqlite3 *db,
                                            const char *table, struct cr_error *err);

#endif
