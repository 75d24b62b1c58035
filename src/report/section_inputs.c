/* Sections 3 and 4: every input with its origin and tolerance; the method and its settings. */
#include "report/sections.h"

#include "scene/keys.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct cr_assumed *assumed_of(const struct cr_paper *p) {
    return p->s->assumed != NULL ? p->s->assumed : &p->r->assumed;
}

/* The car of the catalogue from which an assumed value comes, "" for one that comes from type and
 * mass; NULL: the value was not assumed. */
static const char *assumed_from(const struct cr_paper *p, const char *key) {
    const struct cr_assumed *a = assumed_of(p);
    for (int i = 0; i < a->n; i++) {
        if (strcmp(a->key[i], key) == 0) {
            return a->from != NULL ? a->from[i] : "";
        }
    }
    return NULL;
}

/* Says where a value comes from: it was given, or a file, a row of the catalogue, a rule or the
 * program gave it. */
static const char *origin_of(struct cr_paper *p, const struct cr_key *key, const char *assumed,
                             bool given) {
    if (assumed != NULL) {
        return assumed[0] != '\0' ? cr_doc_text(p->doc, W(p, "catalogue: %s"), assumed)
                                  : W(p, "assumed: from type and mass");
    }
    if (!given && strcmp(key->name, "mass_kg") == 0) { /* a mass by rule counts as assumed above */
        return W(p, "kerb mass and load");
    }
    bool imported = p->r->scene.source[CR_SOURCE_FILE][0] != '\0';
    return !given ? W(p, "the program's default") : imported ? W(p, "imported") : W(p, "given");
}

/* The tolerance of a value, "+- 3 km/h" with the proper sign; "" without. */
static const char *tolerance(const struct cr_paper *p, const struct cr_tolerances *list, int row,
                             const struct cr_key *key) {
    const char *text = "";
    for (int i = 0; i < list->n; i++) {
        if (list->of[i].row == row) {
            const struct cr_unit *unit = cr_scene_key_unit(key);
            text = cr_doc_text(p->doc, "\u00b1 %.4g %s", cr_unit_from_si(unit, list->of[i].half),
                               key->unit != NULL ? key->unit : "");
        }
    }
    return text;
}

/* Adds a row for a value; none where it is empty. */
static void value_row(struct cr_paper *p, const char *id, const struct cr_key *key, bool given,
                      const char *half) {
    struct cr_str value = {0};
    char full[CR_NAME_MAX + 64];
    snprintf(full, sizeof full, "%s%s%s", id, id[0] != '\0' ? "." : "", key->name);
    enum cr_err code = cr_scene_get(&p->r->resolved, full, &value, NULL);
    p->doc->failed = p->doc->failed || code == CR_ERR_MEMORY;
    if (code == CR_ERR_OK && value.len > 0) {
        const char *assumed = assumed_from(p, full);
        /* The commas of a list separate its numbers: its points must not become commas. */
        const char *text = cr_str_get(&value);
        text = text[0] == '[' ? text : cr_doc_text(p->doc, "%s", text);
        char *end;
        double number = strtod(cr_str_get(&value), &end);
        if (assumed != NULL && *end == '\0') { /* a rule is not exact to ten digits */
            text = cr_doc_text(p->doc, "%.5g", number);
        }
        struct cr_doc_row *row = ROW(p, key->name, text, key->unit != NULL ? key->unit : "", half,
                                     origin_of(p, key, assumed, given));
        if (row != NULL) {
            row->marked = assumed != NULL;
        }
    }
    p->doc->failed = p->doc->failed || value.failed;
    cr_str_fini(&value);
}

/* Whether a value says nothing because its choice was not made: of a model, of a car of the
 * catalogue, or of a place relation for a participant that has its own position. */
static bool is_idle(const struct cr_key *key, const struct cr_participant *part, bool given) {
    if (key->type == CR_KEY_PDOF) {
        enum cr_pdof_kind kind = part->model.pdof_kind;
        return key->aux != (size_t)(kind == CR_PDOF_OLD ? CR_PDOF_AUTO : kind);
    }
    bool place = strncmp(key->name, "place.", 6) == 0;
    return !given && (strncmp(key->name, "model.stiffness", 15) == 0 ||
                      strcmp(key->name, "model.file") == 0 || strcmp(key->name, "car") == 0 ||
                      (place && !cr_scene_is_placed(part)));
}

/* Repeats the x_ keys of a scene or participant in their author's words: sources, assumptions, what
 * an import or a catalogue left. */
static void notes(struct cr_paper *p, const char *extra) {
    cJSON *json = extra != NULL ? cJSON_Parse(extra) : NULL;
    const cJSON *item;
    p->doc->failed = p->doc->failed || (extra != NULL && json == NULL);
    if (json != NULL) {
        cr_doc_table(p->doc, 2);
        HEAD(p, W(p, "Note in the scene"), "");
        cJSON_ArrayForEach(item, json) {
            char *text = cJSON_IsString(item) ? NULL : cJSON_PrintUnformatted(item);
            p->doc->failed = p->doc->failed || (text == NULL && !cJSON_IsString(item));
            ROW(p, item->string, text != NULL ? text : cJSON_GetStringValue(item));
            cJSON_free(text);
        }
        if (!p->doc->failed) {
            p->doc->block[p->doc->blocks - 1].quoted = true;
        }
    }
    cJSON_Delete(json);
}

