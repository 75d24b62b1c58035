/* The pictures of a crash by name, as the prompt, the command line and the report ask for them. */
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
const char *cr_picture_word(enum cr_picture picture);
bool cr_picture_needs_result(enum cr_picture picture);
int cr_picture_find(const char *word); /* -1: none */

enum { CR_FACE_MEASURED_MAX = 64 };

/* Crush that was measured on a face, at even stations: from left to right on the ends, from rear to
 * front on the sides, m from the middle of the vehicle. */
struct cr_face_measured {
    enum cr_face face;
    int n; /* 0: nothing */
    double from, to;
    double depth[CR_FACE_MEASURED_MAX]; /* m */
};

/* What they are made of. */
struct cr_picture_source {
    const struct cr_result *result;          /* NULL: not solved */
    const struct cr_scene *scene;            /* without a result: resolved */
    const struct cr_compiled *compiled;      /* likewise */
    const struct cr_model_lib *models;       /* of the 3D models */
    const struct cr_irf_set *irf;            /* of the risk curves */
    struct cr_scene_view view;               /* of the scene; time NaN: after the crash */
    int body;                                /* of damage, 3D models, risk; -1: the first vehicle */
    enum cr_quantity quantity;               /* of the pulse; CR_QUANTITIES: |a| */
    const struct cr_face_measured *measured; /* crush beside the computed; NULL: none, and of
                                                another face it is left out */
    struct cr_figure_words words;
};

/* A picture on a canvas of its own, 500 points wide. Errors: MISSING without a result or a vehicle,
 * MEMORY, those of the models. */
CR_MUST_CHECK enum cr_err cr_picture_draw(enum cr_picture picture,
                                          const struct cr_picture_source *source,
                                          struct cr_canvas **out, struct cr_error *err);

/* The time that a picture of the scene shows, s; NaN: after the crash. */
double cr_picture_time(enum cr_picture picture, const struct cr_result *result, double otherwise);
/* C1 and C6 along the struck face of a vehicle, m, as in struct cr_face_measured. */
void cr_picture_profile_span(const struct cr_result *result, int body, double *from, double *to);
/* "after the crash, 165.5 ms after first contact" in the words of the source. */
void cr_picture_title(const struct cr_picture_source *source, double time, char *buf, int size);

enum cr_picture_format { CR_FORMAT_SVG, CR_FORMAT_PDF, CR_FORMAT_PNG, CR_PICTURE_FORMATS };
/* By the suffix of a path; -1: none of them. */
int cr_picture_format_of(const char *path);
/* Can there be a picture in a file of that name? Errors: USAGE for another suffix, and in a build
 * without cairo, which it names. */
CR_MUST_CHECK enum cr_err cr_picture_may_write(const char *path, struct cr_error *err);
/* Takes a canvas over and writes it into a file, in the format of its suffix, whole or not at all.
 * Errors: those of cr_picture_may_write, IO; MEMORY, also for a canvas of NULL. */
CR_MUST_CHECK enum cr_err cr_picture_write(struct cr_canvas *canvas, const char *path,
                                           const char *title, struct cr_error *err);
/* A canvas as the text of a file. Errors: USAGE in a build without cairo, MEMORY. */
CR_MUST_CHECK enum cr_err cr_picture_text(struct cr_canvas *canvas, enum cr_picture_format format,
                                          const char *title, struct cr_str *out,
                                          struct cr_error *err);

#endif
