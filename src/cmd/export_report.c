/* export: the expert's report, made by whom the session was opened with. */
#include "cmd/export.h"

#include "report/order.h"

#include <stdio.h>

static int drawn(void *user, int done, int draws) {
    return cr_work_count(user, "report", done, draws);
}

static int cancelled(void *user) {
    return cr_work_cancelled(user);
}

enum cr_err cr_export_report(struct cr_export *x, struct cr_error *err) {
    struct cr_session *s = x->s;
    const struct cr_scene *scene = cr_session_scene(s);
    char from[CR_PATH_MAX + 8];
    const char *file = cr_session_now(s)->file;
    bool saved = file[0] != '\0';
    snprintf(from, sizeof from, "%s%s", saved ? file : scene->name, saved ? "" : ".json");
    const struct cr_report_order order = {.scene = scene,
                                          .from = from,
                                          .path = x->path,
                                          .author = cr_cmd_text(x->call, "author", NULL),
                                          .case_no = cr_cmd_text(x->call, "case", NULL),
                                          .german = cr_cmd_word(x->call, "lang", 0) == 1,
                                          .us = s->units == CR_UNITS_US,
                                          .no_tests = cr_cmd_word(x->call, "tests", 0) == 1,
                                          .draws = (int)cr_cmd_number(x->call, "draws", 300),
                                          .max_seconds = s->opts.max_seconds,
                                          .max_bytes = cr_work_max_bytes(s),
                                          .progress = drawn,
                                          .cancel = cancelled,
                                          .user = s};
    if (s->opts.report == NULL) {
        return cr_err_set(err, CR_ERR_MISSING, "no reports are made here");
    }
    s->solving = true;
    cr_work_begin(s);
    enum cr_err code = s->opts.report(&order, err);
    cr_work_end(s);
    s->solving = false;
    x->written = true;
    return code;
}
