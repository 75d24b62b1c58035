/* Finds things in XML: the outermost element of a file, and the way to elements and attributes. */
#include "import/xml.h"

#include "base/csv.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Gives the place behind what begins and ends so, NULL where it does not begin so; "" where the end
 * lies beyond the text that is at hand. */
static const char *behind(const char *s, const char *begin, const char *end) {
    if (strncmp(s, begin, strlen(begin)) != 0) {
        return NULL;
    }
    const char *to = strstr(s + strlen(begin), end);
    return to != NULL ? to + strlen(end) : s + strlen(s);
}

/* Gives the place behind a document type, with what it declares in brackets. */
static const char *behind_doctype(const char *s) {
    if (strncmp(s, "<!DOCTYPE", 9) != 0) {
        return NULL;
    }
    int depth = 0;
    for (; *s != '\0'; s++) {
        depth += (*s == '[') - (*s == ']');
        if (*s == '>' && depth <= 0) {
            return s + 1;
        }
    }
    return s;
}

bool cr_xml_is(const struct cr_import_head *head, const char *root) {
    const char *s = head->text, *next = s;
    if (head->folder) {
        return false;
    }
    s += strncmp(s, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (next != NULL) {
        s += strspn(s, " \t\r\n");
        next = behind(s, "<?", "?>");
        next = next != NULL ? next : behind(s, "<!--", "-->");
        next = next != NULL ? next : behind_doctype(s);
        s = next != NULL ? next : s;
        next = *s != '\0' ? next : NULL;
    }
    size_t n = strlen(root);
    return *s == '<' && strncmp(s + 1, root, n) == 0 && s[n + 1] != '\0' &&
           strchr(" \t\r\n/>", s[n + 1]) != NULL;
}

const struct cr_xml_node *cr_xml_next(const struct cr_xml_node *parent,
                                      const struct cr_xml_node *after, const char *name) {
    const struct cr_xml_node *n = parent == NULL  ? NULL
                                  : after != NULL ? after->next
                                                  : parent->child;
    while (n != NULL && strcmp(n->name, name) != 0) {
        n = n->next;
    }
    return n;
}

const struct cr_xml_node *cr_xml_find(const struct cr_xml_node *node, const char *path) {
    while (node != NULL && *path != '\0') {
        size_t n = strcspn(path, "/");
        const struct cr_xml_node *c = node->child;
        while (c != NULL && (strncmp(c->name, path, n) != 0 || c->name[n] != '\0')) {
            c = c->next;
        }
        node = c;
        path += path[n] == '/' ? n + 1 : n;
    }
    return node;
}

const char *cr_xml_attr(const struct cr_xml_node *node, const char *name) {
    for (int i = 0; node->attr != NULL && node->attr[i] != NULL; i += 2) {
        if (strcmp(node->attr[i], name) == 0) {
            return node->attr[i + 1];
        }
    }
    return NULL;
}

enum cr_err cr_xml_fault(const char *shown, const struct cr_xml_node *node, struct cr_error *err,
                         enum cr_err code, const char *fmt, ...) {
    char text[200];
    va_list args;
    va_start(args, fmt);
    vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    cr_err_set(err, code, "<%.40s>: %s", node->name, text);
    cr_err_place(err, shown, node->line, 0);
    return code;
}

enum cr_err cr_xml_need(const char *shown, const struct cr_xml_node *node, const char *name,
                        const char **out, struct cr_error *err) {
    *out = cr_xml_attr(node, name);
    return *out != NULL ? CR_ERR_OK
                        : cr_xml_fault(shown, node, err, CR_ERR_MISSING, "no \"%s\"", name);
}

enum cr_err cr_xml_number(const char *shown, const struct cr_xml_node *node, const char *name,
                          double *out, struct cr_error *err) {
    const char *text;
    enum cr_err code = cr_xml_need(shown, node, name, &text, err);
    if (code == CR_ERR_OK && !cr_csv_scan(text, false, out)) {
        code =
            cr_xml_fault(shown, node, err, CR_ERR_TYPE, "%s is no number: \"%.60s\"", name, text);
    }
    return code;
}
