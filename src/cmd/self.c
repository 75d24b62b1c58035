/* undo, redo, history and quit. */
#include "cmd/cmd_priv.h"

#include <stdio.h>
#include <string.h>

enum cr_err cr_cmd_undo(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    int count = (int)cr_cmd_number(call, "COUNT", 1);
    if (s->now == 0) {
        return cr_err_set(err, CR_ERR_MISSING, "there is nothing to undo");
    }
    if (count > s->now) {
        cr_err_set(err, CR_ERR_RANGE, "only %d change%s can be undone", s->now,
                   s->now == 1 ? "" : "s");
        return cr_cmd_blame(call, "COUNT", CR_ERR_RANGE);
    }
    for (int i = 0; i < count; i++) {
        cr_say(s, "undone: %s", s->state[s->now]->command);
        s->now--;
    }
    cr_session_autosave(s);
    return CR_ERR_OK;
}

enum cr_err cr_cmd_redo(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    int count = (int)cr_cmd_number(call, "COUNT", 1), left = s->states - 1 - s->now;
    if (left == 0) {
        return cr_err_set(err, CR_ERR_MISSING, "there is nothing to redo");
    }
    if (count > left) {
        cr_err_set(err, CR_ERR_RANGE, "only %d change%s can be redone", left, left == 1 ? "" : "s");
        return cr_cmd_blame(call, "COUNT", CR_ERR_RANGE);
    }
    for (int i = 0; i < count; i++) {
        s->now++;
        cr_say(s, "done again: %s", s->state[s->now]->command);
    }
    cr_session_autosave(s);
    return CR_ERR_OK;
}

enum cr_err cr_cmd_history(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    int count = (int)cr_cmd_number(call, "COUNT", s->lines);
    (void)err;
    if (s->lines == 0) {
        cr_say(s, "no line was typed in this session");
    }
    for (int i = count < s->lines ? s->lines - count : 0; i < s->lines; i++) {
        cr_say(s, "%4d  %s", i + 1, s->line[i]);
    }
    return CR_ERR_OK;
}

enum cr_err cr_cmd_quit(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    int unsaved = cr_session_unsaved(s);
    char question[CR_PATH_MAX + 100];
    if (!call->force && unsaved > 0 && s->opts.ask && s->opts.out.ask != NULL) {
        snprintf(question, sizeof question, "%s has %d unsaved change%s: (s)ave (q)uit (c)ancel",
                 cr_session_file(s)[0] != '\0' ? cr_session_file(s) : "the scene", unsaved,
                 unsaved == 1 ? "" : "s");
        int answer = s->opts.out.ask(s->opts.out.user, question, "sqc");
        if (answer == 's' && cr_session_file(s)[0] == '\0') {
            cr_err_set(err, CR_ERR_MISSING, "the scene has no file yet");
            cr_err_hint(err, "for example: save crash.json");
            return CR_ERR_MISSING;
        }
        if (answer == 's') {
            enum cr_err code = cr_scene_save(cr_session_scene(s), cr_session_file(s), err);
            if (code != CR_ERR_OK) {
                return code;
            }
            cr_session_saved(s, cr_session_file(s));
        } else if (answer != 'q') {
            cr_say(s, "not quit");
            return CR_ERR_OK;
        }
    }
    s->over = true;
    return CR_ERR_OK;
}
