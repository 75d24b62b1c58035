/* Whole screens as the full screen composes them, against texts that were looked at. The crash is
 * made by hand, so they change only when the screen does; make update-golden writes them anew. */
#include "golden.h"
#include "tui_double.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct shot {
    const char *name;
    int w, h;
    const char *keys;
    enum { EMPTY, SOLVED, COMPARED, PART, SWEPT, SWEPT_4, DRAWN } crash;
    bool ascii;
    const char *question;
    double working; /* share of a solve under way, 0: none; 1: a sweep */
    bool color;     /* with the colours of a theme, as escapes of the palette of 256 */
};

static const struct shot shots[] = {
    {"start-80x24", 80, 24, "", EMPTY, false, NULL, 0, false},
    {"frame-80x24", 80, 24, "show frame=80<Enter>", SOLVED, false, NULL, 0, false},
    {"frame-80x24-ascii", 80, 24, "show frame=80<Enter>", SOLVED, true, NULL, 0, false},
    {"frame-100x30", 100, 30, "show frame=80<Enter>", SOLVED, false, NULL, 0, false},
    {"frame-120x36", 120, 36, "show frame=80<Enter>", SOLVED, false, NULL, 0, false},
    {"frame-200x50", 200, 50, "show frame=80<Enter>show color", SOLVED, false, NULL, 0, false},
    {"stale-80x24", 80, 24, "vehicle A speed=80<Enter>", SOLVED, false, NULL, 0, false},
    {"stale-200x50", 200, 50, "vehicle A speed=80<Enter>", SOLVED, false, NULL, 0, false},
    {"ghost-100x30", 100, 30, "show ghost=on<Enter>", SOLVED, false, NULL, 0, false},
    {"end-80x24", 80, 24, "", SOLVED, false, NULL, 0, false},
    {"end-200x50", 200, 50, "", SOLVED, false, NULL, 0, false},
    {"narrow-60x20", 60, 20, "show frame=80<Enter>", SOLVED, false, NULL, 0, false},
    {"prompt-30x8", 30, 8, "show frame=80<Enter>", SOLVED, false, NULL, 0, false},
    {"pulse-100x30", 100, 30, "show frame=80<Enter><M-2>", SOLVED, false, NULL, 0, false},
    {"energy-100x30", 100, 30, "show frame=80<Enter><M-3>", SOLVED, false, NULL, 0, false},
    {"table-100x30", 100, 30, "<M-4>", SOLVED, false, NULL, 0, false},
    {"compared-100x30", 100, 30, "<M-4>", COMPARED, false, NULL, 0, false},
    {"compared-200x50", 200, 50, "", COMPARED, false, NULL, 0, false},
    {"sweep-80x24", 80, 24, "<M-5>", SOLVED, false, NULL, 0, false},
    {"log-80x24", 80, 24, "<M-6>list<Enter>", SOLVED, false, NULL, 0, false},
    {"zoom-100x30", 100, 30, "<F6>z", SOLVED, false, NULL, 0, false},
    {"help-80x24", 80, 24, "<F6><F1>", SOLVED, false, NULL, 0, false},
    {"help-200x50", 200, 50, "<F1>", SOLVED, false, NULL, 0, false},
    {"palette-100x30", 100, 30, "<Tab><Tab>sw", SOLVED, false, NULL, 0, false},
    {"sheet-80x24", 80, 24, "help undo<Enter>", SOLVED, false, NULL, 0, false},
    {"complete-100x30", 100, 30, "place B facing A <Tab>", SOLVED, false, NULL, 0, false},
    {"error-80x24", 80, 24, "plaze A<Enter>", SOLVED, false, NULL, 0, false},
    {"question-80x24", 80, 24, "", SOLVED, false,
     "crash.json has 3 unsaved changes: (s)ave (q)uit (c)ancel", 0, false},
    {"solving-80x24", 80, 24, "", SOLVED, false, NULL, 0.43, false},
    {"sweeping-80x24", 80, 24, "<M-5>", SOLVED, false, NULL, 1, false},
    {"sweeping-200x50", 200, 50, "", SOLVED, false, NULL, 1, false},
    {"interrupted-80x24", 80, 24, "", PART, false, NULL, 0, false},
    {"swept-80x24", 80, 24, "<M-5><F6><Down><Down>", SWEPT, false, NULL, 0, false},
    {"map-80x24", 80, 24, "<M-5><F6><Down><Down>p", SWEPT, false, NULL, 0, false},
    {"map-80x24-ascii", 80, 24, "<M-5><F6><Down><Down>pp", SWEPT, true, NULL, 0, false},
    {"map-200x50", 200, 50, "<M-5><F6><Down>p", SWEPT, false, NULL, 0, false},
    {"map-of-four-100x30", 100, 30, "set units=us<Enter><M-5><F6><Down>pp", SWEPT_4, false, NULL, 0,
     false},
    {"draws-80x24", 80, 24, "<M-5><F6>pp", DRAWN, false, NULL, 0, false},
    {"compare-80x24", 80, 24, "compare tests/golden/tui/other.json<Enter>", SOLVED, false, NULL, 0,
     false},
    {"compare-200x50", 200, 50, "compare tests/golden/tui/other.json<Enter>", SOLVED, false, NULL,
     0, false},
    {"frame-80x24-dark", 80, 24, "view theme=dark<Enter>show frame=80<Enter>", SOLVED, false, NULL,
     0, true},
    {"frame-80x24-light", 80, 24, "view theme=light<Enter>show frame=80<Enter>", SOLVED, false,
     NULL, 0, true},
    {"frame-200x50-dark", 200, 50, "view theme=dark<Enter>show frame=80<Enter>", SOLVED, false,
     NULL, 0, true},
    {"frame-200x50-light", 200, 50, "view theme=light<Enter>show frame=80<Enter>", SOLVED, false,
     NULL, 0, true},
    {"pulse-80x24-dark", 80, 24, "view theme=dark<Enter>show frame=80<Enter><M-2>", SOLVED, false,
     NULL, 0, true},
    {"pulse-80x24-light", 80, 24, "view theme=light<Enter>show frame=80<Enter><M-2>", SOLVED, false,
     NULL, 0, true},
    {"energy-80x24-dark", 80, 24, "view theme=dark<Enter>show frame=80<Enter><M-3>", SOLVED, false,
     NULL, 0, true},
    {"energy-80x24-light", 80, 24, "view theme=light<Enter>show frame=80<Enter><M-3>", SOLVED,
     false, NULL, 0, true},
    {"table-80x24-dark", 80, 24, "view theme=dark<Enter><M-4>", SOLVED, false, NULL, 0, true},
    {"table-80x24-light", 80, 24, "view theme=light<Enter><M-4>", SOLVED, false, NULL, 0, true},
    {"map-80x24-dark", 80, 24, "view theme=dark<Enter><M-5><F6><Down>p", SWEPT, false, NULL, 0,
     true},
    {"map-80x24-light", 80, 24, "view theme=light<Enter><M-5><F6><Down>p", SWEPT, false, NULL, 0,
     true},
    {"map-200x50-dark", 200, 50, "view theme=dark<Enter><M-5><F6><Down>pp", SWEPT, false, NULL, 0,
     true},
    {"map-200x50-light", 200, 50, "view theme=light<Enter><M-5><F6><Down>pp", SWEPT, false, NULL, 0,
     true},
    {"start-80x24-dark", 80, 24, "view theme=dark<Enter>", EMPTY, false, NULL, 0, true},
    {"start-80x24-light", 80, 24, "view theme=light<Enter>", EMPTY, false, NULL, 0, true},
    {"stale-80x24-dark", 80, 24, "view theme=dark<Enter>vehicle A speed=80<Enter>", SOLVED, false,
     NULL, 0, true},
    {"stale-80x24-light", 80, 24, "view theme=light<Enter>vehicle A speed=80<Enter>", SOLVED, false,
     NULL, 0, true},
    {"compare-80x24-dark", 80, 24,
     "view theme=dark<Enter>compare tests/golden/tui/other.json<Enter>", SOLVED, false, NULL, 0,
     true},
    {"compare-80x24-light", 80, 24,
     "view theme=light<Enter>compare tests/golden/tui/other.json<Enter>", SOLVED, false, NULL, 0,
     true},
};
enum { SHOTS = sizeof shots / sizeof shots[0] };

