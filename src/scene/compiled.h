/* A scene made into the case that is solved. */
#ifndef CR_SCENE_COMPILED_H
#define CR_SCENE_COMPILED_H

#include "base/arena.h"
#include "scene/scene.h"
#include "solver/case.h"

/* What a compiled case was made of. */
struct cr_compiled {
    struct cr_case cs;
    struct cr_arena arena;                /* owns the grids, vertices and waypoints of cs */
    char model[CR_BODY_MAX][CR_NAME_MAX]; /* "suv/12", "file my.json", "stiffness" */
    char hash[CR_BODY_MAX][CR_HASH_SIZE]; /* of the model's source */
};

/* Resolved scene -> case. pdof[i] is the PDOF (rad) for vehicle i's model, used where the model
 * choice is auto. Own model files are read here. Errors: those of the model functions. */
CR_MUST_CHECK enum cr_err cr_scene_compile(const struct cr_scene *scene,
                                           const struct cr_model_lib *lib,
                                           const double pdof[CR_BODY_MAX], struct cr_compiled *out,
                                           struct cr_error *err);
void cr_compiled_fini(struct cr_compiled *compiled);

#endif
