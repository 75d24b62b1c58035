/* Writes the crash in slow motion as an asciinema cast: frames of the picture in text. */
#include "figure/forms.h"

#include "render/picture.h"

#include <math.h>
#include <stdio.h>

static const double frame_s = 0.002, slow = 30, before_s = 0.02, hold_s = 2;

static void escape(struct cr_str *out, const char *s) {
    for (; *s != '\0'; s++) {
        unsigned char c = (unsigned char)*s;
        if (c == '\n') {
            cr_str_add(out, "\\r\\n");
        } else if (c == '"' || c == '\\') {
            cr_str_addf(out, "\\%c", c);
        } else if (c < 32) {
            cr_str_addf(out, "\\u%04x", c);
        } else {
            cr_str_addn(out, s, 1);
        }
    }
}

static enum cr_err frame(const struct cr_result *r, struct cr_cells *cells, double t, double shown,
                         struct cr_str *out, struct cr_error *err) {
    struct cr_look look = {.color = CR_COLOR_256};
    struct cr_scene_view view = {
        .field = CR_FIELD_EES, .time = t, .centre = {NAN, NAN}, .vectors = true, .selected = -1};
    struct cr_str text = {0};
    cr_cells_clear(cells);
    enum cr_err code =
        cr_render_scene(&(struct cr_target){cells, {0, 0, cells->w, cells->h - 1}, &look},
                        r->compiled, &r->resolved, r, &view, err);
    if (code == CR_ERR_OK) {
        char line[80];
        snprintf(line, sizeof line, "%+.0f ms, %gx slower", 1e3 * (t - r->solution->t_contact),
                 slow);
        cr_cells_print(cells, 0, cells->h - 1, cells->w, CR_ROLE_TEXT, line);
        cr_cells_text(cells, &look, &text);
        if (text.len > 0 && text.s[text.len - 1] == '\n') {
            text.s[text.len - 1] = '\0'; /* else the last line would scroll the first away */
        }
        cr_str_addf(out, "[%.3f, \"o\", \"\\u001b[H\\u001b[2J", shown);
        escape(out, cr_str_get(&text));
        cr_str_add(out, "\"]\n");
        out->failed |= text.failed;
    }
    cr_str_fini(&text);
    return code;
}

enum cr_err cr_form_cast(const struct cr_result *r, int w, int h, struct cr_str *out,
                         struct cr_error *err) {
    struct cr_cells cells;
    double t0 = fmax(r->solution->t_contact - before_s, 0);
    double t1 = cr_render_t_after(r->solution);
    enum cr_err code = cr_cells_new(w, h, &cells, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_str_addf(out, "{\"version\": 2, \"width\": %d, \"height\": %d, \"title\": \"", w, h);
    escape(out, r->resolved.name);
    cr_str_add(out, "\"}\n");
    int frames = (int)ceil((t1 - t0) / frame_s - 1e-9);
    for (int k = 0; k <= frames && code == CR_ERR_OK; k++) {
        double t = fmin(t0 + k * frame_s, t1);
        code = frame(r, &cells, t, k * frame_s * slow, out, err);
    }
    if (code == CR_ERR_OK) {
        cr_str_addf(out, "[%.3f, \"o\", \"\\r\\n\"]\n", frames * frame_s * slow + hold_s);
    }
    cr_cells_fini(&cells);
    return code;
}
