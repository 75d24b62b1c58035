/* Any bytes as a command file: every error has a text, and the scene is as it was after it. Work
 * that takes long or writes files is left out: those commands are refused before they run. */
#include "fuzz.h"

#include "cmd/cmd.h"

#include <stdlib.h>
#include <string.h>

static int faults;

static void fault(void *user, const struct cr_fault *f) {
    struct cr_str text = {0};
    (void)user;
    if (f->err.code == CR_ERR_OK || f->err.text[0] == '\0' || f->col < 1 || f->len < 0) {
        abort();
    }
    cr_fault_text(f, -1, &text);
    cr_fault_text(f, 9, &text);
    cr_str_fini(&text);
    faults++;
}

/* save, export, sweep out= write files; source reads any; no crash is solved here */
static bool harmless(const char *text) {
    static const char *const words[] = {"sa", "ex", "sw", "so", "load", "co", "pu", "model"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        if (strstr(text, words[i]) != NULL) {
            return false;
        }
    }
    return true;
}

static void complete(struct cr_session *s, const char *text) {
    struct cr_completion list;
    struct cr_error err;
    struct cr_str hint = {0};
    int len = (int)strlen(text);
    for (int at = 0; at <= len; at += 1 + len / 4) {
        if (cr_session_complete(s, text, at, &list, &err) == CR_ERR_OK) {
            if (list.start < 0 || list.start > at || list.end != at) {
                abort();
            }
            cr_completion_fini(&list);
        }
        cr_session_hint(s, text, at, &hint);
    }
    cr_str_fini(&hint);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct cr_session_opts opts = {.data_dir = "", .out = {.fault = fault}};
    struct cr_session *s;
    struct cr_error err;
    char *text = malloc(size + 1);
    if (text == NULL || cr_session_new(&opts, &s, &err) != CR_ERR_OK) {
        free(text);
        return 0;
    }
    memcpy(text, data, size);
    text[size] = '\0';
    if (harmless(text)) {
        faults = 0;
        int before = cr_session_scene(s)->n;
        enum cr_err code = cr_session_script(s, text, "fuzz", 1);
        if ((code != CR_ERR_OK) != (faults > 0) || cr_session_scene(s)->n < before) {
            abort();
        }
        complete(s, text);
    }
    cr_session_free(s);
    free(text);
    return 0;
}
