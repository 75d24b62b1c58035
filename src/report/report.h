/* Makes the expert's report: everything that another examiner needs to check and repeat a
 * computation, in English or German. */
#ifndef CR_REPORT_REPORT_H
#define CR_REPORT_REPORT_H

#include "figure/pictures.h"
#include "report/document.h"
#include "report/validity.h"
#include "result/result.h"
#include "study/study.h"

enum cr_lang { CR_LANG_EN, CR_LANG_DE };
/* The words of a language for an English text; the English itself where there are none. */
#if defined(__GNUC__)
__attribute__((format_arg(2)))
#endif
const char *
cr_words(enum cr_lang lang, const char *english);

/* Adds a warning of a result (English) to out in a language; in English where it is not known. */
void cr_warning_words(enum cr_lang lang, const char *english, struct cr_str *out);

struct cr_report_source {
    const struct cr_result *result;
    const struct cr_context *ctx;
    enum cr_lang lang;
    const char *title;                                      /* never NULL */
    const char *author, *case_no, *order, *date, *question; /* NULL: left out */
    const char *program;                                    /* name and version */
    const char *commit;               /* the sources it was built from; "": not known */
    const char *libraries;            /* the libraries it was built with */
    const char *command;              /* the line that makes this report again */
    const char *scene_text;           /* the scene as it was given */
    const char *from_result;          /* what was found when a result file was computed again */
    const struct cr_assumed *assumed; /* what that file assumed; NULL: what `result` assumed */
    char scene_hash[CR_HASH_SIZE], result_hash[CR_HASH_SIZE], data_hash[CR_HASH_SIZE];
    const struct cr_mc *mc;                  /* NULL: no draws were made */
    const char *no_mc;                       /* why there are none */
    const struct cr_validity *validity;      /* NULL: not compared with crash tests */
    const struct cr_face_measured *measured; /* [participants] crush as measured; NULL: none */
    int expects;
    const struct cr_expected *expected; /* [expects] */
    const char *unexpected; /* why the measured values could not be compared; NULL: they could */
    int variants;
    const struct cr_variant *variant; /* [variants] */
};

/* Makes the whole report. The caller frees it with cr_document_fini, also after an error. Errors:
 * MEMORY, those of the pictures. */
CR_MUST_CHECK enum cr_err cr_report_make(const struct cr_report_source *source,
                                         struct cr_document *out, struct cr_error *err);

#endif
