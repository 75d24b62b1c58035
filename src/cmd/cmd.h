/* The command language (crumple-commands(7)): tokens, the command table, the session
 * that commands work on, and completion. Every change of state goes through a command line.
 *
 * Output goes through struct cr_out alone. A session is used by one thread; what is borrowed from
 * it (scene, result, view, log) is valid until the next line is run. */
#ifndef CR_CMD_CMD_H
#define CR_CMD_CMD_H

#include "base/err.h"
#include "base/str.h"
#include "base/units.h"
#include "render/layout.h"
#include "render/render.h"
#include "result/result.h"
#include "scene/keys.h"
#include "scene/scene.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- output ---- */

enum cr_tone {
    CR_TONE_ANSWER, /* what a command answers, indented by two columns */
    CR_TONE_WARN,   /* "warning: ..." */
    CR_TONE_ERROR,  /* the lines of an error, as cr_fault_text makes them */
    CR_TONE_ECHO,   /* a command line itself, without the prompt */
};

/* An error with the line it was found in. */
struct cr_fault {
    struct cr_error err; /* err.src, line, col: a data file that is at fault, "" if none */
    const char *src;     /* the script, NULL for a line typed at the prompt */
    int line, col, len;  /* 1-based place (characters) and length of the words at fault */
    const char *text;    /* the physical line they are in, without its end */
    bool many;           /* it is one of several lines, so the caret needs the line above it */
};

/* What long work (solve, sweep) has reached. */
struct cr_progress {
    const char *what;               /* "SOLVING", "SWEEP" */
    double share;                   /* 0..1, NaN: unknown */
    int done, total;                /* runs of a sweep, 0 of 0 for a solve */
    double elapsed, left;           /* s of wall clock; left NaN: unknown */
    double time;                    /* s since the first contact; NaN: not in contact yet */
    const struct cr_solution *live; /* the trace so far, NULL if there is none */
    const struct cr_case *cs;       /* the case it belongs to, NULL if there is none */
    const struct cr_sweep *sweep;   /* the runs so far, NULL if it is no sweep */
};

/* Where output goes. Each function may be NULL. */
struct cr_out {
    void *user;
    void (*text)(void *user, enum cr_tone tone, const char *line); /* one line without newline */
    void (*fault)(void *user, const struct cr_fault *fault);
    /* a picture, made for that look, false where memory is out for it; NULL: none is drawn */
    bool (*cells)(void *user, const struct cr_cells *cells, const struct cr_look *look);
    void (*progress)(void *user, const struct cr_progress *progress); /* NULL at the end */
    int (*cancel)(void *user); /* polled while solving; non-zero stops the work */
    /* a question with one letter per answer ("sqc"); NULL: nobody is there to ask */
    int (*ask)(void *user, const char *question, const char *answers);
    void (*size)(void *user, int *width, int *height); /* room for pictures; NULL: 80 x 24 */
    /* a command file waits until somebody goes on; non-zero gives the rest up. NULL: nobody does */
    int (*pause)(void *user);
    void (*play)(void *user, bool on); /* at the view's rate; NULL: pictures do not move */
};

/* Lines of a fault as a person reads them. In a script: place and message, the source line (of a
 * long one a part) with a caret, the hint. At a prompt of that width in columns, with the line just
 * above: caret, message with hint; with prompt < 0 the message alone. */
void cr_fault_text(const struct cr_fault *fault, int prompt, struct cr_str *out);

/* ---- the command table ---- */

enum cr_arg_place {
    CR_ARG_POSITION, /* must be given, in order */
    CR_ARG_OPTION,   /* a position that may be left out */
    CR_ARG_KEY,      /* key=value */
    CR_ARG_FLAG,     /* --name */
    CR_ARG_REST,     /* all words that are left */
};

