/* damage: what was measured of vehicles, and what follows from it; against a solve. */
#include "cmd/cmd_priv.h"

#include "base/file.h"
#include "damage/against.h"
#include "damage/picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the session was told of damage, in the order it came. */
struct cr_damage_notes {
    int n;
    char id[CR_BODY_MAX][CR_NAME_MAX];
    struct cr_measured m[CR_BODY_MAX];
};

static struct cr_measured *note_of(struct cr_damage_notes *notes, const char *id) {
    for (int i = 0; notes != NULL && i < notes->n; i++) {
        if (strcmp(notes->id[i], id) == 0) {
            return &notes->m[i];
        }
    }
    return NULL;
}

const struct cr_measured *cr_damage_known(const struct cr_session *s, const char *id) {
    return note_of(s->damage, id);
}

static void take_number(struct cr_call *call, const char *name, double *value, double *tolerance) {
    const struct cr_value *v = cr_cmd_arg(call, name);
    *value = v->token != NULL ? v->number : *value;
    *tolerance = v->token != NULL && !isnan(v->second) ? v->second : *tolerance;
}

/* the keys that were given, over what was known before */
static enum cr_err read_keys(struct cr_call *call, struct cr_measured *m, struct cr_error *err) {
    const char *stations = cr_cmd_text(call, "c", NULL), *ride = cr_cmd_text(call, "ride", NULL);
    const char *outline = cr_cmd_text(call, "outline", NULL);
    m->face = (enum cr_face)cr_cmd_word(call, "face", (int)m->face);
    take_number(call, "length", &m->length, &m->length_tol);
    take_number(call, "offset", &m->offset, &m->offset_tol);
    take_number(call, "pdof", &m->pdof, &m->pdof_tol);
    m->direct = cr_cmd_number(call, "direct", m->direct);
    m->direct_offset = cr_cmd_number(call, "at", m->direct_offset);
    if (ride != NULL) {
        cr_crush_ride(cr_cmd_word(call, "ride", 0) == 0 ? "under" : "over", m);
    }
    m->z_lo = cr_cmd_number(call, "low", m->z_lo);
    m->z_hi = cr_cmd_number(call, "high", m->z_hi);
    m->depth_tol = cr_cmd_number(call, "tape", m->depth_tol);
    if (stations != NULL) {
        enum cr_err code = cr_crush_stations_read(stations, m, err);
        if (code != CR_ERR_OK) {
            return cr_cmd_blame(call, "c", code);
        }
    }
    if (outline != NULL) {
        enum cr_err code = cr_crush_outline_read(outline, m, err);
        return code == CR_ERR_OK ? code : cr_cmd_blame(call, "outline", code);
    }
    return CR_ERR_OK;
}

