/* Writes what real crashes say: statistics as text, with a scatter plot, and as JSON; rows as
 * CSV. */
#include "trial/field.h"
#include "trial/verdict.h"

#include "base/json.h"
#include "base/tree.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A number in its column, a dash where there is none. */
static void say(struct cr_str *out, int width, int digits, bool sign, double x) {
    if (isfinite(x)) {
        cr_str_addf(out, sign ? " %+*.*f" : " %*.*f", width, digits, x);
    } else {
        cr_str_addf(out, " %*s", width, "-");
    }
}

static void say_stats(struct cr_str *out, const struct cr_field_stats *s, bool median) {
    say(out, 6, 1, true, s->bias);
    say(out, 6, 1, false, s->mape);
    if (median) {
        say(out, 7, 1, true, s->median);
    }
    say(out, 7, 3, false, s->log_sd);
}

static void say_row(struct cr_str *out, const char *name, const struct cr_field_result *r) {
    cr_str_addf(out, "  %-18s %4d", name, r->own.n);
    say_stats(out, &r->own, true);
    cr_str_addf(out, " | %4d", r->same.n);
    say_stats(out, &r->same, false);
    cr_str_add(out, " |");
    say_stats(out, &r->smash, false);
    cr_str_add(out, "\n");
}

static enum cr_err say_groups(const struct cr_field_table *field, struct cr_str *out,
                              struct cr_error *err) {
    struct cr_field_result r;
    enum cr_err code = cr_field_result(field, -1, -1, &r, err);
    if (code == CR_ERR_OK) {
        say_row(out, "all", &r);
    }
    for (int k = 0; k < CR_FIELD_KINDS && code == CR_ERR_OK; k++) {
        code = cr_field_result(field, k, -1, &r, err);
        if (code == CR_ERR_OK && r.own.n > 0) {
            say_row(out, cr_field_kind_word((enum cr_field_kind)k), &r);
        }
    }
    if (code == CR_ERR_OK) {
        code = cr_field_result(field, CR_FIELD_OFFSET, -1, &r, err);
        say_row(out, "front < 60 % wide", &r);
    }
    for (int b = 0; b < CR_FIELD_BANDS && code == CR_ERR_OK; b++) {
        char name[32];
        double to = cr_field_band(b + 1);
        code = cr_field_result(field, CR_FIELD_BAND + b, -1, &r, err);
        snprintf(name, sizeof name, isfinite(to) ? "  %.0f to %.0f %%" : "  %.0f %% and more",
                 100 * cr_field_band(b), 100 * to);
        if (code == CR_ERR_OK && r.own.n > 0) {
            say_row(out, name, &r);
        }
    }
    for (int t = 0; t < CR_TYPES && code == CR_ERR_OK; t++) {
        code = cr_field_result(field, -1, t, &r, err);
        if (code == CR_ERR_OK && r.own.n > 0) {
            say_row(out, cr_type_word((enum cr_type)t), &r);
        }
    }
    return code;
}

static void say_plot(const struct cr_field_table *field, struct cr_str *out) {
    enum { WIDE = 60, HIGH = 24 };
    static const char marks[] = " .:+*#@";
    int count[HIGH][WIDE] = {{0}};
    double top = 0;
    for (int i = 0; i < field->n; i++) {
        top = fmax(top, fmax(cr_kmh(field->row[i].measured), cr_kmh(field->row[i].value)));
    }
    top = 10 * ceil(top / 10);
    for (int i = 0; i < field->n; i++) {
        int x = (int)(cr_kmh(field->row[i].measured) / top * (WIDE - 1) + 0.5);
        int y = (int)(cr_kmh(field->row[i].value) / top * (HIGH - 1) + 0.5);
        count[y][x]++;
    }
    cr_str_add(out, "  delta-v from damage over recorder, km/h; / is equality\n");
    for (int y = HIGH - 1; y >= 0; y--) {
        char line[WIDE + 1] = "";
        for (int x = 0; x < WIDE; x++) {
            bool equal = (int)((double)x / (WIDE - 1) * (HIGH - 1) + 0.5) == y;
            line[x] = count[y][x] > 0 ? marks[count[y][x] < 6 ? count[y][x] : 6]
                      : equal         ? '/'
                                      : ' ';
        }
        if (y == HIGH - 1) {
            cr_str_addf(out, "  %6.0f |%s|\n", top, line);
        } else {
            cr_str_addf(out, "         |%s|\n", line);
        }
    }
    cr_str_addf(out, "          0%*.0f\n", WIDE, top);
}

