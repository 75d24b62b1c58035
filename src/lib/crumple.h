/* libcrumple, the interface for other programs: vehicle crashes as JSON in, numbers and JSON out.
 *
 * One `crumple` holds the models and risk functions. It never changes once it is open: any number
 * of threads may solve with it at the same time. A `crumple_result` never changes either and may be
 * read by any number of threads. The library keeps no state of its own between calls; it neither
 * prints nor exits nor touches signals, and takes numbers with a decimal point whatever the
 * locale of the caller is.
 *
 * A function that can fail returns CRUMPLE_OK (0) or a code, and fills in *error unless that is
 * NULL. What it returns through a pointer is then NULL. */
#ifndef CR_LIB_CRUMPLE_H
#define CR_LIB_CRUMPLE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CRUMPLE_VERSION_MAJOR 0
#define CRUMPLE_VERSION_MINOR 1
#define CRUMPLE_VERSION_MICRO 0
/* The version as one number that grows: 100 for 0.1.0, 10203 for 1.2.3. */
#define CRUMPLE_VERSION_NUMBER                                                                     \
    (CRUMPLE_VERSION_MAJOR * 10000 + CRUMPLE_VERSION_MINOR * 100 + CRUMPLE_VERSION_MICRO)

#if defined(__GNUC__)
#define CRUMPLE_API __attribute__((visibility("default")))
#else
#define CRUMPLE_API
#endif

typedef struct crumple crumple;
typedef struct crumple_result crumple_result;

/* Codes of errors; their numbers stay. crumple_error_word gives the word of the result JSON. */
enum crumple_code {
    CRUMPLE_OK = 0,
    CRUMPLE_USAGE = 2,        /* an argument that cannot be */
    CRUMPLE_IO = 3,           /* a file or folder cannot be read */
    CRUMPLE_SYNTAX = 4,       /* the text is no JSON */
    CRUMPLE_TYPE = 5,         /* a value of the wrong kind */
    CRUMPLE_RANGE = 6,        /* a number beyond what is possible */
    CRUMPLE_KEY = 7,          /* a key that is not known */
    CRUMPLE_MISSING = 8,      /* a key that must be there */
    CRUMPLE_DUPLICATE = 9,    /* a key or id twice */
    CRUMPLE_NAME = 10,        /* no participant, type, model or value of this name */
    CRUMPLE_MODEL = 11,       /* a voxel model that cannot be used */
    CRUMPLE_OVERLAP = 12,     /* participants overlap at the start */
    CRUMPLE_NO_CONTACT = 13,  /* participants never meet */
    CRUMPLE_SOLVER = 14,      /* the solver failed */
    CRUMPLE_MEMORY = 15,      /* out of memory */
    CRUMPLE_INTERRUPTED = 16, /* cancelled by the caller */
    CRUMPLE_EXPENSIVE = 17    /* the scene takes more memory than one may */
};

/* What went wrong, where, and the way out. Begin with CRUMPLE_ERROR_INIT: the size tells the
 * library which version of this struct it is given. */
typedef struct crumple_error {
    size_t size;
    int code;         /* enum crumple_code */
    int line, column; /* in the text of the scene, from 1; 0: not known */
    char source[256]; /* name of that text, or of the file at fault; "": none */
    char where[128];  /* JSON pointer of the value at fault, "": none */
    char text[256];   /* what is wrong, one line */
    char hint[192];   /* the way out, "": none */
} crumple_error;
#define CRUMPLE_ERROR_INIT                                                                         \
    { sizeof(crumple_error), 0, 0, 0, "", "", "", "" }

/* How to solve. Begin with CRUMPLE_OPTIONS_INIT; NULL instead of a pointer to it is the same. */
typedef struct crumple_options {
    size_t size;
    const char *name;          /* of the scene in errors; NULL: "scene" */
    const char *folder;        /* that files named in the scene start from; NULL: "." */
    const char *const *set;    /* "KEY=VALUE" as of crumple run --set, in order; NULL: none */
    size_t sets;               /* number of them */
    int (*cancel)(void *user); /* polled in every time slice, from the thread that solves; non-zero
                                  ends with CRUMPLE_INTERRUPTED; NULL: never */
    void *user;                /* handed to cancel */
} crumple_options;
#define CRUMPLE_OPTIONS_INIT                                                                       \
    { sizeof(crumple_options), NULL, NULL, NULL, 0, NULL, NULL }

