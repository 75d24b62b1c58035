/* Opens a session: the one place that knows both the session and the table of its commands. */
#include "cmd/cmd_priv.h"

enum cr_err cr_session_new(const struct cr_session_opts *opts, struct cr_session **out,
                           struct cr_error *err) {
    enum cr_err code = cr_session_make(opts, out, err);
    if (code == CR_ERR_OK) {
        (*out)->command = cr_commands(&(*out)->commands);
    }
    return code;
}
