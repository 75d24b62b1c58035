/* What the files of a study share. */
#ifndef CR_CLI_STUDY_PRIV_H
#define CR_CLI_STUDY_PRIV_H

#include "cli/study.h"

enum { CR_STUDY_CODES = 20 };

struct cr_study {
    struct cr_study_options opt;
    char axis[3][CR_FIELD_SIZE]; /* names of x, y, z */
    int axes;                    /* 0: no plot; 2; 3: heat map */
    int rows, size;              /* solved records */
    double *value;               /* [rows * (fields + axes)] */
    int *of;                     /* [rows] group */
    char **group;                /* [groups] labels */
    int groups, group_size, failed, codes;
    struct {
        char word[32];
        int n;
    } code[CR_STUDY_CODES];
};

/* A map: means of z over values or bins of x and y. */
enum { CR_MAP_COLUMNS = 10, CR_MAP_ROWS = 16 };
struct cr_map_steps {
    int n;
    bool bins;
    double lo, width, at[CR_MAP_ROWS];
};
struct cr_map {
    struct cr_map_steps x, y;
    double mean[CR_MAP_ROWS][CR_MAP_COLUMNS];
    int n[CR_MAP_ROWS][CR_MAP_COLUMNS];
    double lo, hi;
};
/* NULL when memory is out; free() it. */
struct cr_map *cr_study_map(const struct cr_study *study);

/* Value of an axis of the plot in a row. */
double cr_study_axis(const struct cr_study *study, int row, int axis);
/* The rows as points over both axes of the plot; NULL when memory is out. free() what is returned,
 * which holds their places. */
double *cr_study_points(const struct cr_study *study, struct cr_curve_line *out);

/* Finite values of a column (fields, then axes) in a group (-1: all) into out; how many. */
int cr_study_column(const struct cr_study *study, int column, int group, double *out);

#endif