/* Tells the file that the scene was imported from, and what is known of it. */
static void imported(struct cr_paper *p) {
    const struct cr_scene *scene = &p->r->scene;
    if (scene->source[CR_SOURCE_FILE][0] == '\0') {
        return;
    }
    cr_doc_table(p->doc, 2);
    HEAD(p, W(p, "Imported from"), "");
    int n;
    const struct cr_key *key = cr_scene_keys(CR_KEYS_SCENE, &n);
    for (int i = 0; i < n; i++) {
        const char *name = strchr(key[i].name, '.');
        const char *text = (const char *)scene + key[i].at;
        if (name != NULL && strncmp(key[i].name, "source.", 7) == 0 && text[0] != '\0') {
            ROW(p, name + 1, text);
        }
    }
}

static void one_participant(struct cr_paper *p, int body) {
    const struct cr_participant *part = &p->r->resolved.part[body];
    const struct cr_participant *as_given = &p->r->scene.part[body];
    unsigned mask = cr_scene_kind_mask(part);
    int n;
    const struct cr_key *key = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    cr_doc_addf(p->doc, CR_BLOCK_MINOR, "%s", part->id);
    cr_doc_table(p->doc, 5);
    HEAD(p, W(p, "Input"), W(p, "Value"), W(p, "Unit"), W(p, "Tolerance"), W(p, "Origin"));
    for (int i = 0; i < n; i++) {
        bool long_list = key[i].type == CR_KEY_VERTICES || key[i].type == CR_KEY_TRAJECTORY;
        bool given = (as_given->given >> i & 1) != 0, named = strcmp(key[i].name, "id") == 0;
        if ((key[i].for_kinds & mask) != 0 && !long_list && !named &&
            !is_idle(&key[i], part, given)) {
            value_row(p, part->id, &key[i], given, tolerance(p, &as_given->tolerances, i, &key[i]));
        }
    }
    if (part->waypoints > 0) {
        cr_doc_addf(p->doc, CR_BLOCK_TEXT, W(p, "Trajectory of %d points, given."),
                    part->waypoints);
    }
    notes(p, as_given->extra);
}

void cr_section_inputs(struct cr_paper *p) {
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "3 Inputs and their origin"));
    cr_doc_add(p->doc, CR_BLOCK_TEXT,
               W(p,
                 "Every value that entered the computation. Values assumed by rule are marked in "
                 "the margin; a value without tolerance was taken as exact."));
    imported(p);
    notes(p, p->r->scene.extra);
    for (int i = 0; i < p->r->resolved.n; i++) {
        one_participant(p, i);
    }
}

void cr_section_method(struct cr_paper *p) {
    int n;
    const struct cr_key *key = cr_scene_keys(CR_KEYS_SETTINGS, &n);
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "4 Method"));
    cr_doc_add(p->doc, CR_BLOCK_TEXT,
               W(p,
                 "Each vehicle is a plane grid of voxels. A voxel holds the energy that crushes "
                 "it; together the voxels of a face give its EES over depth, calibrated to "
                 "crash tests. Time runs in slices. In each slice the voxels in which two bodies "
                 "overlap lose material and release their energy."));
    static const char *const equations[] = {"(1)  E = sum of E_voxel", "(2)  |F_n| = E / s",
                                            "(3)  COE = sum(E_voxel p_voxel) / sum(E_voxel)",
                                            "(4)  m a = F + sum F_tyre",
                                            "(5)  Theta psi'' = p_F x F + sum p_tyre x F_tyre"};
    for (size_t i = 0; i < sizeof equations / sizeof equations[0]; i++) {
        cr_doc_add(p->doc, CR_BLOCK_CODE, equations[i]);
    }
    cr_doc_add(p->doc, CR_BLOCK_TEXT,
               W(p,
                 "E: energy released in the slice, s: approach along the contact normal, COE: "
                 "centre of energy, where the force acts. The compression ends when the approach "
                 "momentum that is left is the elastic share; compression and restitution of "
                 "that share follow."));
    cr_doc_add(p->doc, CR_BLOCK_TEXT,
               W(p, "Source: Breitlauch et al., A novel method for the automated simulation of "
                    "various vehicle collisions to estimate crash severity, Traffic Injury "
                    "Prevention 2023, S116-S123. The method \"extended\" adds friction between "
                    "bodies, induced deformation, dynamic crush, heights and braking dive; "
                    "\"paper\" is without them. The choices made stand in the program's method "
                    "page."));
    cr_doc_table(p->doc, 5);
    HEAD(p, W(p, "Setting"), W(p, "Value"), W(p, "Unit"), W(p, "Tolerance"), W(p, "Origin"));
    for (int i = 0; i < n; i++) {
        value_row(p, "", &key[i], (p->r->scene.set.given >> i & 1) != 0,
                  tolerance(p, &p->r->scene.set.tolerances, i, &key[i]));
    }
}
