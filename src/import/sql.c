/* Reads SQLite databases that may be hostile: they are opened for reading only, with bounds, and
 * errors name the file. */
#include "config.h"

#if HAVE_SQLITE3
#include "import/sql.h"

#include <limits.h>
#include <sqlite3.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* watching() is called every STEPS instructions of SQLite. A database of plain tables is read in
 * about one for each byte of its file; statistics that a stranger made up can make that the square.
 * One that wants fifty for each byte, and CALLS_LEAST calls, is ended. */
enum { STEPS = 10000, CALLS_LEAST = 2000, BYTES_A_CALL = STEPS / 50 };

static int watching(void *user) {
    struct cr_import *im = user;
    im->polls++;
    return im->polls > im->polls_most ||
           (im->opts->cancel != NULL && im->opts->cancel(im->opts->user) != 0);
}

static enum cr_err fault(struct cr_import *im, sqlite3 *db, struct cr_error *err) {
    int status = db != NULL ? sqlite3_errcode(db) : SQLITE_NOMEM;
    enum cr_err code = CR_ERR_SYNTAX;
    if (status == SQLITE_NOMEM) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the database");
    }
    if (status == SQLITE_INTERRUPT) {
        bool user = im->polls <= im->polls_most;
        code = cr_err_set(err, user ? CR_ERR_INTERRUPTED : CR_ERR_EXPENSIVE, "%s",
                          user ? "interrupted" : "too expensive: the database misleads SQLite");
        if (!user) {
            cr_err_place(err, im->shown, 0, 0);
            cr_err_hint(err, "DROP TABLE sqlite_stat1 takes its statistics away");
        }
        return code;
    }
    if (status == SQLITE_CANTOPEN || status == SQLITE_IOERR || status == SQLITE_FULL) {
        code = CR_ERR_IO;
    }
    cr_err_set(err, code, "SQLite: %.150s", sqlite3_errmsg(db));
    cr_err_place(err, im->shown, 0, 0);
    return code;
}

/* Writes a path as a URI of a file that does not change: then SQLite writes nothing beside it and
 * takes no lock. */
static enum cr_err uri_of(const char *path, struct cr_str *uri, struct cr_error *err) {
    cr_str_add(uri, "file:");
    for (const unsigned char *p = (const unsigned char *)path; *p != '\0'; p++) {
        bool plain = *p > ' ' && *p < 0x7f && strchr("%?#", *p) == NULL;
        cr_str_addf(uri, plain ? "%c" : "%%%02x", *p);
    }
    cr_str_add(uri, "?immutable=1");
    return uri->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the database") : CR_ERR_OK;
}

/* what there is to read, bytes; 0 where that is not known */
static long size_of(const char *path) {
    struct stat st;
    return stat(path, &st) == 0 ? (long)(st.st_size < LONG_MAX ? st.st_size : LONG_MAX / 2) : 0;
}

enum cr_err cr_sql_open(struct cr_import *im, const char *path, sqlite3 **out,
                        struct cr_error *err) {
    struct cr_str uri = {0};
    bool own = path[0] == '\0';
    enum cr_err code = own ? CR_ERR_OK : uri_of(path, &uri, err);
    *out = NULL;
    if (code == CR_ERR_OK && sqlite3_open_v2(cr_str_get(&uri), out,
                                             own ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
                                                 : SQLITE_OPEN_READONLY | SQLITE_OPEN_URI,
                                             NULL) != SQLITE_OK) {
        code = fault(im, *out, err);
    }
    cr_str_fini(&uri);
    if (code != CR_ERR_OK) {
        return code;
    }
    sqlite3_db_config(*out, SQLITE_DBCONFIG_DEFENSIVE, 1, NULL);
    sqlite3_db_config(*out, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, NULL);
    sqlite3_limit(*out, SQLITE_LIMIT_LENGTH, 10000000);
    sqlite3_limit(*out, SQLITE_LIMIT_EXPR_DEPTH, 100);
    sqlite3_limit(*out, SQLITE_LIMIT_ATTACHED, 0);
    im->polls = 0;
    im->polls_most = own ? LONG_MAX : CALLS_LEAST + size_of(path) / BYTES_A_CALL;
    sqlite3_progress_handler(*out, STEPS, watching, im);
    return CR_ERR_OK;
}

