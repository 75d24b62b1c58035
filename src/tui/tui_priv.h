/* What the files of the full screen share. */
#ifndef CR_TUI_TUI_PRIV_H
#define CR_TUI_TUI_PRIV_H

#include "cmd/cmd.h"
#include "process/clock.h"
#include "process/signals.h"
#include "render/screen.h"
#include "tui/frame.h"
#include "tui/ground.h"
#include "tui/tui.h"

#include <stdbool.h>
#include <wchar.h>

/* ---- terminal (term.c): curses, captured standard error ---- */

/* Takes the terminal over, or says why not; cr_term_close gives it back and may be called twice. */
CR_MUST_CHECK enum cr_err cr_term_open(struct cr_error *err);
void cr_term_close(void);
/* Stops this process as ^Z does, and takes the terminal again when it goes on. */
void cr_term_suspend(void);
/* Takes over the terminal's new size. */
void cr_term_resize(int *w, int *h);
/* Everything is to be drawn again, whatever the terminal shows; how often that was asked. */
void cr_term_redraw(void);
unsigned cr_term_redraws(void);
enum cr_color cr_term_color(void);   /* colours of the terminal, NO_COLOR considered */
enum cr_ground cr_term_ground(void); /* of the terminal, as far as it has told */
bool cr_term_ascii(void);            /* no UTF-8, or block characters of a doubtful width */

bool cr_term_console(void); /* the Linux console: few glyphs */

/* Waits for a key or a signal, at most so many ms (-1: any time). False: the terminal is gone. */
bool cr_term_wait(int ms);

/* A key or a character. */
struct cr_input {
    bool function; /* code is a KEY_ of curses, else a character */
    bool alt;      /* came after an escape */
    wint_t code;
    int x, y;            /* of the mouse */
    unsigned long mouse; /* its buttons, when code is KEY_MOUSE */
};
bool cr_term_read(struct cr_input *out); /* false: no key is waiting */
/* A function key of its own: something was pasted, and is in cr_term_pasted(). */
enum { CR_KEY_PASTE = 2100 };
/* What was pasted since the last call; valid until more is. */
const char *cr_term_pasted(void);

/* ---- standard error (stderr.c) ---- */

void cr_stderr_capture(void);
void cr_stderr_restore(void); /* for a handler of signals: only calls that POSIX allows there */
void cr_stderr_release(void);
/* What libraries have written to it since the last call, appended to out. */
void cr_term_stderr(struct cr_str *out);

/* ---- events of the mouse (pointer.c) ---- */

/* An event being read, after what it begins with. */
struct cr_pointer {
    bool on;
    bool decimal; /* form of mode 1006 (SGR), else the old one (X10) */
    int n;        /* fields read */
    int field[3]; /* button, column, row */
};
#define CR_POINTER_DECIMAL    "\033[<"
#define CR_POINTER_CHARACTERS "\033[M"
enum cr_pointer_step { CR_POINTER_MORE, CR_POINTER_DONE, CR_POINTER_NOT };
void cr_pointer_begin(struct cr_pointer *p, bool decimal);
/* The next character. DONE: *out is the event, KEY_MOUSE with buttons of curses (0: none that
 * matters); NOT: it was none, and `in` is a key of its own. */
enum cr_pointer_step cr_pointer_read(struct cr_pointer *p, const struct cr_input *in,
                                     struct cr_input *out);

/* ---- what is pasted (paste.c) ---- */

/* The text between the terminal's marks (bracketed paste). */
struct cr_paste {
    bool on, taken, cut; /* taken: somebody has looked; cut: there was more than 1 MB */
    bool returned;       /* the last character was a CR */
    double last;         /* s, of its last character */
    struct cr_str text;  /* UTF-8: line ends are LF, tabs blanks, nothing in it acts */
};
#define CR_PASTE_BEGIN "\033[200~"
#define CR_PASTE_END   "\033[201~"
void cr_paste_begin(struct cr_paste *p, double now);
void cr_paste_char(struct cr_paste *p, const struct cr_input *in, double now);
bool cr_paste_silent(const struct cr_paste *p, double now); /* its end mark does not come */
const char *cr_paste_end(struct cr_paste *p);               /* without blank ends */

/* ---- drawing cells (paint.c) ---- */

/* Brings the terminal up to date with the cells, which are of its size. cursor < 0: hidden. */
void cr_paint(const struct cr_cells *cells, const struct cr_look *look, int cursor_x, int cursor_y);
void cr_paint_forget(void); /* the next cr_paint draws every cell */

/* ---- dialogue (log.c) ---- */

