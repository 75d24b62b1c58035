/* The manual page of the commands, from the command table: make update-manual writes it, make check
 * compares it with man/crumple-commands.7. */
#include "cmd/cmd.h"

#include <stdio.h>

static const char head[] =
    ".\\\" made from the command table by make update-manual; do not edit\n"
    ".TH CRUMPLE\\-COMMANDS 7 2026-11-28 \"crumple\" \"Miscellaneous Information\"\n"
    ".ad l\n" /* lists of words are broken where a justified line could not be */
    ".SH NAME\n"
    "crumple\\-commands \\- the command language of crumple\n"
    ".SH SYNOPSIS\n"
    ".nf\n"
    "line  = [ command { word } ] [ # comment ]    ; separates, \\e at the end continues\n"
    "word  = name | key=value | \\-\\-flag\n"
    "value = number[unit] | name | \"text\" | from:to:step\n"
    ".fi\n"
    ".SH DESCRIPTION\n"
    "Everything that changes a scene or a view of\n"
    ".BR crumple (1)\n"
    "is a command: at the prompt of\n"
    ".BR \"crumple \\-\\-repl\" ,\n"
    "in command files\n"
    ".RI ( FILE.crumple ),\n"
    "on standard input, after\n"
    ".B \\-e\n"
    "and on the full screen, where each key and click is one of these commands.\n"
    "Any unique prefix of a command, key or flag is enough.\n"
    ".PP\n"
    "Text with blanks, semicolons or # is put in quotes; in it \\e\" stands for \" and \\e\\e for "
    "\\e.\n"
    "A command that overwrites files or loses changes takes\n"
    ".B !\n"
    "after its name, as in\n"
    ".BR save! .\n"
    ".PP\n"
    "A number may have a unit: m cm mm km ft in, km/h m/s mph, kg t lb, deg rad, s ms, %, N kN, J "
    "kJ,\n"
    "g m/s2, kgm2, deg/s rad/s.\n"
    "Without one it is in the unit that is named with its key;\n"
    ".B speed=35mph\n"
    "and\n"
    ".B mass=1.4t\n"
    "are fine.\n"
    "A unit of the wrong kind is an error.\n"
    ".PP\n"
    "In a command file the first error ends the run with its file, line and column; at the prompt "
    "it\n"
    "leaves scene and result as they were.\n"
    "A file that begins with #! can be executed.\n"
    ".B set echo on\n"
    "shows the lines of a file, comments included, as they are run.\n"
    ".SH HISTORY AND RECOVERY\n"
    "At the prompt each line is kept in\n"
    ".I $XDG_STATE_HOME/crumple/history\n"
    "(by default below\n"
    ".IR ~/.local/state )\n"
    "as soon as it is typed, and while changes are unsaved the scene is kept beside it.\n"
    "After a crash of the machine the next start says so, and\n"
    ".B load \\-\\-recover\n"
    "brings the scene back.\n"
    "Every change of the scene can be undone.\n"
    "Settings of readline\n"
    ".RI ( ~/.inputrc )\n"
    "apply, with the application name crumple.\n"
    ".SH COMMANDS\n";
static const char foot[] = ".SH EXIT STATUS\n"
                           "0 done; 1 an assert or compare missed its tolerance; 2 usage or file "
                           "system; 3 the command file or a\n"
                           "JSON file is invalid; 4 the solver failed; 130 interrupted.\n"
                           ".SH FILES\n"
                           ".TP\n"
                           ".I share/tutorial/*.crumple\n"
                           "five lessons, to be run with\n"
                           ".B crumple\n"
                           "or\n"
                           ".B source\n"
                           ".TP\n"
                           ".I $XDG_STATE_HOME/crumple/history\n"
                           "the lines typed\n"
                           ".TP\n"
                           ".I $XDG_STATE_HOME/crumple/autosave\\-PID.json\n"
                           "the scene of a session with unsaved changes\n"
                           ".SH SEE ALSO\n"
                           ".BR crumple (1)\n";

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