/* The version of the library that runs, which may be newer than the header: "0.1.0", 100. */
CRUMPLE_API const char *crumple_version(void);
CRUMPLE_API int crumple_version_number(void);

/* The word of a code, "unknown-key"; "unknown" for a number that is no code. Never freed. */
CRUMPLE_API const char *crumple_error_word(int code);

/* Read the models and risk functions of a data folder; NULL: that of the environment variable
 * CRUMPLE_DATA, else the one the library was installed with. Cars that a scene names come from its
 * catalogue and from the tables in the user's own, $XDG_DATA_HOME/crumple/catalogue or
 * ~/.local/share/crumple/catalogue. Errors: CRUMPLE_IO, CRUMPLE_SYNTAX, CRUMPLE_MODEL,
 * CRUMPLE_MEMORY. Close with crumple_close. */
CRUMPLE_API int crumple_open(const char *data_folder, crumple **out, crumple_error *error);

/* Give back what crumple_open has made; results of it stay valid. NULL does nothing. */
CRUMPLE_API void crumple_close(crumple *lib);

/* SHA-256 of all models and risk functions, 64 hexadecimal digits. Two libraries of one version and
 * one such hash give the same bytes for the same scene. Valid until crumple_close. */
CRUMPLE_API const char *crumple_data_hash(const crumple *lib);

/* Solve a scene, given as JSON text of `length` bytes (scene.schema.json). Errors: all. Free the
 * result with crumple_result_free. */
CRUMPLE_API int crumple_solve(const crumple *lib, const char *scene, size_t length,
                              const crumple_options *options, crumple_result **out,
                              crumple_error *error);

/* Free a result; NULL does nothing. */
CRUMPLE_API void crumple_result_free(crumple_result *result);

/* Next scene of a stack: return 1 with its text, which must stay valid until the next call; 0 at
 * the end. Called from the threads of the stack, one call at a time. It may change name and folder
 * of the options of the stack, which are read and copied after each call. */
typedef int (*crumple_next)(void *user, const char **scene, size_t *length);

/* A scene of a stack is done: `result` belongs to the callee from now on, or is NULL with what
 * went wrong in *error, which is valid during the call. `index` counts the scenes from 0. Called in
 * the order of the scenes, in the thread that called crumple_stack. Return non-zero to stop. */
typedef int (*crumple_done)(void *user, size_t index, crumple_result *result,
                            const crumple_error *error);

/* Solve scenes in threads (1 to 256; 0: one per processor). The results are the same for any
 * number of them; no more than four scenes per thread are in memory at a time. A scene that fails
 * does not stop the stack. options->cancel is polled from all threads. Errors: CRUMPLE_USAGE,
 * CRUMPLE_MEMORY; CRUMPLE_INTERRUPTED where `done` or `cancel` has stopped it. */
CRUMPLE_API int crumple_stack(const crumple *lib, int threads, const crumple_options *options,
                              crumple_next next, crumple_done done, void *user,
                              crumple_error *error);

/* EES and delta-v out of a measured deformation: the text of a damage file (crumple(1)) into *json,
 * what crumple damage --format=json prints. Free it with crumple_free. Of the options the name
 * counts. Errors: those of scenes. */
CRUMPLE_API int crumple_damage(const crumple *lib, const char *text, size_t length,
                               const crumple_options *options, char **json, crumple_error *error);

/* A case of an import: the text of a scene (one line, as crumple_solve takes it), valid during the
 * call, or NULL with what kept it from being one in *error. Return non-zero to stop. */
typedef int (*crumple_case)(void *user, const char *scene, size_t length,
                            const crumple_error *error);

