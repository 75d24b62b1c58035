/* Reads CommonRoad scenarios (XML, 2018b and 2020a): rectangles that move in time steps. Places
 * are those of the middle of the rectangle. */
#include "import/xml.h"

#include "base/csv.h"
#include "base/grow.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct moving {
    struct cr_participant *p;
    const struct cr_xml_node *node;  /* of the obstacle */
    const struct cr_xml_node *state; /* the next one */
    double next;                     /* time step of that state */
    bool parked;
    struct cr_waypoint last;
};

struct road {
    struct cr_import *im;
    const char *shown;
    const struct cr_xml_node *root;
    double step; /* s from one time step to the next */
    struct moving *car;
    int n, size;
    bool intervals;
};

bool cr_import_commonroad_is(const struct cr_import_head *head) {
    return cr_xml_is(head, "commonRoad");
}

/* Reads a value that is exact or an interval, of which the middle is taken. Errors: MISSING,
 * TYPE. */
static enum cr_err value(struct road *r, const struct cr_xml_node *node, const char *path,
                         double *out, struct cr_error *err) {
    const struct cr_xml_node *at = cr_xml_find(node, path);
    const struct cr_xml_node *exact = at != NULL ? cr_xml_find(at, "exact") : NULL;
    const struct cr_xml_node *from = at != NULL ? cr_xml_find(at, "intervalStart") : NULL;
    const struct cr_xml_node *to = at != NULL ? cr_xml_find(at, "intervalEnd") : NULL;
    double a, b;
    if (at == NULL) {
        return cr_xml_fault(r->shown, node, err, CR_ERR_MISSING, "no <%s>", path);
    }
    if (exact == NULL && at->child == NULL) {
        exact = at; /* Lengths and coordinates stand there without <exact>. */
    }
    if (exact != NULL ? cr_csv_scan(exact->text, false, out)
                      : from != NULL && to != NULL && cr_csv_scan(from->text, false, &a) &&
                            cr_csv_scan(to->text, false, &b)) {
        *out = exact != NULL ? *out : (a + b) / 2;
        r->intervals = r->intervals || exact == NULL;
        return CR_ERR_OK;
    }
    return cr_xml_fault(r->shown, at, err, CR_ERR_TYPE,
                        "neither a number nor an interval: \"%.60s\"",
                        exact != NULL ? exact->text : "");
}

static enum cr_err pose(struct road *r, const struct cr_xml_node *state, struct cr_waypoint *out,
                        struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    const struct cr_xml_node *position = cr_xml_find(state, "position");
    if (position == NULL || cr_xml_find(position, "point") == NULL) {
        cr_xml_fault(r->shown, position != NULL ? position : state, err, CR_ERR_MISSING,
                     "no <position> with a <point>");
        cr_err_hint(err, "places that are areas of uncertainty have no one pose to start from");
        return CR_ERR_MISSING;
    }
    code = value(r, cr_xml_find(position, "point"), "x", &out->pos.x, err);
    code =
        code == CR_ERR_OK ? value(r, cr_xml_find(position, "point"), "y", &out->pos.y, err) : code;
    return code == CR_ERR_OK ? value(r, state, "orientation", &out->heading, err) : code;
}

/* ---- obstacles ---- */

