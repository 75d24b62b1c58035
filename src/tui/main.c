/* The full screen as a whole: the session's output, running lines, one loop that sleeps until a
 * key, a signal or the next frame. */
#include "tui/tui_priv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES_PER_S = 30 };

/* ---- what signals ask for ---- */

static void act_on_signals(struct cr_tui *t) {
    if (cr_signal_stopping) {
        cr_term_suspend();
    }
    if (cr_signal_continued) {
        cr_term_redraw();
        t->dirty = true;
    }
    if (cr_signal_resized) {
        cr_term_resize(&t->w, &t->h);
        t->dirty = true;
    }
    if (cr_signal_interrupted) {
        const struct cr_input interrupt = {.code = 3};
        cr_signal_interrupted = 0;
        cr_tui_input(t, &interrupt);
    }
}

/* ---- the session's output ---- */

static void on_echo(struct cr_tui *t, const char *line) {
    struct cr_str text = {0};
    const char *words = line + strspn(line, " \t");
    if (t->lesson_from < 0) {
        t->lesson_from = t->log.n;
    }
    if (*words == '#') {
        words += 1 + (words[1] == ' ');
        cr_dialogue_add(&t->log, CR_ROLE_TITLE, words);
    } else if (*words != '\0') {
        cr_str_addf(&text, "crumple> %s", line);
        cr_dialogue_add(&t->log, CR_ROLE_KEY, cr_str_get(&text));
    }
    cr_str_fini(&text);
}

static void on_text(void *user, enum cr_tone tone, const char *line) {
    static const enum cr_role roles[] = {[CR_TONE_ANSWER] = CR_ROLE_TEXT,
                                         [CR_TONE_WARN] = CR_ROLE_WARN,
                                         [CR_TONE_ERROR] = CR_ROLE_BAD,
                                         [CR_TONE_ECHO] = CR_ROLE_KEY};
    struct cr_tui *t = user;
    if (t->mute && tone != CR_TONE_WARN) {
        return;
    }
    if (tone == CR_TONE_ECHO) { /* of a command file: what it says, and what it runs */
        on_echo(t, line);
    } else {
        cr_dialogue_add(&t->log, roles[tone], line);
    }
    t->dirty = true;
}

static void on_fault(void *user, const struct cr_fault *fault) {
    struct cr_tui *t = user;
    struct cr_fault shown = *fault;
    struct cr_str text = {0};
    /* a caret below a line that is folded would point anywhere */
    shown.many = fault->many || CR_PROMPT_W + (int)strlen(fault->text) >= t->w - 2;
    cr_fault_text(&shown, CR_PROMPT_W, &text);
    for (char *p = text.s, *end; p != NULL && (end = strchr(p, '\n')) != NULL; p = end + 1) {
        *end = '\0';
        cr_dialogue_add(&t->log, CR_ROLE_BAD, p);
    }
    cr_str_fini(&text);
    t->dirty = true;
}

static void on_progress(void *user, const struct cr_progress *progress) {
    struct cr_tui *t = user;
    t->progress = progress;
    t->dirty = true;
    if (progress != NULL) {
        cr_tui_draw_due(t);
        t->progress = NULL; /* it is the caller's, and only valid until we return */
    }
}

/* ^C cancels; a new size and ^Z are acted on; what is typed ahead waits */
static int on_cancel(void *user) {
    struct cr_tui *t = user;
    struct cr_input in;
    if (cr_signal_interrupted) {
        cr_signal_interrupted = 0;
        t->cancel = true;
    }
    act_on_signals(t);
    while (cr_term_read(&in)) {
        if (!in.function && in.code == 3) {
            t->cancel = true;
        } else if (!in.function && in.code == 26) {
            cr_term_suspend();
        } else if (t->pendings < CR_PENDING) {
            t->pending[t->pendings++] = in;
        }
    }
    return t->cancel || cr_signal_ending;
}

static int on_ask(void *user, const char *question, const char *answers) {
    struct cr_tui *t = user;
    int answer = 0;
    t->question = question;
    while (answer == 0) {
        struct cr_input in;
        t->dirty = true;
        act_on_signals(t);
        cr_tui_draw(t);
        if (!cr_term_wait(-1) || cr_signal_ending) {
            answer = 'c';
        }
        while (answer == 0 && cr_term_read(&in)) {
            if (!in.function && (in.code == 3 || in.code == 27)) {
                answer = 'c';
            } else if (!in.function && in.code < 128 && strchr(answers, (int)in.code) != NULL) {
                answer = (int)in.code;
            }
        }
    }
    t->question = NULL;
    t->dirty = true;
    return answer;
}

static void on_size(void *user, int *width, int *height) {
    const struct cr_tui *t = user;
    *width = t->w;
    *height = t->h;
}

/* ---- the loop ---- */

static void show_stderr(struct cr_tui *t) {
    struct cr_str text = {0};
    cr_term_stderr(&text);
    for (char *p = text.s, *end; p != NULL && *p != '\0'; p = end) {
        end = p + strcspn(p, "\n");
        end += *end == '\n' ? (*end = '\0', 1) : 0;
        cr_dialogue_add(&t->log, CR_ROLE_WARN, p);
        t->dirty = true;
    }
    cr_str_fini(&text);
}

static void take_keys(struct cr_tui *t) {
    struct cr_input in;
    t->keys_at = cr_clock_wall();
    while (t->pendings > 0 && !cr_session_over(t->session)) {
        in = t->pending[0];
        memmove(t->pending, t->pending + 1, (size_t)--t->pendings * sizeof in);
        cr_tui_input(t, &in);
    }
    while (!cr_session_over(t->session) && !cr_signal_ending && cr_term_read(&in)) {
        cr_tui_input(t, &in);
    }
}

