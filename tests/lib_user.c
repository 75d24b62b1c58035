/* A user of the installed library in ten lines: make installcheck compiles and runs it, as C and as
 * C++. Reads a scene from standard input and prints the EES of its participant A. */
#include <crumple.h>
#include <stdio.h>

int main(void) {
    static char scene[100000];
    crumple *lib = NULL;
    crumple_result *result = NULL;
    crumple_error err = CRUMPLE_ERROR_INIT;
    double ees = 0;
    size_t length = fread(scene, 1, sizeof scene, stdin);
    if (crumple_open(NULL, &lib, &err) != CRUMPLE_OK ||
        crumple_solve(lib, scene, length, NULL, &result, &err) != CRUMPLE_OK ||
        crumple_value(result, "A.ees_kmh", &ees) != CRUMPLE_OK) {
        fprintf(stderr, "%s: %s (%s)\n", err.where, err.text, err.hint);
        return 1;
    }
    printf("crumple %s: EES %.1f km/h\n", crumple_version(), ees);
    crumple_result_free(result);
    crumple_close(lib);
    return 0;
}
