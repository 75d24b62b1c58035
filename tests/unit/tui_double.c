/* Runs the full screen without a terminal: keys go in, the screen comes out as text. */
#include "tui_double.h"
#include "test.h"

#include "cmd/cmd_priv.h"
#include "cmd/measure.h"
#include "render/picture.h"

#include <curses.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char scene[] =
    "vehicle A type=suv mass=2400kg length=5m width=2m speed=56km/h; vehicle B type=mini-compact "
    "mass=1200kg length=3.6m width=1.6m speed=56km/h; place B x=6m y=1m heading=180deg";

static void solve(struct tui_double *d, bool interrupted) {
    struct cr_result *r = malloc(sizeof *r);
    assert_non_null(r);
    assert_int_equal(cr_session_script(d->t->session, scene, "scene", 1), CR_ERR_OK);
    render_double_init(&d->crash);
    d->crash.solution.interrupted = interrupted;
    *r = d->crash.result; /* its grids and trace stay with the double */
    for (int i = 0; i < CR_BODY_MAX; i++) {
        r->of[i].outline = NULL;
        r->of[i].outline_n = 0;
    }
    memset(&r->assumed, 0, sizeof r->assumed);
    cr_session_take_result(d->t->session, r);
}

void tui_double_init(struct tui_double *d, int w, int h, bool solved, bool interrupted) {
    struct cr_error err;
    const struct cr_look look = {0};
    const struct cr_tui_start start = {.data_dir = getenv("SRC"), .state_dir = NULL};
    memset(d, 0, sizeof *d);
    setenv("INPUTRC", "/dev/null", 1);
    assert_int_equal(cr_tui_new(&start, &d->t, &err), CR_ERR_OK);
    d->t->w = w;
    d->t->h = h;
    cr_session_set_look(d->t->session, &look);
    cr_prompt_open(d->t, "");
    cr_tui_greet(d->t, "");
    if (solved) {
        solve(d, interrupted);
    }
}

void tui_double_compare(struct tui_double *d) {
    struct cr_reference *ref = malloc(sizeof *ref);
    assert_non_null(ref);
    *ref = (struct cr_reference){.n = 2, .id = {"A", "B"}};
    for (int i = 0; i < 2; i++) {
        cr_measures_clear(&ref->of[i]);
    }
    ref->of[0].ees = 40 / 3.6;
    ref->of[0].delta_v = 35 / 3.6;
    ref->of[0].pdof = cr_rad(5);
    ref->of[1].delta_v = 80 / 3.6;
    d->t->session->reference = ref;
}

static void sweep_axis(struct cr_sweep *sweep, const char *key, int n) {
    struct cr_sweep_axis *axis = &sweep->axis[sweep->axes++];
    snprintf(axis->key, sizeof axis->key, "%s", key);
    axis->n = n;
    axis->unit = cr_unit_find("km/h", CR_DIM_SPEED);
    axis->value = calloc((size_t)n, sizeof *axis->value);
    assert_non_null(axis->value);
    for (int i = 0; i < n; i++) {
        axis->value[i] = (40 + 10 * i) / 3.6;
    }
}

void tui_double_sweep(struct tui_double *d, int more, bool drawn) {
    struct cr_sweep *sweep = calloc(1, sizeof *sweep);
    assert_non_null(sweep);
    for (int a = 0; a < more; a++) {
        sweep_axis(sweep, a == 0 ? "A.course" : "B.course", 2);
    }
    sweep_axis(sweep, "A.speed", 3);
    sweep_axis(sweep, "B.speed", 4);
    *sweep->id[0] = 'A';
    *sweep->id[1] = 'B';
    sweep->participants = 2;
    sweep->drawn = drawn;
    sweep->part = -1;
    sweep->measure = cr_measure_find("ees");
    sweep->n = 12 << more;
    sweep->run = calloc((size_t)sweep->n, sizeof *sweep->run);
    sweep->severity = calloc((size_t)sweep->n * 2, sizeof *sweep->severity);
    assert_true(sweep->run != NULL && sweep->severity != NULL);
    for (int i = 0; i < sweep->n; i++) {
        struct cr_sweep_run *run = &sweep->run[i];
        int rest = i;
        for (int a = sweep->axes - 1; a >= 0; a--) {
            run->at[a] = sweep->axis[a].value[rest % sweep->axis[a].n];
            rest /= sweep->axis[a].n;
        }
        run->done = true;
        run->stop = CR_STOP_MOMENTUM;
        run->of = sweep->severity + 2 * (size_t)i;
        run->of[0].ees = (run->at[more] + run->at[more + 1]) / 2;
        run->of[1].ees = run->at[more] + run->at[more + 1] + 5 * run->at[0];
    }
    cr_session_take_sweep(d->t->session, sweep);
}

