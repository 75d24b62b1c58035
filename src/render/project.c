/* Draws 3D voxel models as seen from the side, from above and from the front. */
#include "render/project.h"
#include "render/render_priv.h"

#include "base/vec.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MARGIN = 2, ROWS_MORE = 3, SUB = 3 };
static const double ees_top = CR_EES_TOP;
static const double near_depth = 0.5; /* m of material that the front view looks into */

static const char *const view_words[CR_PROJECTS] = {
#define X(name, word) word,
    CR_PROJECT_LIST(X)
#undef X
};

static bool is_side(enum cr_project view) {
    return view == CR_PROJECT_SIDE || view == CR_PROJECT_SLICE;
}

/* The numbers of voxels along u, v and the line of sight. */
static void axes(enum cr_project view, const struct cr_voxels *m, int n[3]) {
    const int all[3] = {m->nx, m->ny, m->nz};
    static const int order[CR_PROJECTS][3] = {[CR_PROJECT_SIDE] = {0, 2, 1},
                                              [CR_PROJECT_TOP] = {0, 1, 2},
                                              [CR_PROJECT_FRONT] = {1, 2, 0},
                                              [CR_PROJECT_SLICE] = {0, 2, 1}};
    for (int k = 0; k < 3; k++) {
        n[k] = all[order[view][k]];
    }
}

static void voxel_at(enum cr_project view, int u, int v, int w, int i[3]) {
    i[0] = view == CR_PROJECT_FRONT ? w : u;
    i[1] = view == CR_PROJECT_TOP ? v : view == CR_PROJECT_FRONT ? u : w;
    i[2] = view == CR_PROJECT_TOP ? w : v;
}

