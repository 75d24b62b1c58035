/* Scale and place of the scene picture: where it lies on the screen, larger, smaller, moved. */
#include "tui/tui_priv.h"

#include "render/picture.h"

#include <stdio.h>

bool cr_rect_has(struct cr_rect r, int x, int y) {
    return x >= r.x && x < r.x + r.w && y >= r.y && y < r.y + r.h;
}

struct cr_rect cr_rect_inner(struct cr_rect r) {
    return r.w < 3 || r.h < 3 ? r : (struct cr_rect){r.x + 1, r.y + 1, r.w - 2, r.h - 2};
}

/* The picture as it is drawn; false when there is none. */
bool cr_scene_picture(struct cr_tui *t, struct cr_pic *pic) {
    struct cr_error err;
    struct cr_rect at = t->layout.pane[CR_AREA_SCENE];
    struct cr_scene_view view = cr_session_scene_view(t->session);
    const struct cr_scene *scene = cr_session_scene(t->session);
    const struct cr_result *result = NULL;
    const struct cr_compiled *compiled;
    if (at.w == 0 || scene->n == 0) {
        return false;
    }
    enum cr_solve_state state = cr_session_state(t->session);
    if (state == CR_STATE_SOLVED || state == CR_STATE_INTERRUPTED) {
        result = cr_session_result(t->session);
        compiled = result->compiled;
        scene = &result->resolved;
    } else {
        compiled = cr_session_compiled(t->session, &err);
        view.time = (double)NAN;
    }
    if (compiled == NULL || cr_pic_init(pic, compiled, scene, result, &view, &err) != CR_ERR_OK) {
        return false;
    }
    cr_pic_fit(pic, result, &view, cr_rect_inner(at));
    return true;
}

void cr_scene_zoom(struct cr_tui *t, int step) {
    static const double scales[] = {0.01, 0.02, 0.025, 0.05, 0.1, 0.2, 0.5, 1, 2, 5};
    enum { N = sizeof scales / sizeof *scales };
    struct cr_pic pic;
    char line[40];
    int i = 0;
    if (!cr_scene_picture(t, &pic)) {
        return;
    }
    while (i < N - 1 && scales[i] < pic.m_per_col * (1 - 1e-9)) {
        i++;
    }
    bool between = scales[i] > pic.m_per_col * (1 + 1e-9);
    i += step > 0 ? (between ? 0 : 1) : -1;
    i = i < 0 ? 0 : i >= N ? N - 1 : i;
    cr_pic_fini(&pic);
    snprintf(line, sizeof line, "show scale=%gm", scales[i]);
    cr_tui_run_key(t, line);
}

void cr_scene_pan(struct cr_tui *t, int key) {
    struct cr_pic pic;
    char line[80];
    if (!cr_scene_picture(t, &pic)) {
        return;
    }
    double dx = pic.at.w / 8.0 * pic.m_per_col, dy = pic.at.h / 4.0 * pic.m_per_col;
    double x = pic.centre.x + (key == 'h' ? -dx : key == 'l' ? dx : 0);
    double y = pic.centre.y + (key == 'j' ? -dy : key == 'k' ? dy : 0);
    cr_pic_fini(&pic);
    snprintf(line, sizeof line, "show centre=%.2f,%.2f", x, y);
    cr_tui_run_key(t, line);
}
