/* Options of a command line word: one table per word parses, checks and explains itself.
 *
 * Nothing is copied: texts and operands point into argv. */
#ifndef CR_CLI_OPTIONS_H
#define CR_CLI_OPTIONS_H

#include "base/err.h"
#include "base/str.h"

#include <stdbool.h>

enum { CR_OPTION_REPEAT_MAX = 256 };

/* Values of an option that may be given several times, in order. */
struct cr_option_values {
    int n;
    const char *value[CR_OPTION_REPEAT_MAX];
};

/* One option. Exactly one of flag, number, text and values says what it is and where it goes; what
 * is not given keeps the value it had, so the caller's initialisation is the default. */
struct cr_option {
    const char *name; /* without the dashes */
    char letter;      /* short form, 0: none */
    const char *arg;  /* name of its value in the help; "a|b|c" with `number`: one of these words */
    const char *help;
    bool *flag;
    int *number;       /* an integer lo..hi, or the index of the word */
    const char **text; /* "" is refused */
    struct cr_option_values *values;
    int lo, hi;
};

/* Rows of a table of options, by what they take. letter 0: none; `to` points to where the value
 * goes. A number lies in lo..hi; a word is one of "a|b|c" and comes as its index. */
#define CR_OPTION_NUMBER(long_name, short_name, to, least, most, text)                             \
    {                                                                                              \
        .name = long_name, .letter = short_name, .arg = "N", .number = to, .lo = least,            \
        .hi = most, .help = text                                                                   \
    }
#define CR_OPTION_WORD(long_name, short_name, words, to, text)                                     \
    { .name = long_name, .letter = short_name, .arg = words, .number = to, .help = text }
#define CR_OPTION_TEXT(long_name, short_name, what, to, text_of_help)                              \
    { .name = long_name, .letter = short_name, .arg = what, .text = to, .help = text_of_help }
#define CR_OPTION_VALUES(long_name, short_name, what, to, text)                                    \
    { .name = long_name, .letter = short_name, .arg = what, .values = to, .help = text }
#define CR_OPTION_FLAG(long_name, short_name, to, text)                                            \
    { .name = long_name, .letter = short_name, .flag = to, .help = text }

struct cr_usage {
    const char *word;     /* "run" */
    const char *operands; /* as the help shows them: "SCENE.json" */
    const char *about;    /* lines of text, each ending in a newline */
    const struct cr_option *option;
    int options;
    int least, most;        /* number of operands; most < 0: any */
    const char *candidates; /* "a|b|c": operands that completion offers; NULL: files */
};

/* The usage of a word whose operands are files and whose options are an array. */
#define CR_USAGE(name, files, text, table, fewest, greatest)                                       \
    {                                                                                              \
        .word = name, .operands = files, .about = text, .option = table,                           \
        .options = sizeof table / sizeof *table, .least = fewest, .most = greatest                 \
    }

/* Parse argv (argv[0] is the word itself). Options and operands may be mixed, "--" ends the
 * options, "-" is an operand. The operands are moved to argv[1] ... argv[*operands]. *help is set
 * when -h or --help was met, which ends the parsing. Errors: USAGE with the nearest spelling or the
 * range. */
CR_MUST_CHECK enum cr_err cr_options_parse(const struct cr_usage *usage, int argc, char **argv,
                                           int *operands, bool *help, struct cr_error *err);

/* The help text that belongs to the table, appended to out. */
void cr_options_help(const struct cr_usage *usage, struct cr_str *out);

#endif
