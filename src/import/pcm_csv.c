/* Makes a database of a folder of CSV files that are named like the tables of a PCM. */
#include "config.h"

#if HAVE_SQLITE3
#include "import/pcm_csv.h"

#include "base/csv.h"
#include "import/sql.h"

#include <sqlite3.h>
#include <stdio.h>
#include <string.h>

enum { COLUMNS_MAX = 500 };

/* Writes a name in quotes, with the quotes in it doubled. */
static void quoted(struct cr_str *out, const char *name) {
    cr_str_add(out, "\"");
    for (const char *p = name; *p != '\0'; p++) {
        cr_str_addn(out, p, 1);
        if (*p == '"') {
            cr_str_add(out, "\"");
        }
    }
    cr_str_add(out, "\"");
}

static enum cr_err run(struct cr_import *im, sqlite3 *db, const struct cr_str *text,
                       struct cr_error *err) {
    sqlite3_stmt *stmt = NULL;
    bool row;
    enum cr_err code = cr_sql_prepare(im, db, text, &stmt, err);
    code = code == CR_ERR_OK ? cr_sql_step(im, db, stmt, &row, err) : code;
    sqlite3_finalize(stmt);
    return code;
}

static enum cr_err make_table(struct cr_import *im, sqlite3 *db, const char *name,
                              const struct cr_csv *csv, struct cr_error *err) {
    struct cr_str text = {0};
    int n = cr_csv_columns(csv);
    if (n > COLUMNS_MAX) {
        return cr_csv_head_fault(csv, COLUMNS_MAX, err, CR_ERR_RANGE, "more than %d columns",
                                 COLUMNS_MAX);
    }
    cr_str_addf(&text, "CREATE TABLE %s (", name);
    for (int i = 0; i < n; i++) {
        cr_str_add(&text, i > 0 ? ", " : "");
        quoted(&text, cr_csv_name(csv, i));
    }
    cr_str_add(&text, ")");
    enum cr_err code = run(im, db, &text, err);
    if (code == CR_ERR_SYNTAX) { /* A name stands there twice or is empty. */
        cr_err_place(err, im->shown, 0, 0);
    }
    cr_str_fini(&text);
    return code;
}

/* Binds a field: a number as a number, so that times are sorted as numbers, an empty one as
 * NULL. */
static bool bind(sqlite3_stmt *stmt, int i, const char *cell, bool comma) {
    double x;
    if (cell[0] == '\0') {
        return sqlite3_bind_null(stmt, i) == SQLITE_OK;
    }
    if (strlen(cell) < 16 && strspn(cell, "0123456789") == strlen(cell)) {
        long long whole = 0;
        sscanf(cell, "%lld", &whole);
        return sqlite3_bind_int64(stmt, i, whole) == SQLITE_OK;
    }
    if (cr_csv_scan(cell, comma, &x)) {
        return sqlite3_bind_double(stmt, i, x) == SQLITE_OK;
    }
    return sqlite3_bind_text(stmt, i, cell, -1, SQLITE_TRANSIENT) == SQLITE_OK;
}

static enum cr_err fill(struct cr_import *im, sqlite3 *db, sqlite3_stmt *stmt, struct cr_csv *csv,
                        struct cr_error *err) {
    enum cr_err code;
    bool row, none;
    while ((code = cr_csv_next(csv, &row, err)) == CR_ERR_OK && row) {
        for (int i = 0; i < cr_csv_columns(csv); i++) {
            if (!bind(stmt, i + 1, cr_csv_cell(csv, i), cr_csv_comma(csv))) {
                return cr_err_set(err, CR_ERR_MEMORY, "no memory for the database");
            }
        }
        code = cr_sql_step(im, db, stmt, &none, err);
        sqlite3_reset(stmt);
        if (code != CR_ERR_OK) {
            break;
        }
    }
    return code;
}

static enum cr_err read_table(struct cr_import *im, sqlite3 *db, const char *name, const char *path,
                              struct cr_error *err) {
    struct cr_csv_opts opts = {.path = path};
    struct cr_csv *csv = NULL;
    struct cr_str text = {0};
    sqlite3_stmt *stmt = NULL;
    enum cr_err code = cr_import_also(im, path, err);
    code = code == CR_ERR_OK ? cr_csv_open(&opts, &csv, err) : code;
    code = code == CR_ERR_OK ? make_table(im, db, name, csv, err) : code;
    if (code == CR_ERR_OK) {
        cr_str_addf(&text, "INSERT INTO %s VALUES (?", name);
        for (int i = 1; i < cr_csv_columns(csv); i++) {
            cr_str_add(&text, ", ?");
        }
        cr_str_add(&text, ")");
        code = cr_sql_prepare(im, db, &text, &stmt, err);
    }
    code = code == CR_ERR_OK ? fill(im, db, stmt, csv, err) : code;
    sqlite3_finalize(stmt);
    cr_str_fini(&text);
    cr_csv_close(csv);
    return code;
}

enum cr_err cr_pcm_csv(struct cr_import *im, sqlite3 **out, struct cr_error *err) {
    static const char *const tables[] = {"participant_data", "participant_shape", "dynamics"};
    const struct cr_str begin = {.s = (char[]){"BEGIN"}, .len = 5},
                        commit = {.s = (char[]){"COMMIT"}, .len = 6};
    enum cr_err code = cr_sql_open(im, "", out, err);
    code = code == CR_ERR_OK ? run(im, *out, &begin, err) : code;
    for (size_t i = 0; i < sizeof tables / sizeof *tables && code == CR_ERR_OK; i++) {
        char name[64], path[4096];
        snprintf(name, sizeof name, "%s.csv", tables[i]);
        code = cr_import_file_in(im->path, name, path, sizeof path, err);
        if (code == CR_ERR_OK && path[0] != '\0') {
            code = read_table(im, *out, tables[i], path, err);
        }
    }
    return code == CR_ERR_OK ? run(im, *out, &commit, err) : code;
}

#endif
