/* damage: what was measured of vehicles, and what follows from it; against a solve. */
#include "cmd/cmd_priv.h"

#include "base/file.h"
#include "damage/picture.h"
#include "result/deform.h"

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

/* "12,14,20,22,18,10cm": depths, a unit behind the last counts for all */
static enum cr_err read_stations(const char *text, struct cr_measured *m, struct cr_error *err) {
    const struct cr_unit *unit = cr_unit_find("m", CR_DIM_LENGTH);
    const char *last = strrchr(text, ','), *end;
    if (last != NULL) {
        cr_number_scan(last + 1, &end);
        unit = *end != '\0' && cr_unit_find(end, CR_DIM_LENGTH) != NULL
                   ? cr_unit_find(end, CR_DIM_LENGTH)
                   : unit;
    }
    m->stations = 0;
    for (bool more = true; more;) {
        char word[64];
        size_t len = strcspn(text, ",");
        if (m->stations == CR_STATIONS_MAX || len >= sizeof word) {
            return cr_err_set(err, CR_ERR_RANGE, "more than %d stations", CR_STATIONS_MAX);
        }
        snprintf(word, sizeof word, "%.*s", (int)len, text);
        enum cr_err code =
            cr_unit_parse(word, CR_DIM_LENGTH, unit, &m->depth[m->stations++], NULL, err);
        if (code != CR_ERR_OK) {
            return code;
        }
        more = text[len] == ',';
        text += len + more;
    }
    return CR_ERR_OK;
}

/* the keys that were given, over what was known before */
static enum cr_err read_keys(struct cr_call *call, struct cr_measured *m, struct cr_error *err) {
    const char *stations = cr_cmd_text(call, "c", NULL);
    m->face = (enum cr_face)cr_cmd_word(call, "face", (int)m->face);
    m->length = cr_cmd_number(call, "length", m->length);
    m->offset = cr_cmd_number(call, "offset", m->offset);
    m->direct = cr_cmd_number(call, "direct", m->direct);
    m->direct_offset = cr_cmd_number(call, "at", m->direct_offset);
    m->pdof = cr_cmd_number(call, "pdof", m->pdof);
    m->z_lo = cr_cmd_number(call, "low", m->z_lo);
    m->z_hi = cr_cmd_number(call, "high", m->z_hi);
    m->depth_tol = cr_cmd_number(call, "tape", m->depth_tol);
    if (stations == NULL) {
        return CR_ERR_OK;
    }
    enum cr_err code = read_stations(stations, m, err);
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "c", code);
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
    if (m.stations == 0) {
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

/* a copy of the scene with all its values, which the caller frees */
static enum cr_err resolve(struct cr_session *s, struct cr_scene *out, struct cr_error *err) {
    struct cr_assumed assumed = {0};
    enum cr_err code = cr_scene_copy(cr_session_scene(s), out, err);
    if (code == CR_ERR_OK) {
        code = cr_cmd_resolve(out, s->models, &assumed, err);
        if (code != CR_ERR_OK) {
            cr_cmd_name_place(cr_session_scene(s), err);
            cr_scene_fini(out);
        }
    }
    cr_assumed_fini(&assumed);
    return code;
}

/* the vehicle, and its partner: against=, or the other one whose damage is known */
static enum cr_err open_case(struct cr_call *call, const char *id, struct cr_scene *scene,
                             struct cr_arena *arena, struct cr_crush_case *out,
                             struct cr_error *err) {
    struct cr_session *s = call->s;
    const char *other = cr_cmd_text(call, "against", NULL);
    *out = (struct cr_crush_case){.n = 1, .object_mass = NAN, .restitution = NAN};
    enum cr_err code = cr_crush_open(s->models, cr_scene_find(scene, id), note_of(s->damage, id),
                                     arena, &out->car[0], err);
    for (int i = 0; i < s->damage->n && other == NULL; i++) {
        bool there = cr_scene_find(scene, s->damage->id[i]) != NULL;
        other = there && strcmp(s->damage->id[i], id) != 0 ? s->damage->id[i] : NULL;
    }
    struct cr_participant *p = other != NULL ? cr_scene_find(scene, other) : NULL;
    if (code != CR_ERR_OK || p == NULL) {
        return code;
    }
    if (p->kind == CR_KIND_OBJECT) {
        out->object = true;
        out->object_mass = p->mass;
        return CR_ERR_OK;
    }
    struct cr_measured *m = note_of(s->damage, other);
    if (m == NULL || strcmp(other, id) == 0) {
        cr_err_set(err, CR_ERR_MISSING, "nothing was measured of %s yet", other);
        cr_err_hint(err, "damage %s face=front length=1.4m c=12,14,20,22,18,10cm", other);
        return cr_cmd_blame(call, "against", CR_ERR_MISSING);
    }
    out->n = 2;
    return cr_crush_open(s->models, p, m, arena, &out->car[1], err);
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
        cr_session_lines(s, &text);
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
        code = cr_file_write(path, cr_str_get(&text), text.len, err);
    }
    cr_str_fini(&text);
    if (code == CR_ERR_OK) {
        cr_say(call->s, "%s: the damage and what follows", path);
    }
    return code == CR_ERR_OK ? code : cr_cmd_blame(call, "out", code);
}

