/* Draws what a study found: a histogram shows how a result scatters, a tornado which input moves
 * it. */
#ifndef CR_STUDY_CHARTS_H
#define CR_STUDY_CHARTS_H

#include "figure/figure.h"
#include "study/study.h"

enum cr_mc_chart { CR_MC_HISTOGRAM, CR_MC_TORNADO };

/* The chart of a result (plot->measure) on a canvas of its own, 500 points wide; with participant
 * -1 those of all participants in which the result scatters, one below the other. Errors: MISSING
 * when it scatters in none, MEMORY. */
CR_MUST_CHECK enum cr_err cr_mc_chart(const struct cr_mc *mc, enum cr_mc_chart chart,
                                      const struct cr_mc_plot *plot,
                                      const struct cr_figure_words *words, struct cr_canvas **out,
                                      struct cr_error *err);

#endif
