/* Reads the storyboard of OpenSCENARIO as far as no simulator is needed: how entities begin, and
 * speeds and trajectories that begin at given times. Whatever else would move one of them is
 * refused. */
#include "import/xosc_priv.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- actions ---- */

static enum cr_err dynamics(struct cr_xosc *x, const struct cr_xml_node *speed,
                            struct cr_xosc_action *a, struct cr_error *err) {
    static const char *const shapes[] = {"step", "linear", "cubic", "sinusoidal"};
    const struct cr_xml_node *d = cr_xml_find(speed, "SpeedActionDynamics");
    const char *shape, *dimension;
    int i = 0;
    if (d == NULL) {
        return cr_xml_fault(x->shown, speed, err, CR_ERR_MISSING, "no <SpeedActionDynamics>");
    }
    enum cr_err code = cr_xosc_text(x, d, "dynamicsShape", NULL, &shape, err);
    code =
        code == CR_ERR_OK ? cr_xosc_text(x, d, "dynamicsDimension", "time", &dimension, err) : code;
    code = code == CR_ERR_OK ? cr_xosc_number(x, d, "value", 0, &a->value, err) : code;
    if (code != CR_ERR_OK) {
        return code;
    }
    while (i < 4 && strcmp(shape, shapes[i]) != 0) {
        i++;
    }
    a->shape = (enum cr_xosc_shape)i;
    a->rate = strcmp(dimension, "rate") == 0;
    if (i == 4 || (i > 0 && !a->rate && strcmp(dimension, "time") != 0)) {
        return cr_xosc_refuse(x, d, err, "this change of speed is not read");
    }
    if (i > 0 && !(a->value >= (a->rate ? 1e-6 : 0))) {
        return cr_xml_fault(x->shown, d, err, CR_ERR_RANGE, "value must be above 0, got %g",
                            a->value);
    }
    return CR_ERR_OK;
}

static enum cr_err read_speed(struct cr_xosc *x, const struct cr_xml_node *speed,
                              struct cr_xosc_action *a, struct cr_error *err) {
    const struct cr_xml_node *target = cr_xml_find(speed, "SpeedActionTarget");
    const struct cr_xml_node *absolute = cr_xml_find(target, "AbsoluteTargetSpeed");
    if (absolute == NULL) {
        return cr_xosc_refuse(x, target != NULL && target->child != NULL ? target->child : speed,
                              err, "only an AbsoluteTargetSpeed is read");
    }
    enum cr_err code = cr_xosc_number(x, absolute, "value", NAN, &a->speed, err);
    return code == CR_ERR_OK ? dynamics(x, speed, a, err) : code;
}

/* Adds an action in the order of time; of two at one time the later in the file comes second. */
static enum cr_err add_action(struct cr_xosc_entity *e, const struct cr_xosc_action *a,
                              struct cr_error *err) {
    if (!cr_grow(&e->action, &e->size, e->actions, sizeof *e->action)) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for an action");
    }
    int i = e->actions++;
    for (; i > 0 && e->action[i - 1].t > a->t; i--) {
        e->action[i] = e->action[i - 1];
    }
    e->action[i] = *a;
    return CR_ERR_OK;
}

static enum cr_err teleport(struct cr_xosc *x, const struct cr_xml_node *action,
                            struct cr_xosc_entity *e, struct cr_error *err) {
    double heading;
    enum cr_err code = cr_xosc_position(x, action, &e->pos, &heading, err);
    e->heading = isnan(heading) ? 0 : heading;
    e->placed = code == CR_ERR_OK;
    return code;
}

