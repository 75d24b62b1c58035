/* The one table of keys: what is pressed where, what it is called in the key bar and in the help,
 * and the command line it stands for. */
#include "tui/tui_priv.h"

#include "render/picture.h"
#include "render/theme.h"

#include <curses.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define BIT(area) (1u << CR_AREA_##area)
enum {
    AT_PROMPT = 1u << CR_AREAS,
    PANES = (1u << CR_AREAS) - 1,
    EVERYWHERE = PANES | AT_PROMPT,
    TIMED = BIT(PULSE) | BIT(ENERGY),
    PAGED = BIT(LOG) | BIT(TABLE)
};
#define TWICE_S 0.4 /* two Tabs within this time are one key */
enum kind { CHARACTER, FUNCTION, ALT, READLINE };

struct key {
    const char *shown; /* in help and bar, NULL: with the row above */
    const char *label; /* in the bar, NULL: not there */
    const char *help;  /* in the help overlay */
    unsigned where;    /* bits: areas, AT_PROMPT */
    enum kind kind;    /* READLINE: only told about, the prompt acts on it */
    wint_t code;
    const char *command; /* run as it stands, $ is the participant chosen; NULL: see act */
    void (*act)(struct cr_tui *t, int arg);
    int arg;
};

/* ---- what is not just a command ---- */

void cr_tui_focus(struct cr_tui *t, enum cr_area pane) {
    t->focus = pane;
    t->dirty = true;
}

static enum cr_area front(const struct cr_tui *t) {
    return cr_session_view(t->session)->pane;
}

static void view(struct cr_tui *t, int pane) {
    char line[40];
    snprintf(line, sizeof line, "view %s", cr_area_word((enum cr_area)pane));
    cr_tui_run_key(t, line);
    if (t->focus != CR_AREAS || t->layout.kind == CR_LAYOUT_ALL) {
        cr_tui_focus(t, (enum cr_area)pane);
    }
}

static void next_pane(struct cr_tui *t, int step) {
    bool all = t->layout.kind == CR_LAYOUT_ALL && !cr_session_view(t->session)->zoom;
    int here = (int)t->focus;
    if (here == CR_AREAS && !all) {
        cr_tui_focus(t, front(t));
        return;
    }
    here = (here + step + CR_AREAS + 1) % (CR_AREAS + 1);
    if (here == CR_AREAS || all) {
        cr_tui_focus(t, (enum cr_area)here);
    } else {
        cr_tui_focus(t, (enum cr_area)here);
        view(t, here);
    }
}

static void open_overlay(struct cr_tui *t, int which) {
    t->overlay = (enum cr_overlay)which;
    t->filter[0] = '\0';
    t->chosen = 0;
    t->dirty = true;
}

/* the next pane; twice at once on an empty line: the palette, and the focus is where it was */
static void tab(struct cr_tui *t, int step) {
    if (t->focus != CR_AREAS && t->keys_at - t->tabbed_at < TWICE_S) {
        cr_tui_focus(t, CR_AREAS);
        open_overlay(t, CR_OVERLAY_PALETTE);
        return;
    }
    t->tabbed_at = t->focus == CR_AREAS ? t->keys_at : -1;
    next_pane(t, step);
}

static void solve(struct cr_tui *t, int arg) {
    (void)arg;
    cr_play_stop(t);
    cr_tui_run_key(t, "solve");
    if (!t->failed && cr_session_state(t->session) == CR_STATE_SOLVED) {
        cr_play_start(t, 0);
    }
}

static void play(struct cr_tui *t, int arg) {
    (void)arg;
    cr_play_toggle(t);
}

static void loop(struct cr_tui *t, int arg) {
    (void)arg;
    cr_tui_run_key(t, cr_session_view(t->session)->loop ? "play loop=off" : "play loop=on");
}

/* < and > while it plays: its rate; else the speed of who is chosen */
static void slower_faster(struct cr_tui *t, int step) {
    const char *who = cr_session_view(t->session)->selected;
    char line[CR_NAME_MAX + 40];
    if (t->play.on || t->paused || who[0] == '\0') {
        cr_play_rate(t, step);
        return;
    }
    snprintf(line, sizeof line, "move %s speed=%dkm/h", who, step);
    cr_tui_run_key(t, line);
}