enum cr_arg_type {
    CR_VALUE_KEY,     /* a key of the scene (keys.h), which says type, unit, range and help */
    CR_VALUE_NUMBER,  /* number with unit; unit is the default one, lo..hi in that unit */
    CR_VALUE_COUNT,   /* whole number lo..hi; a sign makes it relative where def is "relative" */
    CR_VALUE_WORD,    /* one of words, separated by '|' */
    CR_VALUE_STEM,    /* likewise, also as the stem of a file: "scene", "scene.svg" */
    CR_VALUE_TEXT,    /* anything */
    CR_VALUE_NAME,    /* a participant that exists */
    CR_VALUE_VEHICLE, /* a vehicle that exists */
    CR_VALUE_NEW,     /* a participant's name, which may be new */
    CR_VALUE_FILE,    /* a file; words are its suffixes, separated by '|' */
    CR_VALUE_MODEL,   /* a model: TYPE/CLOCK or a file */
    CR_VALUE_COMMAND, /* a command's name */
    CR_VALUE_TIME,    /* time of the scene with unit, or a word of words */
    CR_VALUE_SWEEP,   /* what a sweep can vary: A.speed, B.overlap, restitution */
    CR_VALUE_POINT,   /* x,y in m */
    CR_VALUE_SWITCH,  /* on or off */
};

struct cr_arg {
    const char *name; /* key or flag as typed; a position in capitals as help shows it */
    enum cr_arg_place place;
    enum cr_arg_type type;
    enum cr_dim dim;   /* of a number */
    const char *unit;  /* its default unit, NULL: the SI one */
    double lo, hi;     /* allowed range in that unit; lo == hi: any */
    const char *words; /* see cr_arg_type; of a number: words that may stand instead */
    const char *def;   /* what is taken when it is not given, for help; NULL: nothing */
    const char *help;
    bool spreads;    /* a number that may have a tolerance: 1.4+-0.05m */
    const char *key; /* of CR_VALUE_KEY */
    unsigned mask;   /* kinds the key is for, 0: a setting */
};

struct cr_call;
enum { CR_CMD_ARGS = 32 };

struct cr_command {
    const char *name;
    const char *group; /* heading in help */
    const char *help;  /* one line */
    const char *example[2];
    const char *setup; /* lines that make the examples work in an empty session, NULL: none */
    const char *see;   /* related commands, separated by blanks */
    const struct cr_arg *arg; /* ends with a name of NULL */
    unsigned flags;           /* CR_CMD_* */
    enum cr_err (*run)(struct cr_call *call, struct cr_error *err);
};
enum {
    CR_CMD_FORCE = 1, /* takes "!" after its name */
    CR_CMD_PAIRS = 2, /* "key value" is taken as "key=value" */
};

const struct cr_command *cr_commands(int *n);
/* Exact name or unique prefix; NULL if there is none, *many (nullable) says if it was ambiguous. */
const struct cr_command *cr_command_find(const char *word, bool *many);
/* "place NAME [facing|...] [OTHER] [overlap=]": one line for the status under the prompt. */
void cr_command_usage(const struct cr_command *cmd, struct cr_str *out);
/* Row of the scene's key table behind an argument, NULL if it is none of them. */
const struct cr_key *cr_arg_key(const struct cr_arg *arg);
/* What an argument means, with range, unit and default. */
void cr_arg_help(const struct cr_arg *arg, struct cr_str *out);
/* The whole help page of a command; as roff for the man page. */
void cr_command_help(const struct cr_command *cmd, struct cr_str *out);
void cr_command_roff(const struct cr_command *cmd, struct cr_str *out);

/* ---- the session ---- */

struct cr_session;
struct cr_measure;

struct cr_report_order;
struct cr_session_opts {
    const char *data_dir;  /* folder of models/ and share/; "" if there is none */
    const char *cars_dir;  /* folder of the user's own tables of cars, NULL or "": none */
    const char *state_dir; /* folder for the autosave, "" if there is none; NULL: none is wanted */
    const char *stateless; /* why that folder cannot be made, NULL: it is there */
    bool ask;              /* quit asks when changes are unsaved */
    int max_seconds;   /* of processor time for one solve, 0: any; somebody at a prompt has ^C */
    int max_megabytes; /* of memory for one solve, 0: CR_MAX_MEGABYTES */
    struct cr_look look;
    struct cr_out out;
    /* makes the expert's report (report/order.h); NULL: nobody does */
    enum cr_err (*report)(const struct cr_report_order *order, struct cr_error *err);
};

