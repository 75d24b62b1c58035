/* The case: everything the solver needs, constant while it runs. Made from a scene by
 * scene/compile.c or by hand in a test. SI units, world frame x east, y north, headings
 * counter-clockwise; body frame x forward, y left, origin at the CG. */
#ifndef CR_SOLVER_CASE_H
#define CR_SOLVER_CASE_H

#include "base/vec.h"
#include "model/grid.h"
#include "solver/limits.h"

#include <stdbool.h>

enum cr_shape_kind {
    CR_SHAPE_NONE,    /* the body is a voxel grid */
    CR_SHAPE_WALL,    /* half plane behind the origin: material at body x <= 0, normal +x */
    CR_SHAPE_POLE,    /* circle about the origin */
    CR_SHAPE_POLYGON, /* closed polygon, counter-clockwise, grown by edge_radius all round */
};

/* Rigid exact outline of an object, body frame. */
struct cr_shape {
    enum cr_shape_kind kind;
    double radius;                /* pole, m */
    double edge_radius;           /* polygon: the outline is the vertices' polygon grown by this,
                                     so a rounded box has its vertices drawn in by it, m */
    int n;                        /* vertices of the polygon */
    const struct cr_vec2 *vertex; /* borrowed, [n] */
};

struct cr_wheel {
    struct cr_vec2 at; /* contact point, body frame, m */
    double load;       /* static vertical load, N */
    double brake;      /* share of the available friction used for braking, 0..1 */
    double steer;      /* steer angle, rad, counter-clockwise */
    bool locked;       /* slides with all its friction against its own velocity */
};

/* The ways in which a voxel can be pushed: from the front rearward, from the rear forward, from a
 * flank. A structure resists each with another strength. */
enum cr_push { CR_PUSH_REARWARD, CR_PUSH_FORWARD, CR_PUSH_SIDEWAYS, CR_PUSHES };

/* Energies of the voxels by the way they are pushed, J; NULL: the grid's energy. */
struct cr_strength {
    const double *energy[CR_PUSHES]; /* borrowed, [ny * nx] */
};

struct cr_body {
    double mass;    /* kg; <= 0: fixed to the ground */
    double inertia; /* about the vertical axis through the CG, kg m2; <= 0: does not turn */
    struct cr_vec2 pos, vel;
    double heading, yaw_rate;
    struct cr_grid grid;                     /* nx = 0 for a rigid object */
    struct cr_shape shape;                   /* CR_SHAPE_NONE for a grid */
    double friction;                         /* of its surface; < 0: the case's friction */
    int wheels;                              /* 0 or CR_WHEELS */
    struct cr_wheel wheel[CR_WHEELS];        /* front left, front right, rear left, rear right */
    struct cr_strength strength;             /* of all layers */
    struct cr_strength against[CR_BODY_MAX]; /* of the layers that meet this partner in height;
                                                  NULL: strength */
    double brake_after;                      /* deceleration, m/s2, as far as the road gives it */
    double reaction;                         /* from so long after its first contact on, s */
    int waypoints;                           /* 0: pos, vel, heading above are the start */
    const struct cr_waypoint *waypoint;      /* borrowed, [waypoints] */
};

struct cr_opts {
    double dt;             /* longest time slice, s */
    double friction;       /* Coulomb coefficient between bodies, 0: force along the normal */
    bool friction_auto;    /* by kind of body instead: crushing structures hook into each other, on
                              a rigid object they slide */
    double road_friction;  /* of the tyres */
    double rolling;        /* rolling resistance, share of the load */
    double rolling_after;  /* the same from 1 s after a body's first contact on */
    struct cr_vec2 slope;  /* towards where the road falls, m of height per m of plan */
    double restitution;    /* 0..1, see restitution_auto */
    bool restitution_auto; /* from closing speed, kind of partner and the share of an end's width
                              that is pressed instead [RESTITUTION-SPEED] */
    double elastic_s;      /* length of the elastic compression, and of the restitution, s; 0: from
                              the force at the end of the plastic phase, which goes on smoothly */
    bool plane;            /* the force is normal to the plane through the deformed voxels, not
                              along what presses on the surfaces (method.md) */
    bool induced;          /* what lies beside the contact is dragged along (method.md) */
    enum cr_end end;
    double max_time;  /* s before the first contact after which there is none */
    double rest_time; /* s after the first contact after which motion to rest is cut */
};

struct cr_opts cr_opts_default(void);

/* A part of the road with a friction of its own. */
struct cr_patch {
    int n;                        /* corners, 0: none */
    const struct cr_vec2 *vertex; /* borrowed, [n] */
    double friction;
};

struct cr_case {
    int n; /* bodies, in the order of the scene; contacts are worked in this order and backwards in
              turns */
    struct cr_body body[CR_BODY_MAX];
    struct cr_opts opts;
    struct cr_patch patch;
};

#endif
