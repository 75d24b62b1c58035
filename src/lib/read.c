/* Reads values off a result of the library: JSON, values by name, time series, voxels. */
#include "lib/lib_priv.h"

#include "base/str.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

char *crumple_json(const crumple_result *result, unsigned flags, size_t *length) {
    const struct cr_result_opts opts = {.trace = (flags & CRUMPLE_TRACE) != 0,
                                        .resolved = (flags & CRUMPLE_RESOLVED) != 0,
                                        .pretty = (flags & CRUMPLE_PRETTY) != 0};
    struct cr_str text = {0};
    locale_t callers = uselocale(result->lib->c_locale);
    enum cr_err code = cr_result_json(result->result, &opts, &text, NULL);
    uselocale(callers);
    return cr_lib_text(code, &text, length);
}

void crumple_free(void *text) {
    free(text);
}

const char *crumple_name(const crumple_result *result, size_t i) {
    return i < (size_t)result->values ? result->value[i].name : NULL;
}

static const struct cr_named *find(const crumple_result *r, const char *name) {
    size_t len = strlen(name);
    for (int i = 0; i < r->values; i++) {
        if (strcmp(r->value[i].name, name) == 0) {
            return &r->value[i];
        }
    }
    for (int i = 0; i < r->values; i++) {
        if (cr_names_is_short(r->value[i].name, name, len)) {
            return &r->value[i];
        }
    }
    return NULL;
}

int crumple_value(const crumple_result *result, const char *name, double *out) {
    const struct cr_named *value = find(result, name);
    *out = (double)NAN;
    if (value == NULL || value->text != NULL) {
        return CRUMPLE_NAME;
    }
    *out = value->number;
    return CRUMPLE_OK;
}

const char *crumple_word(const crumple_result *result, const char *name) {
    const struct cr_named *value = find(result, name);
    return value != NULL ? value->text : NULL;
}

/* Index of the participant of an id of len bytes; -1: none. */
static int participant(const struct cr_result *r, const char *id, size_t len) {
    for (int i = 0; i < r->solution->bodies; i++) {
        const char *own = r->resolved.part[i].id;
        if (strlen(own) == len && memcmp(own, id, len) == 0) {
            return i;
        }
    }
    return -1;
}

static int quantity(const char *name) {
    for (int i = 0; i < CR_QUANTITIES; i++) {
        if (strcmp(cr_quantity_key((enum cr_quantity)i), name) == 0) {
            return i;
        }
    }
    return -1;
}

size_t crumple_series(const crumple_result *result, const char *name, double *out, size_t size) {
    const struct cr_solution *sol = result->result->solution;
    size_t n = (size_t)sol->samples, dot = strcspn(name, ".");
    bool time = strcmp(name, "t_s") == 0;
    int body = time ? 0 : participant(result->result, name, dot);
    int which = time || name[dot] == '\0' ? 0 : quantity(name + dot + 1);
    if (body < 0 || which < 0 || (!time && name[dot] == '\0')) {
        return 0;
    }
    for (size_t i = 0; i < n && i < size; i++) {
        out[i] = time ? sol->t[i] : cr_result_quantity(sol, (int)i, body, (enum cr_quantity)which);
    }
    return n;
}

static double voxel(const struct cr_grid *g, const struct cr_outcome *o, int kind, size_t i) {
    double damage = g->fill[i] > 0 ? 1 - o->left[i] / g->fill[i] : 0;
    switch (kind) {
    case CRUMPLE_FIELD_MATERIAL:
        return g->fill[i];
    case CRUMPLE_FIELD_DAMAGE:
        return damage;
    case CRUMPLE_FIELD_ENERGY:
        return g->energy[i];
    case CRUMPLE_FIELD_ABSORBED:
        return damage * g->energy[i];
    default:
        return (double)o->t_crushed[i];
    }
}

static bool fill_ees(const struct cr_grid *g, double mass, float *out, size_t size) {
    size_t n = (size_t)g->nx * (size_t)g->ny;
    double *ees = malloc(n * sizeof *ees);
    if (ees == NULL) {
        return false;
    }
    cr_result_ees(g, mass, ees);
    for (size_t i = 0; i < n && i < size; i++) {
        out[i] = (float)ees[i];
    }
    free(ees);
    return true;
}

size_t crumple_field(const crumple_result *result, const char *id, int kind, float *out,
                     size_t size, int dims[3], double frame[6]) {
    const struct cr_result *r = result->result;
    int body = participant(r, id, strlen(id));
    if (body < 0 || kind < CRUMPLE_FIELD_MATERIAL || kind > CRUMPLE_FIELD_TIME) {
        return 0;
    }
    const struct cr_grid *g = cr_result_grid(r, body);
    double mass = cr_result_mass(r, body);
    const struct cr_outcome *o = &r->solution->body[body];
    size_t n = (size_t)g->nx * (size_t)g->ny;
    if (n == 0 || o->left == NULL || (kind == CRUMPLE_FIELD_EES && !(mass > 0))) {
        return 0;
    }
    const int counts[3] = {g->nx, g->ny, 1};
    const double place[6] = {g->x0, g->y0, g->h, o->after.pos.x, o->after.pos.y, o->after.heading};
    memcpy(dims, counts, sizeof counts);
    memcpy(frame, place, sizeof place);
    if (kind == CRUMPLE_FIELD_EES) {
        return size == 0 || fill_ees(g, mass, out, size) ? n : 0;
    }
    for (size_t i = 0; i < n && i < size; i++) {
        out[i] = (float)voxel(g, o, kind, i);
    }
    return n;
}
