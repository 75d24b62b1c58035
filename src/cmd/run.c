/* Runs lines and command files: statement by statement through the table, errors with place. */
#include "cmd/cmd_priv.h"

#include "base/show.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum cr_err no_command(const struct cr_session *s, const char *word, bool many,
                              struct cr_error *err) {
    enum { MAX = 64 };
    const char *names[MAX];
    char list[160] = "";
    int n = s->commands;
    const struct cr_command *table = s->command;
    for (int i = 0; i < n && i < MAX; i++) {
        names[i] = table[i].name;
        size_t used = strlen(list);
        if (many && strncmp(table[i].name, word, strlen(word)) == 0) {
            snprintf(list + used, sizeof list - used, " %s", table[i].name);
        }
    }
    if (many) {
        cr_err_set(err, CR_ERR_NAME, "'%.60s' is short for several commands", word);
        cr_err_hint(err, "one of:%s", list);
        return CR_ERR_NAME;
    }
    cr_err_set(err, CR_ERR_NAME, "there is no command '%.60s'", word);
    const char *near = cr_cmd_elsewhere(word);
    near = near != NULL ? near : cr_str_nearest(word, names, n < MAX ? n : MAX);
    if (near != NULL) {
        cr_err_hint(err, "did you mean '%s'?", near);
    } else {
        cr_err_hint(err, "help lists the commands");
    }
    return CR_ERR_NAME;
}

/* ---- faults ---- */

static void caret(struct cr_str *out, int indent, int col, int len) {
    cr_str_fill(out, ' ', indent + col - 1);
    cr_str_fill(out, '^', len > 0 ? len : 1);
    cr_str_add(out, "\n");
}

static void message(const struct cr_error *err, struct cr_str *out) {
    if (err->src[0] != '\0' && err->line > 0) {
        cr_str_addf(out, "%s:%d:", err->src, err->line);
        if (err->col > 0) {
            cr_str_addf(out, "%d:", err->col);
        }
        cr_str_add(out, " ");
    } else if (err->src[0] != '\0') {
        cr_str_addf(out, "%s: ", err->src);
    }
    if (err->where[0] != '\0') {
        cr_show_add(out, err->where);
        cr_str_add(out, ": ");
    }
    cr_str_add(out, err->text);
}

/* bytes of the first n characters */
static int bytes_of(const char *text, int n) {
    int i = 0;
    while (text[i] != '\0' && (n > 0 || ((unsigned char)text[i] & 0xC0) == 0x80)) {
        n -= ((unsigned char)text[i++] & 0xC0) != 0x80;
    }
    return i;
}

/* The line with a caret below what is meant; of a line longer than anybody reads what is around. */
static void quote_line(const struct cr_fault *f, struct cr_str *out) {
    enum { CHARS = 200 };
    int chars = cr_cmd_chars(f->text, (int)strlen(f->text));
    int first = chars <= CHARS || f->col <= CHARS / 2 ? 0 : f->col - 1 - CHARS / 2;
    int last = first + CHARS < chars ? first + CHARS : chars, room = last + 1 - f->col;
    int from = bytes_of(f->text, first), to = bytes_of(f->text, last);
    cr_str_addf(out, "  %s%.*s%s\n", first > 0 ? "..." : "", to - from, f->text + from,
                last < chars ? "..." : "");
    caret(out, first > 0 ? 5 : 2, f->col - first, f->len < room ? f->len : room);
}

void cr_fault_text(const struct cr_fault *fault, int prompt, struct cr_str *out) {
    const struct cr_error *err = &fault->err;
    if (fault->src != NULL) {
        cr_show_add(out, fault->src);
        cr_str_addf(out, ":%d:%d: error: ", fault->line, fault->col);
        message(err, out);
        cr_str_add(out, "\n");
        quote_line(fault, out);
        if (err->hint[0] != '\0') {
            cr_str_addf(out, "  hint: %s\n", err->hint);
        }
        return;
    }
    if (prompt >= 0 && fault->many) {
        quote_line(fault, out);
    } else if (prompt >= 0) {
        caret(out, prompt, fault->col, fault->len);
    }
    cr_str_add(out, "error: ");
    message(err, out);
    if (err->hint[0] != '\0') {
        bool typed = err->hint[strcspn(err->hint, " =")] == '='; /* "type=suv": as it is */
        cr_str_addf(out, ". %c%s", typed ? err->hint[0] : toupper((unsigned char)err->hint[0]),
                    err->hint + 1);
    }
    cr_str_add(out, "\n");
}

/* where a text that is being run comes from */
struct source {
    const char *name; /* NULL: the prompt */
    const char *text;
    int line; /* number of its first line */
};

