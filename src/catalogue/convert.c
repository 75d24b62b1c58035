/* Turns the table of a register of vehicles into a table of the catalogue: rows of equal make,
 * model and size become one, with the years and the masses that they have. */
#define _XOPEN_SOURCE 700 /* tsearch */
#include "config.h"

#include "catalogue/catalogue_priv.h"

#include "base/csv.h"
#include "base/grow.h"
#include "base/show.h"

#include <ctype.h>
#include <math.h>
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { LENGTH, WIDTH, HEIGHT, WHEELBASE, TRACK, SIZES };
enum { MAKE = SIZES, MODEL, YEAR, KERB, RUNNING, REAR_TRACK, WEIGHT, COLUMNS };
enum { ROWS_MAX = 1000000 };

/* What a register calls its columns: the letters and digits of the names in lower case, without a
 * unit in brackets. */
static const struct form {
    const char *word, *source;
    double unit;   /* of the sizes, m */
    double beside; /* what the mass in running order has more than the kerb mass, kg */
    int least;     /* vehicles that make a row: single ones may be slips of the pen */
    const char *column[COLUMNS];
} forms[] = {
    /* Canadian Vehicle Specifications: cm, kg; WD is "60/40" [CVS-COLUMNS] */
    {"cvs",
     "CVS",
     0.01,
     0,
     1,
     {[MAKE] = "make",
      [MODEL] = "model",
      [YEAR] = "myr",
      [KERB] = "cw",
      [LENGTH] = "ol",
      [WIDTH] = "ow",
      [HEIGHT] = "oh",
      [WHEELBASE] = "wb",
      [TRACK] = "twf",
      [REAR_TRACK] = "twr",
      [WEIGHT] = "wd"}},
    /* Netherlands Vehicle Authority: cm, kg; 100 kg are of driver and fluids [RDW-COLUMNS] */
    {"rdw",
     "RDW",
     0.01,
     100,
     3,
     {[MAKE] = "merk",
      [MODEL] = "handelsbenaming",
      [YEAR] = "datumeerstetoelating",
      [KERB] = "massaledigvoertuig",
      [RUNNING] = "massarijklaar",
      [LENGTH] = "lengte",
      [WIDTH] = "breedte",
      [HEIGHT] = "hoogtevoertuig",
      [WHEELBASE] = "wielbasis"}},
    /* European Environment Agency, monitoring of CO2: mm, kg; 75 kg are the driver [EEA-COLUMNS] */
    {"eea",
     "EEA",
     0.001,
     75,
     3,
     {[MAKE] = "mk",
      [MODEL] = "cn",
      [YEAR] = "year",
      [RUNNING] = "m",
      [WHEELBASE] = "w",
      [TRACK] = "at1",
      [REAR_TRACK] = "at2"}},
};
enum { FORMS = sizeof forms / sizeof forms[0] };

/* Vehicles of one make, model and size. */
struct group {
    char *make, *model;
    int size[SIZES];         /* mm; 0: not known */
    int share;               /* of 1000 parts of the weight those on the rear axle; 0: not known */
    int from, to;            /* model years; 0: not known */
    long n, weighed;         /* vehicles, and those of them with a mass */
    double sum, least, most; /* kerb masses, kg */
};

struct work {
    const struct form *form;
    struct cr_csv *csv;
    int at[COLUMNS]; /* index of the column in the table; -1: none */
    void *tree;      /* the groups by tsearch */
    struct group **group;
    int n, room;
};

static int order(const void *a, const void *b) {
    const struct group *x = a, *y = b;
    int by = strcasecmp(x->make, y->make);
    by = by != 0 ? by : strcasecmp(x->model, y->model);
    for (int i = SIZES - 1; i >= 0 && by == 0; i--) {
        by = (x->size[i] > y->size[i]) - (x->size[i] < y->size[i]);
    }
    return by != 0 ? by : (x->share > y->share) - (x->share < y->share);
}

/* The order of rows in the table that is written. */
static int order_years(const void *a, const void *b) {
    const struct group *x = *(struct group *const *)a, *y = *(struct group *const *)b;
    int by = strcasecmp(x->make, y->make);
    by = by != 0 ? by : strcasecmp(x->model, y->model);
    by = by != 0 ? by : (x->from > y->from) - (x->from < y->from);
    return by != 0 ? by : order(x, y);
}

/* ---- the header ---- */

static bool same_name(const char *header, const char *name) {
    for (; *header != '\0' && *header != '(' && *header != '['; header++) {
        if (isalnum((unsigned char)*header) && tolower((unsigned char)*header) != *name++) {
            return false;
        }
    }
    return *name == '\0';
}

