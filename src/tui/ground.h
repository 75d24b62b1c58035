/* Is the terminal's background dark or light? It is asked (OSC 11) and not waited for: whatever
 * answers, and whenever, is read like a key; what never answers costs nothing. */
#ifndef CR_TUI_GROUND_H
#define CR_TUI_GROUND_H

#include <stdbool.h>
#include <wchar.h>

enum cr_ground { CR_GROUND_UNKNOWN, CR_GROUND_DARK, CR_GROUND_LIGHT };

/* Terminals of this TERM take the question, or leave it alone, without printing it. */
bool cr_ground_may_ask(const char *term);
#define CR_GROUND_QUESTION "\033]11;?\033\\"
#define CR_GROUND_ANSWER   "\033]11;" /* what its answer begins with */

/* What the environment says: COLORFGBG ("15;0", "0;default;15") and TERM; both nullable. */
enum cr_ground cr_ground_of_environment(const char *colorfgbg, const char *term);
/* "rgb:ffff/ffff/ffff", "rgb:ff/ff/ff", "rgba:...", "#ffffff": dark below the middle of CIE
 * lightness. */
enum cr_ground cr_ground_of_color(const char *text);

/* The rest of an answer, character by character. */
struct cr_ground_reader {
    bool on;
    int n;
    char text[64];
};
enum cr_ground_step { CR_GROUND_MORE, CR_GROUND_DONE, CR_GROUND_NOT };
/* A character, alt if an escape came before it. DONE: text is whole; NOT: this was no answer. */
enum cr_ground_step cr_ground_read(struct cr_ground_reader *r, wint_t code, bool alt);

#endif
