/* Writes the phases of a crash in the report, a line per contact. */
#include "render/picture.h"
#include "render/report.h"
#include "render/table.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>

enum { CONTACT_LINES = 12 };
static const struct {
    const char *head, *unit;
    int end; /* the column ends before this one; the first is left-aligned */
} phase_rows[] = {
    {"contact", "", 12},     {"plastic", "ms", 26}, {"elastic", "ms", 37},   {"stop", "", 48},
    {"closing", "km/h", 56}, {"e", "", 61},         {"impulse", "kN s", 69}, {"friction", "kJ", 78},
};
enum { PHASE_COLUMNS = sizeof phase_rows / sizeof phase_rows[0] };

static const char *const why_text[] = {
    [CR_STOP_NONE] = "still in contact when the solve ended",
    [CR_STOP_MOMENTUM] = "the approach momentum left is the elastic share",
    [CR_STOP_SEPARATION] = "the bodies part in the next slice",
    [CR_STOP_NO_OVERLAP] = "no more material meets in the slices to come",
    [CR_STOP_INTERRUPTED] = "by ^C, before a criterion was met",
};

static enum cr_err phase_line(const struct cr_page *page, enum cr_role role,
                              const char *const text[PHASE_COLUMNS], struct cr_error *err) {
    struct cr_cells c;
    enum cr_err code = cr_cells_new(page->width, 1, &c, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_cells_print(&c, 1, 0, phase_rows[0].end, role, text[0]);
    for (int i = 1; i < PHASE_COLUMNS; i++) {
        cr_cells_print_right(&c, phase_rows[i].end, 0,
                             phase_rows[i].end - phase_rows[i - 1].end - 1, role, text[i]);
    }
    return cr_page_emit(page, &c, err);
}

/* Writes two times in ms, "12.5 + 5.0"; a dash stands for a time that has not come. */
static void pair_of(double a, const char *between, double b, char *out, size_t size) {
    char one[24], two[24];
    cr_render_number(a * 1e3, 1, one, sizeof one);
    cr_render_number(b * 1e3, 1, two, sizeof two);
    snprintf(out, size, "%s%s%s", one, between, two);
}

/* Writes a number of a column in the unit that the column shows. */
static void put(const struct cr_page *page, int column, double x, int decimals, char out[64]) {
    cr_units_shown(page->result->units, phase_rows[column].unit, &x, &decimals);
    cr_render_number(x, decimals, out, 64);
}

static enum cr_err contact_line(const struct cr_page *page, const struct cr_contact *k,
                                struct cr_error *err) {
    const struct cr_scene *scene = &page->result->resolved;
    double t0 = cr_render_t_contact(page->result->solution);
    char text[PHASE_COLUMNS][64];
    const char *at[PHASE_COLUMNS];
    snprintf(text[0], sizeof text[0], "%.5s - %.5s", scene->part[k->a].id, scene->part[k->b].id);
    pair_of(k->t_begin - t0, "-", k->t_plastic_end - t0, text[1], sizeof text[1]);
    pair_of(k->t_elastic_end - k->t_plastic_end, " + ", k->t_end - k->t_elastic_end, text[2],
            sizeof text[2]);
    bool cut = k->stop == CR_STOP_INTERRUPTED; /* its word is longer than the column is wide */
    snprintf(text[3], sizeof text[3], "%s", cut ? "^C" : cr_stop_word(k->stop));
    put(page, 4, cr_kmh(k->closing), 1, text[4]);
    put(page, 5, k->restitution, 2, text[5]);
    put(page, 6, cr_vec2_len(k->impulse) * 1e-3, 2, text[6]);
    put(page, 7, k->friction * 1e-3, 1, text[7]);
    for (int i = 0; i < PHASE_COLUMNS; i++) {
        at[i] = text[i];
    }
    return phase_line(page, CR_ROLE_TEXT, at, err);
}

/* Explains the words of the stop criteria that were used. */
static enum cr_err stop_notes(const struct cr_page *page, struct cr_error *err) {
    const struct cr_solution *sol = page->result->solution;
    enum cr_err code = CR_ERR_OK;
    for (size_t w = 0; w < sizeof why_text / sizeof why_text[0] && code == CR_ERR_OK; w++) {
        bool used = false;
        for (int i = 0; i < sol->contacts; i++) {
            used |= (size_t)sol->contact[i].stop == w;
        }
        if (used) {
            char text[160];
            snprintf(text, sizeof text, "stop %s: %s", cr_stop_word((enum cr_stop)w), why_text[w]);
            code = cr_page_paragraph(page, 2, CR_ROLE_DIM, text, err);
        }
    }
    return code;
}

/* Tells how friction, restitution and elastic times follow from the contact if they are "auto". */
static enum cr_err auto_notes(const struct cr_page *page, struct cr_error *err) {
    const struct cr_settings *set = &page->result->resolved.set;
    const struct {
        bool on;
        const char *text;
    } note[] = {
        {set->restitution_auto, "e auto: from the closing speed, the kind of partner and the share "
                                "of an end's width that was pressed"},
        {set->friction_auto, "friction auto: 1.0 between vehicles, 0.13 on objects without one of "
                             "their own"},
        {set->elastic_auto, "elastic auto: from the force at the end of the plastic phase"},
    };
    enum cr_err code = CR_ERR_OK;
    for (size_t i = 0; i < sizeof note / sizeof *note && code == CR_ERR_OK; i++) {
        code = note[i].on ? cr_page_paragraph(page, 2, CR_ROLE_DIM, note[i].text, err) : code;
    }
    return code;
}

enum cr_err cr_page_phases(const struct cr_page *page, struct cr_error *err) {
    const struct cr_solution *sol = page->result->solution;
    const char *head[PHASE_COLUMNS], *unit[PHASE_COLUMNS];
    double most = 0;
    int hidden = 0;
    for (int i = 0; i < PHASE_COLUMNS; i++) {
        head[i] = phase_rows[i].head;
        unit[i] = cr_units_shown(page->result->units, phase_rows[i].unit, NULL, NULL);
    }
    for (int i = 0; i < sol->contacts; i++) {
        most = fmax(most, cr_vec2_len(sol->contact[i].impulse));
    }
    enum cr_err code = cr_page_heading(page, "Phases", "times after the first touch", err);
    code = code == CR_ERR_OK ? phase_line(page, CR_ROLE_TITLE, head, err) : code;
    code = code == CR_ERR_OK ? phase_line(page, CR_ROLE_DIM, unit, err) : code;
    for (int i = 0; i < sol->contacts && code == CR_ERR_OK; i++) {
        const struct cr_contact *k = &sol->contact[i];
        if (sol->contacts > CONTACT_LINES && cr_vec2_len(k->impulse) < 0.02 * most) {
            hidden++;
        } else {
            code = contact_line(page, k, err);
        }
    }
    if (hidden > 0 && code == CR_ERR_OK) {
        char text[96];
        snprintf(text, sizeof text, "and %d light contacts below 2 %% of the greatest impulse",
                 hidden);
        code = cr_page_paragraph(page, 2, CR_ROLE_DIM, text, err);
    }
    code = code == CR_ERR_OK ? stop_notes(page, err) : code;
    return code == CR_ERR_OK ? auto_notes(page, err) : code;
}
