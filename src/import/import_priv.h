/* What the framework of the import keeps of a case while its reader fills it in. */
#ifndef CR_IMPORT_IMPORT_PRIV_H
#define CR_IMPORT_IMPORT_PRIV_H

#include "import/reader.h"

/* Rows that are held of one case: 100 MB. A file in the order of time needs far fewer. */
enum { CR_IMPORT_ROWS_MAX = 2000000, CR_IMPORT_ID_MAX = 128 };

/* A participant with the rows of its motion; p comes first, so that a reader's pointer to it leads
 * to the whole. */
struct cr_import_part {
    struct cr_participant p;
    char source_id[CR_IMPORT_ID_MAX];
    bool fixed;                 /* p is complete and `full` is made from it */
    struct cr_participant full; /* p with what the scene's rules fill in; owns nothing */
    double shift;               /* m from the reference point forward to the CG */
    struct cr_waypoint *row;    /* of the CG; row[first] .. row[n - 1] are held */
    int first, n, size, at;     /* at: where the search for contact is */
    int corners;                /* outline about the CG */
    struct cr_vec2 corner[CR_VERTEX_MAX];
    double radius; /* of the circle about the CG that holds it */
    bool hit;      /* one of those whose outlines met first */
};

struct cr_import_case {
    char id[CR_IMPORT_ID_MAX], name[CR_NAME_MAX];
    enum cr_point point;
    struct cr_import_part **part;
    int parts, size;
    int moving; /* parts with rows */
    long rows;  /* that are held */
    double now;
    bool started, cut; /* there is a row; rows were left behind already */
    bool unordered;    /* times went back: participants one after the other */
    bool met;
    double t_met;
    bool placed; /* an origin is chosen */
    struct cr_vec2 origin;
    double road_friction; /* NaN: not known */
    struct cr_str note;
    struct cJSON *extra;
};

/* A name for mkstemp and mkdtemp in $TMPDIR or /tmp. */
enum { CR_TEMP_MAX = 256 };
void cr_import_temp(char path[CR_TEMP_MAX]);

/* What an archive was unpacked into, and what it is about: the folder, or the one thing in it. */
struct cr_unpacked {
    char dir[CR_TEMP_MAX], root[1024];
    char **made; /* files and folders, in the order they came; owned */
    int n;
};
bool cr_import_is_zip(const struct cr_import_head *head);
/* Unpack im->path; to be given back in any case, which takes the files away. Errors: SYNTAX for
 * what is no whole archive, is encrypted or leads out of it, RANGE for too much in it, IO, MEMORY,
 * INTERRUPTED. */
CR_MUST_CHECK enum cr_err cr_import_unpack(struct cr_import *im, struct cr_unpacked *to,
                                           struct cr_error *err);
void cr_import_unpacked_fini(struct cr_unpacked *unpacked);

/* The place of an error as the user knows it: not that of a copy or of what was unpacked. */
void cr_import_place(const struct cr_import *im, struct cr_error *err);

/* One of the files of cr_import_files. */
CR_MUST_CHECK enum cr_err cr_import_file(struct cr_import_opts *opts, const char *path,
                                         struct cr_import_count *count, struct cr_error *err);

void cr_import_case_free(struct cr_import_case *c);

/* Members of an object over those of another, inner objects member by member. False without memory.
 */
bool cr_import_lay_over(struct cJSON *to, const struct cJSON *from);

/* Complete a participant: the map's values over the reader's, sizes, outline. Errors: those of a
 * scene's participant. */
CR_MUST_CHECK enum cr_err cr_import_fix(struct cr_import *im, struct cr_import_part *part,
                                        struct cr_error *err);

/* Complete those that have no rows: the objects alone, or all. Errors: the same. */
CR_MUST_CHECK enum cr_err cr_import_settle(struct cr_import *im, bool objects,
                                           struct cr_error *err);

/* Pose of a participant at a time, s; false where it is not there then. Times must not go back
 * between calls. */
bool cr_import_pose(struct cr_import_part *part, double t, struct cr_waypoint *out);
/* Look whether outlines overlap at that time. */
void cr_import_look(struct cr_import_case *c, double t);
/* Look through all rows that are held, in the order of time. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_import_search(struct cr_import_case *c, struct cr_error *err);
/* Leave out the rows of each participant before the time, but those needed to be there at it. */
void cr_import_cut(struct cr_import_case *c, double from, double to);

/* The scene of a case as one line. Errors: what the scene lacks. */
CR_MUST_CHECK enum cr_err cr_import_scene(struct cr_import *im, struct cr_str *line,
                                          struct cr_error *err);

#endif
