/* A report that is asked for at the prompt. Commands know less of the program than a report says:
 * who opens a session names who makes it (src/expert). */
#ifndef CR_REPORT_ORDER_H
#define CR_REPORT_ORDER_H

#include "scene/scene.h"

struct cr_report_order {
    const struct cr_scene *scene; /* as it is given */
    const char *from;             /* file that it is in, for the line that repeats the report */
    const char *path;             /* of the report, .html or .pdf */
    const char *author, *case_no; /* NULL: none */
    bool german, us, no_tests;    /* language, units, without crash tests beside it */
    int draws;                    /* for the intervals; 0: none */
    int max_seconds;              /* of processor time for one solve, 0: any */
    double max_bytes;             /* of memory likewise */
    int (*progress)(void *user, int done, int draws); /* of the draws; non-zero: cancelled */
    int (*cancel)(void *user);
    void *user;
};

#endif
