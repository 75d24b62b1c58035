/* Parts of the program that need large libraries: each is a shared object of its own beside the
 * program, a module, so that what does not need it starts without those libraries. A module has
 * all that it calls inside and gives away one table. */
#ifndef CR_MODULE_MODULE_H
#define CR_MODULE_MODULE_H

#include "figure/canvas.h"

/* What a module does; the others are NULL. */
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

/* Files, scenes, -e and what belongs to them on a terminal: the full screen or the prompt, curses
 * and readline. Returns the exit status of crumple(1). */
int cr_screen_main(int argc, char **argv);

#endif
