/* Chooses the voxels on which the draws of mc are solved: coarse ones, if the first draws, solved
 * on the scene's own as well, say that hardly any of the results' scatter comes from the grid. */
#include "study/mc_grid.h"

#include "base/stats.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* So many draws are solved on both grids: a median of 24 differences is known to a quarter of their
 * scatter. */
enum { BOTH = 24 };
/* From so many draws on solving some of them twice saves time. */
enum { DRAWS_LEAST = 10 * BOTH };
/* Edge of the coarse voxels, m: a solve takes a third of the time of one on 25 mm. */
static const double coarse = 0.040;
/* The coarse grid serves while the standard deviation of the differences is no more than this share
 * of that of the result, which widens an interval by 2 %, or than this share of the result itself,
 * which nobody can measure. */
static const double share_most = 0.2, value_most = 0.01;
/* The standard deviation of a normal distribution over the median of the distances from its
 * middle. */
static const double sd_of_median = 1.4826;

int cr_mc_measures(void) {
    int n;
    cr_measures(&n);
    return n;
}

double cr_mc_difference(const struct cr_measure *m, double x, double y) {
    return m->dim == CR_DIM_ANGLE ? remainder(x - y, 2 * CR_PI) : x - y;
}

/* The median of n values, and a standard deviation that outliers do not move. */
static double middle(double *x, int n, double *scatter) {
    double mid = cr_stats_median(x, n);
    for (int i = 0; i < n; i++) {
        x[i] = fabs(x[i] - mid);
    }
    *scatter = sd_of_median * cr_stats_median(x, n);
    return mid;
}

bool cr_mc_grid_open(struct cr_mc *mc) {
    size_t results = (size_t)mc->participants * (size_t)cr_mc_measures();
    bool finer = mc->own_voxel < 0.8 * coarse && !mc->opts.own_grid;
    for (int i = 0; i < mc->study.n; i++) {
        finer = finer && strcmp(mc->study.in[i].key, "voxel_mm") != 0;
    }
    mc->voxel = mc->own_voxel;
    if (!finer || mc->opts.draws < DRAWS_LEAST) {
        return true;
    }
    mc->both = BOTH;
    mc->voxel = coarse;
    mc->on_coarse = calloc(BOTH * results, sizeof *mc->on_coarse);
    mc->grid = calloc(results, sizeof *mc->grid);
    return mc->on_coarse != NULL && mc->grid != NULL;
}

/* Finds how a result differs from grid to grid, and whether it scatters much more than that. */
static bool compare(struct cr_mc *mc, int part, int measure) {
    const struct cr_measure *m = &cr_measures(&(int){0})[measure];
    double difference[BOTH], own[BOTH], scatter, spread;
    long results = (long)mc->participants * cr_mc_measures(),
         at = (long)part * cr_mc_measures() + measure;
    double nominal = cr_measure_get(m, &mc->nominal[part]);
    int n = 0;
    for (int i = 0; i < mc->both; i++) {
        double x = mc->result[i * results + at], y = mc->on_coarse[i * results + at];
        if (isnan(x) != isnan(y)) {
            return false;
        }
        own[n] = cr_mc_difference(m, x, nominal);
        difference[n] = cr_mc_difference(m, x, y);
        n += !isnan(x);
    }
    if (n == 0) {
        return true;
    }
    mc->grid[at].shift = middle(difference, n, &scatter);
    mc->grid[at].scatter = scatter;
    middle(own, n, &spread);
    return scatter <= fmax(share_most * spread, value_most * fabs(nominal));
}

void cr_mc_grid_choose(struct cr_mc *mc) {
    bool serves = true;
    for (int p = 0; p < mc->participants; p++) {
        for (int k = 0; k < cr_mc_measures(); k++) {
            const struct cr_measure *m = &cr_measures(&(int){0})[k];
            bool same = compare(mc, p, k);
            bool asked = strcmp(m->name, "ees") == 0 || strcmp(m->name, "delta_v") == 0;
            serves = serves && (same || !asked || cr_measure_get(m, &mc->nominal[p]) == 0);
        }
    }
    mc->voxel = serves ? mc->voxel : mc->own_voxel;
}

void cr_mc_grid_shift(struct cr_mc *mc) {
    long results = (long)mc->participants * cr_mc_measures();
    for (long i = mc->both * results; mc->voxel > mc->own_voxel && i < mc->done * results; i++) {
        const struct cr_measure *m = &cr_measures(&(int){0})[i % cr_mc_measures()];
        /* An angle has no scale on which a coarse grid could make it greater. */
        mc->result[i] += m->dim != CR_DIM_ANGLE ? mc->grid[i % results].shift : 0;
    }
}
