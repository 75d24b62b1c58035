/* `crumple run --picture`: pictures of the crash that was solved, each into a file of its own. */
#include "cli/pictures.h"

#include "figure/pictures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* "WHAT=FILE" or "FILE": what is drawn, when, of whom, and where it goes */
struct wanted {
    enum cr_picture picture;
    double ms; /* after first contact; NaN: as the picture says */
    const char *file;
};

static enum cr_err unknown(const char *word, struct cr_error *err) {
    const char *known[CR_PICTURES];
    for (int i = 0; i < CR_PICTURES; i++) {
        known[i] = cr_picture_word((enum cr_picture)i);
    }
    const char *near = cr_str_nearest(word, known, CR_PICTURES);
    cr_err_set(err, CR_ERR_USAGE, "--picture: there is no picture '%.60s'", word);
    if (near != NULL) {
        cr_err_hint(err, "did you mean %s=FILE?", near);
    } else {
        cr_err_hint(err, "before, contact, engagement, after, 40ms, pulse, energy, damage, side, "
                         "top, front, risk or overview");
    }
    return CR_ERR_USAGE;
}

static enum cr_err read_wanted(const char *value, struct wanted *out, struct cr_error *err) {
    const char *equals = strchr(value, '=');
    *out = (struct wanted){CR_PICTURE_OVERVIEW, NAN, equals != NULL ? equals + 1 : value};
    if (equals != NULL) {
        char word[64], *end;
        snprintf(word, sizeof word, "%.*s", (int)(equals - value), value);
        int found = cr_picture_find(word);
        double ms = strtod(word, &end);
        if (found >= 0) {
            out->picture = (enum cr_picture)found;
        } else if (end != word && strcmp(end, "ms") == 0 && fabs(ms) < 6e4) {
            out->picture = CR_PICTURE_SCENE;
            out->ms = ms;
        } else {
            return unknown(word, err);
        }
    }
    return cr_picture_may_write(out->file, err);
}

enum cr_err cr_cli_check_pictures(const struct cr_option_values *pictures, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < pictures->n && code == CR_ERR_OK; i++) {
        struct wanted w;
        code = read_wanted(pictures->value[i], &w, err);
    }
    return code;
}

static enum cr_err draw(const struct wanted *w, const struct cr_result *result,
                        const struct cr_context *ctx, struct cr_error *err) {
    struct cr_picture_source source = {
        .result = result,
        .models = ctx->models,
        .irf = ctx->irf,
        .view = {.field = CR_FIELD_EES,
                 .time = isnan(w->ms) ? (double)NAN : result->solution->t_contact + 1e-3 * w->ms,
                 .centre = {NAN, NAN},
                 .vectors = true,
                 .selected = -1},
        .body = -1,
        .quantity = CR_QUANTITIES};
    struct cr_canvas *canvas;
    enum cr_err code = cr_picture_draw(w->picture, &source, &canvas, err);
    return code == CR_ERR_OK ? cr_picture_write(canvas, w->file, result->resolved.name, err) : code;
}

enum cr_err cr_cli_pictures(const struct cr_option_values *pictures, const struct cr_result *result,
                            const struct cr_context *ctx, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < pictures->n && code == CR_ERR_OK; i++) {
        struct wanted w;
        code = read_wanted(pictures->value[i], &w, err);
        if (code == CR_ERR_OK) {
            code = draw(&w, result, ctx, err);
        }
    }
    return code;
}
