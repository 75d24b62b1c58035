/* export: a crash in the forms of other programs, one or several files each. */
#include "cmd/export.h"

#include "base/file.h"
#include "figure/forms.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/* name and folder that the files of an export get: "a/b/crash.gp" -> "a/b", "crash" */
struct place {
    char dir[CR_PATH_MAX], name[200];
};

static void place_of(const char *path, struct place *out) {
    const char *slash = strrchr(path, '/'), *base = slash != NULL ? slash + 1 : path;
    const char *dot = strrchr(base, '.');
    cr_file_dir(path, out->dir, sizeof out->dir);
    snprintf(out->name, sizeof out->name, "%.*s",
             (int)(dot != NULL ? dot - base : (long)strlen(base)), base);
}

static enum cr_err put_file(void *user, const char *name, const struct cr_str *text,
                            struct cr_error *err) {
    const struct place *place = user;
    char path[2 * CR_PATH_MAX];
    const char *slash = strchr(name, '/');
    if (slash != NULL) {
        snprintf(path, sizeof path, "%s/%.*s", place->dir, (int)(slash - name), name);
        if (mkdir(path, 0777) != 0 && errno != EEXIST) {
            return cr_err_set(err, CR_ERR_IO, "%.150s: cannot make the folder: %s", path,
                              strerror(errno));
        }
    }
    snprintf(path, sizeof path, "%s/%s", place->dir, name);
    return cr_file_write_str(path, text, err);
}

enum cr_err cr_export_channels(struct cr_export *x, struct cr_error *err) {
    struct place place;
    place_of(x->path, &place);
    struct cr_form_sink sink = {put_file, &place};
    x->written = true;
    return x->form == CR_EXPORT_MME ? cr_form_mme(x->s->result, place.name, &sink, err)
                                    : cr_form_gnuplot(x->s->result, place.name, &sink, err);
}

enum cr_err cr_export_film(struct cr_export *x, struct cr_error *err) {
    return cr_form_cast(x->s->result, 100, 32, &x->text, err);
}

/* "every 10 ms" is said beside the file: a table has no place for it but its times */
enum cr_err cr_export_motion(struct cr_export *x, struct cr_error *err) {
    (void)err;
    enum cr_axes_of axes = (enum cr_axes_of)cr_cmd_word(x->call, "axes", CR_AXES_ISO);
    double step = cr_cmd_number(x->call, "every", 0.01);
    cr_form_motion(x->s->result, axes, step, &x->text);
    cr_say(x->s, "every %.4g ms, axes of %s", 1e3 * step,
           axes == CR_AXES_SAE ? "SAE J670" : "ISO 8855");
    return CR_ERR_OK;
}

enum cr_err cr_export_body(struct cr_export *x, struct cr_error *err) {
    const struct cr_scene *scene = &x->s->result->resolved;
    const char *id = cr_cmd_text(x->call, "of", x->s->view.selected);
    struct cr_body_voxels body;
    int found = -1;
    for (int i = 0; i < scene->n; i++) {
        bool vehicle = scene->part[i].kind == CR_KIND_VEHICLE;
        if (vehicle && (strcmp(scene->part[i].id, id) == 0 || (id[0] == '\0' && found < 0))) {
            found = i;
        }
    }
    if (found < 0) {
        cr_err_set(err, CR_ERR_NAME, "there is no vehicle '%.60s'", id);
        return CR_ERR_NAME;
    }
    enum cr_err code = cr_project_body(x->s->models, x->s->result, found, &body, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (x->form == CR_EXPORT_VTK) {
        cr_form_vtk(&body, &x->text);
    } else {
        code = cr_form_obj(&body, &x->text, err);
    }
    cr_body_voxels_fini(&body);
    return code;
}
