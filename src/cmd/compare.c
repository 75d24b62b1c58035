/* compare with a measured pulse: overlay, RMS error and ratings, by the code of crumple validate;
 * and with evidence as it is typed. */
#include "cmd/vary.h"

#include "base/units.h"
#include "render/render.h"
#include "result/compare.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* the participant that was named, else the only one that moves; -1 if there is none */
static int whose(struct cr_call *call, struct cr_error *err) {
    const struct cr_result *r = call->s->result;
    const char *name = cr_cmd_text(call, "of", NULL);
    int found = -1, moving = 0;
    for (int i = 0; i < r->resolved.n; i++) {
        bool moves = cr_result_moves(r, i);
        if (name != NULL ? strcmp(r->resolved.part[i].id, name) == 0 : moves) {
            found = i;
        }
        moving += moves;
    }
    if (name == NULL && moving > 1) {
        cr_err_set(err, CR_ERR_MISSING, "a pulse is that of one vehicle");
        cr_err_hint(err, "add of=%s", r->resolved.part[0].id);
        return -1;
    }
    if (found < 0) {
        cr_err_set(err, CR_ERR_NAME, "there is no '%s' in this result", name != NULL ? name : "");
        cr_cmd_blame(call, "of", CR_ERR_NAME);
    }
    return found;
}

