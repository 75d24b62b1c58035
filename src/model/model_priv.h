/* Inside of the model folder: recipes, the reference body and the reference grid.
 *
 * Recipe coordinates (also of the reference body): x from the front end rearward, y from the
 * centre line (models are mirror images left and right, so only y >= 0 is held), z from the road,
 * all in m of the reference vehicle. */
#ifndef CR_MODEL_PRIV_H
#define CR_MODEL_PRIV_H

#include "model/model.h"

#include <stddef.h>

enum { CR_MODEL_BOXES = 64, CR_MODEL_NAME = 32 };

/* Value at x; beyond the knots the first or last value holds. */
double cr_model_knots_at(const struct cr_model_knots *k, double x);

/* A structure: adds its weights to the plan inside its box. */
struct cr_model_box {
    char name[CR_MODEL_NAME];
    double x[2], y[2], z[2]; /* m */
    double weight[2];        /* longitudinal, lateral; relative to the other structures */
};

struct cr_model_recipe {
    char label[CR_MODEL_NAME];
    char hash[CR_HASH_SIZE];
    struct cr_dims dims;
    double mass; /* kg */
    struct cr_model_rules rules;
    double a_pillar, b_pillar;    /* x, m */
    struct cr_model_knots end[2]; /* front, rear: share of the half width -> how far the outline
                                     stands back from the foremost point, m */
    struct cr_model_knots top, bottom;              /* x -> z, m */
    struct cr_model_knots side;                     /* z m -> share of half width */
    double keep_below;                              /* z up to which heights are not stretched, m */
    double wheel_radius, wheel_width, house_radius; /* m */
    struct cr_model_face face[CR_MODEL_ENDS];
    double body_weight[2]; /* longitudinal, lateral: of the body between the structures */
    int boxes;
    struct cr_model_box box[CR_MODEL_BOXES];
};

/* Read a recipe from its text; src names the file in errors. Errors: SYNTAX, MISSING, TYPE, RANGE,
 * KEY, MODEL with JSON pointer. */
CR_MUST_CHECK enum cr_err cr_model_recipe_read(const char *text, size_t len, const char *src,
                                               struct cr_model_recipe *out, struct cr_error *err);

/* The reference body: cubic cells, each with its part of the weight of its column, longitudinal and
 * lateral, and with how much of it is material. Only ratios of weights count: they share out the
 * energy of a layer. */
struct cr_model_body {
    double edge;             /* m */
    int nx, ny, nz;          /* cells from the front end, from the centre line, from the road */
    const double *weight[2]; /* [(ix * nz + iz) * ny + iy] */
    const double *fill;      /* 0..1, in height and profile; the plan outline is not in it */
};

/* Build the body of a recipe, with arrays in the arena. Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_model_body_build(const struct cr_model_recipe *r,
                                              struct cr_arena *arena, struct cr_model_body *out,
                                              struct cr_error *err);

/* The reference body seen from above: weights and presence of material per column. */
struct cr_model_plan {
    int nx, ny;
    double edge;
    const double *weight[2]; /* [ix * ny + iy], of the layers asked for */
    const double *full[2];   /* the same of all layers */
    const double *present;   /* share of the column's plan that has material in those layers */
};

/* Columns of the layers between two heights z (m of the reference vehicle), without the memory of a
 * whole body. whole: the plan of all layers, whose arrays are borrowed; NULL if this is that plan.
 * Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_model_plan_build(const struct cr_model_recipe *r, const double z[2],
                                              const struct cr_model_plan *whole,
                                              struct cr_arena *arena, struct cr_model_plan *out,
                                              struct cr_error *err);

/* Monotone piecewise linear map between the vehicle's own lines and the reference grid's. */
enum { CR_MODEL_LINES = 6 };
struct cr_model_map {
    int n;
    double own[CR_MODEL_LINES], ref[CR_MODEL_LINES];
};
double cr_model_map_ref(const struct cr_model_map *map, double own);
double cr_model_map_own(const struct cr_model_map *map, double ref);

/* The reference grid of a vehicle: x (from the front end), y (from the centre line), z. */
struct cr_model_stretch {
    struct cr_model_map x, y, z;
};
/* The reference grid for a vehicle's dimensions. Errors: RANGE where its lines are not in order. */
CR_MUST_CHECK enum cr_err cr_model_stretch_make(const struct cr_model_recipe *r,
                                                const struct cr_dims *dims,
                                                struct cr_model_stretch *out, struct cr_error *err);

