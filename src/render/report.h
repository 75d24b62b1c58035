/* What the files that write the report in text share: a page that grows line by line. */
#ifndef CR_RENDER_REPORT_H
#define CR_RENDER_REPORT_H

#include "render/render_priv.h"

struct cr_page {
    const struct cr_result *result;
    const struct cr_look *look;
    int width;
    struct cr_str *out;
};

/* Adds cells to the page and frees them. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_page_emit(const struct cr_page *page, struct cr_cells *cells,
                                       struct cr_error *err);
/* Adds a blank line and "-- Title ------ note --". Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_page_heading(const struct cr_page *page, const char *title,
                                          const char *note, struct cr_error *err);
/* Draws such a heading into the first row of the target. */
void cr_page_draw_heading(const struct cr_target *target, const char *title, const char *note);
/* Adds a text, broken at blanks to the width; lines after the first are indented. Errors:
 * MEMORY. */
CR_MUST_CHECK enum cr_err cr_page_paragraph(const struct cr_page *page, int indent,
                                            enum cr_role role, const char *text,
                                            struct cr_error *err);
/* Adds the phases of the crash, a line per contact. Errors: MEMORY. */
CR_MUST_CHECK enum cr_err cr_page_phases(const struct cr_page *page, struct cr_error *err);

#endif
