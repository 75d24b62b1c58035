/* Declares what the framework of the import keeps of a case while its reader fills it in, and the
 * functions that its files share; readers see reader.h alone. */
#ifndef CR_IMPORT_IMPORT_PRIV_H
#define CR_IMPORT_IMPORT_PRIV_H

#include "import/reader.h"

/* Rows that may be held of one case, about 100 MB. A file in the order of time needs far fewer. */
enum { CR_IMPORT_ROWS_MAX = 2000000 };

/* A participant with the rows of its motion; p comes first, so that a reader's pointer to it leads
 * to the whole. */
struct cr_import_part {
    struct cr_participant p;
    char source_id[CR_IMPORT_ID_MAX];
    bool fixed;                 /* p is complete and `full` is made from it */
    struct cr_participant full; /* p with what the scene's rules fill in; owns nothing */
    double shift;               /* m forward from the point that the file gives to the CG */
    struct cr_waypoint *row;    /* of the CG; row[first] .. row[n - 1] are held */
    int first, n, size, at;     /* at: where the search for contact is */
    int corners;                /* of the outline */
    struct cr_vec2 corner[CR_VERTEX_MAX]; /* m, about the CG */
    double radius;                        /* m, of the circle about the CG that holds them */
    bool hit;                             /* one of those whose outlines met first */
};

/* A case while it is read. */
struct cr_import_case {
    char id[CR_IMPORT_ID_MAX], name[CR_NAME_MAX];
    enum cr_point point;
    struct cr_import_part **part;
    int parts, size;
    int moving;            /* parts with rows */
    long rows;             /* that are held */
    double now;            /* s, the latest time of a row */
    bool started, cut;     /* there is a row; rows were left behind already */
    bool unordered;        /* times went back: participants stand one after the other */
    bool met;              /* outlines overlap, */
    double t_met;          /* s, first at this time */
    bool placed;           /* an origin is chosen: */
    struct cr_vec2 origin; /* m in the file, where the scene has its 0 */
    double road_friction;  /* NaN: not known */
    struct cr_str note;
    struct cJSON *extra;
};

/* Writes a name for mkstemp and mkdtemp in $TMPDIR or /tmp. */
enum { CR_TEMP_MAX = 256 };
void cr_import_temp(char path[CR_TEMP_MAX]);

/* Where an archive was unpacked: into dir; root is what to read, dir or the one thing in it. */
struct cr_unpacked {
    char dir[CR_TEMP_MAX], root[1024];
    char **made; /* files and folders, in the order in which they came; owned */
    int n;
};
bool cr_import_is_zip(const struct cr_import_head *head);
/* Unpacks im->path. cr_import_unpacked_fini is due also after an error; it removes the files.
 * Errors: SYNTAX for what is no whole archive, is encrypted or leads out of it, RANGE for too much
 * in it, IO, MEMORY, INTERRUPTED. */
CR_MUST_CHECK enum cr_err cr_import_unpack(struct cr_import *im, struct cr_unpacked *to,
                                           struct cr_error *err);
void cr_import_unpacked_fini(struct cr_unpacked *unpacked);

/* Makes the place of an error one that the user knows, not a copy nor an unpacked file. */
void cr_import_place(const struct cr_import *im, struct cr_error *err);

void cr_import_case_free(struct cr_import_case *c);

/* Lays the members of an object over those of another, inner objects member by member. False if
 * memory is out. */
bool cr_import_lay_over(struct cJSON *to, const struct cJSON *from);

/* Completes a participant: the map's values over the reader's, sizes, outline. Errors: those of a
 * scene's participant. */
CR_MUST_CHECK enum cr_err cr_import_fix(struct cr_import *im, struct cr_import_part *part,
                                        struct cr_error *err);

/* Completes those that have no rows: the objects alone, or all. Errors: those of cr_import_fix. */
CR_MUST_CHECK enum cr_err cr_import_settle(struct cr_import *im, bool objects,
                                           struct cr_error *err);

/* Looks whether outlines overlap at a time, s, and notes it in the case. Times must not go back
 * between calls. */
void cr_import_look(struct cr_import_case *c, double t);
/* Looks at the times of all rows that are held, in their order, until outlines overlap. Errors:
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_import_search(struct cr_import_case *c, struct cr_error *err);
/* Leaves out the rows of each participant before `from` and after `to`, s, but always keeps two of
 * a participant that has as many. */
void cr_import_cut(struct cr_import_case *c, double from, double to);

/* Writes the scene of a case as one line. Errors: what the scene lacks. */
CR_MUST_CHECK enum cr_err cr_import_scene(struct cr_import *im, struct cr_str *line,
                                          struct cr_error *err);

#endif
