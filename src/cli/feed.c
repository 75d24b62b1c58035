/* Reads scene texts one after the other from files, folders, JSON arrays and JSON Lines. */
#include "cli/feed.h"

#include "base/file.h"
#include "base/str.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum form { FORM_ARRAY, FORM_LINES, FORM_DOCUMENT };

struct cr_feed {
    char *const *input;
    int inputs, next_input;
    /* files of the folder that is being read */
    struct dirent **entry;
    int entries, next_entry;
    char *folder;
    /* the file that is being read */
    FILE *file;
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

enum cr_err cr_feed_new(char *const *input, int n, struct cr_feed **out, struct cr_error *err) {
    *out = calloc(1, sizeof **out);
    if (!*out) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to read scenes");
    }
    (*out)->input = input;
    (*out)->inputs = n;
    return CR_ERR_OK;
}

static void close_file(struct cr_feed *f) {
    if (f->file && f->file != stdin) {
        fclose(f->file);
    }
    f->file = NULL;
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
    return n > m && !strcmp(name + n - m, suffix);
}

static bool is_lines(const char *name) {
    return ends_in(name, ".jsonl") || ends_in(name, ".ndjson");
}

static int is_scene_file(const struct dirent *e) {
    return e->d_name[0] != '.' && (ends_in(e->d_name, ".json") || is_lines(e->d_name));
}

/* next character, counting lines; EOF also for an error of the file */
static int next_char(struct cr_feed *f) {
    int c = getc_unlocked(f->file);
    f->line += c == '\n';
    return c;
}

static bool blank(int c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* first character that is not blank, put back; the line counter stands on it */
static int skip_blanks(struct cr_feed *f) {
    int c;
    do {
        c = next_char(f);
    } while (blank(c));
    if (c != EOF) {
        ungetc(c, f->file);
    }
    return c;
}

static void read_line(struct cr_feed *f, struct cr_str *to) {
    char buf[4096];
    size_t n = 0;
    int c;
    while ((c = next_char(f)) != EOF) {
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

/* open a file (or standard input); false if that is not possible, with the item's fault */
static bool open_file(struct cr_feed *f, const char *path, struct cr_feed_item *out) {
    bool standard = !strcmp(path, "-");
    f->src = copy(standard ? "standard input" : path);
    f->file = standard ? stdin : fopen(path, "r");
    if (!f->file || !f->src) {
        char text[128];
        snprintf(text, sizeof text, "cannot open: %s", strerror(errno));
        fault(out, path, CR_ERR_IO, text, NULL);
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
        char text[128];
        snprintf(text, sizeof text, "cannot list the folder: %s", strerror(errno));
        f->entries = 0;
        return !fault(out, path, CR_ERR_IO, text, NULL);
    }
    return f->entries > 0 || !fault(out, path, CR_ERR_MISSING, "no scenes in this folder",
                                    "their names must end in .json, .jsonl or .ndjson");
}

/* open what comes next; false at the end or with a fault */
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
    if (text->failed || !text->s || !out->src) {
        cr_str_fini(text);
        free(out->src);
        return fault(out, f->src, CR_ERR_MEMORY, "no memory for a scene", NULL);
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
        if (text.len == 0 && feof(f->file)) {
            cr_str_fini(&text);
            return false;
        }
        if (strspn(cr_str_get(&text), " \t\r\n") < text.len) {
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
    cr_str_add(&text, cr_str_get(&f->held[1]));
    memset(&f->held[0], 0, sizeof f->held[0]);
    int line = f->held_line[0];
    f->held_n = 0;
    char buf[4096];
    for (size_t n; (n = fread(buf, 1, sizeof buf, f->file)) > 0;) {
        cr_str_addn(&text, buf, n);
    }
    return give(f, &text, line, 1, out);
}

/* nothing may follow the array, and it must have an end; reads the rest of the file */
static bool end_array(struct cr_feed *f, int c, struct cr_feed_item *out) {
    const char *text = "the array has no end";
    if (feof(f->file) && f->given < 0) {
        return false;
    }
    if (c == ']') {
        next_char(f);
        text = skip_blanks(f) == EOF ? NULL : "text after the end of the array";
    }
    int line = f->line;
    while (next_char(f) != EOF) {
    }
    f->given = -1;
    if (!text || ferror(f->file)) {
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
    while ((c = next_char(f)) != EOF) {
        if (s.depth == 0 && !s.string && (c == ',' || c == ']')) {
            ungetc(c, f->file);
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
    return give(f, &text, line, 1, out);
}

bool cr_feed_next(struct cr_feed *f, struct cr_feed_item *out) {
    static bool (*const NEXT[])(struct cr_feed *, struct cr_feed_item *) = {
        [FORM_ARRAY] = next_element, [FORM_LINES] = next_line, [FORM_DOCUMENT] = next_document};
    memset(out, 0, sizeof *out);
    for (;;) {
        if (f->file && NEXT[f->form](f, out)) {
            return true;
        }
        if (f->file && ferror(f->file)) {
            bool got = fault(out, f->src, CR_ERR_IO, "cannot read", "is it a file?");
            close_file(f);
            return got;
        }
        if (f->file && f->given == 0 && f->form != FORM_ARRAY) {
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
