/* The prompt: readline edits, completes and remembers; it never sees the terminal
 * [READLINE-CURSES]. Its functions know no argument, so the one pointer they need lives here. */
#include "tui/tui_priv.h"

#include "render/picture.h"

#include <curses.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

#include <readline/readline.h>

enum { QUEUE = 64 };
static const char first_prompt[] = "crumple> ", more_prompt[] = "      -> ";

static struct {
    struct cr_tui *tui;
    FILE *nowhere;
    unsigned char queue[QUEUE]; /* bytes of one key */
    int from, to;
    char *accepted; /* a line that Enter has given */
} prompt;

/* ---- what readline asks for ---- */

static int next_byte(FILE *in) {
    (void)in;
    return prompt.from < prompt.to ? prompt.queue[prompt.from++]
                                   : 7; /* ^G ends what is half done */
}

static int byte_waits(void) {
    return prompt.from < prompt.to;
}

static void redisplay(void) {
    prompt.tui->dirty = true;
}

static void on_line(char *line) {
    free(prompt.accepted);
    prompt.accepted = line;
}

/* longest start that all candidates share, in bytes */
static int common(const struct cr_completion *c) {
    int n = (int)strlen(c->item[0].word);
    for (int i = 1; i < c->n; i++) {
        int k = 0;
        while (k < n && c->item[i].word[k] == c->item[0].word[k]) {
            k++;
        }
        n = k;
    }
    while (n > 0 && ((unsigned char)c->item[0].word[n] & 0xC0) == 0x80) {
        n--; /* not within a character */
    }
    return n;
}

static int nothing(int count, int key) {
    (void)count;
    (void)key;
    return 0;
}

static void put_word(const struct cr_completion *c, const char *word, int n) {
    char buf[1200];
    snprintf(buf, sizeof buf, "%.*s", n, word);
    rl_begin_undo_group();
    rl_delete_text(c->start, c->end);
    rl_point = c->start;
    rl_insert_text(buf);
    rl_end_undo_group();
}

static int complete(int count, int key) {
    struct cr_tui *t = prompt.tui;
    struct cr_error err;
    (void)count;
    (void)key;
    cr_completion_fini(&t->candidates);
    t->sheet_from = -1;
    t->dirty = true;
    if (cr_session_complete(t->session, rl_line_buffer, rl_point, &t->candidates, &err) !=
            CR_ERR_OK ||
        t->candidates.n == 0) {
        return 0;
    }
    const struct cr_completion *c = &t->candidates;
    int typed = c->end - c->start, n = common(c);
    if (c->n == 1) {
        char end[2] = {c->item[0].end, '\0'};
        put_word(c, c->item[0].word, (int)strlen(c->item[0].word));
        if (end[0] != '\0' && rl_line_buffer[rl_point] != end[0]) {
            rl_insert_text(end);
        }
        cr_completion_fini(&t->candidates);
    } else if (n > typed) {
        put_word(c, c->item[0].word, n);
    }
    return 0;
}

/* ---- opening and closing ---- */

void cr_prompt_open(struct cr_tui *t, const char *state_dir) {
    prompt.tui = t;
    prompt.nowhere = fopen("/dev/null", "w");
    rl_readline_name = "crumple";
    rl_catch_signals = 0;
    rl_catch_sigwinch = 0;
    rl_change_environment = 0;
    rl_prep_term_function = NULL;
    rl_deprep_term_function = NULL;
    rl_getc_function = next_byte;
    rl_input_available_hook = byte_waits;
    rl_redisplay_function = redisplay;
    if (prompt.nowhere != NULL) {
        rl_outstream = prompt.nowhere;
    }
    cr_history_open(state_dir);
    rl_callback_handler_install(first_prompt, on_line);
    rl_variable_bind("bell-style", "none");
    rl_bind_key('\t', complete);
    rl_bind_keyseq(CR_PASTE_BEGIN, nothing); /* the terminal's marks end in term.c; readline's own
                                                reader would wait for the second for ever */
}

void cr_prompt_close(void) {
    rl_callback_handler_remove();
    cr_history_close();
    if (prompt.nowhere != NULL) {
        rl_outstream = stdout;
        fclose(prompt.nowhere);
    }
    free(prompt.accepted);
    memset(&prompt, 0, sizeof prompt);
}

/* ---- keys ---- */

/* keys of curses as the sequences readline knows by itself */
static const struct {
    wint_t key;
    const char *sequence;
} keys[] = {
    {KEY_UP, "\033[A"},      {KEY_DOWN, "\033[B"}, {KEY_RIGHT, "\033[C"}, {KEY_LEFT, "\033[D"},
    {KEY_HOME, "\033[H"},    {KEY_END, "\033[F"},  {KEY_DC, "\033[3~"},   {KEY_IC, "\033[2~"},
    {KEY_BACKSPACE, "\177"}, {KEY_ENTER, "\r"},    {KEY_BTAB, "\033[Z"},  {KEY_SRIGHT, "\033f"},
    {KEY_SLEFT, "\033b"},
};

