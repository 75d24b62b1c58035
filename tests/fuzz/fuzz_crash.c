/* Any bytes as a scene, solved for some slices: an error with a text, or a result that closes its
 * energy and momentum and is written in every form. */
#include "scratch.h"

#include "base/json.h"
#include "result/result.h"

#include <math.h>

static int stop_late(void *user) {
    int *polls = user;
    return ++*polls > 2500;
}

static void look_at(const struct cr_result *r, bool whole) {
    const struct cr_balance *b = &r->solution->balance;
    const struct cr_result_opts form = {.trace = true, .resolved = true};
    struct cr_str out = {0};
    struct cr_error err = {0};
    if (whole && !(b->energy_residual < 1e-7 && b->momentum_residual < 1e-7)) {
        abort();
    }
    if (cr_result_json(r, &form, &out, &err) != CR_ERR_OK ||
        cr_json_check(out.s, out.len, NULL, NULL) != CR_ERR_OK) {
        abort();
    }
    cr_str_clear(&out);
    if (cr_result_csv(r, &form, &out, &err) != CR_ERR_OK) {
        abort();
    }
    cr_str_fini(&out);
}

/* what would only make the fuzzer slow */
static bool is_slow(const struct cr_scene *scene) {
    bool slow = scene->n > 5 || scene->set.voxel < 0.02;
    for (int i = 0; i < scene->n; i++) {
        const struct cr_participant *p = &scene->part[i];
        slow = slow || p->length > 8 || p->waypoints > 50 || p->model.file[0] != '\0';
    }
    return slow;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static struct cr_model_lib *lib;
    char models[4200];
    struct cr_error err = {0};
    struct cr_scene scene;
    struct cr_result *result = NULL;
    int polls = 0;
    snprintf(models, sizeof models, "%s/models", data_dir());
    if (lib == NULL && cr_model_lib_open(models, &lib, &err) != CR_ERR_OK) {
        exit(3);
    }
    if (cr_scene_parse((const char *)data, size, "fuzz", &scene, &err) != CR_ERR_OK) {
        return 0;
    }
    if (!is_slow(&scene)) {
        scene.set.dt = fmax(scene.set.dt, 1e-4);
        const struct cr_context ctx = {
            .models = lib, .cancel = stop_late, .user = &polls, .keep = true, .max_bytes = 1e9};
        enum cr_err code = cr_result_run(&scene, &ctx, &result, &err);
        if (code != CR_ERR_OK && err.text[0] == '\0') {
            abort();
        }
        if (result != NULL) {
            look_at(result, code == CR_ERR_OK);
            cr_result_free(result);
        }
    }
    cr_scene_fini(&scene);
    return 0;
}
