/* The clock of long work: when progress is due, and when to look whether the user cancels. */
#include "cmd/cmd_priv.h"

#include "process/clock.h"

#include <math.h>

#define FIRST_SHOW 0.3  /* s of work before progress is shown */
#define SHOW_EVERY 0.1  /* s between two shows */
#define POLL_EVERY 0.01 /* s between two looks for a cancel */

double cr_work_max_bytes(const struct cr_session *s) {
    return 1e6 * (s->opts.max_megabytes > 0 ? s->opts.max_megabytes : CR_MAX_MEGABYTES);
}

void cr_work_begin(struct cr_session *s) {
    s->work_began = cr_clock_wall();
    s->work_processor = cr_clock_thread();
    s->work_polled = -1; /* the first look is at once, however fast the work is */
    s->work_shown = 0;
}

double cr_work_end(struct cr_session *s) {
    if (s->work_shown > 0 && s->opts.out.progress != NULL) {
        s->opts.out.progress(s->opts.out.user, NULL);
    }
    return cr_clock_wall() - s->work_began;
}

bool cr_work_due(struct cr_session *s, double *elapsed) {
    double now = cr_clock_wall();
    *elapsed = now - s->work_began;
    if (s->opts.out.progress == NULL || *elapsed < FIRST_SHOW || now - s->work_shown < SHOW_EVERY) {
        return false;
    }
    s->work_shown = now;
    return true;
}

int cr_work_cancelled(struct cr_session *s) {
    double now = cr_clock_wall();
    if (s->opts.out.cancel == NULL || now - s->work_polled < POLL_EVERY) {
        return 0;
    }
    s->work_polled = now;
    return s->opts.out.cancel(s->opts.out.user);
}

int cr_work_count(struct cr_session *s, const char *what, int done, int total) {
    double elapsed;
    if (cr_work_due(s, &elapsed)) {
        struct cr_progress p = {.what = what,
                                .share = (double)done / total,
                                .done = done,
                                .total = total,
                                .elapsed = elapsed,
                                .left = done > 0 ? elapsed / done * (total - done) : (double)NAN,
                                .time = NAN};
        s->opts.out.progress(s->opts.out.user, &p);
    }
    return cr_work_cancelled(s);
}
