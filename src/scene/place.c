/* Placing one participant against another: align, then bring together until the outlines are as far
 * apart as wanted. */
#include "scene/scene_priv.h"

#include "base/elementary.h"

#include <math.h>
#include <stdlib.h>

enum { CORNER_MAX = CR_VERTEX_MAX, STEP_MAX = 2000 };

/* An outline as corners with a radius about each: exact for poles and rounded boxes. */
struct hull {
    int n;
    struct cr_vec2 corner[CORNER_MAX];
    double radius;
    bool barrier; /* overlaps with it are shares of the other's width, as test protocols count */
};

static void hull_of(const struct cr_participant *p, struct hull *out) {
    struct cr_participant plain = *p;
    bool rounded = p->kind == CR_KIND_OBJECT && p->shape == CR_OBJECT_BOX;
    out->radius = 0;
    out->barrier = p->kind == CR_KIND_OBJECT && p->shape == CR_OBJECT_BARRIER;
    if (p->kind == CR_KIND_OBJECT && p->shape == CR_OBJECT_POLE) {
        out->n = 1;
        out->corner[0] = cr_vec2(0, 0);
        out->radius = p->radius;
        return;
    }
    if (rounded) {
        out->radius = p->edge_radius;
        plain.length -= 2 * p->edge_radius;
        plain.width -= 2 * p->edge_radius;
        plain.edge_radius = 0;
    }
    out->n = cr_scene_outline(&plain, out->corner, CORNER_MAX);
}

static void extent(const struct hull *h, double *front, double *rear, double *left, double *right) {
    *front = *left = -INFINITY;
    *rear = *right = INFINITY;
    for (int i = 0; i < h->n; i++) {
        *front = fmax(*front, h->corner[i].x + h->radius);
        *rear = fmin(*rear, h->corner[i].x - h->radius);
        *left = fmax(*left, h->corner[i].y + h->radius);
        *right = fmin(*right, h->corner[i].y - h->radius);
    }
}

static struct hull hull_at(const struct hull *h, struct cr_vec2 pos, double heading) {
    struct hull out = {.n = h->n, .radius = h->radius};
    double c, s;
    cr_sincos(heading, &s, &c);
    for (int i = 0; i < h->n; i++) {
        out.corner[i] = cr_vec2_add(pos, cr_vec2_rotate(h->corner[i], c, s));
    }
    return out;
}

static double point_to_edge(struct cr_vec2 p, struct cr_vec2 a, struct cr_vec2 b) {
    struct cr_vec2 ab = cr_vec2_sub(b, a), ap = cr_vec2_sub(p, a);
    double l2 = cr_vec2_dot(ab, ab);
    double t = l2 > 0 ? cr_clamp(cr_vec2_dot(ap, ab) / l2, 0, 1) : 0;
    return cr_vec2_len(cr_vec2_axpy(ap, -t, ab));
}

static double corners_to_edges(const struct hull *a, const struct hull *b) {
    double least = INFINITY;
    for (int i = 0; i < a->n; i++) {
        for (int k = 0; k < b->n; k++) {
            least =
                fmin(least, point_to_edge(a->corner[i], b->corner[k], b->corner[(k + 1) % b->n]));
        }
    }
    return least;
}

/* distance between outlines that do not overlap */
static double distance(const struct hull *a, const struct hull *b) {
    return fmin(corners_to_edges(a, b), corners_to_edges(b, a)) - a->radius - b->radius;
}

/* Moves a by `back` along the unit vector `to`, which leads to b: from far away in steps as long as
 * the distance that is left, which never pass a touch. False if a passes b by. */
static bool bring_together(struct hull a, const struct hull *b, struct cr_vec2 to, double gap,
                           double far_off, double *moved) {
    *moved = 0;
    for (int i = 0; i < STEP_MAX && *moved < 3 * far_off; i++) {
        double step = distance(&a, b) - gap;
        if (step < 1e-12) {
            return true;
        }
        *moved += step;
        for (int k = 0; k < a.n; k++) {
            a.corner[k] = cr_vec2_axpy(a.corner[k], step, to);
        }
    }
    return *moved < 3 * far_off;
}

/* Where the face that is met lies, in the frame of the struck participant. */
struct face {
    struct cr_vec2 middle, normal; /* the face's outward normal */
    double left, right;            /* its ends along perp(normal): +left, -right */
    double counted;                /* width that an overlap is a share of, m */
    bool endless;
};