CR_MUST_CHECK enum cr_err cr_session_new(const struct cr_session_opts *opts,
                                         struct cr_session **out, struct cr_error *err);
void cr_session_free(struct cr_session *s);
void cr_session_set_out(struct cr_session *s, const struct cr_out *out);
void cr_session_set_look(struct cr_session *s, const struct cr_look *look);
const struct cr_look *cr_session_look(const struct cr_session *s);

/* Run a line as typed at the prompt (several commands with ";" are fine). It is logged and
 * numbered; an error has been shown through out.fault already. A line that ends with "\" needs
 * more: cr_line_open tells before running it. */
enum cr_err cr_session_run(struct cr_session *s, const char *line);
bool cr_line_open(const char *line);

/* Run a command file's text, or a part of it that starts at the given line; stops at the first
 * error, which has been shown. src names it in messages. */
enum cr_err cr_session_script(struct cr_session *s, const char *text, const char *src, int line);

/* Has a session that is gone left an autosave in the state folder (load --recover)? */
bool cr_session_left_behind(const char *state_dir);

bool cr_session_over(const struct cr_session *s); /* quit was accepted */

enum cr_solve_state {
    CR_STATE_UNSOLVED, /* no result; the scene is as its file has it, or empty */
    CR_STATE_EDITED,   /* no result; the scene has changed since it was loaded or saved */
    CR_STATE_SOLVING,
    CR_STATE_SOLVED,
    CR_STATE_STALE,      /* the scene changed after the solve */
    CR_STATE_FAILED,     /* the last solve failed */
    CR_STATE_INTERRUPTED /* the result is what was solved until ^C: pictures, no final values */
};

const struct cr_scene *cr_session_scene(const struct cr_session *s);
const struct cr_result *cr_session_result(const struct cr_session *s); /* NULL: none */
/* In which what is shown is told (set units). */
enum cr_units cr_session_units(const struct cr_session *s);
/* Changes that undo (> 0) or redo (< 0) must take back until the scene is the one that was solved
 * last; 0: it is, or there is no way. */
int cr_session_way_back(const struct cr_session *s);
/* What the last `compare` with a file of values has read, NULL: none for this scene. */
const struct cr_reference *cr_session_reference(const struct cr_session *s);
enum cr_solve_state cr_session_state(const struct cr_session *s);
const char *cr_session_file(const struct cr_session *s); /* "" while it has none */
int cr_session_unsaved(const struct cr_session *s);      /* changes since the last save */
int cr_session_undos(const struct cr_session *s);        /* changes that undo can take back */
/* The scene compiled for a picture without a result; NULL while it is incomplete, and err says
 * why. Kept until the scene changes. */
const struct cr_compiled *cr_session_compiled(struct cr_session *s, struct cr_error *err);

/* What is looked at: changed by show, view, pulse, solve --step. */
struct cr_view {
    enum cr_area pane; /* in front */
    bool zoom;         /* the pane fills the screen */
    enum cr_field field;
    int frame;   /* 0: before the first contact, k: end of time slice k of the trace */
    double rate; /* of playing, 1: the crash in some seconds */
    bool loop;   /* played again and again */
    bool ghost;  /* outlines of where the bodies were at the first contact */
    bool vectors;
    bool follow;                /* keep the bodies' middle centred, else the world point `centre` */
    double m_per_col;           /* 0: automatic */
    struct cr_vec2 centre;      /* m; NaN: automatic */
    char selected[CR_NAME_MAX]; /* participant, "" for none */
    enum cr_quantity quantity;  /* of the pulse pane; CR_QUANTITIES: |a| */
    int sweep_picture;          /* of the pane of the sweep, from 1; 0: the table */
    char pulse_of[CR_NAME_MAX]; /* participant of the pulse pane, "" for all */
    char versus[CR_PATH_MAX];   /* measured curve beside it, "" for none */
    char colormap[16], theme[16];
};
const struct cr_view *cr_session_view(const struct cr_session *s);
int cr_session_frames(const struct cr_session *s);  /* last frame, 0 without a result */
double cr_session_time(const struct cr_session *s); /* s of the frame; NaN before contact */
/* The same as a picture's description, with the selected participant's index. */
struct cr_scene_view cr_session_scene_view(const struct cr_session *s);

