/* Step 1, induced deformation: a struck face drags along what lies beside the contact.
 *
 * The depth w of a face, along its lines, falls by no more than k a + c a^2 at the distance a from
 * what the contact holds: w[i] >= w[j] - k a - c a^2 - (o[i] - o[j])+, a = |y[i] - y[j]|, o being
 * how far the undeformed outline of a line lies back: a wall on a rounded front drags nothing.
 * A flank is stretched, by the slope k; the beam of an end is bent, by c. Where the surface of the
 * contact itself recedes with the slope s, the limit is k + s: a corner that is driven on obliquely
 * does not drag the flank. The least such depths come from a walk up and a walk down the lines from
 * each that the contact holds. A stamp of the width b on a uniform face q: E = q (b d + d^2 / k)
 * where it is stretched, q (b d + 4/3 d sqrt(d / c)) where it is bent. */
#include "solver/crush.h"
#include "solver/tuning.h"

/* One face while it is dragged. */
struct face {
    struct cr_side *k;
    enum cr_face face;
    struct cr_lines lines;
    double lean[2]; /* slope of the contact where it recedes towards the last and the next line */
    double faces;   /* how far the force is on this face, 0..1 */
    double in;      /* cosine of the force with the way inward */
    bool held;      /* the contact holds any line */
    struct cr_line *line;
};

/* Slope of the structure at a depth, at the distance `away` from what holds it, between the lines i
 * and i + 1. Behind its front an engine is pushed along as one. */
static double slope_at(const struct face *f, int i, double depth, double away) {
    const struct cr_grid *g = f->k->m->surface.grid;
    double k = g->drag_slope[f->face] + 2 * g->drag_bend[f->face] * away;
    double block = g->block[f->face];
    double out = fabs(2.0 * (i + 1) / f->lines.n - 1);
    if (cr_face_is_end(f->face) && out > cr_rails_share) {
        return cr_max(k, cr_beyond_rails);
    }
    return block > 0 ? k * (1 - cr_clamp((depth - block) / cr_block_rise, 0, 1)) : k;
}

/* The hold one step up or down the face from another, a part of the way between the lines i and
 * i + 1: how the contact recedes that way, and the structure. */
static struct cr_hold step(const struct face *f, bool up, int i, struct cr_hold held, double part) {
    double way = part * f->k->m->surface.grid->h;
    double slope = f->lean[up] + slope_at(f, i, held.depth, held.away + way / 2) / held.in;
    return (struct cr_hold){held.depth - slope * way, held.in, held.away + way};
}

/* How deep a place lies below the undeformed outline of the body, m. */
static double rest_depth(const struct cr_surface *s, struct cr_vec2 place) {
    const struct cr_grid *g = s->grid;
    double x = place.x - g->x0, y = place.y - g->y0, per = 1 / g->h;
    int column = (int)cr_clamp(x * per, 0, g->nx - 1), row = (int)cr_clamp(y * per, 0, g->ny - 1);
    double along = cr_min(g->nx * g->h - x - s->outline[CR_FACE_FRONT][row],
                          x - s->outline[CR_FACE_REAR][row]);
    double across = cr_min(g->ny * g->h - y - s->outline[CR_FACE_LEFT][column],
                           y - s->outline[CR_FACE_RIGHT][column]);
    return cr_min(along, across);
}

/* Of two that hold a line at one depth, as all do behind an engine, the nearer one holds it. */
static void deepen(struct cr_hold *l, struct cr_hold by) {
    double more = by.depth - l->depth;
    if (more > cr_one_depth || (more > -cr_one_depth && by.away < l->away)) {
        *l = by;
    }
}

/* How far the lines about a place are open, in voxels: the nearest two, and those beside them as
 * far as they are near. A line that the opponent covers in part is never emptied, but one beside it
 * is. */
static double open_about(const struct face *f, double at) {
    const int *first = f->k->m->surface.first[f->face];
    int last = f->lines.n - 1, i = (int)cr_clamp(at, 0, last - 1);
    double u = cr_clamp(at - i, 0, 1), open = first[i] > first[i + 1] ? first[i] : first[i + 1];
    double before = i > 0 ? first[i - 1] - open : 0;
    double after = i + 2 <= last ? first[i + 2] - open : 0;
    return open + cr_max(cr_max((1 - u) * before, u * after), 0);
}

