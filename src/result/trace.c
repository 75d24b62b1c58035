/* Gives the quantities of a result's time series by name and unit, and the motion at a time. */
#include "result/result.h"

#include "base/elementary.h"

const char *cr_quantity_key(enum cr_quantity quantity) {
    static const char *const keys[CR_QUANTITIES] = {
#define X(name, key, unit, factor) key,
        CR_QUANTITY_LIST(X)
#undef X
    };
    return keys[quantity];
}

static const double factors[CR_QUANTITIES] = {
#define X(name, key, unit, factor) factor,
    CR_QUANTITY_LIST(X)
#undef X
};

const struct cr_sample *cr_result_motion_at(const struct cr_solution *sol, int body, double t) {
    const struct cr_sample *then = &sol->body[body].before;
    for (int i = 0; i < sol->samples && sol->t[i] <= t; i++) {
        then = &sol->trace[(size_t)i * (size_t)sol->bodies + (size_t)body];
    }
    return then;
}

double cr_result_quantity(const struct cr_solution *sol, int sample, int body,
                          enum cr_quantity quantity) {
    const struct cr_sample *s = &sol->trace[(long)sample * sol->bodies + body];
    struct cr_vec2 a = cr_vec2_turn(s->acc, -s->heading);
    const double si[CR_QUANTITIES] = {
        [CR_QUANTITY_X] = s->pos.x,
        [CR_QUANTITY_Y] = s->pos.y,
        [CR_QUANTITY_HEADING] = s->heading,
        [CR_QUANTITY_VX] = s->vel.x,
        [CR_QUANTITY_VY] = s->vel.y,
        [CR_QUANTITY_YAW_RATE] = s->yaw_rate,
        [CR_QUANTITY_AX] = a.x,
        [CR_QUANTITY_AY] = a.y,
        [CR_QUANTITY_YAW_ACC] = s->yaw_acc,
        [CR_QUANTITY_FORCE] = cr_vec2_len(s->force),
        [CR_QUANTITY_ENERGY] = s->energy,
    };
    return si[quantity] * factors[quantity];
}