enum cr_err cr_sql_prepare(struct cr_import *im, sqlite3 *db, const struct cr_str *text,
                           sqlite3_stmt **out, struct cr_error *err) {
    if (text->failed) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the database");
    }
    return sqlite3_prepare_v2(db, cr_str_get(text), -1, out, NULL) == SQLITE_OK
               ? CR_ERR_OK
               : fault(im, db, err);
}

enum cr_err cr_sql_step(struct cr_import *im, sqlite3 *db, sqlite3_stmt *stmt, bool *row,
                        struct cr_error *err) {
    /* A text of the row before for which there was no memory read as an empty one: it is told here,
     * before the step hides it. */
    bool short_of_memory = sqlite3_errcode(db) == SQLITE_NOMEM;
    int status = short_of_memory ? SQLITE_NOMEM : sqlite3_step(stmt);
    *row = status == SQLITE_ROW;
    return status == SQLITE_ROW || status == SQLITE_DONE ? CR_ERR_OK : fault(im, db, err);
}

enum cr_err cr_sql_has(struct cr_import *im, sqlite3 *db, const char *table, const char *column,
                       bool *there, struct cr_error *err) {
    sqlite3_stmt *stmt = NULL;
    bool row = true;
    enum cr_err code = CR_ERR_OK;
    *there = false;
    if (sqlite3_prepare_v2(db, "SELECT name FROM pragma_table_info(?1)", -1, &stmt, NULL) !=
            SQLITE_OK ||
        sqlite3_bind_text(stmt, 1, table, -1, SQLITE_STATIC) != SQLITE_OK) {
        code = fault(im, db, err);
    }
    while (code == CR_ERR_OK && row && !*there) {
        code = cr_sql_step(im, db, stmt, &row, err);
        const char *name = row ? (const char *)sqlite3_column_text(stmt, 0) : NULL;
        *there = row && (column == NULL || (name != NULL && sqlite3_stricmp(name, column) == 0));
    }
    sqlite3_finalize(stmt);
    return code;
}

/* A view or a computed column would run what a stranger wrote: without end, or with gigabytes to be
 * sorted out of a few bytes. */
enum cr_err cr_sql_need_plain(struct cr_import *im, sqlite3 *db, const char *table,
                              struct cr_error *err) {
    static const char computed[] = "SELECT 1 FROM pragma_table_xinfo(?1) WHERE hidden <> 0";
    sqlite3_stmt *stmt = NULL;
    bool there, row = false;
    enum cr_err code = cr_sql_has(im, db, table, NULL, &there, err);
    if (code != CR_ERR_OK || !there) {
        return code;
    }
    int status = sqlite3_table_column_metadata(db, NULL, table, NULL, NULL, NULL, NULL, NULL, NULL);
    bool view = status == SQLITE_ERROR;
    if ((status != SQLITE_OK && !view) ||
        sqlite3_prepare_v2(db, computed, -1, &stmt, NULL) != SQLITE_OK ||
        sqlite3_bind_text(stmt, 1, table, -1, SQLITE_STATIC) != SQLITE_OK) {
        code = fault(im, db, err);
    } else {
        code = cr_sql_step(im, db, stmt, &row, err);
    }
    sqlite3_finalize(stmt);
    if (code == CR_ERR_OK && (view || row)) {
        code =
            cr_err_set(err, CR_ERR_TYPE, "%s is no plain table: the database computes it", table);
        cr_err_place(err, im->shown, 0, 0);
        cr_err_hint(err, "CREATE TABLE copy AS SELECT * FROM %s makes one", table);
    }
    return code;
}

#endif
