/* Declares how the readers of the formats work: they fill in cases, all values in SI, and the
 * framework makes scenes of them.
 *
 * A format is added in four steps:
 * 1. A file src/import/NAME.c with two functions:
 *    bool cr_import_NAME_is(const struct cr_import_head *head): whether a file is of the format, by
 *    its first bytes (or what lies in a folder), never by its suffix alone;
 *    enum cr_err cr_import_NAME_read(struct cr_import *im, struct cr_error *err): reads im->path.
 * 2. A row X(NAME) in CR_FORMAT_LIST below, ahead of those that would take it too (csv is last).
 * 3. Its file in src/import/local.mk; a library it needs behind a switch of configure.ac. Without
 *    the library the reader still recognises the format and says what was left out of the build.
 *    (An archive is unpacked before, zip.c: a reader sees a folder.)
 * 4. A sample in tests/data/import/ with the lines that come out of it (tests/cli/import.sh), a
 *    fuzz corpus tests/fuzz/corpus/import/NAME*, a paragraph in man/crumple-import.1.
 *
 * A reader goes through the cases of its file like this:
 *
 *     if (cr_import_wants(im, id)) {
 *         code = cr_import_begin(im, id, "pcm-17", err);     (fatal errors only: return them)
 *         fault_code = read_case(im, &fault);                (what is wrong with this case)
 *         code = cr_import_end(im, fault_code != CR_ERR_OK ? &fault : NULL, err);
 *     }
 *
 * Within a case: cr_import_add for every participant, whose fields it fills in as far as the file
 * knows them (NaN, CR_TYPES and "" are "not known"; never guess: the scene's own rules do that and
 * say so); then cr_import_row for every row of its motion, in the order of time. Rows of several
 * participants may alternate, and should where the file is long: only the last seconds before the
 * first contact are held. A participant without rows stands or moves as its pos, heading, course
 * and speed say. A map's "vehicles" wins over what the reader fills in.
 *
 * Errors name the place in the file: cr_err_place with the line, and the element, table, row or
 * channel in the text; the hint is the way out. */
#ifndef CR_IMPORT_READER_H
#define CR_IMPORT_READER_H

#include "base/hash.h"
#include "import/import.h"
#include "scene/scene.h"

#include <stddef.h>

struct cJSON;

/* The formats, in the order in which they are asked: X(name), where name is the word of --format
 * and part of the names of the reader's functions. */
#define CR_FORMAT_LIST(X)                                                                          \
    X(pcm)                                                                                         \
    X(xosc)                                                                                        \
    X(sumo)                                                                                        \
    X(commonroad)                                                                                  \
    X(esmini)                                                                                      \
    X(erg)                                                                                         \
    X(ev5)                                                                                         \
    X(mme)                                                                                         \
    X(edr)                                                                                         \
    X(csv)

/* The beginning of a file, by which its format is recognised. */
struct cr_import_head {
    const char *path, *name; /* the whole path; its last part */
    bool folder;
    const char *text; /* first bytes, terminated, "" of a folder; may hold zeros */
    size_t len;
};
enum {
    CR_IMPORT_HEAD = 65536,
    CR_IMPORT_PARTS_MAX = 10000,
    CR_IMPORT_ID_MAX = 128, /* bytes of the id of a participant or case with its end */
    CR_INSIDE_MAX = 1300
};

struct cr_import {
    struct cr_import_opts *opts;
    const char *path;          /* what to open */
    const char *shown;         /* what to call it in errors */
    const struct cJSON *map;   /* the user's map, NULL without one */
    struct cr_import_case *at; /* the case that has begun, NULL between cases */
    /* the rest is the framework's */
    const struct cr_unpacked *unpacked; /* NULL: no archive */
    char inside[CR_INSIDE_MAX];         /* path, of a file in a folder */
    struct cr_import_count *count;
    char format[CR_SOURCE_MAX];
    char sha256[CR_HASH_SIZE]; /* of the one file, or of the lines in `files` */
    struct cr_str files;       /* "SHA-256  name" of each */
    int hashed;
    long polls, polls_most; /* of a database, while it is watched, and how many it may have */
};

