/* Resolved scene -> case for the solver. */
#include "scene/scene_priv.h"

#include "base/elementary.h"
#include "scene/compiled.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What the functions below share. */
struct making {
    const struct cr_scene *scene;
    const struct cr_model_lib *lib;
    const double *pdof;
    struct cr_compiled *out;
    struct cr_error *err;
};

static enum cr_err no_memory(struct making *m) {
    return cr_err_set(m->err, CR_ERR_MEMORY, "no memory for the voxels");
}

static double pdof_of(const struct making *m, int i) {
    const struct cr_model_choice *choice = &m->scene->part[i].model;
    return choice->pdof_kind != CR_PDOF_AUTO ? choice->pdof : m->pdof[i];
}

struct cr_model_query cr_scene_query(const struct cr_scene *scene, const struct cr_participant *p,
                                     double pdof) {
    return (struct cr_model_query){
        .type = p->type,
        .pdof = pdof,
        .blend = p->model.blend,
        .dims = {.length = p->length,
                 .width = p->width,
                 .height = p->height,
                 .wheelbase = p->wheelbase,
                 .track = p->track,
                 .front_overhang = p->front_overhang,
                 .cg_behind_front_axle = p->cg_behind_front_axle,
                 .cg_height = p->cg_height},
        .mass_kg = p->kerb_mass + CR_TEST_LOAD,
        .voxel = scene->set.voxel,
        .curve = scene->set.residual_curve == 1 ? CR_CURVE_RESIDUAL : CR_CURVE_DYNAMIC,
        .built = isnan(p->built) ? 0 : p->built,
        .z_hi = INFINITY,
    };
}

static struct cr_model_query query_of(const struct making *m, int i, double z_lo, double z_hi) {
    struct cr_model_query q = cr_scene_query(m->scene, &m->scene->part[i], pdof_of(m, i));
    q.z_lo = z_lo;
    q.z_hi = z_hi;
    return q;
}

void cr_scene_model_path(const struct cr_scene *scene, const struct cr_participant *p,
                         char path[2 * CR_PATH_MAX]) {
    const char *file = p->model.file;
    bool own = file[0] == '/' || scene->dir[0] == '\0';
    snprintf(path, 2 * CR_PATH_MAX, "%s%s%s", own ? "" : scene->dir, own ? "" : "/", file);
}

static enum cr_err make_own_grid(struct making *m, int i, const struct cr_model_query *asked,
                                 struct cr_grid *grid) {
    const struct cr_model_choice *choice = &m->scene->part[i].model;
    struct cr_model_query query = *asked;
    char path[2 * CR_PATH_MAX], hash[CR_HASH_SIZE];
    enum cr_err code;
    switch (choice->kind) {
    case CR_MODEL_FILE:
        cr_scene_model_path(m->scene, &m->scene->part[i], path);
        code = cr_model_from_file(path, &query, &m->out->arena, grid, hash, m->err);
        if (code == CR_ERR_OK) {
            memcpy(m->out->hash[i], hash, sizeof hash);
        }
        return code;
    case CR_MODEL_STIFFNESS:
        return cr_model_from_stiffness(m->lib, &query, choice->face, &m->out->arena, grid, m->err);
    default:
        return cr_model_substitute(m->lib, &query, &m->out->arena, grid, m->err);
    }
}

static enum cr_err make_grid(struct making *m, int i, const struct cr_model_query *query,
                             struct cr_grid *grid) {
    double factor = m->scene->part[i].model.energy_factor;
    enum cr_err code = make_own_grid(m, i, query, grid);
    if (code != CR_ERR_OK || factor == 1) {
        return code;
    }
    size_t n = (size_t)grid->nx * (size_t)grid->ny; /* the model's own arrays are shared */
    double *energy = cr_arena_take_raw(&m->out->arena, n, sizeof *energy);
    if (energy == NULL) {
        return no_memory(m);
    }
    for (size_t k = 0; k < n; k++) {
        energy[k] = factor * grid->energy[k];
    }
    grid->energy = energy;
    return CR_ERR_OK;
}

