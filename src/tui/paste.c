/* What is pasted, between the marks with which the terminal frames it: text, never keys. */
#include "tui/tui_priv.h"

#include "base/show.h"

#define SILENCE_S 1.0 /* a paste without its end mark ends so long after its last character */
enum { PASTE_MAX = 1 << 20 };

void cr_paste_begin(struct cr_paste *p, double now) {
    if (p->taken) {
        cr_str_clear(&p->text);
    } else if (p->text.len > 0) { /* two pastes before anybody looked */
        cr_str_add(&p->text, "\n");
    }
    p->on = true;
    p->taken = p->cut = p->returned = false;
    p->last = now;
}

void cr_paste_char(struct cr_paste *p, const struct cr_input *in, double now) {
    char bytes[4];
    p->last = now;
    if (in->function || in->alt) {
        return; /* a sequence in the text would be a key: it is left out */
    }
    uint32_t ch = in->code == L'\r' ? '\n' : in->code == L'\t' ? ' ' : (uint32_t)in->code;
    bool second = ch == '\n' && in->code == L'\n' && p->returned; /* of a CR LF */
    p->returned = in->code == L'\r';
    if (second || (ch != '\n' && cr_show_acts(ch)) || ch > 0x10FFFF) {
        return;
    }
    if (p->text.len + sizeof bytes > PASTE_MAX) {
        p->cut = true;
        return;
    }
    cr_str_addn(&p->text, bytes, cr_utf8_put(ch, bytes));
}

bool cr_paste_silent(const struct cr_paste *p, double now) {
    return p->on && now - p->last > SILENCE_S;
}

const char *cr_paste_end(struct cr_paste *p) {
    p->on = false;
    while (p->text.len > 0 &&
           (p->text.s[p->text.len - 1] == '\n' || p->text.s[p->text.len - 1] == ' ')) {
        p->text.s[--p->text.len] = '\0'; /* the last line waits for Enter like all */
    }
    return cr_str_get(&p->text);
}
