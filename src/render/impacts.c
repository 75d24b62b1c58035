/* Draws the table of impacts: what each blow did to either participant, a line each. */
#include "render/picture.h"
#include "render/table.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ID = 10 };

struct hit {
    const struct cr_severity *of;
    bool deforms;
};

/* ---- columns, in the order in which they are left out from the right where room is scarce ---- */

#define OF(name, expression)                                                                       \
    static double name(const struct hit *h) {                                                      \
        return expression;                                                                         \
    }
OF(get_delta_v, cr_kmh(h->of->delta_v))
OF(get_ees, h->deforms ? cr_kmh(h->of->ees) : (double)NAN)
OF(get_pdof, h->deforms ? cr_bearing_deg(h->of->pdof) : (double)NAN)
OF(get_peak, h->deforms ? h->of->acceleration_max / CR_G : (double)NAN)
OF(get_pulse, h->deforms ? h->of->pulse * 1e3 : (double)NAN)
OF(get_depth, h->deforms ? h->of->face_depth : (double)NAN)
OF(get_yaw, cr_deg(h->of->yaw_rate_change))
OF(get_mean, h->deforms ? h->of->acceleration_mean / CR_G : (double)NAN)
OF(get_energy, h->deforms ? h->of->energy * 1e-3 : (double)NAN)
#undef OF

static void put_cdc(const struct hit *h, char *buf, int size) {
    snprintf(buf, (size_t)size, "%s", h->deforms && h->of->cdc[0] != '\0' ? h->of->cdc : "-");
}

static void put_face(const struct hit *h, char *buf, int size) {
    snprintf(buf, (size_t)size, "%s", h->deforms ? cr_render_face(h->of->face) : "-");
}

static const struct {
    const char *head, *unit;
    int width, decimals;
    double (*number)(const struct hit *h);
    void (*text)(const struct hit *h, char *buf, int size);
} columns[] = {
    {"delta-v", "km/h", 8, 1, get_delta_v, NULL}, {"EES", "km/h", 6, 1, get_ees, NULL},
    {"PDOF", "deg", 5, 0, get_pdof, NULL},        {"CDC", "", 8, 0, NULL, put_cdc},
    {"peak", "g", 6, 1, get_peak, NULL},          {"pulse", "ms", 7, 1, get_pulse, NULL},
    {"face", "", 6, 0, NULL, put_face},           {"depth", CR_SHOWN_DEPTH, 6, 2, get_depth, NULL},
    {"yaw", "deg/s", 7, 1, get_yaw, NULL},        {"mean", "g", 5, 1, get_mean, NULL},
    {"energy", "kJ", 7, 1, get_energy, NULL},
};

/* The place where a table goes on. */
struct pen {
    struct cr_cells *cells;
    struct cr_rect at;
    int y;
    enum cr_units units;
};

/* Writes words with numbers in them, which are told in the units of the table. */
static void write_words(struct pen *p, int indent, enum cr_role role, const char *text) {
    struct cr_str shown = {0};
    cr_units_text(p->units, text, &shown);
    p->cells->failed = p->cells->failed || shown.failed;
    cr_cells_print(p->cells, p->at.x + indent, p->y++, p->at.w - indent, role, cr_str_get(&shown));
    cr_str_fini(&shown);
}

static bool full(const struct pen *p) {
    return p->y >= p->at.y + p->at.h;
}

/* Writes the values of a hit; for hit NULL the heads of the columns, or their units. */
static void write_columns(struct pen *p, enum cr_role role, const struct hit *hit, bool units) {
    int x = p->at.x + ID;
    for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++) {
        char text[32];
        x += columns[i].width;
        if (x > p->at.x + p->at.w) {
            return;
        }
        if (hit == NULL) {
            const char *unit = cr_units_shown(p->units, columns[i].unit, NULL, NULL);
            snprintf(text, sizeof text, "%s", units ? unit : columns[i].head);
        } else if (columns[i].text != NULL) {
            columns[i].text(hit, text, sizeof text);
        } else {
            double shown = columns[i].number(hit);
            int decimals = columns[i].decimals;
            cr_units_shown(p->units, columns[i].unit, &shown, &decimals);
            cr_render_number(shown, decimals, text, sizeof text);
        }
        cr_cells_print_right(p->cells, x, p->y, columns[i].width - 1, role, text);
    }
}

