/* The last sweep as a sheet of texts. */
#include "tui/tui_priv.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 64, COLUMNS_MAX = 2 + 3 * CR_BODY_MAX + 1 };

struct cr_sweep_sheet {
    struct cr_sheet sheet;
    char head[COLUMNS_MAX][TEXT];
    const char *heads[COLUMNS_MAX];
    const char **cell;
    char (*text)[TEXT];
    char note[64];
    bool under_way;            /* runs are still coming in */
    bool deforms[CR_BODY_MAX]; /* participants with columns of their own */
};

static bool deforms(const struct cr_sweep *sweep, int part) {
    for (int i = 0; i < sweep->n; i++) {
        if (sweep->run[i].done && !sweep->run[i].failed && sweep->run[i].of[part].ees > 0) {
            return true;
        }
    }
    return false;
}

static void write_run(struct cr_sweep_sheet *s, const struct cr_sweep *sweep, int row) {
    const struct cr_sweep_run *run = &sweep->run[row];
    char(*text)[TEXT] = s->text + row * s->sheet.columns;
    int c = 0;
    for (int a = 0; a < sweep->axes; a++) {
        const struct cr_sweep_axis *axis = &sweep->axis[a];
        snprintf(text[c++], TEXT, "%.6g %s", run->at[a] * axis->unit->div / axis->unit->mul,
                 axis->unit->name);
    }
    bool known = run->done && !run->failed;
    for (int p = 0; p < sweep->participants; p++) {
        if (s->deforms[p]) {
            if (known) {
                snprintf(text[c], TEXT, "%.1f", cr_kmh(run->of[p].ees));
                snprintf(text[c + 1], TEXT, "%.1f", cr_kmh(run->of[p].delta_v));
                snprintf(text[c + 2], TEXT, "%.2f", run->of[p].deformation_max);
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
    s->sheet.note = "EES, dv km/h, depth m   Up Down choose, Enter takes it into the scene";
    if (!s->under_way) {
        return;
    }
    for (int i = 0; i < sweep->n; i++) {
        running += sweep->run[i].running;
    }
    snprintf(s->note, sizeof s->note, "%d of %d done, %d running; ^C stops", p->done, p->total,
             running);
    s->sheet.note = s->note;
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
        s->deforms[p] = deforms(sweep, p);
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
