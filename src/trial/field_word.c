/* `crumple validate field`, and `crumple calibrate-damage`, which fits the rules of damage to the
 * recorders of real crashes, with all of them and without each fold. */
#include "trial/field.h"
#include "trial/trial.h"
#include "trial/verdict.h"

#include "process/signals.h"
#include "cli/cli.h"
#include "cli/word.h"

#include <stdio.h>
#include <string.h>

static const char about[] =
    "Fits threshold and level of the energies of front, side and rear to the event data\n"
    "recorders of TABLE (the shipped one), for all and for each of five folds of cases, and\n"
    "prints the calibration file that crumple damage reads. A minute; after the models changed.\n";

/* A table of real crashes with all that it is evaluated by. */
struct opened {
    char rules_path[4200];
    struct cr_crush_rules rules;
    struct cr_cli_shared shared;
    struct cr_field_table field;
};

/* Opens a table, NULL: the shipped one. The caller closes it also after an error. */
static enum cr_err open_table(const char *path, struct opened *o, struct cr_error *err) {
    char table[4200], filter_path[4200];
    struct cr_field_filter filter;
    *o = (struct opened){.field = {0}};
    enum cr_err code =
        cr_cli_data("damage/calibration.json", o->rules_path, sizeof o->rules_path, err);
    if (code == CR_ERR_OK) {
        code = cr_crush_rules_read(o->rules_path, &o->rules, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_data("validation/field/crush_edr.csv", table, sizeof table, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_data("validation/field/filter.csv", filter_path, sizeof filter_path, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_field_filter_read(filter_path, &filter, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_open(&o->shared, CR_CLI_ALL, err);
    }
    if (code == CR_ERR_OK) {
        code =
            cr_field_load(path != NULL ? path : table, &filter, o->shared.models, &o->field, err);
    }
    return code;
}

static void close_table(struct opened *o) {
    cr_field_fini(&o->field);
    cr_cli_close(&o->shared);
}

static enum cr_err write_form(const struct cr_field_table *field, const struct cr_field_task *task,
                              const struct cr_field_form *form, const struct cr_crush_rules *rules,
                              struct cr_str *out, struct cr_error *err) {
    return task->format == 1   ? cr_field_json(field, form, rules, out, err)
           : task->format == 2 ? cr_field_csv(field, out, err)
                               : cr_field_text(field, form, rules, out, err);
}

/* The targets are of the shipped crashes; of partners that were not measured nothing is wanted. */
static enum cr_err judge(const struct opened *o, const struct cr_field_task *task,
                         struct cr_verdict *verdict, bool *missed, struct cr_error *err) {
    if (task->path != NULL || task->guess) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_field_targets(&o->field, verdict, err);
    for (int i = 0; i < verdict->targets; i++) {
        *missed = *missed || !verdict->target[i].met;
    }
    return code;
}

enum cr_err cr_field_validate(const struct cr_field_task *task, struct cr_str *out, bool *missed,
                              struct cr_error *err) {
    struct opened o;
    struct cr_crush_rules folds[CR_FIELD_FOLDS];
    struct cr_verdict verdict = {0};
    bool shipped = task->path == NULL;
    const struct cr_crush_rules *by = shipped ? folds : &o.rules;
    enum cr_err code = open_table(task->path, &o, err);
    if (code == CR_ERR_OK && shipped) {
        code = cr_field_folds_read(o.rules_path, folds, err);
    }
    if (code == CR_ERR_OK) {
        cr_field_evaluate(&o.field, by, shipped, task->guess);
        if (!task->guess) {
            cr_field_spread(&o.field, by, shipped);
        }
        code = judge(&o, task, &verdict, missed, err);
    }
    if (code == CR_ERR_OK) {
        const struct cr_field_form form = {.cases = task->cases,
                                           .plot = task->plot,
                                           .guess = task->guess,
                                           .crossed = shipped,
                                           .title = shipped ? "NHTSA CISS" : task->path,
                                           .targets = &verdict};
        code = write_form(&o.field, task, &form, &o.rules, out, err);
    }
    if (code == CR_ERR_OK && task->picture != NULL) {
        code = cr_field_picture(&o.field, task->picture, err);
    }
    cr_verdict_fini(&verdict);
    close_table(&o);
    return code;
}

static enum cr_err fit_all(struct cr_field_table *field, struct cr_crush_rules *rules,
                           struct cr_crush_rules folds[CR_FIELD_FOLDS], struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    static const struct cr_crush_rules begin = {
        .rise = {0.12, 0.03, 0.15}, .level = {1.3, 0.9, 0.9}, .oblique = 0.7};
    /* The search always begins here, so that its end does not hang on the file of the last one. */
    memcpy(rules->rise, begin.rise, sizeof begin.rise);
    memcpy(rules->level, begin.level, sizeof begin.level);
    rules->oblique = begin.oblique;
    for (int turn = 0; turn < 2 && code == CR_ERR_OK; turn++) {
        code = cr_field_fit(field, -1, rules, err); /* The second turn goes on from the first. */
    }
    for (int k = 0; k < CR_FIELD_FOLDS && code == CR_ERR_OK; k++) {
        folds[k] = *rules;
        code = cr_field_fit(field, k, &folds[k], err);
        if (code == CR_ERR_OK && cr_cli_cancelled(NULL)) {
            code = cr_err_set(err, CR_ERR_INTERRUPTED, "interrupted");
        }
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_field_evaluate(field, folds, true, false);
    cr_field_scatter(field, rules);
    cr_field_partners(field, -1, rules);
    for (int k = 0; k < CR_FIELD_FOLDS; k++) {
        cr_field_partners(field, k, &folds[k]);
        memcpy(folds[k].log_sd, rules->log_sd, sizeof rules->log_sd);
    }
    return CR_ERR_OK;
}

static enum cr_err calibrate(const char *table, struct cr_str *out, struct cr_error *err) {
    struct opened o;
    struct cr_crush_rules folds[CR_FIELD_FOLDS];
    enum cr_err code = open_table(table, &o, err);
    cr_signals_catch_word();
    if (code == CR_ERR_OK) {
        code = fit_all(&o.field, &o.rules, folds, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_field_write(&o.rules, folds, &o.field, out, err);
    }
    close_table(&o);
    return code;
}

int cr_trial_calibrate_damage(int argc, char **argv) {
    const char *path = NULL;
    const struct cr_option table[] = {CR_CLI_OUTPUT_OPTION(&path)};
    const struct cr_usage usage = {.word = "calibrate-damage",
                                   .operands = "[TABLE.csv]",
                                   .about = about,
                                   .option = table,
                                   .options = 1,
                                   .least = 0,
                                   .most = 1};
    struct cr_error err = {0};
    struct cr_str out = {0};
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    enum cr_err code = calibrate(operands > 0 ? argv[1] : NULL, &out, &err);
    if (code == CR_ERR_OK) {
        code = cr_cli_emit(path, &out, &err);
    }
    cr_str_fini(&out);
    return code == CR_ERR_OK ? 0 : cr_cli_fail(&err);
}
