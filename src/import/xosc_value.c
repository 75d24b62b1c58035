/* Reads attributes of OpenSCENARIO with parameters and expressions in them, and world positions. */
#include "import/xosc_priv.h"

#include "base/csv.h"
#include "base/grow.h"
#include "import/formula.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SCOPE_DEPTH = 20, SCOPE_MAX = 10000, WORK_MAX = 100000000 };

enum cr_err cr_xosc_declare(struct cr_xosc *x, const char *name, const char *value,
                            struct cr_error *err) {
    struct cr_xosc_scope *s = &x->scope;
    if (s->n == SCOPE_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "more than %d parameters", SCOPE_MAX);
    }
    if (!cr_grow(&s->item, &s->size, s->n, sizeof *s->item)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a parameter");
    }
    s->item[s->n].name = name + (name[0] == '$');
    s->item[s->n++].value = value;
    return CR_ERR_OK;
}

enum cr_err cr_xosc_enter(struct cr_xosc *x, const struct cr_xml_node *node, struct cr_error *err) {
    static const char *const lists[] = {"ParameterDeclarations", "VariableDeclarations"};
    for (int k = 0; k < 2; k++) {
        const struct cr_xml_node *list = cr_xml_find(node, lists[k]);
        for (const struct cr_xml_node *d = list != NULL ? list->child : NULL; d != NULL;
             d = d->next) {
            const char *name, *value;
            enum cr_err code = cr_xml_need(x->shown, d, "name", &name, err);
            code = code == CR_ERR_OK ? cr_xml_need(x->shown, d, "value", &value, err) : code;
            code = code == CR_ERR_OK ? cr_xosc_declare(x, name, value, err) : code;
            if (code != CR_ERR_OK) {
                return code;
            }
        }
    }
    return CR_ERR_OK;
}

void cr_xosc_leave(struct cr_xosc *x, int n) {
    x->scope.n = n;
}

bool cr_xosc_is_one_of(const char *word, const char *const *list) {
    while (*list != NULL && strcmp(word, *list) != 0) {
        list++;
    }
    return *list != NULL;
}

/* ---- values ---- */

static enum cr_err lookup(struct cr_xosc *x, const char *name, const char **out,
                          struct cr_error *err) {
    x->scope.work += x->scope.n + 1;
    if (x->scope.work > WORK_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "parameters are made of each other without end");
    }
    for (int i = x->scope.n - 1; i >= 0; i--) {
        if (strcmp(x->scope.item[i].name, name) == 0) {
            *out = x->scope.item[i].value;
            return CR_ERR_OK;
        }
    }
    cr_err_set(err, CR_ERR_NAME, "no parameter $%.60s", name);
    cr_err_hint(err, "declare it under ParameterDeclarations");
    return CR_ERR_NAME;
}

static enum cr_err number_of(struct cr_xosc *x, const char *text, double *out,
                             struct cr_error *err);

static enum cr_err value_of_name(void *user, const char *name, double *out, struct cr_error *err) {
    const char *text = NULL;
    enum cr_err code = lookup(user, name, &text, err);
    return code == CR_ERR_OK ? number_of(user, text, out, err) : code;
}

/* Gives the number that a text stands for. Parameters may be made of others, but not of themselves:
 * the depth is limited. */
static enum cr_err number_of(struct cr_xosc *x, const char *text, double *out,
                             struct cr_error *err) {
    const struct cr_formula_names names = {value_of_name, x};
    size_t n = strlen(text);
    char inner[1024];
    enum cr_err code;
    if (text[0] != '$') {
        bool word = strcmp(text, "true") == 0 || strcmp(text, "false") == 0;
        *out = strcmp(text, "true") == 0;
        return word || cr_csv_scan(text, false, out)
                   ? CR_ERR_OK
                   : cr_err_set(err, CR_ERR_TYPE, "no number: \"%.60s\"", text);
    }
    if (x->scope.depth >= SCOPE_DEPTH) {
        return cr_err_set(err, CR_ERR_RANGE, "parameters go round in a circle: \"%.60s\"", text);
    }
    x->scope.depth++;
    if (text[1] != '{') {
        code = value_of_name(x, text + 1, out, err);
    } else if (text[n - 1] != '}' || n >= sizeof inner) {
        code = cr_err_set(err, CR_ERR_SYNTAX, "no expression ${...}: \"%.60s\"", text);
    } else {
        snprintf(inner, sizeof inner, "%.*s", (int)(n - 3), text + 2);
        code = cr_formula(inner, &names, out, err);
    }
    x->scope.depth--;
    return code;
}

