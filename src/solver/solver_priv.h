/* State of a running solve and the steps that work on it. Private to src/solver. */
#ifndef CR_SOLVER_PRIV_H
#define CR_SOLVER_PRIV_H

#include "base/arena.h"
#include "solver/solver.h"

#include <stddef.h>

enum { CR_PAIR_MAX = CR_BODY_MAX * (CR_BODY_MAX - 1) / 2 };

/* Live part of a line of voxels: [lo, hi) can still hold material. */
struct cr_span {
    int lo, hi;
};

/* A part of the lines of a face; line i fills [i - 0.5, i + 0.5]. */
struct cr_range {
    double lo, hi;
};

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
    int wheel_voxel[CR_WHEELS]; /* at the wheel's place, -1: beside the grid */
    bool drag[CR_WHEELS];       /* that was crushed: the wheel slides */
    /* grid, NULL for rigid shapes */
    double *left;                    /* material left, 0..fill */
    double *t_sum;                   /* sum of time x material lost: gives t_crushed */
    uint8_t *how;                    /* enum cr_crush flags */
    const double *unit[CR_BODY_MAX]; /* energy per unit of material against each partner, J */
    bool solid[CR_BODY_MAX];         /* all material has energy against it */
    struct cr_span *row, *col;       /* live span of each row (along x) and column (along y) */
    struct cr_span rows, cols;       /* rows and columns between which there is material */
    /* [k + 2]: part of the lines k and k + 1 that has live material within one voxel */
    struct cr_range *between_rows, *between_cols;
    double *depth[CR_FACES];         /* crush of each line of a face, m: rows for front and
                                        rear, columns for left and right */
    double *outline[CR_FACES];       /* undeformed surface behind the foremost one, m */
    double *pitch[CR_FACES];         /* depth of a line per unit of material, m: more than a voxel's
                                        edge at the sides, where voxels are filled in part */
    struct cr_span dented[CR_FACES]; /* lines that have lost material, both ends included */
    double energy, induced;          /* plastic so far, J */
    double crushed;                  /* plan area so far, m2 */
    struct cr_vec2 slice_impulse;    /* contact impulse in this slice, N s */
    struct cr_vec2 slice_coe;        /* its |impulse|-weighted place, summed */
    double slice_weight;
    struct cr_vec2 vel_begin; /* at the begin of the slice */
    double yaw_begin;
    struct cr_vec2 delta_v;
    double yaw_change;
    struct cr_vec2 impulse;
    double t_first, t_last, t_rest;
};

/* One voxel that would lose material in this slice. */
struct cr_loss {
    int voxel, ix, iy;
    double amount; /* material, 0..1 */
    double energy; /* J */
    double before; /* scratch of yield.c: what the voxel held */
};

/* Losses of one body in one contact and slice. */
struct cr_losses {
    int n, size;
    struct cr_loss *loss;
    const double *unit;    /* energy per unit of material of the body's voxels, J */
    double energy;         /* of all, J */
    struct cr_vec2 first;  /* sum of energy x place of those in the contact, body frame, J m */
    struct cr_vec2 normal; /* what presses on the partner along its normals, its frame, N s */
    double induced;        /* part that is dragged along, J */
    double area;           /* m2 */
    enum cr_face face;     /* it acts on */
    double slant;          /* slope of the contact against that face */
    int contact;           /* the first losses are of contact, the rest induced */
};

/* Scratch of drag.c, one entry a line of the longest face. */
struct cr_drag {
    double *w, *own; /* depth, and that without what is dragged, m */
};

/* A contact being worked: the record that is reported and what only the solver needs. */
struct cr_touch {
    int record;         /* index into solver.contact, -1: never touched or over */
    int last;           /* index of its last contact, where before */
    double quiet;       /* time since it last deformed something, s */
    struct cr_vec2 coe; /* carried along with the bodies between slices */
    struct cr_vec2 normal, direction;
    enum cr_face face[2];      /* that the force acted on in the last slice, a's and b's */
    bool sliding;              /* force on the edge of the friction cone */
    double most;               /* greatest force, N: bodies that have crushed are sprung */
    double spent;              /* crush energy of the pair's contacts that are over, J */
    double restitution;        /* by closing speed and kind of partner */
    bool rubbing;              /* this touch is too slight to count as part of the crash */
    double force;              /* along direction, mean of the last plastic slices, N */
    double plastic_before;     /* plastic impulse of earlier touches of the same contact, N s */
    double slip;               /* against the tangential force when the elastic phases began, m/s */
    double rubbed;             /* work of the tangential force in the elastic phases so far, J */
    double elastic_time;       /* length of the elastic phase, s */
    double elastic_left;       /* what is left of it, s */
    double elastic_plan;       /* impulse the phase is to give, N s */
    double elastic_done;       /* impulse it has given so far, N s */
    struct cr_vec2 moment_coe; /* sum of impulse x COE */
    double moment_weight;
    struct cr_vec2 normal_sum; /* energy-weighted, J */
    double energy_recent;      /* of the last slices, older ones fading, J */
    struct cr_vec2 thrust;     /* of the last slices, older ones fading, N s */
};

