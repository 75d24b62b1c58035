/* The command language: tokens, table, binding, undo, completion, autosave, sweep. */
#include "config.h"

#include "test.h"

#include "base/file.h"
#include "cmd/cmd.h"
#include "cmd/cmd_priv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* what a session printed, for the tests to read */
struct heard {
    struct cr_str text, faults;
    int pictures, asked;
    char answer;
};

static void hear_text(void *user, enum cr_tone tone, const char *line) {
    struct heard *h = user;
    (void)tone;
    cr_str_addf(&h->text, "%s\n", line);
}

static void hear_fault(void *user, const struct cr_fault *fault) {
    struct heard *h = user;
    cr_fault_text(fault, 9, &h->faults);
}

static bool hear_cells(void *user, const struct cr_cells *cells, const struct cr_look *look) {
    struct heard *h = user;
    (void)look;
    assert_true(cells->w > 0 && cells->h > 0);
    h->pictures++;
    return true;
}

static int hear_question(void *user, const char *question, const char *answers) {
    struct heard *h = user;
    assert_non_null(strstr(question, "unsaved"));
    assert_non_null(strchr(answers, h->answer));
    h->asked++;
    return h->answer;
}

static struct cr_session *session(struct heard *h, const char *state_dir) {
    struct cr_session *s;
    struct cr_error err;
    struct cr_session_opts opts = {.data_dir = getenv("SRC"),
                                   .state_dir = state_dir,
                                   .ask = true,
                                   .out = {.user = h,
                                           .text = hear_text,
                                           .fault = hear_fault,
                                           .cells = hear_cells,
                                           .ask = hear_question}};
    *h = (struct heard){.answer = 'c'};
    assert_int_equal(cr_session_new(&opts, &s, &err), CR_ERR_OK);
    return s;
}

static void end(struct cr_session *s, struct heard *h) {
    cr_session_free(s);
    cr_str_fini(&h->text);
    cr_str_fini(&h->faults);
}

static void run(struct cr_session *s, const char *line) {
    if (cr_session_run(s, line) != CR_ERR_OK) {
        const struct cr_log_line *log;
        int n = cr_session_log(s, &log);
        fail_msg("%s: %s", line, n > 0 ? log[n - 1].text : "");
    }
}

/* ---- tokens ---- */

static void test_words_pairs_flags_and_quotes(void **state) {
    (void)state;
    struct cr_tokens t;
    const char *text = "place B over=40% --step \"a b\\\"c\" A.ees==4 x=\"1 2\" # note; more";
    assert_int_equal(cr_cmd_tokens(text, 0, &t, NULL), CR_ERR_OK);
    assert_int_equal(t.n, 7);
    assert_int_equal(t.tok[2].kind, CR_TOKEN_PAIR);
    assert_string_equal(t.tok[2].key, "over");
    assert_string_equal(t.tok[2].text, "40%");
    assert_int_equal(t.tok[2].value_at, 13);
    assert_int_equal(t.tok[3].kind, CR_TOKEN_FLAG);
    assert_string_equal(t.tok[3].text, "step");
    assert_string_equal(t.tok[4].text, "a b\"c");
    assert_int_equal(t.tok[5].kind, CR_TOKEN_WORD);
    assert_string_equal(t.tok[6].text, "1 2");
    assert_int_equal(t.next, (int)strlen(text));
    cr_cmd_tokens_fini(&t);
}

static void test_statements_end_at_semicolon_and_open_line_end(void **state) {
    (void)state;
    struct cr_tokens t;
    const char *text = "a \\\n b ; c\nd";
    assert_int_equal(cr_cmd_tokens(text, 0, &t, NULL), CR_ERR_OK);
    assert_int_equal(t.n, 2);
    int next = t.next;
    cr_cmd_tokens_fini(&t);
    assert_int_equal(cr_cmd_tokens(text, next, &t, NULL), CR_ERR_OK);
    assert_int_equal(t.n, 1);
    assert_string_equal(t.tok[0].text, "c");
    assert_string_equal(text + t.next, "d");
    cr_cmd_tokens_fini(&t);
    assert_true(cr_line_open("a \\"));
    assert_false(cr_line_open("a # \\"));
    assert_false(cr_line_open("a"));
}