/* What a place holds of the two lines that follow it up or down the face. The further the first
 * lies, the more the second is held as the first would tow it: a place between two lines is on
 * neither, and one upon a line holds both of its neighbours. */
static void hold_side(struct face *f, bool up, double at, struct cr_hold held) {
    const double *o = f->k->m->surface.outline[f->face];
    double far = 0;
    int i = (int)cr_clamp(floor(at) + up, 0, f->lines.n - 1);
    double off = up ? i - at : at - i;
    for (int n = 0; n < 2 && off >= 0 && i >= 0 && i < f->lines.n; n++) {
        held = step(f, up, up ? i - 1 : i, held, n == 0 ? off : 1);
        held.depth -= far;
        /* the contact itself is not on a line beside it */
        deepen(n > 0 || off > cr_beside ? &f->line[i].tow[up] : &f->line[i].own, held);
        int next = up ? i + 1 : i - 1;
        far = next >= 0 && next < f->lines.n ? cr_min(off, 1) * cr_max(o[i] - o[next], 0) : 0;
        i = next;
    }
}

/* What holds the lines of a face about a place of the contact's surface, `rest` below the
 * undeformed outline. A place of the surface belongs to the face that it looks at, unless it is
 * much closer to another: the side of a dent in an end is no dent of the flank. One behind
 * material that still stands in its line holds nothing. */
static void hold(struct face *f, struct cr_vec2 place, double rest) {
    const struct cr_surface *s = &f->k->m->surface;
    struct cr_vec2 r = cr_vec2_sub(place, f->lines.corner);
    double h = s->grid->h, deep = cr_vec2_dot(r, f->lines.in);
    double faces = f->faces * cr_clamp(2 - deep / (cr_other_face * cr_max(rest, h)), 0, 1);
    if (!(faces > 0)) {
        return;
    }
    double at = cr_vec2_dot(r, f->lines.along) / h - 0.5;
    double hidden = cr_max(deep - (open_about(f, at) + cr_hidden_voxels) * h, 0);
    for (int up = 0; up < 2; up++) {
        hold_side(f, up, at, (struct cr_hold){deep - 2 * hidden, faces, 0});
    }
    f->held = true;
}

static void hold_faces(struct face face[CR_FACES], struct cr_vec2 place) {
    double rest = rest_depth(&face[0].k->m->surface, place);
    for (int f = 0; f < CR_FACES; f++) {
        if (face[f].faces > 0) {
            hold(&face[f], place, rest);
        }
    }
}

/* The edge of the opponent's surface if one lies within a voxel of a place on it: a voxel's depth
 * inside the opponent it is that close to another of its sides. */
static bool edge_near(const struct cr_side *k, struct cr_vec2 place, struct cr_vec2 n,
                      struct cr_vec2 *edge) {
    double h = k->m->surface.grid->h;
    struct cr_vec2 inside = cr_vec2_axpy(place, -h, n);
    double room = -cr_overlap_distance(k, inside);
    if (!(room > 0 && room < h)) {
        return false;
    }
    struct cr_vec2 out = cr_overlap_normal(k, inside);
    struct cr_vec2 aside = cr_vec2_axpy(out, -cr_vec2_dot(out, n), n);
    double off = cr_vec2_len(aside);
    /* the other side is one only as far as its normal turns away from n */
    *edge = cr_vec2_axpy(place, room * cr_min(off, 1) / cr_max(off, 1e-9), aside);
    return true;
}

/* how much of the width of its line a voxel presses on */
static void press_on(struct face *f, const struct cr_cell *c, double h) {
    double at = cr_vec2_dot(cr_vec2_sub(c->place, f->lines.corner), f->lines.along);
    int line = (int)cr_clamp(at / h, 0, f->lines.n - 1);
    f->line[line].pressed += c->met * cr_surface_weight(c->other, h);
}

