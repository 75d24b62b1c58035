/* Reads the two logs of esmini: that of --csv_logger has a row for each time with all entities side
 * by side and their sizes, that of dat2csv a row for each time and entity without sizes. */
#include "import/reader.h"

#include "base/csv.h"
#include "base/grow.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char log_header[] = "Index [-]";
/* The shortest car, m: what is shorter walks or has one track, and is left out. */
static const double shortest = 2.0;

/* Finds the first line of a text that begins so; NULL if there is none. */
static const char *line_with(const char *text, const char *begin) {
    while (text != NULL && strncmp(text, begin, strlen(begin)) != 0) {
        text = strchr(text, '\n');
        text = text != NULL ? text + 1 : NULL;
    }
    return text;
}

bool cr_import_esmini_is(const struct cr_import_head *head) {
    const char *dat = line_with(head->text, "time, id, name,");
    return !head->folder && (line_with(head->text, log_header) != NULL ||
                             (dat != NULL && strstr(dat, "wheel_rot") != NULL));
}

/* ---- dat2csv ---- */

enum dat { DAT_TIME, DAT_NAME, DAT_X, DAT_Y, DAT_H, DAT_SPEED, DATS };

static enum cr_err dat_row(struct cr_import *im, const struct cr_csv *csv, const int at[DATS],
                           struct cr_error *err) {
    struct cr_waypoint row = {0};
    double *const out[DATS] = {[DAT_TIME] = &row.t,
                               [DAT_X] = &row.pos.x,
                               [DAT_Y] = &row.pos.y,
                               [DAT_H] = &row.heading,
                               [DAT_SPEED] = &row.speed};
    const char *name = cr_csv_cell(csv, at[DAT_NAME]);
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < DATS && code == CR_ERR_OK; i++) {
        code = out[i] != NULL ? cr_csv_number(csv, at[i], out[i], err) : CR_ERR_OK;
        if (code == CR_ERR_OK && out[i] != NULL && isnan(*out[i])) {
            code = cr_csv_fault(csv, at[i], err, CR_ERR_MISSING, "no %s", cr_csv_name(csv, at[i]));
        }
    }
    if (code == CR_ERR_OK && name[0] == '\0') {
        code = cr_csv_fault(csv, at[DAT_NAME], err, CR_ERR_MISSING, "no name");
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_participant *p = cr_import_find(im, name);
    if (p == NULL) {
        code = cr_import_add(im, name, CR_KIND_VEHICLE, &p, err);
        if (code != CR_ERR_OK) {
            cr_err_place(err, im->shown, cr_csv_line(csv), 0);
            return code;
        }
    }
    code = cr_import_row(im, p, &row, err);
    if (code != CR_ERR_OK) {
        cr_err_place(err, im->shown, cr_csv_line(csv), 0);
    }
    return code;
}

static enum cr_err read_dat(struct cr_import *im, struct cr_csv *csv, struct cr_error *err) {
    static const char *const names[DATS] = {"time", "name", "x", "y", "h", "speed"};
    int at[DATS];
    bool row = true;
    enum cr_err code = CR_ERR_OK;
    cr_import_point(im, CR_POINT_REAR_AXLE);
    for (int i = 0; i < DATS && code == CR_ERR_OK; i++) {
        code = cr_csv_need(csv, names[i], &at[i], err);
    }
    while (code == CR_ERR_OK && !cr_import_met(im)) {
        code = cr_csv_next(csv, &row, err);
        if (code != CR_ERR_OK || !row) {
            break;
        }
        code = dat_row(im, csv, at, err);
    }
    return code;
}

/* ---- csv_logger ---- */

enum log_column {
    LOG_NAME,
    LOG_SPEED,
    LOG_BOX_X,
    LOG_BOX_Y,
    LOG_LENGTH,
    LOG_WIDTH,
    LOG_HEIGHT,
    LOG_X,
    LOG_Y,
    LOG_HEADING,
    LOG_COLUMNS
};
static const char *const log_names[LOG_COLUMNS] = {"Entity_Name [-]",
                                                   "Current_Speed [m/s]",
                                                   "bb_x [m]",
                                                   "bb_y [m]",
                                                   "bb_length [m]",
                                                   "bb_width [m]",
                                                   "bb_height [m]",
                                                   "World_Position_X [m]",
                                                   "World_Position_Y [m]",
                                                   "World_Heading_Angle [rad]"};

struct entity {
    int number, at[LOG_COLUMNS];
    bool known, left_out;
    struct cr_participant *p;
};

struct logged {
    struct entity *entity;
    int n, size;
};

/* Finds the group of columns of each entity, "#1 ...", "#2 ...". */
static enum cr_err find_entities(const struct cr_csv *csv, struct logged *log,
                                 struct cr_error *err) {
    char name[80];
    for (int k = 1;; k++) {
        struct entity e = {.number = k};
        snprintf(name, sizeof name, "#%d World_Position_X [m]", k);
        if (cr_csv_find(csv, name) < 0 && k > 1) {
            return CR_ERR_OK;
        }
        for (int i = 0; i < LOG_COLUMNS; i++) {
            snprintf(name, sizeof name, "#%d %s", k, log_names[i]);
            e.at[i] = cr_csv_find(csv, name);
            if (e.at[i] < 0 && i == LOG_NAME) { /* Older versions spell it otherwise. */
                snprintf(name, sizeof name, "#%d Entitity_Name [-]", k);
                e.at[i] = cr_csv_find(csv, name);
            }
            if (e.at[i] < 0) {
                snprintf(name, sizeof name, "#%d %s", k, log_names[i]);
                return cr_csv_need(csv, name, &e.at[i], err);
            }
        }
        if (!cr_grow(&log->entity, &log->size, log->n, sizeof *log->entity)) {
            return cr_err_set(err, CR_ERR_MEMORY, "no memory for an entity");
        }
        log->entity[log->n++] = e;
    }
}

