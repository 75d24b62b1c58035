/* Parts of `crumple models`: what is known of each of the 72 models, as text and JSON. */
#ifndef CR_CLI_MODELS_H
#define CR_CLI_MODELS_H

#include "base/err.h"
#include "base/str.h"
#include "model/model.h"

struct cJSON;

/* The recipes as JSON, for what the library does not keep: calibration, provenance, structures. */
struct cr_model_papers {
    struct cJSON *recipe[CR_TYPES];
};
CR_MUST_CHECK enum cr_err cr_model_papers_read(const char *dir, struct cr_model_papers *out,
                                               struct cr_error *err);
void cr_model_papers_fini(struct cr_model_papers *papers);

/* A line for each model of a type (CR_TYPES: of all): tests, mean error, scatter, assumptions. */
void cr_model_list_text(const struct cr_model_papers *papers, int type, int clock,
                        struct cr_str *out);
/* The same as a JSON array. */
CR_MUST_CHECK enum cr_err cr_model_list_json(const struct cr_model_papers *papers, int type,
                                             int clock, struct cr_str *out, struct cr_error *err);

/* What a type is made of: dimensions, faces, structures, provenance. */
void cr_model_about(const struct cr_model_papers *papers, const struct cr_model_lib *lib,
                    enum cr_type type, struct cr_str *out);

/* Provenance of a model for its file, a JSON object. */
void cr_model_provenance(const struct cr_model_papers *papers, const struct cr_model_lib *lib,
                         enum cr_type type, int clock, struct cr_str *out);

#endif