/* the places on the surface of the contact, and its edges */
static void hold_all(const struct cr_side *k, struct face face[CR_FACES]) {
    const struct cr_surface *s = &k->m->surface;
    double h = s->grid->h;
    for (int i = 0; i < k->cells; i++) {
        const struct cr_cell *c = &k->cell[i];
        double phi = s->phi[c->at];
        if (!(c->met > 0)) {
            continue;
        }
        for (int f = 0; f < CR_FACES; f++) {
            if (face[f].faces > 0) {
                press_on(&face[f], c, h);
            }
        }
        if (fabs(phi) < h) {
            struct cr_vec2 place = cr_vec2_axpy(c->place, phi, c->normal), edge;
            hold_faces(face, place);
            if (edge_near(k, place, c->normal, &edge)) {
                hold_faces(face, edge);
            }
        }
    }
}

/* A walk up or down the lines from what holds one of them. Who is nearer falls off less from there
 * on, so it ends where the contact itself, or what is nearer, holds a line deeper. */
static void walk(const struct face *f, bool up, int i, struct cr_hold from) {
    const double *o = f->k->m->surface.outline[f->face];
    while (from.depth > 0 && (up ? i + 1 < f->lines.n : i > 0)) {
        int next = up ? i + 1 : i - 1;
        struct cr_line *l = &f->line[next];
        from = step(f, up, up ? i : next, from, 1);
        from.depth -= cr_max(o[i] - o[next], 0);
        if (from.depth <= cr_max(l->own.depth, l->tow[up].depth) + cr_one_depth) {
            return;
        }
        l->tow[up] = from;
        i = next;
    }
}

/* What tows each line, of all that the contact holds. The nearest walks first, and nothing tows
 * itself. */
static void tow_lines(const struct face *f, bool up) {
    for (int n = 0; n < f->lines.n; n++) {
        int i = up ? f->lines.n - 1 - n : n;
        walk(f, up, i, f->line[i].tow[up]);
        walk(f, up, i, f->line[i].own);
    }
}

/* the voxels of a line down to a depth of a surface that slants with the slope k */
static bool crush_line(struct face *f, int line, double depth, double k) {
    struct cr_surface *s = &f->k->m->surface;
    double h = s->grid->h, open = depth - s->outline[f->face][line];
    double wide = cr_min(1 + k, 1 + 2 * open / h), lean = wide - 1,
           steep = 1 / sqrt(1 + lean * lean);
    struct cr_vec2 n = cr_vec2_scale(cr_vec2_axpy(f->lines.in, lean, f->lines.along), steep);
    for (int i = s->first[f->face][line]; i < f->lines.length; i++) {
        double phi = (depth - (i + 0.5) * h) * steep;
        if (phi < -2 * h) {
            break;
        }
        int voxel = f->lines.first + line * f->lines.next + i * f->lines.inward;
        int at = cr_surface_at(s, voxel % s->grid->nx, voxel / s->grid->nx);
        if (!cr_crush_voxel(f->k, voxel, at, phi, n, f->lines.in)) {
            return false;
        }
    }
    return true;
}

/* force with which a line resists at a depth, N */
static double strength_of(const struct face *f, int line, double depth) {
    const struct cr_surface *s = &f->k->m->surface;
    double n = depth / s->grid->h - 0.5;
    int i = (int)cr_clamp(floor(n), 0, f->lines.length - 2);
    double u = cr_clamp(n - i, 0, 1);
    int k = f->lines.first + line * f->lines.next + i * f->lines.inward, next = k + f->lines.inward;
    double here = cr_unit_energy(f->k, k, f->lines.in) * s->dense[k];
    double there = cr_unit_energy(f->k, next, f->lines.in) * s->dense[next];
    return (here + u * (there - here)) / s->grid->h;
}

/* Lines that are dragged to their limit pull on the contact, as far as it does not press on them
 * itself: what of a line is taut, and how far. */
