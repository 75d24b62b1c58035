/* The library of models: the recipes of a folder, each read once, and what was derived from them,
 * shared by all threads. */
#include "config.h"

#include "model/model_priv.h"

#include "base/file.h"
#include "base/vec.h"
#include "catalogue/catalogue.h"

#include <assert.h>
#include <dirent.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* How many height ranges are kept per type; more are derived each time. */
enum { PLANS = 64 };

/* What was derived from one recipe. */
struct kept {
    struct cr_arena arena;
    bool built; /* whether body is there: only 3D voxels need it */
    struct cr_model_body body;
    bool planned;               /* whether whole is there */
    struct cr_model_plan whole; /* all heights */
    int plans;
    double range[PLANS][2]; /* heights of each plan, m of the reference vehicle */
    struct cr_model_plan plan[PLANS];
};

/* A query as numbers that can be compared byte by byte. */
struct key {
    double v[16];
};

/* Finished substitutes, so that a stack of scenes derives none twice. One takes about 0.25 MB at
 * 25 mm; once there are FINISHED of them, others are derived each time. */
enum { FINISHED = 96 };
struct finished {
    pthread_mutex_t lock;
    struct cr_arena arena;
    int n;
    struct key key[FINISHED];
    struct cr_grid grid[FINISHED];
};

struct cache {
    pthread_mutex_t lock;
    struct cr_model_recipe *recipe[CR_TYPES]; /* NULL: not read yet */
    struct kept kept[CR_TYPES];
    struct finished finished;
    int barriers;
    struct cr_barrier barrier[CR_BARRIERS];
    char *own_cars; /* folder of the user's tables */
    struct cr_catalogue *catalogue;
};

struct cr_model_lib {
    char *dir;
    struct cache *cache;
};

static enum cr_err read_recipe(const char *dir, enum cr_type type, struct cr_model_recipe **out,
                               struct cr_error *err) {
    struct cr_str path = {0};
    char *text = NULL;
    size_t len = 0;
    cr_str_addf(&path, "%s/%s.json", dir, cr_type_word(type));
    struct cr_model_recipe *r = malloc(sizeof *r);
    enum cr_err code = r == NULL || path.failed
                           ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the models")
                           : cr_file_read_regular(path.s, &text, &len, err);
    if (!code) {
        code = cr_model_recipe_read(text, len, path.s, r, err);
    }
    if (code) {
        free(r);
    } else {
        *out = r;
    }
    free(text);
    cr_str_fini(&path);
    return code;
}

enum cr_err cr_model_need(const struct cr_model_lib *lib, enum cr_type type, struct cr_error *err) {
    struct cache *cache = lib->cache;
    pthread_mutex_lock(&cache->lock);
    enum cr_err code = cache->recipe[type] != NULL
                           ? CR_ERR_OK
                           : read_recipe(lib->dir, type, &cache->recipe[type], err);
    pthread_mutex_unlock(&cache->lock);
    return code;
}

enum cr_err cr_model_need_all(const struct cr_model_lib *lib, struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    for (int i = 0; i < CR_TYPES && !code; i++) {
        code = cr_model_need(lib, (enum cr_type)i, err);
    }
    return code;
}

enum cr_err cr_model_own_cars(struct cr_model_lib *lib, const char *dir, struct cr_error *err) {
    free(lib->cache->own_cars);
    lib->cache->own_cars = dir != NULL ? strdup(dir) : NULL;
    return dir != NULL && lib->cache->own_cars == NULL
               ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the models")
               : CR_ERR_OK;
}

enum cr_err cr_model_catalogue(const struct cr_model_lib *lib, const struct cr_catalogue **out,
                               struct cr_error *err) {
    struct cache *cache = lib->cache;
    char data[4096], shipped[4200];
    cr_file_dir(lib->dir, data, sizeof data);
    cr_file_part(data, "catalogue", shipped, sizeof shipped);
    const char *const dirs[] = {shipped, cache->own_cars};
    pthread_mutex_lock(&cache->lock);
    enum cr_err code =
        cache->catalogue != NULL ? CR_ERR_OK : cr_catalogue_open(dirs, 2, &cache->catalogue, err);
    *out = cache->catalogue;
    pthread_mutex_unlock(&cache->lock);
    return code;
}