void tui_double_fini(struct tui_double *d) {
    cr_prompt_close();
    cr_tui_free(d->t);
    render_double_fini(&d->crash);
}

/* ---- keys ---- */

static const struct {
    const char *name;
    bool function;
    wint_t code;
} keys[] = {
    {"Enter", false, '\r'},        {"Tab", false, '\t'},        {"Esc", false, 27},
    {"Space", false, ' '},         {"Up", true, KEY_UP},        {"Down", true, KEY_DOWN},
    {"Left", true, KEY_LEFT},      {"Right", true, KEY_RIGHT},  {"Home", true, KEY_HOME},
    {"End", true, KEY_END},        {"BS", true, KEY_BACKSPACE}, {"S-Left", true, KEY_SLEFT},
    {"S-Right", true, KEY_SRIGHT},
};

static struct cr_input named(const char *name, size_t n) {
    if (n > 1 && name[0] == 'F') {
        return (struct cr_input){.function = true,
                                 .code = (wint_t)KEY_F(strtol(name + 1, NULL, 10))};
    }
    if (n == 3 && name[1] == '-') {
        return (struct cr_input){.alt = name[0] == 'M',
                                 .code = (wint_t)(name[0] == 'M' ? name[2] : name[2] - 'a' + 1)};
    }
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        if (strlen(keys[i].name) == n && strncmp(keys[i].name, name, n) == 0) {
            return (struct cr_input){.function = keys[i].function, .code = keys[i].code};
        }
    }
    fail_msg("no key is called %.*s", (int)n, name);
    return (struct cr_input){0};
}

/* what is on the screen decides where a key goes */
static void give(struct tui_double *d, const struct cr_input *in) {
    struct cr_error err;
    int x;
    assert_int_equal(cr_tui_compose(d->t, &x, &err), CR_ERR_OK);
    cr_tui_input(d->t, in);
}

void tui_double_type(struct tui_double *d, const char *text) {
    while (*text != '\0') {
        const char *end = *text == '<' && text[1] != '\0' ? strchr(text, '>') : NULL;
        struct cr_input in = {.code = (wint_t)(unsigned char)*text};
        if (end != NULL) {
            in = named(text + 1, (size_t)(end - text - 1));
            text = end;
        }
        give(d, &in);
        text++;
    }
}

void tui_double_mouse(struct tui_double *d, unsigned long buttons, int x, int y) {
    const struct cr_input in = {
        .function = true, .code = KEY_MOUSE, .mouse = buttons, .x = x, .y = y};
    give(d, &in);
}

/* ---- what came of it ---- */

char *tui_double_text(struct tui_double *d) {
    struct cr_str text = {0};
    struct cr_error err;
    struct cr_look look = cr_tui_look(d->t);
    int x;
    if (cr_tui_compose(d->t, &x, &err) != CR_ERR_OK) {
        fail_msg("%s", err.text);
    }
    if (x >= 0) { /* the cursor, as a block */
        d->t->cells.cell[d->t->layout.prompt.y * d->t->w + x].ch = look.ascii ? '_' : 0x2588;
    }
    cr_cells_text(&d->t->cells, &look, &text);
    return text.s;
}

const char *tui_double_command(const struct tui_double *d) {
    static const char prompt[] = "crumple> ";
    for (int i = d->t->log.n - 1; i >= 0; i--) {
        if (strncmp(d->t->log.line[i].text, prompt, sizeof prompt - 1) == 0) {
            return d->t->log.line[i].text + sizeof prompt - 1;
        }
    }
    return "";
}
