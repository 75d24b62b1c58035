/* What the fuzz targets of import do with the lines that come out. */
#ifndef CR_FUZZ_SCENE_H
#define CR_FUZZ_SCENE_H

#include "fuzz.h"

#include "scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* what comes out is a scene that reads, or an error object */
static enum cr_err take(void *user, const struct cr_str *line, struct cr_error *err) {
    struct cr_scene scene;
    (void)user;
    if (strncmp(line->s, "{\"crumple_result\"", 17) != 0) {
        if (cr_scene_parse(line->s, line->len, "scene", &scene, err) != CR_ERR_OK) {
            fprintf(stderr, "%s: %s\n", err->where, err->text);
            abort();
        }
        cr_scene_fini(&scene);
    }
    return CR_ERR_OK;
}

#endif
