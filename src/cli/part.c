/* The output file of a long run: written as FILE.part, which becomes FILE when it is whole. An
 * unfinished attempt is set aside as FILE.part.1 and so on, until one is whole. */
#include "cli/part.h"

#include "base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static enum cr_err cannot(const char *what, const char *name, struct cr_error *err) {
    enum cr_err code = errno == EINTR ? CR_ERR_INTERRUPTED : CR_ERR_IO;
    if (code == CR_ERR_INTERRUPTED) {
        cr_err_set(err, code, "interrupted");
    } else {
        cr_err_set(err, code, "cannot %s: %s", what, strerror(errno));
    }
    cr_err_place(err, name, 0, 0);
    return code;
}

/* name of the i-th unfinished attempt; of the present one for 0 */
static char *attempt(const struct cr_part *part, int i, struct cr_str *out) {
    cr_str_clear(out);
    cr_str_addf(out, "%s.part", cr_str_get(&part->target));
    if (i > 0) {
        cr_str_addf(out, ".%d", i);
    }
    return out->s;
}

static enum cr_err take_up(struct cr_part *part, int i, struct cr_option_values *resume,
                           struct cr_error *err) {
    struct cr_str name = {0};
    attempt(part, i, &name);
    for (int k = 0; k < resume->n; k++) {
        if (!name.failed && strcmp(resume->value[k], name.s) == 0) {
            cr_str_fini(&name); /* given by hand as well */
            return CR_ERR_OK;
        }
    }
    if (name.failed || resume->n == CR_OPTION_REPEAT_MAX) {
        cr_str_fini(&name);
        return cr_err_set(err, CR_ERR_USAGE, "too many unfinished attempts to resume");
    }
    part->taken[part->takes++] = name.s;
    resume->value[resume->n++] = name.s;
    return CR_ERR_OK;
}

enum cr_err cr_part_find(struct cr_part *part, const char *path, struct cr_option_values *resume,
                         struct cr_error *err) {
    struct cr_str name = {0};
    struct stat st;
    enum cr_err code = CR_ERR_OK;
    part->in_place = cr_file_in_place(path);
    if (part->in_place) {
        cr_str_add(&part->target, path);
    } else {
        cr_file_target(path, &part->target);
    }
    for (int i = 0; i <= CR_PART_OLDS_MAX && resume != NULL && !part->in_place && code == CR_ERR_OK;
         i++) {
        const char *file = attempt(part, i, &name);
        if (file == NULL || lstat(file, &st) != 0) {
            if (i > 0) {
                break;
            }
            continue;
        }
        part->olds = i;
        code = take_up(part, i, resume, err);
    }
    cr_str_fini(&name);
    return code;
}

/* The part that is there already may hold results that the resumed file lacks. */
static enum cr_err set_aside(struct cr_part *part, struct cr_error *err) {
    struct cr_str to = {0};
    struct stat st;
    enum cr_err code = CR_ERR_OK;
    if (part->olds > 0 || lstat(cr_str_get(&part->name), &st) == 0) {
        while (part->olds < CR_PART_OLDS_MAX &&
               lstat(attempt(part, part->olds + 1, &to), &st) == 0) {
            part->olds++;
        }
        attempt(part, ++part->olds, &to);
        part->aside = rename(cr_str_get(&part->name), cr_str_get(&to)) == 0;
        if (!part->aside && errno != ENOENT) {
            code = cannot("rename", cr_str_get(&part->name), err);
        }
    }
    cr_str_fini(&to);
    return code;
}

enum cr_err cr_part_open(struct cr_part *part, struct cr_error *err) {
    struct stat st;
    const char *target = cr_str_get(&part->target);
    if (part->in_place) {
        cr_str_add(&part->name, target);
        part->file = fopen(target, "w");
        return part->file != NULL ? CR_ERR_OK : cannot("write", target, err);
    }
    if (stat(target, &st) == 0 && S_ISDIR(st.st_mode)) {
        errno = EISDIR;
        return cannot("write", target, err);
    }
    attempt(part, 0, &part->name);
    enum cr_err code = set_aside(part, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    int fd = open(cr_str_get(&part->name), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    part->made = fd >= 0;
    if (fd >= 0) {
        cr_file_keep_mode(fd, target);
    }
    part->file = fd >= 0 ? fdopen(fd, "w") : NULL;
    if (part->file == NULL && fd >= 0) {
        close(fd);
    }
    return part->file != NULL ? CR_ERR_OK : cannot("write", cr_str_get(&part->name), err);
}

enum cr_err cr_part_finish(struct cr_part *part, struct cr_error *err) {
    struct cr_str old = {0};
    const char *name = cr_str_get(&part->name), *target = cr_str_get(&part->target);
    bool bad = fflush(part->file) != 0 || (!part->in_place && fsync(fileno(part->file)) != 0);
    bad = fclose(part->file) != 0 || bad;
    part->file = NULL;
    if (bad) {
        return cannot("write", name, err);
    }
    if (part->in_place) {
        return CR_ERR_OK;
    }
    if (rename(name, target) != 0) {
        return cannot("rename", name, err);
    }
    part->made = false;
    for (int i = 1; i <= part->olds; i++) {
        unlink(attempt(part, i, &old));
    }
    cr_str_fini(&old);
    return cr_file_sync_folder(target, err);
}

void cr_part_drop(struct cr_part *part) {
    struct cr_str old = {0};
    const char *before = part->aside ? attempt(part, part->olds, &old) : NULL;
    if (part->file != NULL) {
        fclose(part->file);
        part->file = NULL;
    }
    if (part->made) {
        unlink(cr_str_get(&part->name));
        if (before != NULL && rename(before, cr_str_get(&part->name)) != 0) {
            errno = 0; /* it keeps the name that it was set aside under */
        }
    }
    part->made = part->aside = false;
    cr_str_fini(&old);
}

void cr_part_fini(struct cr_part *part) {
    if (part->file != NULL) {
        fclose(part->file);
    }
    for (int i = 0; i < part->takes; i++) {
        free(part->taken[i]);
    }
    cr_str_fini(&part->target);
    cr_str_fini(&part->name);
    memset(part, 0, sizeof *part);
}
