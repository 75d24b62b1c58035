/* Any bytes as a scene: refused with an error, or read, written and read again as the same. */
#include "fuzz.h"

#include "base/json.h"
#include "scene/scene.h"

#include <stdlib.h>
#include <string.h>

static char *written(const struct cr_scene *scene) {
    struct cr_str text = {0};
    if (!cr_json_add(cr_scene_to_json(scene, false), false, &text)) {
        abort();
    }
    return text.s;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct cr_scene scene, again;
    struct cr_error err = {0};
    char *text = malloc(size + 1);
    if (text == NULL) {
        return 0;
    }
    memcpy(text, data, size);
    text[size] = '\0';
    enum cr_err code = cr_scene_parse(text, size, "fuzz", &scene, &err);
    free(text);
    if (code != CR_ERR_OK) {
        if (err.code != code || err.text[0] == '\0') {
            abort();
        }
        return 0;
    }
    char *first = written(&scene);
    if (cr_scene_parse(first, strlen(first), "again", &again, &err) != CR_ERR_OK) {
        abort();
    }
    char *second = written(&again);
    if (strcmp(first, second) != 0) {
        abort();
    }
    free(first);
    free(second);
    cr_scene_fini(&scene);
    cr_scene_fini(&again);
    return 0;
}