static enum cr_err take_note(struct cr_call *call, const char *id, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct cr_measured m, *known = note_of(s->damage, id);
    if (known != NULL) {
        m = *known;
    } else {
        cr_crush_init(&m);
    }
    enum cr_err code = read_keys(call, &m, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    if (m.stations == 0 && !m.guessed) {
        cr_err_set(err, CR_ERR_MISSING, "nothing was measured of %s yet", id);
        cr_err_hint(err, "damage %s face=front length=1.4m c=12,14,20,22,18,10cm", id);
        return cr_cmd_blame(call, "NAME", CR_ERR_MISSING);
    }
    if (s->damage == NULL) {
        s->damage = calloc(1, sizeof *s->damage);
    }
    if (s->damage == NULL || (known == NULL && s->damage->n == CR_BODY_MAX)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the damage");
    }
    if (known == NULL) {
        known = &s->damage->m[s->damage->n];
        snprintf(s->damage->id[s->damage->n++], CR_NAME_MAX, "%s", id);
    }
    *known = m;
    return CR_ERR_OK;
}

/* What is worked with: a copy of the scene with all its values, and what follows. */
struct back {
    struct cr_scene scene;
    struct cr_assumed assumed;
    struct cr_arena arena;
    struct cr_crush_rules rules;
    struct cr_crush_case what;
    struct cr_crush_impact impact;
};

static enum cr_err resolve(struct cr_session *s, struct back *out, struct cr_error *err) {
    enum cr_err code = cr_scene_copy(cr_session_scene(s), &out->scene, err);
    if (code == CR_ERR_OK) {
        code = cr_cmd_resolve(&out->scene, s->models, &out->assumed, err);
        if (code != CR_ERR_OK) {
            cr_cmd_name_place(cr_session_scene(s), err);
        }
    }
    return code;
}

/* The vehicle, and its partner: against=, or the other one whose damage is known. Names it, or an
 * object, or nobody (NULL). */
static const char *partner_of(struct cr_call *call, const char *id, struct back *b) {
    const struct cr_damage_notes *notes = call->s->damage;
    const char *other = cr_cmd_text(call, "against", NULL);
    for (int i = 0; i < notes->n && other == NULL; i++) {
        bool there = cr_scene_find(&b->scene, notes->id[i]) != NULL;
        other = there && strcmp(notes->id[i], id) != 0 ? notes->id[i] : NULL;
    }
    return other;
}

static enum cr_err open_car(struct cr_session *s, struct back *b, int i, const char *id,
                            const struct cr_measured *partner, struct cr_error *err) {
    struct cr_participant *p = cr_scene_find(&b->scene, id);
    struct cr_measured m = *note_of(s->damage, id);
    double reference, spread = b->assumed.mass_spread[p - b->scene.part];
    cr_model_dims(s->models, p->type, &reference);
    /* what the command vehicle took for want of a mass is no better known than any of the type */
    spread = p->mass == reference ? cr_mass_spread_by_type : spread;
    cr_crush_mass(p, spread, &m);
    if (m.guessed && (partner == NULL || partner->guessed)) {
        cr_err_set(err, CR_ERR_MISSING, "what is unknown of %s needs a partner that was measured",
                   id);
        cr_err_hint(err, "damage B face=rear length=1.2m c=10,20,20,10cm against=%s", id);
        return CR_ERR_MISSING;
    }
    if (m.guessed) {
        cr_crush_guess(partner, p, &m);
    }
    return cr_crush_open(s->models, p, &m, &b->arena, &b->what.car[i], err);
}

static enum cr_err open_case(struct cr_call *call, const char *id, struct back *b,
                             struct cr_error *err) {
    struct cr_session *s = call->s;
    const char *other = partner_of(call, id, b);
    struct cr_participant *p = other != NULL ? cr_scene_find(&b->scene, other) : NULL;
    struct cr_measured *m = other != NULL ? note_of(s->damage, other) : NULL;
    b->what = (struct cr_crush_case){
        .n = 1, .object_mass = NAN, .restitution = NAN, .restitution_tol = NAN};
    if (p != NULL && p->kind == CR_KIND_OBJECT) {
        b->what.object = true;
        b->what.object_mass = p->mass;
    } else if (p != NULL && (m == NULL || strcmp(other, id) == 0)) {
        cr_err_set(err, CR_ERR_MISSING, "nothing was measured of %s yet", other);
        cr_err_hint(err, "damage %s face=front length=1.4m c=12,14,20,22,18,10cm, or c=unknown",
                    other);
        return cr_cmd_blame(call, "against", CR_ERR_MISSING);
    } else if (p != NULL) {
        b->what.n = 2;
    }
    enum cr_err code = open_car(s, b, 0, id, b->what.n == 2 ? m : NULL, err);
    return code == CR_ERR_OK && b->what.n == 2
               ? open_car(s, b, 1, other, note_of(s->damage, id), err)
               : code;
}

static enum cr_err read_rules(struct cr_session *s, struct cr_crush_rules *out,
                              struct cr_error *err) {
    char path[2 * CR_PATH_MAX];
    return cr_crush_rules_read(
        cr_file_part(s->data_dir, "damage/calibration.json", path, sizeof path), out, err);
}

static enum cr_err say_picture(struct cr_session *s, const struct cr_crush_case *what,
                               const struct cr_crush_rules *rules, struct cr_error *err) {
    int width, height;
    struct cr_str text = {0};
    enum cr_err code = CR_ERR_OK;
    cr_session_room(s, &width, &height);
    struct cr_look look = s->opts.look;
    look.color = CR_COLOR_NONE; /* lines of an answer have none */
    const struct cr_crush_look how = {.lib = s->models, .look = &look, .width = width - 2};
    for (int i = 0; i < what->n && code == CR_ERR_OK; i++) {
        code = cr_crush_picture(&what->car[i], rules, &how, &text, err);
    }
    if (code == CR_ERR_OK) {
        cr_session_lines(s, &text, false);
    }
    cr_str_fini(&text);
    return code;
}

static enum cr_err write_file(struct cr_call *call, const struct cr_crush_case *what,
                              const struct cr_crush_impact *impact, struct cr_error *err) {
    const char *path = cr_cmd_text(call, "out", NULL);
    struct cr_str text = {0};
    if (path == NULL) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_crush_json(what, impact, &text, err);
    if (code == CR_ERR_OK) {
        code = cr_file_write_str(path, &text, err);
    }
    cr_str_fini(&text);
    if (code == CR_ERR_OK) {
        cr_say(call->s, "%s: the damage and what follows", path);
    }
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "out", code);
}

