/* The output file of a long run: written as FILE.part, which becomes FILE when it is whole. */
#ifndef CR_CLI_PART_H
#define CR_CLI_PART_H

#include "base/err.h"
#include "base/str.h"
#include "cli/options.h"

#include <stdio.h>

enum { CR_PART_OLDS_MAX = 100 };

struct cr_part {
    FILE *file;
    struct cr_str target, name;        /* FILE with links followed, and what is written to */
    bool in_place;                     /* a pipe or device: written as it is */
    bool made, aside;                  /* FILE.part is ours; one that was there was set aside */
    int olds;                          /* FILE.part.1 ...: unfinished attempts before this one */
    char *taken[CR_PART_OLDS_MAX + 1]; /* their names in the list of files to resume */
    int takes;
};

/* Where an unfinished FILE would lie: in FILE.part and those that were set aside. Adds those that
 * there are to the list of files to resume. Errors: USAGE, MEMORY. */
CR_MUST_CHECK enum cr_err cr_part_find(struct cr_part *part, const char *path,
                                       struct cr_option_values *resume, struct cr_error *err);

/* Open FILE.part for writing; an unfinished one is set aside before. Errors: IO. */
CR_MUST_CHECK enum cr_err cr_part_open(struct cr_part *part, struct cr_error *err);
/* All is written: FILE.part becomes FILE, those set aside go. Errors: IO. */
CR_MUST_CHECK enum cr_err cr_part_finish(struct cr_part *part, struct cr_error *err);
/* For an output that nothing takes up again: after an error FILE.part goes, and one that was there
 * before has its name back. */
void cr_part_drop(struct cr_part *part);
/* Close what is open; unless finished, FILE.part stays for --resume. */
void cr_part_fini(struct cr_part *part);

#endif