static void name_model(struct making *m, int i) {
    const struct cr_participant *p = &m->scene->part[i];
    char *name = m->out->model[i];
    size_t size = sizeof m->out->model[i];
    if (p->model.kind == CR_MODEL_FILE) {
        const char *slash = strrchr(p->model.file, '/');
        snprintf(name, size, "file %.*s", (int)size - 6, slash != NULL ? slash + 1 : p->model.file);
        return;
    }
    snprintf(m->out->hash[i], sizeof m->out->hash[i], "%s", cr_model_hash(m->lib, p->type));
    if (p->model.kind == CR_MODEL_STIFFNESS) {
        snprintf(name, size, "stiffness");
    } else {
        snprintf(name, size, "%s/%d", cr_type_word(p->type), cr_pdof_clock(pdof_of(m, i)));
    }
}

/* Wheels at their contact points with the static loads that the place of the CG gives. */
static void make_wheels(const struct cr_participant *p, struct cr_body *body) {
    double front = p->cg_behind_front_axle, rear = p->wheelbase - front;
    double weight = p->mass * CR_G;
    body->wheels = CR_WHEELS;
    for (int w = 0; w < CR_WHEELS; w++) {
        bool is_front = w < 2, is_left = w % 2 == 0;
        body->wheel[w] = (struct cr_wheel){
            .at = cr_vec2(is_front ? front : -rear, is_left ? p->track / 2 : -p->track / 2),
            .load = weight * (is_front ? rear : front) / p->wheelbase / 2,
            .brake = p->brake[w],
            .steer = p->steer[w],
            .locked = p->locked[w],
        };
    }
}

struct range {
    double lo, hi; /* m above the road */
};

bool cr_scene_by_push(const struct cr_participant *p) {
    return p->kind == CR_KIND_VEHICLE && p->model.kind != CR_MODEL_FILE &&
           p->model.pdof_kind == CR_PDOF_AUTO && p->model.blend;
}

/* The strengths of vehicle i by the way it is pushed, of the layers in a range of heights: those of
 * the models of 12, 6 and 3 o'clock, which the solver mixes by the direction of the force. */
static enum cr_err make_strength(struct making *m, int i, struct range z, struct cr_strength *out) {
    static const double pdof[CR_PUSHES] = {
        [CR_PUSH_REARWARD] = 0, [CR_PUSH_FORWARD] = CR_PI, [CR_PUSH_SIDEWAYS] = CR_PI / 2};
    const struct cr_grid *whole = &m->out->cs.body[i].grid;
    for (int k = 0; k < CR_PUSHES; k++) {
        struct cr_model_query query = query_of(m, i, z.lo, z.hi);
        struct cr_grid grid;
        query.pdof = pdof[k];
        query.blend = false;
        enum cr_err code = make_grid(m, i, &query, &grid);
        if (code == CR_ERR_OK && (grid.nx != whole->nx || grid.ny != whole->ny)) {
            code = cr_err_set(m->err, CR_ERR_MODEL, "model of \"%s\" changes its size",
                              m->scene->part[i].id);
        }
        if (code != CR_ERR_OK) {
            return code;
        }
        out->energy[k] = grid.energy;
    }
    return CR_ERR_OK;
}

static enum cr_err make_vehicle(struct making *m, int i, struct cr_body *body) {
    const struct cr_participant *p = &m->scene->part[i];
    body->mass = p->mass;
    body->inertia = p->yaw_inertia;
    make_wheels(p, body);
    struct cr_model_query query = query_of(m, i, 0, INFINITY);
    enum cr_err code = make_grid(m, i, &query, &body->grid);
    if (code == CR_ERR_OK && cr_scene_by_push(p)) {
        code = make_strength(m, i, (struct range){0, INFINITY}, &body->strength);
    }
    if (code == CR_ERR_OK) {
        name_model(m, i);
    } else if (m->err != NULL && m->err->where[0] == '\0') {
        snprintf(m->err->where, sizeof m->err->where, "/participants/%d/model", i);
    }
    return code;
}

/* area, centroid and second moment of area about the centroid of a polygon (Green's theorem) */
static void polygon_moments(const struct cr_vec2 *v, int n, double *area, struct cr_vec2 *centre,
                            double *second) {
    double a = 0, x = 0, y = 0, j = 0;
    for (int i = 0; i < n; i++) {
        struct cr_vec2 p = v[i], q = v[(i + 1) % n];
        double c = cr_vec2_cross(p, q);
        a += c / 2;
        x += c * (p.x + q.x) / 6;
        y += c * (p.y + q.y) / 6;
        j += c * (cr_vec2_dot(p, p) + cr_vec2_dot(p, q) + cr_vec2_dot(q, q)) / 12;
    }
    *area = a;
    *centre = cr_vec2(x / a, y / a);
    *second = j - a * cr_vec2_dot(*centre, *centre);
}