/* Refuses the name of a barrier and hints at those that there are. */
static enum cr_err no_barrier(const char *dir, const char *name, struct cr_error *err) {
    struct cr_folder folder;
    struct cr_str list = {0};
    enum cr_err code = cr_folder_list(dir, NULL, true, &folder, err);
    for (int i = 0; i < folder.n; i++) {
        const char *its = folder.entry[i]->d_name, *dot = strrchr(its, '.');
        if (dot != NULL && dot != its && strcmp(dot, ".json") == 0) {
            cr_str_addf(&list, "%s%.*s", list.len > 0 ? ", " : "", (int)(dot - its), its);
        }
    }
    cr_folder_fini(&folder);
    if (code != CR_ERR_OK) {
        cr_str_fini(&list);
        return code;
    }
    code = name[0] == '\0' ? cr_err_set(err, CR_ERR_NAME, "which barrier is not said")
                           : cr_err_set(err, CR_ERR_NAME, "no barrier \"%.40s\"", name);
    if (list.len > 0) {
        cr_err_hint(err, "one of: %s", cr_str_get(&list));
    }
    cr_str_fini(&list);
    return code;
}

static enum cr_err read_barrier(const char *model_dir, const char *name, struct cr_barrier *out,
                                struct cr_error *err) {
    char data[4096], dir[4200], path[4300], *text = NULL;
    size_t len = 0;
    cr_file_dir(model_dir, data, sizeof data);
    cr_file_part(data, "barriers", dir, sizeof dir);
    snprintf(path, sizeof path, "%s/%.40s.json", dir, name);
    if (name[0] == '\0' || strchr(name, '/') != NULL || cr_file_check_regular(path, NULL)) {
        return no_barrier(dir, name, err);
    }
    enum cr_err code = cr_file_read_regular(path, &text, &len, err);
    if (!code) {
        code = cr_barrier_read(text, len, path, out, err);
    }
    free(text);
    return code;
}

enum cr_err cr_model_barrier(const struct cr_model_lib *lib, const char *name,
                             const struct cr_barrier **out, struct cr_error *err) {
    struct cache *cache = lib->cache;
    enum cr_err code = CR_ERR_OK;
    *out = NULL;
    pthread_mutex_lock(&cache->lock);
    for (int i = 0; i < cache->barriers && *out == NULL; i++) {
        *out = strcmp(cache->barrier[i].name, name) == 0 ? &cache->barrier[i] : NULL;
    }
    if (*out == NULL && cache->barriers == CR_BARRIERS) {
        code = cr_err_set(err, CR_ERR_RANGE, "more than %d kinds of barriers", CR_BARRIERS);
    } else if (*out == NULL) {
        struct cr_barrier *b = &cache->barrier[cache->barriers];
        code = read_barrier(lib->dir, name, b, err);
        if (!code) {
            /* It is found again by the name of its file, whatever its text calls it. */
            snprintf(b->name, sizeof b->name, "%.31s", name);
            cache->barriers++;
            *out = b;
        }
    }
    pthread_mutex_unlock(&cache->lock);
    return code;
}

static const struct cr_model_recipe *recipe_of(const struct cr_model_lib *lib, enum cr_type type) {
    assert(lib->cache->recipe[type] != NULL);
    return lib->cache->recipe[type];
}

enum cr_err cr_model_lib_open(const char *dir, struct cr_model_lib **out, struct cr_error *err) {
    struct cr_model_lib *lib = calloc(1, sizeof *lib);
    struct cache *cache = calloc(1, sizeof *cache);
    char *copy = strdup(dir);
    if (lib == NULL || cache == NULL || copy == NULL ||
        pthread_mutex_init(&cache->lock, NULL) != 0 ||
        pthread_mutex_init(&cache->finished.lock, NULL) != 0) {
        free(lib);
        free(cache);
        free(copy);
        return cr_err_set(err, CR_ERR_MEMORY, "no memory for the models");
    }
    *lib = (struct cr_model_lib){copy, cache};
    *out = lib;
    return CR_ERR_OK;
}

void cr_model_lib_free(struct cr_model_lib *lib) {
    if (lib == NULL) {
        return;
    }
    for (int i = 0; i < CR_TYPES; i++) {
        cr_arena_free(&lib->cache->kept[i].arena);
        free(lib->cache->recipe[i]);
    }
    cr_arena_free(&lib->cache->finished.arena);
    cr_catalogue_free(lib->cache->catalogue);
    free(lib->cache->own_cars);
    pthread_mutex_destroy(&lib->cache->finished.lock);
    pthread_mutex_destroy(&lib->cache->lock);
    free(lib->cache);
    free(lib->dir);
    free(lib);
}

const struct cr_dims *cr_model_dims(const struct cr_model_lib *lib, enum cr_type type,
                                    double *mass_kg) {
    const struct cr_model_recipe *r = recipe_of(lib, type);
    if (mass_kg != NULL) {
        *mass_kg = r->mass;
    }
    return &r->dims;
}

const struct cr_model_rules *cr_model_rules(const struct cr_model_lib *lib, enum cr_type type) {
    return &recipe_of(lib, type)->rules;
}

void cr_model_pillars(const struct cr_model_lib *lib, enum cr_type type, double *a, double *b) {
    const struct cr_model_recipe *r = recipe_of(lib, type);
    *a = (r->a_pillar - r->dims.front_overhang) / r->dims.wheelbase;
    *b = (r->b_pillar - r->dims.front_overhang) / r->dims.wheelbase;
}

