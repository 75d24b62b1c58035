/* Gathers the data that each picture of a crash shows, draws it, and writes its file. */
#include "figure/pictures.h"

#include "base/file.h"
#include "base/vec.h"
#include "render/picture.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { WIDTH = 500, MARGIN = 10, INNER = WIDTH - 2 * MARGIN, PLOT_H = 240, MOST_H = 460 };
enum { RISK_POINTS = 81, RISK_MOST = 3 };
static const double png_dpi = 144;

static const struct {
    const char *word;
    bool result;
} pictures[CR_PICTURES] = {
#define X(name, word, result, help) {word, result},
    CR_PICTURE_LIST(X)
#undef X
};

const char *cr_picture_word(enum cr_picture picture) {
    return pictures[picture].word;
}

int cr_picture_find(const char *word) {
    for (int i = 0; i < CR_PICTURES; i++) {
        if (strcmp(pictures[i].word, word) == 0) {
            return i;
        }
    }
    return -1;
}

int cr_picture_format_of(const char *path) {
    static const char *const suffix[CR_PICTURE_FORMATS] = {".svg", ".pdf", ".png"};
    size_t n = strlen(path);
    for (int i = 0; i < CR_PICTURE_FORMATS; i++) {
        if (n > 4 && strcasecmp(path + n - 4, suffix[i]) == 0) {
            return i;
        }
    }
    return -1;
}

static const char *say(const struct cr_picture_source *s, const char *english) {
    return s->words.say != NULL ? s->words.say(english) : english;
}

static enum cr_err new_canvas(double h, struct cr_canvas **out, struct cr_error *err) {
    *out = cr_canvas_new(WIDTH, h + 2 * MARGIN);
    return *out != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "no memory for the picture");
}

static struct cr_box box(double h) {
    return (struct cr_box){MARGIN, MARGIN, INNER, h};
}

/* ---- the scene ---- */

/* The time of greatest engagement, s: the end of the plastic phase of the contact with the greatest
 * impulse. */
static double engaged(const struct cr_solution *sol) {
    double most = -1, t = cr_render_t_contact(sol);
    for (int i = 0; i < sol->contacts; i++) {
        double impulse = cr_vec2_len(sol->contact[i].impulse);
        if (impulse > most && isfinite(sol->contact[i].t_plastic_end)) {
            most = impulse;
            t = sol->contact[i].t_plastic_end;
        }
    }
    return t;
}

/* The time that a picture of the scene shows, s; NaN: after the crash. */
static double time_of(enum cr_picture picture, const struct cr_result *result, double otherwise) {
    switch (picture) {
    case CR_PICTURE_BEFORE:
        return 0;
    case CR_PICTURE_CONTACT:
        return cr_render_t_contact(result->solution);
    case CR_PICTURE_ENGAGED:
        return engaged(result->solution);
    case CR_PICTURE_AFTER:
        return NAN;
    default:
        return otherwise;
    }
}

/* Writes "After: 165.5 ms after first contact" in the words of the source. */
static void title_of(const struct cr_picture_source *s, double time, char *buf, int size) {
    if (s->result == NULL || s->result->solution->samples == 0) {
        snprintf(buf, (size_t)size, "%s", say(s, "The scene"));
        return;
    }
    const struct cr_solution *sol = s->result->solution;
    double after = cr_render_t_after(sol), contact = cr_render_t_contact(sol);
    double t = isnan(time) ? after : time, ms = 1e3 * (t - contact);
    if (ms < 0) {
        snprintf(buf, (size_t)size, "%s: %.0f ms %s", say(s, "Before"), -ms,
                 say(s, "before first contact"));
        return;
    }
    const char *what = ms == 0             ? "First contact"
                       : t >= after        ? "After"
                       : t == engaged(sol) ? "Greatest engagement"
                                           : "In the crash";
    if (ms == 0) {
        snprintf(buf, (size_t)size, "%s", say(s, what));
    } else {
        snprintf(buf, (size_t)size, "%s: %.1f ms %s", say(s, what), ms,
                 say(s, "after first contact"));
    }
}

enum { TITLE = CR_NAME_MAX + 160 };