/* Scenes out of a file or folder that another program, a database or a test house has written
 * (crumple-import(1)), case by case in the order of the file. options->set has the options of
 * crumple import, "case=3,17", "reference=cg", "map=FILE". A case that cannot be converted does not
 * stop the others. Errors: CRUMPLE_USAGE; CRUMPLE_IO and CRUMPLE_SYNTAX for a file that cannot be
 * read or has no known format; CRUMPLE_NAME for a case that is not there; CRUMPLE_MEMORY;
 * CRUMPLE_INTERRUPTED where `take` or `cancel` has stopped it. */
CRUMPLE_API int crumple_import(const crumple *lib, const char *path, const crumple_options *options,
                               crumple_case take, void *user, crumple_error *error);

/* Parts of the JSON of a result. */
enum crumple_json_flag {
    CRUMPLE_TRACE = 1,    /* with the time series */
    CRUMPLE_RESOLVED = 2, /* with the scene as solved, every default filled in */
    CRUMPLE_PRETTY = 4    /* indented, else one line */
};

/* The result as JSON (result.schema.json) with a newline at the end, as crumple run prints it; its
 * length into *length unless that is NULL. NULL when memory is out. Free with crumple_free. */
CRUMPLE_API char *crumple_json(const crumple_result *result, unsigned flags, size_t *length);

/* Free a text that the library has returned; NULL does nothing. */
CRUMPLE_API void crumple_free(void *text);

/* Name of the i-th value of a result, NULL beyond the last one. Names are the keys of the result
 * JSON joined by dots, a participant by its id, an injury risk by its function: "A.ees_kmh",
 * "B.injury.NAME.probability", "contacts.0.restitution", "balance.energy_residual". */
CRUMPLE_API const char *crumple_name(const crumple_result *result, size_t i);

/* Number of a name, in the unit that the name ends in, NaN where the result has null. A name may
 * leave out its unit ("A.ees"). Errors: CRUMPLE_NAME for what is not there or is no number. */
CRUMPLE_API int crumple_value(const crumple_result *result, const char *name, double *out);

/* Text of a name such as "A.cdc" or "time.stop", NULL for what is not there or is no text. Valid
 * until crumple_result_free. */
CRUMPLE_API const char *crumple_word(const crumple_result *result, const char *name);

/* A time series: "t_s", or one of a participant's in the vehicle's frame or the world's as in the
 * trace of the result JSON, "A.ax_mps2". Writes the first `size` samples to out (NULL with size 0)
 * and returns how many there are, 0 for a name that is not there. */
CRUMPLE_API size_t crumple_series(const crumple_result *result, const char *name, double *out,
                                  size_t size);

/* The scene from above as an SVG element with the EES of the voxels, speeds and forces, at a time
 * in s of the scene; NaN: after the crash. Its length into *length unless that is NULL. NULL when
 * memory is out. Free with crumple_free. */
CRUMPLE_API char *crumple_svg(const crumple_result *result, double time, size_t *length);

/* What crumple_field gives for each voxel. */
enum crumple_field_kind {
    CRUMPLE_FIELD_MATERIAL = 0, /* share of the voxel that was material, 0..1 */
    CRUMPLE_FIELD_DAMAGE = 1,   /* share of the material that was crushed, 0..1 */
    CRUMPLE_FIELD_ENERGY = 2,   /* that crushes all its material, J */
    CRUMPLE_FIELD_ABSORBED = 3, /* that it has taken, J */
    CRUMPLE_FIELD_EES = 4,      /* of a crush of the whole face down to it, km/h */
    CRUMPLE_FIELD_TIME = 5      /* when it was crushed, s; infinite where it was not */
};

/* The voxels of a participant's plan model at the end of the crash. dims gets the numbers of voxels
 * along the vehicle, across it and in height (1: a plan model). The voxel (ix, iy) is
 * out[iy * dims[0] + ix]; x counts forward, y to the left. frame gets x and y (m) of the corner of
 * voxel (0, 0) in the frame of the vehicle, the edge of a voxel (m), and x, y (m) and heading (rad)
 * of the vehicle's centre of gravity in the world after the contact. Writes the first `size` values
 * to out and returns how many there are; 0 for a participant without voxels or an unknown kind. */
CRUMPLE_API size_t crumple_field(const crumple_result *result, const char *id, int kind, float *out,
                                 size_t size, int dims[3], double frame[6]);

#ifdef __cplusplus
}
#endif

#endif
