/* Files: read whole, written whole or not at all. */
#ifndef CR_BASE_FILE_H
#define CR_BASE_FILE_H

#include "base/err.h"
#include "base/str.h"

#include <stdbool.h>
#include <stddef.h>

enum { CR_FILE_MAX_MB = 1024 };

/* Read a whole file ("-" is standard input) into *text, terminated, to be freed by the caller.
 * Errors: IO for what cannot be opened or read, is a directory or exceeds CR_FILE_MAX_MB;
 * INTERRUPTED when a signal comes whose handler does not restart system calls. */
CR_MUST_CHECK enum cr_err cr_file_read(const char *path, char **text, size_t *len,
                                       struct cr_error *err);

/* The same for data that a scene, a setting or the installation names: only a regular file will do,
 * so that neither a pipe nor a device is waited for or read without end. Errors: IO. */
CR_MUST_CHECK enum cr_err cr_file_read_regular(const char *path, char **text, size_t *len,
                                               struct cr_error *err);
/* Whether a path leads to a regular file. Errors: IO, with what it is instead. */
CR_MUST_CHECK enum cr_err cr_file_check_regular(const char *path, struct cr_error *err);
/* The same of what was opened as fd; below 0: that failed, and errno says why. */
enum cr_err cr_file_check_open(int fd, const char *path, struct cr_error *err);

/* Write n bytes to path by way of a temporary file in its folder, fsync and rename: after a failure
 * the old file is as it was, and nothing is beside it, also after kill -9 where the system has
 * files without a name (O_TMPFILE). A link stays one: what it leads to is replaced. The folder is
 * made lasting too; a failure of that alone leaves the new file. Errors: IO. */
CR_MUST_CHECK enum cr_err cr_file_write(const char *path, const char *text, size_t n,
                                        struct cr_error *err);
/* The same with a text that was put together; where memory was out for some of it, nothing is
 * written. Errors: IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_file_write_str(const char *path, const struct cr_str *text,
                                            struct cr_error *err);

/* The file that a path leads to through links, which need not be there: what is written and renamed
 * to that leaves the links as they are. Added to out. */
void cr_file_target(const char *path, struct cr_str *out);

/* Whether a path is a pipe or device such as /dev/stdout: it is written in place, a rename would
 * put a file where it was. */
bool cr_file_in_place(const char *path);

/* For what is written piece by piece: give the open file the mode of the one that it is going to
 * replace, or what the umask leaves where there is none. */
void cr_file_keep_mode(int fd, const char *path);
/* Make the folder of a path lasting: a name is no more so than that. Errors: IO. */
CR_MUST_CHECK enum cr_err cr_file_sync_folder(const char *path, struct cr_error *err);

/* Where a part of a data folder ("irf", "validation/data") lies: below share/ in a source tree, at
 * its top once installed. "share/irf" is the same, and "models" has one place. Returns buf. */
char *cr_file_part(const char *data_dir, const char *part, char *buf, size_t size);

/* Where a user's own part of the data ("catalogue") lies: XDG_DATA_HOME/crumple/PART, else below
 * HOME; "" where the values of both (NULL: not set) lead nowhere. Returns buf. */
char *cr_file_own_part(const char *xdg_data_home, const char *home, const char *part, char *buf,
                       size_t size);

/* Order of names for scandir: by bytes, the same in every locale. */
struct dirent;
int cr_file_by_bytes(const struct dirent **a, const struct dirent **b);

struct cr_folder {
    struct dirent **entry;
    int n;
};
/* List the entries of a folder that the filter takes (NULL: all), in the order of their bytes; out
 * is there to be finished after an error, too. A folder that is not there is empty where it may be
 * missing. Errors: IO, MEMORY. */
CR_MUST_CHECK enum cr_err cr_folder_list(const char *dir, int (*filter)(const struct dirent *),
                                         bool may_miss, struct cr_folder *out,
                                         struct cr_error *err);
void cr_folder_fini(struct cr_folder *folder);

/* Folder part of a path, "." if there is none, into buf. */
void cr_file_dir(const char *path, char *buf, size_t size);

#endif