static void test_bytes_that_are_no_text_are_refused(void **state) {
    (void)state;
    static const char *const bad[] = {"a \xff", "\x1b[2J", "\"\xc2\x9b\"", "\xc3"};
    for (int i = 0; i < 4; i++) {
        struct cr_tokens t;
        struct cr_error err;
        assert_int_equal(cr_cmd_tokens(bad[i], 0, &t, &err), CR_ERR_SYNTAX);
        cr_cmd_tokens_fini(&t);
    }
}

/* ---- the table ---- */

static void test_every_row_is_complete(void **state) {
    (void)state;
    int n;
    const struct cr_command *table = cr_commands(&n);
    for (int i = 0; i < n; i++) {
        const struct cr_command *c = &table[i];
        assert_non_null(c->help);
        assert_non_null(c->see);
        assert_ptr_equal(cr_command_find(c->name, NULL), c);
        int args = 0;
        for (; c->arg[args].name != NULL; args++) {
            struct cr_str help = {0};
            cr_arg_help(&c->arg[args], &help);
            if (help.len == 0) {
                fail_msg("%s %s: no help", c->name, c->arg[args].name);
            }
            if (c->arg[args].type == CR_VALUE_KEY && cr_arg_key(&c->arg[args]) == NULL) {
                fail_msg("%s %s: no such key of a scene", c->name, c->arg[args].name);
            }
            cr_str_fini(&help);
        }
        assert_true(args < CR_CMD_ARGS);
    }
}

/* a setting that the scene gets is a setting that the command knows */
static void test_set_knows_every_setting(void **state) {
    (void)state;
    int n;
    const struct cr_key *row = cr_scene_keys(CR_KEYS_SETTINGS, &n);
    const struct cr_command *set = cr_command_find("set", NULL);
    for (int i = 0; i < n; i++) {
        bool found = false;
        for (int k = 0; set->arg[k].name != NULL; k++) {
            found = found || cr_arg_key(&set->arg[k]) == &row[i];
        }
        if (!found) {
            fail_msg("set has no %s", row[i].name);
        }
    }
}

/* in a folder of their own, since some write files; each in a session that the row's setup made */
static void test_examples_of_help_run(void **state) {
    (void)state;
    char dir[] = "cr_help_XXXXXX", back[4096], command[64];
    int n;
    const struct cr_command *table = cr_commands(&n);
    assert_non_null(getcwd(back, sizeof back));
    assert_non_null(mkdtemp(dir));
    assert_int_equal(chdir(dir), 0);
    for (int i = 0; i < 2 * n; i++) {
        const struct cr_command *c = &table[i / 2];
        struct heard h;
        if ((!HAVE_GSL || !HAVE_NLOPT) &&
            (strcmp(c->name, "mc") == 0 || strcmp(c->name, "fit") == 0)) {
            continue; /* a build without draws */
        }
        struct cr_session *s = session(&h, NULL);
        h.answer = 'q';
        if (c->setup != NULL && cr_session_script(s, c->setup, c->name, 1) != CR_ERR_OK) {
            fail_msg("setup of %s: %s", c->name, cr_str_get(&h.faults));
        }
        if (cr_session_run(s, c->example[i % 2]) != CR_ERR_OK) {
            fail_msg("%s: %s", c->example[i % 2], cr_str_get(&h.faults));
        }
        snprintf(command, sizeof command, "%.*s", (int)strcspn(c->example[i % 2], " !"),
                 c->example[i % 2]);
        assert_string_equal(command, c->name);
        end(s, &h);
    }
    unlink("mine.json");
    unlink("mine.csv");
    assert_int_equal(chdir(back), 0);
    assert_int_equal(rmdir(dir), 0);
}

static void test_prefixes(void **state) {
    (void)state;
    bool many;
    assert_string_equal(cr_command_find("veh", &many)->name, "vehicle");
    assert_null(cr_command_find("s", &many));
    assert_true(many);
    assert_null(cr_command_find("nothing", &many));
    assert_false(many);
    assert_null(cr_command_find("", &many));
}

/* ---- undo ---- */

