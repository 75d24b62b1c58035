/* Where a key or an event of the mouse goes: overlay, mouse, table of keys, or the prompt. */
#include "tui/tui_priv.h"

#include <curses.h>
#include <stdio.h>
#include <wctype.h>

/* a participant by its mark; with Alt also where that letter has another meaning */
static bool choose_letter(struct cr_tui *t, wint_t code) {
    const struct cr_scene *scene = cr_session_scene(t->session);
    char line[CR_NAME_MAX + 20];
    for (int i = 0; i < scene->n; i++) {
        if (towlower(code) == towlower((wint_t)(unsigned char)cr_render_mark(scene, i))) {
            snprintf(line, sizeof line, "show select=%s", scene->part[i].id);
            cr_tui_run_key(t, line);
            return true;
        }
    }
    return false;
}

void cr_tui_paste(struct cr_tui *t, const char *text) {
    int lines = 1;
    if (text[0] == '\0' || t->overlay != CR_OVERLAY_NONE) {
        return;
    }
    for (const char *p = text; *p != '\0'; p++) {
        lines += *p == '\n';
    }
    cr_tui_focus(t, CR_AREAS);
    cr_play_stop(t);
    cr_prompt_insert(text);
    if (lines > 1) {
        char line[80];
        snprintf(line, sizeof line, "  %d lines pasted: Enter runs them, ^C gives them up", lines);
        cr_dialogue_add(&t->log, CR_ROLE_TEXT, line);
    }
}

void cr_tui_input(struct cr_tui *t, const struct cr_input *in) {
    t->dirty = true;
    if (in->function && in->code == KEY_RESIZE) {
        return; /* signals tell it */
    }
    if (in->function && in->code == CR_KEY_PASTE) {
        const char *text = cr_term_pasted();
        if (!t->paused) {
            cr_tui_paste(t, text);
        }
        return;
    }
    if (t->overlay != CR_OVERLAY_NONE && cr_overlay_input(t, in)) {
        return;
    }
    if (t->paused) { /* a lesson waits: it is read, looked at, and left */
        if (!cr_lesson_key(t, in)) {
            cr_tui_key(t, in);
        }
        return;
    }
    if (in->function && in->code == KEY_MOUSE) {
        cr_mouse(t, in);
        return;
    }
    if (cr_tui_key(t, in)) {
        return;
    }
    bool printed = !in->function && iswprint(in->code), letter = printed && !in->alt;
    if (t->focus == CR_AREA_SCENE && printed && choose_letter(t, in->code)) {
        return;
    }
    if (t->focus != CR_AREAS && letter) {
        cr_tui_focus(t, CR_AREAS); /* it begins a command */
    }
    if (t->focus == CR_AREAS) {
        cr_play_stop(t);
        cr_prompt_key(in);
    }
}
