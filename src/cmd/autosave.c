/* The autosave that outlives a crash of the program, and how the next session finds it. */
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

static enum cr_err write_autosave(struct cr_session *s, struct cr_error *err) {
    if (s->autosave[0] == '\0') {
        return cr_err_set(err, CR_ERR_IO, "neither XDG_STATE_HOME nor HOME names a folder");
    }
    if (s->opts.stateless != NULL) {
        return cr_err_set(err, CR_ERR_IO, "cannot make %.150s: %s", s->opts.state_dir,
                          s->opts.stateless);
    }
    return cr_scene_save(&cr_session_now(s)->scene, s->autosave, err);
}

void cr_session_autosave(struct cr_session *s) {
    struct cr_error err;
    if (s->opts.state_dir == NULL) {
        return;
    }
    if (cr_session_unsaved(s) == 0) {
        unlink(s->autosave);
        return;
    }
    /* It is tried with each change, because a disk may be full for a while; told once, until it
     * goes again. */
    bool saved = write_autosave(s, &err) == CR_ERR_OK;
    if (!saved && !s->no_autosave) {
        cr_warn(s, "no autosave: %s", err.text);
        cr_warn(s, "changes outlive a crash only where you save FILE; XDG_STATE_HOME names another "
                   "folder");
    }
    s->no_autosave = !saved;
    if (saved && s->recovered[0] != '\0') { /* what it held is in ours now */
        unlink(s->recovered);
        s->recovered[0] = '\0';
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
