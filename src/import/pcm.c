/* Reads the pre-crash matrices (PCM) of the accident databases GIDAS and IGLAD, of both
 * generations: an SQLite database, or a folder of CSV files named like the tables, as mdb-export
 * makes them of an Access file. */
#include "config.h"

#include "import/reader.h"

#include <string.h>

#if HAVE_SQLITE3
#include "base/csv.h"
#include "import/pcm_csv.h"
#include "import/sql.h"

#include <math.h>
#include <sqlite3.h>
#include <stdio.h>
#include <stdlib.h>

/* Columns by their names in version 5 and before: X(NAME, table, v5, before, needed). */
#define PCM_COLUMNS(X)                                                                             \
    X(CASE, "participant_data", "CASEID", "FALL", true)                                            \
    X(PART, "participant_data", "PARTID", "BETNR", true)                                           \
    X(TYPE, "participant_data", "PARTTYPE", "TYPEPCM", true)                                       \
    X(LENGTH, "participant_data", "LENGTH", "LENGTH", false)                                       \
    X(WIDTH, "participant_data", "WIDTH", "WIDTH", false)                                          \
    X(HEIGHT, "participant_data", "HEIGHT", "HEIGHT", false)                                       \
    X(MASS, "participant_data", "WEIGHT", "WEIGHT", false)                                         \
    X(CG, "participant_data", "FRONTAXLEX", "DISTCGFA", false)                                     \
    X(CG_HEIGHT, "participant_data", "COGZ", "HEIGHTCG", false)                                    \
    X(WHEELBASE, "participant_data", "WHEELBASE", "WHEELBASE", false)                              \
    X(TRACK, "participant_data", "TRACKWIDTH", "TRACKWIDTH", false)                                \
    X(INERTIA, "participant_data", "IZZ", "IZZ", false)                                            \
    X(CG_FRONT, "participant_data", NULL, "CGFRONT", false)                                        \
    X(MUE, "participant_data", NULL, "MUE", false)                                                 \
    X(D_CASE, "dynamics", "CASEID", "FALL", true)                                                  \
    X(D_PART, "dynamics", "PARTID", "BETNR", true)                                                 \
    X(T, "dynamics", "TIME", "STEP", true)                                                         \
    X(POSX, "dynamics", "POSX", "XPOS", true)                                                      \
    X(POSY, "dynamics", "POSY", "YPOS", true)                                                      \
    X(PSI, "dynamics", "POSPSI", "PSI", true)                                                      \
    X(VX, "dynamics", "VX", "VX", true)                                                            \
    X(VY, "dynamics", "VY", "VY", true)                                                            \
    X(D_MUE, "dynamics", "MUE", NULL, false)

enum {
#define X(name, table, v5, before, needed) name,
    PCM_COLUMNS(X)
#undef X
        COLUMNS
};
static const struct {
    const char *table, *name[2];
    bool needed;
} columns[COLUMNS] = {
#define X(name, table, v5, before, needed) {table, {v5, before}, needed},
    PCM_COLUMNS(X)
#undef X
};

struct pcm {
    struct cr_import *im;
    sqlite3 *db;
    int old;                 /* 1: the generation before version 5 */
    const char *of[COLUMNS]; /* the SQL that gives the column, "NULL" if it is not there */
    sqlite3_stmt *parts, *rows;
    bool more_parts, more_rows; /* a row is at hand */
    char slip[160];             /* a column that is read under another name; "": none */
    double mue_lo, mue_hi;
};

/* ---- what the database has ---- */

static enum cr_err missing(struct pcm *m, int i, struct cr_error *err) {
    bool table;
    enum cr_err code = cr_sql_has(m->im, m->db, columns[i].table, NULL, &table, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_err_set(err, CR_ERR_MISSING, "table %s %s%s", columns[i].table,
               table ? "has no column " : "is not there", table ? columns[i].name[m->old] : "");
    cr_err_place(err, m->im->shown, 0, 0);
    cr_err_hint(err, "a PCM has participant_data and dynamics, see crumple-import(1)");
    return CR_ERR_MISSING;
}

/* Columns of a PCM that are not read, and are no slips of those that are. */
static const char *const others[] = {"IXX",      "IYY", "AX",    "AY",    "AZ",   "X",
                                     "Y",        "Z",   "VZ",    "POSZ",  "ZPOS", "POSPHI",
                                     "POSTHETA", "PHI", "THETA", "PITCH", "ROLL"};

/* Tells whether a column is one of those that are known, of either generation. */
static bool is_known(const char *name) {
    bool known = false;
    for (int i = 0; i < COLUMNS; i++) {
        for (int old = 0; old < 2; old++) {
            const char *own = columns[i].name[old];
            known = known || (own != NULL && sqlite3_stricmp(own, name) == 0);
        }
    }
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        known = known || sqlite3_stricmp(others[i], name) == 0;
    }
    return known;
}