static void ghost(struct cr_tui *t, int arg) {
    (void)arg;
    cr_tui_run_key(t, cr_session_view(t->session)->ghost ? "show ghost=off" : "show ghost=on");
}

static void ask_for(struct cr_tui *t, const char *line) {
    cr_prompt_set(line);
    cr_tui_focus(t, CR_AREAS);
}

static void save(struct cr_tui *t, int arg) {
    (void)arg;
    if (cr_session_file(t->session)[0] != '\0') {
        cr_tui_run_key(t, "save");
    } else {
        ask_for(t, "save ");
    }
}

static void zoom(struct cr_tui *t, int arg) {
    char line[60];
    (void)arg;
    enum cr_area pane = t->focus == CR_AREAS ? front(t) : t->focus;
    snprintf(line, sizeof line, "view %s zoom=%s", cr_area_word(pane),
             cr_session_view(t->session)->zoom ? "off" : "on");
    cr_tui_run_key(t, line);
}

static void redraw(struct cr_tui *t, int arg) {
    (void)arg;
    cr_term_redraw();
    t->dirty = true;
}

static void suspend(struct cr_tui *t, int arg) {
    (void)t;
    (void)arg;
    cr_signal_stopping = 1;
}

static void cancel(struct cr_tui *t, int arg) {
    (void)arg;
    cr_play_stop(t);
    cr_prompt_clear();
    cr_completion_fini(&t->candidates);
    t->sheet_from = -1;
    cr_tui_focus(t, CR_AREAS);
}

/* from the nearest thing that can be left: sheet, choice, pane */
static void escape(struct cr_tui *t, int arg) {
    (void)arg;
    if (t->sheet_from >= 0 || t->candidates.n > 0) {
        t->sheet_from = -1;
        cr_completion_fini(&t->candidates);
        t->dirty = true;
    } else if (t->focus == CR_AREA_SCENE && cr_session_view(t->session)->selected[0] != '\0') {
        cr_tui_run_key(t, "show select=none");
    } else {
        cr_tui_focus(t, CR_AREAS);
    }
}

static void choose_next(struct cr_tui *t, int arg) {
    const struct cr_scene *scene = cr_session_scene(t->session);
    int now = cr_session_scene_view(t->session).selected;
    char line[CR_NAME_MAX + 20];
    (void)arg;
    if (scene->n > 0) {
        snprintf(line, sizeof line, "show select=%s", scene->part[(now + 1) % scene->n].id);
        cr_tui_run_key(t, line);
    }
}

static void change_speed(struct cr_tui *t, int arg) {
    int i = cr_session_scene_view(t->session).selected;
    char line[CR_NAME_MAX + 20];
    (void)arg;
    if (i >= 0) {
        const struct cr_participant *p = &cr_session_scene(t->session)->part[i];
        snprintf(line, sizeof line,
                 "%s %s speed=", p->kind == CR_KIND_VEHICLE ? "vehicle" : "object", p->id);
        ask_for(t, line);
    }
}

static void next_field(struct cr_tui *t, int arg) {
    char line[40];
    (void)arg;
    snprintf(line, sizeof line, "show field=%s",
             cr_field_word((cr_session_view(t->session)->field + 1) % CR_FIELDS));
    cr_tui_run_key(t, line);
}

static void next_map(struct cr_tui *t, int arg) {
    char line[40];
    int i = 0;
    (void)arg;
    while (i < CR_COLORMAPS - 1 && strcmp(cr_colormap_word((enum cr_colormap)i),
                                          cr_session_view(t->session)->colormap) != 0) {
        i++;
    }
    snprintf(line, sizeof line, "show colormap=%s",
             cr_colormap_word((enum cr_colormap)((i + 1) % CR_COLORMAPS)));
    cr_tui_run_key(t, line);
}

static void next_theme(struct cr_tui *t, int arg) {
    int i = 0, n = cr_theme_count() - 1; /* the last one is for NO_COLOR */
    char line[60];
    (void)arg;
    while (i < n - 1 && strcmp(cr_theme_get(i)->name, cr_session_view(t->session)->theme) != 0) {
        i++;
    }
    snprintf(line, sizeof line, "view theme=%s", cr_theme_get((i + 1) % n)->name);
    cr_tui_run_key(t, line);
}

