/* Deformable barriers: blocks of honeycomb before a rigid carriage or block, as a grid of voxels.
 *
 * A row of honeycomb is layers in series: under one force the weakest crushes first, wherever it
 * stands, so the layers count by their strength and not by their place. Rows above each other are
 * parallel. What is crushed whole is a solid pack, behind which the rigid part stands. The force
 * over depth is then a sum of rising curves and never falls. */
#include "config.h"

#include "model/json.h"

#include <cjson/cJSON.h>
#include "model/model_priv.h"

#include "base/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Strength of a pack of crushed honeycomb and of what stands behind it, Pa: ten times a car's front
 * is enough for it to stay as it is, and no more. A car that takes part of the barrier's width also
 * touches the pack from its side, and which structure gives way is one share for the contact: with
 * 20 MPa the honeycomb before that car stayed uncrushed under forces of three times its strength,
 * the more the finer voxels and slices were (validation.md, deformable barriers). */
static const double rigid_strength = 5e6;

/* Layers in series at one place across and between two heights. */
struct row {
    double height, gap; /* m; gap: from the foremost face of the barrier to the row's */
    int n;
    const struct cr_barrier_block *layer[CR_BARRIER_BLOCKS]; /* weakest first */
};

static double mean_strength(const struct cr_barrier_block *b) {
    return 0.5 * (b->strength[0] + b->strength[1]);
}

static void add_layer(struct row *row, const struct cr_barrier_block *b) {
    int at = row->n++;
    for (; at > 0 && mean_strength(row->layer[at - 1]) > mean_strength(b); at--) {
        row->layer[at] = row->layer[at - 1];
    }
    row->layer[at] = b;
    row->gap = fmin(row->gap, b->x[0]);
}

/* Energy per metre of width of a row that is pressed from the barrier's front to depth d. */
static double row_energy(const struct cr_barrier *b, const struct row *row, double d) {
    double left = d - row->gap, energy = 0;
    for (int i = 0; i < row->n && left > 0; i++) {
        const struct cr_barrier_block *l = row->layer[i];
        double stroke = b->crushable * (l->x[1] - l->x[0]), used = fmin(left, stroke);
        energy +=
            l->strength[0] * used + 0.5 * (l->strength[1] - l->strength[0]) * used * used / stroke;
        left -= used;
    }
    return row->height * (energy + rigid_strength * fmax(left, 0));
}

/* Finds the rows at a place across the barrier, between two heights; returns how many. */
static int rows_at(const struct cr_barrier *b, double y, double z_lo, double z_hi,
                   struct row row[2 * CR_BARRIER_BLOCKS]) {
    double edge[2 * CR_BARRIER_BLOCKS + 2];
    int edges = 0, n = 0;
    edge[edges++] = z_lo;
    for (int i = 0; i < b->blocks; i++) {
        for (int k = 0; k < 2; k++) {
            edge[edges++] = cr_clamp(b->block[i].z[k], z_lo, z_hi);
        }
    }
    for (int i = 1; i < edges; i++) { /* The edges are sorted by insertion. */
        double e = edge[i];
        int at = i;
        for (; at > 0 && edge[at - 1] > e; at--) {
            edge[at] = edge[at - 1];
        }
        edge[at] = e;
    }
    for (int i = 1; i < edges; i++) {
        double middle = 0.5 * (edge[i - 1] + edge[i]);
        struct row *r = &row[n];
        *r = (struct row){.height = edge[i] - edge[i - 1], .gap = INFINITY};
        for (int k = 0; k < b->blocks && r->height > 1e-9; k++) {
            const struct cr_barrier_block *c = &b->block[k];
            if (c->z[0] < middle && middle < c->z[1] && c->y[0] <= y && y < c->y[1]) {
                add_layer(r, c);
            }
        }
        n += r->n > 0;
    }
    return n;
}

/* How deep the honeycomb and its mounting reach from the front; behind that only the carriage goes
 * on. */
