/* Reads scene texts one after the other from files, folders, JSON arrays and JSON Lines. */
#include "cli/feed.h"

#include "base/file.h"
#include "base/str.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A scene is never that long; what is, as a device that gives zeroes for ever, is given up. */
enum { TEXT_MAX = 256 << 20, POLL_MS = 100 };

/* Bytes of a file. Between pieces it is asked whether to go on: a thread of a pool takes no
 * signals, and a pipe may say nothing for a long time. */
struct bytes {
    int fd;
    unsigned char piece[1 << 16];
    size_t from, to;
    bool end, stopped; /* stopped: by who was asked */
    bool binary;       /* a NUL byte comes next: there are no scenes in what follows */
    int error;         /* errno of a read that failed */
};

enum form { FORM_ARRAY, FORM_LINES, FORM_DOCUMENT };

struct cr_feed {
    char *const *input;
    int inputs, next_input;
    /* files of the folder that is being read */
    struct dirent **entry;
    int entries, next_entry;
    char *folder;
    int (*cancel)(void *user);
    void *user;
    /* the file that is being read */
    bool open, standard; /* standard: input of the process, which is not ours to close */
    struct bytes in;
    char *src;
    enum form form;
    int line;              /* line that the next character belongs to */
    int given;             /* scenes of this file so far */
    struct cr_str held[2]; /* lines that were read to tell the form */
    int held_line[2], held_n;
};

void cr_feed_item_fini(struct cr_feed_item *item) {
    free(item->text);
    free(item->src);
    memset(item, 0, sizeof *item);
}

enum cr_err cr_feed_new(char *const *input, int n, int (*cancel)(void *user), void *user,
                        struct cr_feed **out, struct cr_error *err) {
    *out = calloc(1, sizeof **out);
    if (!*out) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to read scenes");
    }
    (*out)->input = input;
    (*out)->inputs = n;
    (*out)->cancel = cancel;
    (*out)->user = user;
    return CR_ERR_OK;
}

static void close_file(struct cr_feed *f) {
    if (f->open && !f->standard) {
        close(f->in.fd);
    }
    f->open = false;
    free(f->src);
    f->src = NULL;
    f->held_n = 0;
    cr_str_clear(&f->held[0]);
    cr_str_clear(&f->held[1]);
}

static void close_folder(struct cr_feed *f) {
    for (int i = f->next_entry; i < f->entries; i++) {
        free(f->entry[i]);
    }
    free(f->entry);
    free(f->folder);
    f->entry = NULL;
    f->folder = NULL;
    f->entries = f->next_entry = 0;
}

void cr_feed_free(struct cr_feed *feed) {
    if (feed) {
        close_file(feed);
        close_folder(feed);
        cr_str_fini(&feed->held[0]);
        cr_str_fini(&feed->held[1]);
        free(feed);
    }
}

static char *copy(const char *s) {
    size_t n = strlen(s) + 1;
    char *c = malloc(n);
    return c ? memcpy(c, s, n) : NULL;
}

static bool fault(struct cr_feed_item *out, const char *src, enum cr_err code, const char *text,
                  const char *hint) {
    cr_err_set(&out->fault, code, "%s", text);
    cr_err_place(&out->fault, src, 0, 0);
    if (hint) {
        cr_err_hint(&out->fault, "%s", hint);
    }
    out->src = copy(src);
    return true;
}

static bool ends_in(const char *name, const char *suffix) {
    size_t n = strlen(name), m = strlen(suffix);
    return n > m && strcmp(name + n - m, suffix) == 0;
}

static bool is_lines(const char *name) {
    return ends_in(name, ".jsonl") || ends_in(name, ".ndjson");
}

static int is_scene_file(const struct dirent *e) {
    return e->d_name[0] != '.' && (ends_in(e->d_name, ".json") || is_lines(e->d_name));
}