static enum cr_err values(const struct cr_csv *csv, const struct entity *e, double v[LOG_COLUMNS],
                          struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = LOG_NAME + 1; i < LOG_COLUMNS && code == CR_ERR_OK; i++) {
        code = cr_csv_number(csv, e->at[i], &v[i], err);
        if (code == CR_ERR_OK && isnan(v[i])) {
            code = cr_csv_fault(csv, e->at[i], err, CR_ERR_MISSING, "no %s",
                                cr_csv_name(csv, e->at[i]));
        }
    }
    return code;
}

static enum cr_err meet(struct cr_import *im, struct entity *e, const char *name,
                        const double v[LOG_COLUMNS], struct cr_error *err) {
    e->known = true;
    if (v[LOG_LENGTH] < shortest) {
        e->left_out = true;
        cr_import_note(im, "%.40s left out: %.3g m long", name, v[LOG_LENGTH]);
        return CR_ERR_OK;
    }
    enum cr_err code = cr_import_add(im, name, CR_KIND_VEHICLE, &e->p, err);
    if (code == CR_ERR_OK) {
        e->p->length = v[LOG_LENGTH];
        e->p->width = v[LOG_WIDTH];
        e->p->height = v[LOG_HEIGHT];
    }
    return code;
}

/* Gives a row at the middle of the entity's box. The log has the place of the rear axle, and where
 * that lies in the car follows only from the box. */
static enum cr_err log_row(struct cr_import *im, const struct cr_csv *csv, struct entity *e,
                           double t, struct cr_error *err) {
    double v[LOG_COLUMNS];
    const char *name = cr_csv_cell(csv, e->at[LOG_NAME]);
    if (name[0] == '\0' || e->left_out) {
        return CR_ERR_OK; /* The entity is not there any more. */
    }
    enum cr_err code = values(csv, e, v, err);
    if (code == CR_ERR_OK && !e->known) {
        code = meet(im, e, name, v, err);
    }
    if (code != CR_ERR_OK || e->left_out) {
        return code;
    }
    double c = cos(v[LOG_HEADING]), s = sin(v[LOG_HEADING]);
    struct cr_vec2 box = cr_vec2_rotate(cr_vec2(v[LOG_BOX_X], v[LOG_BOX_Y]), c, s);
    const struct cr_waypoint row = {.t = t,
                                    .pos = cr_vec2_add(cr_vec2(v[LOG_X], v[LOG_Y]), box),
                                    .heading = v[LOG_HEADING],
                                    .speed = v[LOG_SPEED]};
    code = cr_import_row(im, e->p, &row, err);
    if (code != CR_ERR_OK) {
        cr_err_place(err, im->shown, cr_csv_line(csv), 0);
    }
    return code;
}

static enum cr_err log_rows(struct cr_import *im, struct cr_csv *csv, struct logged *log,
                            struct cr_error *err) {
    int time;
    bool row = true;
    double t = 0;
    enum cr_err code = cr_csv_need(csv, "TimeStamp [s]", &time, err);
    code = code == CR_ERR_OK ? find_entities(csv, log, err) : code;
    while (code == CR_ERR_OK && !cr_import_met(im)) {
        code = cr_csv_next(csv, &row, err);
        if (code != CR_ERR_OK || !row) {
            break;
        }
        code = cr_csv_number(csv, time, &t, err);
        if (code == CR_ERR_OK && isnan(t)) {
            code = cr_csv_fault(csv, time, err, CR_ERR_MISSING, "no time");
        }
        for (int i = 0; i < log->n && code == CR_ERR_OK; i++) {
            code = log_row(im, csv, &log->entity[i], t, err);
        }
    }
    return code;
}

static enum cr_err read_log(struct cr_import *im, struct cr_csv *csv, struct cr_error *err) {
    struct logged log = {0};
    cr_import_point(im, CR_POINT_CENTRE);
    enum cr_err code = log_rows(im, csv, &log, err);
    free(log.entity);
    return code;
}

enum cr_err cr_import_esmini_read(struct cr_import *im, struct cr_error *err) {
    struct cr_csv_opts opts = {.path = im->path, .header = log_header};
    struct cr_csv *csv = NULL;
    struct cr_error why;
    bool log = true;
    enum cr_err code = cr_csv_open(&opts, &csv, err);
    if (code == CR_ERR_SYNTAX || code == CR_ERR_MISSING) {
        log = false;
        opts.header = "time,";
        code = cr_csv_open(&opts, &csv, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_import_format(im, log ? "esmini csv_logger" : "esmini dat2csv");
    code = cr_import_begin(im, "", "esmini", err);
    if (code == CR_ERR_OK) {
        enum cr_err fault = log ? read_log(im, csv, &why) : read_dat(im, csv, &why);
        code = cr_import_end(im, fault != CR_ERR_OK ? &why : NULL, err);
    }
    cr_csv_close(csv);
    return code;
}
