/* The results table, inside: a block of it for chosen participants, so that reports can show more
 * of them than fit beside each other. */
#ifndef CR_RENDER_TABLE_H
#define CR_RENDER_TABLE_H

#include "render/render.h"

/* Participants that a table has columns for (those that move or deform); returns how many. */
int cr_table_bodies(const struct cr_result *result, int body[CR_BODY_MAX]);
/* How many of them fit beside each other, at least one. */
int cr_table_columns(int width);
void cr_table_draw(const struct cr_target *target, const struct cr_result *result, double time,
                   const int *body, int n);

/* "front", "left" ...; "-" for none. */
const char *cr_render_face(enum cr_face face);

/* A number with fixed decimals, "-" for what is not known, never "-0". */
void cr_render_number(double x, int decimals, char *buf, int size);

/* What was assumed, a line per participant. */
void cr_render_assumed(const struct cr_result *result, struct cr_str *out);

#endif