/* the next piece of the file; false at its end, after an error and when told to stop */
static bool fill(struct cr_feed *f) {
    struct bytes *in = &f->in;
    struct pollfd fd = {.fd = in->fd, .events = POLLIN};
    while (!in->end) {
        in->stopped = f->cancel != NULL && f->cancel(f->user) != 0;
        in->end = in->stopped || in->binary;
        if (!in->end && poll(&fd, 1, POLL_MS) != 0) {
            ssize_t n = read(in->fd, in->piece, sizeof in->piece);
            in->error = n < 0 && errno != EINTR && errno != EAGAIN ? errno : 0;
            in->end = n == 0 || in->error != 0;
            in->from = 0;
            in->to = n > 0 ? (size_t)n : 0;
            const unsigned char *nul = memchr(in->piece, '\0', in->to);
            in->binary = nul != NULL;
            in->to = nul != NULL ? (size_t)(nul - in->piece) : in->to;
            if (in->to > 0) {
                return true;
            }
        }
    }
    return false;
}

static bool broken(const struct cr_feed *f) {
    return f->in.error != 0 || f->in.stopped || (f->in.binary && f->in.end);
}

/* next character, counting lines; EOF also for an error of the file */
static int next_char(struct cr_feed *f) {
    if (f->in.from == f->in.to && !fill(f)) {
        return EOF;
    }
    int c = f->in.piece[f->in.from++];
    f->line += c == '\n';
    return c;
}

/* Gives the last character back: a line is counted only when its end is taken. */
static void put_back(struct cr_feed *f) {
    f->in.from--;
    f->line -= f->in.piece[f->in.from] == '\n';
}

