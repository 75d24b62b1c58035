/* Inside of the command language: tokens, bound calls and the session's own state. */
#ifndef CR_CMD_CMD_PRIV_H
#define CR_CMD_CMD_PRIV_H

#include "cmd/cmd.h"

/* ---- tokens (token.c) ---- */

enum cr_token_kind { CR_TOKEN_WORD, CR_TOKEN_PAIR, CR_TOKEN_FLAG };

struct cr_token {
    enum cr_token_kind kind;
    const char *text; /* word, value of a pair or name of a flag, without quotes; in the arena */
    const char *key;  /* of a pair */
    bool quoted;
    int at, len;             /* bytes in the source text */
    int value_at, value_len; /* of the value of a pair; else as at, len */
};

struct cr_tokens {
    struct cr_arena arena;
    const char *source;
    int n;
    struct cr_token *tok;
    int end;  /* byte after the statement, without its ";" or newline */
    int next; /* byte at which the next statement starts */
};

/* One statement of text[from..]: ends at ";" or a newline that no "\" hides. err->col is the byte
 * offset of the fault + 1, err->line its length. */
enum cr_err cr_cmd_tokens(const char *text, int from, struct cr_tokens *out, struct cr_error *err);
void cr_cmd_tokens_fini(struct cr_tokens *tokens);
int cr_cmd_chars(const char *s, int bytes); /* characters in so many bytes of UTF-8 */

/* ---- values and bound calls (args.c) ---- */

struct cr_value {
    const struct cr_token *token; /* NULL: not given */
    const char *text;
    double number; /* SI, or the count */
    double second; /* y of a point; tolerance of a number that may have one, NaN: none */
    int word;      /* index in the words of the argument, -1: none of them */
    int sign;      /* +1, -1: typed with a sign, so relative where that is allowed; 0 */
};

struct cr_call {
    struct cr_session *s;
    const struct cr_command *cmd;
    const struct cr_tokens *tokens;
    bool force;
    struct cr_value value[CR_CMD_ARGS];
    int rest;                     /* first token of CR_ARG_REST, tokens->n if there is none */
    const struct cr_token *blame; /* token at fault, set by a handler that fails */
    struct cr_state *draft;       /* the state being edited, NULL while nothing changes it */
    bool fresh;                   /* the draft is another scene: its file is `file`, not unsaved */
    char file[CR_PATH_MAX];
};

/* Default unit of a number argument. */
const struct cr_unit *cr_cmd_unit(const struct cr_arg *arg);
enum cr_err cr_cmd_bind(struct cr_call *call, struct cr_error *err);
/* Value of an argument by name; token is NULL when it was not given. */
const struct cr_value *cr_cmd_arg(const struct cr_call *call, const char *name);
bool cr_cmd_given(const struct cr_call *call, const char *name);
double cr_cmd_number(const struct cr_call *call, const char *name, double otherwise);
int cr_cmd_word(const struct cr_call *call, const char *name, int otherwise);
const char *cr_cmd_text(const struct cr_call *call, const char *name, const char *otherwise);
/* Remember which argument is at fault; returns code. */
enum cr_err cr_cmd_blame(struct cr_call *call, const char *name, enum cr_err code);

/* Words of a "a|b|c" list: how many, the i-th into buf, and the index of a word or unique prefix
 * (-1: none, -2: ambiguous). */
int cr_cmd_words(const char *words);
const char *cr_cmd_word_at(const char *words, int i, char *buf, int size);
int cr_cmd_word_find(const char *words, const char *word);
const char *cr_cmd_word_nearest(const char *words, const char *word, char *buf, int size);
/* cr_command_find in a table of n commands. */
const struct cr_command *cr_command_among(const struct cr_command *table, int n, const char *word,
                                          bool *many);

/* ---- session (session.c, state.c, autosave.c, work.c, placed.c) ---- */

/* Puts those that stand against another where they belong by now, and says who moved. */
enum cr_err cr_cmd_settle(struct cr_session *s, struct cr_state *draft, struct cr_error *err);

struct cr_state {
    struct cr_scene scene;
    char file[CR_PATH_MAX]; /* it was read from or saved to, "" if it has none */
    char *command;          /* that led here, NULL for the first */
    long rev;
};

