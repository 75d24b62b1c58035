/* Option tables: what is parsed, what is refused, and what is printed about them. */
#include "test.h"

#include "cli/options.h"

#include <stdio.h>
#include <string.h>

enum { ARG_MAX_TEST = 16 };

struct got {
    bool trace, quiet;
    int format, jobs;
    const char *out;
    struct cr_option_values set;
    int operands;
    bool help;
    char *argv[ARG_MAX_TEST];
    struct cr_error err;
};

/* a table with one option of each kind, parsed over the words of a line */
static enum cr_err parse(struct got *g, char *line) {
    memset(g, 0, sizeof *g);
    g->jobs = 1;
    const struct cr_option table[] = {
        {.name = "trace", .letter = 't', .flag = &g->trace, .help = "a switch"},
        {.name = "quiet", .letter = 'q', .flag = &g->quiet, .help = "another"},
        {.name = "format", .arg = "json|text|csv", .number = &g->format, .help = "a word"},
        {.name = "jobs",
         .letter = 'j',
         .arg = "N",
         .number = &g->jobs,
         .lo = 1,
         .hi = 64,
         .help = "a number"},
        {.name = "output", .letter = 'o', .arg = "FILE", .text = &g->out, .help = "a text"},
        {.name = "set", .letter = 's', .arg = "KEY=VALUE", .values = &g->set, .help = "a list"},
    };
    const struct cr_usage usage = {.word = "run",
                                   .operands = "SCENE",
                                   .about = "About.\n",
                                   .option = table,
                                   .options = 6,
                                   .least = 1,
                                   .most = 2};
    int argc = 0;
    char *save = NULL;
    g->argv[argc++] = line;
    for (char *w = strtok_r(line, " ", &save); w != NULL; w = strtok_r(NULL, " ", &save)) {
        assert_true(argc < ARG_MAX_TEST);
        g->argv[argc++] = w;
    }
    return cr_options_parse(&usage, argc, g->argv, &g->operands, &g->help, &g->err);
}

static void test_every_form_of_an_option(void **state) {
    (void)state;
    struct got g;
    char a[] = "x.json --format=csv -tq -o out.csv --set a=1 -sb=2 --jobs 8 -";
    assert_int_equal(parse(&g, a), CR_ERR_OK);
    assert_int_equal(g.operands, 2);
    assert_string_equal(g.argv[1], "x.json");
    assert_string_equal(g.argv[2], "-");
    assert_int_equal(g.format, 2);
    assert_true(g.trace && g.quiet && !g.help);
    assert_string_equal(g.out, "out.csv");
    assert_int_equal(g.set.n, 2);
    assert_string_equal(g.set.value[0], "a=1");
    assert_string_equal(g.set.value[1], "b=2");
    assert_int_equal(g.jobs, 8);

    char b[] = "-- --trace";
    assert_int_equal(parse(&g, b), CR_ERR_OK);
    assert_false(g.trace);
    assert_string_equal(g.argv[1], "--trace");

    char c[] = "--help --nonsense";
    assert_int_equal(parse(&g, c), CR_ERR_OK);
    assert_true(g.help);
}

static void test_each_refusal_names_the_way_out(void **state) {
    (void)state;
    static const struct {
        const char *line, *text, *hint;
    } bad[] = {
        {"x --fromat json", "unknown option --fromat", "did you mean --format?"},
        {"x --zzzzzzzzz", "unknown option --zzzzzzzzz", "crumple run --help lists them"},
        {"x -Z", "unknown option -Z", "crumple run --help lists them"},
        {"x --format xml", "--format: 'xml' is none of json|text|csv", ""},
        {"x --format", "--format needs a value: json|text|csv", ""},
        {"x --trace=yes", "--trace takes no value", ""},
        {"x -j 0", "--jobs: '0' is not a whole number in 1..64", ""},
        {"x -j 2x", "--jobs: '2x' is not a whole number in 1..64", ""},
        {"x -j 99999999999999999999",
         "--jobs: '99999999999999999999' is not a whole number in 1..64", ""},
        {"x --output=", "--output needs a FILE, not an empty text", ""},
        {"--trace", "crumple run needs SCENE", "crumple run --help explains"},
        {"x y z", "crumple run takes 2 operands, not 3", "crumple run --help explains"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct got g;
        char line[80];
        snprintf(line, sizeof line, "%s", bad[i].line);
        assert_int_equal(parse(&g, line), CR_ERR_USAGE);
        assert_string_equal(g.err.text, bad[i].text);
        assert_string_equal(g.err.hint, bad[i].hint);
    }
}

static void test_too_many_of_a_repeated_option(void **state) {
    (void)state;
    struct cr_option_values set = {.n = CR_OPTION_REPEAT_MAX};
    const struct cr_option table[] = {{.name = "set", .arg = "K=V", .values = &set, .help = ""}};
    const struct cr_usage usage = {.word = "run",
                                   .operands = "",
                                   .about = "",
                                   .option = table,
                                   .options = 1,
                                   .least = 0,
                                   .most = 0};
    char word[] = "run", opt[] = "--set=a=1";
    char *argv[] = {word, opt};
    int operands;
    bool help;
    struct cr_error err;
    assert_int_equal(cr_options_parse(&usage, 2, argv, &operands, &help, &err), CR_ERR_USAGE);
    assert_string_equal(err.text, "--set is given more than 256 times");
}

static void test_help_lists_every_option(void **state) {
    (void)state;
    bool flag = false;
    const char *text = NULL;
    const struct cr_option table[] = {
        {.name = "trace", .letter = 't', .flag = &flag, .help = "with the time series"},
        {.name = "a-long-name-of-an-option", .arg = "FILE", .text = &text, .help = "elsewhere"},
    };
    const struct cr_usage usage = {.word = "run",
                                   .operands = "SCENE",
                                   .about = "Solves.\n",
                                   .option = table,
                                   .options = 2,
                                   .least = 1,
                                   .most = 1};
    struct cr_str out = {0};
    cr_options_help(&usage, &out);
    assert_string_equal(cr_str_get(&out), "usage: crumple run [OPTION ...] SCENE\n"
                                          "\n"
                                          "Solves.\n"
                                          "\n"
                                          "  -t, --trace               with the time series\n"
                                          "      --a-long-name-of-an-option=FILE\n"
                                          "                            elsewhere\n"
                                          "  -h, --help                this text\n");
    cr_str_fini(&out);
}

static void test_choice_matches_whole_words_only(void **state) {
    (void)state;
    assert_int_equal(cr_str_choice("auto|always|never", "always"), 1);
    assert_int_equal(cr_str_choice("auto|always|never", "never"), 2);
    assert_int_equal(cr_str_choice("auto|always|never", "al"), -1);
    assert_int_equal(cr_str_choice("auto|always|never", ""), -1);
    assert_int_equal(cr_str_choice("auto|always|never", "auto|always"), -1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_form_of_an_option),
        cmocka_unit_test(test_each_refusal_names_the_way_out),
        cmocka_unit_test(test_too_many_of_a_repeated_option),
        cmocka_unit_test(test_help_lists_every_option),
        cmocka_unit_test(test_choice_matches_whole_words_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