/* Sets the name of the format in `source`, "PCM v5"; before the first case. */
void cr_import_format(struct cr_import *im, const char *fmt, ...) CR_PRINTF(2, 3);

/* Names a further file that belongs to the import (ERG beside its .info), before the first case:
 * its SHA-256 goes into the source. Errors: IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_import_also(struct cr_import *im, const char *path,
                                         struct cr_error *err);

/* Finds the file of that name, in capital or small letters, in a folder and writes its path, "" if
 * there is none. Errors: IO, MEMORY, RANGE for a path longer than size allows. */
CR_MUST_CHECK enum cr_err cr_import_file_in(const char *folder, const char *name, char *path,
                                            size_t size, struct cr_error *err);
/* Tells whether there is one. */
bool cr_import_lies_in(const char *folder, const char *name);
/* Tells whether im->path is a folder. */
bool cr_import_is_folder(const struct cr_import *im);

/* Tells whether --case asks for the case of that id, or for all, and notes that it is there. */
bool cr_import_wants(const struct cr_import *im, const char *id);

/* Begins a case by its id in the source ("" if there is only one) and the name of its scene.
 * Errors: MEMORY, INTERRUPTED. */
CR_MUST_CHECK enum cr_err cr_import_begin(struct cr_import *im, const char *id, const char *name,
                                          struct cr_error *err);
/* Ends it: a scene is written, or an error object where fault is given or something is missing.
 * Errors: those of opts->take, MEMORY, INTERRUPTED. */
CR_MUST_CHECK enum cr_err cr_import_end(struct cr_import *im, const struct cr_error *fault,
                                        struct cr_error *err);

/* Adds a participant to the case; *out is valid until the case ends. id is the source's: what is
 * not fit for an id of a scene (letters, digits, _ and -) is replaced. Errors: DUPLICATE, RANGE for
 * an id that is too long or too many participants, MEMORY. */
CR_MUST_CHECK enum cr_err cr_import_add(struct cr_import *im, const char *id, enum cr_kind kind,
                                        struct cr_participant **out, struct cr_error *err);
/* Finds the one that was added under that id of the source; NULL if there is none. */
struct cr_participant *cr_import_find(const struct cr_import *im, const char *id);

/* Adds a row of a participant's motion: s, m, rad, m/s; pos is the place of the case's reference
 * point. What the reader fills in of the participant counts only before its first row. Rows after
 * the first contact of outlines are left out. Errors: RANGE (time does not rise, a value is not
 * finite or out of all range), EXPENSIVE (too many rows must be held), MEMORY, and those of a
 * scene's participant. */
CR_MUST_CHECK enum cr_err cr_import_row(struct cr_import *im, struct cr_participant *p,
                                        const struct cr_waypoint *row, struct cr_error *err);
/* Tells whether outlines have met, so that what follows in the file is of no use. */
bool cr_import_met(const struct cr_import *im);

/* Sets what pos and the rows of this case are places of, unless --reference says otherwise; without
 * it they are places of the CG. */
void cr_import_point(struct cr_import *im, enum cr_point point);
/* Notes something that the user should know of how the case was read, in source.note. */
void cr_import_note(struct cr_import *im, const char *fmt, ...) CR_PRINTF(2, 3);
/* Sets the friction of the road, if the file knows it. */
void cr_import_road_friction(struct cr_import *im, double mu);
/* Sets the x_ keys of the scene (x_expect ...), unless reading them ended with the code of an
 * error, which is returned. The object is taken over either way. The x_ keys of a participant go as
 * JSON text into its `extra`. Error: MEMORY, where any of the object is missing. */
CR_MUST_CHECK enum cr_err cr_import_extra(struct cr_import *im, enum cr_err code,
                                          struct cJSON *object, struct cr_error *err);

#define X(name)                                                                                    \
    bool cr_import_##name##_is(const struct cr_import_head *head);                                 \
    enum cr_err cr_import_##name##_read(struct cr_import *im, struct cr_error *err);
CR_FORMAT_LIST(X)
#undef X

#endif