static void push(const char *bytes, int n) {
    for (int i = 0; i < n && prompt.to < QUEUE; i++) {
        prompt.queue[prompt.to++] = (unsigned char)bytes[i];
    }
}

static void push_key(const struct cr_input *in) {
    char bytes[MB_LEN_MAX];
    mbstate_t state;
    prompt.from = prompt.to = 0;
    if (in->alt) {
        push("\033", 1);
    }
    if (!in->function) {
        memset(&state, 0, sizeof state);
        size_t n = wcrtomb(bytes, (wchar_t)in->code, &state);
        push(bytes, n != (size_t)-1 ? (int)n : 0);
        return;
    }
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        if (keys[i].key == in->code) {
            push(keys[i].sequence, (int)strlen(keys[i].sequence));
        }
    }
}

/* in the history a line is one line */
static void run_accepted(void) {
    struct cr_tui *t = prompt.tui;
    char *line = prompt.accepted;
    prompt.accepted = NULL;
    if (cr_line_open(line)) {
        cr_str_addf(&t->open, "%s\n", line);
        rl_set_prompt(more_prompt);
    } else {
        cr_str_add(&t->open, line);
        char *whole = strdup(cr_str_get(&t->open));
        cr_str_clear(&t->open);
        rl_set_prompt(first_prompt);
        if (whole != NULL) {
            cr_play_stop(t);
            cr_tui_run(t, whole);
        }
        free(whole);
    }
    free(line);
}

void cr_prompt_key(const struct cr_input *in) {
    push_key(in);
    /* all bytes of a character at once, so that a search for an umlaut works */
    while (prompt.from < prompt.to) {
        rl_callback_read_char();
    }
    if (prompt.accepted != NULL) {
        run_accepted();
    }
    prompt.tui->dirty = true;
}

const char *cr_prompt_line(int *point) {
    *point = rl_point;
    return rl_line_buffer != NULL ? rl_line_buffer : "";
}

bool cr_prompt_empty(void) {
    return rl_end == 0 && !RL_ISSTATE(RL_STATE_ISEARCH | RL_STATE_NSEARCH);
}

void cr_prompt_set(const char *line) {
    rl_replace_line(line, 1);
    rl_point = rl_end;
    prompt.tui->dirty = true;
}

void cr_prompt_insert(const char *text) {
    const struct cr_input abort = {.code = 7};
    if (RL_ISSTATE(RL_STATE_ISEARCH | RL_STATE_NSEARCH)) {
        cr_prompt_key(&abort);
    }
    rl_insert_text(text);
    prompt.tui->dirty = true;
}

void cr_prompt_clear(void) {
    const struct cr_input abort = {.code = 7};
    if (RL_ISSTATE(RL_STATE_ISEARCH | RL_STATE_NSEARCH)) {
        cr_prompt_key(&abort);
    }
    cr_str_clear(&prompt.tui->open);
    rl_set_prompt(first_prompt);
    cr_prompt_set("");
}

/* ---- drawing ---- */

void cr_prompt_draw(struct cr_cells *cells, struct cr_rect at, int *x) {
    const char *head = rl_display_prompt != NULL ? rl_display_prompt : first_prompt;
    const char *line = rl_line_buffer != NULL ? rl_line_buffer : "";
    int head_w = cr_glyph_width(head);
    int room = at.w - head_w, before = 0;
    cr_cells_print(cells, at.x, at.y, at.w, CR_ROLE_KEY, head);
    if (room < 4) {
        *x = at.x + (head_w < at.w ? head_w : at.w - 1);
        return;
    }
    /* columns up to the cursor, then as many characters off the start as do not fit */
    for (const char *p = line; p < line + rl_point;) {
        before += cr_glyph_columns(cr_glyph_next(&p));
    }
    const char *from = line;
    int shift = before >= room ? before - room + room / 3 : 0, gone = 0;
    while (gone < shift && *from != '\0') {
        gone += cr_glyph_columns(cr_glyph_next(&from));
    }
    char *shown = strdup(from);
    for (char *p = shown; p != NULL && *p != '\0'; p++) {
        *p = *p == '\n' ? '|' : *p; /* pasted lines, as wide as the cursor counts them */
    }
    cr_cells_print(cells, at.x + head_w, at.y, room, CR_ROLE_TEXT, shown != NULL ? shown : "");
    free(shown);
    if (gone > 0) {
        cr_cells_print(cells, at.x + head_w, at.y, 1, CR_ROLE_DIM, "<");
    }
    *x = at.x + head_w + before - gone;
}