/* Reads a private action that begins at time t, s; NaN stands for the begin of the scenario. */
static enum cr_err act(struct cr_xosc *x, const struct cr_xml_node *private, double t,
                       struct cr_xosc_entity *e, struct cr_error *err) {
    static const char *const harmless[] = {"VisibilityAction", "ControllerAction",
                                           "AppearanceAction", "ActivateControllerAction", NULL};
    bool init = isnan(t);
    struct cr_xosc_action a = {.t = init ? 0 : t, .node = private};
    const struct cr_xml_node *what = private->child;
    const struct cr_xml_node *speed = cr_xml_find(private, "LongitudinalAction/SpeedAction");
    const struct cr_xml_node *path = cr_xml_find(private, "RoutingAction/FollowTrajectoryAction");
    enum cr_err code = CR_ERR_OK;
    if (what == NULL || cr_xosc_is_one_of(what->name, harmless)) {
        return CR_ERR_OK;
    }
    if (strcmp(what->name, "TeleportAction") == 0 && init) {
        return teleport(x, what, e, err);
    }
    if (e->p->kind == CR_KIND_OBJECT) {
        return cr_xosc_refuse(x, private, err, "an object that moves");
    }
    if (speed != NULL) {
        code = read_speed(x, speed, &a, err);
        if (code == CR_ERR_OK && init && (a.shape == CR_XOSC_STEP || a.value == 0)) {
            e->speed = a.speed;
            return CR_ERR_OK;
        }
    } else if (path != NULL) {
        code = cr_xosc_path(x, path, &a, err);
    } else {
        return cr_xosc_refuse(x, what->child != NULL ? what->child : what, err,
                              "this action needs a simulator");
    }
    code = code == CR_ERR_OK ? add_action(e, &a, err) : code;
    if (code != CR_ERR_OK) {
        free(a.point);
    }
    return code;
}

/* ---- begin ---- */

static enum cr_err init_of(struct cr_xosc *x, const struct cr_xml_node *private,
                           struct cr_error *err) {
    const char *name;
    const struct cr_xml_node *a = NULL;
    enum cr_err code = cr_xosc_text(x, private, "entityRef", NULL, &name, err);
    struct cr_xosc_entity *e = code == CR_ERR_OK ? cr_xosc_find(x, name) : NULL;
    if (code == CR_ERR_OK && e == NULL) {
        return cr_xml_fault(x->shown, private, err, CR_ERR_NAME, "no entity \"%.60s\"", name);
    }
    while (code == CR_ERR_OK && e->p != NULL &&
           (a = cr_xml_next(private, a, "PrivateAction")) != NULL) {
        code = act(x, a, NAN, e, err);
    }
    return code;
}

/* Checks that all entities have a place; a trajectory that begins at once gives it, too. */
static enum cr_err check_placed(struct cr_xosc *x, const struct cr_xml_node *init,
                                struct cr_error *err) {
    for (int i = 0; i < x->n; i++) {
        struct cr_xosc_entity *e = &x->entity[i];
        if (e->p == NULL || e->placed) {
            continue;
        }
        if (e->actions > 0 && e->action[0].path && e->action[0].t == 0) {
            e->pos = e->action[0].point[0].pos;
            e->heading = e->action[0].point[0].heading;
            continue;
        }
        return cr_xml_fault(x->shown, init, err, CR_ERR_MISSING,
                            "no TeleportAction that places \"%.60s\"", e->name);
    }
    return CR_ERR_OK;
}

/* ---- events ---- */

/* Moves *t, s, on to the time of a trigger. Errors: TYPE for conditions that depend on what
 * happens. */
static enum cr_err trigger(struct cr_xosc *x, const struct cr_xml_node *node, double *t,
                           struct cr_error *err) {
    const struct cr_xml_node *start = cr_xml_find(node, "StartTrigger");
    const struct cr_xml_node *group = start != NULL ? cr_xml_find(start, "ConditionGroup") : NULL;
    const struct cr_xml_node *cond = NULL;
    if (start != NULL && group != NULL && cr_xml_next(start, group, "ConditionGroup") != NULL) {
        return cr_xosc_refuse(x, start, err, "one condition or another needs a simulator");
    }
    while (group != NULL && (cond = cr_xml_next(group, cond, "Condition")) != NULL) {
        const struct cr_xml_node *by =
            cr_xml_find(cond, "ByValueCondition/SimulationTimeCondition");
        const char *rule;
        double value, delay;
        if (by == NULL) {
            return cr_xosc_refuse(x, cond, err, "this condition needs a simulator");
        }
        enum cr_err code = cr_xosc_number(x, by, "value", NAN, &value, err);
        code = code == CR_ERR_OK ? cr_xosc_number(x, cond, "delay", 0, &delay, err) : code;
        code = code == CR_ERR_OK ? cr_xosc_text(x, by, "rule", NULL, &rule, err) : code;
        if (code != CR_ERR_OK) {
            return code;
        }
        if (strcmp(rule, "lessThan") != 0 && strcmp(rule, "lessOrEqual") != 0) {
            *t = fmax(*t, value + delay);
        }
    }
    return CR_ERR_OK;
}