static void arrows(struct cr_tui *t, int arg) {
    (void)arg;
    cr_tui_run_key(t,
                   cr_session_view(t->session)->vectors ? "show vectors=off" : "show vectors=on");
}

static void next_quantity(struct cr_tui *t, int step) {
    static const struct {
        enum cr_quantity quantity;
        const char *word;
    } shown[] = {{CR_QUANTITIES, "a"},         {CR_QUANTITY_AX, "ax"},
                 {CR_QUANTITY_AY, "ay"},       {CR_QUANTITY_VX, "vx"},
                 {CR_QUANTITY_VY, "vy"},       {CR_QUANTITY_YAW_RATE, "yawrate"},
                 {CR_QUANTITY_FORCE, "force"}, {CR_QUANTITY_ENERGY, "energy"}};
    enum { N = sizeof shown / sizeof *shown };
    char line[40];
    int i = 0;
    while (i < N - 1 && shown[i].quantity != cr_session_view(t->session)->quantity) {
        i++;
    }
    snprintf(line, sizeof line, "pulse all %s", shown[(i + step + N) % N].word);
    cr_tui_run_key(t, line);
}

static void scroll_pane(struct cr_tui *t, int rows) {
    int *at = t->focus == CR_AREA_TABLE ? &t->table_down : &t->log_back;
    *at += t->focus == CR_AREA_TABLE ? rows : -rows;
    *at = *at < 0 ? 0 : *at;
    const struct cr_result *r = cr_session_result(t->session);
    const struct cr_reference *ref = cr_session_reference(t->session);
    int of_table = r != NULL ? cr_render_table_rows_beside(r, ref) : 0;
    int most = t->focus == CR_AREA_TABLE ? of_table : t->log.n;
    *at = *at > most ? most : *at;
    t->dirty = true;
}

static void scroll_sheet(struct cr_tui *t, int rows) {
    int down = t->sheet_down + rows; /* drawing keeps it within the answer */
    t->sheet_down = down < 0 ? 0 : down > CR_SHEET_END ? CR_SHEET_END : down;
    t->dirty = true;
}

static void export_run(struct cr_tui *t, int arg) {
    (void)arg;
    ask_for(t, "export sweep ");
}

/* in the scene arrows move who is chosen; with nobody chosen, and in plots, they step in time */
static void arrow(struct cr_tui *t, int key) {
    static const struct {
        int key;
        const char *move, *step;
    } rows[] = {{KEY_LEFT, "dx=-0.1m", "-1"},    {KEY_RIGHT, "dx=0.1m", "+1"},
                {KEY_DOWN, "dy=-0.1m", "-10"},   {KEY_UP, "dy=0.1m", "+10"},
                {KEY_SLEFT, "dx=-0.01m", "-10"}, {KEY_SRIGHT, "dx=0.01m", "+10"},
                {KEY_SF, "dy=-0.01m", "-1"},     {KEY_SR, "dy=0.01m", "+1"}};
    const char *who = cr_session_view(t->session)->selected;
    char line[CR_NAME_MAX + 40];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (rows[i].key == key && t->focus == CR_AREA_SCENE && who[0] != '\0') {
            snprintf(line, sizeof line, "move %s %s", who, rows[i].move);
            cr_tui_run_key(t, line);
        } else if (rows[i].key == key) {
            snprintf(line, sizeof line, "show frame=%s", rows[i].step);
            cr_tui_run_key(t, line);
        }
    }
}

/* ---- the table ---- */

#define ROW(shown_as, in_bar, says, places, type, key)                                             \
    .shown = shown_as, .label = in_bar, .help = says, .where = places, .kind = type, .code = key
#define ALSO(places, type, key) .where = places, .kind = type, .code = key
#define CTRL(c)                 ((c)-64)
#define SCENE                   BIT(SCENE)

