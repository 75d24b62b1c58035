/* The last sweep as a sheet of texts. */
#include "tui/tui_priv.h"

#include "render/picture.h"
#include "result/measures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 64, COLUMNS_MAX = CR_SWEEP_AXES + 3 * CR_BODY_MAX + 1 };

struct cr_sweep_sheet {
    struct cr_sheet sheet;
    char head[COLUMNS_MAX][TEXT];
    const char *heads[COLUMNS_MAX];
    const char **cell;
    char (*text)[TEXT];
    char note[96];
    enum cr_units units;
    bool under_way;            /* runs are still coming in */
    bool deforms[CR_BODY_MAX]; /* participants with columns of their own */
};

/* a number of a participant in the units of the session */
static void put(char *text, enum cr_units units, const char *name, const struct cr_severity *of) {
    const struct cr_measure *m = cr_measure_find(name);
    double x = cr_measure_shown(m, of);
    int decimals;
    cr_measure_in(m, units, &x, &decimals);
    snprintf(text, TEXT, "%.*f", decimals, x);
}

static void write_run(struct cr_sweep_sheet *s, const struct cr_sweep *sweep, int row) {
    char value[TEXT];
    const struct cr_sweep_run *run = &sweep->run[row];
    char(*text)[TEXT] = s->text + row * s->sheet.columns;
    int c = 0;
    for (int a = 0; a < sweep->axes; a++) {
        const struct cr_sweep_axis *axis = &sweep->axis[a];
        cr_sweep_text(axis, run->at[a], s->units, value, sizeof value);
        snprintf(text[c++], TEXT, "%.40s%s%s", value, axis->word != NULL ? "" : " ",
                 cr_sweep_unit(axis, s->units));
    }
    bool known = cr_sweep_known(run);
    for (int p = 0; p < sweep->participants; p++) {
        if (s->deforms[p]) {
            if (known) {
                put(text[c], s->units, "ees", &run->of[p]);
                put(text[c + 1], s->units, "delta_v", &run->of[p]);
                put(text[c + 2], s->units, "deformation_max", &run->of[p]);
            }
            c += 3;
        }
    }
    snprintf(text[c], TEXT, "%s",
             run->running  ? "running"
             : !run->done  ? s->under_way ? "queued" : "not run"
             : run->failed ? "failed"
                           : cr_stop_word(run->stop));
}

/* below the runs: how far they are, or what can be done with them */
static void write_note(struct cr_sweep_sheet *s, const struct cr_progress *p,
                       const struct cr_sweep *sweep) {
    int running = 0;
    s->sheet.progress = (double)NAN;
    snprintf(s->note, sizeof s->note,
             "EES, dv %s, depth %s   Up Down choose, Enter takes it into the scene",
             cr_units_shown(s->units, "km/h", NULL, NULL),
             cr_units_shown(s->units, CR_SHOWN_DEPTH, NULL, NULL));
    s->sheet.note = s->note;
    if (!s->under_way) {
        return;
    }
    for (int i = 0; i < sweep->n; i++) {
        running += sweep->run[i].running;
    }
    snprintf(s->note, sizeof s->note, "%d of %d done, %d running; ^C stops", p->done, p->total,
             running);
    s->sheet.progress = p->share;
}

/* While runs come in, the row to see is the last that is running. */
static int row_of(const struct cr_tui *t, const struct cr_sweep_sheet *s,
                  const struct cr_sweep *sweep) {
    int row = s->under_way ? 0 : t->sweep_row;
    for (int i = 0; s->under_way && i < sweep->n; i++) {
        row = sweep->run[i].running ? i : row;
    }
    return row < sweep->n ? row : sweep->n - 1;
}

static void write_head(struct cr_sweep_sheet *s, const struct cr_sweep *sweep) {
    int c = 0;
    for (int a = 0; a < sweep->axes; a++) {
        snprintf(s->head[c++], TEXT, "%.40s", sweep->axis[a].key);
    }
    for (int p = 0; p < sweep->participants; p++) {
        s->deforms[p] = cr_sweep_deforms(sweep, p);
        if (s->deforms[p]) {
            snprintf(s->head[c++], TEXT, "EES %.20s", sweep->id[p]);
            snprintf(s->head[c++], TEXT, "dv %.20s", sweep->id[p]);
            snprintf(s->head[c++], TEXT, "depth %.20s", sweep->id[p]);
        }
    }
    snprintf(s->head[c++], TEXT, "stop");
    s->sheet.columns = c;
}

