/* Draws pictures and tables in text: a grid of cells that a plain terminal, a file or curses can
 * show.
 *
 * Drawing goes into memory only; cr_cells_text turns the cells into text with or without colour.
 * Glyphs are UTF-8 blocks and braille, or pure ASCII; nothing is told by colour alone. */
#ifndef CR_RENDER_RENDER_H
#define CR_RENDER_RENDER_H

#include "base/str.h"
#include "base/units.h"
#include "result/result.h"
#include "scene/scene.h"

#include <stdbool.h>
#include <stdint.h>

/* What a cell means, not how it looks: a theme maps roles to colours. */
enum cr_role {
    CR_ROLE_TEXT,
    CR_ROLE_DIM,
    CR_ROLE_TITLE,
    CR_ROLE_FRAME,
    CR_ROLE_A,
    CR_ROLE_B,
    CR_ROLE_C,
    CR_ROLE_OBJECT,
    CR_ROLE_CRUSHED,
    CR_ROLE_INDUCED,
    CR_ROLE_FORCE,
    CR_ROLE_GOOD,
    CR_ROLE_WARN,
    CR_ROLE_BAD,
    CR_ROLE_REFERENCE,
    CR_ROLE_CURSOR,
    CR_ROLE_KEY,
    CR_ROLE_FIELD,
    CR_ROLES
};

struct cr_cell {
    uint32_t ch;    /* Unicode code point, 0: the right half of a wide character */
    uint8_t role;   /* enum cr_role */
    uint8_t fg, bg; /* field colours: step 1..8 of the colour map, 9: beyond its scale, 0: none */
    uint8_t flags;  /* CR_CELL_* */
};
enum { CR_CELL_BOLD = 1, CR_CELL_REVERSE = 2, CR_CELL_DIM = 4 };

struct cr_cells {
    int w, h;
    struct cr_cell *cell; /* [h * w], owned */
    bool failed;          /* memory was out for some of what belongs here; its text fails, too */
};

/* Makes a blank grid; cr_cells_fini gives back. Errors: RANGE for sides outside of 1..4096,
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_cells_new(int w, int h, struct cr_cells *out, struct cr_error *err);
void cr_cells_fini(struct cr_cells *cells);
void cr_cells_clear(struct cr_cells *cells);
/* Writes a text at column x, row y, cut with ~ at width w (0: the edge); returns the columns
 * used. */
int cr_cells_print(struct cr_cells *cells, int x, int y, int w, enum cr_role role,
                   const char *utf8);

enum cr_color { CR_COLOR_NONE, CR_COLOR_16, CR_COLOR_256 };

/* Colour maps of fields; all rise in lightness. X(NAME, word) */
#define CR_COLORMAP_LIST(X) X(VIRIDIS, "viridis") X(MAGMA, "magma") X(GRAY, "gray")
enum cr_colormap {
#define X(name, word) CR_COLORMAP_##name,
    CR_COLORMAP_LIST(X)
#undef X
        CR_COLORMAPS
};
const char *cr_colormap_word(enum cr_colormap map);
/* The words of such a list as "viridis|magma|gray". */
#define CR_WORD_OF(name, word) "|" word
#define CR_COLORMAP_WORDS      (("" CR_COLORMAP_LIST(CR_WORD_OF)) + 1)

struct cr_theme;
struct cr_look {
    bool ascii; /* no character above 126 */
    enum cr_color color;
    enum cr_colormap map;
    const struct cr_theme *theme; /* NULL: auto (render/theme.h) */
};
/* Adds the cells as lines of text, trailing blanks cut. */
void cr_cells_text(const struct cr_cells *cells, const struct cr_look *look, struct cr_str *out);

/* What a picture shows of the voxels. X(NAME, word) */
#define CR_FIELD_LIST(X)                                                                           \
    X(EES, "ees") X(ENERGY, "energy") X(CRUSH, "crush") X(DEPTH, "depth") X(NONE, "none")
enum cr_field {
#define X(name, word) CR_FIELD_##name,
    CR_FIELD_LIST(X)
#undef X
        CR_FIELDS
};
const char *cr_field_word(enum cr_field field);
#define CR_FIELD_WORDS (("" CR_FIELD_LIST(CR_WORD_OF)) + 1)

