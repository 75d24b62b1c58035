/* Loads a measured curve from the files of a crash test of NHTSA or in ISO-MME: a channel that is
 * named itself, or the one of a whole test that is meant. */
#include "result/ev5.h"
#include "result/mme.h"
#include "result/signal.h"

#include "base/file.h"
#include "base/units.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

static bool ends(const char *path, const char *with) {
    size_t n = strlen(path), m = strlen(with);
    return n > m && strcasecmp(path + n - m, with) == 0;
}

/* The number 8 of "v07292.008", 0 for a name of another form. */
static long channel_number(const char *path) {
    const char *dot = strrchr(path, '.');
    bool digits = dot != NULL && strlen(dot) >= 4 && dot[1 + strspn(dot + 1, "0123456789")] == '\0';
    return digits ? strtol(dot + 1, NULL, 10) : 0;
}

static bool is_folder(const char *path) {
    struct stat st;
    return stat(path, &st) == 0 && S_ISDIR(st.st_mode);
}

bool cr_signal_is(const char *path) {
    return ends(path, ".csv") || ends(path, ".ev5") || ends(path, ".mme") || ends(path, ".zip") ||
           channel_number(path) > 0 || is_folder(path);
}

static enum cr_err fault(const char *path, struct cr_error *err, enum cr_err code, const char *text,
                         const char *hint) {
    cr_err_set(err, code, "%s", text);
    cr_err_place(err, path, 0, 0);
    cr_err_hint(err, "%s", hint);
    return code;
}

/* Turns the samples of a channel into a signal in SI units, with y to the left and z up. */
static enum cr_err become(struct cr_channel *ch, const char *unit_text, char axis, const char *path,
                          struct cr_signal *out, struct cr_error *err) {
    const struct cr_unit *unit;
    enum cr_err code = cr_unit_read(unit_text, CR_DIMS, &unit, err);
    if (code != CR_ERR_OK) {
        cr_err_place(err, path, 0, 0);
        return code;
    }
    if (unit == NULL || ch->n < 2) {
        return fault(path, err, CR_ERR_MISSING,
                     unit == NULL ? "a channel without a unit" : "fewer than two samples", "");
    }
    out->memory = malloc(2 * (size_t)ch->n * sizeof *out->memory);
    if (out->memory == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for a signal");
    }
    double sign = axis == 'Y' || axis == 'Z' ? -1 : 1;
    out->n = ch->n;
    out->axis = axis;
    out->t = out->memory;
    out->x = out->memory + ch->n;
    snprintf(out->unit, sizeof out->unit, "%s", cr_unit_nth(unit->dim, 0)->name);
    for (int i = 0; i < ch->n; i++) {
        out->t[i] = ch->t[i];
        out->x[i] = sign * cr_unit_to_si(unit, ch->x[i]);
    }
    return CR_ERR_OK;
}

/* ---- NHTSA ---- */

static enum cr_err load_pairs(const char *path, const struct cr_ev5_record *r,
                              struct cr_signal *out, struct cr_error *err) {
    struct cr_channel ch = {.n = 0};
    char *text;
    size_t len;
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_channel_pairs(text, path, &ch, err);
    free(text);
    if (code == CR_ERR_OK) {
        code = become(&ch, cr_ev5_text(r, CR_EV5_UNIT), cr_ev5_text(r, CR_EV5_AXIS)[0], path, out,
                      err);
    }
    snprintf(out->name, sizeof out->name, "%.20s %.20s %.20s of vehicle %.20s",
             cr_ev5_text(r, CR_EV5_SENSOR), cr_ev5_text(r, CR_EV5_ATTACHMENT),
             cr_ev5_text(r, CR_EV5_AXIS), cr_ev5_text(r, CR_EV5_OF));
    cr_channel_fini(&ch);
    return code;
}

/* The record that was named by its curve number in pick->column, else that of the acceleration that
 * is meant; NULL with an error. */
static const struct cr_ev5_record *choose_record(const struct cr_ev5 *ev5, const char *path,
                                                 const struct cr_signal_pick *pick,
                                                 struct cr_error *err) {
    const struct cr_ev5_record *r, *vehicle;
    if (pick->column != NULL) {
        long number = strtol(pick->column, NULL, 10);
        r = number > 0 ? cr_ev5_curve(ev5, number) : NULL;
        if (r == NULL) {
            cr_err_set(err, CR_ERR_NAME, "there is no curve '%.40s'", pick->column);
            cr_err_place(err, path, 0, 0);
            cr_err_hint(err, "column= is a curve number of section INSTRUMENTATION");
        }
        return r;
    }
    vehicle = cr_ev5_find(ev5, "VEHICLE", pick->object - 1);
    vehicle = vehicle == NULL ? cr_ev5_find(ev5, "VEHICLE", 0) : vehicle;
    r = vehicle != NULL ? cr_ev5_accel(ev5, cr_ev5_text(vehicle, 1), pick->left ? 'Y' : 'X') : NULL;
    if (r == NULL) {
        fault(path, err, CR_ERR_MISSING, "the test has no acceleration of this vehicle",
              "column= names a curve of section INSTRUMENTATION by its number");
    }
    return r;
}

