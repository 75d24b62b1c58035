/* Runs the words of the command line that lead to commands: files, -, -e, -i, --repl. */
#include "repl/repl_priv.h"

#include "base/file.h"
#include "base/show.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char *cr_repl_state_dir(char *buf, int size, const char **why) {
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    int fault = 0; /* the first, which makes the others */
    buf[0] = '\0';
    *why = NULL;
    if (state != NULL && state[0] == '/') {
        snprintf(buf, (size_t)size, "%s/crumple", state);
    } else if (home != NULL && home[0] == '/') {
        snprintf(buf, (size_t)size, "%s/.local/state/crumple", home);
    } else {
        return buf;
    }
    for (char *p = buf + 1; *p != '\0'; p++) { /* XDG asks for 0700 of each folder on the way. */
        if (*p == '/') {
            *p = '\0';
            fault = mkdir(buf, 0700) != 0 && errno != EEXIST && fault == 0 ? errno : fault;
            *p = '/';
        }
    }
    if (mkdir(buf, 0700) != 0 && errno != EEXIST) {
        *why = strerror(fault != 0 ? fault : errno);
    }
    return buf;
}

/* ---- sources ---- */

static enum cr_err say_error(const struct cr_error *err) {
    char line[1200];
    fflush(stdout);
    fprintf(stderr, "crumple: %s\n", cr_err_format(err, line, sizeof line));
    return err->code;
}

/* Runs lines that were put together, unless there was no memory for some of them. */
static enum cr_err run_text(struct cr_session *s, const struct cr_str *lines, const char *name,
                            int first) {
    struct cr_error err;
    if (lines->failed) {
        cr_err_set(&err, CR_ERR_MEMORY, "no memory for a line");
        cr_err_place(&err, name, first, 0);
        return say_error(&err);
    }
    return cr_session_script(s, cr_str_get(lines), name, first);
}

/* Runs lines as they arrive, so that another program can talk to this one through pipes. */
static enum cr_err run_stream(struct cr_session *s) {
    char *line = NULL;
    size_t size = 0;
    struct cr_str whole = {0};
    enum cr_err code = CR_ERR_OK;
    int number = 0, first = 1;
    while (code == CR_ERR_OK && !cr_session_over(s)) {
        ssize_t n = getline(&line, &size, stdin);
        if (n < 0 && !feof(stdin) && !cr_signal_interrupted) {
            struct cr_error err;
            cr_err_set(&err, CR_ERR_IO, "cannot read: %s", strerror(errno));
            cr_err_place(&err, "stdin", 0, 0);
            code = say_error(&err);
        }
        if (n < 0 || cr_signal_interrupted) {
            break;
        }
        number++;
        if (strlen(line) != (size_t)n) {
            struct cr_error err;
            cr_err_set(&err, CR_ERR_SYNTAX, "a NUL byte is no text");
            cr_err_place(&err, "stdin", number, 1);
            code = say_error(&err);
            break;
        }
        cr_str_add(&whole, line);
        if (!cr_line_open(line)) {
            code = run_text(s, &whole, "stdin", first);
            cr_str_clear(&whole);
            first = number + 1;
            fflush(stdout);
        }
    }
    if (code == CR_ERR_OK && (whole.len > 0 || whole.failed)) {
        code = run_text(s, &whole, "stdin", first);
    }
    free(line);
    cr_str_fini(&whole);
    return code;
}

static enum cr_err run_file(struct cr_session *s, const char *name, const char *data_dir) {
    char buf[4096];
    const char *path = cr_repl_find_file(name, data_dir, buf, sizeof buf);
    struct cr_error err;
    char *text;
    size_t len;
    if (strcmp(path, "-") == 0) {
        return run_stream(s);
    }
    if (cr_file_read(path, &text, &len, &err) != CR_ERR_OK) {
        return say_error(&err);
    }
    enum cr_err code;
    if (strlen(text) != len) {
        cr_err_set(&err, CR_ERR_SYNTAX, "a NUL byte is no text");
        cr_err_place(&err, path, 1, 1);
        code = say_error(&err);
    } else if (text[strspn(text, " \t\r\n")] == '{') {
        struct cr_str line = {0};
        cr_repl_add_line(&line, name);
        code = run_text(s, &line, name, 1);
        cr_str_fini(&line);
    } else {
        code = cr_session_script(s, text, name, 1);
    }
    free(text);
    return code;
}

static enum cr_err run_sources(struct cr_session *s, int argc, char **argv, const char *data_dir) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 1; i < argc && code == CR_ERR_OK && !cr_session_over(s); i++) {
        if (strcmp(argv[i], "-e") == 0) {
            code = cr_session_script(s, argv[++i], "-e", 1);
        } else if (argv[i][0] != '-' || argv[i][1] == '\0') {
            code = run_file(s, argv[i], data_dir);
        }
    }
    return code;
}

int cr_repl_main(int argc, char **argv, const char *data_dir, const char *cars_dir,
                 enum cr_err (*report)(const struct cr_report_order *order, struct cr_error *err),
                 enum cr_err (*ask)(struct cr_session *s, struct cr_terminal *t,
                                    const char *state_dir)) {
    struct cr_repl_options o;
    struct cr_error err;
    const char *stateless = NULL;
    char state_dir[1024] = "";
    struct cr_session *s = NULL;
    int status = cr_repl_read_options(argc, argv, &o);
    if (status != 0) {
        return status;
    }
    bool prompt = ask != NULL && (o.prompt || o.sources == 0);
    struct cr_terminal t = {.progress = isatty(STDERR_FILENO) != 0};
    int max_seconds = o.max_seconds > 0 || prompt ? o.max_seconds : CR_MAX_SECONDS;
    const char *kept = prompt ? cr_repl_state_dir(state_dir, sizeof state_dir, &stateless) : NULL;
    struct cr_session_opts opts = {.data_dir = data_dir,
                                   .cars_dir = cars_dir,
                                   .state_dir = kept,
                                   .stateless = stateless,
                                   .ask = prompt,
                                   .max_seconds = max_seconds,
                                   .max_megabytes = o.max_megabytes,
                                   .look = cr_terminal_look(o.color, o.ascii),
                                   .out = cr_terminal_out(&t),
                                   .report = report};
    cr_signals_catch_lines();
    if (cr_session_new(&opts, &s, &err) != CR_ERR_OK) {
        say_error(&err);
        return cr_err_status(err.code);
    }
    enum cr_err code = o.sources > 0 ? run_sources(s, argc, argv, data_dir) : CR_ERR_OK;
    /* -i stays also after ^C, so that one can look at what a solve has left. */
    if (prompt && (code == CR_ERR_OK || code == CR_ERR_INTERRUPTED) && !cr_session_over(s)) {
        code = ask(s, &t, state_dir);
    } else if (!prompt && code == CR_ERR_OK && (o.sources == 0 || o.prompt)) {
        code = run_stream(s);
    }
    cr_session_free(s);
    if (cr_signal_interrupted && code == CR_ERR_OK && !prompt) {
        code = CR_ERR_INTERRUPTED;
    }
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "crumple: error: cannot write to standard output: %s\n", strerror(errno));
        return 2;
    }
    return cr_err_status(code);
}