static void show_fault(struct cr_session *s, const struct source *src, const struct cr_error *err,
                       int at, int len) {
    int start = at, line = src->line;
    while (start > 0 && src->text[start - 1] != '\n') {
        start--;
    }
    for (int i = 0; i < start; i++) {
        line += src->text[i] == '\n';
    }
    int width = (int)strcspn(src->text + start, "\r\n");
    char none[] = "", *line_text = malloc((size_t)width + 1);
    char *text = line_text != NULL ? line_text : none;
    snprintf(text, line_text != NULL ? (size_t)width + 1 : 1, "%.*s", width, src->text + start);
    cr_show_mask(text); /* the caret stays below what it means */
    len = len < start + width - at ? len : start + width - at;
    struct cr_fault fault = {.err = *err,
                             .src = src->name,
                             .line = line,
                             .col = cr_cmd_chars(src->text + start, at - start) + 1,
                             .len = cr_cmd_chars(src->text + at, len > 0 ? len : 0),
                             .text = text,
                             .many = strchr(src->text, '\n') != NULL};
    struct cr_str lines = {0};
    cr_fault_text(&fault, -1, &lines);
    for (char *p = lines.s, *end; p != NULL && (end = strchr(p, '\n')) != NULL; p = end + 1) {
        *end = '\0';
        struct cr_out quiet = s->opts.out;
        s->opts.out.text = NULL; /* into the log only: out.fault shows it */
        cr_session_text(s, CR_TONE_ERROR, p);
        s->opts.out = quiet;
    }
    cr_str_fini(&lines);
    if (s->opts.out.fault != NULL) {
        s->opts.out.fault(s->opts.out.user, &fault);
    }
    free(line_text);
}

/* ---- statements ---- */

/* text of the statement on one line, for the undo list */
static char *statement_text(const struct cr_tokens *tokens) {
    int at = tokens->tok[0].at,
        end = tokens->tok[tokens->n - 1].at + tokens->tok[tokens->n - 1].len;
    char *text = malloc((size_t)(end - at) + 1);
    if (text == NULL) {
        return NULL;
    }
    int n = 0;
    for (int i = at; i < end; i++) {
        bool hidden = tokens->source[i] == '\\' && strchr("\r\n", tokens->source[i + 1]) != NULL;
        char c = tokens->source[i];
        text[n++] = hidden || c == '\n' || c == '\r' ? ' ' : c;
    }
    text[n] = '\0';
    return text;
}

static enum cr_err run_call(struct cr_call *call, struct cr_error *err) {
    enum cr_err code = cr_cmd_bind(call, err);
    if (code == CR_ERR_OK) {
        code = call->cmd->run(call, err);
    }
    if (call->s->lost && code == CR_ERR_OK) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for all of the answer");
    }
    call->s->lost = false;
    if (code == CR_ERR_OK && call->draft != NULL && !call->fresh) {
        code = cr_cmd_settle(call->s, call->draft, err);
    }
    if (code == CR_ERR_OK && call->draft != NULL) {
        char *text = statement_text(call->tokens);
        if (text == NULL) {
            code = cr_err_set(err, CR_ERR_MEMORY, "out of memory");
        } else {
            code = cr_session_commit(call->s, call->draft, text, err);
            call->draft = NULL;
        }
        free(text);
        if (code == CR_ERR_OK && call->fresh) {
            cr_session_saved(call->s, call->file);
            cr_session_drop_result(call->s);
        }
        cr_session_autosave(call->s);
    }
    call->s->recovered[0] = '\0'; /* of this call alone */
    cr_state_free(call->draft);
    return code;
}

