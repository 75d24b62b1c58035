/* Fits the rules of damage to real crashes: the search of `crumple calibrate-damage`. */
#include "config.h"

#include "trial/field.h"

#include <math.h>

#if HAVE_NLOPT
#include <nlopt.h>

/* The parameters are rise and level of the three ends, and the oblique factor. */
enum { PARAMETERS = 2 * CR_MODEL_ENDS + 1 };
static const double least[PARAMETERS] = {0.01, 0.01, 0.01, 0.2, 0.2, 0.2, 0};
static const double most[PARAMETERS] = {0.35, 0.35, 0.35, 4, 4, 4, 2};

static void unpack(const double *x, struct cr_crush_rules *rules) {
    for (int i = 0; i < CR_MODEL_ENDS; i++) {
        rules->rise[i] = x[i];
        rules->level[i] = x[CR_MODEL_ENDS + i];
    }
    rules->oblique = x[2 * CR_MODEL_ENDS];
}

/* Sums over the rows of one kind and face of the car, without those of a fold. */
struct group {
    double log_sum, log_square, percent, amount;
    int n;
};

static void add_to(struct group *g, double value, double measured) {
    double r = log(value / measured), p = 100 * (value / measured - 1);
    g->n++;
    g->log_sum += r;
    g->log_square += r * r;
    g->percent += p;
    g->amount += fabs(p);
}

/* Loss of a whole kind: mean error, scatter and squared bias, as the aims ask for them. The bias of
 * one end of the car within a kind counts a third of that. */
static double group_loss(const struct group *g, bool whole) {
    if (g->n == 0) {
        return 0;
    }
    double bias = g->percent / g->n;
    if (!whole) {
        return g->n * 0.02 * bias * bias;
    }
    double mean = g->log_sum / g->n;
    double sd = sqrt(fmax(0, g->log_square / g->n - mean * mean));
    return g->amount + g->n * (50 * sd + 0.06 * bias * bias);
}

static double loss(const struct cr_field_table *field, int without) {
    struct group kind[CR_FIELD_KINDS] = {{0}}, part[CR_FIELD_KINDS][CR_MODEL_ENDS] = {{{0}}};
    double sum = 0;
    int n = 0;
    for (int i = 0; i < field->n; i++) {
        const struct cr_field_row *row = &field->row[i];
        if (row->fold == without || !(row->value > 0)) {
            continue;
        }
        enum cr_model_end end = cr_crush_end(row->what.car[0].m.face);
        add_to(&kind[row->kind], row->value, row->measured);
        add_to(&part[row->kind][end], row->value, row->measured);
        n++;
    }
    for (int k = 0; k < CR_FIELD_KINDS; k++) {
        sum += group_loss(&kind[k], true);
        for (int e = 0; e < CR_MODEL_ENDS; e++) {
            sum += group_loss(&part[k][e], false);
        }
    }
    return n > 0 ? sum / n : 0;
}

struct search {
    struct cr_field_table *field;
    struct cr_crush_rules rules;
    int without;
};

static double objective(unsigned n, const double *x, double *gradient, void *user) {
    struct search *s = user;
    (void)n;
    (void)gradient;
    unpack(x, &s->rules);
    cr_field_evaluate(s->field, &s->rules, false, false);
    double sum = loss(s->field, s->without);
    for (int i = 0; i < CR_MODEL_ENDS; i++) {
        /* Threshold and level trade along a flat valley of the loss; its better end is where the
         * recipes' own energy holds. */
        sum += pow(log(s->rules.level[i]), 2);
    }
    return sum;
}

