/* Reads what the words of the command line ask for: command files, scenes, -e, -i and the
 * options. */
#include "repl/repl_priv.h"

#include "base/file.h"
#include "base/show.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char usage[] = "crumple --help tells the options";

const char *cr_repl_find_file(const char *path, const char *data_dir, char *buf, int size) {
    if (access(path, F_OK) != 0 && path[0] != '/' && data_dir[0] != '\0') {
        cr_file_part(data_dir, path, buf, (size_t)size);
        return access(buf, F_OK) == 0 ? buf : path;
    }
    return path;
}

bool cr_repl_is_scene(const char *path) {
    size_t n = strlen(path);
    return n > 5 && strcmp(path + n - 5, ".json") == 0;
}

bool cr_repl_takes(const char *arg) {
    size_t n = strlen(arg);
    return strcmp(arg, "-") == 0 || strcmp(arg, "-e") == 0 || strcmp(arg, "-i") == 0 ||
           strcmp(arg, "--repl") == 0 || strcmp(arg, "--ascii") == 0 ||
           strncmp(arg, "--color", 7) == 0 || strncmp(arg, "--max-", 6) == 0 ||
           (arg[0] != '-' &&
            (strchr(arg, '/') != NULL || (n > 8 && strcmp(arg + n - 8, ".crumple") == 0) ||
             cr_repl_is_scene(arg) || access(arg, F_OK) == 0));
}

/* The exit status of wrong usage, after a message unless it is quiet. */
static int fail(bool quiet, const char *what, const char *arg) {
    char shown[256];
    if (quiet) {
        return 2;
    }
    fprintf(stderr, "crumple: error: %s '%s'. %s\n", what, cr_show(arg, shown, sizeof shown),
            usage);
    return 2;
}

static bool is_color(const char *word) {
    return strcmp(word, "always") == 0 || strcmp(word, "auto") == 0 || strcmp(word, "never") == 0;
}

static bool read_limit(const char *arg, struct cr_repl_options *o) {
    const char *equals = strchr(arg, '=');
    bool seconds = strncmp(arg, "--max-seconds=", 14) == 0;
    char *end = NULL;
    long n = equals != NULL ? strtol(equals + 1, &end, 10) : 0;
    if ((!seconds && strncmp(arg, "--max-memory=", 13) != 0) || *end != '\0' || n < 1 ||
        n > 1000000) {
        return false;
    }
    *(seconds ? &o->max_seconds : &o->max_megabytes) = (int)n;
    return true;
}

void cr_repl_add_line(struct cr_str *out, const char *path) {
    cr_str_add(out, cr_repl_is_scene(path) ? "load \"" : "source \"");
    for (const char *p = path; *p != '\0'; p++) {
        cr_str_addf(out, *p == '"' || *p == '\\' ? "\\%c" : "%c", *p);
    }
    cr_str_add(out, "\"\n");
}

static int read_words(int argc, char **argv, bool quiet, struct cr_repl_options *o) {
    *o = (struct cr_repl_options){.color = "auto"};
    for (int i = 1; i < argc; i++) {
        const char *arg = argv[i];
        if (strcmp(arg, "-i") == 0 || strcmp(arg, "--repl") == 0) {
            o->prompt = true;
            o->plain = o->plain || arg[1] == '-';
        } else if (strcmp(arg, "--ascii") == 0) {
            o->ascii = true;
        } else if (strncmp(arg, "--max-", 6) == 0) {
            if (!read_limit(arg, o)) {
                return fail(quiet, "want --max-seconds=N or --max-memory=MB, not", arg);
            }
        } else if (strncmp(arg, "--color=", 8) == 0 && is_color(arg + 8)) {
            o->color = arg + 8;
        } else if (strncmp(arg, "--color", 7) == 0) {
            return fail(quiet, "--color takes always, auto or never, not", arg);
        } else if (strcmp(arg, "-e") == 0) {
            if (++i == argc) {
                return fail(quiet, "a command must follow", arg);
            }
            o->sources++;
        } else if (arg[0] == '-' && arg[1] != '\0') {
            return fail(quiet, "unknown option", arg);
        } else {
            o->sources++;
            o->scenes += cr_repl_is_scene(arg);
            o->streams += strcmp(arg, "-") == 0;
        }
    }
    return 0;
}

int cr_repl_read_options(int argc, char **argv, struct cr_repl_options *o) {
    return read_words(argc, argv, false, o);
}

bool cr_repl_one_scene(int argc, char **argv) {
    struct cr_repl_options o;
    return read_words(argc, argv, true, &o) == 0 && o.scenes == 1 && o.sources == 1 && !o.prompt;
}

/* Whether all files among the arguments can be read. */
static bool all_there(int argc, char **argv, const char *data_dir) {
    char buf[4096];
    for (int i = 1; i < argc; i++) {
        i += strcmp(argv[i], "-e") == 0;
        if (i < argc && argv[i][0] != '-' && strcmp(argv[i - 1], "-e") != 0 &&
            access(cr_repl_find_file(argv[i], data_dir, buf, sizeof buf), R_OK) != 0) {
            return false;
        }
    }
    return true;
}

bool cr_repl_wants_screen(int argc, char **argv, const char *data_dir, struct cr_repl_start *out) {
    struct cr_repl_options o;
    *out = (struct cr_repl_start){0};
    bool wants = cr_repl_one_scene(argc, argv);
    for (int i = 1; i < argc; i++) {
        wants = wants || strcmp(argv[i], "-i") == 0;
    }
    if (!wants || !all_there(argc, argv, data_dir) || read_words(argc, argv, true, &o) != 0 ||
        o.plain || o.streams > 0) {
        return false;
    }
    *out = (struct cr_repl_start){.ascii = o.ascii,
                                  .color = o.color,
                                  .max_seconds = o.max_seconds,
                                  .max_megabytes = o.max_megabytes};
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-e") == 0) {
            cr_str_addf(&out->lines, "%s\n", argv[++i]);
        } else if (argv[i][0] != '-') {
            cr_repl_add_line(&out->lines, argv[i]);
        }
    }
    return true;
}