/* Loads the curve that is meant of TEST.EV5, with number > 0 that of the channel TEST.008 beside
 * it; pick is not read then. */
static enum cr_err load_ev5(const char *path, long number, const struct cr_signal_pick *pick,
                            struct cr_signal *out, struct cr_error *err) {
    struct cr_ev5 ev5;
    const struct cr_ev5_record *r;
    char file[4096], *text;
    size_t len;
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_ev5_parse(text, path, &ev5, err);
    free(text);
    if (code != CR_ERR_OK) {
        goto out;
    }
    if (number > 0) {
        r = cr_ev5_curve(&ev5, number);
        if (r == NULL) {
            cr_err_set(err, CR_ERR_MISSING, "section INSTRUMENTATION has no curve %ld", number);
            cr_err_place(err, path, 0, 0);
        }
    } else {
        r = choose_record(&ev5, path, pick, err);
    }
    if (r == NULL) {
        code = err != NULL ? err->code : CR_ERR_MISSING;
    } else if (!cr_ev5_file(path, r, file, sizeof file)) {
        cr_err_set(err, CR_ERR_MISSING, "the channel of curve %.20s is not beside the file",
                   cr_ev5_text(r, CR_EV5_CURVE));
        cr_err_place(err, path, 0, 0);
        code = CR_ERR_MISSING;
    } else {
        code = load_pairs(file, r, out, err);
    }
out:
    cr_ev5_fini(&ev5);
    return code;
}

/* Finds "dir/v07292.EV5", its suffix in either case, of "dir/v07292.008"; false if there is
 * none. */
static bool test_beside(const char *channel, char *buf, size_t size) {
    static const char *const suffixes[] = {"EV5", "ev5"};
    int stem = (int)(strrchr(channel, '.') - channel);
    for (int i = 0; i < 2; i++) {
        if (snprintf(buf, size, "%.*s.%s", stem, channel, suffixes[i]) < (int)size &&
            cr_file_check_regular(buf, NULL) == CR_ERR_OK) {
            return true;
        }
    }
    return false;
}

/* ---- ISO-MME ---- */

static enum cr_err load_mme_channel(const char *path, struct cr_signal *out, struct cr_error *err) {
    struct cr_mme_channel ch;
    enum cr_err code = cr_mme_channel_load(path, &ch, err);
    if (code == CR_ERR_OK) {
        /* The 15th character of a code is the axis, the 16th the filter: D is CFC 60. */
        bool whole = strlen(ch.code) == CR_MME_CODE - 1;
        code = become(&ch.samples, ch.unit, whole ? ch.code[14] : '\0', path, out, err);
        snprintf(out->name, sizeof out->name, "%s%s", ch.code,
                 whole && ch.code[15] == 'D' ? " (CFC60)" : "");
    }
    cr_channel_fini(&ch.samples);
    return code;
}

/* The search for the channel that is meant among those of a test. */
struct search {
    const struct cr_signal_pick *pick;
    char path[4096];        /* the best channel so far */
    int rank;               /* of that channel, see rank_of */
    char object;            /* test object of the last acceleration that was met */
    bool several;           /* several test objects have such an acceleration */
    struct cr_str channels; /* codes of all channels */
};

/* 2 for the channel that is meant, 1 for the acceleration that is meant but of another test object
 * (which will do if no other has one), 0 else. */
static int rank_of(struct search *s, const char *code, const char *name, long number) {
    const char *column = s->pick->column;
    if (column != NULL) {
        return strcasecmp(code, column) == 0 || (name != NULL && strcasecmp(name, column) == 0) ||
                       (number > 0 && column[strspn(column, "0123456789")] == '\0' &&
                        strtol(column, NULL, 10) == number)
                   ? 2
                   : 0;
    }
    if (!cr_mme_is_accel(code, s->pick->left ? 'Y' : 'X')) {
        return 0;
    }
    s->several = s->several || (s->object != '\0' && s->object != code[0]);
    s->object = code[0];
    return code[0] - '0' == s->pick->object ? 2 : 1;
}