static enum cr_err find_columns(struct work *w, struct cr_error *err) {
    for (int k = 0; k < COLUMNS; k++) {
        w->at[k] = -1;
        for (int i = 0; w->form->column[k] != NULL && i < cr_csv_columns(w->csv); i++) {
            if (same_name(cr_csv_name(w->csv, i), w->form->column[k])) {
                w->at[k] = i;
                break;
            }
        }
    }
    for (int k = MAKE; k <= RUNNING; k++) {
        bool either = (k == KERB || k == RUNNING) && (w->at[KERB] >= 0 || w->at[RUNNING] >= 0);
        if (w->at[k] < 0 && !either) {
            const char *name = w->form->column[k];
            cr_csv_head_fault(w->csv, -1, err, CR_ERR_MISSING, "no column %s, as tables of %s have",
                              name != NULL ? name : w->form->column[RUNNING], w->form->source);
            cr_err_hint(err, "--format is one of %s", CR_CATALOGUE_FORMS);
            return CR_ERR_MISSING;
        }
    }
    return CR_ERR_OK;
}

/* ---- rows ---- */

/* A size in mm, 0 where there is none or one that no car can have. */
static enum cr_err size(const struct work *w, int k, int *out, struct cr_error *err) {
    static const char *const names[] = {
        [LENGTH] = "length_m", [WIDTH] = "width_m",         [HEIGHT] = "height_m",
        [TRACK] = "track_m",   [WHEELBASE] = "wheelbase_m", [REAR_TRACK] = "track_m"};
    double x = NAN;
    enum cr_err code = w->at[k] >= 0 ? cr_csv_number(w->csv, w->at[k], &x, err) : CR_ERR_OK;
    x *= w->form->unit;
    *out = cr_car_in_range(names[k], x) ? (int)lround(1000 * x) : 0;
    return code;
}

static enum cr_err kerb_mass(const struct work *w, double *out, struct cr_error *err) {
    double running = NAN;
    enum cr_err code = CR_ERR_OK;
    *out = NAN;
    if (w->at[KERB] >= 0) {
        code = cr_csv_number(w->csv, w->at[KERB], out, err);
    }
    if (code == CR_ERR_OK && !cr_car_in_range("curb_kg", *out) && w->at[RUNNING] >= 0) {
        code = cr_csv_number(w->csv, w->at[RUNNING], &running, err);
        *out = running - w->form->beside;
    }
    *out = cr_car_in_range("curb_kg", *out) ? *out : (double)NAN;
    return code;
}

/* The year of "2015", "20150314", "2015-03-14"; 0: none. */
static int year_of(const char *text) {
    char four[5];
    snprintf(four, sizeof four, "%s", text);
    int year = strspn(four, "0123456789") == 4 ? (int)strtol(four, NULL, 10) : 0;
    return year >= 1900 && year < 2100 ? year : 0;
}

/* Of "60/40" the share on the rear axle in parts of 1000: 400; 0: none. */
static int rear_share(const char *text) {
    const char *end;
    double front = cr_number_scan(text, &end);
    double rear = *end == '/' ? cr_number_scan(end + 1, &end) : (double)NAN;
    double share = rear / (front + rear);
    return share > 0.2 && share < 0.8 ? (int)lround(1000 * share) : 0;
}

static void add_to(struct group *g, int year, double kerb) {
    g->n++;
    if (year > 0) {
        g->from = g->from == 0 || year < g->from ? year : g->from;
        g->to = year > g->to ? year : g->to;
    }
    if (!isnan(kerb)) {
        g->least = g->weighed == 0 ? kerb : fmin(g->least, kerb);
        g->most = fmax(g->most, kerb);
        g->sum += kerb;
        g->weighed++;
    }
}

static void forget(struct group *g) {
    if (g != NULL) {
        free(g->make);
        free(g->model);
        free(g);
    }
}

/* Finds the group of a row, or makes it. */
static enum cr_err group_of(struct work *w, const struct group *key, struct group **out,
                            struct cr_error *err) {
    struct group *const *found = tfind(key, &w->tree, order);
    if (found != NULL) {
        *out = *found;
        return CR_ERR_OK;
    }
    if (w->n == ROWS_MAX) {
        return cr_csv_fault(w->csv, -1, err, CR_ERR_EXPENSIVE, "more than %d different cars",
                            ROWS_MAX);
    }
    struct group *g = malloc(sizeof *g);
    if (g != NULL) {
        *g = *key;
        g->make = strdup(key->make);
        g->model = strdup(key->model);
    }
    if (g == NULL || g->make == NULL || g->model == NULL ||
        !cr_grow(&w->group, &w->room, w->n, sizeof *w->group) ||
        tsearch(g, &w->tree, order) == NULL) {
        forget(g);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a table of cars");
    }
    w->group[w->n++] = *out = g;
    return CR_ERR_OK;
}

