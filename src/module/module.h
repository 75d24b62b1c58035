/* Modules: the parts of the program that need large libraries, each a shared object beside the
 * program, so that all else starts without those libraries. A module is linked with all that it
 * calls and exports one table, crumple_module; load.c loads it when the program comes to it. */
#ifndef CR_MODULE_MODULE_H
#define CR_MODULE_MODULE_H

#include "figure/canvas.h"

/* What a module does; functions that it does not have are NULL. */
struct cr_module {
    const char *version; /* of the program that it belongs to */
    int (*word)(int argc, char **argv);
    enum cr_err (*need_cairo)(struct cr_error *err);
    enum cr_err (*pdf)(struct cr_canvas *const *page, int pages, const struct cr_pdf_about *about,
                       struct cr_str *out, struct cr_error *err);
    enum cr_err (*png)(const struct cr_canvas *canvas, double dpi, struct cr_str *out,
                       struct cr_error *err);
};
extern __attribute__((visibility("default"))) const struct cr_module crumple_module;

/* Run the full screen (curses) or the prompt (readline), whichever the words of the command line
 * and the terminal allow. Returns the exit status of crumple(1). */
int cr_screen_main(int argc, char **argv);

#endif
