/* What the files of export share: one export under way, and those that draw. */
#ifndef CR_CMD_EXPORT_H
#define CR_CMD_EXPORT_H

#include "cmd/cmd_priv.h"

/* X(NAME, suffix of its files) */
#define CR_EXPORT_FORM_LIST(X)                                                                     \
    X(CSV, ".csv")                                                                                 \
    X(JSON, ".json")                                                                               \
    X(TXT, ".txt")                                                                                 \
    X(HTML, ".html")                                                                               \
    X(SVG, ".svg")                                                                                 \
    X(PDF, ".pdf")                                                                                 \
    X(PNG, ".png")                                                                                 \
    X(MME, ".mme")                                                                                 \
    X(GP, ".gp")                                                                                   \
    X(VTK, ".vtk")                                                                                 \
    X(OBJ, ".obj")                                                                                 \
    X(CAST, ".cast")

enum cr_export_form {
#define X(name, suffix) CR_EXPORT_##name,
    CR_EXPORT_FORM_LIST(X)
#undef X
        CR_EXPORT_FORMS
};

struct cr_export {
    struct cr_call *call;
    struct cr_session *s;
    const char *what, *path;
    int form;           /* enum cr_export_form */
    struct cr_str text; /* what goes into the file */
    bool written;       /* the maker has written its files itself */
};

/* A picture by the name of what is exported (figure/pictures.h). */
enum cr_err cr_export_picture(struct cr_export *x, struct cr_error *err);
/* The last sweep as curves or as a map. */
enum cr_err cr_export_sweep(struct cr_export *x, struct cr_error *err);
/* Histogram or tornado of the last draws (mc). */
enum cr_err cr_export_mc(struct cr_export *x, struct cr_error *err);

/* The expert's report as HTML or PDF. */
enum cr_err cr_export_report(struct cr_export *x, struct cr_error *err);

/* ISO-MME channels (beside FILE.mme a folder Channel) or a gnuplot pair; a film; the 3D model. */
enum cr_err cr_export_channels(struct cr_export *x, struct cr_error *err);
enum cr_err cr_export_motion(struct cr_export *x, struct cr_error *err);
enum cr_err cr_export_film(struct cr_export *x, struct cr_error *err);
enum cr_err cr_export_body(struct cr_export *x, struct cr_error *err);

#endif