static enum cr_err work_back(struct cr_call *call, const char *id, struct cr_error *err) {
    struct cr_session *s = call->s;
    struct cr_scene scene;
    struct cr_arena arena = {0};
    struct cr_crush_case what;
    struct cr_crush_rules rules;
    struct cr_crush_impact impact;
    struct cr_str text = {0};
    enum cr_err code = resolve(s, &scene, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = read_rules(s, &rules, err);
    if (code == CR_ERR_OK) {
        code = open_case(call, id, &scene, &arena, &what, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_solve(&what, &rules, &impact, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_text(&what, &impact, &text, err);
    }
    if (code == CR_ERR_OK) {
        cr_session_lines(s, &text);
        code = cr_cmd_given(call, "picture") ? say_picture(s, &what, &rules, err) : code;
    }
    if (code == CR_ERR_OK) {
        code = write_file(call, &what, &impact, err);
    }
    cr_str_fini(&text);
    cr_arena_free(&arena);
    cr_scene_fini(&scene);
    return code;
}

/* ---- against a solve ---- */

/* residual depth of the solve at a place along the face: the line of voxels there */
static double solved_at(const struct cr_result *r, int body, const struct cr_measured *m,
                        double at) {
    const struct cr_deform d = {.grid = &r->compiled.cs.body[body].grid,
                                .left = r->solution->body[body].left,
                                .how = r->solution->body[body].how,
                                .residual_curve = r->resolved.set.residual_curve == 1};
    const struct cr_grid *g = d.grid;
    const struct cr_participant *p = &r->resolved.part[body];
    bool end = cr_face_is_end(m->face);
    double middle = p->front_overhang + p->cg_behind_front_axle - p->length / 2;
    double place = end ? -at : at + middle, from = end ? g->y0 : g->x0;
    int line = (int)floor((place - from) / g->h), n = cr_face_lines(g, m->face);
    if (line < 0 || line >= n) {
        return 0;
    }
    /* columns run from left to right and from rear to front */
    int column = end ? n - 1 - line : line;
    double depth = cr_deform_column(&d, m->face, column, false);
    return d.residual_curve ? depth : cr_deform_residual(depth, g->springback[m->face]);
}

static enum cr_err against_solve(struct cr_call *call, const char *id, struct cr_error *err) {
    struct cr_session *s = call->s;
    enum cr_err code = cr_session_need_whole(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const struct cr_measured *m = note_of(s->damage, id);
    int body = (int)(cr_scene_find(&cr_session_now(s)->scene, id) - cr_session_now(s)->scene.part);
    double sum = 0;
    cr_say(s, "%s, %s: measured and solved depth, cm", id, cr_crush_face_word(m->face));
    for (int i = 0; i < m->stations; i++) {
        double at = m->offset + m->length * ((double)i / (m->stations - 1) - 0.5);
        double solved = solved_at(s->result, body, m, at), off = solved - m->depth[i];
        cr_say(s, "  C%-2d at %+5.2f m %6.1f %6.1f  %+6.1f", i + 1, at, 100 * m->depth[i],
               100 * solved, 100 * off);
        sum += off * off;
    }
    cr_say(s, "  root mean square of the differences %.1f cm", 100 * sqrt(sum / m->stations));
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