static void say_cases(const struct cr_field_table *field, struct cr_str *out) {
    cr_str_add(out,
               "  case/vehicle          kind         type            recorder  damage WinSMASH "
               "km/h\n");
    for (int i = 0; i < field->n; i++) {
        const struct cr_field_row *r = &field->row[i];
        cr_str_addf(out, "  %-21s %-12s %-15s %8.1f %7.1f", r->name, cr_field_kind_word(r->kind),
                    cr_type_word(r->what.car[0].p->type), cr_kmh(r->measured), cr_kmh(r->value));
        if (isnan(r->winsmash)) {
            cr_str_add(out, "        -\n");
        } else {
            cr_str_addf(out, " %8.1f\n", cr_kmh(r->winsmash));
        }
    }
}

enum cr_err cr_field_text(const struct cr_field_table *field, const struct cr_field_form *form,
                          const struct cr_crush_rules *rules, struct cr_str *out,
                          struct cr_error *err) {
    cr_str_addf(out, "field: delta-v from the measured damage against event data recorders (%s)\n",
                form->title);
    cr_str_addf(
        out, "  %d recorders pass the filter (share/validation/field/filter.csv), %d do not%s\n",
        field->n, field->dropped, form->crossed ? "; cross-validated by case in five folds" : "");
    if (form->guess) {
        cr_str_add(out, "  as if nothing had been measured of the partners but their face\n");
    }
    cr_str_addf(out, "  %-18s %-34s | the rows that WinSMASH has too\n", "", "all rows");
    cr_str_addf(out, "  %-18s %-34s | %-26s | WinSMASH\n", "", "", "damage");
    cr_str_addf(out, "  %-18s %4s %6s %6s %7s %7s | %4s %6s %6s %7s | %6s %6s %7s\n", "", "n",
                "bias%", "MAPE%", "median%", "log SD", "n", "bias%", "MAPE%", "log SD", "bias%",
                "MAPE%", "log SD");
    if (field->n == 0) {
        cr_str_add(out, "  no row passes the filter\n");
        return CR_ERR_OK;
    }
    enum cr_err code = say_groups(field, out, err);
    cr_str_addf(
        out,
        "  Only the directions that a recorder gave are compared; a front's recorder counts "
        "%.1f km/h\n  of braking. A recorder's own noise is about %.0f %%: no model can be "
        "judged finer per car.\n",
        cr_kmh(rules->drag), 100 * rules->noise);
    if (!form->guess) {
        cr_str_addf(out, "  The intervals of 95 %% hold %.0f %% of the recorders.\n",
                    100 * cr_field_inside(field, -1, rules->noise));
    }
    if (form->plot) {
        say_plot(field, out);
    }
    if (form->cases) {
        say_cases(field, out);
    }
    cr_verdict_targets_text(form->targets, "delta-v from damage, cross-validated by case", out);
    return code == CR_ERR_OK && out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory") : code;
}

/* ---- JSON, CSV ---- */

static cJSON *number(double x) {
    return isfinite(x) ? cJSON_CreateNumber(x) : cJSON_CreateNull();
}

static void add_stats(cJSON *to, const char *prefix, const struct cr_field_stats *s) {
    const struct {
        const char *key;
        double value;
    } values[] = {{"n", s->n},
                  {"bias_percent", s->bias},
                  {"mape_percent", s->mape},
                  {"median_percent", s->median},
                  {"log_sd", s->log_sd}};
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        char key[40];
        snprintf(key, sizeof key, "%s%s", prefix, values[i].key);
        cr_tree_put(to, key, number(values[i].value));
    }
}

/* Adds ours and WinSMASH's statistics on the rows that both have (all, if WinSMASH has none), and
 * ours on all. */
static void add_summary(cJSON *to, const char *name, const struct cr_field_result *r) {
    cJSON *o = cr_tree_object(to, name);
    add_stats(o, "", r->same.n > 0 ? &r->same : &r->own);
    add_stats(o, "winsmash_", &r->smash);
    add_stats(o, "all_rows_", &r->own);
}