/* Centre of a shape from its reference point, and inertia per mass (uniform; the rounding of a
 * box's edges is left out). A wall has no end and so does not turn. */
static void shape_moments(const struct cr_participant *p, struct cr_vec2 *centre, double *inertia) {
    double area, second;
    *centre = cr_vec2(0, 0);
    switch (p->shape) {
    case CR_OBJECT_POLE:
        *inertia = p->radius * p->radius / 2;
        break;
    case CR_OBJECT_BOX:
        *inertia = (p->length * p->length + p->width * p->width) / 12;
        break;
    case CR_OBJECT_POLYGON:
        polygon_moments(p->vertex, p->vertices, &area, centre, &second);
        *inertia = second / area;
        break;
    default:
        *inertia = 0;
        break;
    }
}

static enum cr_err make_polygon(struct making *m, const struct cr_participant *p,
                                struct cr_vec2 centre, struct cr_shape *shape) {
    bool box = p->shape == CR_OBJECT_BOX;
    double x = p->length / 2 - p->edge_radius, y = p->width / 2 - p->edge_radius;
    const struct cr_vec2 corner[] = {cr_vec2(-x, -y), cr_vec2(x, -y), cr_vec2(x, y),
                                     cr_vec2(-x, y)};
    int n = box ? 4 : p->vertices;
    struct cr_vec2 *v = cr_arena_take(&m->out->arena, (size_t)n, sizeof *v);
    if (v == NULL) {
        return no_memory(m);
    }
    for (int i = 0; i < n; i++) {
        v[i] = box ? corner[i] : cr_vec2_sub(p->vertex[i], centre);
    }
    shape->kind = CR_SHAPE_POLYGON;
    shape->edge_radius = box ? p->edge_radius : 0;
    shape->n = n;
    shape->vertex = v;
    return CR_ERR_OK;
}

/* A barrier is voxels as a vehicle is, of the blocks in its heights. */
static enum cr_err make_barrier(struct making *m, int i, struct cr_body *body) {
    const struct cr_participant *p = &m->scene->part[i];
    const struct cr_barrier *b;
    enum cr_err code = cr_model_barrier(m->lib, p->barrier, &b, m->err);
    if (code != CR_ERR_OK) {
        return code;
    }
    body->mass = isnan(p->mass) ? 0 : p->mass;
    body->inertia = p->yaw_inertia;
    memcpy(m->out->hash[i], b->hash, sizeof m->out->hash[i]);
    snprintf(m->out->model[i], sizeof m->out->model[i], "barrier %s", p->barrier);
    return cr_barrier_grid(b, m->scene->set.voxel, (const double[2]){p->z_lo, p->z_hi},
                           &m->out->arena, &body->grid, m->err);
}

/* The solver's bodies turn about their CG: a polygon is moved to its centroid. */
static enum cr_err make_object(struct making *m, int i, struct cr_body *body,
                               struct cr_vec2 *centre) {
    const struct cr_participant *p = &m->scene->part[i];
    double inertia;
    if (p->shape == CR_OBJECT_BARRIER) {
        return make_barrier(m, i, body);
    }
    shape_moments(p, centre, &inertia);
    body->mass = isnan(p->mass) ? 0 : p->mass;
    body->inertia = inertia * body->mass;
    switch (p->shape) {
    case CR_OBJECT_WALL:
        body->shape.kind = CR_SHAPE_WALL;
        return CR_ERR_OK;
    case CR_OBJECT_POLE:
        body->shape.kind = CR_SHAPE_POLE;
        body->shape.radius = p->radius;
        return CR_ERR_OK;
    default:
        return make_polygon(m, p, *centre, &body->shape);
    }
}

static struct cr_vec2 shifted(struct cr_vec2 pos, double heading, struct cr_vec2 by) {
    return cr_vec2_add(pos, cr_vec2_turn(by, heading));
}