static struct face face_of(const struct cr_participant *other, const struct hull *h,
                           enum cr_face side) {
    double front, rear, left, right;
    extent(h, &front, &rear, &left, &right);
    bool wall = other->kind == CR_KIND_OBJECT && other->shape == CR_OBJECT_WALL;
    struct face f = {.endless = wall};
    double x = (front + rear) / 2, y = (left + right) / 2;
    const struct face all[CR_FACES] = {
        [CR_FACE_FRONT] = {.middle = {front, y}, .normal = {1, 0}, .left = left - y},
        [CR_FACE_LEFT] = {.middle = {x, left}, .normal = {0, 1}, .left = front - x},
        [CR_FACE_REAR] = {.middle = {rear, y}, .normal = {-1, 0}, .left = left - y},
        [CR_FACE_RIGHT] = {.middle = {x, right}, .normal = {0, -1}, .left = front - x},
    };
    bool endless = f.endless;
    f = all[side];
    f.right = f.left;
    f.endless = endless;
    return f;
}

/* Offset of the part's centre line along the face, positive to the left of the struck participant
 * (front, rear) or to its front (flanks). */
static enum cr_err offset_of(const struct cr_place *how, const struct face *f, double half,
                             double front, double *offset, struct cr_error *err) {
    bool flank = how->side == CR_FACE_LEFT || how->side == CR_FACE_RIGHT;
    *offset = 0;
    if (flank) {
        *offset = front - f->middle.x - how->along;
        return CR_ERR_OK;
    }
    if (!(how->overlap > 0 && how->overlap <= 1)) {
        return cr_err_set(err, CR_ERR_RANGE, "overlap must be above 0 and up to 100 %%, got %g %%",
                          100 * how->overlap);
    }
    if (how->overlap_side == 0 || f->endless) {
        if (how->overlap < 1) {
            cr_err_set(err, CR_ERR_RANGE, "overlap of %g %% has no side", 100 * how->overlap);
            cr_err_hint(err, f->endless ? "a wall has no edge; use a box"
                                        : "say which side is met, left or right");
            return CR_ERR_RANGE;
        }
        return CR_ERR_OK;
    }
    /* the band of the part begins where the overlap ends, counted from the struck one's edge */
    *offset = how->overlap_side * (f->left - how->overlap * f->counted + half);
    return CR_ERR_OK;
}

struct pose {
    struct cr_vec2 pos;
    double heading;
};

/* Pose of the part before it is brought together: far off along the normal, centre line on the
 * offset, nose towards the face (beside: parallel), turned about the point it would touch. */
static struct pose align(const struct cr_place *how, const struct face *f, const struct hull *part,
                         double offset, double far_off) {
    struct pose pose;
    double front, rear, left, right;
    extent(part, &front, &rear, &left, &right);
    bool flank = how->side == CR_FACE_LEFT || how->side == CR_FACE_RIGHT;
    struct cr_vec2 along = flank ? cr_vec2(1, 0) : cr_vec2(0, 1);
    struct cr_vec2 touch = cr_vec2_axpy(f->middle, offset, along), origin;
    double to_face = cr_atan2(-f->normal.y, -f->normal.x);
    if (how->rel == CR_PLACE_BESIDE) {
        /* flank to flank, fronts `along` apart */
        bool on_left = how->side == CR_FACE_LEFT;
        origin = cr_vec2(touch.x - front, touch.y + (on_left ? -right : -left));
        pose.heading = 0;
    } else {
        origin = cr_vec2_axpy(touch, front, f->normal);
        pose.heading = to_face;
    }
    struct cr_vec2 arm = cr_vec2_sub(origin, touch);
    origin = cr_vec2_add(touch, cr_vec2_turn(arm, how->angle));
    pose.pos = cr_vec2_axpy(origin, far_off, f->normal);
    pose.heading += how->angle;
    return pose;
}

static enum cr_err check_known(const struct cr_participant *p, const struct hull *h,
                               struct cr_error *err) {
    if (h->n > 0 && isfinite(h->radius)) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_MISSING, "\"%s\" has no dimensions yet", p->id);
    cr_err_hint(err, "give its type, mass and size first");
    return CR_ERR_MISSING;
}

/* the side that a relation means by itself */
static struct cr_place normal_form(const struct cr_place *how) {
    struct cr_place out = *how;
    if (how->rel == CR_PLACE_FACING) {
        out.side = CR_FACE_FRONT;
    } else if (how->rel == CR_PLACE_BEHIND) {
        out.side = CR_FACE_REAR;
    } else if (how->rel == CR_PLACE_BESIDE && how->side != CR_FACE_RIGHT) {
        out.side = CR_FACE_LEFT;
    }
    return out;
}