static bool one_of(const char *word, const char *list) {
    const char *at = *word != '\0' ? strstr(list, word) : NULL;
    size_t n = strlen(word);
    return at != NULL && (at == list || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0');
}

static enum cr_err sizes(struct road *r, const struct cr_xml_node *obstacle,
                         struct cr_participant *p, struct cr_error *err) {
    const struct cr_xml_node *rect = cr_xml_find(obstacle, "shape/rectangle");
    if (rect == NULL) {
        return cr_xml_fault(r->shown, obstacle, err, CR_ERR_MISSING,
                            "obstacle %.40s: no <shape> that is a <rectangle>",
                            cr_xml_attr(obstacle, "id"));
    }
    enum cr_err code = value(r, rect, "length", &p->length, err);
    return code == CR_ERR_OK ? value(r, rect, "width", &p->width, err) : code;
}

static enum cr_err add_car(struct road *r, const struct cr_xml_node *obstacle, bool parked,
                           struct cr_error *err) {
    char id[64];
    struct moving m = {.node = obstacle, .parked = parked};
    if (!cr_grow(&r->car, &r->size, r->n, sizeof *r->car)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for an obstacle");
    }
    snprintf(id, sizeof id, "o%.60s", cr_xml_attr(obstacle, "id"));
    m.state = cr_xml_find(obstacle, "initialState");
    if (m.state == NULL) {
        return cr_xml_fault(r->shown, obstacle, err, CR_ERR_MISSING, "no <initialState>");
    }
    if (!parked && cr_xml_find(obstacle, "occupancySet") != NULL) {
        return cr_xml_fault(r->shown, obstacle, err, CR_ERR_TYPE,
                            "obstacle %.40s has sets of occupancy, no motion",
                            cr_xml_attr(obstacle, "id"));
    }
    enum cr_err code = cr_import_add(r->im, id, CR_KIND_VEHICLE, &m.p, err);
    if (code != CR_ERR_OK) {
        cr_err_place(err, r->shown, obstacle->line, 0);
        return code;
    }
    code = sizes(r, obstacle, m.p, err);
    code = code == CR_ERR_OK && parked ? pose(r, m.state, &m.last, err) : code;
    code = code == CR_ERR_OK && !parked ? value(r, m.state, "time", &m.next, err) : code;
    r->car[r->n++] = m;
    return code;
}

/* Adds a pillar or building as a box, or as a pole where it is round. */
static enum cr_err add_object(struct road *r, const struct cr_xml_node *obstacle,
                              struct cr_error *err) {
    char id[64];
    struct cr_participant *p;
    struct cr_waypoint at = {0};
    const struct cr_xml_node *circle = cr_xml_find(obstacle, "shape/circle");
    const struct cr_xml_node *state = cr_xml_find(obstacle, "initialState");
    snprintf(id, sizeof id, "o%.60s", cr_xml_attr(obstacle, "id"));
    if (state == NULL) {
        return cr_xml_fault(r->shown, obstacle, err, CR_ERR_MISSING, "no <initialState>");
    }
    enum cr_err code = cr_import_add(r->im, id, CR_KIND_OBJECT, &p, err);
    code = code == CR_ERR_OK ? pose(r, state, &at, err) : code;
    if (code != CR_ERR_OK) {
        cr_err_place(err, r->shown, obstacle->line, 0);
        return code;
    }
    p->pos = at.pos;
    p->heading = at.heading;
    p->shape = circle != NULL ? CR_OBJECT_POLE : CR_OBJECT_BOX;
    return circle != NULL ? value(r, circle, "radius", &p->radius, err)
                          : sizes(r, obstacle, p, err);
}

static enum cr_err add_obstacle(struct road *r, const struct cr_xml_node *o, struct cr_error *err) {
    const struct cr_xml_node *type_node = cr_xml_find(o, "type"), *role = cr_xml_find(o, "role");
    const char *type = type_node != NULL ? type_node->text : "unknown", *id;
    bool still = strcmp(o->name, "staticObstacle") == 0 ||
                 (role != NULL && strcmp(role->text, "static") == 0);
    enum cr_err code = cr_xml_need(r->shown, o, "id", &id, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (one_of(type, still ? "parkedVehicle car taxi" : "car taxi priorityVehicle unknown")) {
        return add_car(r, o, still, err);
    }
    bool round_or_square =
        cr_xml_find(o, "shape/rectangle") != NULL || cr_xml_find(o, "shape/circle") != NULL;
    if (still && round_or_square &&
        one_of(type, "pillar building roadBoundary medianStrip unknown")) {
        return add_object(r, o, err);
    }
    cr_import_note(r->im, "obstacle %.20s left out: %.30s", id, type);
    return CR_ERR_OK;
}

/* ---- motion ---- */

static enum cr_err give_row(struct road *r, struct moving *m, double step, struct cr_error *err) {
    struct cr_waypoint row = m->last;
    const struct cr_xml_node *at = m->parked ? m->node : m->state;
    enum cr_err code = CR_ERR_OK;
    if (!m->parked) {
        code = pose(r, m->state, &row, err);
        code = code == CR_ERR_OK ? value(r, m->state, "velocity", &row.speed, err) : code;
    }
    row.t = step * r->step;
    if (code == CR_ERR_OK && (code = cr_import_row(r->im, m->p, &row, err)) != CR_ERR_OK) {
        cr_err_place(err, r->shown, at->line, 0);
    }
    if (code != CR_ERR_OK || m->parked) {
        return code;
    }
    m->state = strcmp(m->state->name, "initialState") == 0
                   ? cr_xml_find(m->node, "trajectory/state")
                   : cr_xml_next(m->state->parent, m->state, "state");
    return m->state != NULL ? value(r, m->state, "time", &m->next, err) : CR_ERR_OK;
}

/* Gives the rows of all cars, one time step after the other. */
static enum cr_err motion(struct road *r, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    while (code == CR_ERR_OK && !cr_import_met(r->im)) {
        double step = INFINITY;
        for (int i = 0; i < r->n; i++) {
            bool moves = !r->car[i].parked && r->car[i].state != NULL;
            step = moves ? fmin(step, r->car[i].next) : step;
        }
        if (isinf(step)) {
            break;
        }
        for (int i = 0; i < r->n && code == CR_ERR_OK; i++) {
            struct moving *m = &r->car[i];
            if (m->parked || (m->state != NULL && m->next <= step)) {
                code = give_row(r, m, step, err);
            }
        }
    }
    return code;
}

static enum cr_err read_case(struct road *r, struct cr_error *err) {
    enum cr_err code = cr_xml_number(r->shown, r->root, "timeStepSize", &r->step, err);
    if (code == CR_ERR_OK && !(r->step > 0)) {
        code = cr_xml_fault(r->shown, r->root, err, CR_ERR_RANGE, "timeStepSize must be above 0");
    }
    const char *version = cr_xml_attr(r->root, "commonRoadVersion");
    if (version == NULL || !one_of(version, "2018b 2020a")) {
        cr_import_note(r->im, "version \"%.20s\" of CommonRoad is not known: read as 2020a",
                       version != NULL ? version : "");
    }
    cr_import_point(r->im, CR_POINT_CENTRE);
    for (const struct cr_xml_node *o = r->root->child; o != NULL && code == CR_ERR_OK;
         o = o->next) {
        if (one_of(o->name, "dynamicObstacle staticObstacle obstacle")) {
            code = add_obstacle(r, o, err);
        }
    }
    code = code == CR_ERR_OK ? motion(r, err) : code;
    if (r->intervals) {
        cr_import_note(r->im, "the middle of intervals taken");
    }
    return code;
}

enum cr_err cr_import_commonroad_read(struct cr_import *im, struct cr_error *err) {
    struct cr_arena arena = {0};
    struct cr_xml_node *root;
    struct cr_error why;
    struct road r = {.im = im, .shown = im->shown};
    enum cr_err code = cr_xml_load(im->path, im->shown, &arena, &root, err);
    if (code != CR_ERR_OK) {
        goto out;
    }
    if (strcmp(root->name, "commonRoad") != 0) {
        code = cr_xml_fault(im->shown, root, err, CR_ERR_SYNTAX, "no scenario of CommonRoad");
        goto out;
    }
    const char *version = cr_xml_attr(root, "commonRoadVersion");
    const char *name = cr_xml_attr(root, "benchmarkID");
    r.root = root;
    cr_import_format(im, "CommonRoad %.40s", version != NULL ? version : "of no version");
    code = cr_import_begin(im, "", name != NULL ? name : "commonroad", err);
    if (code == CR_ERR_OK) {
        enum cr_err fault = read_case(&r, &why);
        code = cr_import_end(im, fault != CR_ERR_OK ? &why : NULL, err);
    }
out:
    free(r.car);
    cr_arena_free(&arena);
    return code;
}
