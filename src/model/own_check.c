/* What both file formats of voxel models share: the names of the header's numbers, and the checks
 * of all that is read. */
#include "config.h"

#include "model/model_priv.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void cr_voxels_fields(struct cr_voxels *v, double count[3],
                      struct cr_voxels_field out[CR_VOXELS_FIELDS]) {
    struct cr_dims *d = &v->dims;
    double *slope = v->drag_slope, *bend = v->drag_bend, *b = v->block, *s = v->springback;
    const struct cr_voxels_field row[] = {
        {"edge_m", 1, 1, false, false, {&v->edge}},
        {"count", 3, 2, false, false, {&count[0], &count[1], &count[2]}},
        {"origin_m", 3, 2, false, false, {&v->x0, &v->y0, &v->z0}},
        {"mass_kg", 1, 1, false, false, {&v->mass_kg}},
        {"pdof_deg", 1, 1, false, true, {&v->pdof}},
        {"drag_slope", 4, 4, false, true, {slope, slope + 1, slope + 2, slope + 3}},
        {"drag_bend_per_m", 4, 4, false, true, {bend, bend + 1, bend + 2, bend + 3}},
        {"block_m", 4, 4, false, true, {b, b + 1, b + 2, b + 3}},
        {"springback_m", 4, 4, false, true, {s, s + 1, s + 2, s + 3}},
        {"length_m", 1, 1, true, false, {&d->length}},
        {"width_m", 1, 1, true, false, {&d->width}},
        {"height_m", 1, 1, true, false, {&d->height}},
        {"wheelbase_m", 1, 1, true, false, {&d->wheelbase}},
        {"track_m", 1, 1, true, false, {&d->track}},
        {"front_overhang_m", 1, 1, true, false, {&d->front_overhang}},
        {"cg_behind_front_axle_m", 1, 1, true, false, {&d->cg_behind_front_axle}},
        {"cg_height_m", 1, 1, true, true, {&d->cg_height}},
    };
    _Static_assert(sizeof row / sizeof row[0] == CR_VOXELS_FIELDS, "count the fields");
    memcpy(out, row, sizeof row);
}

void cr_voxels_set_name(struct cr_voxels *v, const char *name) {
    size_t n = 0;
    while ((unsigned char)name[n] >= ' ' && name[n] != '"' && name[n] != '\\') {
        n++;
    }
    snprintf(v->name, sizeof v->name, "%.*s", (int)n, name);
}

CR_PRINTF(4, 5)
static bool fail(struct cr_voxels_fault *f, enum cr_err code, const char *key, const char *fmt,
                 ...) {
    va_list args;
    f->code = code;
    f->key = key;
    va_start(args, fmt);
    vsnprintf(f->text, sizeof f->text, fmt, args);
    va_end(args);
    return false;
}

bool cr_voxels_counts(struct cr_voxels *v, const double count[3], struct cr_voxels_fault *f) {
    v->flat = count[2] == 0;
    for (int i = 0; i < (v->flat ? 2 : 3); i++) {
        if (!(count[i] >= 1 && count[i] <= CR_VOXELS_MAX && count[i] == floor(count[i]))) {
            return fail(f, CR_ERR_RANGE, "count", "counts of voxels must be whole numbers from 1");
        }
    }
    double all = count[0] * count[1] * (v->flat ? 1 : count[2]);
    if (all > CR_VOXELS_MAX) {
        return fail(f, CR_ERR_RANGE, "count",
                    "%.0f voxels are more than %d million; make the voxels larger", all,
                    CR_VOXELS_MAX / 1000000);
    }
    v->nx = (int)count[0];
    v->ny = (int)count[1];
    v->nz = v->flat ? 1 : (int)count[2];
    return true;
}

