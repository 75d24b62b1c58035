/* Benchmark: make bench. Times the solver alone, the way from scene to result, the whole process,
 * and stacks. Times are in wall clock; the best of many runs is what the machine can do, the median
 * what one sees. */
#include "base/arena.h"
#include "base/file.h"
#include "result/result.h"
#include "scene/compiled.h"
#include "scene/scene.h"

#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { SOLVES = 201, RESULTS = 51, PROCESSES = 51, STACK = 200 };

extern char **environ;

struct times {
    int n;
    double s[SOLVES];
};

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* sorts, so that s[0] is the best and s[n / 2] the median */
static void sort(struct times *t) {
    qsort(t->s, (size_t)t->n, sizeof t->s[0], by_value);
}

static void die(const struct cr_error *err) {
    char line[1024];
    fprintf(stderr, "bench: %s\n", cr_err_format(err, line, sizeof line));
    exit(cr_err_status(err->code));
}

static void time_solver(const struct cr_case *cs, struct times *t) {
    struct cr_error err;
    for (t->n = 0; t->n < SOLVES; t->n++) {
        struct cr_solver *solver = NULL;
        double start = now();
        if (cr_solver_new(cs, &solver, &err) != CR_ERR_OK ||
            cr_solver_run(solver, NULL, NULL, &err) != CR_ERR_OK) {
            die(&err);
        }
        t->s[t->n] = now() - start;
        cr_solver_free(solver);
    }
    sort(t);
}

static void time_results(const struct cr_scene *scene, const struct cr_context *ctx,
                         struct times *t) {
    struct cr_error err;
    for (t->n = 0; t->n < RESULTS; t->n++) {
        struct cr_result *result = NULL;
        double start = now();
        if (cr_result_run(scene, ctx, &result, &err) != CR_ERR_OK) {
            die(&err);
        }
        t->s[t->n] = now() - start;
        cr_result_free(result);
    }
    sort(t);
}

