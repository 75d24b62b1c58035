/* State of a running solve: the bodies while they move, the contact of each pair, the records. */
#ifndef CR_SOLVER_STATE_H
#define CR_SOLVER_STATE_H

#include "base/arena.h"
#include "solver/case.h"
#include "solver/solver.h"
#include "solver/surface.h"

#include <stddef.h>

enum { CR_PAIR_MAX = CR_BODY_MAX * (CR_BODY_MAX - 1) / 2 };

/* What changes of a body while the solve runs. */
struct cr_moving {
    const struct cr_body *body;
    struct cr_vec2 pos, vel;
    double heading, yaw_rate;
    double c, s; /* cosine and sine of the heading */
    double inv_mass, inv_inertia;
    double reach;          /* radius about the CG that holds the body, m; a wall: infinite */
    struct cr_vec2 lo, hi; /* box that holds it, body frame */
    bool driven;           /* follows its waypoints */
    bool at_rest;
    bool soft;                 /* it has voxels; else it is a rigid shape */
    struct cr_surface surface; /* of a soft body */
    /* energy per unit of material against each partner by the way it is pushed, J */
    const double *unit[CR_BODY_MAX][CR_PUSHES];
    bool drag[CR_WHEELS];         /* the wheel's place was crushed: it slides */
    double energy, induced;       /* plastic so far, J */
    double crushed;               /* plan area so far, m2 */
    struct cr_vec2 slice_impulse; /* contact impulse in this slice, N s */
    struct cr_vec2 slice_coe;     /* its |impulse|-weighted place, summed, N s m */
    double slice_weight;          /* sum of |impulse|, N s */
    struct cr_vec2 vel_begin;     /* at the begin of the slice */
    double yaw_begin;
    struct cr_vec2 delta_v;
    double yaw_change;
    struct cr_vec2 impulse;
    double t_first, t_last, t_rest;
};

/* The opponent as the voxels of a body see it in a slice. */
struct cr_opponent {
    const struct cr_moving *m;
    struct cr_vec2 origin; /* of the body's frame in the opponent's, m */
    double c, s;           /* turn from the body's frame into the opponent's */
    struct cr_vec2 still;  /* velocity of the opponent's material at the body's origin, less that of
                              the body's, body frame, m/s */
    double turn;           /* yaw rate of the opponent less the body's, rad/s */
    double dt;             /* of the slice, s */
};

/* A voxel near the contact, as the overlap finds it. */
struct cr_cell {
    int voxel, at;        /* index into the grid, and into surface.phi */
    struct cr_vec2 place; /* its middle, body frame, m */
    double phi;           /* of the body's own surface, m */
    double other;         /* of the opponent's, if both give half of the way, m */
    double bend;          /* by which that is less, per share of the way more, m */
    double closed;        /* by which the opponent's has become less in the slice, m */
    double overlap, most; /* by which the two have come to overlap there in the slice, at half of
                             the way each, and by which they can at most, m */
    struct cr_vec2
        normal;      /* outward of the face that the opponent strikes with, body frame, unit */
    double next;     /* scratch: phi to come, m */
    bool core;       /* near the two surfaces; else it only follows the voxels that are */
    bool leaves;     /* the opponent moves away from it, not into it nor along it */
    double approach; /* of the opponent along that normal, m/s */
    double strength; /* force that crushes the voxel over its whole edge, N */
    double met;      /* share of it with which it presses in this slice, 0..1 */
};

/* What a voxel loses in a slice. */
struct cr_loss {
    int voxel, at;
    double amount; /* material */
    double moved;  /* rise of phi, m */
};

/* Step 1 for one body of a pair in one slice. */
struct cr_side {
    struct cr_moving *m;
    struct cr_opponent opponent;
    const double *const *unit; /* of m against the opponent, [CR_PUSHES] */
    struct cr_vec2 push;       /* unit vector along which the opponent pushes, body frame */
    int cells, cells_size;
    struct cr_cell *cell;
    int losses, losses_size;
    struct cr_loss *loss; /* the first `direct` are of the contact, the others dragged along */
    int direct;
    double share;      /* of the overlap that this body gives way by, 0..1 */
    double begin, end; /* force of its structure in the contact now, and if it alone gives way, N */
    double thick;      /* sum of force x overlap, N m */
    double advance;    /* of the contact into this body in the slice, mean, m */
    double energy, induced; /* of the losses, J */
    double area;            /* plan area lost, m2 */
    struct cr_vec2
        pressure;          /* on this body: strength along the opponent's normals, body frame, N */
    struct cr_vec2 moment; /* sum of strength x place, N m */
    double weight;         /* sum of strength, N */
};

/* To what depth a line of a face is held, behind the edge of the grid, m; how far what holds it
 * looks at the face, 0..1; and how far away along the face that is, m. */
struct cr_hold {
    double depth, in, away;
};

/* What holds a line: the contact itself, the line before and the line behind it. */
struct cr_line {
    struct cr_hold own, tow[2];
    double pressed; /* share of the line's width that the contact presses on */
};