/* One turn: sleeps until a key, a signal or the next frame. False: the terminal is gone. */
static bool turn(struct cr_tui *t) {
    act_on_signals(t);
    cr_play_obey(t);
    cr_play_tick(t);
    int ms = t->pendings > 0 ? 0 : cr_tui_draw_due(t);
    if (t->play.on && (ms < 0 || ms > 1000 / FRAMES_PER_S)) {
        int due = cr_tui_frame_due(t);
        ms = due > 0 ? due : 1000 / FRAMES_PER_S;
    }
    bool there = cr_term_wait(ms);
    take_keys(t);
    show_stderr(t);
    return there;
}

static void loop(struct cr_tui *t) {
    bool there = true;
    while (there && !cr_session_over(t->session) && !cr_signal_ending && !t->broken) {
        there = turn(t);
    }
    if (!there && !cr_signal_ending) {
        cr_signal_ending = SIGHUP;
    }
}

/* ---- a command file that waits ---- */

static int on_pause(void *user) {
    struct cr_tui *t = user;
    bool there = true;
    if (t->paused || t->mute) {
        return 0;
    }
    t->paused = t->dirty = true;
    t->given_up = false;
    t->progress = NULL;
    t->lesson_down = 0;
    while (t->paused && there && !cr_signal_ending && !t->broken) {
        there = turn(t);
    }
    cr_play_stop(t);
    t->paused = false;
    t->sheet_from = -1;
    t->lesson_from = t->log.n;
    t->dirty = true;
    return !there || cr_signal_ending || t->given_up;
}

static void on_play(void *user, bool on) {
    struct cr_tui *t = user;
    t->play_asked = true;
    t->play_on = on;
}

static struct cr_out out_of(struct cr_tui *t) {
    return (struct cr_out){.user = t,
                           .text = on_text,
                           .fault = on_fault,
                           .progress = on_progress,
                           .cancel = on_cancel,
                           .ask = on_ask,
                           .size = on_size,
                           .pause = on_pause,
                           .play = on_play};
}

void cr_tui_greet(struct cr_tui *t, const char *state_dir) {
    cr_dialogue_add(&t->log, CR_ROLE_TEXT,
                    "Crumple: crash simulation by voxels. F1 shows the keys, help the commands.");
    cr_dialogue_add(&t->log, CR_ROLE_TEXT,
                    state_dir[0] != '\0' && cr_session_left_behind(state_dir)
                        ? "  An earlier session ended without being quit. Its scene: load --recover"
                        : "  Begin with: load share/scenes/q7-fiat500.json   then F5");
}

static void say(const struct cr_error *err) {
    char line[1200];
    fprintf(stderr, "crumple: %s\n", cr_err_format(err, line, sizeof line));
}

enum cr_err cr_tui_new(const struct cr_tui_start *start, struct cr_tui **out,
                       struct cr_error *err) {
    struct cr_tui *t = calloc(1, sizeof *t);
    *out = NULL;
    if (t == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    t->focus = CR_AREAS;
    t->sheet_from = t->lesson_from = t->taken = t->dragged = -1;
    t->tabbed_at = -1;
    struct cr_session_opts opts = {.data_dir = start->data_dir,
                                   .cars_dir = start->cars_dir,
                                   .state_dir = start->state_dir,
                                   .stateless = start->stateless,
                                   .ask = true,
                                   .max_seconds = start->max_seconds,
                                   .max_megabytes = start->max_megabytes,
                                   .out = out_of(t),
                                   .report = start->report};
    enum cr_err code = cr_session_new(&opts, &t->session, err);
    if (code != CR_ERR_OK) {
        free(t);
        return code;
    }
    *out = t;
    return CR_ERR_OK;
}

void cr_tui_free(struct cr_tui *t) {
    cr_session_free(t->session);
    cr_preview_forget(t);
    cr_completion_fini(&t->candidates);
    cr_dialogue_fini(&t->log);
    cr_str_fini(&t->open);
    cr_cells_fini(&t->cells);
    free(t);
}

/* what the command line asked for: shown before it is begun, since it may take its time */
static void run_first(struct cr_tui *t, const char *lines) {
    char *text = strdup(lines);
    size_t len = strlen(lines);
    if (text != NULL && len > 0) {
        text[text[len - 1] == '\n' ? len - 1 : len] = '\0';
        cr_tui_draw(t);
        cr_tui_run(t, text);
    }
    free(text);
}

static int run_screen(struct cr_tui *t, const struct cr_tui_start *start) {
    struct cr_error err;
    if (cr_term_open(&err) != CR_ERR_OK) {
        say(&err);
        return cr_err_status(err.code);
    }
    struct cr_look look = {.ascii = start->ascii || cr_term_ascii(), .color = cr_term_color()};
    look.color = strcmp(start->color, "never") == 0 ? CR_COLOR_NONE : look.color;
    cr_session_set_look(t->session, &look);
    cr_prompt_open(t, start->state_dir);
    cr_term_resize(&t->w, &t->h);
    cr_tui_greet(t, start->state_dir);
    run_first(t, start->lines);
    t->dirty = true;
    loop(t);
    cr_prompt_close();
    cr_term_close();
    cr_paint_forget();
    if (cr_signal_ending) { /* as the sender expects, and without giving up the autosave */
        cr_signals_end_by(cr_signal_ending);
    }
    return t->broken ? cr_err_status(CR_ERR_MEMORY) : 0;
}

int cr_tui_main(const struct cr_tui_start *start) {
    struct cr_error err;
    struct cr_tui *t;
    if (cr_tui_new(start, &t, &err) != CR_ERR_OK) {
        say(&err);
        return cr_err_status(err.code);
    }
    int status = run_screen(t, start);
    cr_tui_free(t);
    return status;
}
