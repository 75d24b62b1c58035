/* Reads XML files for the readers: element by element in constant memory, or whole as a tree.
 *
 * Hostile files are refused in time: a document type with declarations (entities), nesting beyond
 * CR_XML_DEPTH, a tag beyond CR_XML_TAG bytes, a tree beyond CR_XML_NODES elements or CR_XML_BYTES
 * of text. Nothing outside of the file is ever opened. Elements and attributes have their names as
 * the file writes them; namespaces are not looked at. */
#ifndef CR_IMPORT_XML_H
#define CR_IMPORT_XML_H

#include "base/arena.h"
#include "import/reader.h"

#include <stdbool.h>
#include <stddef.h>

enum { CR_XML_DEPTH = 100, CR_XML_TAG = 1 << 20, CR_XML_NODES = 1000000, CR_XML_BYTES = 1 << 27 };

/* An element. Those of cr_xml_stream have no relatives and no text, and live until the call
 * returns. */
struct cr_xml_node {
    const char *name;
    const char *const *attr; /* name, value, ..., NULL */
    const char *text;        /* "" or its characters without the blanks around them */
    int line;
    struct cr_xml_node *parent, *child, *last, *next;
};

/* Whom to tell where elements begin and end. */
struct cr_xml_sax {
    void *user;
    /* both nullable; an error ends the reading */
    enum cr_err (*begin)(void *user, const struct cr_xml_node *node, struct cr_error *err);
    enum cr_err (*end)(void *user, const char *name, struct cr_error *err);
};

/* Tells whether the beginning of a file is XML whose outermost element has that name. */
bool cr_xml_is(const struct cr_import_head *head, const char *root);

/* Hands the elements of im->path to the functions one after the other. Errors: theirs; IO; SYNTAX
 * with the line; RANGE for the limits above; INTERRUPTED; USAGE in a build without expat. */
CR_MUST_CHECK enum cr_err cr_xml_stream(const struct cr_import *im, const struct cr_xml_sax *sax,
                                        struct cr_error *err);

/* Reads the whole file at path, called `shown` in errors, as a tree; cr_arena_free(arena) gives it
 * back, also after an error. Errors: those of cr_xml_stream. */
CR_MUST_CHECK enum cr_err cr_xml_load(const char *path, const char *shown, struct cr_arena *arena,
                                      struct cr_xml_node **root, struct cr_error *err);

/* Finds the first element that "a/b/c" leads to from a node (nullable); NULL if there is none. */
const struct cr_xml_node *cr_xml_find(const struct cr_xml_node *node, const char *path);
/* Gives the next child of that name after `after` (NULL: the first); NULL if there is none. */
const struct cr_xml_node *cr_xml_next(const struct cr_xml_node *parent,
                                      const struct cr_xml_node *after, const char *name);
/* Gives the value of an attribute, NULL if there is none. */
const char *cr_xml_attr(const struct cr_xml_node *node, const char *name);

/* Fills in an error about an element, "<name>: text", with the file and its line; returns code. */
enum cr_err cr_xml_fault(const char *shown, const struct cr_xml_node *node, struct cr_error *err,
                         enum cr_err code, const char *fmt, ...) CR_PRINTF(5, 6);

/* Give the value of an attribute that must be there, as text and as a number. Errors: MISSING,
 * TYPE. */
CR_MUST_CHECK enum cr_err cr_xml_need(const char *shown, const struct cr_xml_node *node,
                                      const char *name, const char **out, struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_xml_number(const char *shown, const struct cr_xml_node *node,
                                        const char *name, double *out, struct cr_error *err);

#endif