/* a sweep of which four runs are done and two under way */
struct half_swept {
    struct cr_sweep sweep;
    struct cr_sweep_run run[9];
    struct cr_severity of[9][2];
};

static void sweep_half(struct half_swept *h, struct cr_progress *work) {
    memset(h, 0, sizeof *h);
    h->sweep = (struct cr_sweep){.axes = 1, .n = 9, .participants = 2, .run = h->run};
    snprintf(h->sweep.axis[0].key, sizeof h->sweep.axis[0].key, "B.overlap");
    h->sweep.axis[0].unit = cr_unit_find("%", CR_DIM_NUMBER);
    snprintf(h->sweep.id[0], sizeof h->sweep.id[0], "A");
    snprintf(h->sweep.id[1], sizeof h->sweep.id[1], "B");
    for (int i = 0; i < 9; i++) {
        h->run[i].of = h->of[i];
        h->run[i].at[0] = 0.2 + 0.1 * i;
        h->run[i].done = i < 4;
        h->run[i].running = i == 4 || i == 5;
        h->run[i].stop = CR_STOP_MOMENTUM;
        for (int k = 0; k < 2; k++) {
            h->of[i][k] = (struct cr_severity){
                .ees = 10 + i, .delta_v = 12 + i, .deformation_max = 0.3 + 0.05 * i};
        }
    }
    *work = (struct cr_progress){.what = "SWEEP",
                                 .share = 4.0 / 9,
                                 .done = 4,
                                 .total = 9,
                                 .left = 2,
                                 .time = NAN,
                                 .sweep = &h->sweep};
}

