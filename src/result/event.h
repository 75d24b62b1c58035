/* Makes impacts out of the solver's record: which contacts of two bodies are one blow, when it
 * began and ended, and what it alone did to the motion of each body. Whoever reports single impacts
 * reads them here, not the solver's contacts and slices. */
#ifndef CR_RESULT_EVENT_H
#define CR_RESULT_EVENT_H

#include "base/err.h"
#include "solver/solver.h"

/* What one impact did to one of its two bodies. */
struct cr_event_body {
    struct cr_vec2 delta_v; /* velocity change of the CG by it, world, m/s */
    double yaw_change;      /* rad/s */
    double energy, induced; /* plastic energy, and the part of it outside the contact, J */
    struct cr_vec2 coe;     /* where the impulse acted in the body's own frame, m from the CG */
    double pushed;          /* sum of the sizes of the impulses of the slices, N s */
    struct cr_vec2 touch;   /* where it first touched, own frame, m from the CG */
    struct cr_vec2 *vel;    /* [samples] velocity change by it until the end of a slice, m/s */
    struct cr_vec2 *way;    /* [samples] unit, own frame: how the partner moves over the body */
};

/* One impact: the contacts of two bodies that follow each other within 0.1 s. */
struct cr_event {
    int body[2];
    double t_begin, t_end;               /* s, without the rubbing that comes before and after */
    int first, samples;                  /* the time slices in between: trace[first] and so many */
    double t_plastic_end, t_elastic_end; /* s */
    int contacts, main;              /* how many contacts, and the one with the greatest impulse */
    enum cr_stop stop;               /* how the main one ended */
    double closing, restitution, mu; /* m/s, -, - */
    double friction;                 /* J */
    struct cr_vec2 impulse;          /* on body[1], world, N s */
    struct cr_vec2 coe, normal;      /* impulse-weighted means, world, m and unit from body[0] */
    struct cr_event_body of[2];
};

struct cr_events {
    int n;
    struct cr_event *event; /* in order of their first contacts; owned */
    struct cr_vec2 *memory; /* holds vel and way of all, owned */
};

/* Finds the impacts of a solution; cr_events_fini gives back. Rubbing is no impact, and ends one: a
 * contact counts while it changes the velocity of one of the two by 0.8 km/h within 20 ms (the end
 * of an event in 49 CFR 563.5), or by 5 % of the greatest such change of the pair where that is
 * less. What tyres did while an impact lasted counts for it, so that the changes of all impacts add
 * up to those of the bodies. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_events_find(const struct cr_solution *sol, const struct cr_case *cs,
                                         struct cr_events *out, struct cr_error *err);
/* The state of a body when the impact begins. */
const struct cr_sample *cr_event_before(const struct cr_solution *sol, const struct cr_event *event,
                                        int body);
void cr_events_fini(struct cr_events *events);

#endif