static cJSON *row_json(const struct cr_field_row *r) {
    cJSON *o = cJSON_CreateObject();
    cr_tree_text(o, "case", r->name);
    cr_tree_number(o, "line", r->line);
    cr_tree_text(o, "kind", cr_field_kind_word(r->kind));
    cr_tree_text(o, "type", cr_type_word(r->what.car[0].p->type));
    cr_tree_text(o, "face", cr_face_word(r->what.car[0].m.face));
    cr_tree_put(o, "recorder_kmh", number(cr_kmh(r->measured)));
    cr_tree_put(o, "damage_kmh", number(cr_kmh(r->value)));
    cr_tree_put(o, "damage_low_kmh", number(cr_kmh(r->lo)));
    cr_tree_put(o, "damage_high_kmh", number(cr_kmh(r->hi)));
    cr_tree_put(o, "winsmash_kmh", number(cr_kmh(r->winsmash)));
    return o;
}

enum cr_err cr_field_json(const struct cr_field_table *field, const struct cr_field_form *form,
                          const struct cr_crush_rules *rules, struct cr_str *out,
                          struct cr_error *err) {
    cJSON *root = cJSON_CreateObject();
    struct cr_field_result r;
    cr_tree_text(root, "class", "field");
    cr_tree_bool(root, "cross_validated", form->crossed);
    cr_tree_bool(root, "partners_guessed", form->guess);
    cr_tree_number(root, "left_out_by_filter", field->dropped);
    cr_tree_number(root, "recorder_noise_percent", 100 * rules->noise);
    cr_tree_put(root, "inside_interval_percent",
                number(100 * cr_field_inside(field, -1, rules->noise)));
    cJSON *rows = cr_tree_array(root, "rows");
    for (int i = 0; i < field->n; i++) {
        cr_tree_push(rows, row_json(&field->row[i]));
    }
    cJSON *summary = cr_tree_object(root, "summary");
    enum cr_err code = cr_field_result(field, -1, -1, &r, err);
    if (code == CR_ERR_OK) {
        add_summary(summary, "all", &r);
    }
    for (int k = 0; k < CR_FIELD_KINDS && code == CR_ERR_OK; k++) {
        code = cr_field_result(field, k, -1, &r, err);
        if (code == CR_ERR_OK) {
            add_summary(summary, cr_field_kind_word((enum cr_field_kind)k), &r);
        }
    }
    if (code == CR_ERR_OK) {
        code = cr_field_result(field, CR_FIELD_OFFSET, -1, &r, err);
        add_summary(summary, "front-offset", &r);
    }
    cJSON *bands = cr_tree_array(root, "front_by_width");
    for (int b = 0; b < CR_FIELD_BANDS && code == CR_ERR_OK; b++) {
        cJSON *band = cJSON_CreateObject();
        cr_tree_push(bands, band);
        cr_tree_number(band, "from_share", cr_field_band(b));
        cr_tree_put(band, "to_share", number(cr_field_band(b + 1)));
        code = cr_field_result(field, CR_FIELD_BAND + b, -1, &r, err);
        add_summary(band, "delta_v", &r);
    }
    cJSON *types = cr_tree_object(root, "types");
    for (int t = 0; t < CR_TYPES && code == CR_ERR_OK; t++) {
        code = cr_field_result(field, -1, t, &r, err);
        if (code == CR_ERR_OK) {
            add_summary(types, cr_type_word((enum cr_type)t), &r);
        }
    }
    cr_verdict_targets_json(form->targets, root);
    bool done = cr_json_add(root, true, out);
    cr_str_add(out, "\n");
    return code != CR_ERR_OK ? code
           : done            ? CR_ERR_OK
                             : cr_err_set(err, CR_ERR_MEMORY, "no memory");
}

enum cr_err cr_field_csv(const struct cr_field_table *field, struct cr_str *out,
                         struct cr_error *err) {
    cr_str_add(out, "case,line,kind,type,face,recorder_kmh,damage_kmh,winsmash_kmh\n");
    for (int i = 0; i < field->n; i++) {
        const struct cr_field_row *r = &field->row[i];
        cr_str_csv(out, r->name);
        cr_str_addf(out, ",%d,%s,%s,%s,%.4g,%.4g,", r->line, cr_field_kind_word(r->kind),
                    cr_type_word(r->what.car[0].p->type), cr_face_word(r->what.car[0].m.face),
                    cr_kmh(r->measured), cr_kmh(r->value));
        if (!isnan(r->winsmash)) {
            cr_str_addf(out, "%.4g", cr_kmh(r->winsmash));
        }
        cr_str_add(out, "\n");
    }
    return out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the table") : CR_ERR_OK;
}
