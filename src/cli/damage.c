/* `crumple damage`: EES and delta-v out of measured deformations. */
#include "cli/cli.h"
#include "cli/word.h"
#include "damage/picture.h"

#include <stdio.h>
#include <string.h>

#define FORMATS "text|json"

struct options {
    int format;
    bool picture;
    const char *out;
    struct cr_cli_look look;
    struct cr_error *err;
};

static const char about[] =
    "Works from the damage back: crush profiles of one or two vehicles (FILE) to EES,\n"
    "energy, centre of energy and CDC, with a partner to delta-v and closing speed; every number\n"
    "with the interval that holds 95 %. See crumple(1) for the file.\n";

static enum cr_err write_case(const struct cr_crush_case *what,
                              const struct cr_crush_impact *impact,
                              const struct cr_crush_rules *rules, const struct cr_crush_look *how,
                              const struct options *opt, struct cr_str *text) {
    struct cr_error *err = opt->err;
    if (opt->format == 1) {
        return cr_crush_json(what, impact, text, err);
    }
    enum cr_err code = cr_crush_text(what, impact, text, err);
    for (int i = 0; i < what->n && opt->picture && code == CR_ERR_OK; i++) {
        code = cr_crush_picture(&what->car[i], rules, how, text, err);
    }
    return code;
}

static enum cr_err run(const char *file, const struct options *opt, struct cr_error *err) {
    char path[4200];
    struct cr_cli_shared shared = {0};
    struct cr_crush_rules rules;
    struct cr_crush_file measured;
    struct cr_crush_case what;
    struct cr_crush_impact impact;
    struct cr_arena arena = {0};
    struct cr_str text = {0};
    enum cr_err code = cr_crush_read(file, &measured, err);
    if (code != CR_ERR_OK) {
        return code;
    }
    code = cr_cli_data("damage/calibration.json", path, sizeof path, err);
    if (code == CR_ERR_OK) {
        code = cr_crush_rules_read(path, &rules, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_open(&shared, CR_CLI_NEEDED, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_case_open(&measured, shared.models, &arena, &what, err);
    }
    if (code == CR_ERR_OK) {
        code = cr_crush_solve(&what, &rules, &impact, err);
    }
    if (code != CR_ERR_OK && err->src[0] == '\0') {
        cr_err_place(err, file, 0, 0);
    }
    if (code == CR_ERR_OK) {
        int width;
        struct cr_look look = cr_cli_look_of(&opt->look, opt->out != NULL, &width);
        const struct cr_crush_look how = {.lib = shared.models, .look = &look, .width = width};
        code = write_case(&what, &impact, &rules, &how, opt, &text);
    }
    if (code == CR_ERR_OK) {
        code = cr_cli_emit(opt->out, &text, err);
    }
    cr_str_fini(&text);
    cr_arena_free(&arena);
    cr_crush_file_fini(&measured);
    cr_cli_close(&shared);
    return code;
}

int cr_cli_damage(int argc, char **argv) {
    struct cr_error err = {0};
    struct options opt = {.err = &err};
    const struct cr_option table[] = {
        {.name = "format",
         .letter = 'f',
         .arg = FORMATS,
         .number = &opt.format,
         .help = "form of the result (text)"},
        {.name = "picture",
         .letter = 'p',
         .flag = &opt.picture,
         .help = "the outline over the voxels, from above and from the side"},
        {.name = "output",
         .letter = 'o',
         .arg = "FILE",
         .text = &opt.out,
         .help = "write to FILE, whole or not at all"},
        CR_CLI_LOOK_OPTIONS(&opt.look),
    };
    const struct cr_usage usage = {.word = "damage",
                                   .operands = "FILE.json|FILE.csv",
                                   .about = about,
                                   .option = table,
                                   .options = sizeof table / sizeof *table,
                                   .least = 1,
                                   .most = 1};
    int operands, status = cr_cli_options(&usage, argc, argv, &operands);
    if (status >= 0) {
        return status;
    }
    return run(argv[1], &opt, &err) == CR_ERR_OK ? 0 : cr_cli_fail(&err);
}