static void test_undo_gives_back_every_state(void **state) {
    (void)state;
    struct heard h;
    struct cr_session *s = session(&h, NULL);
    run(s, "vehicle A type=suv mass=2000kg speed=50km/h");
    for (int i = 1; i <= 50; i++) {
        char line[64];
        snprintf(line, sizeof line, "vehicle A speed=%dkm/h", i);
        run(s, line);
    }
    assert_int_equal(cr_session_undos(s), 51);
    assert_int_equal(cr_session_unsaved(s), 51);
    for (int i = 49; i >= 1; i--) {
        run(s, "undo");
        check_near(cr_session_scene(s)->part[0].speed * 3.6, i, 1e-9);
    }
    run(s, "undo 2");
    assert_int_equal(cr_session_scene(s)->n, 0);
    assert_int_equal(cr_session_unsaved(s), 0);
    run(s, "redo 51");
    check_near(cr_session_scene(s)->part[0].speed * 3.6, 50, 1e-9);
    /* an edit forgets all that had been undone, however much it was */
    run(s, "undo 40; vehicle A speed=99km/h");
    assert_int_equal(cr_session_undos(s), 12);
    run(s, "undo");
    check_near(cr_session_scene(s)->part[0].speed * 3.6, 10, 1e-9);
    end(s, &h);
}

/* what is saved is what is loaded, and undo never leaves a scene with the file of another */
static void test_save_and_load_are_inverses(void **state) {
    (void)state;
    char dir[] = "cr_save_XXXXXX", line[80], one_path[40], two_path[40], *one, *two;
    size_t n1, n2;
    struct heard h;
    struct cr_session *s = session(&h, NULL);
    assert_non_null(mkdtemp(dir));
    snprintf(one_path, sizeof one_path, "%s/one.json", dir);
    snprintf(two_path, sizeof two_path, "%s/two.json", dir);
    run(s, "vehicle A type=suv mass=2260kg speed=56km/h brake=80% steer=1,1,0,0");
    run(s, "vehicle B type=sedan mass=1.5t; place B facing A overlap=40% side=right gap=0.1m");
    run(s, "object tree kind=pole diameter=0.3m; set restitution=auto name=crash");
    snprintf(line, sizeof line, "save %s", one_path);
    run(s, line);
    assert_int_equal(cr_session_unsaved(s), 0);
    snprintf(line, sizeof line, "new; load %s", one_path);
    run(s, line);
    snprintf(line, sizeof line, "save %s", two_path);
    run(s, line);
    assert_int_equal(cr_file_read(one_path, &one, &n1, NULL), CR_ERR_OK);
    assert_int_equal(cr_file_read(two_path, &two, &n2, NULL), CR_ERR_OK);
    assert_int_equal(n1, n2);
    assert_memory_equal(one, two, n1);
    free(one);
    free(two);
    assert_string_equal(cr_session_file(s), two_path);
    /* the file stays the scene's when `save` is given no name, however often */
    for (int i = 0; i < 2; i++) {
        snprintf(line, sizeof line, "vehicle A speed=%dkm/h; save", 62 + i);
        run(s, line);
        assert_string_equal(cr_session_file(s), two_path);
        assert_int_equal(cr_session_unsaved(s), 0);
    }
    run(s, "undo 4");
    assert_string_equal(cr_session_file(s), one_path);
    run(s, "redo");
    assert_string_equal(cr_session_file(s), "");
    unlink(one_path);
    unlink(two_path);
    rmdir(dir);
    end(s, &h);
}

static void test_an_error_changes_nothing(void **state) {
    (void)state;
    struct heard h;
    struct cr_session *s = session(&h, NULL);
    run(s, "vehicle A type=suv mass=2000kg");
    assert_int_equal(cr_session_run(s, "vehicle A speed=10km/h mass=-1"), CR_ERR_RANGE);
    check_near(cr_session_scene(s)->part[0].speed, 0, 0);
    assert_int_equal(cr_session_undos(s), 1);
    /* the caret is below the value, behind the prompt */
    assert_string_equal(h.faults.s, "                                     ^^\n"
                                    "error: mass must be 100 to 60000 kg, got -1 kg\n");
    end(s, &h);
}

