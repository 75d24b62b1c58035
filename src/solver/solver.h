/* The collision solver: six steps of the paper per time slice (method.md), pure computation.
 *
 * cr_solver_new borrows the case until cr_solver_free; cr_solver_step works one time slice; what
 * came out is read at any time through cr_solver_solution and belongs to the solver. */
#ifndef CR_SOLVER_SOLVER_H
#define CR_SOLVER_SOLVER_H

#include "base/err.h"
#include "solver/limits.h"

#include <stdbool.h>
#include <stdint.h>

/* Why the plastic compression of a contact ended (paper, step 5). X(name, word in the result) */
#define CR_STOP_LIST(X)                                                                            \
    X(NONE, "none")                                                                                \
    X(MOMENTUM, "momentum")                                                                        \
    X(SEPARATION, "separation")                                                                    \
    X(NO_OVERLAP, "no-overlap")                                                                    \
    X(INTERRUPTED, "interrupted")

enum cr_stop {
#define X(name, word) CR_STOP_##name,
    CR_STOP_LIST(X)
#undef X
};
const char *cr_stop_word(enum cr_stop stop);

enum cr_phase { CR_PHASE_APART, CR_PHASE_PLASTIC, CR_PHASE_COMPRESSION, CR_PHASE_RESTITUTION };

/* State of a body at the end of a time slice, and what acted on it in the slice. */
struct cr_sample {
    struct cr_vec2 pos, vel; /* CG, world, m and m/s */
    double heading;          /* rad, continuous (not wrapped) */
    double yaw_rate;         /* rad/s */
    struct cr_vec2 acc;      /* of the CG, world, m/s2, mean over the slice */
    double yaw_acc;          /* rad/s2 */
    struct cr_vec2 force;    /* sum of contact forces, world, N */
    struct cr_vec2 coe;      /* where it acts: force-weighted COE of its contacts, world, m */
    double energy;           /* plastic energy so far, J, induced included */
    double crushed;          /* plan area crushed so far, m2 */
};

/* One contact worked in one time slice: the numbers of Eq. (1)-(3) and of the impulse. */
struct cr_slice {
    int sample;  /* index of the time slice in the trace */
    int contact; /* index into cr_solution.contact */
    enum cr_phase phase;
    int deformed[2];          /* voxels that lost material, bodies a and b */
    double energy[2];         /* Eq. (1): energy released in a and b, J (induced included) */
    double induced;           /* part of it outside the contact, J */
    struct cr_vec2 coe;       /* Eq. (3), world, m */
    struct cr_vec2 normal;    /* unit, from a to b */
    struct cr_vec2 direction; /* of the force on b, unit */
    double approach;          /* along the normal at the COE before the slice, m/s */
    double path;              /* s of Eq. (2): approach in this slice along the normal, m */
    double force;             /* along direction, N */
    double impulse;           /* along direction, N s */
    double mass_eff;          /* at the COE along direction, kg */
    double friction;          /* friction work, J */
};

/* One contact between two bodies, from first touch to the end of its restitution. */
struct cr_contact {
    int a, b;
    double t_begin, t_plastic_end, t_elastic_end, t_end; /* s */
    enum cr_stop stop;
    enum cr_phase phase;    /* APART once it is over */
    double closing;         /* approach along the mean normal at first touch, m/s */
    double restitution;     /* used for this contact */
    double mu;              /* Coulomb friction used */
    double plastic_impulse; /* along the normal, N s */
    double elastic_impulse; /* of compression; restitution has the same, N s */
    struct cr_vec2 impulse; /* whole impulse on b, world, N s */
    struct cr_vec2 coe;     /* impulse-weighted mean of the COE, world, m */
    struct cr_vec2 normal;  /* energy-weighted mean, unit, from a to b */
    double energy[2];       /* plastic, J */
    double induced[2];      /* part of it outside the contact, J */
    double friction;        /* J */
    double stored;          /* elastic energy now, J */
};