static void pull_line(struct cr_duo *d, int side, struct face *f, int line, double tow,
                      double pressed) {
    const struct cr_surface *s = &f->k->m->surface;
    double slack = (s->limit[f->face][line] - tow) / s->grid->h;
    double taut = cr_clamp(1 - slack, 0, 1) * cr_max(1 - pressed, 0);
    d->touch->taut[side] += taut * strength_of(f, line, tow);
}

/* Is the force on a face that drags anything along? */
static struct face face_of(struct cr_side *k, enum cr_face face, struct cr_line *line) {
    const struct cr_surface *s = &k->m->surface;
    struct face f = {.k = k, .face = face, .lines = s->lines[face], .line = line};
    struct cr_vec2 n = cr_vec2_unit(k->pressure, cr_vec2(0, 0));
    double aside = cr_vec2_dot(n, f.lines.along);
    f.in = cr_vec2_dot(n, f.lines.in);
    bool drags = s->grid->drag_slope[face] + s->grid->drag_bend[face] > 0 && f.lines.n > 1;
    double looks = (f.in - cr_drags_none) / (cr_drags_whole - cr_drags_none);
    f.faces = drags ? cr_clamp(looks, 0, 1) : 0;
    if (f.faces > 0) {
        f.lean[0] = cr_max(-aside, 0) / f.in;
        f.lean[1] = cr_max(aside, 0) / f.in;
    }
    return f;
}

/* What the contact holds of the faces of a body, and what tows each of their lines; nothing is
 * crushed yet. */
static void find_tow(struct cr_side *k, struct face face[CR_FACES], struct cr_line *line,
                     int longest) {
    bool any = false;
    for (int f = 0; f < CR_FACES; f++, line += longest) {
        face[f] = face_of(k, f, line);
        any = any || face[f].faces > 0;
        for (int i = 0; i < face[f].lines.n && face[f].faces > 0; i++) {
            const struct cr_hold none = {-INFINITY, 1, 0};
            line[i] = (struct cr_line){.own = none, .tow = {none, none}};
        }
    }
    if (!any) {
        return;
    }
    hold_all(k, face);
    for (int f = 0; f < CR_FACES; f++) {
        if (face[f].held) {
            tow_lines(&face[f], true);
            tow_lines(&face[f], false);
        }
    }
}

/* A line that is towed deeper than the contact itself holds it comes along with the contact, and
 * hardly faster. */
static bool tow_face(struct cr_duo *d, int side, struct face *f) {
    struct cr_side *k = f->k;
    const struct cr_surface *s = &k->m->surface;
    double way = cr_pass_most * k->advance / f->in;
    for (int i = 0; i < f->lines.n; i++) {
        const struct cr_line *l = &f->line[i];
        bool up = l->tow[1].depth >= l->tow[0].depth; /* from which side it is towed most */
        double *limit = &s->limit[f->face][i], tow = l->tow[up].depth;
        if (!(tow > s->outline[f->face][i])) {
            continue;
        }
        if (tow > l->own.depth + cr_one_depth) {
            tow = cr_min(tow, cr_max(*limit, s->first[f->face][i] * s->grid->h) + way);
            *limit = cr_max(*limit, tow);
            if (!crush_line(f, i, tow, slope_at(f, up ? i - 1 : i, tow, l->tow[up].away))) {
                return false;
            }
        }
        pull_line(d, side, f, i, tow, l->pressed);
    }
    return true;
}

bool cr_drag_along(struct cr_duo *d) {
    struct face face[2][CR_FACES] = {0};
    /* all are looked at before any is crushed: the order of bodies and faces does not matter */
    for (int side = 0; side < 2; side++) {
        struct cr_side *k = &d->s->side[side];
        if (k->m->soft && k->cells > 0) {
            find_tow(k, face[side], d->s->line + side * CR_FACES * d->s->longest, d->s->longest);
        }
    }
    for (int side = 0; side < 2; side++) {
        struct cr_side *k = &d->s->side[side];
        double before = k->energy;
        d->touch->taut[side] = 0;
        for (int f = 0; f < CR_FACES; f++) {
            if (face[side][f].held && !tow_face(d, side, &face[side][f])) {
                return false;
            }
        }
        k->induced += k->energy - before;
    }
    return true;
}
