/* Computes what the fields of a picture say of a voxel: EES, energy, crush, depth. */
#include "render/picture.h"

#include "base/vec.h"
#include "result/result.h"

#include <math.h>

const char *cr_field_word(enum cr_field field) {
    static const char *const words[CR_FIELDS] = {
#define X(name, word) word,
        CR_FIELD_LIST(X)
#undef X
    };
    return words[field];
}

/* The depth of a voxel below the struck face, m. */
static double depth_at(const struct cr_pic_body *b, int ix, int iy) {
    static const int step[CR_FACES][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const struct cr_grid *g = b->grid;
    const int *d = step[b->face < CR_FACES ? b->face : CR_FACE_FRONT];
    int n = 0;
    for (int x = ix, y = iy; x >= 0 && y >= 0 && x < g->nx && y < g->ny; x += d[0], y += d[1]) {
        n += g->fill[y * g->nx + x] > 0.5;
    }
    return n * g->h;
}

double cr_pic_field_value(const struct cr_pic_body *b, enum cr_field field, int ix, int iy,
                          double left) {
    const struct cr_grid *g = b->grid;
    int i = iy * g->nx + ix;
    double damage = g->fill[i] > 0 ? 1 - left / g->fill[i] : 0;
    switch (field) {
    case CR_FIELD_EES:
        return b->ees != NULL ? b->ees[i] : 0;
    case CR_FIELD_ENERGY:
        return damage * g->energy[i] / (g->h * g->h) * 1e-3;
    case CR_FIELD_CRUSH:
        return damage * 100;
    case CR_FIELD_DEPTH:
        return damage > 0.5 ? depth_at(b, ix, iy) : 0;
    case CR_FIELD_NONE:
    case CR_FIELDS:
        break;
    }
    return 0;
}

static double final_value(const struct cr_pic_body *b, enum cr_field field, int i) {
    double left = b->left != NULL ? b->left[i] : b->grid->fill[i];
    return cr_pic_field_value(b, field, i % b->grid->nx, i / b->grid->nx, left);
}

/* The value that 98 % of the crushed voxels stay below at the end of the crash (single hard voxels
 * would darken all others), rounded up to two digits. */
static double scale_top(const struct cr_pic *pic) {
    enum { BINS = 512 };
    double most = 0;
    long bin[BINS] = {0}, n = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int k = 0; k < pic->n; k++) {
            const struct cr_grid *g = pic->body[k].grid;
            for (int i = 0; i < g->nx * g->ny; i++) {
                double v = final_value(&pic->body[k], pic->field, i);
                if (pass == 0) {
                    most = fmax(most, v);
                } else if (v > 0) {
                    bin[(int)fmin(v / most * BINS, BINS - 1)]++;
                    n++;
                }
            }
        }
        if (!(most > 0)) {
            return 1;
        }
    }
    long sum = 0;
    int top = 0;
    while (top < BINS && (double)sum < 0.98 * (double)n) {
        sum += bin[top++];
    }
    double x = most * top / BINS, unit = pow(10, floor(log10(x)) - 1);
    return ceil(x / unit - 1e-9) * unit;
}

enum cr_err cr_pic_field_init(struct cr_pic *pic, struct cr_error *err) {
    if (pic->field != CR_FIELD_EES) {
        pic->field_max = pic->field == CR_FIELD_CRUSH ? 100 : scale_top(pic);
        return CR_ERR_OK;
    }
    pic->field_max = CR_EES_TOP;
    for (int k = 0; k < pic->n; k++) {
        struct cr_pic_body *b = &pic->body[k];
        if (b->grid->nx > 0) {
            size_t n = (size_t)b->grid->nx * (size_t)b->grid->ny;
            double *ees = cr_arena_take(&pic->arena, n, sizeof *ees);
            if (ees == NULL) {
                return cr_err_set(err, CR_ERR_MEMORY, "no memory for the field of %s", b->id);
            }
            /* A fixed barrier has no mass to which its energy could be related: it gets a car's. */
            cr_result_ees(b->grid, b->mass > 0 ? b->mass : 1500, ees);
            b->ees = ees;
        }
    }
    return CR_ERR_OK;
}

const char *cr_pic_field_label(enum cr_field field) {
    static const char *const labels[] = {
        [CR_FIELD_EES] = "EES",     [CR_FIELD_ENERGY] = "absorbed", [CR_FIELD_CRUSH] = "crushed",
        [CR_FIELD_DEPTH] = "depth", [CR_FIELD_NONE] = "",
    };
    return labels[field];
}

const char *cr_pic_field_unit(enum cr_field field, bool ascii) {
    static const char *const units[] = {
        [CR_FIELD_EES] = "km/h", [CR_FIELD_ENERGY] = "kJ/m\u00b2",
        [CR_FIELD_CRUSH] = "%",  [CR_FIELD_DEPTH] = "m",
        [CR_FIELD_NONE] = "",
    };
    return ascii && field == CR_FIELD_ENERGY ? "kJ/m2" : units[field];
}