static enum cr_err make_motion(struct making *m, const struct cr_participant *p,
                               struct cr_vec2 centre, struct cr_body *body) {
    double course = isnan(p->course) ? p->heading : p->course;
    body->pos = shifted(p->pos, p->heading, centre);
    body->heading = p->heading;
    body->yaw_rate = p->yaw_rate;
    body->vel = cr_vec2_scale(cr_vec2_toward(course), p->speed);
    if (p->waypoints == 0) {
        return CR_ERR_OK;
    }
    struct cr_waypoint *way = cr_arena_take(&m->out->arena, (size_t)p->waypoints, sizeof *way);
    if (way == NULL) {
        return no_memory(m);
    }
    memcpy(way, p->waypoint, (size_t)p->waypoints * sizeof *way);
    for (int i = 0; i < p->waypoints; i++) {
        way[i].pos = shifted(way[i].pos, way[i].heading, centre);
    }
    body->waypoints = p->waypoints;
    body->waypoint = way;
    body->pos = way[0].pos;
    body->heading = way[0].heading;
    body->vel = cr_vec2_scale(cr_vec2_toward(way[0].heading), way[0].speed);
    return CR_ERR_OK;
}

static enum cr_err make_body(struct making *m, int i) {
    const struct cr_participant *p = &m->scene->part[i];
    struct cr_body *body = &m->out->cs.body[i];
    struct cr_vec2 centre = {0, 0};
    *body = (struct cr_body){.friction = isnan(p->friction) ? -1 : p->friction,
                             .brake_after = p->brake_after,
                             .reaction = p->reaction};
    enum cr_err code =
        p->kind == CR_KIND_VEHICLE ? make_vehicle(m, i, body) : make_object(m, i, body, &centre);
    return code == CR_ERR_OK ? make_motion(m, p, centre, body) : code;
}

/* What a vehicle's end holds out at another, as shares of its height: from under the bumper beam to
 * the bonnet; the recipe says from where, the middle of a car's is end_low. A flank goes up to the
 * roof. */
static const double end_low = 0.12, end_high = 0.65;
/* Material below this share of the height, or above this share of what meets, changes nothing that
 * matters: most pairs need no second grid. */
static const double low_share = 0.15, high_share = 0.8;

static enum cr_face struck_face(const struct making *m, int i, int k) {
    return cr_scene_struck_face(m->scene, &m->out->cs, i, k);
}

/* Heights that participant i holds out at k while it stands level. A fixed or rigid partner meets a
 * vehicle from the road to the roof: the vehicle's model knows itself what stands at which height.
 */
static struct range held_level(const struct making *m, int i, int k) {
    const struct cr_participant *p = &m->scene->part[i];
    if (p->kind != CR_KIND_VEHICLE) {
        return (struct range){p->z_lo, p->z_hi};
    }
    if (m->scene->part[k].kind != CR_KIND_VEHICLE) {
        return (struct range){0, p->height};
    }
    enum cr_face face = struck_face(m, i, k);
    bool end = cr_face_is_end(face);
    double low = cr_model_rules(m->lib, p->type)->end_low;
    return (struct range){low * p->height, (end ? end_high : 1) * p->height};
}

/* Middle of the heights in which the end of vehicle i and k meet: there the force acts. What only
 * the wheels meet does not turn the body: the height of the CG. */
static double force_height(const struct making *m, int i, int k) {
    const struct cr_participant *p = &m->scene->part[i];
    struct range a = held_level(m, i, k), b = held_level(m, k, i);
    double lo = fmax(fmax(a.lo, b.lo), end_low * p->height), hi = fmin(a.hi, b.hi);
    return lo < hi ? (lo + hi) / 2 : p->cg_height;
}

/* How far the struck end of vehicle i goes down against k, braked and by the crash itself. What is
 * struck at a flank stays level. */
static double dive_of(const struct making *m, int i, int k) {
    const struct cr_participant *p = &m->scene->part[i];
    enum cr_face face = struck_face(m, i, k);
    if (p->kind != CR_KIND_VEHICLE || m->scene->set.dive != 1 ||
        (face != CR_FACE_FRONT && face != CR_FACE_REAR)) {
        return 0;
    }
    const struct cr_body *a = &m->out->cs.body[i], *b = &m->out->cs.body[k];
    double share = b->mass > 0 ? b->mass / (a->mass + b->mass) : 1;
    double delta_v = share * cr_vec2_len(cr_vec2_sub(b->vel, a->vel));
    bool front = face == CR_FACE_FRONT;
    return cr_scene_dive(p, m->scene->set.road_friction, front) +
           cr_scene_pitch(p, delta_v, force_height(m, i, k), front);
}