static void test_result_follows_the_scene(void **state) {
    (void)state;
    struct heard h;
    struct cr_session *s = session(&h, NULL);
    assert_int_equal(cr_session_state(s), CR_STATE_UNSOLVED);
    run(s, "vehicle A type=suv mass=2000kg speed=50km/h");
    assert_int_equal(cr_session_state(s), CR_STATE_EDITED);
    run(s, "object wall kind=wall; place wall facing A; solve");
    assert_int_equal(cr_session_state(s), CR_STATE_SOLVED);
    assert_int_equal(cr_session_view(s)->frame, cr_session_frames(s));
    run(s, "move A dx=-1m");
    assert_int_equal(cr_session_state(s), CR_STATE_STALE);
    run(s, "undo");
    assert_int_equal(cr_session_state(s), CR_STATE_SOLVED);
    run(s, "show frame=-3");
    assert_int_equal(cr_session_view(s)->frame, cr_session_frames(s) - 3);
    assert_int_equal(h.pictures, 1);
    run(s, "show frame=0");
    check_near(cr_session_time(s), cr_session_result(s)->solution->t_contact, 0);
    run(s, "place wall x=30m y=0m heading=180deg"); /* where it stands, not in front of A */
    run(s, "place A x=-30m heading=180deg");
    assert_int_equal(cr_session_run(s, "solve"), CR_ERR_NO_CONTACT);
    assert_int_equal(cr_session_state(s), CR_STATE_FAILED);
    end(s, &h);
}

/* what compare has read stays, to stand beside the results of further solves */
static void test_compared_values_are_kept(void **state) {
    (void)state;
    struct heard h;
    struct cr_session *s = session(&h, NULL);
    run(s, "vehicle A type=compact mass=1400kg speed=30km/h; object wall kind=wall; place wall "
           "facing A gap=0.1m; set voxel=50mm dt=1ms; solve");
    assert_null(cr_session_reference(s));
    run(s, "compare share/tutorial/reference.json"); /* A: 56.3 km/h and 28.7 g, no EES */
    const struct cr_reference *ref = cr_session_reference(s);
    assert_non_null(ref);
    assert_int_equal(ref->n, 2);
    assert_string_equal(ref->id[0], "A");
    check_near(ref->of[0].delta_v, 56.3 / 3.6, 1e-12);
    check_near(ref->of[0].acceleration_max, 28.7 * 9.80665, 1e-12);
    assert_true(isnan(ref->of[0].ees));
    run(s, "vehicle A speed=40km/h; solve");
    assert_non_null(cr_session_reference(s));
    run(s, "new"); /* another crash */
    assert_null(cr_session_reference(s));
    end(s, &h);
}

/* ---- completion ---- */

/* the words that complete a line at its end, separated by blanks */
static const char *completed(struct cr_session *s, const char *line, char *buf, size_t size) {
    struct cr_completion c;
    struct cr_error err;
    buf[0] = '\0';
    assert_int_equal(cr_session_complete(s, line, (int)strlen(line), &c, &err), CR_ERR_OK);
    for (int i = 0; i < c.n; i++) {
        size_t used = strlen(buf);
        snprintf(buf + used, size - used, "%s%s", i > 0 ? " " : "", c.item[i].word);
    }
    cr_completion_fini(&c);
    return buf;
}

static void test_completion_of_channels(void **state) {
    (void)state;
    char buf[9000], line[4200];
    struct heard h;
    struct cr_session *s = session(&h, NULL);
    snprintf(line, sizeof line, "compare %s/tests/data/import/vtv.", getenv("SRC"));
    completed(s, line, buf, sizeof buf);
    assert_non_null(strstr(buf, "vtv.008"));
    assert_non_null(strstr(buf, "vtv.009"));
    assert_non_null(strstr(buf, "vtv.EV5"));
    assert_null(strstr(buf, "vtv.jsonl"));
    end(s, &h);
}

