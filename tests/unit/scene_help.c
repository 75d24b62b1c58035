/* Builds scenes out of texts, and opens the models, for tests of scenes. */
#include "scene_help.h"

#include "base/json.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void scene_from(const char *text, struct cr_scene *scene) {
    struct cr_error err;
    char line[900];
    if (cr_scene_parse(text, strlen(text), "test", scene, &err) != CR_ERR_OK) {
        fail_msg("%s", cr_err_format(&err, line, sizeof line));
    }
}

void scene_of(const char *first, const char *second, struct cr_scene *scene) {
    struct cr_str text = {0};
    cr_str_addf(&text, "{ \"crumple\": 1, \"participants\": [ { %s }, { %s } ] }", first, second);
    scene_from(cr_str_get(&text), scene);
    cr_str_fini(&text);
}

char *scene_text(const struct cr_scene *scene, bool all) {
    struct cr_str text = {0};
    assert_true(cr_json_add(cr_scene_to_json(scene, all), true, &text));
    return text.s;
}

const char *scene_path(const char *name) {
    static char path[4096];
    const char *src = getenv("SRC");
    snprintf(path, sizeof path, "%s/%s", src != NULL ? src : ".", name);
    return path;
}

struct cr_model_lib *scene_models(void) {
    struct cr_model_lib *lib = NULL;
    struct cr_error err;
    if (cr_model_lib_open(scene_path("models"), &lib, &err) != CR_ERR_OK ||
        cr_model_need_all(lib, &err) != CR_ERR_OK) {
        fail_msg("%s", err.text);
    }
    return lib;
}