/* The depth of a deformed column of the model below the struck face, m; 0 for a whole one. */
static double depth_of(const struct cr_projection *p, int ix, int iy) {
    const struct cr_voxels *m = p->voxels;
    const struct cr_grid *g = p->grid;
    if (g == NULL || p->left == NULL) {
        return 0;
    }
    double x = m->x0 + (ix + 0.5) * m->edge, y = m->y0 + (iy + 0.5) * m->edge;
    int gx = (int)floor((x - g->x0) / g->h), gy = (int)floor((y - g->y0) / g->h);
    if (gx < 0 || gy < 0 || gx >= g->nx || gy >= g->ny) {
        return 0;
    }
    double fill = g->fill[gy * g->nx + gx];
    if (fill < 0.5 || p->left[gy * g->nx + gx] >= 0.5 * fill) {
        return 0;
    }
    static const int step[CR_FACES][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const int *d = step[p->face < CR_FACES ? p->face : CR_FACE_FRONT];
    int n = 0;
    for (; gx >= 0 && gy >= 0 && gx < g->nx && gy < g->ny; gx += d[0], gy += d[1]) {
        n += g->fill[gy * g->nx + gx] > 0.5;
    }
    return n * g->h;
}

/* Looks along the line of sight through u, v. From before the front only the nearest material
 * counts: further back everything is as hard as the cabin. */
static void look_along(const struct cr_projection *p, struct cr_plane *pl, const int n[3], int u,
                       int v) {
    const struct cr_voxels *m = p->voxels;
    double sum = 0, fill = 0, depth = 0;
    int from = 0, to = n[2], most = n[2];
    if (p->view == CR_PROJECT_SLICE) {
        from = (int)cr_clamp(floor((p->slice_y - m->y0) / m->edge), 0, m->ny - 1);
        to = from + 1;
    } else if (p->view == CR_PROJECT_FRONT) {
        most = (int)ceil(near_depth / m->edge);
    }
    for (int w = to - 1; w >= from && most > 0; w--) {
        int i[3];
        voxel_at(p->view, u, v, w, i);
        size_t k = ((size_t)i[2] * (size_t)m->ny + (size_t)i[1]) * (size_t)m->nx + (size_t)i[0];
        if (m->fill[k] > 0.01) {
            fill += m->fill[k];
            sum += m->fill[k] * cr_kmh(p->ees[k]);
            depth = fmax(depth, depth_of(p, i[0], i[1]));
            most--;
        }
    }
    pl->ees[v * pl->nu + u] = fill >= 0.5 ? sum / fill : (double)NAN;
    pl->depth[v * pl->nu + u] = depth;
}

enum cr_err cr_project_plane(const struct cr_projection *p, struct cr_plane *pl,
                             struct cr_error *err) {
    const struct cr_voxels *m = p->voxels;
    int n[3];
    if (p->voxels->flat && p->view != CR_PROJECT_TOP) {
        cr_err_set(err, CR_ERR_RANGE, "%s is a 2D model, it has no %s view", p->voxels->name,
                   view_words[p->view]);
        cr_err_hint(err, "use the top view");
        return CR_ERR_RANGE;
    }
    axes(p->view, m, n);
    *pl = (struct cr_plane){.nu = n[0], .nv = n[1], .edge = m->edge};
    pl->u0 = p->view == CR_PROJECT_FRONT ? m->y0 : m->x0;
    pl->v0 = p->view == CR_PROJECT_TOP ? m->y0 : m->z0;
    size_t size = (size_t)n[0] * (size_t)n[1];
    pl->ees = malloc(2 * size * sizeof *pl->ees);
    if (pl->ees == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the %s view", view_words[p->view]);
    }
    pl->depth = pl->ees + size;
    for (int v = 0; v < n[1]; v++) {
        for (int u = 0; u < n[0]; u++) {
            look_along(p, pl, n, u, v);
        }
    }
    return CR_ERR_OK;
}

void cr_plane_fini(struct cr_plane *plane) {
    free(plane->ees);
    *plane = (struct cr_plane){0};
}

/* ---- to cells ---- */

static const double scales[] = {1.0 / 40, 1.0 / 30, 1.0 / 25, 1.0 / 20, 1.0 / 16, 1.0 / 14,
                                1.0 / 12, 1.0 / 10, 1.0 / 9,  1.0 / 8,  1.0 / 7,  1.0 / 6,
                                1.0 / 5,  1.0 / 4,  1.0 / 3,  0.5,      1};

static double scale(const struct cr_projection *p, int w, int h) {
    int n[3], last = sizeof scales / sizeof scales[0] - 1;
    axes(p->view, p->voxels, n);
    double edge = p->voxels->edge;
    if (p->m_per_col > 0) {
        return p->m_per_col;
    }
    for (int i = 0; i < last; i++) {
        if (n[0] * edge <= scales[i] * w && n[1] * edge <= 2 * scales[i] * h) {
            return scales[i];
        }
    }
    return scales[last];
}

int cr_render_projection_rows(const struct cr_projection *p, int width, int most) {
    int n[3];
    axes(p->view, p->voxels, n);
    double m = scale(p, width - 2 * MARGIN, most - ROWS_MORE);
    int rows = (int)ceil(n[1] * p->voxels->edge / (2 * m) - 1e-9) + ROWS_MORE;
    return rows > most ? most : rows;
}

struct sum {
    int n, solid, hurt;
    double ees, depth;
};

/* The part of a plane that is shown: m to a column and half a row, from the height `top`
 * downward. */
struct window {
    const struct cr_plane *pl;
    double m, top;
};

/* Sums samples of a part of a cell: from (col, row), one column wide and `high` rows high. */
static struct sum gather(const struct window *w, double col, double row, double high) {
    const struct cr_plane *pl = w->pl;
    struct sum s = {.n = SUB * SUB};
    for (int k = 0; k < SUB * SUB; k++) {
        double u = (col + (k % SUB + 0.5) / SUB) * w->m;
        double v = w->top - (row + (k / SUB + 0.5) / SUB * high) * 2 * w->m;
        int iu = (int)floor(u / pl->edge), iv = (int)floor(v / pl->edge);
        if (iu < 0 || iv < 0 || iu >= pl->nu || iv >= pl->nv) {
            continue;
        }
        double ees = pl->ees[iv * pl->nu + iu], depth = pl->depth[iv * pl->nu + iu];
        if (isfinite(ees)) {
            s.solid++;
            s.ees += ees;
            s.hurt += depth > 0;
            s.depth = fmax(s.depth, depth);
        }
    }
    return s;
}

static uint8_t step_of(const struct sum *s) {
    double level = s->solid > 0 ? s->ees / s->solid / ees_top : 0;
    return level >= 1 ? CR_STEPS + 1 : cr_shade_step(level);
}

static void draw_blocks(struct cr_cell *cell, const struct sum half[2]) {
    uint8_t step[2];
    for (int i = 0; i < 2; i++) {
        step[i] = 2 * half[i].solid >= half[i].n ? step_of(&half[i]) : 0;
    }
    if (step[0] == 0 && step[1] == 0) {
        return;
    }
    *cell = (struct cr_cell){.ch = step[0] > 0 ? 0x2580 : 0x2584,
                             .role = CR_ROLE_FIELD,
                             .fg = step[0] > 0 ? step[0] : step[1],
                             .bg = step[0] > 0 ? step[1] : 0};
}

static void draw_cell(struct cr_cell *cell, const struct window *w, int col, int row,
                      const struct cr_look *look) {
    struct sum s = gather(w, col, row, 1);
    if (2 * s.hurt >= s.n) {
        int dm = (int)(s.depth * 10);
        *cell =
            (struct cr_cell){.ch = (uint32_t)('0' + (dm > 9 ? 9 : dm)), .role = CR_ROLE_CRUSHED};
    } else if (look->color == CR_COLOR_256 && !look->ascii) {
        struct sum half[2] = {gather(w, col, row, 0.5), gather(w, col, row + 0.5, 0.5)};
        draw_blocks(cell, half);
    } else if (2 * s.solid >= s.n) {
        *cell = (struct cr_cell){.ch = cr_glyph_shade(s.ees / s.solid / ees_top, look->ascii),
                                 .role = CR_ROLE_FIELD,
                                 .fg = look->color != CR_COLOR_NONE ? step_of(&s) : 0};
    }
}

static void draw_frame(struct cr_cells *cells, struct cr_rect at, const struct cr_look *look,
                       const struct cr_projection *p, double m) {
    static const char *const titles[CR_PROJECTS] = {[CR_PROJECT_SIDE] = "side, front at the right",
                                                    [CR_PROJECT_TOP] = "top",
                                                    [CR_PROJECT_FRONT] = "front",
                                                    [CR_PROJECT_SLICE] =
                                                        "slice, front at the right"};
    char text[128];
    int y = at.y + at.h - 1, n = (int)lround(1 / m), x = at.x + 1;
    snprintf(text, sizeof text, "%.60s  %s", p->voxels->name, titles[p->view]);
    cr_cells_print(cells, x, at.y, at.w - 1, CR_ROLE_TITLE, text);
    cr_cells_put(cells, x, y, CR_ROLE_TEXT, look->ascii ? '|' : 0x251C);
    cr_cells_run(cells, x + 1, y, n - 2, CR_ROLE_TEXT, look->ascii ? '-' : 0x2500);
    cr_cells_put(cells, x + n - 1, y, CR_ROLE_TEXT, look->ascii ? '|' : 0x2524);
    x += n + 1;
    x += cr_cells_print(cells, x, y, at.x + at.w - x, CR_ROLE_TEXT, "1 m   EES 0 ");
    bool blocks = look->color == CR_COLOR_256 && !look->ascii;
    int steps = blocks ? CR_STEPS : look->ascii ? 9 : 4;
    for (int i = 0; i < steps && x < at.x + at.w; i++, x++) {
        double u = (i + 0.5) / steps;
        cr_cells_put(cells, x, y, CR_ROLE_FIELD, blocks ? 0x2588 : cr_glyph_shade(u, look->ascii));
        if (look->color != CR_COLOR_NONE) {
            cr_cells_at(cells, x, y)->fg = cr_shade_step(u);
        }
    }
    snprintf(text, sizeof text, " %.0f+ km/h", ees_top);
    x += cr_cells_print(cells, x, y, at.x + at.w - x, CR_ROLE_TEXT, text) + 3;
    if (p->grid != NULL && x + 26 < at.x + at.w) {
        x += cr_cells_print(cells, x, y, 0, CR_ROLE_CRUSHED, "0..9") + 1;
        cr_cells_print(cells, x, y, 0, CR_ROLE_TEXT, "deformed, depth in dm");
    }
}

enum cr_err cr_render_projection(struct cr_cells *cells, struct cr_rect at,
                                 const struct cr_look *look, const struct cr_projection *p,
                                 struct cr_error *err) {
    struct cr_plane pl;
    enum cr_err code = cr_project_plane(p, &pl, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (at.w < 20 || at.h < ROWS_MORE + 2) {
        cr_plane_fini(&pl);
        return CR_ERR_OK;
    }
    double m = scale(p, at.w - 2 * MARGIN, at.h - ROWS_MORE);
    int rows = at.h - ROWS_MORE;
    /* A view with a road stands on it, at the bottom; seen from above a vehicle is in the
     * middle. */
    double top = is_side(p->view) || p->view == CR_PROJECT_FRONT
                     ? rows * 2 * m
                     : 0.5 * (pl.nv * pl.edge + rows * 2 * m);
    const struct window window = {&pl, m, top};
    for (int y = 0; y < rows; y++) {
        for (int x = 0; x < at.w - 2 * MARGIN; x++) {
            struct cr_cell *cell = cr_cells_at(cells, at.x + MARGIN + x, at.y + 1 + y);
            if (cell != NULL) {
                draw_cell(cell, &window, x, y, look);
            }
        }
    }
    if (p->view != CR_PROJECT_TOP) {
        cr_cells_run(cells, at.x + 1, at.y + 1 + rows, at.w - 2, CR_ROLE_FRAME,
                     look->ascii ? '=' : 0x2550);
    }
    draw_frame(cells, at, look, p, m);
    cr_plane_fini(&pl);
    return CR_ERR_OK;
}
