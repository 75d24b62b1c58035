/* On which voxels the draws of mc are solved. */
#ifndef CR_STUDY_MC_GRID_H
#define CR_STUDY_MC_GRID_H

#include "study/study.h"

/* how many results each participant has */
int cr_mc_measures(void);
/* x - y of a result, the short way round where it is an angle */
double cr_mc_difference(const struct cr_measure *m, double x, double y);

/* Before the first draw: how many are solved on both grids, and room for them. False when memory is
 * out. */
bool cr_mc_grid_open(struct cr_mc *mc);
/* When those are solved: on which grid the others are. */
void cr_mc_grid_choose(struct cr_mc *mc);
/* When all are solved: those on the coarse grid are moved by what it makes of the first ones. */
void cr_mc_grid_shift(struct cr_mc *mc);

#endif
