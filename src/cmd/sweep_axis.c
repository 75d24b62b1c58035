/* The inputs that a sweep varies: "A.speed 30:80:10km/h", "B.type=suv,compact". */
#include "cmd/sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { AXIS_MAX = 1000 };

double cr_sweep_shown(const struct cr_sweep_axis *axis, double at, enum cr_units units) {
    double x = axis->word != NULL ? at : at * axis->unit->div / axis->unit->mul;
    cr_units_shown(units, axis->unit->name, &x, NULL);
    return x;
}

const char *cr_sweep_unit(const struct cr_sweep_axis *axis, enum cr_units units) {
    return cr_units_shown(units, axis->unit->name, NULL, NULL);
}

const char *cr_sweep_text(const struct cr_sweep_axis *axis, double at, enum cr_units units,
                          char *buf, size_t size) {
    if (axis->word != NULL) {
        snprintf(buf, size, "%s", axis->word[(int)at]);
    } else { /* what was typed keeps its digits, what was drawn or turned has those worth reading */
        bool own = !axis->between && cr_sweep_unit(axis, units) == axis->unit->name;
        snprintf(buf, size, own ? "%.6g" : "%.4g", cr_sweep_shown(axis, at, units));
    }
    return buf;
}

bool cr_sweep_known(const struct cr_sweep_run *run) {
    return run->done && !run->failed;
}

bool cr_sweep_deforms(const struct cr_sweep *sweep, int participant) {
    for (int i = 0; i < sweep->n; i++) {
        if (cr_sweep_known(&sweep->run[i]) && sweep->run[i].of[participant].ees > 0) {
            return true;
        }
    }
    return false;
}

/* ---- ranges: from:to:step, a,b,c, or with draws from:to ---- */

static enum cr_err bad_range(const char *text, bool drawn, struct cr_error *err) {
    cr_err_set(err, CR_ERR_SYNTAX, "'%.60s' is no range", text);
    cr_err_hint(err, drawn
                         ? "FROM:TO or A,B,C, for example 30:80km/h"
                         : "FROM:TO:STEP or A,B,C, for example 30:80:10km/h; FROM:TO with draws=N");
    return CR_ERR_SYNTAX;
}

struct numbers {
    int n, max; /* of a range at most 3 */
    double x[AXIS_MAX];
};

/* numbers separated by `sep`; one without a unit takes that of another */
static enum cr_err read_numbers(const char *text, char sep, const struct cr_unit *usual, bool drawn,
                                struct numbers *out, struct cr_error *err) {
    const char *whole = text;
    enum cr_dim dim = usual->dim;
    char part[64];
    const char *end;
    const struct cr_unit *unit = usual;
    for (const char *p = text; *p != '\0'; p += strcspn(p, ":,"), p += *p != '\0') {
        snprintf(part, sizeof part, "%.*s", (int)strcspn(p, ":,"), p);
        cr_number_scan(part, &end);
        if (end != part && *end != '\0' && cr_unit_find(end, dim) != NULL) {
            unit = cr_unit_find(end, dim);
        }
    }
    out->n = 0;
    for (;;) {
        size_t len = strcspn(text, ":,");
        if (out->n == out->max || (text[len] != '\0' && text[len] != sep)) {
            return bad_range(whole, drawn, err);
        }
        snprintf(part, sizeof part, "%.*s", (int)(len < sizeof part ? len : 0), text);
        enum cr_err code = cr_unit_parse(part, dim, unit, &out->x[out->n++], NULL, err);
        if (code != CR_ERR_OK) {
            return code;
        }
        if (text[len] == '\0') {
            return CR_ERR_OK;
        }
        text += len + 1;
    }
}

