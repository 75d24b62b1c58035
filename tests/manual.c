/* The manual page of the commands, from the command table: make update-manual writes it, make check
 * compares it with man/crumple-commands.7. */
#include "cmd/cmd.h"

#include <stdio.h>

static const char head[] =
    ".\\\" made from the command table by make update-manual; do not edit\n"
    ".TH CRUMPLE\\-COMMANDS 7 \"\" \"crumple\" \"Miscellaneous Information\"\n"
    ".SH NAME\n"
    "crumple\\-commands \\- the commands of crumple\n"
    ".SH SYNOPSIS\n"
    ".nf\n"
    "line  = [ command { word } ] [ # comment ]    ; separates, \\e at the end continues\n"
    "word  = name | key=value | \\-\\-flag\n"
    "value = number[unit] | name | \"text\" | from:to:step\n"
    ".fi\n"
    ".SH DESCRIPTION\n"
    "The same commands work on the full screen, at the prompt of\n"
    ".B crumple \\-\\-repl\n"
    "and in command files, whose names end in\n"
    ".BR .crumple .\n"
    "Unique prefixes of commands and keys are enough.\n"
    "A number without a unit has the one that is named with its key;\n"
    ".B speed=35mph\n"
    "and\n"
    ".B mass=1.4t\n"
    "are fine.\n"
    "A command file stops at its first error, with file, line and column.\n"
    ".SH COMMANDS\n";
static const char foot[] = ".SH SEE ALSO\n.BR crumple (1)\n";

int main(void) {
    struct cr_str page = {0};
    int n;
    const struct cr_command *commands = cr_commands(&n);
    cr_str_add(&page, head);
    for (int i = 0; i < n; i++) {
        cr_command_roff(&commands[i], &page);
    }
    cr_str_add(&page, foot);
    int failed = page.failed || fputs(cr_str_get(&page), stdout) == EOF || fflush(stdout) != 0;
    cr_str_fini(&page);
    return failed;
}
