/* Reads XML files by expat, with limits for hostile ones; what needs no expat is in xml_node.c. */
#include "config.h"

#include "import/xml.h"

#include "base/show.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef HAVE_EXPAT
#include <expat.h>

enum { PIECE = 1 << 16, POLL = 1024 };

struct reading {
    XML_Parser parser;
    const struct cr_xml_sax *sax;
    const struct cr_import_opts *opts; /* nullable; its cancel is asked whether to stop */
    const char *shown;
    /* nullable: characters between tags */
    enum cr_err (*chars)(void *user, const char *s, int n, struct cr_error *err);
    int depth;
    long elements;
    enum cr_err code;
    struct cr_error *err, own; /* own: where nobody wants to know */
};

static int line_of(const struct reading *r) {
    XML_Size line = XML_GetCurrentLineNumber(r->parser);
    return line < 2000000000 ? (int)line : 0;
}

static void stop(struct reading *r, enum cr_err code) {
    r->code = code;
    XML_StopParser(r->parser, XML_FALSE);
}

static void refuse(struct reading *r, const char *what) {
    cr_err_set(r->err, CR_ERR_RANGE, "%s", what);
    cr_err_place(r->err, r->shown, line_of(r), 0);
    stop(r, CR_ERR_RANGE);
}

static void on_begin(void *user, const XML_Char *name, const XML_Char **attr) {
    struct reading *r = user;
    const struct cr_xml_node node = {
        .name = name, .attr = (const char *const *)attr, .text = "", .line = line_of(r)};
    if (r->code != CR_ERR_OK) {
        return;
    }
    if (++r->depth > CR_XML_DEPTH) {
        refuse(r, "elements are nested too deeply");
        return;
    }
    if (++r->elements % POLL == 0 && r->opts != NULL && r->opts->cancel != NULL &&
        r->opts->cancel(r->opts->user)) {
        stop(r, cr_err_set(r->err, CR_ERR_INTERRUPTED, "interrupted"));
        return;
    }
    enum cr_err code =
        r->sax->begin != NULL ? r->sax->begin(r->sax->user, &node, r->err) : CR_ERR_OK;
    if (code != CR_ERR_OK) {
        stop(r, code);
    }
}

static void on_end(void *user, const XML_Char *name) {
    struct reading *r = user;
    if (r->code != CR_ERR_OK) {
        return;
    }
    r->depth--;
    enum cr_err code = r->sax->end != NULL ? r->sax->end(r->sax->user, name, r->err) : CR_ERR_OK;
    if (code != CR_ERR_OK) {
        stop(r, code);
    }
}

static void on_chars(void *user, const XML_Char *s, int n) {
    struct reading *r = user;
    enum cr_err code = CR_ERR_OK;
    if (r->code == CR_ERR_OK && r->chars != NULL) {
        code = r->chars(r->sax->user, s, n, r->err);
    }
    if (code != CR_ERR_OK) {
        stop(r, code);
    }
}

/* Refuses declarations: no file of these formats has any, and a few entities can expand to
 * gigabytes. */
static void on_doctype(void *user, const XML_Char *name, const XML_Char *system,
                       const XML_Char *public, int declares) {
    struct reading *r = user;
    (void)name, (void)system, (void)public;
    if (r->code == CR_ERR_OK && declares != 0) {
        refuse(r, "the document type has declarations of its own, which are not taken");
    }
}

static void on_skipped(void *user, const XML_Char *name, int is_parameter) {
    struct reading *r = user;
    if (r->code == CR_ERR_OK && !is_parameter) {
        char text[64];
        snprintf(text, sizeof text, "no entity &%.40s;", name);
        refuse(r, text);
    }
}

static enum cr_err syntax(struct reading *r) {
    enum XML_Error why = XML_GetErrorCode(r->parser);
    XML_Size col = XML_GetCurrentColumnNumber(r->parser);
    enum cr_err code = why == XML_ERROR_NO_MEMORY ? CR_ERR_MEMORY : CR_ERR_SYNTAX;
    cr_err_set(r->err, code, "no well-formed XML: %s", XML_ErrorString(why));
    cr_err_place(r->err, r->shown, line_of(r), col < 1000000000 ? (int)col + 1 : 0);
    return code;
}

