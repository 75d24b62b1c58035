/* The list of crash tests, and the classes of speed of full walls. */
#include "trial/crashtest.h"

#include "base/grow.h"
#include "base/show.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double none = (double)NAN;

/* Median of 474 side pole tests [POLE-AREA]. */
const double cr_test_pole_area = 0.223;

static const struct {
    double below; /* km/h */
    const char *word;
} speeds[CR_SPEEDS] = {
    {36, "below 36 km/h"}, {44, "40 km/h"}, {52, "48 km/h"}, {INFINITY, "56 km/h"}};

int cr_test_speed_of(double speed_kmh) {
    int i = 0;
    while (i < CR_SPEEDS - 1 && speed_kmh >= speeds[i].below) {
        i++;
    }
    return i;
}

const char *cr_test_speed_word(int speed) {
    return speeds[speed].word;
}

void cr_test_list_fini(struct cr_test_list *list) {
    for (int i = 0; i < list->n; i++) {
        free(list->item[i].scene);
        for (int k = 0; k < CR_TEST_RUNS; k++) {
            cr_compare_fini(&list->item[i].of[k].pulse.curves);
        }
    }
    free(list->item);
    *list = (struct cr_test_list){0};
}

struct cr_test *cr_test_list_add(struct cr_test_list *list, struct cr_error *err) {
    if (!cr_grow(&list->item, &list->size, list->n, sizeof *list->item)) {
        cr_err_set(err, CR_ERR_MEMORY, "no memory for crash tests");
        return NULL;
    }
    struct cr_test *c = &list->item[list->n++];
    memset(c, 0, sizeof *c);
    c->pulse = cr_compare_default();
    c->pulse.as_is = true;
    c->at = c->normal = none;
    for (int m = 0; m < CR_MEASURES; m++) {
        c->reference[m] = none;
        for (int k = 0; k < CR_TEST_RUNS; k++) {
            c->of[k].value[m] = none;
        }
    }
    for (int k = 0; k < CR_TEST_RUNS; k++) {
        c->of[k].pulse = (struct cr_test_pulse){.iso = none, .cora = none, .rms_g = none};
    }
    return c;
}

enum cr_err cr_test_set_scene(struct cr_test *c, struct cr_str *text, struct cr_error *err) {
    if (text->failed) {
        cr_str_fini(text);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for crash tests");
    }
    c->scene = text->s;
    /* Names are what somebody's table or the x_ keys of a scene say. */
    char *const name[] = {c->id, c->title, c->group, c->name};
    for (size_t i = 0; i < sizeof name / sizeof name[0]; i++) {
        cr_show_mask(name[i]);
    }
    /* The file of the scene is called after the test, and must stay in its folder. */
    for (char *slash = strchr(c->id, '/'); slash != NULL; slash = strchr(slash, '/')) {
        *slash = '-';
    }
    return CR_ERR_OK;
}