enum cr_err cr_field_fit(struct cr_field_table *field, int without, struct cr_crush_rules *rules,
                         struct cr_error *err) {
    struct search s = {.field = field, .rules = *rules, .without = without};
    double x[PARAMETERS], step[PARAMETERS], value;
    for (int i = 0; i < CR_MODEL_ENDS; i++) {
        x[i] = fmin(fmax(rules->rise[i], least[i]), most[i]);
        x[CR_MODEL_ENDS + i] = rules->level[i];
        step[i] = 0.04;
        step[CR_MODEL_ENDS + i] = 0.2;
    }
    x[2 * CR_MODEL_ENDS] = rules->oblique;
    step[2 * CR_MODEL_ENDS] = 0.3;
    nlopt_opt opt = nlopt_create(NLOPT_LN_SBPLX, PARAMETERS);
    if (opt == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the search");
    }
    nlopt_set_min_objective(opt, objective, &s);
    nlopt_set_lower_bounds(opt, least);
    nlopt_set_upper_bounds(opt, most);
    nlopt_set_initial_step(opt, step);
    nlopt_set_ftol_rel(opt, 1e-6);
    nlopt_set_maxeval(opt, 2000);
    nlopt_result result = nlopt_optimize(opt, x, &value);
    nlopt_destroy(opt);
    if (result < 0 && result != NLOPT_ROUNDOFF_LIMITED) {
        return cr_err_set(err, CR_ERR_SOLVER, "the search of the rules failed (NLopt %d)",
                          (int)result);
    }
    unpack(x, rules);
    return CR_ERR_OK;
}
#else
enum cr_err cr_field_fit(struct cr_field_table *field, int without, struct cr_crush_rules *rules,
                         struct cr_error *err) {
    (void)field, (void)without, (void)rules;
    cr_err_set(err, CR_ERR_USAGE, "this build has no NLopt, which the fit of the rules needs");
    cr_err_hint(err, "install libnlopt-dev, then ./bootstrap build");
    return CR_ERR_USAGE;
}
#endif

/* Sums of a regression of one logarithm by another. */
struct sums {
    double n, x, y, xx, xy, yy;
};

static void add_pair(struct sums *s, double known, double guessed) {
    double scratch = 100; /* J; nothing that is called damage takes less. */
    double x = log(fmax(known, scratch) / cr_crush_known), y = log(fmax(guessed, scratch));
    s->n++;
    s->x += x;
    s->y += y;
    s->xx += x * x;
    s->xy += x * y;
    s->yy += y * y;
}

void cr_field_partners(const struct cr_field_table *field, int without,
                       struct cr_crush_rules *rules) {
    enum { LEAST = 10 }; /* pairs */
    struct sums sums[CR_MODEL_ENDS][CR_MODEL_ENDS] = {{{0}}};
    for (int i = 0; i < field->n; i++) {
        const struct cr_crush_case *what = &field->row[i].what;
        if (what->n != 2 || field->row[i].fold == without) {
            continue;
        }
        struct cr_crush_energy e[2];
        enum cr_model_end end[2];
        for (int k = 0; k < 2; k++) {
            cr_crush_energy(&what->car[k], rules, &e[k]);
            end[k] = cr_crush_end(what->car[k].m.face);
        }
        for (int k = 0; k < 2; k++) {
            add_pair(&sums[end[k]][end[1 - k]], e[k].energy, e[1 - k].energy);
        }
    }
    for (int k = 0; k < CR_MODEL_ENDS * CR_MODEL_ENDS; k++) {
        const struct sums *s = &sums[k / CR_MODEL_ENDS][k % CR_MODEL_ENDS];
        struct cr_crush_partner *p = &rules->partner[k / CR_MODEL_ENDS][k % CR_MODEL_ENDS];
        *p = (struct cr_crush_partner){0};
        if (s->n >= LEAST) {
            double xx = s->xx - s->x * s->x / s->n, xy = s->xy - s->x * s->y / s->n;
            double yy = s->yy - s->y * s->y / s->n;
            p->power = fmax(0, xy / xx);
            p->energy = exp((s->y - p->power * s->x) / s->n);
            p->log_sd = sqrt(fmax(0, yy - p->power * xy) / (s->n - 2));
        }
    }
}

void cr_field_scatter(const struct cr_field_table *field, struct cr_crush_rules *rules) {
    struct cr_field_result r;
    struct cr_error ignored;
    if (cr_field_result(field, -1, -1, &r, &ignored) != CR_ERR_OK || r.own.n < 3) {
        return;
    }
    /* What is left of the scatter without the recorder's is that of the energy, and delta-v goes
     * with the root of the energy. */
    double speed = sqrt(fmax(0, r.own.log_sd * r.own.log_sd - rules->noise * rules->noise));
    for (int i = 0; i < CR_MODEL_ENDS; i++) {
        rules->log_sd[i] = 2 * speed;
    }
}
