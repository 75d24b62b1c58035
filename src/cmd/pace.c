/* pause and play: what goes at the pace of somebody who watches. */
#include "cmd/cmd_priv.h"

enum cr_err cr_cmd_pause(struct cr_call *call, struct cr_error *err) {
    const struct cr_out *out = &call->s->opts.out;
    if (out->pause != NULL && out->pause(out->user) != 0) {
        return cr_err_set(err, CR_ERR_INTERRUPTED, "given up at this pause");
    }
    return CR_ERR_OK;
}

enum cr_err cr_cmd_play(struct cr_call *call, struct cr_error *err) {
    struct cr_session *s = call->s;
    enum cr_err code = cr_session_need_result(s, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    s->view.rate = cr_cmd_number(call, "rate", s->view.rate);
    s->view.loop = cr_cmd_word(call, "loop", s->view.loop ? 0 : 1) == 0;
    if (s->opts.out.play != NULL) {
        s->opts.out.play(s->opts.out.user, cr_cmd_word(call, "HOW", 0) == 0);
    } else {
        cr_say(s, "only the full screen plays (crumple alone); here: show time=20ms");
    }
    return CR_ERR_OK;
}