/* Heights that participant i holds out at k, above the road. */
static struct range held_out(const struct making *m, int i, int k) {
    struct range level = held_level(m, i, k);
    bool both =
        m->scene->part[i].kind == CR_KIND_VEHICLE && m->scene->part[k].kind == CR_KIND_VEHICLE;
    double dive = both ? dive_of(m, i, k) : 0;
    return (struct range){level.lo - dive, level.hi - dive};
}

/* Strength of the layers of vehicle i in a range of heights; none where the range is empty. */
static enum cr_err make_partial(struct making *m, int i, struct range meet,
                                struct cr_strength *out) {
    const struct cr_grid *whole = &m->out->cs.body[i].grid;
    size_t n = (size_t)whole->nx * (size_t)whole->ny;
    struct cr_grid part;
    if (!(meet.lo < meet.hi)) {
        const double *none = cr_arena_take(&m->out->arena, n, sizeof *none);
        *out = (struct cr_strength){{none, none, none}};
        return none != NULL ? CR_ERR_OK : no_memory(m);
    }
    if (cr_scene_by_push(&m->scene->part[i])) {
        return make_strength(m, i, meet, out);
    }
    struct cr_model_query query = query_of(m, i, meet.lo, meet.hi);
    enum cr_err code = make_grid(m, i, &query, &part);
    if (code == CR_ERR_OK && (part.nx != whole->nx || part.ny != whole->ny)) {
        code = cr_err_set(m->err, CR_ERR_MODEL, "model of \"%s\" changes its size with height",
                          m->scene->part[i].id);
    }
    if (code == CR_ERR_OK) {
        *out = (struct cr_strength){{part.energy, part.energy, part.energy}};
    }
    return code;
}

/* Share of a flank's strength against a pole, which reaches from sill to roof, that stands against
 * another vehicle, which comes in at the height of a bumper: with it the fronts and flanks of cars
 * that struck each other, and flanks struck by a barrier on wheels, are crushed as deeply as they
 * were (validation.md). A whole flank would be right only if what it drags along cost nothing. */
static const double flank_share = 0.59;

static const double *weaker(struct making *m, const struct cr_grid *g, const double *energy) {
    size_t n = (size_t)g->nx * (size_t)g->ny;
    double *part = cr_arena_take_raw(&m->out->arena, n, sizeof *part);
    for (size_t k = 0; part != NULL && k < n; k++) {
        part[k] = flank_share * energy[k];
    }
    return part;
}

/* The flank of vehicle i against another vehicle; its ends as before. */
static enum cr_err make_flank(struct making *m, int i, struct cr_strength *out) {
    const struct cr_body *b = &m->out->cs.body[i];
    bool by_push = cr_scene_by_push(&m->scene->part[i]);
    const double *side = by_push ? b->strength.energy[CR_PUSH_SIDEWAYS] : b->grid.energy;
    const double *part = weaker(m, &b->grid, side);
    if (part == NULL) {
        return no_memory(m);
    }
    out->energy[CR_PUSH_SIDEWAYS] = part;
    if (!by_push) {
        out->energy[CR_PUSH_REARWARD] = out->energy[CR_PUSH_FORWARD] = part;
    }
    return CR_ERR_OK;
}

/* Layers of vehicle i, in its own heights, that partner k meets. */
static struct range meeting(const struct making *m, int i, int k) {
    struct range other = held_out(m, k, i);
    double dive = dive_of(m, i, k);
    return (struct range){fmax(0, other.lo + dive),
                          fmin(m->scene->part[i].height, other.hi + dive)};
}

/* Strength of vehicle i in the heights in which it meets k. */
static enum cr_err make_layers(struct making *m, int i, int k) {
    struct cr_strength *against = m->out->cs.body[i].against;
    struct range own = held_out(m, i, k), meet = meeting(m, i, k);
    double height = m->scene->part[i].height;
    if (meet.lo <= low_share * height && meet.hi >= high_share * own.hi) {
        return CR_ERR_OK;
    }
    /* the same range as against an earlier partner is the same grid */
    for (int e = 0; e < k; e++) {
        struct range before = meeting(m, i, e);
        if (e != i && before.lo == meet.lo && before.hi == meet.hi) {
            against[k] = against[e];
            return CR_ERR_OK;
        }
    }
    return make_partial(m, i, meet, &against[k]);
}

/* Strength of vehicle i against k: a flank against another vehicle by its share, all else by the
 * heights in which the two meet. */