/* Upper end of the EES scale, km/h. It is fixed, so that pictures can be compared; harder material
 * is drawn as a last step beyond it. */
#define CR_EES_TOP 100

struct cr_rect {
    int x, y, w, h;
};

/* Where something is drawn, and how: a part of a grid of cells. */
struct cr_target {
    struct cr_cells *cells;
    struct cr_rect at;
    const struct cr_look *look;
};

/* Fills a rectangle that lies within the cells with blanks. */
void cr_cells_wipe(struct cr_cells *cells, struct cr_rect at);

struct cr_scene_view {
    enum cr_field field;
    double time;      /* s of the scene; NaN: after the solve (or the start, without a result) */
    double m_per_col; /* scale; 0: the best round one that shows all */
    struct cr_vec2 centre; /* world point in the middle; NaN: the bodies' middle */
    bool vectors;          /* velocity and force arrows */
    bool ghost;            /* outlines of the bodies at the first contact */
    int selected;          /* participant to mark, -1: none */
    enum cr_units units;   /* units of labels, where no result says them */
};

/* Draws the scene, before (result NULL), at a time, or after; with outline, heading, overlap and
 * crushed voxels, arrows, scale bar and legend. compiled gives the voxels when there is no result
 * yet. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_render_scene(const struct cr_target *target,
                                          const struct cr_compiled *compiled,
                                          const struct cr_scene *scene,
                                          const struct cr_result *result,
                                          const struct cr_scene_view *view, struct cr_error *err);

/* The one character that stands for a participant in pictures, plots and lines: the first of its
 * name that no earlier one has, else a letter or digit that is free. */
char cr_render_mark(const struct cr_scene *scene, int body);
/* The role (colour) of a participant. */
enum cr_role cr_render_role_of(int body);

/* Makes a result to draw of a solve under way: scene, case and trace are borrowed, measures are
 * missing, so that pictures show only what there is so far. NULL without memory; free() it. */
struct cr_result *cr_render_live(const struct cr_scene *scene, const struct cr_case *cs,
                                 const struct cr_solution *live);

struct cr_curve_line {
    const double *x, *y;
    int n;
    char mark;        /* letter beside it, 'A' */
    const char *name; /* name in the legend */
    enum cr_role role;
    bool dashed;
    bool points; /* its points are not joined by lines, and x need not rise */
};
struct cr_plot {
    const char *title, *x_unit, *y_unit;
    const char *x_name; /* name above, in place of the unit below; NULL: none */
    bool close;         /* the y axis is as long as the curves and need not include zero */
    int curves;
    const struct cr_curve_line *curve;
    double cursor;       /* x of a vertical cursor, NaN: none */
    enum cr_units units; /* units it is drawn in; curves and units above are metric */
};
/* The plot itself, or where its units differ a copy in them that lives in the arena; NULL without
 * memory. */
const struct cr_plot *cr_plot_shown(const struct cr_plot *plot, struct cr_arena *arena);
/* Draws curves over a common axis with round 1-2-5 ticks (braille, or * and o). Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_render_plot(struct cr_cells *cells, struct cr_rect at,
                                         const struct cr_look *look, const struct cr_plot *plot,
                                         struct cr_error *err);

/* A value over two inputs. */
struct cr_heat_map {
    const char *title;           /* with the unit of the values */
    const char *x_name, *y_name; /* with their units */
    int nx, ny;
    const double *x, *y;                       /* [nx], [ny] rising; of words their index */
    const double *value;                       /* [ny * nx], x fastest; NaN: none */
    int decimals;                              /* of the values as shown */
    const char *const *x_word, *const *y_word; /* NULL: the input is a number */
    int chosen;                                /* value that is marked, counted from 1; 0: none */
};
/* Finds the least and the greatest value; false: there is none. */
bool cr_heat_range(const struct cr_heat_map *map, double *lo, double *hi);
/* Tells piece() the pieces of the line on which the value is `level`, linear between the values, in
 * places of the grid, 0..nx-1 and 0..ny-1. There are none where an input is a word. */
void cr_heat_contour(const struct cr_heat_map *map, double level,
                     void (*piece)(void *user, const double from[2], const double to[2]),
                     void *user);
