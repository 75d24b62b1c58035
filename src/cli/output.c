/* Writes results to a file or standard output, errors to standard error, and finds colour and width
 * of the terminal. */
#include "cli/word.h"

#include "base/file.h"

#include <errno.h>
#include <langinfo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

int cr_cli_fail(const struct cr_error *err) {
    char line[1024];
    cr_err_format(err, line, sizeof line);
    fprintf(stderr, "%s%s\n", err->src[0] != '\0' ? "" : "crumple: ", line);
    return cr_err_status(err->code);
}

static enum cr_err write_stdout(const struct cr_str *text, struct cr_error *err) {
    size_t n = text->len;
    if ((n > 0 && fwrite(text->s, 1, n, stdout) != n) || fflush(stdout) != 0) {
        int code = errno;
        /* whoever reads, as head, has had enough: that is no failure */
        if (code == EPIPE) {
            return CR_ERR_OK;
        }
        cr_err_set(err, CR_ERR_IO, "cannot write: %s", strerror(code));
        cr_err_place(err, "standard output", 0, 0);
        return CR_ERR_IO;
    }
    return CR_ERR_OK;
}

enum cr_err cr_cli_emit(const char *path, const struct cr_str *text, struct cr_error *err) {
    if (text->failed) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the output");
    }
    if (path == NULL || strcmp(path, "-") == 0) {
        return write_stdout(text, err);
    }
    return cr_file_write_str(path, text, err);
}

enum cr_err cr_cli_emit_after(enum cr_err code, const char *path, const struct cr_str *text,
                              struct cr_error *err) {
    struct cr_error other;
    if (text->len == 0 && !text->failed) {
        return code;
    }
    enum cr_err wrote = cr_cli_emit(path, text, code == CR_ERR_OK ? err : &other);
    return code == CR_ERR_OK ? wrote : code;
}

int cr_cli_options(const struct cr_usage *usage, int argc, char **argv, int *operands) {
    struct cr_str out = {0};
    struct cr_error err = {0};
    bool help;
    if (argc > 1 && strcmp(argv[1], "--complete") == 0) {
        cr_cli_complete(usage, argc - 2, argv + 2, &out);
        enum cr_err written = cr_cli_emit(NULL, &out, &err);
        cr_str_fini(&out);
        return written == CR_ERR_OK ? 0 : cr_cli_fail(&err);
    }
    enum cr_err code = cr_options_parse(usage, argc, argv, operands, &help, &err);
    if (code == CR_ERR_OK && !help) {
        return -1;
    }
    if (code == CR_ERR_OK) {
        cr_options_help(usage, &out);
        code = cr_cli_emit(NULL, &out, &err);
    }
    cr_str_fini(&out);
    return code == CR_ERR_OK ? 0 : cr_cli_fail(&err);
}

static enum cr_color color_of(int choice, bool terminal) {
    const char *no = getenv("NO_COLOR"), *term = getenv("TERM"), *more = getenv("COLORTERM");
    bool dumb = term == NULL || term[0] == '\0' || strcmp(term, "dumb") == 0;
    bool wanted = choice == 1 || (choice == 0 && terminal && !dumb && (no == NULL || no[0] == 0));
    if (!wanted) {
        return CR_COLOR_NONE;
    }
    bool many = !dumb && strstr(term, "256color") != NULL;
    return many || (more != NULL && more[0] != '\0') ? CR_COLOR_256 : CR_COLOR_16;
}

static int terminal_width(void) {
    struct winsize size;
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 40) {
        return size.ws_col;
    }
    return 80;
}

struct cr_look cr_cli_look_of(const struct cr_cli_look *look, bool to_file, int *width) {
    bool terminal = !to_file && isatty(STDOUT_FILENO);
    bool utf8 = strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
    *width = look->width > 0 ? look->width : terminal ? terminal_width() : 80;
    return (struct cr_look){.ascii = look->ascii || !utf8,
                            .color = color_of(look->color, terminal)};
}
