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
    int groups, failed, codes;
    struct {
        char word[32];
        int n;
    } code[CR_STUDY_CODES];
};

/* Finite values of a column (fields, then axes) in a group (-1: all) into out; how many. */
int cr_study_column(const struct cr_study *study, int column, int group, double *out);

#endif
