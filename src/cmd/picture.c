/* Pictures and plots of a session, drawn into cells and handed to its output. */
#include "cmd/cmd_priv.h"

#include <stdlib.h>
#include <string.h>

enum cr_err cr_cmd_picture(struct cr_session *s, int width, int height,
                           enum cr_err (*draw)(void *user, struct cr_cells *cells,
                                               struct cr_rect at, struct cr_error *err),
                           void *user, struct cr_error *err) {
    struct cr_cells cells;
    if (s->opts.out.cells == NULL) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_cells_new(width, height, &cells, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = draw(user, &cells, (struct cr_rect){0, 0, width, height}, err);
    if (code == CR_ERR_OK && !s->opts.out.cells(s->opts.out.user, &cells, &s->opts.look)) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the picture");
    }
    cr_cells_fini(&cells);
    return code;
}

enum cr_err cr_cmd_picture_text(struct cr_session *s, int width, int height,
                                enum cr_err (*draw)(void *user, struct cr_cells *cells,
                                                    struct cr_rect at, struct cr_error *err),
                                void *user, struct cr_error *err) {
    struct cr_cells cells;
    struct cr_str text = {0};
    const struct cr_look look = s->opts.look;
    enum cr_err code = cr_cells_new(width, height, &cells, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    s->opts.look.color = CR_COLOR_NONE; /* lines of an answer have one colour: shades */
    code = draw(user, &cells, (struct cr_rect){0, 0, width, height}, err);
    if (code == CR_ERR_OK) {
        cr_cells_text(&cells, &s->opts.look, &text);
    }
    if (text.failed) { /* half a picture would pass for a whole one */
        code = cr_err_set(err, CR_ERR_MEMORY, "out of memory");
        cr_str_clear(&text);
    }
    s->opts.look = look;
    for (char *p = text.s, *end; p != NULL && (end = strchr(p, '\n')) != NULL; p = end + 1) {
        *end = '\0';
        cr_session_text(s, CR_TONE_ANSWER, p);
    }
    cr_str_fini(&text);
    cr_cells_fini(&cells);
    return code;
}

struct plot_job {
    const struct cr_session *s;
    const struct cr_plot *plot;
};

static enum cr_err draw(void *user, struct cr_cells *cells, struct cr_rect at,
                        struct cr_error *err) {
    const struct plot_job *job = user;
    return cr_render_plot(cells, at, &job->s->opts.look, job->plot, err);
}

enum cr_err cr_cmd_plot(struct cr_session *s, const struct cr_plot *plot, int lines,
                        struct cr_error *err) {
    struct plot_job job = {s, plot};
    int w, h;
    cr_session_room(s, &w, &h);
    return cr_cmd_picture(s, w, h - lines > 10 ? h - lines : 10, draw, &job, err);
}