enum cr_err cr_sweep_sheet_new(const struct cr_tui *t, struct cr_sweep_sheet **out,
                               struct cr_error *err) {
    const struct cr_sweep *live = t->progress != NULL ? t->progress->sweep : NULL;
    const struct cr_sweep *sweep = live != NULL ? live : cr_session_sweep(t->session);
    *out = NULL;
    if (sweep == NULL || sweep->n == 0) {
        return CR_ERR_OK;
    }
    struct cr_sweep_sheet *s = calloc(1, sizeof *s);
    if (s == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    s->under_way = live != NULL;
    s->units = cr_session_units(t->session);
    write_head(s, sweep);
    size_t cells = (size_t)s->sheet.columns * (size_t)sweep->n;
    s->cell = calloc(cells, sizeof *s->cell);
    s->text = calloc(cells, sizeof *s->text);
    if (s->cell == NULL || s->text == NULL) {
        cr_sweep_sheet_free(s);
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (int i = 0; i < s->sheet.columns; i++) {
        s->heads[i] = s->head[i];
    }
    for (int i = 0; i < sweep->n; i++) {
        write_run(s, sweep, i);
    }
    for (size_t i = 0; i < cells; i++) {
        s->cell[i] = s->text[i];
    }
    s->sheet.rows = sweep->n;
    s->sheet.head = s->heads;
    s->sheet.cell = s->cell;
    s->sheet.chosen = row_of(t, s, sweep);
    write_note(s, t->progress, sweep);
    *out = s;
    return CR_ERR_OK;
}

const struct cr_sheet *cr_sweep_sheet_get(const struct cr_sweep_sheet *s) {
    return s != NULL ? &s->sheet : NULL;
}

void cr_sweep_sheet_free(struct cr_sweep_sheet *s) {
    if (s != NULL) {
        free(s->cell);
        free(s->text);
        free(s);
    }
}

bool cr_sweep_pictured(const struct cr_tui *t) {
    bool live = t->progress != NULL && t->progress->sweep != NULL;
    return !live && cr_session_view(t->session)->sweep_picture > 0 &&
           cr_session_sweep_pictures(t->session) > 0;
}

enum cr_err cr_sweep_picture_draw(struct cr_tui *t, const struct cr_look *look,
                                  struct cr_error *err) {
    struct cr_rect at = cr_rect_inner(t->layout.pane[CR_AREA_SWEEP]);
    const struct cr_sweep *sweep = cr_session_sweep(t->session);
    enum cr_units units = cr_session_units(t->session);
    if (!cr_sweep_pictured(t) || at.w < 3 || at.h < 3) {
        return CR_ERR_OK;
    }
    int run = t->sweep_row < sweep->n ? t->sweep_row : sweep->n - 1;
    struct cr_str note = {0};
    char text[TEXT];
    cr_cells_wipe(&t->cells, at);
    cr_str_addf(&note, " run %d:", run + 1);
    for (int a = 0; a < sweep->axes; a++) {
        cr_sweep_text(&sweep->axis[a], sweep->run[run].at[a], units, text, sizeof text);
        cr_str_addf(&note, " %s %s%s%s ", sweep->axis[a].key, text,
                    sweep->axis[a].word != NULL ? "" : " ", cr_sweep_unit(&sweep->axis[a], units));
    }
    static const char keys[] = "  Up Down Enter p";
    if (cr_glyph_width(cr_str_get(&note)) + (int)sizeof keys <= at.w) {
        cr_str_add(&note, keys);
    }
    cr_cells_print(&t->cells, at.x, at.y + at.h - 1, at.w, CR_ROLE_DIM, cr_str_get(&note));
    cr_str_fini(&note);
    at = (struct cr_rect){at.x + 1, at.y, at.w - 2, at.h - 1};
    return cr_session_draw_sweep(t->session, run, &t->cells, at, look, err);
}

void cr_sweep_choose(struct cr_tui *t, int step) {
    const struct cr_sweep *sweep = cr_session_sweep(t->session);
    int most = sweep != NULL ? sweep->n - 1 : 0;
    t->sweep_row += step;
    t->sweep_row = t->sweep_row < 0 ? 0 : t->sweep_row > most ? most : t->sweep_row;
    t->dirty = true;
}

void cr_sweep_take(struct cr_tui *t, int arg) {
    char line[40];
    (void)arg;
    if (cr_session_sweep(t->session) != NULL) {
        snprintf(line, sizeof line, "sweep row=%d", t->sweep_row + 1);
        cr_tui_run_key(t, line);
    }
}

void cr_sweep_turn(struct cr_tui *t, int arg) {
    char line[40];
    (void)arg;
    int n = cr_session_sweep_pictures(t->session), now = cr_session_view(t->session)->sweep_picture;
    snprintf(line, sizeof line, "view sweep picture=%d", now < n ? now + 1 : 0);
    cr_tui_run_key(t, line);
}
