/* Makes participants of the vehicles and objects of OpenSCENARIO, with sizes, axles and mass. */
#include "import/xosc_priv.h"

#include "base/grow.h"

#include <math.h>
#include <string.h>

struct cr_xosc_entity *cr_xosc_find(struct cr_xosc *x, const char *name) {
    for (int i = 0; i < x->n; i++) {
        if (strcmp(x->entity[i].name, name) == 0) {
            return &x->entity[i];
        }
    }
    return NULL;
}

struct box {
    double x, y, length, width, height;
};

static enum cr_err read_box(struct cr_xosc *x, const struct cr_xml_node *thing, struct box *box,
                            struct cr_error *err) {
    const struct cr_xml_node *b = cr_xml_find(thing, "BoundingBox");
    const struct cr_xml_node *centre = cr_xml_find(b, "Center"),
                             *dim = cr_xml_find(b, "Dimensions");
    if (b == NULL || centre == NULL || dim == NULL) {
        return cr_xml_fault(x->shown, b != NULL ? b : thing, err, CR_ERR_MISSING, "no <%s>",
                            b == NULL        ? "BoundingBox"
                            : centre == NULL ? "Center"
                                             : "Dimensions");
    }
    enum cr_err code = cr_xosc_number(x, centre, "x", NAN, &box->x, err);
    code = code == CR_ERR_OK ? cr_xosc_number(x, centre, "y", 0, &box->y, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_number(x, dim, "length", NAN, &box->length, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_number(x, dim, "width", NAN, &box->width, err) : code;
    return code == CR_ERR_OK ? cr_xosc_number(x, dim, "height", NAN, &box->height, err) : code;
}

/* Rounds a length to 0.01 mm, which takes away what sums of decimal numbers leave. */
static double tidy(double m) {
    return round(m * 1e5) / 1e5;
}

static enum cr_err axles(struct cr_xosc *x, const struct cr_xml_node *vehicle,
                         const struct box *box, struct cr_xosc_entity *e, struct cr_error *err) {
    const struct cr_xml_node *front = cr_xml_find(vehicle, "Axles/FrontAxle");
    const struct cr_xml_node *rear = cr_xml_find(vehicle, "Axles/RearAxle");
    double front_x = NAN, track;
    if (front == NULL || rear == NULL) {
        return cr_xml_fault(x->shown, vehicle, err, CR_ERR_MISSING, "no <Axles> with <%s>",
                            front == NULL ? "FrontAxle" : "RearAxle");
    }
    enum cr_err code = cr_xosc_number(x, front, "positionX", NAN, &front_x, err);
    code = code == CR_ERR_OK ? cr_xosc_number(x, rear, "positionX", 0, &e->rear_x, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_number(x, front, "trackWidth", NAN, &track, err) : code;
    if (code == CR_ERR_OK) {
        e->p->wheelbase = tidy(front_x - e->rear_x);
        e->p->track = track;
        e->p->front_overhang = tidy(box->x + box->length / 2 - front_x);
    }
    return code;
}

static enum cr_err add(struct cr_xosc *x, const struct cr_xml_node *node, enum cr_kind kind,
                       struct cr_xosc_entity *e, struct cr_error *err) {
    enum cr_err code = cr_import_add(x->im, e->name, kind, &e->p, err);
    if (code != CR_ERR_OK) {
        cr_err_place(err, x->shown, node->line, 0);
    }
    return code;
}

static enum cr_err add_vehicle(struct cr_xosc *x, const struct cr_xml_node *v,
                               struct cr_xosc_entity *e, struct cr_error *err) {
    const char *category;
    struct box box;
    double mass = NAN;
    enum cr_err code = cr_xosc_text(x, v, "vehicleCategory", "car", &category, err);
    if (code == CR_ERR_OK && strcmp(category, "car") != 0 && strcmp(category, "van") != 0) {
        cr_import_note(x->im, "%.40s left out: %.20s", e->name, category);
        return CR_ERR_OK;
    }
    code = code == CR_ERR_OK ? read_box(x, v, &box, err) : code;
    if (code == CR_ERR_OK && cr_xml_attr(v, "mass") != NULL) {
        code = cr_xosc_number(x, v, "mass", NAN, &mass, err);
    }
    code = code == CR_ERR_OK ? add(x, v, CR_KIND_VEHICLE, e, err) : code;
    if (code == CR_ERR_OK) {
        e->p->length = box.length;
        e->p->width = box.width;
        e->p->height = box.height;
        e->p->mass = mass;
        code = axles(x, v, &box, e, err);
    }
    return code;
}

static enum cr_err add_object(struct cr_xosc *x, const struct cr_xml_node *o,
                              struct cr_xosc_entity *e, struct cr_error *err) {
    static const char *const poles[] = {"pole", "tree", "streetLamp", NULL};
    static const char *const boxes[] = {"barrier",      "building",      "obstacle", "railing",
                                        "soundBarrier", "trafficIsland", NULL};
    const char *category;
    struct box box;
    double mass = 0;
    enum cr_err code = cr_xosc_text(x, o, "miscObjectCategory", "none", &category, err);
    if (code == CR_ERR_OK && !cr_xosc_is_one_of(category, poles) &&
        !cr_xosc_is_one_of(category, boxes)) {
        cr_import_note(x->im, "%.40s left out: %.20s", e->name, category);
        return CR_ERR_OK;
    }
    code = code == CR_ERR_OK ? read_box(x, o, &box, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_number(x, o, "mass", 0, &mass, err) : code;
    code = code == CR_ERR_OK ? add(x, o, CR_KIND_OBJECT, e, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    e->centre = cr_vec2(box.x, box.y);
    if (cr_xosc_is_one_of(category, poles)) {
        e->p->shape = CR_OBJECT_POLE;
        e->p->radius = fmax(box.length, box.width) / 2;
    } else {
        e->p->shape = CR_OBJECT_BOX;
        e->p->length = box.length;
        e->p->width = box.width;
    }
    if (strcmp(category, "obstacle") == 0 && mass > 0) {
        e->p->mass = mass; /* Others are fixed to the ground, whatever their mass. */
    }
    return CR_ERR_OK;
}

static enum cr_err add_entity(struct cr_xosc *x, const struct cr_xml_node *object,
                              struct cr_error *err) {
    const struct cr_xml_node *thing = object->child;
    const char *shown = x->shown;
    int scope = x->scope.n;
    if (!cr_grow(&x->entity, &x->size, x->n, sizeof *x->entity)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for an entity");
    }
    struct cr_xosc_entity *e = &x->entity[x->n];
    *e = (struct cr_xosc_entity){.name = NULL};
    enum cr_err code = cr_xosc_text(x, object, "name", NULL, &e->name, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    x->n++;
    if (thing != NULL && strcmp(thing->name, "CatalogReference") == 0) {
        code = cr_xosc_entry(x, thing, &thing, err);
    } else if (thing != NULL) {
        code = cr_xosc_enter(x, thing, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    if (thing != NULL && strcmp(thing->name, "Vehicle") == 0) {
        code = add_vehicle(x, thing, e, err);
    } else if (thing != NULL && strcmp(thing->name, "MiscObject") == 0) {
        code = add_object(x, thing, e, err);
    } else {
        cr_import_note(x->im, "%.40s left out: %.20s", e->name,
                       thing != NULL ? thing->name : "nothing");
    }
    x->shown = shown;
    cr_xosc_leave(x, scope);
    return code;
}

enum cr_err cr_xosc_entities(struct cr_xosc *x, struct cr_error *err) {
    const struct cr_xml_node *list = cr_xml_find(x->root, "Entities"), *o = NULL;
    enum cr_err code = CR_ERR_OK;
    if (list == NULL) {
        return cr_xml_fault(x->shown, x->root, err, CR_ERR_MISSING, "no <Entities>");
    }
    while (code == CR_ERR_OK && (o = cr_xml_next(list, o, "ScenarioObject")) != NULL) {
        code = add_entity(x, o, err);
    }
    return code;
}