static const struct key keys[] = {
    {ROW("F1", "help", "these keys", EVERYWHERE, FUNCTION, KEY_F(1)), .act = open_overlay,
     .arg = CR_OVERLAY_HELP},
    {ALSO(PANES, CHARACTER, '?'), .act = open_overlay, .arg = CR_OVERLAY_HELP},
    {ROW("F5", "solve", "solve, watch (pane: s)", EVERYWHERE, FUNCTION, KEY_F(5)), .act = solve},
    {ALSO(PANES, CHARACTER, 's'), .act = solve},
    {ROW("Space", "play", "play, pause (empty line)", EVERYWHERE, CHARACTER, ' '), .act = play},
    {ROW("F6", "panes", "next pane (empty: Tab)", EVERYWHERE, FUNCTION, KEY_F(6)), .act = next_pane,
     .arg = 1},
    {ALSO(EVERYWHERE, CHARACTER, '\t'), .act = tab, .arg = 1},
    {ALSO(EVERYWHERE, FUNCTION, KEY_BTAB), .act = next_pane, .arg = -1},
    {ROW("Tab", "complete", "complete, list", AT_PROMPT, READLINE, 0)},
    {ROW("^C", "cancel", "stop work, clear the line", EVERYWHERE, CHARACTER, CTRL('C')),
     .act = cancel},
    {ROW("F10", "quit", "leave (pane: q, else ^D)", EVERYWHERE, FUNCTION, KEY_F(10)),
     .command = "quit"},
    {ALSO(PANES, CHARACTER, 'q'), .command = "quit"},
    {ALSO(EVERYWHERE, CHARACTER, CTRL('D')), .command = "quit"},
    {ROW("^R", "history", "search the history", AT_PROMPT, READLINE, 0)},
    {ROW("F2", "save", "save the scene (pane: w)", EVERYWHERE, FUNCTION, KEY_F(2)), .act = save},
    {ALSO(PANES, CHARACTER, 'w'), .act = save},
    {ROW("F7 F8", "frame", "slice back, on ([ ])", EVERYWHERE, FUNCTION, KEY_F(7)),
     .command = "show frame=-1"},
    {ALSO(EVERYWHERE, FUNCTION, KEY_F(8)), .command = "show frame=+1"},
    {ALSO(PANES, CHARACTER, '['), .command = "show frame=-1"},
    {ALSO(PANES, CHARACTER, ']'), .command = "show frame=+1"},
    {ROW("F9", "palette", "all commands (Tab Tab)", EVERYWHERE, FUNCTION, KEY_F(9)),
     .act = open_overlay, .arg = CR_OVERLAY_PALETTE},
    {ALSO(PANES, CHARACTER, ':'), .act = open_overlay, .arg = CR_OVERLAY_PALETTE},
    {ALSO(PANES, CHARACTER, '/'), .act = open_overlay, .arg = CR_OVERLAY_PALETTE},
    {ROW("^L", "redraw", "draw all again", EVERYWHERE, CHARACTER, CTRL('L')), .act = redraw},
    {ROW("^Z", "suspend", "to the shell; fg returns", EVERYWHERE, CHARACTER, CTRL('Z')),
     .act = suspend},
    {ROW("Esc", NULL, "close, back to the prompt", EVERYWHERE, CHARACTER, 27), .act = escape},
    {ROW("PgUp PgDn", NULL, "scroll a long answer", AT_PROMPT, FUNCTION, KEY_PPAGE),
     .act = scroll_sheet, .arg = -5},
    {ALSO(AT_PROMPT, FUNCTION, KEY_NPAGE), .act = scroll_sheet, .arg = 5},
    {ROW("Alt-1..6", NULL, "that pane (pane: 1..6)", EVERYWHERE, ALT, '1'), .act = view, .arg = 0},
    {ALSO(EVERYWHERE, ALT, '2'), .act = view, .arg = 1},
    {ALSO(EVERYWHERE, ALT, '3'), .act = view, .arg = 2},
    {ALSO(EVERYWHERE, ALT, '4'), .act = view, .arg = 3},
    {ALSO(EVERYWHERE, ALT, '5'), .act = view, .arg = 4},
    {ALSO(EVERYWHERE, ALT, '6'), .act = view, .arg = 5},
    {ALSO(PANES, CHARACTER, '1'), .act = view, .arg = 0},
    {ALSO(PANES, CHARACTER, '2'), .act = view, .arg = 1},
    {ALSO(PANES, CHARACTER, '3'), .act = view, .arg = 2},
    {ALSO(PANES, CHARACTER, '4'), .act = view, .arg = 3},
    {ALSO(PANES, CHARACTER, '5'), .act = view, .arg = 4},
    {ALSO(PANES, CHARACTER, '6'), .act = view, .arg = 5},
    {ROW("{ }", NULL, "ten slices back, on", PANES, CHARACTER, '{'), .command = "show frame=-10"},
    {ALSO(PANES, CHARACTER, '}'), .command = "show frame=+10"},
    {ROW("g G", NULL, "first touch, end", PANES, CHARACTER, 'g'), .command = "show time=start"},
    {ALSO(PANES, CHARACTER, 'G'), .command = "show time=end"},
    {ALSO(PANES, FUNCTION, KEY_HOME), .command = "show time=start"},
    {ALSO(PANES, FUNCTION, KEY_END), .command = "show time=end"},
    {ROW("a b n", "choose", "(Alt-)letter; next one", SCENE, CHARACTER, 'n'), .act = choose_next},
    {ROW("arrows", "move", "by 0.1 m (Shift: 1 cm)", SCENE, FUNCTION, KEY_LEFT), .act = arrow,
     .arg = KEY_LEFT},
    {ALSO(SCENE, FUNCTION, KEY_RIGHT), .act = arrow, .arg = KEY_RIGHT},
    {ALSO(SCENE, FUNCTION, KEY_UP), .act = arrow, .arg = KEY_UP},
    {ALSO(SCENE, FUNCTION, KEY_DOWN), .act = arrow, .arg = KEY_DOWN},
    {ALSO(SCENE, FUNCTION, KEY_SLEFT), .act = arrow, .arg = KEY_SLEFT},
    {ALSO(SCENE, FUNCTION, KEY_SRIGHT), .act = arrow, .arg = KEY_SRIGHT},
    {ALSO(SCENE, FUNCTION, KEY_SR), .act = arrow, .arg = KEY_SR},
    {ALSO(SCENE, FUNCTION, KEY_SF), .act = arrow, .arg = KEY_SF},
    {ROW("r R", "turn", "by 1 deg", SCENE, CHARACTER, 'r'), .command = "move $ turn=1deg"},
    {ALSO(SCENE, CHARACTER, 'R'), .command = "move $ turn=-1deg"},
    {ROW("< >", "speed", "who is chosen; playing", SCENE, CHARACTER, '<'), .act = slower_faster,
     .arg = -1},
    {ALSO(SCENE, CHARACTER, '>'), .act = slower_faster, .arg = 1},
    {ALSO(PANES, CHARACTER, '<'), .act = cr_play_rate, .arg = -1},
    {ALSO(PANES, CHARACTER, '>'), .act = cr_play_rate, .arg = 1},
    {ROW("o", NULL, "play over and over", PANES, CHARACTER, 'o'), .act = loop},
    {ROW("i", NULL, "outlines of the start", SCENE, CHARACTER, 'i'), .act = ghost},
    {ROW("v", NULL, "type the speed", SCENE, CHARACTER, 'v'), .act = change_speed},
    {ROW("u U", "undo", "undo, redo", PANES, CHARACTER, 'u'), .command = "undo"},
    {ALSO(PANES, CHARACTER, 'U'), .command = "redo"},
    {ROW("c", "field", "EES energy crush depth", SCENE, CHARACTER, 'c'), .act = next_field},
    {ROW("m", NULL, "next colour map", SCENE, CHARACTER, 'm'), .act = next_map},
    {ROW("f", NULL, "arrows on or off", SCENE, CHARACTER, 'f'), .act = arrows},
    {ROW("e", "explain", "Eq. 1-5 of this slice", PANES, CHARACTER, 'e'), .command = "explain"},
    {ROW("+ - 0", NULL, "larger, smaller, all", SCENE, CHARACTER, '+'), .act = cr_scene_zoom,
     .arg = -1},
    {ALSO(SCENE, CHARACTER, '-'), .act = cr_scene_zoom, .arg = 1},
    {ALSO(SCENE, CHARACTER, '='), .act = cr_scene_zoom, .arg = -1},
    {ALSO(SCENE, CHARACTER, '0'), .command = "show scale=auto follow=cog"},
    {ROW("h j k l", NULL, "move the picture", SCENE, CHARACTER, 'h'), .act = cr_scene_pan,
     .arg = 'h'},
    {ALSO(SCENE, CHARACTER, 'j'), .act = cr_scene_pan, .arg = 'j'},
    {ALSO(SCENE, CHARACTER, 'k'), .act = cr_scene_pan, .arg = 'k'},
    {ALSO(SCENE, CHARACTER, 'l'), .act = cr_scene_pan, .arg = 'l'},
    {ROW("Left Right", "step", "a time slice back, on", TIMED, FUNCTION, KEY_LEFT), .act = arrow,
     .arg = KEY_LEFT},
    {ALSO(TIMED | AT_PROMPT, FUNCTION, KEY_RIGHT), .act = arrow, .arg = KEY_RIGHT},
    {ALSO(AT_PROMPT, FUNCTION, KEY_LEFT), .act = arrow, .arg = KEY_LEFT},
    {ROW("Up Down", "quantity", "a, ax, vx, force ...", BIT(PULSE), FUNCTION, KEY_UP),
     .act = next_quantity, .arg = -1},
    {ALSO(BIT(PULSE), FUNCTION, KEY_DOWN), .act = next_quantity, .arg = 1},
    {ROW("Up Down", "scroll", "and PgUp PgDn", PAGED, FUNCTION, KEY_UP), .act = scroll_pane,
     .arg = -1},
    {ALSO(PAGED, FUNCTION, KEY_DOWN), .act = scroll_pane, .arg = 1},
    {ALSO(PAGED, FUNCTION, KEY_PPAGE), .act = scroll_pane, .arg = -10},
    {ALSO(PAGED, FUNCTION, KEY_NPAGE), .act = scroll_pane, .arg = 10},
    {ROW("Up Down", "choose", "a run of the sweep", BIT(SWEEP), FUNCTION, KEY_UP),
     .act = cr_sweep_choose, .arg = -1},
    {ALSO(BIT(SWEEP), FUNCTION, KEY_DOWN), .act = cr_sweep_choose, .arg = 1},
    {ROW("Enter", "take", "its values into the scene", BIT(SWEEP), CHARACTER, '\r'),
     .act = cr_sweep_take},
    {ALSO(BIT(SWEEP), FUNCTION, KEY_ENTER), .act = cr_sweep_take},
    {ROW("p", "picture", "curve or map; the table", BIT(SWEEP), CHARACTER, 'p'),
     .act = cr_sweep_turn},
    {ROW("x", NULL, "export the sweep", BIT(SWEEP), CHARACTER, 'x'), .act = export_run},
    {ROW("z", "zoom", "this pane alone, back", PANES, CHARACTER, 'z'), .act = zoom},
    {ROW("t", NULL, "theme: dark, light, ...", PANES, CHARACTER, 't'), .act = next_theme},
    {ROW("mouse", NULL, "choose, drag, scrub, zoom", PANES, READLINE, 0)},
};
enum { KEYS = sizeof keys / sizeof *keys };

