/* Makes the expert's report from its sections. */
#include "report/sections.h"

#include <string.h>

enum cr_err cr_report_make(const struct cr_report_source *s, struct cr_document *out,
                           struct cr_error *err) {
    struct cr_paper p = {.s = s, .r = s->result, .doc = out};
    *out = (struct cr_document){.title = s->title,
                                .author = s->author,
                                .date = s->date,
                                .language = s->lang == CR_LANG_DE ? "de" : "en",
                                .comma = s->lang == CR_LANG_DE};
    cr_section_head(&p);
    cr_section_summary(&p);
    cr_section_inputs(&p);
    cr_section_method(&p);
    enum cr_err code = cr_section_pictures(&p, err);
    code = code != CR_ERR_OK ? code : cr_section_pulses(&p, err);
    code = code != CR_ERR_OK ? code : cr_section_damage(&p, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    cr_section_balance(&p);
    code = cr_section_uncertainty(&p, err);
    if (code == CR_ERR_OK) {
        cr_section_validity(&p);
        cr_section_limits(&p);
        cr_section_annex(&p);
    }
    if (s->result->units == CR_UNITS_US) {
        cr_document_us(out, W(&p, "Unit"));
    }
    if (code == CR_ERR_OK && out->failed) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the report");
    }
    return code;
}
