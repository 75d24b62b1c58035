/* Writes numbers and words as all tables show them, and finds the marks of participants. */
#include "render/table.h"

#include "result/cdc.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

void cr_render_number(double x, int decimals, char *buf, int size) {
    if (!isfinite(x)) {
        snprintf(buf, (size_t)size, "-");
        return;
    }
    x = fabs(x) < 0.5 * pow(10, -decimals) ? 0 : x; /* no "-0.0" */
    snprintf(buf, (size_t)size, "%.*f", decimals, x);
}

const char *cr_render_face(enum cr_face face) {
    return face < CR_FACES ? cr_face_word(face) : "-";
}

/* A mark for this name that is not among the n taken ones; the wished one if all are taken. */
static char free_mark(const char *id, int body, const char *taken, int n) {
    static const char others[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZ123456789";
    char wish[CR_NAME_MAX + sizeof others + 1];
    wish[0] = id[0] > 32 && id[0] < 127 ? id[0] : (char)('A' + body % 26);
    snprintf(wish + 1, sizeof wish - 1, "%s%s", id, others);
    for (const char *p = wish; *p != '\0'; p++) {
        bool used = !isalnum((unsigned char)*p) || (unsigned char)*p >= 127;
        for (int i = 0; i < n; i++) {
            used = used || tolower((unsigned char)taken[i]) == tolower((unsigned char)*p);
        }
        if (!used) {
            return *p;
        }
    }
    return wish[0];
}

char cr_render_mark(const struct cr_scene *scene, int body) {
    char mark[CR_BODY_MAX] = {0};
    for (int i = 0; i <= body && i < scene->n; i++) {
        mark[i] = free_mark(scene->part[i].id, i, mark, i);
    }
    return mark[body];
}