/* ---- finding and running ---- */

static unsigned place(const struct cr_tui *t) {
    return 1u << t->focus;
}

/* At the prompt these belong to the line being typed, unless it is empty. */
static bool for_the_line(const struct cr_tui *t, const struct key *k) {
    bool editing =
        (k->kind == CHARACTER && (k->code == ' ' || k->code == '\t' || k->code == CTRL('D'))) ||
        (k->kind == FUNCTION &&
         (k->code == KEY_LEFT || k->code == KEY_RIGHT || k->code == KEY_BTAB));
    bool searching = k->kind == CHARACTER && k->code == 27;
    if (t->focus != CR_AREAS) {
        return false;
    }
    return (editing && !cr_prompt_empty()) ||
           (searching && t->sheet_from < 0 && t->candidates.n == 0 && !cr_prompt_empty());
}

static const struct key *find(const struct cr_tui *t, const struct cr_input *in) {
    enum kind kind = in->alt ? ALT : in->function ? FUNCTION : CHARACTER;
    for (int i = 0; i < KEYS; i++) {
        if (keys[i].kind == kind && keys[i].code == in->code && (keys[i].where & place(t)) != 0 &&
            !for_the_line(t, &keys[i])) {
            return &keys[i];
        }
    }
    return NULL;
}