static enum cr_err look_at(void *user, const char *path, const char *file, struct cr_error *err) {
    struct search *s = user;
    struct cr_mme mme;
    enum cr_err code = cr_mme_load(path, &mme, err);
    const char *iso = code == CR_ERR_OK ? cr_mme_get(&mme, "Channel code", NULL) : NULL;
    if (iso != NULL) {
        const char *name = cr_mme_get(&mme, "Name of the channel", NULL);
        int rank = rank_of(s, iso, name, channel_number(file));
        if (rank > s->rank) {
            s->rank = rank;
            snprintf(s->path, sizeof s->path, "%s", path);
        }
        cr_str_addf(&s->channels, "%s%.16s", s->channels.len > 0 ? ", " : "", iso);
    }
    cr_mme_fini(&mme);
    return code;
}

static enum cr_err load_mme(const char *path, const char *dir, const struct cr_signal_pick *pick,
                            struct cr_signal *out, struct cr_error *err) {
    struct search s = {.pick = pick};
    enum cr_err code = cr_mme_channels(dir, look_at, &s, err);
    if (code == CR_ERR_OK && (s.rank == 0 || (s.rank == 1 && s.several))) {
        code = CR_ERR_NAME;
        if (pick->column != NULL) {
            cr_err_set(err, code, "there is no channel '%.40s'", pick->column);
        } else {
            cr_err_set(err, code, "there is no acceleration of test object %d (%d?VEHC...AC%c?)",
                       pick->object, pick->object, pick->left ? 'Y' : 'X');
        }
        cr_err_place(err, path, 0, 0);
        if (s.channels.len > 0) {
            cr_err_hint(err, "column= is one of %.160s", cr_str_get(&s.channels));
        } else {
            cr_err_hint(err, "a test has its channels beside TEST.EV5, or in Channel/ of ISO-MME");
        }
    }
    cr_str_fini(&s.channels);
    return code == CR_ERR_OK ? load_mme_channel(s.path, out, err) : code;
}

/* ---- any ---- */

static int is_ev5(const struct dirent *entry) {
    return ends(entry->d_name, ".ev5");
}

/* Loads the one EV5 file of a folder, or the channels of ISO-MME where there is none, or more than
 * one. */
static enum cr_err load_folder(const char *dir, const struct cr_signal_pick *pick,
                               struct cr_signal *out, struct cr_error *err) {
    char path[4096];
    struct cr_folder folder;
    enum cr_err code = cr_folder_list(dir, is_ev5, false, &folder, err);
    bool one = folder.n == 1 && snprintf(path, sizeof path, "%s/%s", dir, folder.entry[0]->d_name) <
                                    (int)sizeof path;
    cr_folder_fini(&folder);
    if (code != CR_ERR_OK) {
        return code;
    }
    return one ? load_ev5(path, 0, pick, out, err) : load_mme(dir, dir, pick, out, err);
}

/* Loads TEST.001, which both formats may be called; ISO-MME begins with descriptors. */
static enum cr_err load_channel(const char *path, struct cr_signal *out, struct cr_error *err) {
    char test[4096];
    struct cr_mme mme;
    enum cr_err code = cr_mme_load(path, &mme, err);
    bool iso = code == CR_ERR_OK && mme.n > 0;
    cr_mme_fini(&mme);
    if (iso) {
        code = load_mme_channel(path, out, err);
    } else if (code == CR_ERR_OK && test_beside(path, test, sizeof test)) {
        code = load_ev5(test, channel_number(path), NULL, out, err);
    } else if (code == CR_ERR_OK) {
        code = fault(path, err, CR_ERR_MISSING, "the test of this channel is not beside it",
                     "its unit and axis stand in the file .EV5 of the test");
    }
    return code;
}

enum cr_err cr_signal_load_any(const char *path, const struct cr_signal_pick *pick,
                               struct cr_signal *out, struct cr_error *err) {
    char buf[4096];
    memset(out, 0, sizeof *out);
    if (is_folder(path)) {
        return load_folder(path, pick, out, err);
    }
    if (ends(path, ".zip")) {
        return fault(path, err, CR_ERR_TYPE, "an archive", "unzip it and name its folder");
    }
    if (ends(path, ".mme")) {
        cr_file_dir(path, buf, sizeof buf);
        return load_mme(path, buf, pick, out, err);
    }
    return ends(path, ".ev5")         ? load_ev5(path, 0, pick, out, err)
           : channel_number(path) > 0 ? load_channel(path, out, err)
                                      : cr_signal_load(path, pick->column, out, err);
}
