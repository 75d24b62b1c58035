/* The numbers of a result by name: the one table of what is measured of a participant. */
#include "result/measures.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define OF(field) offsetof(struct cr_severity, field)

/* The measures stand in the order of the result file; `name` is the key without its unit. */
static const struct cr_measure measures[] = {
    {"ees", "EES", "ees_kmh", CR_DIM_SPEED, "km/h", 1, OF(ees)},
    {"energy", "deformation energy", "energy_kJ", CR_DIM_ENERGY, "kJ", 1, OF(energy)},
    {"energy_induced", "induced energy", "energy_induced_kJ", CR_DIM_ENERGY, "kJ", 1,
     OF(energy_induced)},
    {"delta_v", "delta-v", "delta_v_kmh", CR_DIM_SPEED, "km/h", 1, OF(delta_v)},
    {"delta_v_forward", "delta-v forward", "delta_v_forward_kmh", CR_DIM_SPEED, "km/h", 1,
     OF(delta_v_body.x)},
    {"delta_v_left", "delta-v left", "delta_v_left_kmh", CR_DIM_SPEED, "km/h", 1,
     OF(delta_v_body.y)},
    {"delta_v_x", "delta-v east", "delta_v_x_kmh", CR_DIM_SPEED, "km/h", 1, OF(delta_v_world.x)},
    {"delta_v_y", "delta-v north", "delta_v_y_kmh", CR_DIM_SPEED, "km/h", 1, OF(delta_v_world.y)},
    {"pdof", "direction of force (PDOF)", "pdof_deg", CR_DIM_ANGLE, "deg", 0, OF(pdof)},
    {"yaw_rate_change", "yaw rate change", "yaw_rate_change_deg_s", CR_DIM_YAW_RATE, "deg/s", 1,
     OF(yaw_rate_change)},
    {"speed_after", "speed after", "speed_after_kmh", CR_DIM_SPEED, "km/h", 1, OF(speed_after)},
    {"course_after", "course after", "course_after_deg", CR_DIM_ANGLE, "deg", 0, OF(course_after)},
    {"yaw_rate_after", "yaw rate after", "yaw_rate_after_deg_s", CR_DIM_YAW_RATE, "deg/s", 1,
     OF(yaw_rate_after)},
    {"deformation_max", "depth residual, max", "deformation_max_m", CR_DIM_LENGTH, "m", 2,
     OF(deformation_max)},
    {"deformation_dynamic_max", "depth dynamic, max", "deformation_dynamic_max_m", CR_DIM_LENGTH,
     "m", 2, OF(deformation_dynamic_max)},
    {"deformation_area", "damaged area", "deformation_area_m2", CR_DIM_AREA, "m2", 2,
     OF(deformation_area)},
    {"acceleration_max", "peak acceleration", "acceleration_max_g", CR_DIM_ACCELERATION, "g", 1,
     OF(acceleration_max)},
    {"acceleration_mean", "mean acceleration", "acceleration_mean_g", CR_DIM_ACCELERATION, "g", 1,
     OF(acceleration_mean)},
    {"pulse", "length of the pulse", "pulse_ms", CR_DIM_TIME, "ms", 0, OF(pulse)},
    {"olc", "OLC", "olc_g", CR_DIM_ACCELERATION, "g", 1, OF(olc)},
    {"asi", "ASI", "asi", CR_DIM_NUMBER, "", 2, OF(asi)},
    {"thiv", "THIV", "thiv_kmh", CR_DIM_SPEED, "km/h", 1, OF(thiv)},
};
enum { MEASURES = sizeof measures / sizeof measures[0] };

/* Short words that people type for them. */
static const struct {
    const char *word, *name;
} aliases[] = {
    {"dv", "delta_v"},
    {"depth", "deformation_max"},
    {"a_max", "acceleration_max"},
    {"a_mean", "acceleration_mean"},
    {"area", "deformation_area"},
};

const struct cr_measure *cr_measures(int *n) {
    *n = MEASURES;
    return measures;
}

const struct cr_measure *cr_measure_find(const char *name) {
    for (size_t i = 0; i < sizeof aliases / sizeof aliases[0]; i++) {
        name = strcmp(aliases[i].word, name) == 0 ? aliases[i].name : name;
    }
    for (int i = 0; i < MEASURES; i++) {
        if (strcmp(measures[i].name, name) == 0 || strcmp(measures[i].key, name) == 0) {
            return &measures[i];
        }
    }
    return NULL;
}

double cr_measure_get(const struct cr_measure *m, const struct cr_severity *severity) {
    double x;
    memcpy(&x, (const char *)severity + m->at, sizeof x);
    return x;
}

void cr_measure_set(const struct cr_measure *m, struct cr_severity *severity, double si) {
    memcpy((char *)severity + m->at, &si, sizeof si);
}

void cr_measures_clear(struct cr_severity *severity) {
    const double none = NAN;
    for (int i = 0; i < MEASURES; i++) {
        cr_measure_set(&measures[i], severity, none);
    }
    severity->t_max = severity->area_induced = severity->vpi = severity->phd = none;
}

const struct cr_unit *cr_measure_unit(const struct cr_measure *m) {
    return cr_unit_find(m->unit, m->dim);
}

double cr_measure_shown(const struct cr_measure *m, const struct cr_severity *severity) {
    const struct cr_unit *unit = cr_measure_unit(m);
    return cr_measure_get(m, severity) * unit->div / unit->mul;
}

const char *cr_measure_in(const struct cr_measure *m, enum cr_units units, double *x,
                          int *decimals) {
    if (decimals != NULL) {
        *decimals = m->decimals;
    }
    /* All lengths among the measures are depths, which are shown in a unit of their own. */
    return cr_units_shown(units, m->dim == CR_DIM_LENGTH ? CR_SHOWN_DEPTH : m->unit, x, decimals);
}

const char *cr_measure_text(const struct cr_measure *m, double shown, char *buf, int size) {
    bool bearing = strcmp(m->name, "pdof") == 0;
    snprintf(buf, (size_t)size, "%.*f", m->decimals,
             bearing ? cr_bearing_deg(cr_rad(shown)) : shown);
    /* What rounds to zero loses its sign. */
    if (buf[0] == '-' && strspn(buf + 1, "0.") == strlen(buf + 1)) {
        memmove(buf, buf + 1, strlen(buf));
    }
    return buf;
}