static enum cr_err work_back(struct cr_call *call, const char *id, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct cr_str text = {0};
    struct back *b = calloc(1, sizeof *b);
    if (b == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the damage");
    }
    cr_scene_init(&b->scene);
    enum cr_err code = resolve(s, b, err);
    if (code == CR_ERR_OK) {
        code = read_rules(s, &b->rules, err);
    }
    if (code == CR_ERR_OK) {
        code = open_case(call, id, b, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_solve(&b->what, &b->rules, &b->impact, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_text(&b->what, &b->impact, &text, err);
    }
    if (code == CR_ERR_OK) {
        cr_session_lines(s, &text, false);
        code = cr_cmd_given(call, "picture") ? say_picture(s, &b->what, &b->rules, err) : code;
    }
    if (code == CR_ERR_OK) {
        code = write_file(call, &b->what, &b->impact, err);
    }
    cr_str_fini(&text);
    cr_arena_free(&b->arena);
    cr_assumed_fini(&b->assumed);
    cr_scene_fini(&b->scene);
    free(b);
    return code;
}

/* ---- against a solve ---- */

static enum cr_err against_solve(struct cr_call *call, const char *id, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct cr_crush_against against;
    struct cr_str text = {0};
    enum cr_err code = cr_session_need_whole(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_measured *m = note_of(s->damage, id);
    if (m->guessed) {
        cr_err_set(err, CR_ERR_MISSING, "nothing was measured of %s", id);
        return cr_cmd_blame(call, "NAME", CR_ERR_MISSING);
    }
    struct cr_scene *scene = &cr_session_now(s)->scene;
    cr_crush_against(s->result, (int)(cr_scene_find(scene, id) - scene->part), m, &against);
    cr_crush_against_text(id, m, &against, &text);
    cr_session_lines(s, &text, false);
    cr_str_fini(&text);
    return CR_ERR_OK;
}

enum cr_err cr_cmd_damage(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    const char *id = cr_cmd_text(call, "NAME", NULL);
    enum cr_err code = cr_session_need_models(s, err);
    if (code == CR_ERR_OK) {
        code = take_note(call, id, err);
    }
    if (code == CR_ERR_OK) {
        code =
            cr_cmd_given(call, "solved") ? against_solve(call, id, err) : work_back(call, id, err);
    }
    return code;
}