/* Looks for a column that is not there, and need not be, under a misspelt name: the user is told
 * so, else a mass would be assumed beside one that was given. */
static enum cr_err find_slip(struct pcm *m, int column, struct cr_error *err) {
    const char *name = columns[column].name[m->old];
    struct cr_str text = {0};
    sqlite3_stmt *list = NULL;
    bool row = true;
    cr_str_addf(&text, "SELECT upper(name) FROM pragma_table_info('%s')", columns[column].table);
    enum cr_err code = cr_sql_prepare(m->im, m->db, &text, &list, err);
    while (code == CR_ERR_OK && row) {
        code = cr_sql_step(m->im, m->db, list, &row, err);
        const char *other = row ? (const char *)sqlite3_column_text(list, 0) : NULL;
        if (other != NULL && m->slip[0] == '\0' && !is_known(other) &&
            cr_str_nearest(other, &name, 1) != NULL) {
            snprintf(m->slip, sizeof m->slip, "no %s in %s: is \"%.40s\" meant, which is not read?",
                     name, columns[column].table, other);
        }
    }
    sqlite3_finalize(list);
    cr_str_fini(&text);
    return code;
}

static enum cr_err find_columns(struct pcm *m, struct cr_error *err) {
    static const char *const tables[] = {"participant_data", "participant_shape", "dynamics"};
    bool v5 = false, old = false, there;
    enum cr_err code = CR_ERR_OK;
    for (size_t i = 0; i < sizeof tables / sizeof *tables && code == CR_ERR_OK; i++) {
        code = cr_sql_need_plain(m->im, m->db, tables[i], err);
    }
    if (code == CR_ERR_OK) {
        code = cr_sql_has(m->im, m->db, "participant_data", "CASEID", &v5, err);
    }
    if (code == CR_ERR_OK && !v5) {
        code = cr_sql_has(m->im, m->db, "participant_data", "FALL", &old, err);
    }
    m->old = old;
    cr_import_format(m->im, m->old ? "PCM v4" : "PCM v5");
    for (int i = 0; i < COLUMNS && code == CR_ERR_OK; i++) {
        const char *name = columns[i].name[m->old];
        there = false;
        if (name != NULL) {
            code = cr_sql_has(m->im, m->db, columns[i].table, name, &there, err);
        }
        m->of[i] = there ? name : "NULL";
        if (code == CR_ERR_OK && columns[i].needed && !there) {
            code = missing(m, i, err);
        } else if (code == CR_ERR_OK && name != NULL && !there) {
            code = find_slip(m, i, err);
        }
    }
    return code;
}

/* Opens the streams of participants and of rows. Both go through the cases in one order, numbered,
 * so that each table is sorted once. */
static enum cr_err open_streams(struct pcm *m, struct cr_error *err) {
    struct cr_str parts = {0}, rows = {0};
    const char *id = m->of[CASE];
    bool shape = false;
    enum cr_err code =
        m->old ? CR_ERR_OK : cr_sql_has(m->im, m->db, "participant_shape", "X", &shape, err);
    static const char numbers[] =
        " FROM (SELECT k, row_number() OVER (ORDER BY k) AS n FROM (SELECT %s AS k FROM "
        "participant_data UNION SELECT %s FROM dynamics) WHERE k IS NOT NULL) AS c";
    cr_str_add(&parts, "SELECT c.n");
    cr_str_add(&parts, ", c.k");
    for (int i = CASE + 1; i < D_CASE; i++) {
        cr_str_addf(&parts, ", %s%s", strcmp(m->of[i], "NULL") != 0 ? "p." : "", m->of[i]);
    }
    cr_str_add(&parts, shape ? ", s.x" : ", NULL");
    cr_str_addf(&parts, numbers, id, m->of[D_CASE]);
    cr_str_addf(&parts, " LEFT JOIN participant_data AS p ON p.%s = c.k", id);
    if (shape) {
        cr_str_add(&parts, " LEFT JOIN (SELECT CASEID AS k, PARTID AS b, max(X) AS x FROM "
                           "participant_shape GROUP BY 1, 2) AS s ON s.k = c.k AND s.b = p.PARTID");
    }
    cr_str_addf(&parts, " ORDER BY c.n, p.%s", m->of[PART]);
    cr_str_add(&rows, "SELECT c.n");
    for (int i = D_CASE; i < COLUMNS; i++) {
        cr_str_addf(&rows, ", %s%s", strcmp(m->of[i], "NULL") != 0 ? "d." : "", m->of[i]);
    }
    cr_str_addf(&rows, numbers, id, m->of[D_CASE]);
    cr_str_addf(&rows, " JOIN dynamics AS d ON d.%s = c.k ORDER BY c.n, d.%s, d.%s", m->of[D_CASE],
                m->of[T], m->of[D_PART]);
    code = code == CR_ERR_OK ? cr_sql_prepare(m->im, m->db, &parts, &m->parts, err) : code;
    code = code == CR_ERR_OK ? cr_sql_prepare(m->im, m->db, &rows, &m->rows, err) : code;
    cr_str_fini(&parts);
    cr_str_fini(&rows);
    return code;
}

