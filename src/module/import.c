/* Module: the word import, with SQLite, libzip and expat. */
#include "config.h"

#include "module/module.h"

#include "cli/cli.h"

const struct cr_module crumple_module = {.version = VERSION, .word = cr_cli_import};
