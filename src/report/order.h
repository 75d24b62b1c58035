/* What the command `report` hands on to the maker of reports. Commands know less of the program
 * than a report says; so whoever opens a session names the function that makes one (src/expert). */
#ifndef CR_REPORT_ORDER_H
#define CR_REPORT_ORDER_H

#include "scene/scene.h"

struct cr_report_order {
    const struct cr_scene *scene; /* as it is given */
    const char *from;             /* file that it is in, for the line that repeats the report */
    const char *path;             /* where the report goes, .html or .pdf */
    const char *author, *case_no; /* NULL: none */
    bool german, us, no_tests;    /* language, units, no crash tests for comparison */
    int draws;                    /* for the intervals; 0: none */
    int max_seconds;              /* processor time of one solve, 0: any */
    double max_bytes;             /* memory of one solve, 0: any */
    int (*progress)(void *user, int done, int draws); /* told of each draw; non-zero cancels */
    int (*cancel)(void *user);                        /* non-zero cancels */
    void *user;
};

#endif
