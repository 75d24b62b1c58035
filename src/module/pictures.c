/* The module of PNG pictures and PDF pages, which keeps cairo out of the program. */
#include "config.h"

#include "module/module.h"

const struct cr_module crumple_module = {.version = VERSION,
                                         .need_cairo = cr_canvas_need_cairo,
                                         .pdf = cr_canvas_pdf,
                                         .png = cr_canvas_png};