/* Draws a map: shades or colours between the values, lines with their values. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_render_map(struct cr_cells *cells, struct cr_rect at,
                                        const struct cr_look *look, const struct cr_heat_map *map,
                                        struct cr_error *err);

/* A round tick step, 1, 2 or 5 times a power of ten, with at most `most` steps in span (> 0). */
double cr_tick_step(double span, int most);
/* The ticks from lo to hi, with a rounding error at either end: the multiples of a step from the
 * first-th on. n is 0 where lo or hi is no number. */
struct cr_ticks {
    double first, step;
    int n;
};
struct cr_ticks cr_ticks(double lo, double hi, double step);
double cr_tick_at(const struct cr_ticks *ticks, int i);
/* Writes a number with the digits that ticks of this step need. */
void cr_tick_text(double value, double step, char *buf, int size);
/* The least and greatest x and y that the axes of a plot show: zero is among the y unless the
 * curves are a small change of a large number. */
struct cr_plot_range {
    double x_lo, x_hi, y_lo, y_hi;
};
struct cr_plot_range cr_plot_range(const struct cr_plot *plot);

/* A plot of a result with the memory of its curves. It must not be copied: the plot points into
 * it. */
struct cr_plot_made {
    struct cr_plot plot;
    struct cr_curve_line curve[CR_BODY_MAX + 1];
    char name[CR_BODY_MAX][2];
    struct cr_arena arena;
};
/* Make the plots of a quantity of all participants that move (CR_QUANTITIES: |a| = sqrt(ax2 + ay2),
 * g), and of the kinetic energy of all and the deformation energy of each, kJ; over ms after first
 * contact. cursor: a time of the scene, s, NaN: none. cr_plot_made_fini gives back after success.
 * Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_plot_pulse(const struct cr_result *result, enum cr_quantity quantity,
                                        double cursor, struct cr_plot_made *out,
                                        struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_plot_energy(const struct cr_result *result, double cursor,
                                         struct cr_plot_made *out, struct cr_error *err);
void cr_plot_made_fini(struct cr_plot_made *made);

/* Draw these plots. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_render_pulse(const struct cr_target *target,
                                          const struct cr_result *result, enum cr_quantity quantity,
                                          double cursor, struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_render_energy(struct cr_cells *cells, struct cr_rect at,
                                           const struct cr_look *look,
                                           const struct cr_result *result, double cursor,
                                           struct cr_error *err);

/* Draws the results table (quantities with units, a column per participant). time NaN: final
 * values, else those of that instant, s. */
CR_MUST_CHECK enum cr_err cr_render_table(struct cr_cells *cells, struct cr_rect at,
                                          const struct cr_look *look,
                                          const struct cr_result *result, double time,
                                          struct cr_error *err);
/* The rows that the table needs for this result. */
int cr_render_table_rows(const struct cr_result *result);

/* Draws a table of all impacts with what each did to either participant; times after the first
 * contact. Columns that have no room are left out from the right. */
void cr_render_impacts(struct cr_cells *cells, struct cr_rect at, const struct cr_result *result);
int cr_render_impacts_rows(const struct cr_result *result);

/* Adds lines that say how far the numbers depend on chance, of a result that was checked
 * (result/robust.h). */
void cr_render_robust(const struct cr_result *result, struct cr_str *out);

/* Measured values of participants, to stand beside a result; NaN: not measured. */
struct cr_reference {
    int n;
    char id[CR_BODY_MAX][CR_NAME_MAX];
    struct cr_severity of[CR_BODY_MAX];
};
/* Draws the results table with measured values beside it, and below each row the errors, if
 * reference is not NULL and there is room; below it the impacts if there were several. */
CR_MUST_CHECK enum cr_err cr_render_table_beside(const struct cr_target *target,
                                                 const struct cr_result *result,
                                                 const struct cr_reference *reference, double time,
                                                 struct cr_error *err);
int cr_render_table_rows_beside(const struct cr_result *result,
                                const struct cr_reference *reference);

/* Adds the whole report of `crumple run --format text`: before, after, pulses, table, balance,
 * assumptions, warnings; width in columns, 60..300. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_render_report(const struct cr_result *result,
                                           const struct cr_look *look, int width,
                                           struct cr_str *out, struct cr_error *err);

#endif
