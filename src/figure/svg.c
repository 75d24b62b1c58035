/* Writes a canvas as SVG, with its words as text. */
#include "figure/canvas_priv.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Writes a number to a hundredth of a point, without zeros at the end and without "-0". */
static void number(struct cr_str *out, double x) {
    char text[40];
    double rounded = round(x * 100) / 100;
    int n = snprintf(text, sizeof text, "%.2f", rounded + 0.0);
    while (n > 0 && text[n - 1] == '0') {
        n--;
    }
    n -= n > 0 && text[n - 1] == '.';
    if (n == 2 && text[0] == '-' && text[1] == '0') {
        cr_str_add(out, "0");
        return;
    }
    cr_str_addn(out, text, (size_t)n);
}

static void attribute(struct cr_str *out, const char *name, double x) {
    cr_str_addf(out, " %s=\"", name);
    number(out, x);
    cr_str_add(out, "\"");
}

static void colour(struct cr_str *out, const char *name, uint32_t ink) {
    if (ink == CR_NO_INK) {
        cr_str_addf(out, " %s=\"none\"", name);
    } else {
        cr_str_addf(out, " %s=\"#%06x\"", name, (unsigned)ink);
    }
}

static void point(struct cr_str *out, double x, double y) {
    number(out, x);
    cr_str_add(out, " ");
    number(out, y);
}

static void path(const struct cr_canvas *c, const struct cr_item *item, struct cr_str *out) {
    static const char *const letter[] = {"M", "L", "C", "Z"};
    const struct cr_paint *p = &item->paint;
    cr_str_add(out, "<path d=\"");
    for (int i = item->from; i < item->from + item->n; i++) {
        const struct cr_step *s = &c->step[i];
        cr_str_add(out, letter[s->verb]);
        int points = s->verb == CR_VERB_CURVE ? 3 : s->verb == CR_VERB_CLOSE ? 0 : 1;
        for (int k = 0; k < points; k++) {
            cr_str_add(out, k > 0 ? " " : "");
            point(out, s->x[k], s->y[k]);
        }
    }
    cr_str_add(out, "\"");
    colour(out, "fill", p->fill);
    if (p->alpha > 0 && p->alpha < 1) {
        attribute(out, "fill-opacity", p->alpha);
    }
    if (p->line != CR_NO_INK) {
        colour(out, "stroke", p->line);
        attribute(out, "stroke-width", p->width);
        const double *dash = cr_dash_lengths[p->dash];
        for (int i = 0; i < 4 && dash[i] > 0; i++) {
            cr_str_add(out, i == 0 ? " stroke-dasharray=\"" : " ");
            number(out, dash[i] * p->width);
        }
        cr_str_add(out, dash[0] > 0 ? "\"" : "");
    }
    cr_str_add(out, "/>\n");
}

/* Writes a line. The viewer's font may be wider or narrower than the one for which labels were
 * placed: textLength makes it fit. */
static void text(const struct cr_canvas *c, const struct cr_item *item, struct cr_str *out) {
    static const char *const anchor[] = {NULL, "middle", "end"};
    const struct cr_type_face *f = &item->face;
    cr_str_add(out, "<text");
    attribute(out, "x", item->x);
    attribute(out, "y", item->y);
    attribute(out, "font-size", f->size);
    colour(out, "fill", f->ink);
    attribute(out, "textLength", item->w);
    cr_str_add(out, " lengthAdjust=\"spacingAndGlyphs\"");
    if (f->bold) {
        cr_str_add(out, " font-weight=\"bold\"");
    }
    if (f->mono) {
        cr_str_add(out, " font-family=\"Courier, Liberation Mono, monospace\"");
    }
    if (anchor[f->anchor] != NULL) {
        cr_str_addf(out, " text-anchor=\"%s\"", anchor[f->anchor]);
    }
    if (f->halo) {
        cr_str_add(out, " stroke=\"#ffffff\" stroke-width=\"2.5\" stroke-linejoin=\"round\""
                        " paint-order=\"stroke\"");
    }
    if (f->upward) {
        cr_str_add(out, " transform=\"rotate(-90 ");
        point(out, item->x, item->y);
        cr_str_add(out, ")\"");
    }
    cr_str_add(out, " xml:space=\"preserve\">");
    cr_str_xml(out, c->words.s + item->from, (size_t)item->n);
    cr_str_add(out, "</text>\n");
}

/* Begins a clip. An inner svg cuts at its box and needs no name, which could clash with that of
 * another picture of the page. */
static void clip(const struct cr_item *item, struct cr_str *out) {
    cr_str_add(out, "<svg");
    attribute(out, "x", item->x);
    attribute(out, "y", item->y);
    attribute(out, "width", item->w);
    attribute(out, "height", item->h);
    cr_str_add(out, " viewBox=\"");
    point(out, item->x, item->y);
    cr_str_add(out, " ");
    point(out, item->w, item->h);
    cr_str_add(out, "\">\n");
}

enum cr_err cr_canvas_svg(const struct cr_canvas *c, const char *title, bool alone,
                          struct cr_str *out, struct cr_error *err) {
    if (alone) {
        cr_str_add(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    }
    cr_str_add(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"");
    number(out, c->w);
    cr_str_add(out, "pt\" height=\"");
    number(out, c->h);
    cr_str_add(out, "pt\" viewBox=\"0 0 ");
    point(out, c->w, c->h);
    cr_str_add(out, "\" font-family=\"Helvetica, Arial, Liberation Sans, sans-serif\""
                    " role=\"img\">\n<title>");
    cr_str_xml(out, title, strlen(title));
    cr_str_add(out, "</title>\n<path d=\"M0 0H");
    number(out, c->w);
    cr_str_add(out, "V");
    number(out, c->h);
    cr_str_add(out, "H0Z\" fill=\"#ffffff\"/>\n");
    for (int i = 0; i < c->items; i++) {
        const struct cr_item *item = &c->item[i];
        switch (item->act) {
        case CR_ACT_PATH:
            path(c, item, out);
            break;
        case CR_ACT_TEXT:
            text(c, item, out);
            break;
        case CR_ACT_CLIP:
            clip(item, out);
            break;
        case CR_ACT_UNCLIP:
            cr_str_add(out, "</svg>\n");
            break;
        }
    }
    cr_str_add(out, "</svg>\n");
    return c->failed || out->failed ? cr_err_set(err, CR_ERR_MEMORY, "no memory for the picture")
                                    : CR_ERR_OK;
}
