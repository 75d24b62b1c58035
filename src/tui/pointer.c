/* Events of the mouse as the terminal sends them, character by character. curses would do this, but
 * of events that have arrived together it hands over only the last. */
#include "tui/tui_priv.h"

#include <curses.h>

enum { BUTTON, COLUMN, ROW, FIELDS };
/* bits of the first field, the same in both forms (xterm, "Mouse Tracking") */
enum { WHICH = 3, NONE = 3, MOVED = 32, WHEEL = 64, MORE = 128 };

void cr_pointer_begin(struct cr_pointer *p, bool decimal) {
    *p = (struct cr_pointer){.on = true, .decimal = decimal};
}

static unsigned long event_of(int button, bool released) {
    int which = button & WHICH;
    if ((button & MORE) != 0) {
        return 0;
    }
    if ((button & WHEEL) != 0) {
        return which == 0 ? BUTTON4_PRESSED : which == 1 ? BUTTON5_PRESSED : 0;
    }
    if ((button & MOVED) != 0) {
        return which == 0 ? REPORT_MOUSE_POSITION : 0;
    }
    if (released || which == NONE) {
        return which == 0 || which == NONE ? BUTTON1_RELEASED : 0;
    }
    return which == 0 ? BUTTON1_PRESSED : 0;
}

static enum cr_pointer_step done(struct cr_pointer *p, bool released, struct cr_input *out) {
    p->on = false;
    *out = (struct cr_input){.function = true,
                             .code = KEY_MOUSE,
                             .x = p->field[COLUMN] - 1,
                             .y = p->field[ROW] - 1,
                             .mouse = event_of(p->field[BUTTON], released)};
    return CR_POINTER_DONE;
}

/* SGR (mode 1006): "0;12;7M", m for a release */
static enum cr_pointer_step read_decimal(struct cr_pointer *p, wint_t code, struct cr_input *out) {
    if (code >= '0' && code <= '9' && p->field[p->n] < 10000) {
        p->field[p->n] = 10 * p->field[p->n] + (int)(code - '0');
        return CR_POINTER_MORE;
    }
    if (code == ';' && p->n < FIELDS - 1) {
        p->n++;
        return CR_POINTER_MORE;
    }
    return (code == 'M' || code == 'm') && p->n == FIELDS - 1 ? done(p, code == 'm', out)
                                                              : CR_POINTER_NOT;
}

/* X10: three characters, each 32 more than its number */
static enum cr_pointer_step read_characters(struct cr_pointer *p, wint_t code,
                                            struct cr_input *out) {
    if (code < 32 || code > 255) {
        return CR_POINTER_NOT;
    }
    p->field[p->n++] = (int)code - 32;
    return p->n == FIELDS ? done(p, false, out) : CR_POINTER_MORE;
}

enum cr_pointer_step cr_pointer_read(struct cr_pointer *p, const struct cr_input *in,
                                     struct cr_input *out) {
    /* curses takes this character for a key; in X10 it is column or row 95 */
    bool del = in->function && in->code == KEY_BACKSPACE;
    wint_t code = del ? 127 : in->code;
    enum cr_pointer_step step = CR_POINTER_NOT;
    if (!in->alt && (!in->function || del)) {
        step = p->decimal ? read_decimal(p, code, out) : read_characters(p, code, out);
    }
    p->on = step == CR_POINTER_MORE;
    return step;
}
