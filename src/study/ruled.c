/* Adds what rules assume of the vehicles of a scene to the inputs of a study: each is drawn about
 * its rule in the scene that is solved, so that it follows a mass or a length that is drawn too. */
#include "study/study.h"

#include "base/stats.h"
#include "scene/keys.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *key, *factor;
} ruled[CR_RULED] = {
#define X(name, key, factor) {key, factor},
    CR_RULED_LIST(X)
#undef X
};

/* from half to twice the rule's value: farther out there are no cars */
static const double least = 0.5, most = 2;

/* standard deviation of the logarithm of what was assumed; 0 where none is known */
static double log_sd(const struct cr_scene *full, const struct cr_assumed *assumed, int part,
                     enum cr_ruled what, const struct cr_scatter *scatter) {
    const struct cr_participant *p = &full->part[part];
    char key[sizeof *assumed->key];
    if (what == CR_RULED_MASS) {
        return assumed->mass_spread[part];
    }
    snprintf(key, sizeof key, "%s.%s", p->id, ruled[what].key);
    for (int i = 0; i < assumed->n; i++) {
        if (strcmp(assumed->key[i], key) == 0 && assumed->from[i][0] == '\0') {
            return scatter->off_rule[what][p->type];
        }
    }
    return 0;
}

static enum cr_err add(struct cr_study *study, const struct cr_participant *p, int part,
                       enum cr_ruled what, double sd, struct cr_error *err) {
    const struct cr_key *row =
        cr_scene_key_find(CR_KEYS_PARTICIPANT, ruled[what].key, CR_FOR_VEHICLE);
    const struct cr_unit *unit = cr_scene_key_unit(row);
    double si = *(const double *)(const void *)((const char *)p + row->at);
    if (study->n == CR_STUDY_INPUTS) {
        return cr_err_set(err, CR_ERR_RANGE, "more than %d inputs vary", CR_STUDY_INPUTS);
    }
    struct cr_study_input *in = &study->in[study->n++];
    *in = (struct cr_study_input){.unit = cr_unit_find("", CR_DIM_NUMBER),
                                  .value = 1,
                                  .half = CR_Z_95 * sd,
                                  .lo = least,
                                  .hi = most,
                                  .factor = true,
                                  .assumed = cr_unit_from_si(unit, si),
                                  .of_unit = unit,
                                  .part = part,
                                  .what = what};
    snprintf(in->key, sizeof in->key, "%s.%s", p->id, ruled[what].factor);
    snprintf(in->of, sizeof in->of, "%s.%s", p->id, ruled[what].key);
    return CR_ERR_OK;
}

enum cr_err cr_study_add_ruled(struct cr_study *study, const struct cr_scatter *scatter,
                               const struct cr_model_lib *lib, struct cr_error *err) {
    struct cr_scene full;
    struct cr_assumed assumed = {0};
    double value[CR_STUDY_INPUTS];
    for (int i = 0; i < study->n; i++) {
        value[i] = study->in[i].value;
    }
    enum cr_err code = study->make(study, value, &full, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_scene_resolve(&full, lib, &assumed, err);
    for (int p = 0; p < full.n; p++) {
        for (int what = 0; what < CR_RULED && code == CR_ERR_OK; what++) {
            double sd = log_sd(&full, &assumed, p, (enum cr_ruled)what, scatter);
            code = sd > 0 ? add(study, &full.part[p], p, (enum cr_ruled)what, sd, err) : code;
        }
    }
    cr_assumed_fini(&assumed);
    cr_scene_fini(&full);
    return code;
}
