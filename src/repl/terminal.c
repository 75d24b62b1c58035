/* Prints the output of a session on a terminal or into a pipe. */
#include "repl/repl_priv.h"

#include <langinfo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

void cr_terminal_size(int *width, int *height) {
    struct winsize size;
    const char *columns = getenv("COLUMNS");
    long told = columns != NULL ? strtol(columns, NULL, 10) : 0;
    *width = 80;
    *height = 24;
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
        *width = size.ws_col;
        *height = size.ws_row;
    } else if (told >= 20 && told <= 400) {
        *width = (int)told;
    }
}

struct cr_look cr_terminal_look(const char *color, bool ascii) {
    const char *term = getenv("TERM"), *no_color = getenv("NO_COLOR");
    struct cr_look look = {.ascii = ascii || strcmp(nl_langinfo(CODESET), "UTF-8") != 0};
    bool wanted = strcmp(color, "always") == 0;
    if (strcmp(color, "auto") == 0) {
        wanted = isatty(STDOUT_FILENO) && (no_color == NULL || no_color[0] == '\0') &&
                 term != NULL && strcmp(term, "dumb") != 0;
    }
    if (wanted) {
        bool many = term != NULL && strstr(term, "256color") != NULL;
        look.color = many ? CR_COLOR_256 : CR_COLOR_16;
    }
    return look;
}

static void clear_progress(struct cr_terminal *t) {
    if (t->drawn) {
        fprintf(stderr, "\r%*s\r", 78, "");
        t->drawn = false;
    }
}

static void text(void *user, enum cr_tone tone, const char *line) {
    struct cr_terminal *t = user;
    clear_progress(t);
    if (tone == CR_TONE_WARN && !t->prompt) {
        fflush(stdout);
        fprintf(stderr, "%s\n", line);
        return;
    }
    bool comment = line[strspn(line, " \t")] == '#' || line[0] == '\0';
    printf("%s%s\n", tone == CR_TONE_ECHO && !comment ? CR_PROMPT : "", line);
}

static void fault(void *user, const struct cr_fault *f) {
    struct cr_terminal *t = user;
    struct cr_fault shown = *f;
    struct cr_str lines = {0};
    int width, height;
    clear_progress(t);
    cr_terminal_size(&width, &height);
    /* A caret below a line that is folded would point anywhere. */
    shown.many = f->many || CR_PROMPT_WIDTH + (int)strlen(f->text) >= width;
    cr_fault_text(&shown, t->prompt ? CR_PROMPT_WIDTH : -1, &lines);
    fflush(stdout);
    fputs(lines.failed ? "error: out of memory\n" : cr_str_get(&lines),
          t->prompt ? stdout : stderr);
    cr_str_fini(&lines);
}

static bool cells(void *user, const struct cr_cells *picture, const struct cr_look *look) {
    struct cr_terminal *t = user;
    struct cr_str lines = {0};
    clear_progress(t);
    cr_cells_text(picture, look, &lines);
    bool whole = !lines.failed;
    fputs(whole ? cr_str_get(&lines) : "", stdout);
    cr_str_fini(&lines);
    return whole;
}

enum { BAR = 24 };

static void progress(void *user, const struct cr_progress *p) {
    struct cr_terminal *t = user;
    char bar[BAR + 1] = "", line[160];
    if (p == NULL) {
        clear_progress(t);
        return;
    }
    if (p->total > 0) {
        int full = (int)(BAR * p->share);
        for (int i = 0; i < BAR; i++) {
            bar[i] = i < full ? '#' : '.';
        }
        int n = snprintf(line, sizeof line, "%s [%s] %d of %d", p->what, bar, p->done, p->total);
        if (p->elapsed > 0 && p->done > 0 && isfinite(p->left)) {
            snprintf(line + n, sizeof line - (size_t)n, "  %.1f/s  %.0f s left",
                     p->done / p->elapsed, ceil(p->left));
        }
    } else if (isfinite(p->share)) {
        snprintf(line, sizeof line, "%s %.0f %% of the approach  t %.1f ms  %.1f s", p->what,
                 100 * p->share, 1e3 * p->time, p->elapsed);
    } else {
        snprintf(line, sizeof line, "%s  %.1f s", p->what, p->elapsed);
    }
    fflush(stdout);
    fprintf(stderr, "\r  %-60.60s  ^C stops", line);
    fflush(stderr);
    t->drawn = true;
}

static int cancel(void *user) {
    (void)user;
    return cr_signal_interrupted;
}

static void size(void *user, int *width, int *height) {
    (void)user;
    cr_terminal_size(width, height);
    /* A picture that fills the whole screen would scroll its own title away. */
    *height = *height > 40 ? 40 : *height;
}

struct cr_out cr_terminal_out(struct cr_terminal *t) {
    return (struct cr_out){.user = t,
                           .text = text,
                           .fault = fault,
                           .cells = cells,
                           .progress = t->progress ? progress : NULL,
                           .cancel = cancel,
                           .size = size};
}
