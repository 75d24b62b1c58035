/* Standard error kept off the full screen: it goes to a file, whose lines the dialogue shows. */
#include "tui/tui_priv.h"

#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

/* one standard error per process; a fault's handler reads it too */
static struct {
    int before, file;
    off_t read;
} held = {.before = -1, .file = -1};

/* what was written meanwhile, now that it can be seen */
static void copy(void) {
    char buf[4096];
    ssize_t n;
    off_t at = 0;
    while (held.file >= 0 && (n = pread(held.file, buf, sizeof buf, at)) > 0) {
        at += n;
        if (write(STDERR_FILENO, buf, (size_t)n) != n) {
            break;
        }
    }
}

void cr_stderr_capture(void) {
    FILE *file = tmpfile();
    if (file == NULL) {
        return;
    }
    held.file = dup(fileno(file));
    fclose(file);
    held.before = dup(STDERR_FILENO);
    if (held.file >= 0 && held.before >= 0) {
        fflush(stderr);
        dup2(held.file, STDERR_FILENO);
    }
}

void cr_stderr_restore(void) {
    if (held.before >= 0) {
        dup2(held.before, STDERR_FILENO);
        copy();
        held.before = -1;
    }
}

void cr_stderr_release(void) {
    int before = held.before;
    if (before < 0) {
        return;
    }
    fflush(stderr);
    cr_stderr_restore();
    close(before);
    if (held.file >= 0) {
        close(held.file);
    }
    held.file = -1;
    held.read = 0;
}

void cr_term_stderr(struct cr_str *out) {
    char buf[1024];
    ssize_t n;
    struct stat st;
    if (held.file < 0 || fstat(held.file, &st) != 0 || st.st_size <= held.read) {
        return;
    }
    while ((n = pread(held.file, buf, sizeof buf, held.read)) > 0) {
        held.read += n;
        cr_str_addn(out, buf, (size_t)n);
    }
}