static double face_depth(const struct cr_barrier *b) {
    double deep = 0;
    for (int i = 0; i < b->blocks; i++) {
        deep = fmax(deep, b->block[i].x[1]);
    }
    return deep + b->mounting;
}

/* A line of voxels along the barrier: the middle of its material across, how wide that is, and the
 * heights between which it counts. */
struct line {
    double y, width, z[2];
};

static void fill_line(const struct cr_barrier *b, const struct line *line, const struct cr_grid *g,
                      double *fill, double *energy) {
    struct row row[2 * CR_BARRIER_BLOCKS];
    int n = rows_at(b, line->y, line->z[0], line->z[1], row);
    double width = line->width;
    double long_here = fabs(line->y) < b->carriage_width / 2 ? b->length : face_depth(b);
    double before = 0;
    for (int k = 0; k < g->nx; k++) {
        int ix = g->nx - 1 - k;
        double from = k * g->h, to = fmin((k + 1) * g->h, long_here), sum = 0;
        for (int i = 0; i < n && to > from; i++) {
            sum += row_energy(b, &row[i], to);
        }
        fill[ix] = to > from ? (to - from) / g->h * width / g->h : 0;
        energy[ix] = to > from ? (sum - before) * width : 0;
        before = to > from ? sum : before;
    }
}

enum cr_err cr_barrier_grid(const struct cr_barrier *b, double voxel, const double z[2],
                            struct cr_arena *arena, struct cr_grid *out, struct cr_error *err) {
    struct cr_grid g = {.h = voxel};
    int half = (int)ceil(b->width / 2 / voxel - 1e-9);
    g.nx = (int)ceil(b->length / voxel - 1e-9);
    g.ny = 2 * half;
    g.x0 = b->cg_behind_face - g.nx * voxel;
    g.y0 = -half * voxel;
    size_t n = (size_t)g.nx * (size_t)g.ny;
    double *fill = cr_arena_take(arena, n, sizeof *fill);
    double *energy = cr_arena_take(arena, n, sizeof *energy);
    if (arena->failed) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the voxels of a barrier");
    }
    struct line line = {.z = {fmax(z[0], b->z_lo), fmin(z[1], b->z_hi)}};
    for (int iy = 0; iy < g.ny; iy++) {
        double lo = fmax(g.y0 + iy * voxel, -b->width / 2);
        double hi = fmin(g.y0 + (iy + 1) * voxel, b->width / 2);
        size_t at = (size_t)iy * (size_t)g.nx;
        if (hi > lo) {
            line.y = 0.5 * (lo + hi);
            line.width = hi - lo;
            fill_line(b, &line, &g, fill + at, energy + at);
        }
    }
    g.fill = fill;
    g.energy = energy;
    *out = g;
    return CR_ERR_OK;
}

/* Reads one strength, or two between which the strength rises over the layer's depth. */
static void read_strength(struct cr_model_json *j, const cJSON *o, double out[2]) {
    const cJSON *x = cJSON_GetObjectItemCaseSensitive(o, "strength_MPa");
    if (cJSON_IsArray(x)) {
        cr_model_json_range(j, o, "strength_MPa", out, 0.01, 10);
    } else {
        out[0] = out[1] = cr_model_json_number(j, o, "strength_MPa", 0.01, 10);
    }
    out[0] *= 1e6;
    out[1] *= 1e6;
}

static void read_block(struct cr_model_json *j, const cJSON *o, struct cr_barrier *b) {
    static const char *const known[] = {"name", "x_m", "y_m", "z_m", "strength_MPa"};
    struct cr_barrier_block *c = &b->block[b->blocks];
    if (!cJSON_IsObject(o)) {
        cr_model_json_fail(j, CR_ERR_TYPE, NULL, "a block is an object");
        return;
    }
    cr_model_json_only(j, o, known, sizeof known / sizeof *known);
    cr_model_json_text(j, o, "name", c->name, sizeof c->name);
    cr_model_json_range(j, o, "x_m", c->x, 0, 3);
    cr_model_json_range(j, o, "y_m", c->y, -3, 3);
    cr_model_json_range(j, o, "z_m", c->z, 0, 3);
    read_strength(j, o, c->strength);
    b->blocks++;
}

