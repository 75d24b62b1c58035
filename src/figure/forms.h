/* Writes a crash in the forms of other programs: ISO-MME channels, a gnuplot pair, the motion as
 * CSV, VTK and OBJ of the 3D model, a film for terminals. */
#ifndef CR_FIGURE_FORMS_H
#define CR_FIGURE_FORMS_H

#include "render/project.h"
#include "render/render.h"

/* Takes the files of a form one by one; name is relative, "Channel/crash.001". */
struct cr_form_sink {
    enum cr_err (*put)(void *user, const char *name, const struct cr_str *text,
                       struct cr_error *err);
    void *user;
};

/* Writes ISO/TS 13499 (MME): accelerations and velocities of the CGs and yaw rates of all that
 * moves, evenly sampled, time 0 at first contact, signs of SAE J211 (x forward, y right, z down),
 * marked as computed. `name` is that of the test. Errors: MEMORY, those of the sink. */
CR_MUST_CHECK enum cr_err cr_form_mme(const struct cr_result *result, const char *name,
                                      const struct cr_form_sink *sink, struct cr_error *err);

/* Writes NAME.dat with evenly sampled curves, and NAME.gp, which draws them with gnuplot. Errors:
 * MEMORY, those of the sink. */
CR_MUST_CHECK enum cr_err cr_form_gnuplot(const struct cr_result *result, const char *name,
                                          const struct cr_form_sink *sink, struct cr_error *err);

/* Adds place of the CG, heading (continuous) and velocities of all that moves from the begin to the
 * end of the solve as CSV, every `step` seconds, time 0 at first contact. ISO 8855: x east, y
 * north, angles counter-clockwise; SAE J670: x east, y south, angles clockwise. */
enum cr_axes_of { CR_AXES_ISO, CR_AXES_SAE };
void cr_form_motion(const struct cr_result *result, enum cr_axes_of axes, double step,
                    struct cr_str *out);

/* Adds legacy VTK, ASCII: the voxels as cells with fill, EES (km/h), energy (J) and damage (share
 * of material lost); m, own frame of the vehicle. */
void cr_form_vtk(const struct cr_body_voxels *body, struct cr_str *out);
/* Adds Wavefront OBJ: the surface of the material that is left, quads counter-clockwise as seen
 * from outside; m. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_form_obj(const struct cr_body_voxels *body, struct cr_str *out,
                                      struct cr_error *err);

/* Adds an asciinema cast, version 2: the crash in slow motion on a terminal of w x h characters.
 * Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_form_cast(const struct cr_result *result, int w, int h,
                                       struct cr_str *out, struct cr_error *err);

#endif