/* ---- a case ---- */

static double number(sqlite3_stmt *row, int column) {
    double x;
    if (sqlite3_column_type(row, column) == SQLITE_NULL) {
        return (double)NAN;
    }
    if (sqlite3_column_type(row, column) != SQLITE_TEXT) {
        return sqlite3_column_double(row, column);
    }
    const char *text = (const char *)sqlite3_column_text(row, column);
    return text != NULL && cr_csv_scan(text, true, &x) ? x : (double)NAN;
}

static const char *text(sqlite3_stmt *row, int column) {
    const unsigned char *s = sqlite3_column_text(row, column);
    return s != NULL ? (const char *)s : "";
}

/* The value of a column in the stream of participants, and in that of rows. */
static double of_part(const struct pcm *m, int column) {
    return number(m->parts, 1 + column - CASE);
}
static double of_row(const struct pcm *m, int column) {
    return number(m->rows, 1 + column - D_CASE);
}

/* Checks that what is text in the columns from `first` to before `end` of a stream reads as
 * numbers. */
static enum cr_err check_numbers(const struct pcm *m, int first, int end, const char *id,
                                 struct cr_error *err) {
    sqlite3_stmt *row = first < D_CASE ? m->parts : m->rows;
    double x;
    for (int i = first; i < end; i++) {
        int at = 1 + i - (first < D_CASE ? CASE : D_CASE);
        const char *s = sqlite3_column_type(row, at) == SQLITE_TEXT ? text(row, at) : "";
        if (s[strspn(s, " ")] != '\0' && !cr_csv_scan(s, true, &x)) {
            return cr_err_set(err, CR_ERR_TYPE, "%s: %s of participant %s is no number: \"%.40s\"",
                              columns[i].table, m->of[i], id, s);
        }
    }
    return CR_ERR_OK;
}

static const char *const kinds[] = {"a car",     "a pedestrian", "a motorcycle",
                                    "a bicycle", "a truck",      "an unknown kind"};

