/* The prompt: readline with history and completion. readline keeps its state in globals of its own
 * and hands no argument to its callbacks, so what they need lives in two globals here. */
#include "repl/repl_priv.h"

#include "base/file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <readline/history.h>
#include <readline/readline.h>

enum { HISTORY_MAX = 5000, HELP_COLUMN = 24 };

static struct cr_session *completing;
static struct cr_completion candidates;

static char *next_candidate(const char *typed, int state) {
    static int at;
    at = state == 0 ? 0 : at;
    (void)typed;
    if (at >= candidates.n) {
        return NULL;
    }
    if (candidates.n == 1) {
        rl_completion_append_character = (unsigned char)candidates.item[0].end;
    }
    return strdup(candidates.item[at++].word);
}

static char **complete(const char *typed, int start, int end) {
    struct cr_error err;
    rl_attempted_completion_over = 1;
    rl_completion_append_character = ' ';
    cr_completion_fini(&candidates);
    if (cr_session_complete(completing, rl_line_buffer, end, &candidates, &err) != CR_ERR_OK ||
        candidates.n == 0 || candidates.start != start) {
        return NULL;
    }
    return rl_completion_matches(typed, next_candidate);
}

/* Lists the candidates with what they mean, a line each. */
static void show_candidates(char **matches, int n, int longest) {
    (void)matches;
    (void)n;
    (void)longest;
    int width, height;
    cr_terminal_size(&width, &height);
    rl_crlf();
    for (int i = 0; i < candidates.n; i++) {
        int room = width - HELP_COLUMN - 3;
        const char *help = candidates.item[i].help;
        if (i == height - 3 && candidates.n > height - 2) {
            printf("  ... and %d more\n", candidates.n - i);
            break;
        }
        bool cut = room > 1 && (int)strlen(help) > room;
        printf("  %-*s %.*s%s\n", help[0] != '\0' ? HELP_COLUMN : 0, candidates.item[i].word,
               cut        ? room - 1
               : room > 0 ? room
                          : 0,
               help, cut ? "~" : "");
    }
    rl_on_new_line();
    rl_forced_update_display();
}

void cr_repl_complete(struct cr_session *s) {
    completing = s;
    rl_readline_name = "crumple";
    rl_attempted_completion_function = s != NULL ? complete : NULL;
    rl_completion_display_matches_hook = s != NULL ? show_candidates : NULL;
    rl_completer_word_break_characters = " \t\n;=";
    rl_completer_quote_characters = "";
    rl_sort_completion_matches = 0;
    if (s == NULL) {
        cr_completion_fini(&candidates);
    }
}

/* At ^C the line at the prompt is given up and the session goes on. */
static int after_signal(void) {
    if (cr_signal_interrupted) {
        cr_signal_interrupted = 0;
        rl_replace_line("", 1); /* readline itself has shown ^C already. */
        rl_crlf();
        rl_on_new_line();
        rl_redisplay();
    }
    return 0;
}

static int ask(void *user, const char *question, const char *answers) {
    char prompt[700];
    (void)user;
    snprintf(prompt, sizeof prompt, "%s ", question);
    for (;;) {
        char *line = readline(prompt);
        if (line == NULL) {
            return 'c';
        }
        char first = line[strspn(line, " ")];
        free(line);
        if (first != '\0' && strchr(answers, first) != NULL) {
            return first;
        }
    }
}

/* ---- history ---- */

static void remember(const char *line, const char *file) {
    const HIST_ENTRY *last =
        history_length > 0 ? history_get(history_base + history_length - 1) : NULL;
    if (line[strspn(line, " \t")] == '\0' || (last != NULL && strcmp(last->line, line) == 0)) {
        return;
    }
    add_history(line);
    if (file[0] != '\0' && append_history(1, file) != 0) {
        write_history(file); /* The first line of all makes the file. */
    }
}

/* Reads a line with the lines that "\" adds to it; NULL at the end of input. */
static char *read_whole(void) {
    struct cr_str whole = {0};
    char *line = readline(CR_PROMPT);
    while (line != NULL && cr_line_open(line)) {
        cr_str_addf(&whole, "%s\n", line);
        free(line);
        line = readline("      -> ");
    }
    if (line == NULL && whole.len == 0) {
        cr_str_fini(&whole);
        return NULL;
    }
    cr_str_add(&whole, line != NULL ? line : "");
    free(line);
    return whole.s != NULL ? whole.s : strdup("");
}

/* Joins a command of several lines to one, which it is in the history. */
static void join_lines(char *line) {
    for (char *p = line; *p != '\0'; p++) {
        if (p[0] == '\\' && p[1] == '\n') {
            p[0] = p[1] = ' ';
        }
    }
}

enum cr_err cr_repl_prompt(struct cr_session *s, struct cr_terminal *t, const char *state_dir) {
    char file[1200] = "";
    t->prompt = true;
    cr_signal_interrupted = 0;
    puts("Crumple: crash simulation by voxels. help lists the commands, Tab completes, ^D ends.");
    if (cr_session_left_behind(state_dir)) {
        puts("  An earlier session ended without being quit. Its scene: load --recover");
    }
    struct cr_out out = cr_terminal_out(t);
    out.ask = ask;
    cr_session_set_out(s, &out);
    cr_repl_complete(s);
    rl_signal_event_hook = after_signal;
    using_history();
    stifle_history(HISTORY_MAX);
    if (state_dir[0] != '\0') {
        snprintf(file, sizeof file, "%s/history", state_dir);
        read_history(file);
    }
    while (!cr_session_over(s)) {
        char *line = read_whole();
        cr_signal_interrupted = 0;
        if (line == NULL) { /* ^D */
            puts("");
            cr_session_run(s, "quit");
            if (cr_session_over(s) || !isatty(STDIN_FILENO)) {
                break;
            }
            continue;
        }
        char *one = strdup(line);
        if (one != NULL) {
            join_lines(one);
            remember(one, file);
        }
        free(one);
        cr_session_run(s, line);
        fflush(stdout);
        free(line);
    }
    if (file[0] != '\0') {
        history_truncate_file(file, HISTORY_MAX);
    }
    cr_repl_complete(NULL);
    return CR_ERR_OK;
}