/* Check mass, dimensions and voxel of a query. Errors: RANGE, with the range as a hint. */
CR_MUST_CHECK enum cr_err cr_model_query_check(const struct cr_model_query *q,
                                               struct cr_error *err);

/* One of the twelve sectors in a model: its direction, and the face it loads. */
struct cr_model_sector {
    double share[2]; /* cos^2 and sin^2 of its middle: longitudinal, lateral */
    int clock;       /* 0 to 12; 0 and 12 are both straight ahead */
    bool side;       /* loads a flank (2 to 4, 8 to 10 o'clock), else an end */
    double part;     /* of this sector in the model; all parts add up to 1 */
};

/* The sector of a PDOF, or the two neighbouring ones; returns how many. */
int cr_model_sectors(double pdof, bool blend, struct cr_model_sector out[2]);

/* Energies of the left half of a vehicle for force along it and across it, [half][nx]: rows of
 * voxels from the centre line outward, in a row k counts from the front end. */
struct cr_model_fields {
    int nx, half;
    const double *energy[2]; /* longitudinal, lateral, all heights, J */
    const double *ranged[2]; /* share of it in the heights asked for; NULL: all of it */
    const double *layer_x;   /* [nx] what the layer at depth k takes, both halves together, J */
    const double *layer_y;   /* [half] what the layer at row j takes, one half, J */
};

/* Mix the fields for the sectors of a model into out[half * nx]. scratch[half * nx] and
 * sum[max(nx, half)] are overwritten. */
void cr_model_mix(const struct cr_model_fields *f, const struct cr_model_sector *sector, int n,
                  double *scratch, double *sum, double *out);

/* What a 2D substitute is made from. */
struct cr_model_parts {
    const struct cr_model_recipe *r;
    const struct cr_model_face *face; /* [CR_MODEL_ENDS], the recipe's or others */
    const struct cr_model_plan *plan;
    const struct cr_model_stretch *stretch;
};
/* Make the substitute on the solver's voxels, with arrays in the arena. Error: MEMORY. */
CR_MUST_CHECK enum cr_err cr_model_resample(const struct cr_model_parts *parts,
                                            const struct cr_model_query *q, struct cr_arena *arena,
                                            struct cr_grid *out, struct cr_error *err);

/* What is wrong with a voxel model, in either format. */
struct cr_voxels_fault {
    enum cr_err code; /* RANGE, MODEL */
    const char *key;  /* of the header, or of an array */
    char text[160];
};
/* Whether the numbers of the header can be, asked before memory for the voxels is taken. */
bool cr_voxels_check_header(const struct cr_voxels *v, struct cr_voxels_fault *fault);
/* Whether all energies and fills can be. */
bool cr_voxels_check_data(const struct cr_voxels *v, struct cr_voxels_fault *fault);
/* Take the name of a file's model, up to what a line or a quoted text would end at: both formats
 * must be able to write it again. */
void cr_voxels_set_name(struct cr_voxels *v, const char *name);

/* Numbers of the header by name, in the order they are written. */
struct cr_voxels_field {
    const char *key;
    int n, at_least; /* numbers; those beyond at_least may be left out */
    bool vehicle;    /* member of "vehicle" in JSON */
    bool optional;
    double *at[4];
};
enum { CR_VOXELS_FIELDS = 17 };
/* The fields with their places in v and count. */
void cr_voxels_fields(struct cr_voxels *v, double count[3],
                      struct cr_voxels_field out[CR_VOXELS_FIELDS]);
/* Put the counts into v after the fields were read; a third count of 0 means a flat model. */
bool cr_voxels_counts(struct cr_voxels *v, const double count[3], struct cr_voxels_fault *fault);

/* Read the text of a voxel model; src names the file in errors. Errors: SYNTAX, MISSING, TYPE,
 * RANGE, MODEL, KEY, MEMORY. */
CR_MUST_CHECK enum cr_err cr_voxels_read_json(char *text, size_t len, const char *src,
                                              struct cr_arena *arena, struct cr_voxels *out,
                                              struct cr_error *err);
CR_MUST_CHECK enum cr_err cr_voxels_read_csv(const char *text, const char *src,
                                             struct cr_arena *arena, struct cr_voxels *out,
                                             struct cr_error *err);

/* The body of a type, built on first use and kept by the library. */
CR_MUST_CHECK enum cr_err cr_model_body_of(const struct cr_model_lib *lib, enum cr_type type,
                                           const struct cr_model_recipe **recipe,
                                           const struct cr_model_body **body, struct cr_error *err);

#endif
