/* The sections of the expert's report, in its order, and what they share. */
#ifndef CR_REPORT_SECTIONS_H
#define CR_REPORT_SECTIONS_H

#include "report/report.h"
#include "result/measures.h"

struct cr_paper {
    const struct cr_report_source *s;
    const struct cr_result *r;
    struct cr_document *doc;
};

/* An English text in the language of the paper. */
#define W(paper, english) cr_words((paper)->s->lang, english)

/* Add a row or a head, made of cells, to the table that was begun last. */
#define ROW(paper, ...) cr_doc_row((paper)->doc, (const char *const[CR_COLUMNS]){__VA_ARGS__})
#define HEAD(paper, ...)                                                                           \
    do {                                                                                           \
        struct cr_doc_row *head_ = ROW(paper, __VA_ARGS__);                                        \
        if (head_ != NULL) {                                                                       \
            head_->head = true;                                                                    \
        }                                                                                          \
    } while (0)

/* A number with so many decimals; what rounds to zero has no sign. */
const char *cr_paper_number(const struct cr_paper *paper, int decimals, double x);
/* Whether results of a participant are reported. */
bool cr_paper_is_vehicle(const struct cr_paper *paper, int body);
/* The words and units of the pictures. */
struct cr_figure_words cr_paper_words(const struct cr_paper *paper);
/* "23.4 km/h (20.1 to 26.9)": a result with the range that holds 95 % of the draws; without draws
 * it says so. */
const char *cr_paper_interval(const struct cr_paper *paper, int body, const struct cr_measure *m);

void cr_section_head(struct cr_paper *paper);
void cr_section_summary(struct cr_paper *paper);
void cr_section_inputs(struct cr_paper *paper);
void cr_section_method(struct cr_paper *paper);
enum cr_err cr_section_pictures(struct cr_paper *paper, struct cr_error *err);
enum cr_err cr_section_pulses(struct cr_paper *paper, struct cr_error *err);
enum cr_err cr_section_damage(struct cr_paper *paper, struct cr_error *err);
void cr_section_balance(struct cr_paper *paper);
enum cr_err cr_section_uncertainty(struct cr_paper *paper, struct cr_error *err);
void cr_section_validity(struct cr_paper *paper);
void cr_section_limits(struct cr_paper *paper);
void cr_section_annex(struct cr_paper *paper);

#endif