const char *cr_model_hash(const struct cr_model_lib *lib, enum cr_type type) {
    return recipe_of(lib, type)->hash;
}

const struct cr_model_face *cr_model_face(const struct cr_model_lib *lib, enum cr_type type,
                                          enum cr_model_end end) {
    return &recipe_of(lib, type)->face[end];
}

void cr_model_set_face(struct cr_model_lib *lib, enum cr_type type, enum cr_model_end end,
                       const struct cr_model_face *face) {
    assert(lib->cache->recipe[type] != NULL);
    lib->cache->recipe[type]->face[end] = *face;
    cr_arena_free(&lib->cache->finished.arena);
    lib->cache->finished.n = 0;
}

enum cr_err cr_model_body_of(const struct cr_model_lib *lib, enum cr_type type,
                             const struct cr_model_recipe **recipe,
                             const struct cr_model_body **body, struct cr_error *err) {
    struct kept *k = &lib->cache->kept[type];
    enum cr_err code = cr_model_need(lib, type, err);
    if (code) {
        return code;
    }
    *recipe = recipe_of(lib, type);
    *body = &k->body;
    pthread_mutex_lock(&lib->cache->lock);
    code = k->built ? CR_ERR_OK : cr_model_body_build(*recipe, &k->arena, &k->body, err);
    k->built = !code;
    pthread_mutex_unlock(&lib->cache->lock);
    return code;
}

/* Plan of a height range (m of the reference vehicle): kept while there is room. */
static enum cr_err plan_of(const struct cr_model_recipe *r, struct kept *k, const double z[2],
                           struct cr_arena *scratch, struct cr_model_plan *out,
                           struct cr_error *err) {
    enum cr_err code = CR_ERR_OK;
    if (!k->planned) {
        code =
            cr_model_plan_build(r, (const double[2]){0, INFINITY}, NULL, &k->arena, &k->whole, err);
        k->planned = !code;
    }
    if (code) {
        return code;
    }
    if (z[0] <= 0 && isinf(z[1])) {
        *out = k->whole;
        return CR_ERR_OK;
    }
    for (int i = 0; i < k->plans; i++) {
        if (k->range[i][0] == z[0] && k->range[i][1] == z[1]) {
            *out = k->plan[i];
            return CR_ERR_OK;
        }
    }
    bool keep = k->plans < PLANS;
    code = cr_model_plan_build(r, z, &k->whole, keep ? &k->arena : scratch, out, err);
    if (!code && keep) {
        memcpy(k->range[k->plans], z, sizeof k->range[0]);
        k->plan[k->plans++] = *out;
    }
    return code;
}

/* Height in the reference vehicle. The top cells of the body are not whole: the roof of a vehicle
 * and all above it count as one end. */
static double height_of(const struct cr_model_stretch *stretch, double top, double z) {
    return z >= top ? (double)INFINITY : cr_model_map_ref(&stretch->z, z > 0 ? z : 0);
}

/* The faces of a recipe as they are in a car of the query's year. */
static void faces_of(const struct cr_model_recipe *r, const struct cr_model_query *q,
                     struct cr_model_face out[CR_MODEL_ENDS]) {
    for (int i = 0; i < CR_MODEL_ENDS; i++) {
        out[i] = r->face[i];
        cr_model_face_scale(&out[i], sqrt(cr_model_built_strength(&out[i], q->built)));
    }
}

static enum cr_err substitute(const struct cr_model_lib *lib, const struct cr_model_query *q,
                              const struct cr_model_face face[CR_MODEL_ENDS],
                              struct cr_arena *arena, struct cr_grid *out, struct cr_error *err) {
    struct cr_model_stretch stretch;
    struct cr_model_plan plan;
    struct cr_model_face own[CR_MODEL_ENDS];
    struct cr_arena scratch = {0};
    enum cr_err code = cr_model_query_check(q, err);
    if (!code) {
        code = cr_model_need(lib, q->type, err);
    }
    const struct cr_model_recipe *r = code ? NULL : recipe_of(lib, q->type);
    if (!code) {
        code = cr_model_stretch_make(r, &q->dims, &stretch, err);
    }
    if (code) {
        return code;
    }
    double top = q->dims.height;
    const double z[2] = {height_of(&stretch, top, q->z_lo), height_of(&stretch, top, q->z_hi)};
    pthread_mutex_lock(&lib->cache->lock);
    code = plan_of(r, &lib->cache->kept[q->type], z, &scratch, &plan, err);
    pthread_mutex_unlock(&lib->cache->lock);
    if (!code) {
        if (face == NULL) {
            faces_of(r, q, own);
            face = own;
        }
        code = cr_model_resample(&(struct cr_model_parts){r, face, &plan, &stretch}, q, arena, out,
                                 err);
    }
    cr_arena_free(&scratch);
    return code;
}

