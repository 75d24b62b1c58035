/* The full screen without a terminal: a session with the crash made by hand, keys typed into it,
 * and its screen as text. */
#ifndef CR_TEST_TUI_DOUBLE_H
#define CR_TEST_TUI_DOUBLE_H

#include "render_double.h"
#include "tui/tui_priv.h"

struct tui_double {
    struct cr_tui *t;
    struct render_double crash;
};

/* solved: with the crash of render_double_init as its result; interrupted: as a part of it. */
void tui_double_init(struct tui_double *d, int w, int h, bool solved, bool interrupted);
void tui_double_fini(struct tui_double *d);
/* As after `compare`: EES, delta-v and PDOF of A, delta-v of B were measured. */
void tui_double_compare(struct tui_double *d);
/* As after a sweep of both speeds, and of `more` inputs before them with two values each: the EES
 * of A is the mean of both speeds, that of B their sum and five times the first input. With drawn
 * they are shown as draws. */
void tui_double_sweep(struct tui_double *d, int more, bool drawn);
/* Types text; keys by name in angle brackets: <Enter> <Tab> <Esc> <Space> <Up> <Left> <F1> <C-c>
 * <M-3> ... */
void tui_double_type(struct tui_double *d, const char *keys);
/* An event of the mouse: buttons of curses, cell. */
void tui_double_mouse(struct tui_double *d, unsigned long buttons, int x, int y);
/* The whole screen as lines of UTF-8, allocated. */
char *tui_double_text(struct tui_double *d);
/* The command that was last shown in the dialogue, without the prompt; "" if there is none. */
const char *tui_double_command(const struct tui_double *d);

#endif
