/* Writes the report of a run: pictures, pulses, table, phases, balance, assumptions, warnings. */
#include "render/picture.h"
#include "render/report.h"
#include "render/table.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH_LEAST = 60, WIDTH_MOST = 300, BESIDE = 158 };

/* ---- sections ---- */

/* Gives the answer first: EES and delta-v of each participant. */
static enum cr_err summary(const struct cr_page *page, struct cr_error *err) {
    const struct cr_result *r = page->result;
    struct cr_str text = {0};
    int body[CR_BODY_MAX] = {0};
    int n = cr_table_bodies(r, body);
    for (int i = 0; i < n; i++) {
        const struct cr_severity *of = &r->of[body[i]];
        cr_str_addf(&text, "%s%s", i > 0 ? "   " : "", r->resolved.part[body[i]].id);
        if (cr_result_grid(r, body[i])->nx > 0) {
            cr_str_addf(&text, "  EES %.1f km/h", cr_kmh(of->ees));
        }
        if (cr_result_moves(r, body[i])) {
            cr_str_addf(&text, "  delta-v %.1f km/h", cr_kmh(of->delta_v));
        }
    }
    page->out->failed = page->out->failed || text.failed;
    enum cr_err code = cr_page_paragraph(page, 0, CR_ROLE_TITLE, cr_str_get(&text), err);
    cr_str_fini(&text);
    return code;
}

