/* The history of lines: kept by readline, and in a file of the state folder. */
#include "tui/tui_priv.h"

#include <stdio.h>
#include <string.h>

#include <readline/history.h>

enum { HISTORY_MAX = 5000 };

/* readline has one history per process, so its file is one as well; "" if there is none */
static char file_name[1200];

void cr_history_open(const char *state_dir) {
    using_history();
    stifle_history(HISTORY_MAX);
    file_name[0] = '\0';
    if (state_dir[0] != '\0') {
        snprintf(file_name, sizeof file_name, "%s/history", state_dir);
        read_history(file_name);
    }
}

void cr_history_close(void) {
    if (file_name[0] != '\0') {
        history_truncate_file(file_name, HISTORY_MAX);
        file_name[0] = '\0';
    }
}

void cr_history_add(const char *line, bool keep) {
    const HIST_ENTRY *last =
        history_length > 0 ? history_get(history_base + history_length - 1) : NULL;
    if (line[strspn(line, " \t")] == '\0' || (last != NULL && strcmp(last->line, line) == 0)) {
        return;
    }
    add_history(line);
    using_history(); /* readline has begun the next line already */
    if (keep && file_name[0] != '\0' && append_history(1, file_name) != 0) {
        write_history(file_name); /* the first line of all makes the file */
    }
}