/* The scene at a time; its title is written into buf. */
static struct cr_figure_plan plan_of(const struct cr_picture_source *s, double time,
                                     char buf[TITLE]) {
    const struct cr_result *r = s->result;
    struct cr_figure_plan p = {.compiled = r != NULL ? r->compiled : s->compiled,
                               .scene = r != NULL ? &r->resolved : s->scene,
                               .result = r,
                               .view = s->view,
                               .title = buf};
    p.view.time = time;
    title_of(s, time, buf, TITLE);
    return p;
}

static enum cr_err plan(const struct cr_picture_source *s, double time, struct cr_canvas **out,
                        struct cr_error *err) {
    char title[TITLE];
    struct cr_figure_plan p = plan_of(s, time, title);
    double h;
    enum cr_err code = cr_figure_plan_height(&p, INNER, MOST_H, &h, err);
    if (code == CR_ERR_OK) {
        code = new_canvas(h, out, err);
    }
    return code != CR_ERR_OK ? code : cr_figure_plan(*out, box(h), &p, &s->words, err);
}

/* ---- plots ---- */

static enum cr_err plot(const struct cr_picture_source *s, bool energy, struct cr_canvas **out,
                        struct cr_error *err) {
    struct cr_plot_made made;
    enum cr_err code = energy ? cr_plot_energy(s->result, NAN, &made, err)
                              : cr_plot_pulse(s->result, s->quantity, NAN, &made, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = new_canvas(PLOT_H, out, err);
    if (code == CR_ERR_OK) {
        cr_figure_plot(*out, box(PLOT_H), &made.plot, &s->words);
    }
    cr_plot_made_fini(&made);
    return code;
}

/* ---- one vehicle ---- */

static enum cr_err vehicle_of(const struct cr_picture_source *s, int *body, struct cr_error *err) {
    const struct cr_scene *scene = &s->result->resolved;
    for (int i = 0; i < scene->n; i++) {
        if (scene->part[i].kind == CR_KIND_VEHICLE && (s->body < 0 || s->body == i)) {
            *body = i;
            return CR_ERR_OK;
        }
    }
    if (s->body >= 0 && s->body < scene->n) {
        cr_err_set(err, CR_ERR_NAME, "%s is an object, the picture is of a vehicle",
                   scene->part[s->body].id);
        return CR_ERR_NAME;
    }
    return cr_err_set(err, CR_ERR_MISSING, "there is no vehicle in the scene");
}

void cr_picture_profile_span(const struct cr_result *r, int body, double *from, double *to) {
    const struct cr_severity *of = &r->of[body];
    const struct cr_grid *g = cr_result_grid(r, body);
    struct cr_vec2 centre = cr_vec2(g->x0 + g->nx * g->h / 2, g->y0 + g->ny * g->h / 2);
    double middle =
        cr_face_is_end(of->face) ? centre.y - of->profile_middle : of->profile_middle - centre.x;
    *from = middle - 0.5 * of->profile_width;
    *to = middle + 0.5 * of->profile_width;
}

static enum cr_err damage(const struct cr_picture_source *s, struct cr_canvas **out,
                          struct cr_error *err) {
    static const char *const faces[CR_FACES] = {"front", "left side", "rear", "right side"};
    int body = 0;
    enum cr_err code = vehicle_of(s, &body, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_severity *of = &s->result->of[body];
    const struct cr_participant *part = &s->result->resolved.part[body];
    const struct cr_grid *g = cr_result_grid(s->result, body);
    struct cr_damage_plan p = {.id = part->id,
                               .face = of->face,
                               .length = g->nx * g->h,
                               .width = g->ny * g->h,
                               .stations = CR_PROFILE,
                               .depth = of->profile,
                               .outline_n = of->outline_n,
                               .outline = of->outline};
    char title[CR_NAME_MAX + 120];
    p.centre = cr_vec2(g->x0 + p.length / 2, g->y0 + p.width / 2);
    cr_picture_profile_span(s->result, body, &p.from, &p.to);
    if (s->measured != NULL && s->measured->face == of->face) {
        p.measured = s->measured->n;
        p.measured_depth = s->measured->depth;
        p.measured_from = s->measured->from;
        p.measured_to = s->measured->to;
    }
    snprintf(title, sizeof title, "%s: %s, %s", part->id, say(s, faces[of->face]),
             say(s, "residual crush C1 to C6"));
    p.title = title;
    code = new_canvas(300, out, err);
    if (code == CR_ERR_OK) {
        cr_figure_damage(*out, box(300), &p, &s->words);
    }
    return code;
}

static enum cr_err model(const struct cr_picture_source *s, enum cr_project view,
                         struct cr_canvas **out, struct cr_error *err) {
    struct cr_body_voxels v;
    int body = 0;
    enum cr_err code = vehicle_of(s, &body, err);
    if (code == CR_ERR_OK) {
        code = cr_project_body(s->models, s->result, body, &v, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    v.projection.view = view;
    double h = cr_figure_body_height(&v.projection, INNER, MOST_H);
    code = new_canvas(h, out, err);
    if (code == CR_ERR_OK) {
        code = cr_figure_body(*out, box(h), &v.projection, &s->words, err);
    }
    cr_body_voxels_fini(&v);
    return code;
}

/* ---- risk ---- */

struct risk_curves {
    double x[RISK_POINTS], y[RISK_MOST][RISK_POINTS]; /* delta-v, km/h; risk, % */
    struct cr_curve_line line[RISK_MOST];
    char name[RISK_MOST][CR_NAME_MAX];
};

static void risk_line(const struct cr_picture_source *s, int body, int k, struct risk_curves *c) {
    static const enum cr_role roles[RISK_MOST] = {CR_ROLE_A, CR_ROLE_B, CR_ROLE_C};
    struct cr_severity at;
    for (int i = 0; i < RISK_POINTS; i++) {
        cr_result_risk(s->result, s->irf, body, cr_mps(c->x[i]), &at);
        c->y[k][i] = k < at.injuries ? 100 * at.injury[k].probability : (double)NAN;
        if (k < at.injuries) {
            snprintf(c->name[k], sizeof c->name[k], "%s", at.injury[k].title);
        }
    }
    c->line[k] = (struct cr_curve_line){.x = c->x,
                                        .y = c->y[k],
                                        .n = RISK_POINTS,
                                        .mark = (char)('1' + k),
                                        .name = c->name[k],
                                        .role = roles[k]};
}

static enum cr_err risk(const struct cr_picture_source *s, struct cr_canvas **out,
                        struct cr_error *err) {
    struct risk_curves c;
    char title[CR_NAME_MAX + 160];
    int body = 0, n = 0;
    enum cr_err code = vehicle_of(s, &body, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_severity *own = &s->result->of[body];
    double dv = cr_kmh(own->delta_v), top = fmax(80, 10 * ceil(1.2 * dv / 10));
    for (int i = 0; i < RISK_POINTS; i++) {
        c.x[i] = top * i / (RISK_POINTS - 1);
    }
    for (; n < own->injuries && n < RISK_MOST; n++) {
        risk_line(s, body, n, &c);
    }
    if (n == 0) {
        cr_err_set(err, CR_ERR_MISSING, "no injury risk function fits the crash of %s",
                   s->result->resolved.part[body].id);
        return CR_ERR_MISSING;
    }
    double per = 1;
    char x_unit[32];
    const char *unit = cr_units_shown(s->result->units, "km/h", &per, NULL);
    for (int i = 0; i < RISK_POINTS; i++) {
        c.x[i] *= per;
    }
    dv *= per;
    snprintf(x_unit, sizeof x_unit, "delta-v, %s", unit);
    snprintf(title, sizeof title, "%s: %s, %%; delta-v %.1f %s", s->result->resolved.part[body].id,
             say(s, "injury risk"), dv, unit);
    struct cr_plot p = {
        .title = title, .x_unit = x_unit, .curves = n, .curve = c.line, .cursor = dv};
    code = new_canvas(PLOT_H, out, err);
    if (code == CR_ERR_OK) {
        cr_figure_plot(*out, box(PLOT_H), &p, &s->words);
    }
    return code;
}

/* ---- one sheet ---- */

static enum cr_err overview(const struct cr_picture_source *s, struct cr_canvas **out,
                            struct cr_error *err) {
    enum { GAP = 20, HEAD = 24 };
    char title[2][TITLE];
    struct cr_plot_made made;
    double h = 300;
    const struct cr_figure_plan before = plan_of(s, 0, title[0]), after = plan_of(s, NAN, title[1]);
    struct cr_figure_plan p = before;
    p.view.time = s->view.time;
    enum cr_err code = cr_figure_plan_height(&p, INNER, 400, &h, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    *out = cr_canvas_new(2 * INNER + GAP + 2 * MARGIN, HEAD + h + GAP + PLOT_H + 2 * MARGIN);
    if (*out == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the picture");
    }
    struct cr_type_face face = {.size = 13, .ink = 0x1a1a1a, .bold = true};
    cr_canvas_text(*out, MARGIN, MARGIN + 13, &face, s->result->resolved.name);
    struct cr_box left = {MARGIN, MARGIN + HEAD, INNER, h}, right = left;
    right.x += INNER + GAP;
    code = cr_figure_plan(*out, left, &before, &s->words, err);
    code = code != CR_ERR_OK ? code : cr_figure_plan(*out, right, &after, &s->words, err);
    left.y = right.y = left.y + h + GAP;
    left.h = right.h = PLOT_H;
    for (int i = 0; i < 2 && code == CR_ERR_OK; i++) {
        code = i == 0 ? cr_plot_pulse(s->result, s->quantity, NAN, &made, err)
                      : cr_plot_energy(s->result, NAN, &made, err);
        if (code == CR_ERR_OK) {
            cr_figure_plot(*out, i == 0 ? left : right, &made.plot, &s->words);
            cr_plot_made_fini(&made);
        }
    }
    return code;
}

enum cr_err cr_picture_draw(enum cr_picture picture, const struct cr_picture_source *source,
                            struct cr_canvas **out, struct cr_error *err) {
    struct cr_picture_source in_units = *source;
    const struct cr_picture_source *s = &in_units;
    in_units.words.units = s->result != NULL ? s->result->units : source->words.units;
    *out = NULL;
    if (pictures[picture].result && s->result == NULL) {
        cr_err_set(err, CR_ERR_MISSING, "nothing has been solved yet");
        cr_err_hint(err, "try: solve");
        return CR_ERR_MISSING;
    }
    enum cr_err code;
    switch (picture) {
    case CR_PICTURE_PULSE:
    case CR_PICTURE_ENERGY:
        code = plot(s, picture == CR_PICTURE_ENERGY, out, err);
        break;
    case CR_PICTURE_DAMAGE:
        code = damage(s, out, err);
        break;
    case CR_PICTURE_SIDE:
    case CR_PICTURE_TOP:
    case CR_PICTURE_FRONT:
        code = model(s, (enum cr_project)(CR_PROJECT_SIDE + (picture - CR_PICTURE_SIDE)), out, err);
        break;
    case CR_PICTURE_RISK:
        code = risk(s, out, err);
        break;
    case CR_PICTURE_OVERVIEW:
        code = overview(s, out, err);
        break;
    default:
        code = plan(s, time_of(picture, s->result, s->view.time), out, err);
    }
    if (code != CR_ERR_OK) {
        cr_canvas_free(*out);
        *out = NULL;
    }
    return code;
}

enum cr_err cr_picture_text(struct cr_canvas *canvas, enum cr_picture_format format,
                            const char *title, struct cr_str *out, struct cr_error *err) {
    struct cr_pdf_about about = {.title = title};
    switch (format) {
    case CR_FORMAT_PDF:
        return cr_canvas_pdf(&canvas, 1, &about, out, err);
    case CR_FORMAT_PNG:
        return cr_canvas_png(canvas, png_dpi, out, err);
    default:
        return cr_canvas_svg(canvas, title, true, out, err);
    }
}

enum cr_err cr_picture_may_write(const char *path, struct cr_error *err) {
    int format = cr_picture_format_of(path);
    if (format < 0) {
        cr_err_set(err, CR_ERR_USAGE, "a picture ends in .svg, .pdf or .png, not as %.150s", path);
        cr_err_hint(err, "for example crash.svg");
        return CR_ERR_USAGE;
    }
    return format == CR_FORMAT_SVG ? CR_ERR_OK : cr_canvas_need_cairo(err);
}

enum cr_err cr_picture_write(struct cr_canvas *canvas, const char *path, const char *title,
                             struct cr_error *err) {
    struct cr_str text = {0};
    enum cr_err code = cr_picture_may_write(path, err);
    if (code == CR_ERR_OK && canvas == NULL) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the picture");
    }
    if (code == CR_ERR_OK) {
        code = cr_picture_text(canvas, (enum cr_picture_format)cr_picture_format_of(path), title,
                               &text, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_file_write_str(path, &text, err);
    }
    cr_canvas_free(canvas);
    cr_str_fini(&text);
    return code;
}