static enum cr_err make_against(struct making *m, int i, int k) {
    bool flank = !cr_face_is_end(struck_face(m, i, k));
    const struct cr_participant *other = &m->scene->part[k];
    bool vehicle = other->kind == CR_KIND_VEHICLE || other->shape == CR_OBJECT_BARRIER;
    bool by_push = cr_scene_by_push(&m->scene->part[i]);
    if (vehicle && !by_push && flank && cr_face_is_end(struck_face(m, k, i))) {
        return make_flank(m, i, &m->out->cs.body[i].against[k]);
    }
    enum cr_err code = make_layers(m, i, k);
    if (code == CR_ERR_OK && vehicle && by_push) {
        code = make_flank(m, i, &m->out->cs.body[i].against[k]);
    }
    return code;
}

static enum cr_err make_heights(struct making *m) {
    const struct cr_scene *scene = m->scene;
    for (int i = 0; i < scene->n; i++) {
        for (int k = 0; k < scene->n && scene->part[i].kind == CR_KIND_VEHICLE; k++) {
            enum cr_err code = k == i ? CR_ERR_OK : make_against(m, i, k);
            if (code != CR_ERR_OK) {
                return code;
            }
        }
    }
    return CR_ERR_OK;
}

/* [ROLLING-RESISTANCE], [ROLLING-IN-GEAR] */
static const double rolling_free = 0.010, rolling_in_gear = 0.05;
/* s beyond the last row of a trajectory, or beyond the way to the others at their speed, in which
 * a contact is waited for; and the most in all */
static const double wait_beyond = 20, wait_most = 3600;

/* Until when a first contact is waited for, s: as long as two that come together need. */
static double longest_wait(const struct cr_case *cs) {
    double wait = 0;
    for (int i = 0; i < cs->n; i++) {
        const struct cr_body *a = &cs->body[i];
        wait = a->waypoints > 0 ? fmax(wait, a->waypoint[a->waypoints - 1].t) : wait;
        for (int k = 0; k < i; k++) {
            const struct cr_body *b = &cs->body[k];
            struct cr_vec2 way = cr_vec2_sub(b->pos, a->pos), v = cr_vec2_sub(a->vel, b->vel);
            double far = cr_vec2_len(way), speed = far > 0 ? cr_vec2_dot(way, v) / far : 0;
            wait = speed > 0 ? fmax(wait, far / speed) : wait;
        }
    }
    return fmin(wait + wait_beyond, wait_most);
}

static struct cr_opts make_opts(const struct cr_settings *set) {
    struct cr_opts opts = cr_opts_default();
    opts.dt = set->dt;
    opts.friction = set->friction_auto ? 0 : set->friction;
    opts.friction_auto = set->friction_auto;
    opts.road_friction = set->road_friction;
    opts.restitution = set->restitution_auto ? 0 : set->restitution;
    opts.restitution_auto = set->restitution_auto;
    opts.elastic_s = set->elastic_auto ? 0 : set->elastic;
    opts.induced = set->induced == 1;
    opts.plane = set->plane_normal == 1;
    opts.end = set->end;
    opts.slope = cr_vec2_scale(cr_vec2_toward(set->downhill), set->slope);
    opts.rolling = set->rolling_auto ? rolling_free : set->rolling;
    opts.rolling_after = set->rolling_auto ? rolling_in_gear : set->rolling;
    return opts;
}

enum cr_err cr_scene_compile(const struct cr_scene *scene, const struct cr_model_lib *lib,
                             const double pdof[CR_BODY_MAX], struct cr_compiled *out,
                             struct cr_error *err) {
    struct making m = {.scene = scene, .lib = lib, .pdof = pdof, .out = out, .err = err};
    memset(out, 0, sizeof *out);
    out->cs.n = scene->n;
    out->cs.opts = make_opts(&scene->set);
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < scene->n && code == CR_ERR_OK; i++) {
        code = make_body(&m, i);
    }
    out->cs.opts.max_time = longest_wait(&out->cs);
    out->cs.patch = (struct cr_patch){.n = scene->set.patch_vertices,
                                      .vertex = scene->set.patch,
                                      .friction = scene->set.patch_friction};
    if (code == CR_ERR_OK && scene->set.heights == 1) {
        code = make_heights(&m);
    }
    if (code != CR_ERR_OK) {
        cr_compiled_fini(out);
    }
    return code;
}

void cr_compiled_fini(struct cr_compiled *compiled) {
    cr_arena_free(&compiled->arena);
    memset(compiled, 0, sizeof *compiled);
}