static bool blank(int c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* The first character that is not blank; it stays to be read, and the line counter is at it. */
static int skip_blanks(struct cr_feed *f) {
    int c;
    do {
        c = next_char(f);
    } while (blank(c));
    if (c != EOF) {
        put_back(f);
    }
    return c;
}

static void read_line(struct cr_feed *f, struct cr_str *to) {
    char buf[4096];
    size_t n = 0;
    int c;
    while (to->len < TEXT_MAX && (c = next_char(f)) != EOF) {
        buf[n++] = (char)c;
        if (c == '\n' || n == sizeof buf) {
            cr_str_addn(to, buf, n);
            n = 0;
        }
        if (c == '\n') {
            return;
        }
    }
    cr_str_addn(to, buf, n);
}

/* State of a walk over JSON text: how deep, and whether inside a string. */
struct nesting {
    int depth;
    bool string, escaped;
};

static void nest(struct nesting *s, int c) {
    if (s->escaped) {
        s->escaped = false;
    } else if (s->string) {
        s->escaped = c == '\\';
        s->string = c != '"';
    } else if (c == '"') {
        s->string = true;
    } else {
        s->depth += (c == '{' || c == '[') - (c == '}' || c == ']');
    }
}

static bool is_complete(const struct cr_str *line) {
    struct nesting s = {0};
    for (size_t i = 0; i < line->len; i++) {
        nest(&s, line->s[i]);
    }
    return s.depth == 0 && !s.string;
}

/* Tell the form from the first lines: an array; lines if the first is whole by itself or the second
 * one begins with a brace, as no line inside of a printed scene does; else one document. */
static void tell_form(struct cr_feed *f) {
    f->line = 1;
    f->given = 0;
    int c = skip_blanks(f);
    f->form = FORM_ARRAY;
    if (c == '[') {
        next_char(f);
        return;
    }
    f->form = FORM_LINES;
    if (is_lines(f->src)) {
        return;
    }
    f->held_line[0] = f->line;
    read_line(f, &f->held[0]);
    f->held_n = 1;
    if (is_complete(&f->held[0])) {
        return;
    }
    f->held_line[1] = f->line;
    read_line(f, &f->held[1]);
    f->held_n = 2;
    f->form = cr_str_get(&f->held[1])[0] == '{' ? FORM_LINES : FORM_DOCUMENT;
}

static bool cannot(struct cr_feed_item *out, const char *src, const char *what, int code) {
    char text[160];
    snprintf(text, sizeof text, "cannot %s: %s", what, strerror(code));
    return fault(out, src, CR_ERR_IO, text, NULL);
}

/* Opens a file (or standard input); false if that is not possible, with the item's fault. Whoever
 * names a pipe or a device means it; one that lies in a folder would be waited for or read without
 * end. */
static bool open_file(struct cr_feed *f, const char *path, struct cr_feed_item *out) {
    bool listed = f->folder != NULL;
    bool standard = strcmp(path, "-") == 0;
    struct stat st;
    f->src = copy(standard ? "standard input" : path);
    /* a pipe is opened at once, and waited for where that can be given up */
    int fd = standard ? STDIN_FILENO : open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    f->in = (struct bytes){.fd = fd};
    f->open = fd >= 0;
    f->standard = standard;
    if (fd < 0 || fstat(fd, &st) != 0 || f->src == NULL) {
        cannot(out, path, "open", f->src == NULL ? ENOMEM : errno);
        close_file(f);
        return false;
    }
    if (S_ISDIR(st.st_mode)) {
        cannot(out, path, "read", EISDIR);
        cr_err_hint(&out->fault, "folders in a folder are not looked into: name it by itself");
        close_file(f);
        return false;
    }
    if (listed && cr_file_check_open(fd, path, &out->fault) != CR_ERR_OK) {
        out->src = copy(path);
        close_file(f);
        return false;
    }
    tell_form(f);
    return true;
}

static bool open_folder(struct cr_feed *f, const char *path, struct cr_feed_item *out) {
    f->folder = copy(path);
    f->entries = scandir(path, &f->entry, is_scene_file, cr_file_by_bytes);
    if (f->entries < 0 || !f->folder) {
        int code = f->entries < 0 ? errno : ENOMEM;
        f->entries = f->entries < 0 ? 0 : f->entries;
        return !cannot(out, path, "list the folder", code);
    }
    return f->entries > 0 || !fault(out, path, CR_ERR_MISSING, "no scenes in this folder",
                                    "their names must end in .json, .jsonl or .ndjson");
}

/* Opens the next input; false at the end or with a fault. */
static bool open_next(struct cr_feed *f, struct cr_feed_item *out, bool *end) {
    *end = false;
    if (f->next_entry < f->entries) {
        struct dirent *e = f->entry[f->next_entry++];
        struct cr_str path = {0};
        cr_str_addf(&path, "%s/%s", f->folder, e->d_name);
        free(e);
        bool ok = open_file(f, cr_str_get(&path), out);
        cr_str_fini(&path);
        return ok;
    }
    close_folder(f);
    if (f->next_input == f->inputs) {
        *end = true;
        return false;
    }
    const char *path = f->input[f->next_input++];
    struct stat st;
    if (strcmp(path, "-") != 0 && stat(path, &st) == 0 && S_ISDIR(st.st_mode)) {
        return open_folder(f, path, out) && open_next(f, out, end);
    }
    return open_file(f, path, out);
}

/* move a text into the item */
static bool give(struct cr_feed *f, struct cr_str *text, int line, int col,
                 struct cr_feed_item *out) {
    out->src = copy(f->src);
    if (text->failed || !text->s || !out->src || text->len >= TEXT_MAX) {
        bool long_text = text->len >= TEXT_MAX;
        cr_str_fini(text);
        free(out->src);
        f->in.end = f->in.end || long_text; /* the next byte lies in the middle of a record */
        f->in.from = long_text ? f->in.to : f->in.from;
        f->given += long_text && f->given >= 0;
        return fault(out, f->src, long_text ? CR_ERR_EXPENSIVE : CR_ERR_MEMORY,
                     long_text ? "a scene of more than 256 MB" : "no memory for a scene", NULL);
    }
    out->text = text->s;
    out->len = text->len;
    out->line = line;
    out->col = col;
    f->given++;
    memset(text, 0, sizeof *text);
    return true;
}

static bool next_line(struct cr_feed *f, struct cr_feed_item *out) {
    for (;;) {
        struct cr_str text = {0};
        int line = f->line;
        if (f->held_n > 0) {
            text = f->held[0];
            line = f->held_line[0];
            f->held[0] = f->held[1];
            f->held_line[0] = f->held_line[1];
            memset(&f->held[1], 0, sizeof f->held[1]);
            f->held_n--;
        } else {
            read_line(f, &text);
        }
        if (broken(f) || (text.len == 0 && !text.failed && f->in.end)) {
            cr_str_fini(&text);
            return false;
        }
        if (text.failed || strspn(cr_str_get(&text), " \t\r\n") < text.len) {
            return give(f, &text, line, 1, out);
        }
        cr_str_fini(&text);
    }
}

static bool next_document(struct cr_feed *f, struct cr_feed_item *out) {
    if (f->held_n == 0) {
        return false;
    }
    struct cr_str text = f->held[0];
    cr_str_join(&text, &f->held[1]);
    memset(&f->held[0], 0, sizeof f->held[0]);
    int line = f->held_line[0];
    f->held_n = 0;
    while (text.len < TEXT_MAX && (f->in.from < f->in.to || fill(f))) {
        cr_str_addn(&text, (const char *)f->in.piece + f->in.from, f->in.to - f->in.from);
        f->in.from = f->in.to;
    }
    if (broken(f)) {
        cr_str_fini(&text);
        return false;
    }
    return give(f, &text, line, 1, out);
}

/* Reads the rest of the file: the array must end, and nothing may follow. */
static bool end_array(struct cr_feed *f, int c, struct cr_feed_item *out) {
    const char *text = "the array has no end";
    if (broken(f) || f->given < 0) {
        return false;
    }
    if (c == ']') {
        next_char(f);
        text = skip_blanks(f) == EOF ? NULL : "text after the end of the array";
    }
    int line = f->line;
    f->given = -1;
    f->in.end = true;
    f->in.from = f->in.to;
    if (text == NULL || broken(f)) {
        return false;
    }
    fault(out, f->src, CR_ERR_SYNTAX, text, NULL);
    cr_err_place(&out->fault, f->src, line, 1);
    return true;
}

static bool next_element(struct cr_feed *f, struct cr_feed_item *out) {
    int c = skip_blanks(f);
    while (c == ',') {
        next_char(f);
        c = skip_blanks(f);
    }
    if (c == EOF || c == ']') {
        return end_array(f, c, out);
    }
    struct cr_str text = {0};
    struct nesting s = {0};
    char buf[4096];
    size_t n = 0;
    int line = f->line;
    while (text.len < TEXT_MAX && (c = next_char(f)) != EOF) {
        if (s.depth == 0 && !s.string && (c == ',' || c == ']')) {
            put_back(f);
            break;
        }
        nest(&s, c);
        buf[n++] = (char)c;
        if (n == sizeof buf) {
            cr_str_addn(&text, buf, n);
            n = 0;
        }
    }
    cr_str_addn(&text, buf, n);
    if (broken(f)) {
        cr_str_fini(&text);
        return false;
    }
    return give(f, &text, line, 1, out);
}

bool cr_feed_next(struct cr_feed *f, struct cr_feed_item *out) {
    static bool (*const NEXT[])(struct cr_feed *, struct cr_feed_item *) = {
        [FORM_ARRAY] = next_element, [FORM_LINES] = next_line, [FORM_DOCUMENT] = next_document};
    memset(out, 0, sizeof *out);
    for (;;) {
        if (f->open && NEXT[f->form](f, out)) {
            return true;
        }
        if (f->open && f->in.stopped) {
            close_file(f);
            return false;
        }
        if (f->open && f->in.error != 0) {
            cannot(out, f->src, "read", f->in.error);
            close_file(f);
            return true;
        }
        if (f->open && f->in.binary && f->given >= 0) {
            fault(out, f->src, CR_ERR_SYNTAX, "a NUL byte: this is no text", NULL);
            cr_err_place(&out->fault, f->src, f->line, 0);
            close_file(f);
            return true;
        }
        if (f->open && f->given == 0 && f->form != FORM_ARRAY) {
            bool got = fault(out, f->src, CR_ERR_MISSING, "no scene in this input", NULL);
            close_file(f);
            return got;
        }
        close_file(f);
        bool end;
        if (!open_next(f, out, &end)) {
            return !end;
        }
    }
}
