/* Reads OpenSCENARIO XML 1.0 to 1.3: vehicles and objects at world positions, with speeds and
 * trajectories. Places are those of the middle of the rear axle. What needs the road or a simulator
 * is refused: esmini runs such a scenario and writes a log that can be imported. */
#include "import/xosc_priv.h"

#include <stdlib.h>
#include <string.h>

bool cr_import_xosc_is(const struct cr_import_head *head) {
    return cr_xml_is(head, "OpenSCENARIO");
}

static void fini(struct cr_xosc *x) {
    for (int i = 0; i < x->n; i++) {
        for (int k = 0; k < x->entity[i].actions; k++) {
            free(x->entity[i].action[k].point);
        }
        free(x->entity[i].action);
    }
    free(x->entity);
    free(x->scope.item);
    cr_xosc_catalogues_free(x);
    cr_arena_free(&x->arena);
}

static enum cr_err read_case(struct cr_xosc *x, struct cr_error *err) {
    cr_import_point(x->im, CR_POINT_REAR_AXLE);
    enum cr_err code = cr_xosc_entities(x, err);
    code = code == CR_ERR_OK ? cr_xosc_story(x, err) : code;
    return code == CR_ERR_OK ? cr_xosc_move(x, err) : code;
}

/* Reads the header and refuses what is of OpenSCENARIO but no scenario of version 1. */
static enum cr_err read_header(struct cr_xosc *x, const struct cr_xml_node **header,
                               struct cr_error *err) {
    const char *major, *minor;
    *header = cr_xml_find(x->root, "FileHeader");
    if (strcmp(x->root->name, "OpenSCENARIO") != 0 || *header == NULL) {
        return cr_xml_fault(x->shown, x->root, err, CR_ERR_MISSING,
                            "no <OpenSCENARIO> with a <FileHeader>");
    }
    enum cr_err code = cr_xml_need(x->shown, *header, "revMajor", &major, err);
    code = code == CR_ERR_OK ? cr_xml_need(x->shown, *header, "revMinor", &minor, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    if (strcmp(major, "1") != 0) {
        return cr_xml_fault(x->shown, *header, err, CR_ERR_TYPE,
                            "OpenSCENARIO %.10s.%.10s, only 1.0 to 1.3 can be read", major, minor);
    }
    if (cr_xml_find(x->root, "Catalog") != NULL ||
        cr_xml_find(x->root, "ParameterValueDistribution") != NULL) {
        return cr_xml_fault(x->shown, x->root, err, CR_ERR_TYPE,
                            "a catalogue or a distribution, which is no scenario by itself");
    }
    cr_import_format(x->im, "OpenSCENARIO %.10s.%.10s", major, minor);
    return CR_ERR_OK;
}

enum cr_err cr_import_xosc_read(struct cr_import *im, struct cr_error *err) {
    struct cr_xosc x = {.im = im, .shown = im->shown};
    const struct cr_xml_node *header;
    struct cr_error why;
    enum cr_err code = cr_xml_load(im->path, im->shown, &x.arena, &x.root, err);
    code = code == CR_ERR_OK ? read_header(&x, &header, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_enter(&x, x.root, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_catalogues(&x, err) : code;
    if (code != CR_ERR_OK) {
        goto out;
    }
    const char *name = cr_xml_attr(header, "description");
    code = cr_import_begin(im, "", name != NULL && name[0] != '\0' ? name : "xosc", err);
    if (code == CR_ERR_OK) {
        enum cr_err fault = read_case(&x, &why);
        code = cr_import_end(im, fault != CR_ERR_OK ? &why : NULL, err);
    }
out:
    fini(&x);
    return code;
}