/* Has an error say whose attribute was at fault. */
static enum cr_err blame(struct cr_xosc *x, const struct cr_xml_node *node, const char *name,
                         struct cr_error *err) {
    struct cr_error why = *err;
    cr_xml_fault(x->shown, node, err, why.code, "%.40s: %.140s", name, why.text);
    if (why.hint[0] != '\0') {
        cr_err_hint(err, "%s", why.hint);
    }
    return why.code;
}

enum cr_err cr_xosc_number(struct cr_xosc *x, const struct cr_xml_node *node, const char *name,
                           double fallback, double *out, struct cr_error *err) {
    const char *text = cr_xml_attr(node, name);
    if (text == NULL && !isnan(fallback)) {
        *out = fallback;
        return CR_ERR_OK;
    }
    enum cr_err code = cr_xml_need(x->shown, node, name, &text, err);
    if (code == CR_ERR_OK && number_of(x, text, out, err) != CR_ERR_OK) {
        code = blame(x, node, name, err);
    }
    return code;
}

enum cr_err cr_xosc_text(struct cr_xosc *x, const struct cr_xml_node *node, const char *name,
                         const char *fallback, const char **out, struct cr_error *err) {
    *out = cr_xml_attr(node, name);
    if (*out == NULL && fallback != NULL) {
        *out = fallback;
        return CR_ERR_OK;
    }
    enum cr_err code = cr_xml_need(x->shown, node, name, out, err);
    for (int i = 0; code == CR_ERR_OK && (*out)[0] == '$' && (*out)[1] != '{'; i++) {
        code = i < SCOPE_DEPTH ? lookup(x, *out + 1, out, err)
                               : cr_err_set(err, CR_ERR_RANGE, "parameters go round in a circle");
        if (code != CR_ERR_OK) {
            return blame(x, node, name, err);
        }
    }
    return code;
}

/* ---- positions ---- */

enum cr_err cr_xosc_refuse(struct cr_xosc *x, const struct cr_xml_node *node, struct cr_error *err,
                           const char *what) {
    cr_xml_fault(x->shown, node, err, CR_ERR_TYPE, "%s", what);
    cr_err_hint(err,
                "run it: esmini --headless --csv_logger log.csv --osc FILE, and import log.csv");
    return CR_ERR_TYPE;
}

enum cr_err cr_xosc_position(struct cr_xosc *x, const struct cr_xml_node *node, struct cr_vec2 *pos,
                             double *heading, struct cr_error *err) {
    const struct cr_xml_node *position = cr_xml_find(node, "Position");
    const struct cr_xml_node *at = position != NULL ? position->child : NULL;
    if (at == NULL) {
        return cr_xml_fault(x->shown, node, err, CR_ERR_MISSING, "no <Position>");
    }
    if (strcmp(at->name, "WorldPosition") != 0) {
        return cr_xosc_refuse(x, at, err, "only a WorldPosition can be read without the road");
    }
    enum cr_err code = cr_xosc_number(x, at, "x", NAN, &pos->x, err);
    code = code == CR_ERR_OK ? cr_xosc_number(x, at, "y", NAN, &pos->y, err) : code;
    *heading = NAN;
    if (code == CR_ERR_OK && cr_xml_attr(at, "h") != NULL) {
        code = cr_xosc_number(x, at, "h", NAN, heading, err);
    }
    return code;
}
