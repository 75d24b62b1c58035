/* crumple_damage: computes EES and delta-v from a measured deformation, by the library. */
#include "lib/lib_priv.h"

static enum cr_err solve(const crumple *lib, struct cr_crush_file *measured, struct cr_str *out,
                         struct cr_error *err) {
    struct cr_crush_case what;
    struct cr_crush_impact impact;
    struct cr_arena arena = {0};
    enum cr_err code = cr_crush_case_open(measured, lib->models, &arena, &what, err);
    if (code == CR_ERR_OK) {
        code = cr_crush_solve(&what, &lib->rules, &impact, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_json(&what, &impact, out, err);
    }
    cr_arena_free(&arena);
    return code;
}

int crumple_damage(const crumple *lib, const char *text, size_t length,
                   const crumple_options *options, char **json, crumple_error *error) {
    struct cr_error err = {0};
    const crumple_options opt = cr_lib_options(options);
    struct cr_crush_file measured;
    struct cr_str out = {0};
    *json = NULL;
    locale_t callers = uselocale(lib->c_locale);
    enum cr_err code = cr_crush_parse(text, length, opt.name, &measured, &err);
    if (code == CR_ERR_OK) {
        code = solve(lib, &measured, &out, &err);
        cr_crush_file_fini(&measured);
    }
    uselocale(callers);
    if (code == CR_ERR_OK && out.failed) {
        code = cr_err_set(&err, CR_ERR_MEMORY, "no memory for the JSON of a deformation");
    }
    if (code != CR_ERR_OK) {
        cr_str_fini(&out);
        return cr_lib_error(code, &err, error);
    }
    *json = out.s;
    return CRUMPLE_OK;
}