static enum cr_err spread(const struct numbers *numbers, const char *text,
                          struct cr_sweep_axis *axis, struct cr_error *err) {
    const double *x = numbers->x;
    bool steps = numbers->n == 3 && numbers->max == 3;
    if (steps && (x[2] == 0 || (x[1] - x[0]) / x[2] < 0 || (x[1] - x[0]) / x[2] > AXIS_MAX - 1)) {
        cr_err_set(err, CR_ERR_RANGE, "'%.60s' has no or more than %d steps", text, AXIS_MAX);
        cr_err_hint(err, "the step leads from the first value to the second");
        return CR_ERR_RANGE;
    }
    axis->n = steps ? (int)floor((x[1] - x[0]) / x[2] + 1e-9) + 1 : numbers->n;
    axis->value = calloc((size_t)axis->n, sizeof *axis->value);
    if (axis->value == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    for (int i = 0; i < axis->n; i++) {
        axis->value[i] = steps ? x[0] + i * x[2] : x[i];
    }
    return CR_ERR_OK;
}

static enum cr_err read_range(const char *text, bool drawn, struct cr_sweep_axis *axis,
                              struct cr_error *err) {
    bool colon = strchr(text, ':') != NULL;
    struct numbers numbers = {.max = colon ? 3 : AXIS_MAX};
    enum cr_err code = read_numbers(text, colon ? ':' : ',', axis->unit, drawn, &numbers, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    axis->between = colon && drawn && numbers.n == 2;
    if (colon && numbers.n != 3 && !axis->between) {
        return bad_range(text, drawn, err);
    }
    return spread(&numbers, text, axis, err);
}

/* ---- words: a,b,c ---- */

static enum cr_err read_words(const char *text, struct cr_sweep_axis *axis, struct cr_error *err) {
    int n = 1;
    for (const char *p = text; *p != '\0'; p++) {
        n += *p == ',';
    }
    axis->word = calloc((size_t)n, sizeof *axis->word);
    for (axis->n = 0; axis->word != NULL && axis->n < n; axis->n++) {
        size_t len = strcspn(text, ",");
        axis->word[axis->n] = strndup(text, len);
        if (axis->word[axis->n] == NULL) {
            return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
        }
        text += len + (text[len] == ',');
    }
    return axis->word != NULL ? CR_ERR_OK : cr_err_set(err, CR_ERR_MEMORY, "out of memory");
}

/* a word that cannot be is told before anything is solved */
static enum cr_err try_words(struct cr_session *s, const struct cr_vary *var,
                             const struct cr_sweep_axis *axis, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < axis->n && code == CR_ERR_OK; i++) {
        struct cr_state *state = NULL;
        code = cr_state_dup(cr_session_now(s), &state, err);
        if (code == CR_ERR_OK) {
            code = cr_vary_word(state, var, axis->word[i], err);
        }
        if (code == CR_ERR_OK && strcmp(var->key.key, "car") == 0) {
            const struct cr_car *car;
            code = cr_session_car(s, axis->word[i], &car, err);
        }
        cr_state_free(state);
    }
    return code;
}

/* ---- "KEY RANGE" or "KEY=RANGE" ---- */

static enum cr_err add_axis(struct cr_call *call, const char *name, const char *range,
                            struct cr_sweep *sweep, struct cr_vary *var, struct cr_error *err) {
    struct cr_sweep_axis *axis = &sweep->axis[sweep->axes];
    enum cr_err code = cr_vary_any(call->s, name, var, err);
    if (code != CR_ERR_OK || range == NULL) {
        return code;
    }
    bool words = var->key.dim == CR_DIMS;
    axis->unit =
        words ? cr_unit_find("", CR_DIM_NUMBER) : cr_unit_find(var->key.unit, var->key.dim);
    snprintf(axis->key, sizeof axis->key, "%s", name);
    sweep->axes++; /* what it holds is freed with the sweep */
    code = words ? read_words(range, axis, err) : read_range(range, sweep->drawn, axis, err);
    return code == CR_ERR_OK && words ? try_words(call->s, var, axis, err) : code;
}

static enum cr_err too_many(int most, struct cr_error *err) {
    if (most == CR_SWEEP_AXES) {
        return cr_err_set(err, CR_ERR_SYNTAX, "a sweep varies no more than %d inputs", most);
    }
    cr_err_set(err, CR_ERR_SYNTAX, "all combinations of more than %d inputs are too many", most);
    cr_err_hint(err, "draws=200 takes a Latin hypercube of them, up to %d inputs", CR_SWEEP_AXES);
    return CR_ERR_SYNTAX;
}

static enum cr_err incomplete(const struct cr_call *call, const char *name, struct cr_error *err) {
    cr_err_set(err, CR_ERR_MISSING, "%s%s", name != NULL ? name : "sweep",
               name != NULL ? " needs a range" : " needs KEY RANGE");
    cr_err_hint(err, "for example: %s", call->cmd->example[0]);
    return CR_ERR_MISSING;
}

enum cr_err cr_sweep_axes(struct cr_call *call, struct cr_sweep *sweep, struct cr_vary *var,
                          struct cr_error *err) {
    const struct cr_tokens *t = call->tokens;
    const char *name = NULL;
    sweep->drawn = cr_cmd_given(call, "draws");
    int most = sweep->drawn ? CR_SWEEP_AXES : CR_SWEEP_GRID;
    for (int i = call->rest; i < t->n; i++) {
        const struct cr_token *tok = &t->tok[i];
        if (cr_cmd_is_arg(call, tok)) {
            continue;
        }
        call->blame = tok;
        if (sweep->axes == most) {
            return too_many(most, err);
        }
        bool key = name == NULL && tok->kind == CR_TOKEN_WORD;
        name = key ? tok->text : tok->kind == CR_TOKEN_PAIR ? tok->key : name;
        enum cr_err code =
            add_axis(call, name, key ? NULL : tok->text, sweep, &var[sweep->axes], err);
        if (code != CR_ERR_OK) {
            return code;
        }
        name = key ? name : NULL;
    }
    if (name != NULL || sweep->axes == 0) {
        return incomplete(call, name, err);
    }
    call->blame = NULL;
    return CR_ERR_OK;
}
