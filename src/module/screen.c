/* The module of the full screen and of the prompt, which keeps curses and readline out of the
 * program. */
#include "config.h"

#include "module/module.h"

#include "cli/cli.h"
#include "expert/expert.h"
#include "repl/repl.h"
#include "tui/tui.h"

#include <stdio.h>

int cr_screen_main(int argc, char **argv) {
    char data[4096], cars[4096], state[1024];
    const char *data_dir = cr_data_dir(data, sizeof data), *own = cr_own_cars(cars, sizeof cars);
    const char *why = cr_tui_refusal(), *stateless;
    struct cr_repl_start start = {.color = "auto"};
    bool wanted = argc <= 1 || cr_repl_wants_screen(argc, argv, data_dir, &start);
    int status;
    if (start.lines.failed) {
        fprintf(stderr, "crumple: error: no memory for the command line\n");
        status = cr_err_status(CR_ERR_MEMORY);
    } else if (wanted && why == NULL) {
        cr_repl_state_dir(state, sizeof state, &stateless);
        const struct cr_tui_start screen = {.data_dir = data_dir,
                                            .cars_dir = own,
                                            .state_dir = state,
                                            .stateless = stateless,
                                            .ascii = start.ascii,
                                            .color = start.color,
                                            .max_seconds = start.max_seconds,
                                            .max_megabytes = start.max_megabytes,
                                            .lines = cr_str_get(&start.lines),
                                            .report = cr_expert_order};
        status = cr_tui_main(&screen);
    } else if (!wanted && cr_repl_one_scene(argc, argv)) {
        status = cr_cli_run(argc, argv); /* It says what is wrong with the scene. */
    } else {
        if (wanted) {
            fprintf(stderr, "crumple: no full screen (%s), so the plain prompt\n", why);
        }
        status = cr_repl_main(argc, argv, data_dir, own, cr_expert_order, cr_repl_prompt);
    }
    cr_str_fini(&start.lines);
    return status;
}

const struct cr_module crumple_module = {.version = VERSION, .word = cr_screen_main};