static enum cr_err title(const struct cr_page *page, struct cr_error *err) {
    const struct cr_settings *set = &page->result->resolved.set;
    char note[160];
    snprintf(note, sizeof note, "method %s, dt %g ms, voxel %g mm",
             set->method == CR_METHOD_PAPER ? "paper" : "extended", set->dt * 1e3,
             set->voxel * 1e3);
    struct cr_cells c;
    enum cr_err code = cr_cells_new(page->width, 1, &c, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_cells_print(&c, 1, 0, page->width - 50, CR_ROLE_TITLE, page->result->resolved.name);
    cr_cells_print_right(&c, page->width - 1, 0, 48, CR_ROLE_DIM, note);
    code = cr_page_emit(page, &c, err);
    return code == CR_ERR_OK ? summary(page, err) : code;
}

struct shot {
    const char *name, *note;
    struct cr_scene_view view;
};

/* Draws n pictures beside each other, each with a heading. */
static enum cr_err strip(const struct cr_page *page, const struct shot *shot, int n, int rows,
                         struct cr_error *err) {
    const struct cr_result *r = page->result;
    struct cr_cells c;
    enum cr_err code = cr_cells_new(page->width, rows + 2, &c, err);
    int w = (page->width - 2 * (n - 1)) / n;
    for (int i = 0; i < n && code == CR_ERR_OK; i++) {
        int x = i * (w + 2);
        struct cr_target target = {&c, {x, 1, w, 1}, page->look};
        cr_page_draw_heading(&target, shot[i].name, shot[i].note);
        target.at = (struct cr_rect){x, 2, w, rows};
        code = cr_render_scene(&target, r->compiled, &r->resolved, r, &shot[i].view, err);
    }
    if (code != CR_ERR_OK) {
        cr_cells_fini(&c);
        return code;
    }
    return cr_page_emit(page, &c, err);
}

/* Shows where the bodies come to rest, with the ways they took. */
static enum cr_err rest_picture(const struct cr_page *page, struct cr_error *err) {
    const struct cr_solution *sol = page->result->solution;
    double end = sol->t[sol->samples - 1];
    struct cr_scene_view view = {
        .field = CR_FIELD_EES, .time = end, .centre = {NAN, NAN}, .vectors = true, .selected = -1};
    int rows = 0;
    enum cr_err code =
        cr_pic_frame(page->result, &view, page->width, page->width / 4 + 6, &rows, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    char note[80];
    snprintf(note, sizeof note, "%.2f s after the first touch", end - cr_render_t_contact(sol));
    struct shot shot = {"At rest", note, view};
    for (int i = 0; i < sol->bodies; i++) {
        if (cr_result_moves(page->result, i) && !isfinite(sol->body[i].t_rest)) {
            shot.name = "At the end, not all at rest";
        }
    }
    return strip(page, &shot, 1, rows, err);
}

static enum cr_err pictures(const struct cr_page *page, struct cr_error *err) {
    const struct cr_solution *sol = page->result->solution;
    double t0 = cr_render_t_contact(sol), t1 = cr_render_t_main(sol);
    /* "Before" shows the bodies 0.3 m apart, so that one sees where each of them ends. */
    double closing = sol->contacts > 0 ? sol->contact[0].closing : 0;
    double lead = closing > 1 ? fmin(0.3 / closing, t0) : 0;
    struct cr_scene_view view = {.field = CR_FIELD_EES,
                                 .time = t0 - lead,
                                 .centre = {NAN, NAN},
                                 .vectors = true,
                                 .selected = -1};
    int beside = page->width >= BESIDE ? 2 : 1, rows = 0;
    int width = (page->width - 2 * (beside - 1)) / beside;
    enum cr_err code = cr_pic_frame(page->result, &view, width, width / 4 + 6, &rows, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    char before[80], after[80];
    snprintf(before, sizeof before, "%.0f ms before the first touch", lead * 1e3);
    snprintf(after, sizeof after, "end of the %s, %.1f ms after the first touch",
             t1 < cr_render_t_after(sol) ? "main contact" : "contact", (t1 - t0) * 1e3);
    struct shot shot[2] = {{"Before", lead > 0 ? before : "at the first touch", view},
                           {"After", after, view}};
    shot[1].view.time = t1;
    for (int i = 0; i < 2 && code == CR_ERR_OK; i += beside) {
        code = strip(page, &shot[i], beside, rows, err);
    }
    bool rest = page->result->resolved.set.end == CR_END_REST && sol->samples > 0;
    return code == CR_ERR_OK && rest ? rest_picture(page, err) : code;
}

static enum cr_err pulses(const struct cr_page *page, struct cr_error *err) {
    struct cr_cells c;
    int rows = page->width >= 120 ? 20 : 15;
    enum cr_err code = cr_page_heading(page, "Pulse", "acceleration of the CG, CFC 60", err);
    if (code == CR_ERR_OK) {
        code = cr_cells_new(page->width, rows, &c, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_render_pulse(&(struct cr_target){&c, {1, 0, page->width - 2, rows}, page->look},
                           page->result, CR_QUANTITIES, NAN, err);
    if (code != CR_ERR_OK) {
        cr_cells_fini(&c);
        return code;
    }
    return cr_page_emit(page, &c, err);
}

static enum cr_err tables(const struct cr_page *page, struct cr_error *err) {
    int body[CR_BODY_MAX] = {0};
    int n = cr_table_bodies(page->result, body), most = cr_table_columns(page->width - 2);
    int rows = cr_render_table_rows(page->result);
    enum cr_err code = cr_page_heading(page, "Results", "", err);
    for (int i = 0; i < n && code == CR_ERR_OK; i += most) {
        struct cr_cells c;
        code = cr_cells_new(page->width, rows, &c, err);
        if (code == CR_ERR_OK) {
            cr_table_draw(&(struct cr_target){&c, {1, 0, page->width - 2, rows}, page->look},
                          page->result, NAN, body + i, n - i < most ? n - i : most);
            code = cr_page_emit(page, &c, err);
        }
    }
    return code;
}

/* Adds the table of impacts if there were several; of one impact the results tell all. */
static enum cr_err impacts(const struct cr_page *page, struct cr_error *err) {
    struct cr_cells c;
    if (page->result->impacts < 2) {
        return CR_ERR_OK;
    }
    int rows = cr_render_impacts_rows(page->result);
    enum cr_err code = cr_page_heading(page, "Impacts", "each by itself", err);
    code = code == CR_ERR_OK ? cr_cells_new(page->width, rows, &c, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_render_impacts(&c, (struct cr_rect){1, 0, page->width - 2, rows}, page->result);
    return cr_page_emit(page, &c, err);
}

static bool has_profile(const struct cr_result *r, int b) {
    return cr_result_grid(r, b)->nx > 0 && r->of[b].face < CR_FACES && r->of[b].deformation_max > 0;
}

static enum cr_err profile_line(const struct cr_page *page, int b, double most,
                                struct cr_error *err) {
    const struct cr_severity *of = &page->result->of[b];
    struct cr_cells c;
    enum cr_err code = cr_cells_new(page->width, 1, &c, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    char text[CR_NAME_MAX + 16];
    snprintf(text, sizeof text, "%s %s", page->result->resolved.part[b].id,
             cr_render_face(of->face));
    cr_cells_print(&c, 1, 0, 16, cr_render_role_of(b), text);
    for (int i = 0; i < CR_PROFILE; i++) {
        int level = (int)ceil(of->profile[i] / most * 8 - 1e-9);
        uint32_t bar = level < 1 ? ' ' : 0x2580u + (uint32_t)level;
        cr_cells_run(&c, 18 + 3 * i, 0, 3, cr_render_role_of(b),
                     page->look->ascii && level > 0 ? (uint8_t) " .:-=+*#@"[level] : bar);
        double x = of->profile[i];
        int decimals = 2;
        cr_units_shown(page->result->units, CR_SHOWN_DEPTH, &x, &decimals);
        cr_render_number(x, decimals, text, sizeof text);
        cr_cells_print_right(&c, 46 + 5 * i, 0, 5, CR_ROLE_TEXT, text);
    }
    return cr_page_emit(page, &c, err);
}

/* Tells C1..C6 as numbers and as a small bar each, all bars to one scale. */
static enum cr_err profiles(const struct cr_page *page, struct cr_error *err) {
    const struct cr_result *r = page->result;
    double most = 0;
    for (int b = 0; b < r->solution->bodies; b++) {
        for (int i = 0; has_profile(r, b) && i < CR_PROFILE; i++) {
            most = fmax(most, r->of[b].profile[i]);
        }
    }
    if (!(most > 0)) {
        return CR_ERR_OK;
    }
    char note[40];
    snprintf(note, sizeof note, "residual, C1 to C6, %s",
             cr_units_shown(r->units, CR_SHOWN_DEPTH, NULL, NULL));
    enum cr_err code = cr_page_heading(page, "Crush profile", note, err);
    for (int b = 0; b < r->solution->bodies && code == CR_ERR_OK; b++) {
        code = has_profile(r, b) ? profile_line(page, b, most, err) : CR_ERR_OK;
    }
    return code;
}

static enum cr_err bar_line(const struct cr_page *page, const char *label, double joule,
                            double whole, enum cr_role role, struct cr_error *err) {
    struct cr_cells c;
    enum cr_err code = cr_cells_new(page->width, 1, &c, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    char text[64];
    cr_cells_print(&c, 1, 0, 28, CR_ROLE_TEXT, label);
    cr_units_print(page->result->units, "kJ", joule * 1e-3, 1, text, sizeof text);
    cr_cells_print_right(&c, 40, 0, 14, CR_ROLE_TEXT, text);
    double share = whole > 0 ? cr_clamp(joule / whole, 0, 1) : 0;
    snprintf(text, sizeof text, "%.1f %%", share * 100);
    cr_cells_print_right(&c, 49, 0, 8, CR_ROLE_DIM, text);
    int room = page->width - 52;
    int n = (int)lround(share * (room > 60 ? 60 : room));
    cr_cells_run(&c, 51, 0, n, role, page->look->ascii ? '=' : 0x25A0);
    return cr_page_emit(page, &c, err);
}

static enum cr_err balance(const struct cr_page *page, struct cr_error *err) {
    const struct cr_balance *b = &page->result->solution->balance;
    const struct {
        const char *label;
        double joule;
        enum cr_role role;
    } rows[] = {
        {"kinetic energy before", b->kinetic_before, CR_ROLE_REFERENCE},
        {"  kinetic energy after", b->kinetic_after, CR_ROLE_REFERENCE},
        {"  deformation", b->plastic, CR_ROLE_BAD},
        {"  friction between bodies", b->friction, CR_ROLE_WARN},
        {"  tyres", b->tyre, CR_ROLE_DIM},
    };
    enum cr_err code = cr_page_heading(page, "Balance", "", err);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0] && code == CR_ERR_OK; i++) {
        code = bar_line(page, rows[i].label, rows[i].joule, b->kinetic_before, rows[i].role, err);
    }
    if (code == CR_ERR_OK) {
        char text[200];
        snprintf(text, sizeof text,
                 "left over, relative: energy %.1e, momentum %.1e, angular momentum %.1e",
                 b->energy_residual, b->momentum_residual, b->angular_residual);
        code = cr_page_paragraph(page, 2, CR_ROLE_DIM, text, err);
    }
    return code;
}

static enum cr_err lines_of(const struct cr_page *page, const char *line, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    while (*line != '\0' && code == CR_ERR_OK) {
        char one[1024];
        size_t n = strcspn(line, "\n");
        snprintf(one, sizeof one, "%.*s", (int)n, line);
        code = cr_page_paragraph(page, 3, CR_ROLE_TEXT, one, err);
        line += n + (line[n] == '\n');
    }
    return code;
}

static enum cr_err notes(const struct cr_page *page, struct cr_error *err) {
    const struct cr_result *r = page->result;
    enum cr_err code = CR_ERR_OK;
    if (r->assumed.n > 0) {
        struct cr_str text = {0};
        cr_render_assumed(r, &text);
        page->out->failed = page->out->failed || text.failed;
        code = cr_page_heading(page, "Assumed", "not given in the scene: from type and mass", err);
        code = code == CR_ERR_OK ? lines_of(page, cr_str_get(&text), err) : code;
        cr_str_fini(&text);
    }
    if (r->warnings > 0 && code == CR_ERR_OK) {
        code = cr_page_heading(page, "Warnings", "", err);
    }
    for (int i = 0; i < r->warnings && code == CR_ERR_OK; i++) {
        char text[220];
        snprintf(text, sizeof text, "! %s", r->warning[i]);
        code = cr_page_paragraph(page, 2, CR_ROLE_WARN, text, err);
    }
    return code;
}

static enum cr_err robust(const struct cr_page *page, struct cr_error *err) {
    struct cr_str text = {0};
    if (page->result->robust == NULL) {
        return CR_ERR_OK;
    }
    cr_render_robust(page->result, &text);
    page->out->failed = page->out->failed || text.failed;
    enum cr_err code = cr_page_heading(page, "Robustness", "what hangs on chance", err);
    code = code == CR_ERR_OK ? lines_of(page, cr_str_get(&text), err) : code;
    cr_str_fini(&text);
    return code;
}

typedef enum cr_err (*section)(const struct cr_page *page, struct cr_error *err);

static enum cr_err write_all(const struct cr_page *page, const section *of, size_t n,
                             struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (size_t i = 0; i < n && code == CR_ERR_OK; i++) {
        code = of[i](page, err);
    }
    return code;
}

/* The columns of a line of text without its escape sequences; *len gets its bytes, *next the line
 * after it. */
static int line_width(const char *line, size_t *len, const char **next) {
    int width = 0;
    const char *s = line;
    while (*s != '\0' && *s != '\n') {
        if (*s == '\033') {
            s += strcspn(s, "m");
            s += *s == 'm';
        } else {
            width += cr_glyph_columns(cr_glyph_next(&s));
        }
    }
    *len = (size_t)(s - line);
    *next = s + (*s == '\n');
    return width;
}

/* Adds two texts beside each other, the right one from the column on. */
static void join(struct cr_str *out, const char *left, const char *right, int column) {
    while (*left != '\0' || *right != '\0') {
        size_t len;
        const char *line = left;
        int width = line_width(line, &len, &left);
        cr_str_addn(out, line, len);
        line = right;
        line_width(line, &len, &right);
        if (len > 0) {
            cr_str_fill(out, ' ', column - width);
            cr_str_addn(out, line, len);
        }
        cr_str_add(out, "\n");
    }
}

static const section right_column[] = {impacts, profiles, cr_page_phases, balance, robust, notes};
enum { RIGHTS = sizeof right_column / sizeof right_column[0] };

/* Adds the table and, beside it on a wide page, else below it, the other sections. */
static enum cr_err tables_and_rest(const struct cr_page *page, struct cr_error *err) {
    if (page->width < BESIDE) {
        enum cr_err code = tables(page, err);
        return code == CR_ERR_OK ? write_all(page, right_column, RIGHTS, err) : code;
    }
    struct cr_str text[2] = {{0}, {0}};
    struct cr_page half = *page;
    half.width = (page->width - 2) / 2;
    half.out = &text[0];
    enum cr_err code = tables(&half, err);
    if (code == CR_ERR_OK) {
        half.out = &text[1];
        code = write_all(&half, right_column, RIGHTS, err);
    }
    page->out->failed = page->out->failed || text[0].failed || text[1].failed;
    if (code == CR_ERR_OK) {
        join(page->out, cr_str_get(&text[0]), cr_str_get(&text[1]), half.width + 2);
    }
    cr_str_fini(&text[0]);
    cr_str_fini(&text[1]);
    return code;
}

enum cr_err cr_render_report(const struct cr_result *result, const struct cr_look *look, int width,
                             struct cr_str *out, struct cr_error *err) {
    static const section all[] = {title, pictures, pulses, tables_and_rest};
    width = width < WIDTH_LEAST ? WIDTH_LEAST : width > WIDTH_MOST ? WIDTH_MOST : width;
    const struct cr_page page = {result, look, width, out};
    enum cr_err code = write_all(&page, all, sizeof all / sizeof all[0], err);
    if (code == CR_ERR_OK && out->failed) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the report");
    }
    return code;
}