struct cr_session {
    struct cr_session_opts opts;
    const struct cr_command *command; /* the table; handlers know it from here alone */
    int commands;
    char data_dir[CR_PATH_MAX], autosave[CR_PATH_MAX];
    char recovered[CR_PATH_MAX]; /* autosave of a session that is gone, taken over; "" if none */
    struct cr_state **state;     /* undo stack; state[now] is the present */
    int states, state_size, now;
    long last_rev, saved_rev, result_rev, failed_rev, compiled_rev;
    struct cr_model_lib *models;
    struct cr_irf_set *irf;
    struct cr_result *result;
    struct cr_reference *reference; /* NULL: nothing was compared */
    bool solving, over, echo;
    bool no_autosave;    /* that there is none was told */
    enum cr_units units; /* of what is said and shown */
    bool lost;           /* memory was out for something that was to be said: the command fails */
    struct cr_compiled *compiled; /* of compiled_rev, NULL: none */
    struct cr_view view;
    struct cr_sweep *sweep;
    struct cr_mc *mc;               /* the last draws, NULL: none */
    struct cr_damage_notes *damage; /* measured, NULL: none */
    struct cr_pulse_shown *pulse;   /* what the pane of the pulse shows, NULL: |a| of all */
    void (*pulse_free)(struct cr_pulse_shown *pulse); /* of its owner */
    struct cr_log_line *log;
    int logs, log_size;
    char **line; /* history */
    int lines, line_size;
    int depth, sourced; /* of nested source commands; files of the outermost */
    double work_began, work_polled, work_shown; /* s of the monotonic clock */
    double work_processor;                      /* s of processor time when it began */
    double work_took;                           /* s of the last solve */
};

/* A session without a table of commands: for cr_session_new. */
enum cr_err cr_session_make(const struct cr_session_opts *opts, struct cr_session **out,
                            struct cr_error *err);
void cr_say(struct cr_session *s, const char *fmt, ...) CR_PRINTF(2, 3);
void cr_warn(struct cr_session *s, const char *fmt, ...) CR_PRINTF(2, 3);
void cr_session_text(struct cr_session *s, enum cr_tone tone, const char *line);
/* A line that was put together, as cr_say does; the command fails where memory was out for it. */
void cr_say_str(struct cr_session *s, const struct cr_str *line);
/* Text of several lines, each likewise; in_units: its numbers are in those of the session already,
 * not to be converted again. */
void cr_session_lines(struct cr_session *s, const struct cr_str *text, bool in_units);
void cr_session_room(struct cr_session *s, int *width, int *height);
enum cr_err cr_session_remember(struct cr_session *s, const char *line, struct cr_error *err);
void cr_session_reset_view(struct cr_session *s);
/* A path as typed, else below the data folder: "share/tutorial/reference.json" works anywhere. */
const char *cr_session_find_file(const struct cr_session *s, const char *path, char *buf, int size);
enum cr_err cr_session_need_models(struct cr_session *s, struct cr_error *err);
struct cr_car;
/* The car of the catalogue that the words mean. Errors: those of cr_catalogue_find. */
CR_MUST_CHECK enum cr_err cr_session_car(struct cr_session *s, const char *words,
                                         const struct cr_car **car, struct cr_error *err);
enum cr_err cr_session_need_result(struct cr_session *s, struct cr_error *err);
/* Likewise, and of the scene as it is now, solved to its end. */
enum cr_err cr_session_need_whole(struct cr_session *s, struct cr_error *err);
/* The result is of the scene as it is now, to its end or to where ^C stopped it. */
bool cr_session_fits(const struct cr_session *s);

struct cr_state *cr_session_now(const struct cr_session *s);
/* The state to change by this command; it takes effect when the handler succeeds. */
enum cr_err cr_cmd_edit(struct cr_call *call, struct cr_state **out, struct cr_error *err);
enum cr_err cr_state_dup(const struct cr_state *from, struct cr_state **out, struct cr_error *err);
void cr_state_free(struct cr_state *state);
/* Makes draft the present state; takes it over. */
enum cr_err cr_session_commit(struct cr_session *s, struct cr_state *draft, const char *command,
                              struct cr_error *err);