/* Writes "C1-C6 13 14 18 18 14 13 cm over 1.54 m; left too, 0.12 m deep over 0.40 m". */
static void say_damage(enum cr_units units, const struct cr_severity *s, char *buf, size_t size) {
    int n = snprintf(buf, size, "C1-C6");
    for (int i = 0; i < CR_PROFILE; i++) {
        double x = fabs(s->profile[i]) * 100;
        int decimals = 0;
        cr_units_shown(units, "cm", &x, &decimals);
        n += snprintf(buf + n, size - (size_t)n, " %.*f", decimals, x);
    }
    n += snprintf(buf + n, size - (size_t)n, " %s over %.2f m",
                  cr_units_shown(units, "cm", NULL, NULL), s->profile_width);
    if (s->second.face < CR_FACES) {
        snprintf(buf + n, size - (size_t)n, "; %s too, %.2f m deep over %.2f m",
                 cr_render_face(s->second.face), s->second.depth, s->second.width);
    }
}

static void write_side(struct pen *p, const struct cr_result *r, const struct cr_impact *k,
                       int side) {
    int b = k->body[side];
    const struct hit hit = {&k->of[side], cr_result_grid(r, b)->nx > 0};
    if (full(p) || !cr_result_moves(r, b)) {
        return;
    }
    cr_cells_print(p->cells, p->at.x, p->y, ID - 1, cr_render_role_of(b), r->resolved.part[b].id);
    write_columns(p, CR_ROLE_TEXT, &hit, false);
    p->y++;
    if (hit.deforms && !full(p) && hit.of->profile_width > 0) {
        char text[200];
        say_damage(p->units, hit.of, text, sizeof text);
        write_words(p, 2, CR_ROLE_DIM, text);
    }
}

static void write_impact(struct pen *p, const struct cr_result *r, int i) {
    const struct cr_impact *k = &r->impact[i];
    double t0 = cr_render_t_contact(r->solution);
    char text[2 * CR_NAME_MAX + 120];
    if (full(p)) {
        return;
    }
    snprintf(text, sizeof text, "%d  %s - %s  %.1f to %.1f ms, closing %.1f km/h, stop %s", i + 1,
             r->resolved.part[k->body[0]].id, r->resolved.part[k->body[1]].id,
             1e3 * (k->t_begin - t0), 1e3 * (k->t_end - t0), cr_kmh(k->closing),
             cr_stop_word(k->stop));
    write_words(p, 0, CR_ROLE_TITLE, text);
    write_side(p, r, k, 0);
    write_side(p, r, k, 1);
}

int cr_render_impacts_rows(const struct cr_result *result) {
    int rows = 2 + result->impacts;
    for (int i = 0; i < 2 * result->impacts; i++) {
        int b = result->impact[i / 2].body[i % 2];
        bool deforms = cr_result_grid(result, b)->nx > 0;
        double wide = result->impact[i / 2].of[i % 2].profile_width;
        rows += cr_result_moves(result, b) ? 1 + (deforms && wide > 0) : 0;
    }
    return rows;
}

void cr_render_impacts(struct cr_cells *cells, struct cr_rect at, const struct cr_result *result) {
    struct pen p = {cells, at, at.y, result->units};
    if (full(&p)) {
        return;
    }
    cr_cells_print(cells, at.x, p.y, ID - 1, CR_ROLE_TITLE, "Impacts");
    write_columns(&p, CR_ROLE_TITLE, NULL, false);
    p.y++;
    if (!full(&p)) {
        write_columns(&p, CR_ROLE_DIM, NULL, true);
        p.y++;
    }
    for (int i = 0; i < result->impacts; i++) {
        write_impact(&p, result, i);
    }
}
