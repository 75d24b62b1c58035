/* Any bytes as the input of a stack and as results to resume: it ends, and every item is a text or
 * a fault. */
#include "scratch.h"

#include "cli/feed.h"
#include "cli/resume.h"
#include "result/result.h"
#include "scene/scene.h"

#include <string.h>

static void feed(char *path) {
    char *inputs[1] = {path};
    struct cr_error err = {0};
    struct cr_feed *f;
    struct cr_feed_item item;
    if (cr_feed_new(inputs, 1, NULL, NULL, &f, &err) != CR_ERR_OK) {
        return;
    }
    for (long n = 0; cr_feed_next(f, &item); n++) {
        struct cr_scene scene;
        if ((item.text == NULL && item.fault.text[0] == '\0') || n > 1000000) {
            abort();
        }
        if (item.text != NULL &&
            cr_scene_parse(item.text, item.len, item.src, &scene, &err) == CR_ERR_OK) {
            cr_scene_fini(&scene);
        }
        cr_feed_item_fini(&item);
    }
    cr_feed_free(f);
}

static void resume(const char *path) {
    static struct cr_model_lib *lib;
    char models[4200];
    struct cr_error err = {0};
    struct cr_resume *r = NULL;
    const struct cr_result_opts form = {0};
    snprintf(models, sizeof models, "%s/models", data_dir());
    if (lib == NULL && cr_model_lib_open(models, &lib, &err) != CR_ERR_OK) {
        exit(3);
    }
    if (cr_resume_open(&path, 1, lib, &form, &r, &err) != CR_ERR_OK) {
        if (err.text[0] == '\0') {
            abort();
        }
        return;
    }
    cr_resume_free(r);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *name = size & 1 ? "scenes.json" : "scenes.jsonl";
    char *path = scratch_put(name, data, size);
    feed(path);
    resume(path);
    return 0;
}