void cr_session_saved(struct cr_session *s, const char *path); /* the present is on disk */
void cr_session_autosave(struct cr_session *s);
/* The newest autosave that a session which is gone has left behind; false if there is none. */
bool cr_autosave_find(const char *state_dir, char *path, int size);

/* What the command damage was told of a vehicle; NULL: nothing. */
struct cr_measured;
const struct cr_measured *cr_damage_known(const struct cr_session *s, const char *id);

/* Long work: context of runs that report progress and can be cancelled. */
struct cr_context cr_session_context(struct cr_session *s);
void cr_work_begin(struct cr_session *s);
double cr_work_end(struct cr_session *s); /* s it took */
double cr_work_max_bytes(const struct cr_session *s);
/* Progress is due (first after 0.3 s, then ten times a second). */
bool cr_work_due(struct cr_session *s, double *elapsed);
int cr_work_cancelled(struct cr_session *s);
/* Progress of work that is counted, when it is due; non-zero when it is cancelled. */
int cr_work_count(struct cr_session *s, const char *what, int done, int total);
void cr_sweep_free(struct cr_sweep *sweep);
void cr_session_take_sweep(struct cr_session *s, struct cr_sweep *sweep);
void cr_session_drop_result(struct cr_session *s);
void cr_session_take_result(struct cr_session *s, struct cr_result *result);

/* What a sweep can vary under a short name of its own; besides it knows all keys of the scene. */
struct cr_sweep_key {
    const char *name;
    const char *key; /* of the scene, or one that vary.c knows (position.x, model) */
    unsigned kinds;  /* participants it is for, 0: all */
    bool setting;
    enum cr_dim dim;  /* of its value; CR_DIMS: words */
    const char *unit; /* likewise, its usual unit */
    const char *help;
};
extern const struct cr_sweep_key cr_sweep_keys[]; /* ends with a name of NULL */

/* Key arguments handed to the scene: one by name, or all that were given. id NULL: settings. */
enum cr_err cr_cmd_set_key(struct cr_call *call, struct cr_scene *scene, const char *id,
                           const char *name, struct cr_error *err);
enum cr_err cr_cmd_set_keys(struct cr_call *call, struct cr_scene *scene, const char *id,
                            struct cr_error *err);
int cr_cmd_keys_given(const struct cr_call *call);
/* Is a word of the rest an argument of its own, "jobs=2"? */
bool cr_cmd_is_arg(const struct cr_call *call, const struct cr_token *tok);
/* Sets ID.key of the scene to a text. */
enum cr_err cr_cmd_set_text(struct cr_scene *scene, const char *id, const char *key,
                            const char *value, struct cr_error *err);
/* The model of a vehicle: "suv/12", "suv" or a file of voxels. */
enum cr_err cr_model_take(struct cr_scene *scene, const char *id, const char *text,
                          struct cr_error *err);
/* Sets ID.key to a number, or to two where y is not NaN; and the pose: m, rad. */
enum cr_err cr_cmd_set_numbers(struct cr_scene *scene, const char *id, const char *key, double x,
                               double y, struct cr_error *err);
enum cr_err cr_cmd_set_pose(struct cr_scene *scene, const char *id, struct cr_vec2 pos,
                            double heading, struct cr_error *err);
/* cr_scene_resolve, but one participant alone is fine too. */
enum cr_err cr_cmd_resolve(struct cr_scene *scene, const struct cr_model_lib *models,
                           struct cr_assumed *assumed, struct cr_error *err);
/* Turns the JSON pointer of an error into the participant's name and key. */
void cr_cmd_name_place(const struct cr_scene *scene, struct cr_error *err);
/* A participant in one line. */
void cr_cmd_describe(const struct cr_participant *p, char *buf, int size);
/* Time of a CR_VALUE_TIME argument (ms after the first contact, or its word) -> frame of the
 * result; `words` in the order start, compression, end as far as the argument has them. */
enum cr_err cr_cmd_frame_at(struct cr_call *call, const char *name, int *frame,
                            struct cr_error *err);
/* Draw by way of out.cells; `draw` fills the rectangle. Nothing happens without a picture sink. */
enum cr_err cr_cmd_picture(struct cr_session *s, int width, int height,
                           enum cr_err (*draw)(void *user, struct cr_cells *cells,
                                               struct cr_rect at, struct cr_error *err),
                           void *user, struct cr_error *err);

