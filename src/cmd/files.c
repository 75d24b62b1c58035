/* load, save and source. */
#include "cmd/cmd_priv.h"

#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SOURCE_DEPTH = 16, SOURCE_FILES = 1000 };

/* ---- load, save ---- */

enum cr_err cr_cmd_load(struct cr_call *call, struct cr_error *err) {
    char buf[2 * CR_PATH_MAX], left[CR_PATH_MAX] = "", line[300];
    const char *path = cr_cmd_text(call, "FILE", NULL);
    bool recover = cr_cmd_given(call, "recover");
    struct cr_session *s = call->s;
    struct cr_state *draft;
    if (recover &&
        (s->opts.state_dir == NULL || !cr_autosave_find(s->opts.state_dir, left, sizeof left))) {
        return cr_err_set(err, CR_ERR_MISSING, "no session has left a scene behind");
    }
    if (!recover && path == NULL) {
        cr_err_set(err, CR_ERR_MISSING, "load needs FILE (a scene)");
        cr_err_hint(err, "for example: load %s",
                    cr_session_file(s)[0] != '\0' ? cr_session_file(s) : "crash.json");
        return CR_ERR_MISSING;
    }
    enum cr_err code = cr_cmd_edit(call, &draft, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    const char *from = recover ? left : cr_session_find_file(s, path, buf, sizeof buf);
    code = cr_file_check_regular(from, err); /* a session must not wait for a pipe */
    if (code == CR_ERR_OK) {
        cr_scene_fini(&draft->scene);
        code = cr_scene_load_draft(from, &draft->scene, err);
    }
    if (code != CR_ERR_OK) {
        cr_cmd_guess_file(from, ".json", err);
        return recover ? code : cr_cmd_blame(call, "FILE", code);
    }
    draft->file[0] = '\0';
    if (recover) { /* relative model files start from where the program runs, as for a new scene */
        draft->scene.dir[0] = '\0';
        /* it goes when the session's own autosave has taken its place */
        snprintf(s->recovered, sizeof s->recovered, "%s", left);
    } else {
        call->fresh = true;
        snprintf(call->file, sizeof call->file, "%s", from);
    }
    cr_say(s, "%s%s%d participant%s", draft->scene.name, draft->scene.name[0] != '\0' ? ": " : "",
           draft->scene.n, draft->scene.n == 1 ? "" : "s");
    for (int i = 0; i < draft->scene.n; i++) {
        cr_cmd_describe(&draft->scene.part[i], line, sizeof line);
        cr_say(s, "%s", line);
    }
    return CR_ERR_OK;
}

enum cr_err cr_cmd_may_write(struct cr_call *call, const char *path, struct cr_error *err) {
    if (call->force || strcmp(path, cr_session_file(call->s)) == 0 || access(path, F_OK) != 0) {
        return CR_ERR_OK;
    }
    cr_err_set(err, CR_ERR_DUPLICATE, "%.150s is there already", path);
    cr_err_hint(err, "%s! overwrites it", call->cmd->name);
    return cr_cmd_blame(call, "FILE", CR_ERR_DUPLICATE);
}

/* Relative model files are looked for beside the scene file; saved elsewhere cr_scene_save writes
 * their whole path. */
static void say_models(struct cr_session *s, const char *path) {
    char folder[CR_PATH_MAX];
    const struct cr_scene *scene = cr_session_scene(s);
    const char *from = scene->dir[0] != '\0' ? scene->dir : ".";
    cr_file_dir(path, folder, sizeof folder);
    for (int i = 0; i < scene->n; i++) {
        const char *file = scene->part[i].model.file;
        if (file[0] != '\0' && file[0] != '/' && strcmp(folder, from) != 0) {
            cr_say(s, "%s: the file has the whole path of %s", scene->part[i].id, file);
        }
    }
}

enum cr_err cr_cmd_save(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    const char *path = cr_cmd_text(call, "FILE", cr_session_file(s));
    if (path[0] == '\0') {
        cr_err_set(err, CR_ERR_MISSING, "the scene has no file yet");
        cr_err_hint(err, "for example: save crash.json");
        return CR_ERR_MISSING;
    }
    enum cr_err code = cr_cmd_may_write(call, path, err);
    if (code == CR_ERR_OK) {
        code = cr_scene_save(cr_session_scene(s), path, err);
        code = code == CR_ERR_OK ? code : cr_cmd_blame(call, "FILE", code);
    }
    if (code == CR_ERR_OK) {
        cr_session_saved(s, path);
        cr_session_autosave(s);
        say_models(s, path);
        cr_say(s, "%s: %d participant%s", path, cr_session_scene(s)->n,
               cr_session_scene(s)->n == 1 ? "" : "s");
    }
    return code;
}

/* ---- source ---- */

enum cr_err cr_cmd_source(struct cr_call *call, struct cr_error *err) {
    char buf[2 * CR_PATH_MAX];
    const char *typed = cr_cmd_text(call, "FILE", "");
    const char *path = cr_session_find_file(call->s, typed, buf, sizeof buf);
    char *text;
    size_t len;
    if (call->s->depth >= SOURCE_DEPTH) {
        cr_err_set(err, CR_ERR_RANGE, "command files nested more than %d deep", SOURCE_DEPTH);
        cr_err_hint(err, "does one source itself?");
        return cr_cmd_blame(call, "FILE", CR_ERR_RANGE);
    }
    /* sixteen files that source each other eight times are 8^15 of them */
    call->s->sourced = call->s->depth == 0 ? 1 : call->s->sourced + 1;
    if (call->s->sourced > SOURCE_FILES) {
        cr_err_set(err, CR_ERR_EXPENSIVE, "too expensive: one source leads to more than %d files",
                   SOURCE_FILES);
        cr_err_hint(err, "do they source each other?");
        return cr_cmd_blame(call, "FILE", CR_ERR_EXPENSIVE);
    }
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    if (code != CR_ERR_OK) {
        return cr_cmd_blame(call, "FILE", code);
    }
    if (strlen(text) != len) {
        free(text);
        code = cr_err_set(err, CR_ERR_SYNTAX, "%.150s is not text", typed);
        return cr_cmd_blame(call, "FILE", code);
    }
    call->s->depth++;
    code = cr_session_script(call->s, text, typed, 1);
    call->s->depth--;
    free(text);
    return code;
}
