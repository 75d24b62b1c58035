/* Reads a channel from a text of numbers and integrates it to the change of velocity. */
#include "result/channel.h"

#include "base/grow.h"
#include "base/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void cr_channel_fini(struct cr_channel *ch) {
    free(ch->t);
    free(ch->x);
    *ch = (struct cr_channel){.n = 0};
}

static enum cr_err add(struct cr_channel *ch, double t, double x, struct cr_error *err) {
    int same = ch->size;
    if (ch->n == CR_CHANNEL_MAX) {
        return cr_err_set(err, CR_ERR_RANGE, "more than %d samples", CR_CHANNEL_MAX);
    }
    if (!cr_grow(&ch->t, &same, ch->n, sizeof *ch->t) ||
        !cr_grow(&ch->x, &ch->size, ch->n, sizeof *ch->x)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a channel");
    }
    ch->t[ch->n] = t;
    ch->x[ch->n++] = x;
    return CR_ERR_OK;
}

/* Reads the number at *at and moves *at behind the number and the blanks that follow. */
static bool number(const char **at, double *out) {
    const char *end, *p = *at + strspn(*at, " \t");
    *out = cr_number_scan(p, &end);
    *at = end + strspn(end, " \t\r");
    return end != p && isfinite(*out);
}

static enum cr_err bad_line(const char *shown, int line, const char *text, struct cr_error *err) {
    size_t len = strcspn(text, "\r\n");
    cr_err_set(err, CR_ERR_SYNTAX, "no sample: \"%.*s\"", (int)(len < 60 ? len : 60), text);
    cr_err_place(err, shown, line, 0);
    return CR_ERR_SYNTAX;
}

static const char *next_line(const char *p) {
    p += strcspn(p, "\n");
    return *p != '\0' ? p + 1 : p;
}

enum cr_err cr_channel_pairs(const char *text, const char *shown, struct cr_channel *out,
                             struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    int line = 1;
    *out = (struct cr_channel){.n = 0};
    for (const char *p = text; *p != '\0' && code == CR_ERR_OK; p = next_line(p), line++) {
        const char *at = p;
        double t, x;
        if (p[strspn(p, " \t\r\n")] == '\0' || *p == '\n' || *p == '\r' || *p == '#') {
            continue;
        }
        if (!number(&at, &t) || !number(&at, &x) || (*at != '\0' && *at != '\n')) {
            return bad_line(shown, line, p, err);
        }
        if (out->n > 0 && t <= out->t[out->n - 1]) {
            code = cr_err_set(err, CR_ERR_RANGE, "time must rise, got %.9g s after %.9g s", t,
                              out->t[out->n - 1]);
            cr_err_place(err, shown, line, 0);
        }
        code = code == CR_ERR_OK ? add(out, t, x, err) : code;
    }
    return code;
}

enum cr_err cr_channel_values(const char *text, const char *shown, const struct cr_sampling *when,
                              struct cr_channel *out, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    int line = 1;
    *out = (struct cr_channel){.n = 0};
    for (const char *p = text; *p != '\0' && code == CR_ERR_OK; p = next_line(p), line++) {
        const char *at = p;
        double x;
        if (line < when->line || p[strspn(p, " \t\r\n")] == '\0') {
            continue;
        }
        if (!number(&at, &x) || (*at != '\0' && *at != '\n')) {
            return bad_line(shown, line, p, err);
        }
        code = add(out, when->t0 + when->dt * out->n, x, err);
    }
    return code;
}

double cr_channel_integral(const struct cr_channel *ch, double t) {
    double sum = 0;
    for (int i = 0; i + 1 < ch->n; i++) {
        if (ch->t[i] >= 0 && ch->t[i + 1] <= t) {
            sum += (ch->x[i] + ch->x[i + 1]) / 2 * (ch->t[i + 1] - ch->t[i]);
        }
    }
    return sum;
}

double cr_channel_furthest(const struct cr_channel *ch) {
    double sum = 0, most = 0, at = 0;
    for (int i = 0; i + 1 < ch->n; i++) {
        sum += ch->t[i] >= 0 ? (ch->x[i] + ch->x[i + 1]) / 2 * (ch->t[i + 1] - ch->t[i]) : 0;
        if (fabs(sum) > most) {
            most = fabs(sum);
            at = ch->t[i + 1];
        }
    }
    return at;
}