/* Lines of commands and answers, as they are shown; texts owned. */
struct cr_dialogue {
    struct cr_render_line *line;
    int n, size;
    int repeats; /* of the last line, when it is a command run by a key */
    char *again; /* that command, NULL: none */
};
void cr_dialogue_add(struct cr_dialogue *d, enum cr_role role, const char *text);
/* A command that a key has run: the same again is counted instead of repeated. */
void cr_dialogue_key(struct cr_dialogue *d, const char *command);
void cr_dialogue_fini(struct cr_dialogue *d);
/* The lines from `from` on, folded to a width; the caller frees the result with
 * cr_dialogue_fini. */
void cr_dialogue_fold(const struct cr_dialogue *d, int from, int width, struct cr_dialogue *out);

/* ---- prompt (prompt.c): readline without its screen ---- */

struct cr_tui;
void cr_prompt_open(struct cr_tui *t, const char *state_dir);
void cr_prompt_close(void);
/* A character or key for the line being typed. */
void cr_prompt_key(const struct cr_input *in);
const char *cr_prompt_line(int *point); /* the line so far, and its cursor in bytes */
bool cr_prompt_empty(void);
void cr_prompt_set(const char *line); /* replaces what is typed */
/* Puts a text into the line as if it were typed, but for its keys: lines stay lines in it. */
void cr_prompt_insert(const char *text);
void cr_prompt_clear(void); /* ^C: gives the line up */
/* Draws it into a row; *x receives the column of the cursor. */
void cr_prompt_draw(struct cr_cells *cells, struct cr_rect at, int *x);

/* ---- lines typed before (history.c) ---- */

void cr_history_open(const char *state_dir); /* "": none on disk */
void cr_history_close(void);
void cr_history_add(const char *line, bool keep); /* keep: also on disk */

/* ---- the program ---- */

enum { CR_PROMPT_W = 9 }; /* columns of "crumple> " */

enum cr_overlay { CR_OVERLAY_NONE, CR_OVERLAY_HELP, CR_OVERLAY_PALETTE };
enum { CR_FILTER_MAX = 40, CR_PENDING = 256, CR_SHEET_END = 1 << 20 };

struct cr_play {
    bool on;
    double at;     /* s since the first contact that is shown now */
    double ticked; /* s of the clock at the last look at it */
};

struct cr_tui {
    struct cr_session *session;
    struct cr_cells cells;
    struct cr_layout layout;
    struct cr_dialogue log;
    int w, h;
    bool dirty, broken; /* broken: no memory for a screen */
    bool mute;          /* answers are not shown */
    bool failed;        /* the last line that was run */
    double drawn_at;    /* s of the clock at which the last frame was begun */
    enum cr_area focus; /* CR_AREAS: the prompt */
    double keys_at;     /* s of the clock at which the keys being acted on had arrived */
    double tabbed_at;   /* likewise of Tab on the empty prompt, -1: something else since */
    int log_back, table_down, sweep_row;
    /* a lesson: a command file that pauses */
    bool paused, given_up;    /* waits for Enter; ^C was pressed then */
    int lesson_from, told;    /* first line since the last pause, -1: none; lines of it as shown */
    int lesson_down;          /* of these, scrolled past */
    bool play_asked, play_on; /* by the command: acted on when it has ended */
    struct cr_play play;
    /* sheet above the prompt: an answer that is too long for the dialogue, or candidates */
    int sheet_from, sheet_down;      /* first line of the answer, -1: none; rows scrolled */
    struct cr_completion candidates; /* n = 0: none */
    enum cr_overlay overlay;
    char filter[CR_FILTER_MAX];          /* of the palette */
    int chosen;                          /* row of the palette */
    const struct cr_progress *progress;  /* of the work under way, NULL: none */
    bool cancel;                         /* ^C while working */
    const char *question;                /* being asked, NULL: none */
    struct cr_input pending[CR_PENDING]; /* typed while working */
    int pendings;
    struct cr_str open; /* lines that "\" joins to the one being typed */
    /* dragging with the mouse */
    bool scrubbing;
    int taken, dragged;         /* participants, -1: none; dragged once the pointer has moved */
    int taken_x, taken_y;       /* cell at which it was taken */
    double drag_scale;          /* m per column, and middle, of the picture while it is dragged: */
    struct cr_vec2 drag_centre; /* fitting it anew would take it from under the pointer */
    struct cr_vec2 drag_by;     /* m, so far */
    struct cr_preview *preview; /* of the unsolved scene (preview.c) */
};

/* A session with this screen as its output; nothing touches the terminal yet. */
CR_MUST_CHECK enum cr_err cr_tui_new(const struct cr_tui_start *start, struct cr_tui **out,
                                     struct cr_error *err);
void cr_tui_free(struct cr_tui *t);
/* The first lines of the dialogue. */
void cr_tui_greet(struct cr_tui *t, const char *state_dir);

/* Runs a line that was typed; or one that a key stands for, which is shown and kept in the
 * history; or one step of many, which is not (play and drag end with one that is). */