struct cr_solver {
    const struct cr_case *cs;
    struct cr_arena arena;
    struct cr_moving m[CR_BODY_MAX];
    struct cr_losses losses[2]; /* of the pair being worked */
    struct cr_span *met;        /* scratch: voxels of each row that the opponent can meet */
    struct cr_drag drag;
    struct cr_touch touch[CR_PAIR_MAX];
    double t, dt, dt_contact;
    bool probing;    /* bodies are moved to see who would overlap: nothing is remembered */
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
    struct cr_snapshot *freed; /* as it was when the last contact ended */
    struct cr_solution out;
};

/* Kinematic state to go back to when nothing touched again. */
struct cr_snapshot {
    double t, tyre;
    int samples;
    struct cr_vec2 p_ground;
    double l_ground;
    struct {
        struct cr_vec2 pos, vel;
        double heading, yaw_rate;
    } m[CR_BODY_MAX];
};

/* index of the pair of bodies a < b */
static inline int cr_pair(const struct cr_solver *s, int a, int b) {
    return a * s->cs->n - a * (a + 1) / 2 + b - a - 1;
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

/* check.c: numbers, extents and options of a case; RANGE */
CR_MUST_CHECK enum cr_err cr_check_case(const struct cr_case *cs, struct cr_error *err);

/* start.c: takes off what touches at the start by less than outlines can tell; OVERLAP, MEMORY */
CR_MUST_CHECK enum cr_err cr_start_check(struct cr_solver *s, struct cr_error *err);
/* the first pair that overlaps by more, and the way out; leaves the bodies where they are */
bool cr_start_overlap(struct cr_solver *s, struct cr_overlap *out);

/* shape.c: signed distance (negative inside) and outward unit normal of an object, its frame */
double cr_shape_distance(const struct cr_shape *shape, struct cr_vec2 p, struct cr_vec2 *normal);
void cr_shape_box(const struct cr_shape *shape, struct cr_vec2 *lo, struct cr_vec2 *hi);

/* Place of a voxel of one body in another's frame: voxel (ix, iy) lies at
 * (u + c ix - s iy, v + s ix + c iy), in voxels from the centre of voxel (0,0) of a grid, in m for
 * a shape. */
struct cr_map {
    double u, v, c, s;
};

/* One coordinate of the opponent's grid at the voxels of me: at + per_row iy + slope ix. */
struct cr_course {
    double at, per_row, slope;
    double per_slope;   /* reciprocal, finite */
    double first, last; /* bounds of the opponent's material, as a row comes to them */
};

/* What of a body its opponent can meet at their present places. */
struct cr_reach {
    struct cr_map map;
    const struct cr_moving *me, *other;
    struct cr_span rows;    /* rows of me that the opponent's material covers */
    struct cr_course along; /* the opponent's lines, rows where the two are nearly aligned, columns
                               where they stand across, */
    struct cr_course across;
    const struct cr_range *between; /* and what is near material between them; NULL: a shape */
};

/* step 1, reach.c: ready once the live spans of all lines are known; false when memory is out */
bool cr_reach_new(struct cr_solver *s, struct cr_moving *m);
/* the live span of a row or column has shrunk */
void cr_reach_renew(struct cr_moving *m, bool row, int line);
void cr_reach_begin(struct cr_reach *reach, struct cr_moving *me, struct cr_moving *other);
/* voxels that the opponent can meet, of each of the rows; how many they are */
int cr_reach_rows(const struct cr_reach *reach, struct cr_span *met);

/* step 1, deform.c: losses of both bodies of a pair at their present places (nothing changes);
 * false when memory is out */
bool cr_deform_collect(struct cr_solver *s, int a, int b);
extern const double cr_crumb; /* material below this share of a voxel goes with the rest: */
static inline double cr_with_crumb(double left, double amount) {
    return left - amount < cr_crumb ? left : amount;
}
/* room for n more losses */
bool cr_losses_reserve(struct cr_losses *losses, int n);
/* take only a share of the losses */
void cr_deform_scale(struct cr_losses *losses, double share);
/* What a contact may crush more than it passes over in a slice: what has been left standing is made
 * up for, and no force is more than so many times strength times width. */
extern const double cr_deform_made_up;
/* Share of the losses, 0..1, that the contact's width passes over in this slice; the rest stays as
 * overlap, so that no slice has more force than strength times width. */
struct cr_force;
double cr_deform_bound(const struct cr_solver *s, int a, int b, const struct cr_force *f);
/* take the losses [from, n) out of the body; what is taken back is settled below */
void cr_deform_apply(struct cr_moving *m, const struct cr_losses *losses, int from);
/* give back the share 1 - lambda of the losses, and book the rest */
void cr_deform_settle(struct cr_solver *s, struct cr_moving *m, struct cr_losses *losses,
                      double lambda);

/* of losses of both bodies that hold all that has no room, what each has to give */
void cr_yield_share(struct cr_solver *s, int a, int b);
/* what is left of voxels that were hit before goes before the material behind them; false when
 * memory is out */
bool cr_yield_order(struct cr_moving *m, struct cr_losses *losses);

/* drag.c: the face that is crushed by a surface with the normal `inward` that approaches with the
 * velocity v relative to the body, world: the end where its motion along the body does more of the
 * work, else the flank. A corner that is driven on is no dent of the flank, however far the normal
 * has turned. */
enum cr_face cr_struck_face(const struct cr_moving *m, struct cr_vec2 inward, struct cr_vec2 v);
/* the struck face into losses, and how the contact slopes against it */
void cr_losses_turn(const struct cr_moving *m, struct cr_losses *losses, struct cr_vec2 inward,
                    struct cr_vec2 v);
/* energy of what the losses would drag along, J; nothing changes */
double cr_drag_energy(struct cr_solver *s, const struct cr_moving *m,
                      const struct cr_losses *losses);
/* induced deformation of losses->face, at most `most` m deep, added to the losses of one body and
 * applied; false when memory is out */
bool cr_drag_along(struct cr_solver *s, struct cr_moving *m, struct cr_losses *losses, double most);

/* step 2, force.c */
extern const double cr_force_memory;
struct cr_force {
    struct cr_vec2 coe;       /* Eq. (3) */
    struct cr_vec2 normal;    /* from a to b */
    struct cr_vec2 thrust;    /* what presses on the surfaces that it comes from, N s */
    struct cr_vec2 direction; /* of the force on b */
    double cosine;            /* between the two */
    double energy;            /* Eq. (1), J */
    bool sliding;
};
bool cr_force_find(struct cr_solver *s, int pair, int a, int b, struct cr_force *force);
/* energy and COE again once what is dragged along has added its losses */
void cr_force_update(struct cr_solver *s, int pair, int a, int b, struct cr_force *force);
double cr_force_friction(const struct cr_solver *s, int a, int b);
/* approach along the normal at the COE, m/s */
double cr_force_approach(const struct cr_solver *s, int a, int b, const struct cr_force *force);

/* step 3, kinetics.c */
struct cr_vec2 cr_relative_velocity(const struct cr_solver *s, int a, int b, struct cr_vec2 p);
/* change of the relative velocity at p per unit of impulse along f, both bodies */
struct cr_vec2 cr_compliance(const struct cr_solver *s, int a, int b, struct cr_vec2 p,
                             struct cr_vec2 f);
/* impulse along direction that ends the approach along the normal at p; infinite where an eccentric
 * force does not slow it */
double cr_impulse_left(const struct cr_solver *s, int a, int b, struct cr_vec2 coe,
                       struct cr_vec2 normal, struct cr_vec2 direction);
void cr_impulse_apply(struct cr_solver *s, int a, int b, struct cr_vec2 p, struct cr_vec2 impulse);
/* false when memory is out */
bool cr_kinetics_slice(struct cr_solver *s, int pair, int a, int b, const struct cr_force *force);
void cr_tyres_apply(struct cr_solver *s, int body); /* tyre.c */

/* step 4, kinematics.c */
void cr_kinematics_move(struct cr_solver *s);
void cr_kinematics_place(struct cr_moving *m, struct cr_vec2 pos, double heading);
double cr_kinematics_slice_length(const struct cr_solver *s);

/* step 5, abort.c: end of the plastic compression, and the longest slice until a phase ends */
void cr_abort_check(struct cr_solver *s, int pair, int a, int b, bool deformed);
double cr_abort_within(const struct cr_solver *s, int pair);

/* energy of approach of a touch against what the pair has crushed so far; infinite for a first one
 */
double cr_abort_weight(const struct cr_solver *s, int pair, int a, int b, const struct cr_force *f);
/* whether a touch is only rubbing of bodies that have parted */
bool cr_abort_rubbing(const struct cr_solver *s, int pair, int a, int b, const struct cr_force *f);

/* Factor on the restitution of walls, 0..1, where only part of an end is pressed: the energy that
 * comes back is stored in the width that is pressed, and goes with the square of the speed. */
double cr_restitution_share(const struct cr_solver *s, int a, int b, const struct cr_contact *c);

/* step 6, elastic.c; false when memory is out */
void cr_elastic_begin(struct cr_solver *s, int pair, int a, int b);
void cr_elastic_end(struct cr_solver *s, struct cr_touch *t); /* the contact is over */
bool cr_elastic_slice(struct cr_solver *s, int pair, int a, int b);

/* ending.c */
void cr_ending_rest(struct cr_solver *s, const bool in_contact[]);
void cr_ending_check(struct cr_solver *s, bool any_contact, bool rubbing);

/* record.c: contacts, trace, ledger, outcome; false when memory is out */
bool cr_record_contact(struct cr_solver *s, int pair, int a, int b, const struct cr_force *force);
bool cr_record_sample(struct cr_solver *s);
bool cr_record_slice(struct cr_solver *s, const struct cr_slice *slice);
void cr_record_before(struct cr_solver *s);
void cr_record_outcome(struct cr_solver *s);
double cr_kinetic_energy(const struct cr_solver *s);

#endif