static enum cr_err event(struct cr_xosc *x, const struct cr_xml_node *event,
                         const struct cr_xml_node *actors, double t, struct cr_error *err) {
    const struct cr_xml_node *action = NULL, *ref = NULL;
    enum cr_err code = CR_ERR_OK;
    bool timed = false;
    while (code == CR_ERR_OK && (action = cr_xml_next(event, action, "Action")) != NULL) {
        const struct cr_xml_node *private = cr_xml_find(action, "PrivateAction");
        ref = NULL;
        while (private != NULL && code == CR_ERR_OK &&
               (ref = cr_xml_next(actors, ref, "EntityRef")) != NULL) {
            const char *name;
            code = cr_xosc_text(x, ref, "entityRef", NULL, &name, err);
            struct cr_xosc_entity *e = code == CR_ERR_OK ? cr_xosc_find(x, name) : NULL;
            if (e != NULL && e->p != NULL && !timed) {
                code = trigger(x, event, &t, err);
                timed = true;
            }
            if (code == CR_ERR_OK && e != NULL && e->p != NULL) {
                code = act(x, private, t, e, err);
            }
        }
    }
    return code;
}

static enum cr_err group(struct cr_xosc *x, const struct cr_xml_node *group, double t,
                         struct cr_error *err) {
    const struct cr_xml_node *actors = cr_xml_find(group, "Actors"), *m = NULL, *e;
    enum cr_err code = CR_ERR_OK;
    if (cr_xml_find(group, "CatalogReference") != NULL) {
        return cr_xosc_refuse(x, group, err, "a maneuver out of a catalogue is not read");
    }
    while (code == CR_ERR_OK && (m = cr_xml_next(group, m, "Maneuver")) != NULL) {
        int scope = x->scope.n;
        code = cr_xosc_enter(x, m, err);
        e = NULL;
        while (code == CR_ERR_OK && (e = cr_xml_next(m, e, "Event")) != NULL) {
            code = event(x, e, actors, t, err);
        }
        cr_xosc_leave(x, scope);
    }
    return code;
}

static enum cr_err stories(struct cr_xosc *x, const struct cr_xml_node *board,
                           struct cr_error *err) {
    const struct cr_xml_node *story = NULL, *act_node, *g;
    enum cr_err code = CR_ERR_OK;
    while (code == CR_ERR_OK && (story = cr_xml_next(board, story, "Story")) != NULL) {
        int scope = x->scope.n;
        code = cr_xosc_enter(x, story, err);
        act_node = NULL;
        while (code == CR_ERR_OK && (act_node = cr_xml_next(story, act_node, "Act")) != NULL) {
            double t = 0;
            code = trigger(x, act_node, &t, err);
            g = NULL;
            while (code == CR_ERR_OK && (g = cr_xml_next(act_node, g, "ManeuverGroup")) != NULL) {
                code = group(x, g, t, err);
            }
        }
        cr_xosc_leave(x, scope);
    }
    return code;
}

enum cr_err cr_xosc_story(struct cr_xosc *x, struct cr_error *err) {
    const struct cr_xml_node *board = cr_xml_find(x->root, "Storyboard"), *p = NULL;
    const struct cr_xml_node *init = cr_xml_find(board, "Init/Actions");
    enum cr_err code = CR_ERR_OK;
    if (init == NULL) {
        return cr_xml_fault(x->shown, board != NULL ? board : x->root, err, CR_ERR_MISSING,
                            "no <Storyboard> with <Init> and <Actions>");
    }
    while (code == CR_ERR_OK && (p = cr_xml_next(init, p, "Private")) != NULL) {
        code = init_of(x, p, err);
    }
    code = code == CR_ERR_OK ? stories(x, board, err) : code;
    return code == CR_ERR_OK ? check_placed(x, init, err) : code;
}
