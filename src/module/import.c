/* The module of `crumple import`, which keeps SQLite, libzip and expat out of the program. */
#include "config.h"

#include "module/module.h"

#include "cli/cli.h"

const struct cr_module crumple_module = {.version = VERSION, .word = cr_cli_import};