static void test_completion_by_type_of_argument(void **state) {
    (void)state;
    char buf[4000];
    struct heard h;
    struct cr_session *s = session(&h, NULL);
    run(s, "vehicle alpha type=suv mass=2000kg; object wall kind=wall");
    static const char *const rows[][2] = {
        {"ve", "vehicle"},
        {"re", "remove redo"},
        {"list; und", "undo"},
        {"place w", "wall"},
        {"place alpha f", "facing"},
        {"place alpha facing ", "alpha wall overlap= side= at= angle= gap= x= y= heading= course= "
                                "speed= v= yawrate="},
        {"place alpha facing wall over", "overlap="},
        {"place alpha facing wall overlap=4", "4%"},
        {"place alpha facing wall overlap=40% ov", ""},
        {"place alpha facing wall side=", "left right centre front rear"},
        {"vehicle alpha type=s", "super-compact station-wagon sedan suv"},
        {"vehicle alpha speed=50", "50m/s 50km/h 50mph 50ft/s"},
        {"vehicle alpha --r", "--remove"},
        {"vehicle alpha blend", ""},
        {"model ", "alpha list info pdof= pdof_clock= pdof_deg= blend= front= side= rear="},
        {"model alpha sedan/1", "sedan/1 sedan/10 sedan/11 sedan/12"},
        {"set me", "method="},
        {"set method=", "extended paper"},
        {"set induced=", "on off"},
        {"help ap", "apropos"},
        {"solve until=", "compression end"},
        {"sweep alpha.sp", "alpha.speed"},
        {"sweep rest", "restitution"},
        {"export to", "top tornado"},
        {"export re", "result report"},
        {"export report lang=", "en de"},
        {"export damage of=", "alpha"},
        {"nonsense ", ""},
        {"new \"half ope", ""},
        {"vehicle B car=toy", "\"toyota"},
        {"vehicle B car=\"VW golf s", "sportWagen"},
        {"vehicle B car=\"VW golf 201", "2010 2011 2012 2013 2014 2015 2016 2017 2018 2019"},
        {"vehicle B car=\"spaceship ", ""},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        if (strcmp(completed(s, rows[i][0], buf, sizeof buf), rows[i][1]) != 0) {
            fail_msg("'%s' -> '%s', want '%s'", rows[i][0], buf, rows[i][1]);
        }
    }
    end(s, &h);
}

static void test_completion_of_files_by_suffix(void **state) {
    (void)state;
    char dir[] = "cr_cmd_XXXXXX", line[80], buf[400], path[80];
    struct heard h;
    struct cr_session *s = session(&h, NULL);
    assert_non_null(mkdtemp(dir));
    static const char *const files[] = {"a.json", "b.crumple", "c.csv"};
    for (int i = 0; i < 3; i++) {
        snprintf(path, sizeof path, "%s/%s", dir, files[i]);
        fclose(fopen(path, "w"));
    }
    snprintf(line, sizeof line, "load %s/", dir);
    snprintf(path, sizeof path, "%s/a.json", dir);
    assert_string_equal(completed(s, line, buf, sizeof buf), path);
    snprintf(line, sizeof line, "source %s/", dir);
    snprintf(path, sizeof path, "%s/b.crumple", dir);
    assert_string_equal(completed(s, line, buf, sizeof buf), path);
    snprintf(line, sizeof line, "pulse all a vs=%s/", dir);
    snprintf(path, sizeof path, "%s/c.csv", dir);
    assert_string_equal(completed(s, line, buf, sizeof buf), path);
    for (int i = 0; i < 3; i++) {
        snprintf(path, sizeof path, "%s/%s", dir, files[i]);
        unlink(path);
    }
    rmdir(dir);
    end(s, &h);
}

static void test_hint_of_the_command_being_typed(void **state) {
    (void)state;
    struct heard h;
    struct cr_str hint = {0};
    struct cr_session *s = session(&h, NULL);
    cr_session_hint(s, "move A turn=", 12, &hint);
    assert_string_equal(hint.s, "move NAME [dx=m] [dy=m] [turn=deg] [speed=km/h]\n"
                                "turn: counter-clockwise; -360 to 360 deg (0deg)");
    cr_str_clear(&hint);
    cr_session_hint(s, "", 0, &hint);
    assert_int_equal(hint.len, 0);
    cr_str_fini(&hint);
    end(s, &h);
}

/* ---- quit and autosave ---- */

static void test_quit_asks_when_changes_are_unsaved(void **state) {
    (void)state;
    struct heard h;
    struct cr_session *s = session(&h, NULL);
    run(s, "quit");
    assert_int_equal(h.asked, 0);
    assert_true(cr_session_over(s));
    end(s, &h);
    s = session(&h, NULL);
    run(s, "vehicle A type=suv mass=2000kg");
    run(s, "quit");
    assert_int_equal(h.asked, 1);
    assert_false(cr_session_over(s));
    h.answer = 's'; /* without a file there is nothing to save to */
    assert_int_equal(cr_session_run(s, "quit"), CR_ERR_MISSING);
    h.answer = 'q';
    run(s, "quit");
    assert_true(cr_session_over(s));
    end(s, &h);
}

