/* crumple_svg: draws the picture of a result for the caller of the library. */
#include "lib/lib_priv.h"

#include "figure/figure.h"

#include <math.h>

enum { WIDTH = 500, MOST = 400, EDGE = 4 }; /* points */

static enum cr_err draw(const struct cr_result *r, double time, struct cr_str *out) {
    const struct cr_figure_plan plan = {
        .compiled = r->compiled,
        .scene = &r->resolved,
        .result = r,
        .view = {.field = CR_FIELD_EES,
                 .time = time,
                 .centre = {(double)NAN, (double)NAN},
                 .vectors = true,
                 .selected = -1},
    };
    const struct cr_figure_words english = {.say = NULL};
    double height;
    enum cr_err code = cr_figure_plan_height(&plan, WIDTH - 2 * EDGE, MOST, &height, NULL);
    if (code != CR_ERR_OK) {
        return code;
    }
    struct cr_canvas *canvas = cr_canvas_new(WIDTH, height + 2 * EDGE);
    if (canvas == NULL) {
        return CR_ERR_MEMORY;
    }
    const struct cr_box box = {EDGE, EDGE, WIDTH - 2 * EDGE, height};
    code = cr_figure_plan(canvas, box, &plan, &english, NULL);
    if (code == CR_ERR_OK) {
        code = cr_canvas_svg(canvas, r->resolved.name, false, out, NULL);
    }
    cr_canvas_free(canvas);
    return code;
}

char *crumple_svg(const crumple_result *result, double time, size_t *length) {
    struct cr_str out = {0};
    locale_t callers = uselocale(result->lib->c_locale);
    enum cr_err code = draw(result->result, time, &out);
    uselocale(callers);
    return cr_lib_text(code, &out, length);
}
