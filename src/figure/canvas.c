/* Remembers what is drawn on a canvas until the canvas is written. */
#include "figure/canvas_priv.h"

#include "base/grow.h"

#include <stdlib.h>
#include <string.h>

const double cr_dash_lengths[CR_DASHES][4] = {
    {0, 0, 0, 0}, {6, 3, 0, 0}, {1.2, 2, 0, 0}, {7, 2.5, 1.2, 2.5}};

struct cr_canvas *cr_canvas_new(double w, double h) {
    struct cr_canvas *c = calloc(1, sizeof *c);
    if (c != NULL) {
        c->w = w;
        c->h = h;
    }
    return c;
}

void cr_canvas_free(struct cr_canvas *c) {
    if (c != NULL) {
        free(c->item);
        free(c->step);
        cr_str_fini(&c->words);
        free(c);
    }
}

double cr_canvas_w(const struct cr_canvas *c) {
    return c->w;
}

double cr_canvas_h(const struct cr_canvas *c) {
    return c->h;
}

void cr_canvas_comma(struct cr_canvas *c) {
    for (int i = 0; i < c->items; i++) {
        if (c->item[i].act == CR_ACT_TEXT) {
            cr_decimal_comma(c->words.s + c->item[i].from, (size_t)c->item[i].n);
        }
    }
}

static struct cr_item *add_item(struct cr_canvas *c, enum cr_act act) {
    if (!cr_grow(&c->item, &c->item_size, c->items, sizeof *c->item)) {
        c->failed = true;
        return NULL;
    }
    c->item[c->items] = (struct cr_item){.act = act};
    return &c->item[c->items++];
}

static void add_step(struct cr_canvas *c, const struct cr_step *step) {
    if (!cr_grow(&c->step, &c->step_size, c->steps, sizeof *c->step)) {
        c->failed = true;
        return;
    }
    c->step[c->steps++] = *step;
}

void cr_canvas_move(struct cr_canvas *c, double x, double y) {
    add_step(c, &(struct cr_step){CR_VERB_MOVE, {x}, {y}});
}

void cr_canvas_line(struct cr_canvas *c, double x, double y) {
    add_step(c, &(struct cr_step){CR_VERB_LINE, {x}, {y}});
}

void cr_canvas_close(struct cr_canvas *c) {
    add_step(c, &(struct cr_step){.verb = CR_VERB_CLOSE});
}

void cr_canvas_rect(struct cr_canvas *c, double x, double y, double w, double h) {
    cr_canvas_move(c, x, y);
    cr_canvas_line(c, x + w, y);
    cr_canvas_line(c, x + w, y + h);
    cr_canvas_line(c, x, y + h);
    cr_canvas_close(c);
}

/* With this distance of its control points a Bezier curve misses a quarter of a circle by 0.03
 * %. */
static const double round_off = 0.5522847498;

