/* One frame, one write: what curses sends piece by piece is gathered and handed to the terminal
 * whole, and no faster than the terminal takes it.
 *
 * The terminal answers a question at the end of a frame (DSR) once it has drawn it. On a slow line
 * frames are left out until that has come, so that what is shown is never old; a terminal that
 * does not answer is not waited for. */
#ifndef CR_TUI_FRAME_H
#define CR_TUI_FRAME_H

#include <stdbool.h>
#include <stdio.h>

/* The stream for curses to write to, NULL: the terminal itself must do. `asks`: the terminal takes
 * questions without printing them. */
FILE *cr_frame_open(bool asks);
void cr_frame_close(void);

/* What curses writes in between is one frame. */
void cr_frame_begin(void);
void cr_frame_end(double now);

#define CR_FRAME_ANSWER "\033[0n"   /* of a terminal that has drawn all before the question */
void cr_frame_ask(void);            /* the first time: does it answer at all? */
void cr_frame_answered(double now); /* an answer has come */

/* ms that the next frame must wait for answers, 0: it may be drawn. Times are s of the clock. */
int cr_frame_wait(double now);
/* Answers that are still to come within reason: ms to wait for them, 0: none. */
int cr_frame_awaits(double now);

#endif
