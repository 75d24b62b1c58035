/* What the tests of scenes share. */
#ifndef CR_SCENE_HELP_H
#define CR_SCENE_HELP_H

#include "test.h"

#include "scene/scene.h"

/* Scene from a text that must be good. The caller finishes it. */
void scene_from(const char *text, struct cr_scene *scene);

/* "{ crumple: 1, participants: [ first, second ] }" with those members. */
void scene_of(const char *first, const char *second, struct cr_scene *scene);

/* The scene as cr_scene_save writes it; the caller frees it. */
char *scene_text(const struct cr_scene *scene, bool all);

/* The models of the source tree; the caller frees them. */
struct cr_model_lib *scene_models(void);

/* Path of a file of the source tree in a static buffer. */
const char *scene_path(const char *name);

#define CAR   "\"kind\": \"vehicle\", \"type\": \"compact\", \"mass_kg\": 1400"
#define CAR_A "\"id\": \"A\", " CAR ", \"position_m\": [0, 0]"
#define CAR_B "\"id\": \"B\", " CAR ", \"position_m\": [9, 0]"

#endif