static void test_autosave_outlives_a_crash(void **state) {
    (void)state;
    char dir[] = "cr_state_XXXXXX";
    struct heard h;
    assert_non_null(mkdtemp(dir));
    pid_t child = fork();
    if (child == 0) { /* a session that ends without a word */
        struct cr_session *lost = session(&h, dir);
        run(lost, "vehicle A type=suv mass=2000kg");
        run(lost, "vehicle A speed=47km/h");
        _exit(0);
    }
    siginfo_t info;
    assert_int_equal(waitid(P_PID, (id_t)child, &info, WEXITED | WNOWAIT), 0);
    assert_true(cr_session_left_behind(dir)); /* before anybody has asked how it ended */
    waitpid(child, NULL, 0);
    assert_true(cr_session_left_behind(dir));
    struct cr_session *s = session(&h, dir);
    run(s, "load --recover");
    check_near(cr_session_scene(s)->part[0].speed * 3.6, 47, 1e-9);
    assert_true(cr_session_unsaved(s) > 0);
    assert_false(cr_session_left_behind(dir));
    end(s, &h);
    assert_int_equal(rmdir(dir), 0); /* a session that ends in order leaves nothing */
}

/* ---- sweep ---- */

static void test_sweep_is_the_same_for_any_number_of_threads(void **state) {
    (void)state;
    struct heard h;
    double one[9];
    for (int jobs = 1; jobs <= 3; jobs += 2) {
        struct cr_session *s = session(&h, NULL);
        char line[80];
        run(s, "vehicle A type=suv mass=2000kg; vehicle B type=sedan mass=1400kg speed=50km/h");
        run(s, "place B facing A overlap=50%");
        snprintf(line, sizeof line, "sweep A.speed 20:60:20km/h B.overlap 40%%:80%%:20%% jobs=%d",
                 jobs);
        run(s, line);
        const struct cr_sweep *sweep = cr_session_sweep(s);
        assert_int_equal(sweep->n, 9);
        for (int i = 0; i < 9; i++) {
            assert_true(sweep->run[i].done && !sweep->run[i].failed);
            if (jobs == 1) {
                one[i] = sweep->run[i].of[0].ees;
            }
            check_near(sweep->run[i].of[0].ees, one[i], 0);
        }
        check_near(sweep->run[5].at[0] * 3.6, 40, 1e-9);
        check_near(sweep->run[5].at[1], 0.8, 1e-12);
        /* a row is the scene of its run: solved again it gives the same bits */
        run(s, "sweep row=6; solve");
        check_near(cr_session_result(s)->of[0].ees, one[5], 0);
        end(s, &h);
    }
}

/* what is hinted at is a command, and what is not is none */
static void names_of_elsewhere(void **state) {
    (void)state;
    static const char *const words[] = {"run", "exit", "ls", "plot", "wall", "write", "clear"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        bool many = false;
        assert_null(cr_command_find(words[i], &many));
        assert_non_null(cr_command_find(cr_cmd_elsewhere(words[i]), &many));
    }
    assert_null(cr_cmd_elsewhere("solve"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_words_pairs_flags_and_quotes),
        cmocka_unit_test(test_statements_end_at_semicolon_and_open_line_end),
        cmocka_unit_test(test_bytes_that_are_no_text_are_refused),
        cmocka_unit_test(test_every_row_is_complete),
        cmocka_unit_test(test_set_knows_every_setting),
        cmocka_unit_test(test_examples_of_help_run),
        cmocka_unit_test(test_prefixes),
        cmocka_unit_test(test_undo_gives_back_every_state),
        cmocka_unit_test(test_save_and_load_are_inverses),
        cmocka_unit_test(test_an_error_changes_nothing),
        cmocka_unit_test(test_result_follows_the_scene),
        cmocka_unit_test(test_compared_values_are_kept),
        cmocka_unit_test(test_completion_by_type_of_argument),
        cmocka_unit_test(test_completion_of_channels),
        cmocka_unit_test(test_completion_of_files_by_suffix),
        cmocka_unit_test(test_hint_of_the_command_being_typed),
        cmocka_unit_test(test_quit_asks_when_changes_are_unsaved),
        cmocka_unit_test(test_autosave_outlives_a_crash),
        cmocka_unit_test(test_sweep_is_the_same_for_any_number_of_threads),
        cmocka_unit_test(names_of_elsewhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