void cr_canvas_circle(struct cr_canvas *c, double x, double y, double r) {
    static const int turn[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    add_step(c, &(struct cr_step){CR_VERB_MOVE, {x + r}, {y}});
    for (int i = 0; i < 4; i++) {
        const int *a = turn[i], *b = turn[i + 1];
        add_step(c, &(struct cr_step){CR_VERB_CURVE,
                                      {x + r * (a[0] + round_off * b[0]),
                                       x + r * (b[0] + round_off * a[0]), x + r * b[0]},
                                      {y + r * (a[1] + round_off * b[1]),
                                       y + r * (b[1] + round_off * a[1]), y + r * b[1]}});
    }
    cr_canvas_close(c);
}

void cr_canvas_paint(struct cr_canvas *c, const struct cr_paint *paint) {
    struct cr_item *item = c->steps > c->painted ? add_item(c, CR_ACT_PATH) : NULL;
    if (item != NULL) {
        item->from = c->painted;
        item->n = c->steps - c->painted;
        item->paint = *paint;
    }
    c->painted = c->steps;
}

void cr_canvas_clip(struct cr_canvas *c, double x, double y, double w, double h) {
    struct cr_item *item = add_item(c, CR_ACT_CLIP);
    if (item != NULL) {
        item->x = x;
        item->y = y;
        item->w = w;
        item->h = h;
    }
}

void cr_canvas_unclip(struct cr_canvas *c) {
    add_item(c, CR_ACT_UNCLIP);
}

void cr_canvas_place(struct cr_canvas *c, const struct cr_canvas *picture, double x, double y,
                     double k) {
    int steps = c->steps, words = (int)c->words.len;
    cr_str_addn(&c->words, cr_str_get(&picture->words), picture->words.len);
    for (int i = 0; i < picture->steps; i++) {
        struct cr_step s = picture->step[i];
        for (int j = 0; j < 3; j++) {
            s.x[j] = x + k * s.x[j];
            s.y[j] = y + k * s.y[j];
        }
        add_step(c, &s);
    }
    for (int i = 0; i < picture->items; i++) {
        struct cr_item *item = add_item(c, picture->item[i].act);
        if (item == NULL) {
            return;
        }
        *item = picture->item[i];
        item->from += item->act == CR_ACT_PATH ? steps : words;
        item->paint.width *= k;
        item->face.size *= k;
        item->x = x + k * item->x;
        item->y = y + k * item->y;
        item->w *= k;
        item->h *= k;
    }
    c->painted = c->steps;
    c->failed |= picture->failed || c->words.failed;
}

/* ---- words ---- */

/* The length of the UTF-8 sequence at s; 0 for a broken one. */
static int sequence(const char *s) {
    unsigned char c = (unsigned char)s[0];
    int n = c < 0x80 ? 1 : c >= 0xC2 && c < 0xE0 ? 2 : (c & 0xF0) == 0xE0 ? 3 : c < 0xF5 ? 4 : 0;
    if (c >= 0x80 && c < 0xC2) {
        return 0;
    }
    for (int i = 1; i < n; i++) {
        if (((unsigned char)s[i] & 0xC0) != 0x80) {
            return 0;
        }
    }
    return n;
}

void cr_canvas_fail(struct cr_canvas *c) {
    c->failed = true;
}

void cr_canvas_text(struct cr_canvas *c, double x, double y, const struct cr_type_face *face,
                    const char *utf8) {
    struct cr_item *item = utf8[0] != '\0' ? add_item(c, CR_ACT_TEXT) : NULL;
    if (item == NULL) {
        return;
    }
    item->from = (int)c->words.len;
    item->face = *face;
    item->x = x;
    item->y = y;
    for (const char *s = utf8; *s != '\0';) {
        int n = sequence(s);
        if (n == 0 || (n == 1 && (unsigned char)*s < 32) || *s == 127) {
            cr_str_add(&c->words, "\xEF\xBF\xBD");
        } else {
            cr_str_addn(&c->words, s, (size_t)n);
        }
        s += n > 0 ? n : 1;
    }
    item->n = (int)c->words.len - item->from;
    c->failed |= c->words.failed;
    if (!c->words.failed) {
        item->w = cr_text_width(face, c->words.s + item->from);
    }
}

/* Widths of the characters 32..126 of Helvetica in 1/1000 of the size, as Adobe published them
 * (Core 14 AFM files). */
static const short helvetica[95] = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
static const double courier = 600, bold_more = 1.07, other_letter = 556, wide_letter = 1000;

double cr_text_width(const struct cr_type_face *face, const char *utf8) {
    double sum = 0;
    for (const char *s = utf8; *s != '\0';) {
        int n = sequence(s);
        unsigned char c = (unsigned char)*s;
        /* Characters of three bytes and more are arrows, signs and letters as wide as high. */
        double w = face->mono           ? courier
                   : c >= 32 && c < 127 ? helvetica[c - 32]
                   : n > 2              ? wide_letter
                                        : other_letter;
        sum += w;
        s += n > 0 ? n : 1;
    }
    return sum * 1e-3 * face->size * (face->bold && !face->mono ? bold_more : 1);
}