static enum cr_err take_row(struct work *w, struct cr_error *err) {
    char make[64], model[64];
    struct group key = {.make = make, .model = model}, *g = NULL;
    double kerb = NAN;
    int rear = 0;
    enum cr_err code = CR_ERR_OK;
    cr_show(cr_csv_cell(w->csv, w->at[MAKE]), make, sizeof make);
    cr_show(cr_csv_cell(w->csv, w->at[MODEL]), model, sizeof model);
    for (int k = 0; k < SIZES && code == CR_ERR_OK; k++) {
        code = size(w, k, &key.size[k], err);
    }
    code = code == CR_ERR_OK ? size(w, REAR_TRACK, &rear, err) : code;
    code = code == CR_ERR_OK ? kerb_mass(w, &kerb, err) : code;
    if (code != CR_ERR_OK || make[0] == '\0' || model[0] == '\0') {
        return code;
    }
    if (key.size[TRACK] > 0 && rear > 0) {
        key.size[TRACK] = (key.size[TRACK] + rear + 1) / 2;
    }
    key.share = rear_share(cr_csv_cell(w->csv, w->at[WEIGHT]));
    code = group_of(w, &key, &g, err);
    if (code == CR_ERR_OK) {
        add_to(g, year_of(cr_csv_cell(w->csv, w->at[YEAR])), kerb);
    }
    return code;
}

/* ---- the table ---- */

static void add_size(struct cr_str *out, int mm) {
    cr_str_add(out, ",");
    if (mm > 0) {
        cr_str_addf(out, "%.3f", mm / 1000.0);
    }
}

static void add_group(const struct work *w, const struct group *g, struct cr_str *out) {
    cr_str_csv(out, g->make);
    cr_str_add(out, ",");
    cr_str_csv(out, g->model);
    cr_str_addf(out, g->from > 0 ? ",%d,%d" : ",,", g->from, g->to);
    cr_str_addf(out, ",%.0f,%.0f,%.0f", g->sum / (double)g->weighed, g->least, g->most);
    for (int k = 0; k < SIZES; k++) {
        add_size(out, g->size[k]);
    }
    add_size(out, g->share * g->size[WHEELBASE] / 1000);
    cr_str_addf(out, ",%s n %ld\n", w->form->source, g->n);
}

static enum cr_err write_table(struct work *w, struct cr_str *out, int *cars,
                               struct cr_error *err) {
    cr_str_addf(out,
                "# Cars by name, made by %s of a table of %s; mass: mean, least and greatest.\n"
                "make,model,from,to,curb_kg,min_kg,max_kg,length_m,width_m,height_m,wheelbase_m,"
                "track_m,cg_behind_front_axle_m,source\n",
                PACKAGE_STRING, w->form->source);
    if (w->n > 0) {
        qsort(w->group, (size_t)w->n, sizeof *w->group, order_years);
    }
    for (int i = 0; i < w->n; i++) {
        if (w->group[i]->n >= w->form->least && w->group[i]->weighed > 0) {
            add_group(w, w->group[i], out);
            ++*cars;
        }
    }
    return out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for a table of cars")
                       : CR_ERR_OK;
}

enum cr_err cr_catalogue_convert(const char *path, int form, struct cr_str *out, int *cars,
                                 struct cr_error *err) {
    struct work w = {.form = &forms[form]};
    const struct cr_csv_opts opts = {.path = path};
    bool row = true;
    *cars = 0;
    enum cr_err code = cr_csv_open(&opts, &w.csv, err);
    code = code == CR_ERR_OK ? find_columns(&w, err) : code;
    while (code == CR_ERR_OK && row) {
        code = cr_csv_next(w.csv, &row, err);
        code = code == CR_ERR_OK && row ? take_row(&w, err) : code;
    }
    code = code == CR_ERR_OK ? write_table(&w, out, cars, err) : code;
    if (code == CR_ERR_OK && *cars == 0) {
        code = cr_err_set(err, CR_ERR_MISSING, "no car with make, model and mass%s",
                          w.form->least > 1 ? ", of which there are three or more" : "");
        cr_err_place(err, path, 0, 0);
    }
    cr_csv_close(w.csv);
    for (int i = 0; i < w.n; i++) {
        tdelete(w.group[i], &w.tree, order);
        forget(w.group[i]);
    }
    free(w.group);
    return code;
}