/* The voxels must lie on the vehicle they say they are of, give or take a voxel. */
static bool check_place(const struct cr_voxels *v, struct cr_voxels_fault *f) {
    const struct cr_dims *d = &v->dims;
    double front = d->cg_behind_front_axle + d->front_overhang, slack = 1.001 * v->edge;
    double box[4] = {v->x0 - (front - d->length), front - (v->x0 + v->nx * v->edge),
                     v->y0 + d->width / 2, d->width / 2 - (v->y0 + v->ny * v->edge)};
    static const char *const side[] = {"rear end", "front end", "right flank", "left flank"};
    for (int i = 0; i < 4; i++) {
        if (box[i] < -slack) {
            return fail(f, CR_ERR_MODEL, "origin_m",
                        "voxels reach %.3f m beyond the vehicle's %s; x and y count from the CG",
                        -box[i], side[i]);
        }
    }
    return true;
}

bool cr_voxels_check_header(const struct cr_voxels *v, struct cr_voxels_fault *f) {
    const struct {
        const char *key;
        double x, lo, hi;
    } row[] = {
        {"edge_m", v->edge, 0.001, 1},
        {"mass_kg", v->mass_kg, 50, 100000},
        {"origin_m", v->x0, -30, 30},
        {"origin_m", v->y0, -5, 5},
        {"origin_m", v->z0, -1, 5},
        {"length_m", v->dims.length, 1, 30},
        {"width_m", v->dims.width, 0.5, 5},
        {"height_m", v->dims.height, 0.5, 5},
        {"wheelbase_m", v->dims.wheelbase, 0.5, 25},
        {"track_m", v->dims.track, 0.3, 5},
        {"front_overhang_m", v->dims.front_overhang, 0.05, 5},
        {"cg_behind_front_axle_m", v->dims.cg_behind_front_axle, -5, 25},
        {"cg_height_m", v->dims.cg_height, 0, 5},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        if (!(row[i].x >= row[i].lo && row[i].x <= row[i].hi)) {
            return fail(f, CR_ERR_RANGE, row[i].key, "%g is outside %g to %g", row[i].x, row[i].lo,
                        row[i].hi);
        }
    }
    for (int i = 0; i < CR_FACES; i++) {
        if (!(v->drag_slope[i] >= 0 && v->drag_slope[i] <= 100)) {
            return fail(f, CR_ERR_RANGE, "drag_slope", "slopes must be 0 to 100");
        }
        if (!(v->drag_bend[i] >= 0 && v->drag_bend[i] <= 100)) {
            return fail(f, CR_ERR_RANGE, "drag_bend_per_m", "bends must be 0 to 100 1/m");
        }
        if (!(v->block[i] >= 0 && v->block[i] <= 10)) {
            return fail(f, CR_ERR_RANGE, "block_m", "depths of a block must be 0 to 10 m");
        }
        if (!(v->springback[i] >= 0 && v->springback[i] <= 1)) {
            return fail(f, CR_ERR_RANGE, "springback_m", "springbacks must be 0 to 1 m");
        }
    }
    return check_place(v, f);
}

bool cr_voxels_check_data(const struct cr_voxels *v, struct cr_voxels_fault *f) {
    size_t n = (size_t)v->nx * (size_t)v->ny * (size_t)v->nz;
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        const char *key = NULL;
        if (!(v->energy[i] >= 0 && v->energy[i] <= 1e9)) {
            key = "energy_J";
        } else if (!(v->fill[i] >= 0 && v->fill[i] <= 1)) {
            key = "fill";
        }
        if (key != NULL) {
            size_t nx = (size_t)v->nx, ny = (size_t)v->ny;
            return fail(f, CR_ERR_MODEL, key, "voxel (%zu, %zu, %zu) has %s %g; wanted %s", i % nx,
                        i / nx % ny, i / nx / ny, key, key[0] == 'e' ? v->energy[i] : v->fill[i],
                        key[0] == 'e' ? "0 to 1e9 J" : "0 to 1");
        }
        sum += v->energy[i];
    }
    return sum > 0 ? true : fail(f, CR_ERR_MODEL, "energy_J", "no voxel takes any energy");
}