static void run_command(struct cr_tui *t, const char *command) {
    const char *who = strchr(command, '$');
    const char *chosen = cr_session_view(t->session)->selected;
    char line[CR_NAME_MAX + 80];
    if (who == NULL) {
        cr_tui_run_key(t, command);
    } else if (chosen[0] == '\0') {
        cr_dialogue_add(&t->log, CR_ROLE_WARN,
                        "  choose a participant first: its letter, n for the next, or a click");
        t->dirty = true;
    } else {
        snprintf(line, sizeof line, "%.*s%s%s", (int)(who - command), command, chosen, who + 1);
        cr_tui_run_key(t, line);
    }
}

static void press(struct cr_tui *t, const struct key *k) {
    if (k->act != tab) {
        t->tabbed_at = -1;
    }
    bool goes_on = k->act == play || k->act == redraw || k->act == suspend ||
                   k->act == open_overlay || k->act == slower_faster || k->act == cr_play_rate ||
                   k->act == loop || k->act == ghost;
    if (!goes_on) {
        cr_play_stop(t);
    }
    if (k->command != NULL) {
        run_command(t, k->command);
    } else if (k->act != NULL) {
        k->act(t, k->arg);
    }
}

/* changes nothing but what is seen */
static bool looks(const struct cr_tui *t, const struct key *k) {
    static void (*const changing[])(struct cr_tui * t, int arg) = {
        solve, save, cancel, change_speed, cr_sweep_take, export_run};
    if (k->command != NULL) {
        return strncmp(k->command, "show ", 5) == 0 || strcmp(k->command, "explain") == 0;
    }
    for (size_t i = 0; i < sizeof changing / sizeof *changing; i++) {
        if (k->act == changing[i]) {
            return false;
        }
    }
    bool moves = k->act == arrow && t->focus == CR_AREA_SCENE &&
                 cr_session_view(t->session)->selected[0] != '\0';
    return !moves && !(k->act == open_overlay && k->arg == CR_OVERLAY_PALETTE);
}

