/* The state of a session and its history: undo is a stack of whole states. */
#include "cmd/cmd_priv.h"

#include "base/grow.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct cr_state *cr_session_now(const struct cr_session *s) {
    return s->state[s->now];
}

void cr_state_free(struct cr_state *state) {
    if (state != NULL) {
        cr_scene_fini(&state->scene);
        free(state->command);
        free(state);
    }
}

enum cr_err cr_state_dup(const struct cr_state *from, struct cr_state **out, struct cr_error *err) {
    struct cr_state *copy = calloc(1, sizeof *copy);
    if (copy == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    enum cr_err code = cr_scene_copy(&from->scene, &copy->scene, err);
    if (code != CR_ERR_OK) {
        free(copy);
        return code;
    }
    memcpy(copy->file, from->file, sizeof copy->file);
    *out = copy;
    return CR_ERR_OK;
}

/* bytes of a state, near enough */
static size_t size_of(const struct cr_state *state) {
    size_t n = sizeof *state + (state->command != NULL ? strlen(state->command) : 0);
    return n + cr_scene_size(&state->scene);
}

enum { UNDO_MAX = 64 << 20, UNDO_LEAST = 8 }; /* bytes of all states; states that are kept anyway */

/* Undo reaches back as far as its memory does. */
static void forget_oldest(struct cr_session *s) {
    size_t sum = 0;
    int first = s->states;
    while (first > 0 && (sum < UNDO_MAX || s->states - first < UNDO_LEAST)) {
        sum += size_of(s->state[--first]);
    }
    if (first == 0) {
        return;
    }
    for (int i = 0; i < first; i++) {
        cr_state_free(s->state[i]);
    }
    s->states -= first;
    s->now -= first;
    memmove(s->state, s->state + first, (size_t)s->states * sizeof *s->state);
}

enum cr_err cr_session_commit(struct cr_session *s, struct cr_state *draft, const char *command,
                              struct cr_error *err) {
    bool room = cr_grow(&s->state, &s->state_size, s->now + 1, sizeof *s->state);
    char *text = command != NULL ? strdup(command) : NULL;
    if (!room || (command != NULL && text == NULL)) {
        free(text);
        cr_state_free(draft);
        return cr_err_set(err, CR_ERR_MEMORY, "out of memory");
    }
    /* what had been undone is forgotten */
    for (int i = s->now + 1; i < s->states; i++) {
        cr_state_free(s->state[i]);
    }
    draft->command = text;
    draft->rev = ++s->last_rev;
    s->state[++s->now] = draft;
    s->states = s->now + 1;
    forget_oldest(s);
    return CR_ERR_OK;
}

void cr_session_saved(struct cr_session *s, const char *path) {
    struct cr_state *now = cr_session_now(s);
    s->saved_rev = now->rev;
    if (path != now->file) { /* it is that very text when `save` is given no name */
        snprintf(now->file, sizeof now->file, "%s", path);
    }
}

int cr_session_unsaved(const struct cr_session *s) {
    for (int i = 0; i < s->states; i++) {
        if (s->state[i]->rev == s->saved_rev) {
            return abs(s->now - i);
        }
    }
    return s->now > 0 ? s->now : 1;
}

int cr_session_way_back(const struct cr_session *s) {
    for (int i = 0; s->result != NULL && i < s->states; i++) {
        if (s->state[i]->rev == s->result_rev) {
            return s->now - i;
        }
    }
    return 0;
}

int cr_session_undos(const struct cr_session *s) {
    return s->now;
}
