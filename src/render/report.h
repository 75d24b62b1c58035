/* The report, inside: a page that grows line by line. */
#ifndef CR_RENDER_REPORT_H
#define CR_RENDER_REPORT_H

#include "render/render_priv.h"

struct cr_page {
    const struct cr_result *result;
    const struct cr_look *look;
    int width;
    struct cr_str *out;
};

/* Add cells to the page and free them. */
CR_MUST_CHECK enum cr_err cr_page_emit(const struct cr_page *page, struct cr_cells *cells,
                                       struct cr_error *err);
/* A blank line and "-- Title ------ note --". */
CR_MUST_CHECK enum cr_err cr_page_heading(const struct cr_page *page, const char *title,
                                          const char *note, struct cr_error *err);
/* The same into cells. */
void cr_page_draw_heading(const struct cr_target *target, const char *title, const char *note);
/* Text broken at blanks to the width, lines after the first indented. */
CR_MUST_CHECK enum cr_err cr_page_paragraph(const struct cr_page *page, int indent,
                                            enum cr_role role, const char *text,
                                            struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_page_phases(const struct cr_page *page, struct cr_error *err);

#endif