/* A car is as strong from the left as from the right and its fields know no forward: of the hours
 * of a clock 1, 5, 7 and 11 have one substitute, and 12 and 6. */
static struct key key_of(const struct cr_model_query *q) {
    const struct cr_dims *d = &q->dims;
    struct cr_model_sector sector[2];
    bool between = cr_model_sectors(q->pdof, q->blend, sector) > 1;
    int hour = sector[0].clock % 6;
    double pdof = between ? q->pdof : hour > 3 ? 6 - hour : hour;
    double lo = q->z_lo > 0 ? q->z_lo : 0, hi = q->z_hi < d->height ? q->z_hi : d->height;
    return (struct key){{q->type, pdof, between, d->length, d->width, d->height, d->wheelbase,
                         d->track, d->front_overhang, d->cg_behind_front_axle, q->mass_kg, q->voxel,
                         q->curve, q->built, lo, hi}};
}

enum cr_err cr_model_substitute(const struct cr_model_lib *lib, const struct cr_model_query *q,
                                struct cr_arena *arena, struct cr_grid *out, struct cr_error *err) {
    struct finished *f = &lib->cache->finished;
    enum cr_err code = cr_model_query_check(q, err);
    if (code) {
        return code;
    }
    struct key key = key_of(q);
    bool done = false;
    pthread_mutex_lock(&f->lock);
    for (int i = 0; i < f->n && !done; i++) {
        done = memcmp(&f->key[i], &key, sizeof key) == 0;
        *out = f->grid[i];
    }
    if (!done && f->n < FINISHED) {
        done = true;
        code = substitute(lib, q, NULL, &f->arena, out, err);
        if (!code) {
            f->key[f->n] = key;
            f->grid[f->n++] = *out;
        }
    }
    pthread_mutex_unlock(&f->lock);
    return done ? code : substitute(lib, q, NULL, arena, out, err);
}

/* The curve of a face from CRASH3 stiffness: the energy over a width, E = width (A c + B c^2/2 +
 * A^2/2B), means EES = sqrt(B width / m) (c + A/B), linear in the residual depth c. As a dynamic
 * curve it begins A/B earlier, or the recipe's springback earlier if that is less. */
static void stiffness_face(const struct cr_stiffness *s, double width, double mass,
                           struct cr_model_face *f) {
    const double far = 3; /* m, deeper than any half of a car */
    f->own_metres = true;
    f->beyond = 0;
    if (s->b <= 0) { /* steady force A, no energy without residual depth */
        f->energy_linear = true;
        f->springback = 0;
        f->ees = (struct cr_model_knots){2, {0, far}, {0, sqrt(2 * s->a * width * far / mass)}};
        return;
    }
    double slope = sqrt(s->b * width / mass), hidden = s->a / s->b;
    f->energy_linear = false;
    f->springback = hidden < f->springback ? hidden : f->springback;
    f->ees = (struct cr_model_knots){2, {0, far}, {0, slope * far}};
    if (f->springback > 0 && f->springback < far) {
        double residual = far - f->springback;
        f->ees = (struct cr_model_knots){
            3, {0, f->springback, far}, {0, slope * hidden, slope * (residual + hidden)}};
    }
}

enum cr_err cr_model_from_stiffness(const struct cr_model_lib *lib, const struct cr_model_query *q,
                                    const struct cr_stiffness face[3], struct cr_arena *arena,
                                    struct cr_grid *out, struct cr_error *err) {
    static const char *const name[] = {"front", "side", "rear"};
    struct cr_model_face own[CR_MODEL_ENDS];
    enum cr_err code = cr_model_query_check(q, err);
    code = code ? code : cr_model_need(lib, q->type, err);
    if (!code) {
        faces_of(recipe_of(lib, q->type), q, own);
    }
    for (int i = 0; i < CR_MODEL_ENDS && !code; i++) {
        const struct cr_stiffness *s = &face[i];
        if (!(s->a >= 0 && s->a <= 1e7 && s->b >= 0 && s->b <= 1e8)) {
            code = cr_err_set(err, CR_ERR_RANGE, "%s stiffness A %g N/m, B %g N/m2 cannot be",
                              name[i], s->a, s->b);
            cr_err_hint(err, "A 0 to 1e7 N/m, B 0 to 1e8 N/m2; both 0 for the type's own");
        } else if (s->a > 0 || s->b > 0) {
            stiffness_face(s, i == CR_MODEL_SIDE ? q->dims.length : q->dims.width, q->mass_kg,
                           &own[i]);
        }
    }
    return code ? code : substitute(lib, q, own, arena, out, err);
}