static enum cr_err run_statement(struct cr_session *s, const struct source *src,
                                 const struct cr_tokens *tokens) {
    struct cr_error err = {0};
    struct cr_call call = {.s = s, .tokens = tokens};
    char name[64];
    bool many = false;
    size_t len = strlen(tokens->tok[0].text);
    enum cr_err code = CR_ERR_OK;
    snprintf(name, sizeof name, "%s", tokens->tok[0].text);
    if (len > 1 && len < sizeof name && name[len - 1] == '!') {
        call.force = true;
        name[len - 1] = '\0';
    }
    call.cmd = tokens->tok[0].kind == CR_TOKEN_WORD
                   ? cr_command_among(s->command, s->commands, name, &many)
                   : NULL;
    const struct cr_token *first = &tokens->tok[0];
    if (call.cmd == NULL && strcmp(name, "?") == 0) { /* as telnet and gdb have taught people */
        call.cmd = cr_command_among(s->command, s->commands, "help", NULL);
    }
    if (first->kind == CR_TOKEN_PAIR) {
        code = cr_err_set(&err, CR_ERR_KEY, "a line begins with a command");
        if (!cr_cmd_guess_key(s, first->key, first->text, &err)) {
            cr_err_hint(&err, "for example: vehicle A speed=50km/h; set dt=0.25ms");
        }
    } else if (call.cmd == NULL) {
        code = no_command(s, name, many, &err);
    } else if (call.force && (call.cmd->flags & CR_CMD_FORCE) == 0) {
        code = cr_err_set(&err, CR_ERR_SYNTAX, "'%s' takes no '!'", call.cmd->name);
    } else {
        code = run_call(&call, &err);
    }
    if (code != CR_ERR_OK && err.text[0] != '\0') {
        const struct cr_token *tok = call.blame != NULL ? call.blame : &tokens->tok[0];
        if (call.blame != NULL) {
            err.where[0] = '\0'; /* the caret says it better than a JSON pointer */
        }
        cr_cmd_name_place(cr_session_scene(s), &err);
        bool value = tok->kind == CR_TOKEN_PAIR && code != CR_ERR_KEY && tok->value_len > 0;
        show_fault(s, src, &err, value ? tok->value_at : tok->at,
                   value ? tok->value_len : tok->len);
    }
    return code;
}

/* runs the statements of text[at..end) */
static enum cr_err run_line(struct cr_session *s, const struct source *src, int at, int end) {
    enum cr_err code = CR_ERR_OK;
    while (at < end && code == CR_ERR_OK && !s->over) {
        struct cr_tokens tokens;
        struct cr_error err = {0};
        code = cr_cmd_tokens(src->text, at, &tokens, &err);
        if (code != CR_ERR_OK) {
            int where = code == CR_ERR_SYNTAX ? err.col - 1 : at;
            int len = code == CR_ERR_SYNTAX ? err.line : 1;
            cr_err_place(&err, NULL, 0, 0);
            show_fault(s, src, &err, where, len);
        } else if (tokens.n > 0) {
            code = run_statement(s, src, &tokens);
        }
        at = tokens.next;
        cr_cmd_tokens_fini(&tokens);
    }
    return code;
}

/* byte after the line that starts at `at`, with the lines that "\" adds to it */
static int line_end(const char *text, int at) {
    bool comment = false;
    for (; text[at] != '\0' && text[at] != '\n'; at++) {
        comment = comment || text[at] == '#';
        int hidden = comment || text[at] != '\\'                    ? 0
                     : text[at + 1] == '\n'                         ? 1
                     : text[at + 1] == '\r' && text[at + 2] == '\n' ? 2
                                                                    : 0;
        at += hidden;
    }
    return text[at] == '\0' ? at : at + 1;
}

static void echo(struct cr_session *s, const char *text, int n) {
    static const char pause[] = "pause"; /* nobody learns anything from it */
    while (n > 0 && isspace((unsigned char)text[n - 1])) {
        n--;
    }
    if (n == sizeof pause - 1 && strncmp(text, pause, sizeof pause - 1) == 0) {
        return;
    }
    char *line = malloc((size_t)n + 1);
    s->lost = s->lost || line == NULL;
    if (line != NULL) {
        snprintf(line, (size_t)n + 1, "%.*s", n, text);
        cr_session_text(s, CR_TONE_ECHO, line);
        free(line);
    }
}

enum cr_err cr_session_script(struct cr_session *s, const char *text, const char *src, int line) {
    struct source source = {src, text, line};
    enum cr_err code = CR_ERR_OK;
    int at = 0;
    if (text[0] == '#' && text[1] == '!' && line == 1) {
        at = (int)strcspn(text, "\n");
    }
    while (text[at] != '\0' && code == CR_ERR_OK && !s->over) {
        int end = line_end(text, at);
        if (at > 0 && cr_work_cancelled(s)) { /* of long work or not: ^C ends the file */
            cr_warn(s, "interrupted: the rest of %s was not run", src);
            return CR_ERR_INTERRUPTED;
        }
        if (s->echo) {
            echo(s, text + at, end - at);
        }
        code = run_line(s, &source, at, end);
        at = end;
    }
    return code;
}

enum cr_err cr_session_run(struct cr_session *s, const char *line) {
    struct source source = {NULL, line, 1};
    struct cr_error err;
    if (line[strspn(line, " \t\r\n")] != '\0') {
        if (cr_session_remember(s, line, &err) != CR_ERR_OK) {
            return err.code;
        }
        struct cr_out quiet = s->opts.out;
        s->opts.out.text = NULL; /* who typed it sees it already */
        cr_session_text(s, CR_TONE_ECHO, line);
        s->opts.out = quiet;
    }
    return run_line(s, &source, 0, (int)strlen(line));
}