/* Hint for a word that fits nowhere: a unit apart from its number, a value without its key. */
bool cr_cmd_guess(const struct cr_call *call, const struct cr_token *tok, struct cr_error *err);
/* The same for ID.KEY=VALUE where it is no key. */
bool cr_cmd_guess_key(const struct cr_session *s, const char *key, const char *value,
                      struct cr_error *err);
/* The command that other programs call so; NULL for none. */
const char *cr_cmd_elsewhere(const char *word);
/* Hint of a file that could not be opened: the name with its suffix where there is such a file. */
void cr_cmd_guess_file(const char *path, const char *suffix, struct cr_error *err);

/* A plot over the room there is but for some lines, by way of cr_cmd_picture. */
enum cr_err cr_cmd_plot(struct cr_session *s, const struct cr_plot *plot, int lines,
                        struct cr_error *err);

/* The same as lines of the answer: for a screen, which shows its own pictures but not this one. */
enum cr_err cr_cmd_picture_text(struct cr_session *s, int width, int height,
                                enum cr_err (*draw)(void *user, struct cr_cells *cells,
                                                    struct cr_rect at, struct cr_error *err),
                                void *user, struct cr_error *err);

/* The selected vehicle's 3D model from `view` (enum cr_project). */
enum cr_err cr_cmd_project(struct cr_session *s, int view, struct cr_error *err);

/* ---- help (help_text.c, glossary.c) ---- */

/* Adds text that begins at column `first` (further lines at `indent`), folded at 78 columns, and a
 * newline; whether a text (NULL: none) has a word in it, in any case. */
void cr_help_fold(struct cr_str *out, const char *text, int first, int indent);
bool cr_help_contains(const char *text, const char *word);
/* Tell what a term of the field means, "units" or "glossary"; false for what is none. */
bool cr_glossary_say(struct cr_session *s, const char *word);
/* Tell all terms whose text has the word in it; how many. */
int cr_glossary_search(struct cr_session *s, const char *word);
/* Name i and its title, NULL after the last (for completion). */
const char *cr_glossary_name(int i, const char **title);

/* ---- handlers ---- */

#define CR_CMD_LIST(X)                                                                             \
    X(vehicle)                                                                                     \
    X(object)                                                                                      \
    X(model)                                                                                       \
    X(place)                                                                                       \
    X(move)                                                                                        \
    X(set)                                                                                         \
    X(check)                                                                                       \
    X(solve)                                                                                       \
    X(play)                                                                                        \
    X(pause)                                                                                       \
    X(show)                                                                                        \
    X(view)                                                                                        \
    X(table)                                                                                       \
    X(pulse)                                                                                       \
    X(explain)                                                                                     \
    X(compare)                                                                                     \
    X(assert)                                                                                      \
    X(damage)                                                                                      \
    X(fit)                                                                                         \
    X(mc)                                                                                          \
    X(sweep)                                                                                       \
    X(load)                                                                                        \
    X(save)                                                                                        \
    X(export)                                                                                      \
    X(source)                                                                                      \
    X(undo)                                                                                        \
    X(redo)                                                                                        \
    X(history)                                                                                     \
    X(new)                                                                                         \
    X(list)                                                                                        \
    X(remove)                                                                                      \
    X(copy)                                                                                        \
    X(help)                                                                                        \
    X(apropos)                                                                                     \
    X(quit)
/* May a command write to a path? A file that is there and is not the session's own is kept unless
 * "!" was typed. */
enum cr_err cr_cmd_may_write(struct cr_call *call, const char *path, struct cr_error *err);

/* compare with a file of a pulse (compare.c); path is where the file was found. */
enum cr_err cr_cmd_compare_pulse(struct cr_call *call, const char *path, struct cr_error *err);
/* compare with evidence as it is typed (compare.c): rest.A=12,3m */
enum cr_err cr_cmd_compare_evidence(struct cr_call *call, struct cr_error *err);

#define X(name) enum cr_err cr_cmd_##name(struct cr_call *call, struct cr_error *err);
CR_CMD_LIST(X)
#undef X

#endif
