/* Undo as a stack of whole states, the autosave that outlives a crash, and the clock of long
 * work. */
#include "cmd/cmd_priv.h"

#include <dirent.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

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
    memcpy(copy->placed, from->placed, sizeof copy->placed);
    memcpy(copy->file, from->file, sizeof copy->file);
    *out = copy;
    return CR_ERR_OK;
}

enum cr_err cr_cmd_edit(struct cr_call *call, struct cr_state **out, struct cr_error *err) {
    if (call->draft == NULL) {
        enum cr_err code = cr_state_dup(cr_session_now(call->s), &call->draft, err);
        if (code != CR_ERR_OK) {
            return code;
        }
    }
    *out = call->draft;
    return CR_ERR_OK;
}

enum cr_err cr_session_commit(struct cr_session *s, struct cr_state *draft, const char *command,
                              struct cr_error *err) {
    /* never smaller: what had been undone is still in it */
    int size = s->states > s->now + 2 ? s->states : s->now + 2;
    struct cr_state **bigger = realloc(s->state, (size_t)size * sizeof *bigger);
    char *text = command != NULL ? strdup(command) : NULL;
    if (bigger != NULL) {
        s->state = bigger;
    }
    if (bigger == NULL || (command != NULL && text == NULL)) {
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
    return CR_ERR_OK;
}

void cr_session_saved(struct cr_session *s, const char *path) {
    s->saved_rev = cr_session_now(s)->rev;
    struct cr_state *now = cr_session_now(s);
    snprintf(now->file, sizeof now->file, "%s", path);
}

int cr_session_unsaved(const struct cr_session *s) {
    for (int i = 0; i < s->states; i++) {
        if (s->state[i]->rev == s->saved_rev) {
            return abs(s->now - i);
        }
    }
    return s->now > 0 ? s->now : 1;
}

int cr_session_undos(const struct cr_session *s) {
    return s->now;
}

/* ---- autosave ---- */

void cr_session_autosave(struct cr_session *s) {
    struct cr_error err;
    if (s->autosave[0] == '\0') {
        return;
    }
    if (cr_session_unsaved(s) == 0) {
        unlink(s->autosave);
    } else if (cr_scene_save(&cr_session_now(s)->scene, s->autosave, &err) != CR_ERR_OK) {
        cr_warn(s, "no autosave: %s", err.text);
        s->autosave[0] = '\0';
    }
}

struct process {
    char program[64];
    char state;
};

/* from a line "number (program) state ..."; false where the system does not tell */
static bool look_at_process(long pid, struct process *out) {
    char line[256] = "";
    snprintf(line, sizeof line, "/proc/%ld/stat", pid);
    FILE *file = fopen(line, "r");
    if (file == NULL) {
        return false;
    }
    const char *told = fgets(line, sizeof line, file);
    fclose(file);
    const char *from = told != NULL ? strchr(line, '(') : NULL;
    const char *to = told != NULL ? strrchr(line, ')') : NULL;
    if (from == NULL || to == NULL || to < from || to[1] != ' ') {
        return false;
    }
    snprintf(out->program, sizeof out->program, "%.*s", (int)(to - from), from);
    out->state = to[2];
    return true;
}

/* The session of that process has ended. A process that nobody has asked for its status keeps its
 * number (Z), and after a restart of the machine the number may be that of another program. */
static bool process_gone(long pid) {
    struct process other, own;
    if (pid <= 0) {
        return false;
    }
    if (kill((pid_t)pid, 0) != 0 && errno == ESRCH) {
        return true;
    }
    return look_at_process(pid, &other) && look_at_process((long)getpid(), &own) &&
           (other.state == 'Z' || other.state == 'X' || strcmp(other.program, own.program) != 0);
}

static bool later(struct timespec a, struct timespec b) {
    return a.tv_sec > b.tv_sec || (a.tv_sec == b.tv_sec && a.tv_nsec > b.tv_nsec);
}

bool cr_autosave_find(const char *state_dir, char *path, int size) {
    DIR *dir = opendir(state_dir);
    struct dirent *entry;
    struct stat st;
    struct timespec newest = {0}; /* two sessions may end within one second */
    bool found = false;
    while (dir != NULL && (entry = readdir(dir)) != NULL) {
        long pid;
        char end[8] = "", one[CR_PATH_MAX];
        if (sscanf(entry->d_name, "autosave-%ld.%7s", &pid, end) != 2 || strcmp(end, "json") != 0 ||
            !process_gone(pid)) {
            continue;
        }
        snprintf(one, sizeof one, "%s/%s", state_dir, entry->d_name);
        if (stat(one, &st) == 0 && (!found || later(st.st_mtim, newest))) {
            newest = st.st_mtim;
            found = true;
            snprintf(path, (size_t)size, "%s", one);
        }
    }
    if (dir != NULL) {
        closedir(dir);
    }
    return found;
}

bool cr_session_left_behind(const char *state_dir) {
    char path[CR_PATH_MAX];
    return state_dir[0] != '\0' && cr_autosave_find(state_dir, path, sizeof path);
}

/* ---- long work ---- */

#define FIRST_SHOW 0.3  /* s of work before progress is shown (screen.md) */
#define SHOW_EVERY 0.1  /* s between two shows */
#define POLL_EVERY 0.01 /* s between two looks for a cancel */

static double now_s(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void cr_work_begin(struct cr_session *s) {
    s->work_began = now_s();
    s->work_polled = -1; /* the first look is at once, however fast the work is */
    s->work_shown = 0;
}

double cr_work_end(struct cr_session *s) {
    if (s->work_shown > 0 && s->opts.out.progress != NULL) {
        s->opts.out.progress(s->opts.out.user, NULL);
    }
    return now_s() - s->work_began;
}

bool cr_work_due(struct cr_session *s, double *elapsed) {
    double now = now_s();
    *elapsed = now - s->work_began;
    if (s->opts.out.progress == NULL || *elapsed < FIRST_SHOW || now - s->work_shown < SHOW_EVERY) {
        return false;
    }
    s->work_shown = now;
    return true;
}

int cr_work_cancelled(struct cr_session *s) {
    double now = now_s();
    if (s->opts.out.cancel == NULL || now - s->work_polled < POLL_EVERY) {
        return 0;
    }
    s->work_polled = now;
    return s->opts.out.cancel(s->opts.out.user);
}
