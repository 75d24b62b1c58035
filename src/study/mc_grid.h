/* Decides on which voxels the draws of mc are solved: many draws on coarse ones, which are quicker,
 * if they give the same. */
#ifndef CR_STUDY_MC_GRID_H
#define CR_STUDY_MC_GRID_H

#include "study/study.h"

/* How many results each participant has. */
int cr_mc_measures(void);
/* x - y of a result, the short way round where it is an angle. */
double cr_mc_difference(const struct cr_measure *m, double x, double y);

/* Decides before the first draw how many are solved on both grids, and makes room for them. False
 * without memory. */
bool cr_mc_grid_open(struct cr_mc *mc);
/* Chooses, when those are solved, on which grid the others are. */
void cr_mc_grid_choose(struct cr_mc *mc);
/* Moves, when all are solved, those on the coarse grid by the difference that the first ones
 * show. */
void cr_mc_grid_shift(struct cr_mc *mc);

#endif