static enum cr_err parse_file(struct reading *r, FILE *file) {
    long long fed = 0;
    bool last = false;
    while (!last) {
        void *piece = XML_GetBuffer(r->parser, PIECE);
        if (piece == NULL) {
            return cr_err_set(r->err, CR_ERR_MEMORY, "no memory to read XML");
        }
        size_t n = fread(piece, 1, PIECE, file);
        last = n < PIECE;
        if (ferror(file) != 0) {
            cr_err_set(r->err, CR_ERR_IO, "cannot read: %s", strerror(errno));
            cr_err_place(r->err, r->shown, 0, 0);
            return CR_ERR_IO;
        }
        fed += (long long)n;
        enum XML_Status status = XML_ParseBuffer(r->parser, (int)n, last);
        if (r->code != CR_ERR_OK) {
            return r->code;
        }
        if (status != XML_STATUS_OK) {
            return syntax(r);
        }
        /* Expat reads an unfinished tag again with each piece, so a long one would take forever. */
        if (!last && fed - XML_GetCurrentByteIndex(r->parser) > CR_XML_TAG + PIECE) {
            refuse(r, "a tag of more than a megabyte");
            return r->code;
        }
    }
    return CR_ERR_OK;
}

static enum cr_err parse(struct reading *r, const char *path, struct cr_error *err) {
    r->err = err != NULL ? err : &r->own;
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        cr_err_set(r->err, CR_ERR_IO, "cannot open: %s", strerror(errno));
        cr_err_place(r->err, r->shown, 0, 0);
        return CR_ERR_IO;
    }
    enum cr_err code = CR_ERR_MEMORY;
    r->parser = XML_ParserCreate(NULL);
    if (r->parser == NULL) {
        cr_err_set(r->err, code, "no memory to read XML");
        goto out;
    }
    XML_SetUserData(r->parser, r);
    XML_SetElementHandler(r->parser, on_begin, on_end);
    XML_SetCharacterDataHandler(r->parser, on_chars);
    XML_SetStartDoctypeDeclHandler(r->parser, on_doctype);
    XML_SetSkippedEntityHandler(r->parser, on_skipped);
    code = parse_file(r, file);
    XML_ParserFree(r->parser);
out:
    fclose(file);
    return code;
}

enum cr_err cr_xml_stream(const struct cr_import *im, const struct cr_xml_sax *sax,
                          struct cr_error *err) {
    struct reading r = {.sax = sax, .opts = im->opts, .shown = im->shown};
    return parse(&r, im->path, err);
}

/* ---- trees ---- */

struct growing {
    struct reading *reading;
    struct cr_arena *arena;
    struct cr_xml_node *root, *at;
    struct cr_str text[CR_XML_DEPTH + 1]; /* of the elements that are open */
    long nodes;
    size_t bytes;
};

static enum cr_err no_memory(struct cr_error *err) {
    return cr_err_set(err, CR_ERR_MEMORY, "no memory for a tree of XML");
}

static const char *keep(struct growing *g, const char *s, size_t n) {
    char *copy = cr_arena_take_raw(g->arena, n + 1, 1);
    g->bytes += n + 1;
    if (copy != NULL) {
        memcpy(copy, s, n);
        copy[n] = '\0';
    }
    return copy;
}

static bool keep_attrs(struct growing *g, struct cr_xml_node *to, const char *const *attr) {
    size_t n = 0;
    while (attr[n] != NULL) {
        n++;
    }
    const char **copy = cr_arena_take(g->arena, n + 1, sizeof *copy);
    g->bytes += (n + 1) * sizeof *copy;
    for (size_t i = 0; copy != NULL && i < n; i++) {
        copy[i] = keep(g, attr[i], strlen(attr[i]));
        if (copy[i] == NULL) {
            return false;
        }
    }
    to->attr = copy;
    return copy != NULL;
}

