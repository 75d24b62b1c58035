/* Where the program begins: the first word of the command line chooses a scene to solve, a bench,
 * the prompt or the full screen. */
#include "config.h"

#include "base/arena.h"
#include "base/show.h"
#include "base/str.h"
#include "cli/cli.h"
#include "expert/expert.h"
#include "module/module.h"
#include "repl/repl.h"
#include "trial/trial.h"

#include <fcntl.h>
#include <locale.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char help[] =
    "usage: crumple                          full screen on a terminal, else commands from stdin\n"
    "       crumple SCENE.json               opens it there; into a pipe or file: as run\n"
    "       crumple FILE.crumple ...         command files in order ( - is standard input )\n"
    "       crumple -e 'COMMAND' ...         commands likewise; -i stays interactive afterwards\n"
    "       crumple --repl                   commands at a plain prompt\n"
    "       crumple run SCENE.json           solve one scene\n"
    "       crumple stack INPUT ...          solve many, one result per line\n"
    "       crumple merge PART ...           put the parts of a stack in order\n"
    "       crumple import FILE ...          scenes out of other people's files\n"
    "       crumple validate [CLASS ...]     compare with crash tests\n"
    "       crumple damage FILE.json         EES and delta-v out of a measured deformation\n"
    "       crumple fit SCENE.json ... to ... search inputs that explain what was measured\n"
    "       crumple mc SCENE.json            solve many draws of its uncertain inputs\n"
    "       crumple catalogue [WORD ...]     list the cars that scenes can name\n"
    "       crumple report SCENE|RESULT      expert's report as HTML or PDF\n"
    "       crumple diff A.json B.json       two results, or scenes, side by side\n"
    "       crumple audit RESULT [SCENE]     compute a result again and compare\n"
    "       crumple models [NAME]            list, show or export the models\n"
    "       crumple schema [NAME]            print a JSON Schema, of scenes for example\n"
    "       crumple calibrate                fit the models to the crash tests again\n"
    "       crumple help [WORD] | --version  this, what a word or a command takes\n"
    "\n"
    "Commands take --ascii, --color=, --max-seconds=N and --max-memory=MB too, as run does.\n"
    "crumple run --help explains run, and likewise for the other words.\n"
    "Exit status: 0 done; 1 an assert or compare missed its tolerance, or a scene of a stack\n"
    "failed; 2 usage or file system; 3 a script or JSON file is invalid; 4 the solver failed;\n"
    "130 interrupted.\n";

static const char version[] =
    "built with " CR_LIBRARIES "\n"
    "sanitizers: " CR_SANITIZERS "\n"
    "Free software under the GNU General Public License, version 3 or later; no warranty.\n";

struct word {
    const char *name;
    int (*run)(int argc, char **argv);
};
static int tell_help(int argc, char **argv);
static const struct word words[] = {
    {"help", tell_help},
    {"run", cr_cli_run},
    {"catalogue", cr_cli_catalogue},
    {"stack", cr_cli_stack},
    {"merge", cr_cli_merge},
    {"import", cr_cli_import},
    {"mc", cr_cli_mc},
    {"validate", cr_trial_validate},
    {"models", cr_cli_models},
    {"schema", cr_cli_schema},
    {"damage", cr_cli_damage},
    {"diff", cr_cli_diff},
    {"calibrate", cr_trial_calibrate},
    {"calibrate-damage", cr_trial_calibrate_damage},
    {"fit", cr_cli_fit},
    {"report", cr_expert_report},
    {"audit", cr_expert_audit},
};
enum { WORDS = sizeof words / sizeof *words };

static int print(const char *text) {
    if (fputs(text, stdout) == EOF || fflush(stdout) != 0) {
        perror("crumple: error: cannot write to standard output");
        return 2;
    }
    return 0;
}

static int print_version(void) {
    char text[sizeof version + 200];
    bool known = cr_commit[0] != '\0';
    snprintf(text, sizeof text, "%s%s%s\n%s", PACKAGE_STRING, known ? ", commit " : "", cr_commit,
             version);
    return print(text);
}