struct cr_outcome {
    struct cr_sample before, after; /* at first contact and at the end of the last restitution */
    struct cr_sample rest;          /* where the solve ended */
    double t_rest;                  /* s, NaN if it did not come to rest within rest_time */
    double t_first, t_last;         /* first contact and end of last restitution of this body, s */
    struct cr_vec2 delta_v;         /* CG velocity change while in contact, world, m/s */
    double yaw_change;              /* yaw rate change while in contact, rad/s */
    struct cr_vec2 impulse;         /* of all its contacts, world, N s */
    double energy, induced;         /* plastic energy, and its part outside the contact, J */
    const double *left;             /* [ny * nx] material left, 0..fill; NULL without a grid */
    const float *t_crushed;         /* [ny * nx] time at which a voxel lost half of what it lost in
                                       all, s; +inf for one that lost nothing */
    const uint8_t *how;             /* [ny * nx] enum cr_crush flags */
};

enum cr_crush { CR_CRUSH_CONTACT = 1, CR_CRUSH_INDUCED = 2 };

struct cr_balance {
    double kinetic_before, kinetic_after; /* J, at first contact and at the end of the solve */
    double plastic, friction, tyre;       /* J taken out in between */
    double momentum_residual; /* |sum of momentum - what tyres and ground gave| / scale */
    double angular_residual;  /* the same for angular momentum */
    double energy_residual;   /* |kinetic_before - all others| / kinetic_before */
};

struct cr_solution {
    int bodies;
    struct cr_outcome body[CR_BODY_MAX];
    int contacts;
    const struct cr_contact *contact;
    int samples;                   /* time slices recorded, from first contact on */
    const double *t;               /* [samples] end of the slice, s */
    const struct cr_sample *trace; /* [samples * bodies], sample-major */
    int slices;
    const struct cr_slice *slice; /* [slices] in order of time */
    double t_contact;             /* first contact of all, s; NaN before it */
    double dt;                    /* slice used after the first contact, s */
    bool interrupted; /* cut short by who called cr_solver_run: all is as of the last slice */
    struct cr_balance balance;
    long visits;   /* voxels looked at by the contact loop */
    long deformed; /* voxels that lost material */
};

enum cr_status { CR_STATUS_RUNNING, CR_STATUS_DONE, CR_STATUS_FAILED };

struct cr_case;
struct cr_solver;

/* New solver for a case. Errors: RANGE for a body without mass or extent, OVERLAP for bodies that
 * overlap at the start, MEMORY. */
CR_MUST_CHECK enum cr_err cr_solver_new(const struct cr_case *cs, struct cr_solver **out,
                                        struct cr_error *err);

/* Two bodies that overlap at the start, and the way out of it. */
struct cr_overlap {
    int a, b;          /* the first such pair */
    double area;       /* that they share, m2 */
    int mover;         /* the faster of the two: moved by `by` it is clear of all the others */
    struct cr_vec2 by; /* back along the relative velocity, or where that is much further
                          straight away from the other, m; NaN: neither way leads out */
};
/* What cr_solver_new refused with OVERLAP; false where nothing overlaps, or memory is out. */
bool cr_solver_overlap(const struct cr_case *cs, struct cr_overlap *out);

/* Work one time slice. FAILED fills in err: NO_CONTACT when the bodies never meet, MEMORY, SOLVER
 * when a number is no longer finite. */
enum cr_status cr_solver_step(struct cr_solver *s, struct cr_error *err);

/* What has come out so far, brought up to date by this call; valid until the next step. */
const struct cr_solution *cr_solver_solution(struct cr_solver *s);

/* Present state of a body, also before the first contact. */
struct cr_sample cr_solver_state(const struct cr_solver *s, int body);
double cr_solver_time(const struct cr_solver *s);
/* Has any contact begun? Unlike cr_solver_solution this costs nothing. */
bool cr_solver_touched(const struct cr_solver *s);

void cr_solver_free(struct cr_solver *s);

/* Steps until done. cancel (nullable) is polled every slice; non-zero stops with INTERRUPTED. What
 * was worked until then stays, marked as interrupted, and a further call goes on from there. */
CR_MUST_CHECK enum cr_err cr_solver_run(struct cr_solver *s, int (*cancel)(void *), void *user,
                                        struct cr_error *err);

/* Restitution from closing speed, m/s [RESTITUTION-SPEED]. */
double cr_restitution_auto(double closing, bool rigid_partner);

#endif