bool cr_tui_key(struct cr_tui *t, const struct cr_input *in) {
    const struct key *k = find(t, in);
    if (k != NULL && (!t->paused || looks(t, k))) {
        press(t, k);
    }
    return k != NULL;
}

void cr_tui_press(struct cr_tui *t, const char *name) {
    for (int i = 0; i < KEYS; i++) {
        if (keys[i].shown != NULL && strcmp(keys[i].shown, name) == 0 &&
            (keys[i].where & place(t)) != 0) {
            press(t, &keys[i]);
            return;
        }
    }
}

int cr_tui_bar(const struct cr_tui *t, struct cr_render_key *out, int max) {
    int n = 0;
    if (t->paused) {
        return cr_lesson_bar(out, max);
    }
    /* in a pane its own keys come first */
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < KEYS && n < max; i++) {
            bool own = keys[i].where != EVERYWHERE && keys[i].where != PANES;
            if (keys[i].label != NULL && (keys[i].where & place(t)) != 0 &&
                (t->focus == CR_AREAS ? pass == 0 : own == (pass == 0))) {
                out[n++] = (struct cr_render_key){keys[i].shown, keys[i].label};
            }
        }
    }
    return n;
}

int cr_tui_help_rows(const struct cr_tui *t, struct cr_help_row *out, int max) {
    int n = 0;
    unsigned here = t->focus == CR_AREAS ? 1u << front(t) : place(t);
    static const char *const heads[] = {"Anywhere", "In this pane (F6, click)"};
    for (int pass = 0; pass < 2 && n < max; pass++) {
        out[n++] = (struct cr_help_row){heads[pass], "", true};
        for (int i = 0; i < KEYS && n < max; i++) {
            bool anywhere = (keys[i].where & AT_PROMPT) != 0;
            bool fits = pass == 0 ? anywhere : !anywhere && (keys[i].where & here) != 0;
            if (keys[i].shown != NULL && fits) {
                out[n++] = (struct cr_help_row){keys[i].shown, keys[i].help, false};
            }
        }
    }
    return n;
}