static void read_blocks(struct cr_model_json *j, const cJSON *root, struct cr_barrier *b) {
    const cJSON *list = cr_model_json_array(j, root, "blocks"), *item;
    int i = 0;
    cJSON_ArrayForEach(item, list) {
        if (b->blocks == CR_BARRIER_BLOCKS) {
            cr_model_json_fail(j, CR_ERR_RANGE, NULL, "a barrier has up to 16 blocks");
            break;
        }
        cr_model_json_enter(j, NULL, i++);
        read_block(j, item, b);
        cr_model_json_leave(j);
    }
    if (!j->failed && b->blocks == 0) {
        cr_model_json_fail(j, CR_ERR_MODEL, NULL, "a deformable barrier has a block at least");
    }
    cr_model_json_leave(j);
}

/* Sets width and heights, which follow from the blocks, and checks how the blocks stand. */
static void set_bounds(struct cr_model_json *j, struct cr_barrier *b) {
    b->z_lo = INFINITY;
    b->z_hi = 0;
    double front = INFINITY;
    for (int i = 0; i < b->blocks && !j->failed; i++) {
        const struct cr_barrier_block *c = &b->block[i];
        b->z_lo = fmin(b->z_lo, c->z[0]);
        b->z_hi = fmax(b->z_hi, c->z[1]);
        b->width = fmax(b->width, 2 * fmax(-c->y[0], c->y[1]));
        front = fmin(front, c->x[0]);
    }
    if (!j->failed && front != 0) {
        cr_model_json_fail(j, CR_ERR_MODEL, "blocks", "the foremost block begins at x 0");
    }
    if (!j->failed && face_depth(b) > b->length + 1e-9) {
        cr_model_json_fail(j, CR_ERR_MODEL, "length_m", "the blocks are longer than the barrier");
    }
}

enum cr_err cr_barrier_read(const char *text, size_t len, const char *src, struct cr_barrier *out,
                            struct cr_error *err) {
    static const char *const known[] = {
        "crumple_barrier",
        "name",
        "label",
        "length_m",
        "mounting_m",
        "carriage_width_m",
        "mass_kg",
        "cg_behind_face_m",
        "yaw_inertia_kgm2",
        "crushable_share",
        "blocks",
        "provenance",
    };
    struct cr_model_json j;
    cJSON *root = cr_model_json_parse(&j, text, len, src, err);
    struct cr_barrier b = {0};
    cr_model_json_only(&j, root, known, sizeof known / sizeof *known);
    cr_model_json_number(&j, root, "crumple_barrier", 1, 1);
    cr_model_json_text(&j, root, "name", b.name, sizeof b.name);
    cr_model_json_text(&j, root, "label", b.label, sizeof b.label);
    b.length = cr_model_json_number(&j, root, "length_m", 0.1, 10);
    b.mounting = cr_model_json_number(&j, root, "mounting_m", 0, 1);
    b.carriage_width = cr_model_json_number(&j, root, "carriage_width_m", 0.1, 5);
    b.crushable = cr_model_json_number(&j, root, "crushable_share", 0.1, 1);
    b.fixed = !j.failed && !cJSON_HasObjectItem(root, "mass_kg");
    if (!b.fixed) {
        b.mass = cr_model_json_number(&j, root, "mass_kg", 100, 5000);
        b.cg_behind_face = cr_model_json_number(&j, root, "cg_behind_face_m", 0.1, 8);
        b.inertia = cr_model_json_number(&j, root, "yaw_inertia_kgm2", 10, 50000);
    }
    read_blocks(&j, root, &b);
    set_bounds(&j, &b);
    cJSON_Delete(root);
    cr_hash_hex(text, len, b.hash);
    *out = b;
    return j.code;
}