/* The pulse as the last `pulse` asked for it, with its measured curve. Errors: MISSING without a
 * result, MEMORY. */
CR_MUST_CHECK enum cr_err cr_session_draw_pulse(struct cr_session *s, struct cr_cells *cells,
                                                struct cr_rect at, struct cr_error *err);

/* The last sweep: runs in order of its table. Values are SI; those of words are their index. */
enum { CR_SWEEP_AXES = 12, CR_SWEEP_GRID = 4 }; /* that are drawn; all combinations */
struct cr_sweep_axis {
    char key[CR_NAME_MAX + 32];
    const struct cr_unit *unit; /* in which its values are shown */
    int n;
    double *value; /* [n] */
    char **word;   /* [n], NULL: its values are numbers */
    bool between;  /* draws lie anywhere between the two values */
};
struct cr_sweep_run {
    bool running, done, failed;
    double at[CR_SWEEP_AXES];
    char message[160];
    struct cr_severity *of; /* [participants], without outlines */
    enum cr_stop stop;
};
struct cr_sweep {
    int axes;
    struct cr_sweep_axis axis[CR_SWEEP_AXES];
    bool drawn; /* a Latin hypercube; else all combinations, the first axis varies slowest */
    int n, participants;
    char id[CR_BODY_MAX][CR_NAME_MAX];
    const struct cr_measure *measure; /* what its pictures show */
    int part;                         /* of whom, -1: all that are deformed */
    struct cr_sweep_run *run;         /* [n] */
    struct cr_severity *severity;     /* owner of all run[].of */
};
const struct cr_sweep *cr_session_sweep(const struct cr_session *s); /* NULL: none */
/* A value of an axis: in those units, its unit there, and both as text ("34.8", "suv"). */
double cr_sweep_shown(const struct cr_sweep_axis *axis, double at, enum cr_units units);
const char *cr_sweep_unit(const struct cr_sweep_axis *axis, enum cr_units units);
const char *cr_sweep_text(const struct cr_sweep_axis *axis, double at, enum cr_units units,
                          char *buf, size_t size);
/* Has the run a result? Is the participant deformed in any that has? */
bool cr_sweep_known(const struct cr_sweep_run *run);
bool cr_sweep_deforms(const struct cr_sweep *sweep, int participant);
/* Pictures of the last sweep that one run is in, and the one that the view asks for, with that run
 * marked. Errors: MEMORY. */
int cr_session_sweep_pictures(const struct cr_session *s);
CR_MUST_CHECK enum cr_err cr_session_draw_sweep(struct cr_session *s, int run,
                                                struct cr_cells *cells, struct cr_rect at,
                                                const struct cr_look *look, struct cr_error *err);

struct cr_log_line {
    enum cr_tone tone;
    char *text;
};
int cr_session_log(const struct cr_session *s, const struct cr_log_line **out);

/* ---- completion ---- */

struct cr_candidate {
    char *word; /* what the word under the cursor becomes */
    char *help; /* what it means */
    char end;   /* what follows it: ' ', '=' is part of word, '\0' for a folder or key */
};
struct cr_completion {
    int start, end;            /* bytes of the line that the word takes the place of */
    int n, size;               /* candidates, and room for so many */
    struct cr_candidate *item; /* owned */
};
/* Candidates for the word at byte `point` of the line: commands, names, keys not yet given, enum
 * values, models, files by suffix, units after a number. */
CR_MUST_CHECK enum cr_err cr_session_complete(struct cr_session *s, const char *line, int point,
                                              struct cr_completion *out, struct cr_error *err);
void cr_completion_fini(struct cr_completion *completion);
/* What the command being typed takes, with the argument under the cursor: one or two lines; ""
 * when the line is empty or the command is not known. */
void cr_session_hint(struct cr_session *s, const char *line, int point, struct cr_str *out);

#endif