static void give(struct cr_participant *p, const char *name, bool given) {
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_PARTICIPANT, &n);
    const struct cr_key *key = cr_scene_key_find(CR_KEYS_PARTICIPANT, name, CR_FOR_ALL);
    uint64_t bit = (uint64_t)1 << (key - row);
    p->given = given ? p->given | bit : p->given & ~bit;
}

/* a number of degrees, so that a file keeps it to the last bit */
static double whole_degrees(double angle) {
    const struct cr_unit *deg = cr_unit_find("deg", CR_DIM_ANGLE);
    return cr_unit_to_si(deg, cr_unit_from_si(deg, cr_angle_wrap(angle)));
}

void cr_scene_pose(struct cr_participant *p, struct cr_vec2 pos, double heading) {
    give(p, "position_m", true);
    give(p, "heading_deg", true);
    give(p, "trajectory", false);
    free(p->waypoint);
    p->waypoint = NULL;
    p->waypoints = 0;
    p->pos = pos;
    p->heading = whole_degrees(heading);
}

void cr_scene_course(struct cr_participant *p, double course) {
    give(p, "course_deg", true);
    p->course = whole_degrees(course);
}

static enum cr_err check_wish(const struct cr_participant *p, const struct cr_participant *o,
                              const struct cr_place *how, struct cr_error *err) {
    if (p == o) {
        return cr_err_set(err, CR_ERR_NAME, "\"%s\" cannot be placed against itself", p->id);
    }
    if (!(how->gap >= 0) || !isfinite(how->gap)) {
        return cr_err_set(err, CR_ERR_RANGE, "gap must be 0 m or more, got %g m", how->gap);
    }
    if (!isfinite(how->angle) || !isfinite(how->along)) {
        return cr_err_set(err, CR_ERR_RANGE, "angle and place along the side must be finite");
    }
    return CR_ERR_OK;
}

/* Pose of the hull `mine` in the frame of the other participant. */
static enum cr_err find_pose(const struct cr_participant *other, const struct hull *mine,
                             const struct hull *theirs, const struct cr_place *how,
                             struct pose *pose, struct cr_error *err) {
    double front, rear, left, right, offset, moved;
    struct face f = face_of(other, theirs, how->side);
    extent(mine, &front, &rear, &left, &right);
    double half = (left - right) / 2, size = cr_vec2_len(cr_vec2(front - rear, left - right));
    f.counted = 2 * (theirs->barrier ? half : mine->barrier ? f.left : fmin(half, f.left));
    extent(theirs, &front, &rear, &left, &right);
    enum cr_err code = offset_of(how, &f, half, front, &offset, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    double far_off = 2 * (size + cr_vec2_len(cr_vec2(front - rear, left - right))) + how->gap;
    *pose = align(how, &f, mine, offset, far_off);
    struct hull there = hull_at(mine, pose->pos, pose->heading);
    struct cr_vec2 to = cr_vec2_scale(f.normal, -1);
    if (!bring_together(there, theirs, to, how->gap, far_off, &moved)) {
        cr_err_set(err, CR_ERR_RANGE, "placed like this it passes \"%s\" by", other->id);
        cr_err_hint(err, "change the overlap, or where along the side it hits");
        return CR_ERR_RANGE;
    }
    pose->pos = cr_vec2_axpy(pose->pos, moved, to);
    return CR_ERR_OK;
}

enum cr_err cr_scene_place(struct cr_scene *scene, const char *id, const char *other,
                           const struct cr_place *how, struct cr_error *err) {
    struct cr_participant *p = cr_scene_find(scene, id), *o = cr_scene_find(scene, other);
    if (p == NULL || o == NULL) {
        return cr_scene_unknown_id(scene, p == NULL ? id : other, err);
    }
    struct cr_place wish = normal_form(how);
    struct hull mine, theirs;
    struct pose pose;
    hull_of(p, &mine);
    hull_of(o, &theirs);
    enum cr_err code = check_wish(p, o, &wish, err);
    if (code == CR_ERR_OK) {
        code = check_known(p, &mine, err);
    }
    if (code == CR_ERR_OK) {
        code = check_known(o, &theirs, err);
    }
    if (code == CR_ERR_OK) {
        code = find_pose(o, &mine, &theirs, &wish, &pose, err);
    }
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_scene_pose(p, cr_vec2_add(o->pos, cr_vec2_turn(pose.pos, o->heading)),
                  o->heading + pose.heading);
    return CR_ERR_OK;
}
