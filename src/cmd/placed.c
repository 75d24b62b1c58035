/* Who was placed against another still stands so after a change of either. */
#include "cmd/cmd_priv.h"

#include <stdlib.h>
#include <string.h>

/* Is the participant that a fault is told of (by its JSON pointer) in a relation? One that is not
 * may be half made yet. */
static bool concerns(const struct cr_scene *scene, const struct cr_error *err) {
    static const char head[] = "/participants/";
    if (strncmp(err->where, head, sizeof head - 1) != 0) {
        return true;
    }
    long at = strtol(err->where + sizeof head - 1, NULL, 10);
    for (int i = 0; i < scene->n && at >= 0 && at < scene->n; i++) {
        if (cr_scene_is_placed(&scene->part[i]) &&
            (i == at || strcmp(scene->part[i].place.against, scene->part[at].id) == 0)) {
            return true;
        }
    }
    return false;
}

enum cr_err cr_cmd_settle(struct cr_session *s, struct cr_state *draft, struct cr_error *err) {
    struct cr_scene *scene = &draft->scene;
    struct cr_vec2 before[CR_BODY_MAX];
    struct cr_error found = {0};
    bool any = false;
    for (int i = 0; i < scene->n; i++) {
        before[i] = scene->part[i].pos;
        any = any || cr_scene_is_placed(&scene->part[i]);
    }
    if (!any) {
        return CR_ERR_OK;
    }
    enum cr_err code = cr_session_need_models(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_scene_settle(scene, s->models, &found);
    if (code != CR_ERR_OK && concerns(scene, &found)) {
        *err = found;
        return code;
    }
    for (int i = 0; i < scene->n && code == CR_ERR_OK; i++) {
        const struct cr_participant *p = &scene->part[i];
        if (cr_vec2_len(cr_vec2_sub(p->pos, before[i])) > 1e-9) {
            cr_say(s, "placed again: %s x=%.2f m y=%.2f m", p->id, p->pos.x + 0.0, p->pos.y + 0.0);
        }
    }
    return CR_ERR_OK;
}
