/* Any bytes as a folder of files that belong together: tables of a PCM, ISO-MME with a channel, an
 * EV5 file or an ERG description with what lies beside it, a scenario with its catalogue, a table
 * with the user's map of it. Behind a line "=== N" stands the file of that number. What comes out
 * of import is a scene that reads or an error object; a curve of it is finite over rising times. */
#include "scene.h"
#include "scratch.h"

#include "import/import.h"
#include "result/signal.h"

#include <math.h>
#include <string.h>

static const char *const names[] = {"participant_data.csv",
                                    "dynamics.csv",
                                    "participant_shape.csv",
                                    "global_data.csv",
                                    "t.mme",
                                    "Channel/t.001",
                                    "t.EV5",
                                    "t.001",
                                    "t.erg.info",
                                    "t.erg",
                                    "t.xosc",
                                    "vehicles.xosc",
                                    "t.csv",
                                    "map.json"};
enum { NAMES = sizeof names / sizeof names[0], TABLE = NAMES - 2, MAP = NAMES - 1 };

static void read_curve(void) {
    const struct cr_signal_pick pick = {.object = 1};
    struct cr_error err = {0};
    struct cr_signal s;
    enum cr_err code = cr_signal_load_any(scratch_dir(), &pick, &s, &err);
    if (code != CR_ERR_OK) {
        if (err.code != code || err.text[0] == '\0') {
            abort();
        }
        return;
    }
    for (int i = 0; i < s.n; i++) {
        if (!isfinite(s.t[i]) || !isfinite(s.x[i]) || (i > 0 && !(s.t[i] > s.t[i - 1]))) {
            abort();
        }
    }
    cr_signal_free(&s);
}

/* the folder, or with a map the table alone, which is what maps are for */
static void import_all(const struct cr_model_lib *models, bool mapped) {
    char table[400], map[400];
    const char *path = mapped ? table : scratch_dir();
    struct cr_import_count count = {0};
    struct cr_error err = {0};
    struct cr_import_opts opts;
    cr_import_init(&opts);
    opts.models = models;
    opts.take = take;
    snprintf(table, sizeof table, "%s", scratch_path(names[TABLE]));
    snprintf(map, sizeof map, "%s", scratch_path(names[MAP]));
    opts.map = mapped ? map : NULL;
    if (cr_import_files(&opts, &path, 1, &count, &err) != CR_ERR_OK && err.text[0] == '\0') {
        abort();
    }
}

/* the next part of the bytes, up to the next "\n=== "; its file, -1 for none */
static int next_part(const uint8_t **at, size_t *left, size_t *size) {
    if (*left < 7 || memcmp(*at, "=== ", 4) != 0) {
        return -1;
    }
    int file = ((*at)[4] - 'A') % NAMES;
    *at += 6;
    *left -= 6;
    for (*size = 0; *size < *left; ++*size) {
        if (*left - *size > 5 && memcmp(*at + *size, "\n=== ", 5) == 0) {
            break;
        }
    }
    return file;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static struct cr_model_lib *models;
    struct cr_error err;
    char path[4096];
    snprintf(path, sizeof path, "%s/models", data_dir());
    if (models == NULL && cr_model_lib_open(path, &models, &err) != CR_ERR_OK) {
        exit(3);
    }
    snprintf(path, sizeof path, "%s/Channel", scratch_dir());
    mkdir(path, 0700);
    size_t part;
    bool put[NAMES] = {false};
    for (int file; (file = next_part(&data, &size, &part)) >= 0;) {
        scratch_put(names[file], data, part);
        put[file] = true;
        data += part < size ? part + 1 : part;
        size -= part < size ? part + 1 : part;
    }
    import_all(models, put[MAP]);
    read_curve();
    for (int i = 0; i < NAMES; i++) {
        if (put[i]) {
            scratch_remove(names[i]);
        }
    }
    rmdir(path);
    return 0;
}
