/* Makes the pictures of a crash by name, as the prompt, the command line and the report ask for
 * them, and writes them into files. */
#ifndef CR_FIGURE_PICTURES_H
#define CR_FIGURE_PICTURES_H

#include "figure/figure.h"

/* X(NAME, word, needs a result, help) */
#define CR_PICTURE_LIST(X)                                                                         \
    X(SCENE, "scene", false, "the scene as the view shows it, or at time=")                        \
    X(BEFORE, "before", false, "the scene before the crash")                                       \
    X(CONTACT, "contact", true, "the scene at first contact")                                      \
    X(ENGAGED, "engagement", true, "the scene at greatest engagement")                             \
    X(AFTER, "after", true, "the scene after the crash")                                           \
    X(PULSE, "pulse", true, "acceleration or another quantity over time")                          \
    X(ENERGY, "energy", true, "kinetic and deformation energy over time")                          \
    X(DAMAGE, "damage", true, "crush of the struck face, computed beside measured")                \
    X(SIDE, "side", true, "the 3D model of a vehicle from the side")                               \
    X(TOP, "top", true, "the 3D model of a vehicle from above")                                    \
    X(FRONT, "front", true, "the 3D model of a vehicle from before")                               \
    X(RISK, "risk", true, "injury risk over delta-v")                                              \
    X(OVERVIEW, "overview", true, "before, after, pulse and energy on one sheet")

enum cr_picture {
#define X(name, word, result, help) CR_PICTURE_##name,
    CR_PICTURE_LIST(X)
#undef X
        CR_PICTURES
};
/* The word of a picture, and the picture of a word (-1: none). */
const char *cr_picture_word(enum cr_picture picture);
int cr_picture_find(const char *word);

enum { CR_FACE_MEASURED_MAX = 64 };

/* Crush that was measured on a face, at even stations from `from` to `to`, m from the middle of the
 * vehicle: from left to right on the ends, from rear to front on the sides. */
struct cr_face_measured {
    enum cr_face face;
    int n; /* 0: nothing was measured */
    double from, to;
    double depth[CR_FACE_MEASURED_MAX]; /* m */
};

/* What pictures are made of. */
struct cr_picture_source {
    const struct cr_result *result;          /* NULL: not solved */
    const struct cr_scene *scene;            /* read without a result: a resolved scene */
    const struct cr_compiled *compiled;      /* read without a result: that scene compiled */
    const struct cr_model_lib *models;       /* for the 3D models */
    const struct cr_irf_set *irf;            /* for the risk curves */
    struct cr_scene_view view;               /* how the scene is shown; time NaN: after the crash */
    int body;                                /* whose damage, 3D model, risk; -1: first vehicle */
    enum cr_quantity quantity;               /* of the pulse; CR_QUANTITIES: |a| */
    const struct cr_face_measured *measured; /* shown beside the computed crush if it is of the
                                                struck face; NULL: none */
    struct cr_figure_words words;            /* with a result its units count */
};

/* Draws a picture on a canvas of its own, 500 points wide (the overview twice as wide); the caller
 * frees it. Errors: MISSING without a result or a vehicle, NAME for a body that is no vehicle,
 * MEMORY, those of the models. */
CR_MUST_CHECK enum cr_err cr_picture_draw(enum cr_picture picture,
                                          const struct cr_picture_source *source,
                                          struct cr_canvas **out, struct cr_error *err);

/* The places of C1 and C6 along the struck face of a vehicle, m, as in struct cr_face_measured. */
void cr_picture_profile_span(const struct cr_result *result, int body, double *from, double *to);

enum cr_picture_format { CR_FORMAT_SVG, CR_FORMAT_PDF, CR_FORMAT_PNG, CR_PICTURE_FORMATS };
/* The format that the suffix of a path names; -1: none. */
int cr_picture_format_of(const char *path);
/* Checks whether a picture can go into a file of that name. Errors: USAGE for another suffix, and
 * in a build without cairo for what needs it. */
CR_MUST_CHECK enum cr_err cr_picture_may_write(const char *path, struct cr_error *err);
/* Takes a canvas over and writes it into a file, in the format of its suffix, whole or not at all.
 * Errors: those of cr_picture_may_write, IO; MEMORY, also for a canvas of NULL. */
CR_MUST_CHECK enum cr_err cr_picture_write(struct cr_canvas *canvas, const char *path,
                                           const char *title, struct cr_error *err);
/* Adds the content of a file with the canvas to out. Errors: USAGE in a build without cairo,
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_picture_text(struct cr_canvas *canvas, enum cr_picture_format format,
                                          const char *title, struct cr_str *out,
                                          struct cr_error *err);

#endif