void cr_tui_run(struct cr_tui *t, const char *line);
void cr_tui_run_key(struct cr_tui *t, const char *line);
bool cr_tui_run_quiet(struct cr_tui *t, const char *line); /* false: it failed */

/* ---- look.c, screen.c ---- */
/* Colours, glyphs and theme as the session has them now. */
struct cr_look cr_tui_look(const struct cr_tui *t);
/* The screen as it is now into t->cells, of t->w x t->h; *cursor_x < 0: no cursor. */
CR_MUST_CHECK enum cr_err cr_tui_compose(struct cr_tui *t, int *cursor_x, struct cr_error *err);
void cr_tui_draw(struct cr_tui *t);
/* Draws if something changed and the last frame is old enough; else returns the ms until then, -1:
 * nothing to draw. */
int cr_tui_draw_due(struct cr_tui *t);
int cr_tui_frame_due(const struct cr_tui *t); /* ms until a next frame may be begun */

/* ---- input.c, keys.c, overlay.c, zoom.c, mouse.c, play.c ---- */
void cr_tui_input(struct cr_tui *t, const struct cr_input *in);
void cr_tui_paste(struct cr_tui *t, const char *text); /* into the prompt; Enter runs it */
/* Runs what a key stands for; false: nothing where the focus is. */
bool cr_tui_key(struct cr_tui *t, const struct cr_input *in);
/* Keys of the bar for the present focus; returns how many. */
int cr_tui_bar(const struct cr_tui *t, struct cr_render_key *out, int max);
/* Runs what the key of that name in the bar stands for. */
void cr_tui_press(struct cr_tui *t, const char *name);
void cr_tui_focus(struct cr_tui *t, enum cr_area pane);
/* Rows of the help overlay: key and explanation. */
struct cr_help_row {
    const char *key, *help;
    bool heading;
};
int cr_tui_help_rows(const struct cr_tui *t, struct cr_help_row *out, int max);

void cr_overlay_draw(struct cr_tui *t);
bool cr_overlay_input(struct cr_tui *t, const struct cr_input *in); /* true: it was for it */
void cr_sheet_draw(struct cr_tui *t);

bool cr_rect_has(struct cr_rect r, int x, int y);
struct cr_rect cr_rect_inner(struct cr_rect r); /* without its frame */
/* The scene picture as it is drawn, to be finished by cr_pic_fini; false when there is none. */
struct cr_pic;
bool cr_scene_picture(struct cr_tui *t, struct cr_pic *pic);
/* Scale of the scene picture one round step up (1) or down (-1); its middle moved (h, j, k, l). */
void cr_scene_zoom(struct cr_tui *t, int step);
void cr_scene_pan(struct cr_tui *t, int key);
void cr_mouse(struct cr_tui *t, const struct cr_input *in);

void cr_play_toggle(struct cr_tui *t);
void cr_play_start(struct cr_tui *t, int frame);
void cr_play_stop(struct cr_tui *t);
void cr_play_tick(struct cr_tui *t);           /* shows the frame that is due */
void cr_play_rate(struct cr_tui *t, int step); /* faster (1) or slower (-1) */
void cr_play_obey(struct cr_tui *t);           /* what the command `play` has asked for */

/* ---- lesson.c: a command file that waits ---- */
/* Is this key for a lesson that waits? Then it has been acted on; other keys that change anything
 * are refused meanwhile. */
bool cr_lesson_key(struct cr_tui *t, const struct cr_input *in);
int cr_lesson_bar(struct cr_render_key *out, int max);
int cr_lesson_lines(struct cr_tui *t, int width); /* rows that its words take, 0: none */
void cr_lesson_prompt(struct cr_tui *t, struct cr_rect at);

/* ---- preview.c: the predicted first contact of a scene that is not solved ---- */
void cr_preview_draw(struct cr_tui *t, const struct cr_compiled *compiled);
void cr_preview_forget(struct cr_tui *t);

/* ---- sweep.c: the last sweep as a sheet ---- */
struct cr_sweep_sheet;
CR_MUST_CHECK enum cr_err cr_sweep_sheet_new(const struct cr_tui *t, struct cr_sweep_sheet **out,
                                             struct cr_error *err);
const struct cr_sheet *cr_sweep_sheet_get(const struct cr_sweep_sheet *s);
void cr_sweep_sheet_free(struct cr_sweep_sheet *s);
/* The curves or the map of the chosen run, where the pane shows them in place of the table. */
bool cr_sweep_pictured(const struct cr_tui *t);
CR_MUST_CHECK enum cr_err cr_sweep_picture_draw(struct cr_tui *t, const struct cr_look *look,
                                                struct cr_error *err);
/* Keys of the pane: another run, its values into the scene, the next picture. */
void cr_sweep_choose(struct cr_tui *t, int step);
void cr_sweep_take(struct cr_tui *t, int arg);
void cr_sweep_turn(struct cr_tui *t, int arg);

#endif