/* "crumple help": this; "crumple help run": its options; "crumple help sweep": the command */
static int tell_help(int argc, char **argv) {
    static char option[] = "--help", e[] = "-e";
    char line[300], data[4096];
    if (argc < 2) {
        return print(help);
    }
    bool completes = strcmp(argv[1], "--complete") == 0;
    for (int i = 0; i < WORDS; i++) {
        if (completes && strncmp(words[i].name, argv[argc - 1], strlen(argv[argc - 1])) == 0) {
            puts(words[i].name);
        } else if (strcmp(argv[1], words[i].name) == 0 && words[i].run != tell_help) {
            char *asked[] = {argv[1], option, NULL};
            return words[i].run(2, asked);
        }
    }
    if (completes) {
        return 0;
    }
    snprintf(line, sizeof line, "help %.200s", argv[1][0] != '-' ? argv[1] : "help");
    char *commands[] = {argv[0], e, line, NULL};
    return cr_repl_main(3, commands, cr_data_dir(data, sizeof data), "", cr_expert_order, NULL);
}

static int unknown(const char *what, const char *given) {
    const char *known[WORDS + 2] = {"--help", "--version"};
    for (int i = 0; i < WORDS; i++) {
        known[i + 2] = words[i].name;
    }
    const char *near = cr_str_nearest(given, known, WORDS + 2);
    char shown[256];
    fprintf(stderr, "crumple: error: unknown %s %s (%s%s%s)\n", what,
            cr_show(given, shown, sizeof shown),
            near != NULL ? "did you mean " : "crumple --help lists them", near != NULL ? near : "",
            near != NULL ? "?" : "");
    return 2;
}

/* With one of the first three descriptors closed, the next file that is opened would get its
 * number, and what is meant for the user would go there. What takes its place fails like what is
 * closed. */
static void keep_descriptors(void) {
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
        if (fcntl(fd, F_GETFD) == -1 &&
            open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) != fd) {
            _exit(2);
        }
    }
}

/* "crumple --completions WORD ...": what may stand for the last one; for the shells' completion */
static int complete(int argc, char **argv) {
    static char complete_word[] = "--complete";
    static const char *const options[] = {"--help", "--version", "--repl",  "-e",
                                          "-i",     "--ascii",   "--color="};
    struct cr_str out = {0};
    if (argc > 3) {
        char *word = argv[2];
        argv[1] = word;
        argv[2] = complete_word;
        for (int i = 0; i < WORDS; i++) {
            if (strcmp(word, words[i].name) == 0) {
                return words[i].run(argc - 1, argv + 1);
            }
        }
        return 0;
    }
    const char *begun = argc > 2 ? argv[2] : "";
    for (int i = 0; i < WORDS; i++) {
        char shown[64];
        snprintf(shown, sizeof shown, "crumple %s ", words[i].name);
        if (strncmp(words[i].name, begun, strlen(begun)) == 0 && strstr(help, shown) != NULL) {
            cr_str_addf(&out, "%s\n", words[i].name);
        }
    }
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        if (begun[0] == '-' && strncmp(options[i], begun, strlen(begun)) == 0) {
            cr_str_addf(&out, "%s\n", options[i]);
        }
    }
    int status = print(out.failed ? "" : cr_str_get(&out)); /* half a list would mislead */
    status = out.failed ? cr_err_status(CR_ERR_MEMORY) : status;
    cr_str_fini(&out);
    return status;
}

/* files, scenes, -e and what belongs to them */
static int session(int argc, char **argv) {
    char data[4096], cars[4096];
    if (isatty(STDIN_FILENO) && isatty(STDOUT_FILENO)) {
        return cr_screen_main(argc, argv);
    }
    return cr_repl_one_scene(argc, argv)
               ? cr_cli_run(argc, argv) /* nobody is there to look at it */
               : cr_repl_main(argc, argv, cr_data_dir(data, sizeof data),
                              cr_own_cars(cars, sizeof cars), cr_expert_order, NULL);
}

int main(int argc, char **argv) {
    keep_descriptors();
    cr_arena_keep();
    /* Characters are those of the terminal. All else is the same everywhere: the decimal point, the
     * order of the files of a folder, the language of messages that stand in results. */
    setlocale(LC_CTYPE, "");
    const char *word = argc > 1 ? argv[1] : "";
    if (strcmp(word, "--version") == 0 || strcmp(word, "-V") == 0 || strcmp(word, "-v") == 0 ||
        strcmp(word, "version") == 0) {
        return print_version();
    }
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
        return print(help);
    }
    if (strcmp(word, "--completions") == 0) {
        return complete(argc, argv);
    }
    for (int i = 0; i < WORDS; i++) {
        if (strcmp(word, words[i].name) == 0) {
            return words[i].run(argc - 1, argv + 1);
        }
    }
    if (argc <= 1 || word[0] == '\0' || cr_repl_takes(word)) {
        return session(argc, argv);
    }
    return unknown(word[0] == '-' ? "option" : "word", word);
}
