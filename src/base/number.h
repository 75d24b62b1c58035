/* Numbers as texts that are short and lose nothing. */
#ifndef CR_BASE_NUMBER_H
#define CR_BASE_NUMBER_H

enum { CR_NUMBER_SIZE = 32 };

/* The number with 12 significant digits, correctly rounded as by printf's %.12g, so that text made
 * from results is short and the same wherever the last bits differ. */
double cr_round12(double x);

/* The decimal with k digits after the point next to x; NaN where it has more than 15 digits. */
double cr_round_decimals(double x, int k);

/* Shortest text that reads back to the same finite x, in the form of printf's %g, without a sign
 * before zero; returns buf. */
char *cr_number_text(double x, char buf[CR_NUMBER_SIZE]);

#endif