/* A contact being worked: the record that is reported and what only the solver needs. */
struct cr_touch {
    int record;         /* index into solver.contact, -1: never touched or over */
    int last;           /* index of its last contact, where before */
    double quiet;       /* time since it last deformed something, s */
    struct cr_vec2 coe; /* carried along with the bodies between slices */
    struct cr_vec2 normal, direction;
    bool sliding;             /* force on the edge of the friction cone */
    double taut[2];           /* force of what the contact drags along, a and b, N */
    double spent;             /* crush energy of the pair's contacts that are over, J */
    struct cr_vec2 met_at;    /* velocity of a against b at the COE when they met, m/s */
    double work, slight;      /* that this touch has taken, and up to which it only rubs, J */
    bool rubbing;             /* so far it is too slight to count as part of the crash */
    struct cr_vec2 struck[2]; /* where the pair last touched in earnest, frames of a and b, m */
    double force;             /* along direction at the end of the plastic phase, N */
    double force_level, level_weight; /* the same without the ripple of the voxels, N, and how
                                         much of its stretch has been, 0..1 */
    double force_sum;                 /* sum of plastic impulse x force, N2 s */
    double plastic_before;     /* plastic impulse of earlier touches of the same contact, N s */
    double slip;               /* against the tangential force when the elastic phases began, m/s */
    double rubbed;             /* work of the tangential force in the elastic phases so far, J */
    double elastic_time;       /* length of the elastic phase, s */
    double elastic_left;       /* what is left of it, s */
    double elastic_done;       /* impulse it has given so far, N s */
    struct cr_vec2 moment_coe; /* sum of impulse x COE */
    double moment_weight;
    struct cr_vec2 normal_sum; /* energy-weighted, J */
};

struct cr_solver {
    const struct cr_case *cs;
    struct cr_arena arena;
    struct cr_moving m[CR_BODY_MAX];
    struct cr_side side[2]; /* of the pair being worked */
    struct cr_line *line;   /* scratch of drag.c: [2][CR_FACES][longest] */
    int longest;            /* lines of the longest face */
    struct cr_touch touch[CR_PAIR_MAX];
    int met[CR_PAIR_MAX]; /* 1 + the slice of its first contact, 0: none so far */
    double t, dt, dt_contact;
    bool touched;    /* some contact has begun */
    bool backwards;  /* pairs are worked from the last in this slice */
    double t_free;   /* since when nothing is in contact, s; NaN while something is */
    double t_look;   /* when to look ahead for another touch, s */
    double t_struck; /* last time anything was in contact, rubbing apart, s */
    bool done;
    /* records, grown on the heap */
    struct cr_contact *contact;
    int contacts, contacts_size;
    double *times;
    struct cr_sample *trace;
    int samples, samples_size;
    struct cr_slice *slice;
    int slices, slices_size;
    /* ledger since first contact */
    double kinetic_before, scale_p, scale_l;
    struct cr_vec2 p_before, p_ground;
    double l_before, l_ground;
    double friction, tyre;
    long visits, deformed;
    struct cr_sample before[CR_BODY_MAX];
    struct cr_freed *freed; /* as it was when the last contact ended */
    struct cr_solution out;
};

/* A solver to go back to, but for the surfaces, which keep their own, and arrays that only grow. */
struct cr_freed {
    struct cr_solver s;
    struct cr_contact last[CR_PAIR_MAX]; /* of each pair */
};

/* Energy per unit of material of a voxel that is pushed along d, a unit vector in the body's frame,
 * J: the two strengths in series, the weaker gives way first. */
static inline double cr_unit_energy(const struct cr_side *k, int voxel, struct cr_vec2 d) {
    double along = k->unit[d.x < 0 ? CR_PUSH_REARWARD : CR_PUSH_FORWARD][voxel];
    double across = k->unit[CR_PUSH_SIDEWAYS][voxel], x2 = d.x * d.x, y2 = d.y * d.y;
    if (y2 < 1e-9 || along == across) {
        return along;
    }
    double sum = x2 * across + y2 * along;
    return x2 < 1e-9 ? across : sum > 0 ? along * across / sum : 0;
}

/* by how much the two have come to overlap at a voxel whose body gives a share of the way, m */
static inline double cr_overlap_at(const struct cr_cell *c, double share) {
    return cr_clamp(c->bend * (0.5 - share) - (c->phi + c->other), 0, c->most);
}

/* A pair of bodies a < b and its contact, made once a pair and slice. */
struct cr_duo {
    struct cr_solver *s;
    int a, b, pair;
    struct cr_moving *ma, *mb;
    struct cr_touch *touch;
};

/* index of the pair of bodies a < b */
static inline int cr_pair(const struct cr_solver *s, int a, int b) {
    return a * s->cs->n - a * (a + 1) / 2 + b - a - 1;
}
static inline struct cr_duo cr_duo(struct cr_solver *s, int a, int b) {
    int pair = cr_pair(s, a, b);
    return (struct cr_duo){s, a, b, pair, &s->m[a], &s->m[b], &s->touch[pair]};
}
static inline struct cr_vec2 cr_to_world(const struct cr_moving *m, struct cr_vec2 p) {
    return cr_vec2_add(m->pos, cr_vec2_rotate(p, m->c, m->s));
}
static inline struct cr_vec2 cr_to_body(const struct cr_moving *m, struct cr_vec2 p) {
    return cr_vec2_unrotate(cr_vec2_sub(p, m->pos), m->c, m->s);
}
/* velocity of the body's material at a world point */
static inline struct cr_vec2 cr_velocity_at(const struct cr_moving *m, struct cr_vec2 p) {
    struct cr_vec2 r = cr_vec2_sub(p, m->pos);
    return cr_vec2_axpy(m->vel, m->yaw_rate, cr_vec2_perp(r));
}
/* of a's material against b's at a world point */
static inline struct cr_vec2 cr_relative_velocity(const struct cr_duo *d, struct cr_vec2 p) {
    return cr_vec2_sub(cr_velocity_at(d->ma, p), cr_velocity_at(d->mb, p));
}

#endif