static void test_shot(void **state) {
    const struct shot *s = *state;
    struct tui_double d;
    struct cr_progress work = {
        .what = "SOLVING", .share = s->working, .elapsed = 1, .left = NAN, .time = 0.0385};
    struct half_swept half;
    if (s->working >= 1) {
        sweep_half(&half, &work);
    }
    tui_double_init(&d, s->w, s->h, s->crash != EMPTY, s->crash == PART);
    if (s->crash == COMPARED) {
        tui_double_compare(&d);
    }
    if (s->crash >= SWEPT) {
        tui_double_sweep(&d, s->crash == SWEPT_4 ? 2 : 0, s->crash == DRAWN);
    }
    const struct cr_look look = {.ascii = s->ascii,
                                 .color = s->color ? CR_COLOR_256 : CR_COLOR_NONE};
    cr_session_set_look(d.t->session, &look);
    tui_double_type(&d, s->keys);
    d.t->question = s->question;
    d.t->progress = s->working > 0 ? &work : NULL;
    char *text = tui_double_text(&d);
    int rows = 0;
    for (const char *p = text; *p != '\0'; p++) {
        rows += *p == '\n';
    }
    assert_int_equal(rows, s->h);
    against_golden("tui", s->name, text);
    free(text);
    tui_double_fini(&d);
}

int main(void) {
    struct CMUnitTest tests[SHOTS];
    struct shot room[SHOTS];
    if (setlocale(LC_ALL, "C.UTF-8") == NULL) {
        return 77;
    }
    for (int i = 0; i < SHOTS; i++) {
        room[i] = shots[i];
        tests[i] = (struct CMUnitTest){shots[i].name, test_shot, NULL, NULL, &room[i]};
    }
    return cmocka_run_group_tests_name("screens", tests, NULL, NULL);
}