/* runs a program with its output thrown away; returns seconds and its peak memory in kB */
static double run_process(char *const argv[], long *peak_kb) {
    posix_spawn_file_actions_t act;
    posix_spawn_file_actions_init(&act);
    posix_spawn_file_actions_addopen(&act, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t pid;
    int status;
    struct rusage use;
    double start = now();
    if (posix_spawn(&pid, argv[0], &act, NULL, argv, environ) != 0 ||
        waitpid(pid, &status, 0) != pid || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        fprintf(stderr, "bench: %s %s failed\n", argv[0], argv[1]);
        exit(4);
    }
    double took = now() - start;
    getrusage(RUSAGE_CHILDREN, &use);
    *peak_kb = use.ru_maxrss;
    posix_spawn_file_actions_destroy(&act);
    return took;
}

static void time_process(char *program, char *path, struct times *t, long *peak_kb) {
    char run[] = "run";
    char *argv[] = {program, run, path, NULL};
    for (t->n = 0; t->n < PROCESSES; t->n++) {
        t->s[t->n] = run_process(argv, peak_kb);
    }
    sort(t);
}

/* slices in which something is pressed in: they take most of the time */
static int plastic_slices(const struct cr_solution *sol) {
    int n = 0, last = -1;
    for (int i = 0; i < sol->slices; i++) {
        if (sol->slice[i].phase == CR_PHASE_PLASTIC && sol->slice[i].sample != last) {
            last = sol->slice[i].sample;
            n++;
        }
    }
    return n;
}

static void bench_scene(const char *name, char *path, char *program, const struct cr_context *ctx) {
    struct cr_error err;
    struct cr_scene scene;
    struct cr_result *result = NULL;
    struct times solve, whole, process;
    long peak_kb = 0;
    if (cr_scene_load(path, &scene, &err) != CR_ERR_OK ||
        cr_result_run(&scene, ctx, &result, &err) != CR_ERR_OK) {
        die(&err);
    }
    time_solver(&result->compiled->cs, &solve);
    time_results(&scene, ctx, &whole);
    time_process(program, path, &process, &peak_kb);
    const struct cr_solution *sol = result->solution;
    printf("%-6s %8.2f %6.2f %9.2f %6.2f %8.2f %6.2f %6d %7d %7ld %8.1f %6.1f\n", name,
           1e3 * solve.s[0], 1e3 * solve.s[solve.n / 2], 1e3 * whole.s[0],
           1e3 * whole.s[whole.n / 2], 1e3 * process.s[0], 1e3 * process.s[process.n / 2],
           sol->samples, plastic_slices(sol), sol->deformed,
           sol->deformed > 0 ? (double)sol->visits / (double)sol->deformed : 0.0,
           (double)peak_kb / 1024);
    cr_result_free(result);
    cr_scene_fini(&scene);
}

/* a JSON Lines file with the demo at STACK speeds that differ a little */
#define SPEED "\"speed_kmh\": 56"
static void write_stack(const char *path, const char *scene_path, char *stack_path) {
    struct cr_error err;
    char *text = NULL;
    size_t n = 0;
    struct cr_str lines = {0};
    if (cr_file_read(scene_path, &text, &n, &err) != CR_ERR_OK) {
        die(&err);
    }
    for (char *p = text; *p != '\0'; p++) {
        *p = *p == '\n' ? ' ' : *p;
    }
    char *speed = strstr(text, SPEED);
    if (speed == NULL) {
        fprintf(stderr, "bench: no %s in %s\n", SPEED, scene_path);
        exit(3);
    }
    *speed = '\0';
    for (int i = 0; i < STACK; i++) {
        cr_str_addf(&lines, "%s" SPEED ".%03d%s\n", text, i, speed + sizeof SPEED - 1);
    }
    snprintf(stack_path, 4096, "%s", path);
    if (lines.failed || cr_file_write(path, lines.s, lines.len, &err) != CR_ERR_OK) {
        die(&err);
    }
    cr_str_fini(&lines);
    free(text);
}

static void bench_stack(char *program, const char *scene_path) {
    char path[4096], stack[] = "stack", jobs[] = "--jobs", one[] = "1", two[] = "2";
    long peak_kb;
    write_stack("bench-stack.jsonl", scene_path, path);
    char *by_one[] = {program, stack, jobs, one, path, NULL};
    char *by_two[] = {program, stack, jobs, two, path, NULL};
    double t1 = run_process(by_one, &peak_kb), t2 = run_process(by_two, &peak_kb);
    printf("\nstack of %d: %.0f scenes/s with 1 job, %.0f with 2 (x %.2f)\n", STACK, STACK / t1,
           STACK / t2, t1 / t2);
    unlink(path);
}

int main(void) {
    char *program = getenv("CRUMPLE");
    const char *src = getenv("SRC");
    if (program == NULL || src == NULL) {
        fprintf(stderr, "bench: run it with make bench\n");
        return 2;
    }
    static const struct {
        const char *name, *path;
    } scenes[] = {{"demo", "share/scenes/q7-fiat500.json"},
                  {"wall", "tests/bench/wall.json"},
                  {"pole", "tests/bench/pole.json"}};
    cr_arena_keep();
    struct cr_error err;
    struct cr_context ctx = {0};
    struct cr_model_lib *models = NULL;
    struct cr_irf_set *irf = NULL;
    char path[4096];
    snprintf(path, sizeof path, "%s/models", src);
    enum cr_err code = cr_model_lib_open(path, &models, &err);
    snprintf(path, sizeof path, "%s/share/irf", src);
    if (code != CR_ERR_OK || cr_irf_load(path, &irf, &err) != CR_ERR_OK) {
        die(&err);
    }
    ctx.models = models;
    ctx.irf = irf;
    printf("            solver ms  scene-result ms    process ms  slices    with  voxels  visits/ "
           "  peak\n"
           "scene    best median     best median     best median           crush     hit   voxel "
           "    MB\n");
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        snprintf(path, sizeof path, "%s/%s", src, scenes[i].path);
        bench_scene(scenes[i].name, path, program, &ctx);
    }
    snprintf(path, sizeof path, "%s/%s", src, scenes[0].path);
    bench_stack(program, path);
    cr_irf_free(irf);
    cr_model_lib_free(models);
    return 0;
}