static enum cr_err add_part(struct pcm *m, struct cr_error *err) {
    char id[40];
    struct cr_participant *p;
    double type = of_part(m, TYPE), front = number(m->parts, 1 + D_CASE - CASE);
    snprintf(id, sizeof id, "P%.30s", text(m->parts, 1 + PART - CASE));
    if (id[1] == '\0') {
        return cr_err_set(err, CR_ERR_MISSING, "participant_data has no participant of this case");
    }
    enum cr_err code = check_numbers(m, TYPE, D_CASE, id + 1, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (type != 0) {
        int kind = type >= 1 && type <= 4 ? (int)type : 5;
        cr_err_set(err, CR_ERR_MODEL, "participant %s is %s, not a car (%s %g in participant_data)",
                   id + 1, kinds[kind], m->of[TYPE], type);
        cr_err_hint(err, "there are models of cars only");
        return CR_ERR_MODEL;
    }
    code = cr_import_add(m->im, id, CR_KIND_VEHICLE, &p, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    p->length = of_part(m, LENGTH);
    p->width = of_part(m, WIDTH);
    p->height = of_part(m, HEIGHT);
    p->mass = of_part(m, MASS);
    p->cg_behind_front_axle = of_part(m, CG);
    p->cg_height = of_part(m, CG_HEIGHT);
    p->wheelbase = of_part(m, WHEELBASE);
    p->track = of_part(m, TRACK);
    p->yaw_inertia = of_part(m, INERTIA);
    front = m->old ? of_part(m, CG_FRONT) : front;
    p->front_overhang = round((front - p->cg_behind_front_axle) * 1e4) / 1e4;
    m->mue_lo = fmin(m->mue_lo, of_part(m, MUE));
    m->mue_hi = fmax(m->mue_hi, of_part(m, MUE));
    return CR_ERR_OK;
}

static enum cr_err add_row(struct pcm *m, struct cr_error *err) {
    char id[40];
    snprintf(id, sizeof id, "P%.30s", text(m->rows, 1 + D_PART - D_CASE));
    struct cr_participant *p = cr_import_find(m->im, id);
    if (p == NULL) {
        return cr_err_set(err, CR_ERR_MISSING,
                          "participant %s of dynamics is not in participant_data", id + 1);
    }
    enum cr_err code = check_numbers(m, T, COLUMNS, id + 1, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    for (int i = T; i <= VY; i++) {
        if (isnan(of_row(m, i))) {
            return cr_err_set(err, CR_ERR_MISSING,
                              "dynamics: %s of participant %s is empty at %s %s", m->of[i], id + 1,
                              m->of[T], text(m->rows, 1 + T - D_CASE));
        }
    }
    struct cr_waypoint row = {.t = of_row(m, T), .pos = cr_vec2(of_row(m, POSX), of_row(m, POSY))};
    row.heading = of_row(m, PSI);
    row.speed = hypot(of_row(m, VX), of_row(m, VY));
    m->mue_lo = fmin(m->mue_lo, of_row(m, D_MUE));
    m->mue_hi = fmax(m->mue_hi, of_row(m, D_MUE));
    return cr_import_row(m->im, p, &row, err);
}

static enum cr_err part_step(struct pcm *m, struct cr_error *err) {
    return cr_sql_step(m->im, m->db, m->parts, &m->more_parts, err);
}
static enum cr_err row_step(struct pcm *m, struct cr_error *err) {
    return cr_sql_step(m->im, m->db, m->rows, &m->more_rows, err);
}

/* Reads all of case n: its participants, then its rows. A fault of the case is kept in *sick, so
 * that the streams go on to the next. */
static enum cr_err read_case(struct pcm *m, long long n, bool wanted, struct cr_error *sick,
                             struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    m->mue_lo = INFINITY;
    m->mue_hi = -INFINITY;
    while (code == CR_ERR_OK && m->more_parts && sqlite3_column_int64(m->parts, 0) == n) {
        if (wanted && sick->code == CR_ERR_OK) {
            sick->code = add_part(m, sick);
        }
        code = part_step(m, err);
    }
    while (code == CR_ERR_OK && m->more_rows && sqlite3_column_int64(m->rows, 0) == n) {
        if (wanted && sick->code == CR_ERR_OK) {
            sick->code = add_row(m, sick);
        }
        code = row_step(m, err);
    }
    if (wanted && m->mue_lo <= m->mue_hi && sick->code == CR_ERR_OK) {
        cr_import_road_friction(m->im, m->mue_lo);
        if (m->mue_lo < m->mue_hi) {
            cr_import_note(m->im, "MUE from %g to %g: the smallest", m->mue_lo, m->mue_hi);
        }
    }
    return code;
}

static enum cr_err read_cases(struct pcm *m, struct cr_error *err) {
    enum cr_err code = part_step(m, err);
    code = code == CR_ERR_OK ? row_step(m, err) : code;
    while (code == CR_ERR_OK && m->more_parts) {
        char id[64], name[CR_NAME_MAX];
        struct cr_error sick = {0};
        long long n = sqlite3_column_int64(m->parts, 0);
        snprintf(id, sizeof id, "%.50s", text(m->parts, 1));
        snprintf(name, sizeof name, "pcm-%.50s", id);
        bool wanted = cr_import_wants(m->im, id);
        code = wanted ? cr_import_begin(m->im, id, name, err) : CR_ERR_OK;
        if (code == CR_ERR_OK && wanted && m->slip[0] != '\0') {
            cr_import_note(m->im, "%s", m->slip);
        }
        code = code == CR_ERR_OK ? read_case(m, n, wanted, &sick, err) : code;
        if (code == CR_ERR_OK && wanted) {
            code = cr_import_end(m->im, sick.code != CR_ERR_OK ? &sick : NULL, err);
        }
    }
    return code;
}

enum cr_err cr_import_pcm_read(struct cr_import *im, struct cr_error *err) {
    struct pcm m = {.im = im};
    enum cr_err code = cr_import_is_folder(im) ? cr_pcm_csv(im, &m.db, err)
                                               : cr_sql_open(im, im->path, &m.db, err);
    code = code == CR_ERR_OK ? find_columns(&m, err) : code;
    code = code == CR_ERR_OK ? open_streams(&m, err) : code;
    code = code == CR_ERR_OK ? read_cases(&m, err) : code;
    sqlite3_finalize(m.parts);
    sqlite3_finalize(m.rows);
    sqlite3_close(m.db);
    return code;
}

#else

enum cr_err cr_import_pcm_read(struct cr_import *im, struct cr_error *err) {
    cr_err_set(err, CR_ERR_USAGE, "a PCM database, which this build cannot read");
    cr_err_place(err, im->shown, 0, 0);
    cr_err_hint(err, "build it with SQLite (Debian package libsqlite3-dev)");
    return CR_ERR_USAGE;
}

#endif

bool cr_import_pcm_is(const struct cr_import_head *head) {
    static const char magic[16] = "SQLite format 3";
    return head->folder ? cr_import_lies_in(head->path, "participant_data.csv")
                        : head->len >= 16 && memcmp(head->text, magic, 16) == 0;
}