/* both curves in the unit that is shown, over ms */
static enum cr_err plot(struct cr_session *s, const struct cr_compare *c, int body, double unit,
                        const char *unit_name, struct cr_error *err) {
    double *memory = calloc(3 * (size_t)c->n, sizeof *memory);
    if (memory == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    double *t = memory, *test = t + c->n, *own = test + c->n;
    for (int i = 0; i < c->n; i++) {
        t[i] = 1e3 * (c->t0 + i * c->dt);
        test[i] = c->measured[i] / unit;
        own[i] = c->simulated[i] / unit;
    }
    const char *id = s->result->resolved.part[body].id;
    const struct cr_curve_line curve[] = {{.x = t,
                                           .y = own,
                                           .n = c->n,
                                           .mark = cr_render_mark(&s->result->resolved, body),
                                           .name = id,
                                           .role = cr_render_role_of(body)},
                                          {.x = t,
                                           .y = test,
                                           .n = c->n,
                                           .mark = 't',
                                           .name = "test",
                                           .role = CR_ROLE_REFERENCE,
                                           .dashed = true}};
    const struct cr_plot shown = {.title = "measured and computed",
                                  .x_unit = "ms",
                                  .y_unit = unit_name,
                                  .curves = 2,
                                  .curve = curve,
                                  .cursor = NAN};
    enum cr_err code = cr_cmd_plot(s, &shown, 8, err);
    free(memory);
    return code;
}

static void say(struct cr_session *s, const struct cr_compare *c, double unit, const char *name) {
    cr_say(s, "%.0f to %.0f ms: RMS error %.3g %s", 1e3 * c->t0, 1e3 * (c->t0 + (c->n - 1) * c->dt),
           c->rms / unit, name);
    cr_say(s, "largest: test %.4g %s at %.1f ms, result %.4g %s at %.1f ms",
           c->peak_measured / unit, name, 1e3 * c->t_peak_measured, c->peak_simulated / unit, name,
           1e3 * c->t_peak_simulated);
    cr_say(s,
           "ISO/TS 18571: corridor %.2f, phase %.2f, magnitude %.2f, slope %.2f, rating %.2f (%s)",
           c->iso.corridor, c->iso.phase, c->iso.magnitude, c->iso.slope, c->iso.total,
           cr_rating_grade(c->iso.total));
    cr_say(s, "CORA: corridor %.2f, progression %.2f, phase %.2f, size %.2f, rating %.2f",
           c->cora.corridor, c->cora.progression, c->cora.phase, c->cora.size, c->cora.total);
}

/* "Delta-V, Longitudinal (km/h)": what a recorder calls its cumulative change of velocity */
static bool of_recorder(const struct cr_signal *measured) {
    char low[sizeof measured->name];
    size_t n = 0;
    for (; measured->name[n] != '\0'; n++) {
        low[n] = (char)tolower((unsigned char)measured->name[n]);
    }
    low[n] = '\0';
    return strcmp(measured->unit, "m/s") == 0 &&
           (strstr(low, "delta-v") != NULL || strstr(low, "delta v") != NULL ||
            strstr(low, "delta_v") != NULL);
}

/* the corridor of a recorder, and which sign was taken: makers do not agree on it */
static enum cr_err say_corridor(struct cr_session *s, int body, const struct cr_signal *measured,
                                const struct cr_compare_opts *opts, struct cr_error *err) {
    struct cr_corridor c;
    enum cr_err code = cr_compare_corridor(s->result->solution, body, measured, opts, &c, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_say(s,
           "recorder: within +-10 %% (at least 1 km/h) at %d of %d times, its time 0 %.1f ms %s"
           " the first contact",
           c.inside, c.times, 1e3 * fabs(c.shift), c.shift < 0 ? "before" : "after");
    cr_say(s, "its largest delta-v %.4g km/h, the result's in that time %.4g km/h",
           cr_kmh(c.peak_measured), cr_kmh(c.peak_simulated));
    cr_say(s, "sign: %s is positive, %s", opts->axis == CR_COMPARE_LEFT ? "left" : "forward",
           opts->sign < 0 ? "the file's values were turned (sign=minus)"
                          : "as it is taken to be in the file (sign=minus turns it)");
    return CR_ERR_OK;
}

/* The axis that was named; a channel knows its own, and which signs it was measured with is told.
 * A channel of a velocity becomes that of its change since time 0. */
static enum cr_err take_axis(struct cr_call *call, struct cr_signal *measured,
                             struct cr_compare_opts *opts, struct cr_error *err) {
    enum cr_compare_axis asked = opts->axis;
    if (measured->axis == '\0') {
        return CR_ERR_OK;
    }
    opts->axis = measured->axis == 'Y' ? CR_COMPARE_LEFT : CR_COMPARE_FORWARD;
    if ((measured->axis != 'X' && measured->axis != 'Y') ||
        (cr_cmd_given(call, "axis") && asked != opts->axis)) {
        cr_err_set(err, CR_ERR_TYPE, "channel %.60s is not along the axis %s", measured->name,
                   asked == CR_COMPARE_LEFT ? "left" : "forward");
        cr_err_hint(err, "name another channel with column=");
        return CR_ERR_TYPE;
    }
    cr_say(call->s, "channel %s, taken with %s%s (sign=minus turns it)", measured->name,
           opts->axis == CR_COMPARE_LEFT ? "right" : "forward",
           opts->sign < 0 ? " negative" : " positive, as laboratories have it");
    double first =
        strcmp(measured->unit, "m/s") == 0 ? cr_signal_at(measured, 0, measured->x[0]) : 0;
    for (int i = 0; i < measured->n; i++) {
        measured->x[i] -= first;
    }
    return CR_ERR_OK;
}

enum cr_err cr_cmd_compare_pulse(struct cr_call *call, const char *path, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct cr_signal measured = {0};
    struct cr_compare c = {0};
    struct cr_compare_opts opts = cr_compare_default();
    double least = cr_cmd_number(call, "rating", 0);
    int body = whose(call, err);
    if (body < 0) {
        return err != NULL ? err->code : CR_ERR_MISSING;
    }
    opts.axis = cr_cmd_word(call, "axis", 0) == 1 ? CR_COMPARE_LEFT : CR_COMPARE_FORWARD;
    opts.sign = cr_cmd_word(call, "sign", 0) == 1 ? -1 : 1;
    const struct cr_signal_pick pick = {cr_cmd_text(call, "column", NULL), body + 1,
                                        opts.axis == CR_COMPARE_LEFT};
    enum cr_err code = cr_signal_load_any(path, &pick, &measured, err);
    code = code == CR_ERR_OK ? take_axis(call, &measured, &opts, err) : code;
    if (code == CR_ERR_OK) {
        code = cr_compare_pulse(s->result->solution, body, &measured, &opts, &c, err);
    }
    if (code == CR_ERR_OK) {
        bool velocity = strcmp(measured.unit, "m/s") == 0;
        double unit = velocity ? 1 / 3.6 : CR_G;
        const char *name = velocity ? "km/h" : "g";
        code = plot(s, &c, body, unit, name, err);
        say(s, &c, unit, name);
    }
    if (code == CR_ERR_OK && of_recorder(&measured)) {
        code = say_corridor(s, body, &measured, &opts, err);
    }
    if (code == CR_ERR_OK && c.iso.total < least) {
        code = cr_err_set(err, CR_ERR_MISSED, "the rating is %.2f, less than %.10g", c.iso.total,
                          least);
    }
    cr_compare_fini(&c);
    cr_signal_free(&measured);
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "FILE", code);
}

static enum cr_err read_evidence(struct cr_call *call, struct cr_fit_evidence *out,
                                 struct cr_error *err) {
    const struct cr_tokens *t = call->tokens;
    enum cr_err code = CR_ERR_OK;
    for (int i = call->rest; i < t->n && code == CR_ERR_OK; i++) {
        const struct cr_token *tok = &t->tok[i];
        if (cr_cmd_is_arg(call, tok) || tok->kind == CR_TOKEN_FLAG) {
            continue;
        }
        call->blame = tok;
        code = cr_cmd_evidence(tok, &call->s->result->resolved, out, err);
    }
    if (code == CR_ERR_OK && out->n == 0) {
        code = cr_err_set(err, CR_ERR_MISSING, "compare needs a file or what was measured");
        cr_err_hint(err, CR_FIT_EVIDENCE_HINT);
    }
    return code;
}

/* What the result has no value for is missed whatever was allowed. */
static enum cr_err missed(const char *absent, double worst, double within, struct cr_error *err) {
    return absent != NULL
               ? cr_err_set(err, CR_ERR_MISSED, "the result has no %s", absent)
               : cr_err_set(err, CR_ERR_MISSED,
                            "the largest error is %.1f tolerances, more than %.10g", worst, within);
}

enum cr_err cr_cmd_compare_evidence(struct cr_call *call, struct cr_error *err) {
    struct cr_fit_evidence evidence = {.n = 0};
    struct cr_str text = {0};
    const char *absent = NULL;
    double found[CR_FIT_TARGETS] = {0}, within = cr_cmd_number(call, "within", INFINITY), worst = 0;
    enum cr_err code = cr_session_need_whole(call->s, err);
    if (code == CR_ERR_OK) {
        code = read_evidence(call, &evidence, err);
    }
    const struct cr_result *r = call->s->result;
    if (code == CR_ERR_OK && cr_cmd_given(call, "FILE")) {
        return cr_err_set(err, CR_ERR_DUPLICATE, "compare takes a file or what was measured");
    }
    if (code == CR_ERR_OK && evidence.to_rest && r->resolved.set.end != CR_END_REST) {
        cr_err_set(err, CR_ERR_MISSING, "this result ends before the vehicles stand");
        cr_err_hint(err, "set end=rest; solve");
        code = CR_ERR_MISSING;
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    call->blame = NULL;
    for (int k = 0; k < evidence.n; k++) {
        const struct cr_fit_target *t = &evidence.target[k];
        found[k] = cr_fit_found(r, t);
        double error = fabs(found[k] - t->value) / t->half;
        worst = isnan(error) ? (double)INFINITY : fmax(worst, error);
        absent = isnan(error) && absent == NULL ? t->name : absent;
    }
    cr_fit_evidence_text(&evidence, found, &text);
    cr_session_lines(call->s, &text, false);
    cr_str_fini(&text);
    return worst > within ? missed(absent, worst, within, err) : CR_ERR_OK;
}
