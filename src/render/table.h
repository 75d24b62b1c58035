/* What the tables in text share, and the results table for chosen participants, so that reports can
 * show more of them than fit beside each other. */
#ifndef CR_RENDER_TABLE_H
#define CR_RENDER_TABLE_H

#include "render/render.h"

/* Finds the participants that have a column in a table (those that move or deform); returns how
 * many. */
int cr_table_bodies(const struct cr_result *result, int body[CR_BODY_MAX]);
/* How many participants fit beside each other, at least one. */
int cr_table_columns(int width);
/* Draws the table of n participants; time as of cr_render_table. */
void cr_table_draw(const struct cr_target *target, const struct cr_result *result, double time,
                   const int *body, int n);

/* "front", "left" ...; "-" for none. */
const char *cr_render_face(enum cr_face face);

/* Writes a number with fixed decimals, "-" for NaN and infinity; what rounds to zero has no
 * sign. */
void cr_render_number(double x, int decimals, char *buf, int size);

/* Adds what was assumed, a line per participant. */
void cr_render_assumed(const struct cr_result *result, struct cr_str *out);

#endif
