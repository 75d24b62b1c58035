/* Evaluates expressions of OpenSCENARIO by recursive descent, with a function for each level of
 * precedence; the depth is limited, because files may be hostile. */
#include "import/formula.h"

#include "base/units.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { DEPTH = 50, ARGS = 2, NAME = 64 };

struct formula {
    const char *text, *at;
    const struct cr_formula_names *names;
    int depth;
    enum cr_err code;
    struct cr_error *err;
};

static double any(struct formula *f);

static double fail(struct formula *f, const char *what) {
    if (f->code == CR_ERR_OK) {
        f->code = cr_err_set(f->err, CR_ERR_SYNTAX, "\"%.100s\": %s at character %d", f->text, what,
                             (int)(f->at - f->text) + 1);
    }
    return 0;
}

/* Goes on behind a sign or word if it is next, and tells whether it was. */
static bool take(struct formula *f, const char *word) {
    size_t n = strlen(word);
    f->at += strspn(f->at, " \t\r\n");
    if (f->code != CR_ERR_OK || strncmp(f->at, word, n) != 0) {
        return false;
    }
    bool letters = word[0] >= 'a' && word[0] <= 'z';
    if (letters && strspn(f->at + n, "abcdefghijklmnopqrstuvwxyz0123456789_") > 0) {
        return false;
    }
    f->at += n;
    return true;
}

/* ---- functions ---- */

static double sign_of(double x) {
    return (x > 0) - (x < 0);
}

static const struct function {
    const char *name;
    double (*of1)(double);
    double (*of2)(double, double);
} functions[] = {
    {"abs", fabs, NULL},  {"sign", sign_of, NULL}, {"round", round, NULL}, {"floor", floor, NULL},
    {"ceil", ceil, NULL}, {"sqrt", sqrt, NULL},    {"pow", NULL, pow},     {"min", NULL, fmin},
    {"max", NULL, fmax},  {"sin", sin, NULL},      {"cos", cos, NULL},     {"tan", tan, NULL},
    {"asin", asin, NULL}, {"acos", acos, NULL},    {"atan", atan, NULL},   {"atan2", NULL, atan2},
};

static double call(struct formula *f, const struct function *fn) {
    double x[ARGS] = {0};
    int n = fn->of2 != NULL ? 2 : 1;
    if (!take(f, "(")) {
        return fail(f, "( expected");
    }
    for (int i = 0; i < n; i++) {
        x[i] = any(f);
        if (!take(f, i + 1 < n ? "," : ")")) {
            return fail(f, i + 1 < n ? ", expected" : ") expected");
        }
    }
    return n == 2 ? fn->of2(x[0], x[1]) : fn->of1(x[0]);
}

/* ---- levels, from the tightest ---- */

static double parameter(struct formula *f) {
    char name[NAME];
    double x = 0;
    size_t n = strspn(f->at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
    if (n == 0 || n >= NAME) {
        return fail(f, "a name expected");
    }
    snprintf(name, sizeof name, "%.*s", (int)n, f->at);
    f->at += n;
    enum cr_err code = f->names->value(f->names->user, name, &x, f->err);
    f->code = f->code == CR_ERR_OK ? code : f->code;
    return x;
}

static double primary(struct formula *f) {
    const char *end;
    f->at += strspn(f->at, " \t\r\n");
    if (take(f, "(")) {
        double x = any(f);
        return take(f, ")") ? x : fail(f, ") expected");
    }
    if (take(f, "$")) {
        return parameter(f);
    }
    if (take(f, "true")) {
        return 1;
    }
    if (take(f, "false")) {
        return 0;
    }
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++) {
        if (take(f, functions[i].name)) {
            return call(f, &functions[i]);
        }
    }
    double x = cr_number_scan(f->at, &end);
    if (end == f->at) {
        return fail(f, "a number, $name or function expected");
    }
    f->at = end;
    return x;
}

static double unary(struct formula *f) {
    double x;
    if (++f->depth > DEPTH) {
        f->depth--;
        return fail(f, "nested too deeply");
    }
    if (take(f, "-")) {
        x = -unary(f);
    } else if (take(f, "+")) {
        x = unary(f);
    } else if (take(f, "not")) {
        x = unary(f) == 0;
    } else {
        x = primary(f);
    }
    f->depth--;
    return x;
}

static double product(struct formula *f) {
    double x = unary(f);
    while (f->code == CR_ERR_OK) {
        if (take(f, "*")) {
            x *= unary(f);
        } else if (take(f, "/")) {
            x /= unary(f);
        } else if (take(f, "%")) {
            x = fmod(x, unary(f));
        } else {
            break;
        }
    }
    return x;
}

static double sum(struct formula *f) {
    double x = product(f);
    while (f->code == CR_ERR_OK) {
        if (take(f, "+")) {
            x += product(f);
        } else if (take(f, "-")) {
            x -= product(f);
        } else {
            break;
        }
    }
    return x;
}

static double comparison(struct formula *f) {
    double x = sum(f);
    if (take(f, "==")) {
        return x == sum(f);
    }
    if (take(f, "!=")) {
        return x != sum(f);
    }
    if (take(f, "<=")) {
        return x <= sum(f);
    }
    if (take(f, ">=")) {
        return x >= sum(f);
    }
    if (take(f, "<")) {
        return x < sum(f);
    }
    return take(f, ">") ? x > sum(f) : x;
}

static double any(struct formula *f) {
    double x = comparison(f);
    while (f->code == CR_ERR_OK) {
        if (take(f, "and")) {
            double y = comparison(f);
            x = x != 0 && y != 0;
        } else if (take(f, "or")) {
            double y = comparison(f);
            x = x != 0 || y != 0;
        } else {
            break;
        }
    }
    return x;
}

enum cr_err cr_formula(const char *text, const struct cr_formula_names *names, double *out,
                       struct cr_error *err) {
    struct formula f = {.text = text, .at = text, .names = names, .err = err};
    double x = any(&f);
    f.at += strspn(f.at, " \t\r\n");
    if (f.code == CR_ERR_OK && *f.at != '\0') {
        fail(&f, "an operator expected");
    }
    if (f.code == CR_ERR_OK && !isfinite(x)) {
        f.code = cr_err_set(err, CR_ERR_RANGE, "\"%.100s\" has no finite value", text);
    }
    *out = x;
    return f.code;
}