static enum cr_err grow(void *user, const struct cr_xml_node *node, struct cr_error *err) {
    struct growing *g = user;
    struct cr_xml_node *new = cr_arena_take(g->arena, 1, sizeof *new);
    if (new == NULL) {
        return no_memory(err);
    }
    *new = (struct cr_xml_node){.text = "", .line = node->line, .parent = g->at};
    new->name = keep(g, node->name, strlen(node->name));
    if (new->name == NULL || !keep_attrs(g, new, node->attr)) {
        return no_memory(err);
    }
    if (++g->nodes > CR_XML_NODES || g->bytes > CR_XML_BYTES) {
        refuse(g->reading, "too large for a file of this format");
        return CR_ERR_RANGE;
    }
    if (g->at == NULL) {
        g->root = new;
    } else if (g->at->child == NULL) {
        g->at->child = g->at->last = new;
    } else {
        g->at->last->next = new;
        g->at->last = new;
    }
    g->at = new;
    cr_str_clear(&g->text[g->reading->depth]);
    return CR_ERR_OK;
}

static enum cr_err add_chars(void *user, const char *s, int n, struct cr_error *err) {
    struct growing *g = user;
    struct cr_str *text = &g->text[g->reading->depth];
    if (text->len + (size_t)n > CR_XML_TAG) {
        refuse(g->reading, "more than a megabyte of text in one element");
        return CR_ERR_RANGE;
    }
    cr_str_addn(text, s, (size_t)n);
    return text->failed ? no_memory(err) : CR_ERR_OK;
}

static enum cr_err ripen(void *user, const char *name, struct cr_error *err) {
    struct growing *g = user;
    const struct cr_str *text = &g->text[g->reading->depth + 1];
    const char *s = cr_str_get(text);
    size_t n = text->len;
    (void)name;
    while (n > 0 && strchr(" \t\r\n", s[n - 1]) != NULL) {
        n--;
    }
    while (n > 0 && strchr(" \t\r\n", *s) != NULL) {
        s++;
        n--;
    }
    if (n > 0) {
        g->at->text = keep(g, s, n);
        if (g->at->text == NULL) {
            return no_memory(err);
        }
    }
    g->at = g->at->parent;
    return CR_ERR_OK;
}

enum cr_err cr_xml_load(const char *path, const char *shown, struct cr_arena *arena,
                        struct cr_xml_node **root, struct cr_error *err) {
    struct growing *g = calloc(1, sizeof *g);
    *root = NULL;
    if (g == NULL) {
        return no_memory(err);
    }
    const struct cr_xml_sax sax = {.user = g, .begin = grow, .end = ripen};
    struct reading r = {.sax = &sax, .shown = shown, .chars = add_chars};
    g->reading = &r;
    g->arena = arena;
    enum cr_err code = parse(&r, path, err);
    if (code == CR_ERR_OK) {
        *root = g->root;
    }
    for (int i = 0; i <= CR_XML_DEPTH; i++) {
        cr_str_fini(&g->text[i]);
    }
    free(g);
    return code;
}

#else

static enum cr_err left_out(const char *shown, struct cr_error *err) {
    cr_err_set(err, CR_ERR_USAGE, "this build reads no XML: it was made without expat");
    cr_err_place(err, shown, 0, 0);
    cr_err_hint(err, "build it with expat (Debian package libexpat1-dev)");
    return CR_ERR_USAGE;
}

enum cr_err cr_xml_stream(const struct cr_import *im, const struct cr_xml_sax *sax,
                          struct cr_error *err) {
    (void)sax;
    return left_out(im->shown, err);
}

enum cr_err cr_xml_load(const char *path, const char *shown, struct cr_arena *arena,
                        struct cr_xml_node **root, struct cr_error *err) {
    (void)path, (void)arena;
    *root = NULL;
    return left_out(shown, err);
}

#endif
