/* Reads two outputs of the traffic simulation SUMO: the list of collisions (--collision-output),
 * each with the ends of both cars, and floating car data (--fcd-output), the motion of all.
 *
 * Collisions are written in the first step in which the cars overlap, so both go back along their
 * course for a second; floating car data names the middle of the front bumper, and angles clockwise
 * from north. */
#include "import/xml.h"

#include "base/grow.h"
#include "base/units.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double back = 1.0; /* s before a collision at which its scene begins */
/* The shortest car, m: what is shorter has one track or legs. The shortest real cars have 2.2 m. */
static const double shortest = 2.0;

struct seen {
    char *id;
    struct cr_participant *p;
};

struct sumo {
    struct cr_import *im;
    long collisions;
    bool fcd, persons;
    double t;
    struct seen *seen; /* in the order in which they came */
    int n, size, guess;
    enum cr_err fault; /* of the one case of floating car data */
    struct cr_error why;
};

bool cr_import_sumo_is(const struct cr_import_head *head) {
    return cr_xml_is(head, "collisions") || cr_xml_is(head, "fcd-export");
}

/* ---- collisions ---- */

/* Reads a place, "x,y" or "x,y,z" in m, of an attribute. */
static enum cr_err place(const struct sumo *s, const struct cr_xml_node *node, const char *who,
                         const char *end, struct cr_vec2 *out, struct cr_error *err) {
    char name[32];
    double at[3] = {0};
    const char *text;
    snprintf(name, sizeof name, "%s%s", who, end);
    enum cr_err code = cr_xml_need(s->im->shown, node, name, &text, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    int n = 0;
    const char *behind = text;
    while (n < 3 && (n == 0 || *behind == ',')) {
        const char *p = n == 0 ? text : behind + 1;
        p += strspn(p, " ");
        at[n] = cr_number_scan(p, &behind);
        if (behind == p || !isfinite(at[n++])) {
            n = 0;
            break;
        }
        behind += strspn(behind, " ");
    }
    *out = cr_vec2(at[0], at[1]);
    if (n < 2 || *behind != '\0') {
        return cr_xml_fault(s->im->shown, node, err, CR_ERR_TYPE,
                            "%s is no place \"x,y\": \"%.60s\"", name, text);
    }
    return CR_ERR_OK;
}

static enum cr_err not_a_car(const struct sumo *s, const struct cr_xml_node *node, const char *id,
                             struct cr_error *err) {
    return cr_xml_fault(s->im->shown, node, err, CR_ERR_TYPE,
                        "\"%.60s\" is not a car, and only cars have models", id);
}

static enum cr_err add_car(struct sumo *s, const struct cr_xml_node *node, const char *who,
                           struct cr_error *err) {
    char speed_name[32], type_name[32];
    const char *id, *type;
    struct cr_vec2 front, rear;
    double speed = 0;
    struct cr_participant *p;
    snprintf(speed_name, sizeof speed_name, "%sSpeed", who);
    snprintf(type_name, sizeof type_name, "%sType", who);
    enum cr_err code = cr_xml_need(s->im->shown, node, who, &id, err);
    code = code == CR_ERR_OK ? place(s, node, who, "Front", &front, err) : code;
    code = code == CR_ERR_OK ? place(s, node, who, "Back", &rear, err) : code;
    code = code == CR_ERR_OK ? cr_xml_number(s->im->shown, node, speed_name, &speed, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    type = cr_xml_attr(node, type_name);
    struct cr_vec2 axis = cr_vec2_sub(front, rear);
    double length = cr_vec2_len(axis);
    if (length < shortest ||
        (type != NULL && (strstr(type, "PEDTYPE") != NULL || strstr(type, "BIKETYPE") != NULL))) {
        return not_a_car(s, node, id, err);
    }
    code = cr_import_add(s->im, id, CR_KIND_VEHICLE, &p, err);
    if (code != CR_ERR_OK) {
        cr_err_place(err, s->im->shown, node->line, 0);
        return code;
    }
    p->length = round(length * 1e4) / 1e4; /* SUMO writes centimetres. */
    p->heading = atan2(axis.y, axis.x);
    p->speed = speed;
    p->pos = cr_vec2_scale(cr_vec2_add(front, rear), 0.5);
    p->pos = cr_vec2_axpy(p->pos, -speed * back / length, axis);
    return CR_ERR_OK;
}

static enum cr_err one_collision(struct sumo *s, const struct cr_xml_node *node,
                                 struct cr_error *err) {
    char id[24], name[40];
    const char *time = cr_xml_attr(node, "time"), *type = cr_xml_attr(node, "type");
    struct cr_error why;
    snprintf(id, sizeof id, "%ld", s->collisions);
    snprintf(name, sizeof name, "sumo-%ld", s->collisions++);
    if (!cr_import_wants(s->im, id)) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_import_begin(s->im, id, name, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_import_point(s->im, CR_POINT_CENTRE);
    if (time != NULL) {
        cr_import_note(s->im, "time %.20s s%s%.40s, both from %.3g s before", time,
                       type != NULL ? ", type " : "", type != NULL ? type : "", back);
    }
    enum cr_err fault = add_car(s, node, "collider", &why);
    fault = fault == CR_ERR_OK ? add_car(s, node, "victim", &why) : fault;
    return cr_import_end(s->im, fault != CR_ERR_OK ? &why : NULL, err);
}

/* ---- floating car data ---- */

/* Finds or adds the participant of an id. Most often it is the one after the last, since all steps
 * have the same order; or the one after that, where one has left. */
static enum cr_err lookup(struct sumo *s, const char *id, struct cr_participant **out,
                          struct cr_error *err) {
    for (int k = 0; k < 2 && s->n > 0; k++) {
        s->guess = s->guess + 1 < s->n ? s->guess + 1 : 0;
        if (strcmp(s->seen[s->guess].id, id) == 0) {
            *out = s->seen[s->guess].p;
            return CR_ERR_OK;
        }
    }
    for (int i = 0; i < s->n; i++) {
        if (strcmp(s->seen[i].id, id) == 0) {
            s->guess = i;
            *out = s->seen[i].p;
            return CR_ERR_OK;
        }
    }
    enum cr_err code = cr_import_add(s->im, id, CR_KIND_VEHICLE, out, err);
    char *copy = code == CR_ERR_OK ? strdup(id) : NULL;
    if (code != CR_ERR_OK) {
        return code;
    }
    if (copy == NULL || !cr_grow(&s->seen, &s->size, s->n, sizeof *s->seen)) {
        free(copy);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a vehicle");
    }
    s->guess = s->n;
    s->seen[s->n++] = (struct seen){copy, *out};
    return CR_ERR_OK;
}

static enum cr_err one_row(struct sumo *s, const struct cr_xml_node *node, struct cr_error *err) {
    const char *id, *shown = s->im->shown;
    struct cr_waypoint row = {.t = s->t};
    struct cr_participant *p;
    double angle = 0;
    enum cr_err code = cr_xml_need(shown, node, "id", &id, err);
    code = code == CR_ERR_OK ? cr_xml_number(shown, node, "x", &row.pos.x, err) : code;
    code = code == CR_ERR_OK ? cr_xml_number(shown, node, "y", &row.pos.y, err) : code;
    code = code == CR_ERR_OK ? cr_xml_number(shown, node, "angle", &angle, err) : code;
    code = code == CR_ERR_OK ? cr_xml_number(shown, node, "speed", &row.speed, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    row.heading = cr_rad(90 - angle);
    code = lookup(s, id, &p, err);
    code = code == CR_ERR_OK ? cr_import_row(s->im, p, &row, err) : code;
    if (code != CR_ERR_OK) {
        cr_err_place(err, shown, node->line, 0);
    }
    return code;
}

/* Takes an element of floating car data; what is wrong with it ends the only case, not the file. */
static enum cr_err in_export(struct sumo *s, const struct cr_xml_node *node) {
    if (s->fault != CR_ERR_OK || cr_import_met(s->im)) {
        return CR_ERR_OK;
    }
    if (strcmp(node->name, "timestep") == 0) {
        s->fault = cr_xml_number(s->im->shown, node, "time", &s->t, &s->why);
    } else if (strcmp(node->name, "vehicle") == 0) {
        s->fault = one_row(s, node, &s->why);
    } else if ((strcmp(node->name, "person") == 0 || strcmp(node->name, "container") == 0) &&
               !s->persons) {
        s->persons = true;
        cr_import_note(s->im, "persons left out");
    }
    return CR_ERR_OK;
}

/* ---- the file ---- */

static enum cr_err on_begin(void *user, const struct cr_xml_node *node, struct cr_error *err) {
    struct sumo *s = user;
    if (strcmp(node->name, "fcd-export") == 0 && s->im->at == NULL) {
        s->fcd = true;
        cr_import_format(s->im, "SUMO fcd-output");
        enum cr_err code = cr_import_begin(s->im, "", "sumo", err);
        if (code == CR_ERR_OK) {
            cr_import_point(s->im, CR_POINT_FRONT);
        }
        return code;
    }
    if (s->fcd) {
        return in_export(s, node);
    }
    if (strcmp(node->name, "collision") == 0) {
        return one_collision(s, node, err);
    }
    if (strcmp(node->name, "collisions") != 0) {
        return cr_xml_fault(s->im->shown, node, err, CR_ERR_SYNTAX,
                            "neither collision-output nor fcd-output of SUMO");
    }
    return CR_ERR_OK;
}

enum cr_err cr_import_sumo_read(struct cr_import *im, struct cr_error *err) {
    struct sumo s = {.im = im};
    const struct cr_xml_sax sax = {.user = &s, .begin = on_begin};
    cr_import_format(im, "SUMO collision-output");
    enum cr_err code = cr_xml_stream(im, &sax, err);
    if (code == CR_ERR_OK && s.fcd) {
        code = cr_import_end(im, s.fault != CR_ERR_OK ? &s.why : NULL, err);
    }
    for (int i = 0; i < s.n; i++) {
        free(s.seen[i].id);
    }
    free(s.seen);
    return code;
}
