/* Writes canvases as PDF and PNG with cairo; without cairo it says so. */
#include "config.h"

#include "figure/canvas_priv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef HAVE_CAIRO
#include <cairo-pdf.h>
#include <cairo.h>

enum cr_err cr_canvas_need_cairo(struct cr_error *err) {
    (void)err;
    return CR_ERR_OK;
}

static cairo_status_t append(void *out, const unsigned char *data, unsigned n) {
    cr_str_addn(out, (const char *)data, n);
    return ((struct cr_str *)out)->failed ? CAIRO_STATUS_NO_MEMORY : CAIRO_STATUS_SUCCESS;
}

static enum cr_err failed(cairo_status_t status, struct cr_error *err) {
    return cr_err_set(err, CR_ERR_MEMORY, "cairo cannot draw it: %s",
                      cairo_status_to_string(status));
}

static void set_ink(cairo_t *cr, uint32_t ink, double alpha) {
    cairo_set_source_rgba(cr, (ink >> 16 & 255) / 255.0, (ink >> 8 & 255) / 255.0,
                          (ink & 255) / 255.0, alpha > 0 ? alpha : 1);
}

static void path(cairo_t *cr, const struct cr_canvas *c, const struct cr_item *item) {
    const struct cr_paint *p = &item->paint;
    cairo_new_path(cr);
    for (int i = item->from; i < item->from + item->n; i++) {
        const struct cr_step *s = &c->step[i];
        switch (s->verb) {
        case CR_VERB_MOVE:
            cairo_move_to(cr, s->x[0], s->y[0]);
            break;
        case CR_VERB_LINE:
            cairo_line_to(cr, s->x[0], s->y[0]);
            break;
        case CR_VERB_CURVE:
            cairo_curve_to(cr, s->x[0], s->y[0], s->x[1], s->y[1], s->x[2], s->y[2]);
            break;
        case CR_VERB_CLOSE:
            cairo_close_path(cr);
            break;
        }
    }
    if (p->fill != CR_NO_INK) {
        set_ink(cr, p->fill, p->alpha);
        cairo_fill_preserve(cr);
    }
    if (p->line != CR_NO_INK) {
        double dash[4];
        int n = 0;
        for (; n < 4 && cr_dash_lengths[p->dash][n] > 0; n++) {
            dash[n] = cr_dash_lengths[p->dash][n] * p->width;
        }
        cairo_set_dash(cr, dash, n, 0);
        cairo_set_line_width(cr, p->width);
        set_ink(cr, p->line, 1);
        cairo_stroke_preserve(cr);
    }
    cairo_new_path(cr);
}

/* Writes a line. The machine's font may be wider than the one for which lines were laid out: then
 * the line is set narrower. */
static void text(cairo_t *cr, const struct cr_canvas *c, const struct cr_item *item) {
    const struct cr_type_face *f = &item->face;
    char *words = strndup(c->words.s + item->from, (size_t)item->n);
    cairo_text_extents_t box;
    if (words == NULL) {
        return;
    }
    cairo_select_font_face(cr, f->mono ? "Liberation Mono" : "Liberation Sans",
                           CAIRO_FONT_SLANT_NORMAL,
                           f->bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, f->size);
    cairo_text_extents(cr, words, &box);
    double narrow = box.x_advance > item->w ? item->w / box.x_advance : 1;
    cairo_save(cr);
    cairo_translate(cr, item->x, item->y);
    if (f->upward) {
        cairo_rotate(cr, -3.14159265358979323846 / 2);
    }
    cairo_scale(cr, narrow, 1);
    cairo_move_to(cr, -0.5 * f->anchor * box.x_advance, 0);
    if (f->halo) {
        cairo_text_path(cr, words);
        cairo_set_source_rgb(cr, 1, 1, 1);
        cairo_set_line_width(cr, 2.5);
        cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
        cairo_set_dash(cr, NULL, 0, 0);
        cairo_stroke(cr);
        cairo_set_line_join(cr, CAIRO_LINE_JOIN_MITER);
        cairo_move_to(cr, -0.5 * f->anchor * box.x_advance, 0);
    }
    set_ink(cr, f->ink, 1);
    cairo_show_text(cr, words);
    cairo_restore(cr);
    cairo_new_path(cr);
    free(words);
}

static void draw(cairo_t *cr, const struct cr_canvas *c) {
    for (int i = 0; i < c->items; i++) {
        const struct cr_item *item = &c->item[i];
        switch (item->act) {
        case CR_ACT_PATH:
            path(cr, c, item);
            break;
        case CR_ACT_TEXT:
            text(cr, c, item);
            break;
        case CR_ACT_CLIP:
            cairo_save(cr);
            cairo_rectangle(cr, item->x, item->y, item->w, item->h);
            cairo_clip(cr);
            break;
        case CR_ACT_UNCLIP:
            cairo_restore(cr);
            break;
        }
    }
}

static void describe(cairo_surface_t *surface, const struct cr_pdf_about *about) {
    const struct {
        cairo_pdf_metadata_t what;
        const char *text;
    } rows[] = {
        {CAIRO_PDF_METADATA_TITLE, about->title},
        {CAIRO_PDF_METADATA_AUTHOR, about->author},
        {CAIRO_PDF_METADATA_SUBJECT, about->subject},
        {CAIRO_PDF_METADATA_CREATOR, PACKAGE_STRING},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        if (rows[i].text != NULL) {
            cairo_pdf_surface_set_metadata(surface, rows[i].what, rows[i].text);
        }
    }
    /* Without this line cairo writes the time of day. */
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                   about->date != NULL ? about->date : "");
}

enum cr_err cr_canvas_pdf(struct cr_canvas *const *page, int pages,
                          const struct cr_pdf_about *about, struct cr_str *out,
                          struct cr_error *err) {
    cairo_surface_t *surface =
        cairo_pdf_surface_create_for_stream(append, out, page[0]->w, page[0]->h);
    describe(surface, about);
    bool whole = true;
    cairo_t *cr = cairo_create(surface);
    for (int i = 0; i < pages; i++) {
        cairo_pdf_surface_set_size(surface, page[i]->w, page[i]->h);
        draw(cr, page[i]);
        cairo_show_page(cr);
        whole = whole && !page[i]->failed;
    }
    cairo_status_t status = cairo_status(cr);
    cairo_destroy(cr);
    cairo_surface_finish(surface);
    status = status != CAIRO_STATUS_SUCCESS ? status : cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    return status != CAIRO_STATUS_SUCCESS || !whole
               ? failed(whole ? status : CAIRO_STATUS_NO_MEMORY, err)
               : CR_ERR_OK;
}

enum cr_err cr_canvas_png(const struct cr_canvas *c, double dpi, struct cr_str *out,
                          struct cr_error *err) {
    double k = dpi / 72;
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)(c->w * k + 0.5),
                                                          (int)(c->h * k + 0.5));
    cairo_t *cr = cairo_create(surface);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    cairo_scale(cr, k, k);
    draw(cr, c);
    cairo_status_t status = cairo_status(cr);
    cairo_destroy(cr);
    if (status == CAIRO_STATUS_SUCCESS && c->failed) {
        status = CAIRO_STATUS_NO_MEMORY;
    }
    if (status == CAIRO_STATUS_SUCCESS) {
        status = cairo_surface_write_to_png_stream(surface, append, out);
    }
    cairo_surface_destroy(surface);
    return status != CAIRO_STATUS_SUCCESS ? failed(status, err) : CR_ERR_OK;
}

#else

enum cr_err cr_canvas_need_cairo(struct cr_error *err) {
    cr_err_set(err, CR_ERR_USAGE,
               "this build writes neither PDF nor PNG: it was configured without cairo");
    cr_err_hint(err, "install libcairo2-dev and build again, or give the file the suffix .svg "
                     "(a report: .html)");
    return CR_ERR_USAGE;
}

enum cr_err cr_canvas_pdf(struct cr_canvas *const *page, int pages,
                          const struct cr_pdf_about *about, struct cr_str *out,
                          struct cr_error *err) {
    (void)page, (void)pages, (void)about, (void)out;
    return cr_canvas_need_cairo(err);
}

enum cr_err cr_canvas_png(const struct cr_canvas *c, double dpi, struct cr_str *out,
                          struct cr_error *err) {
    (void)c, (void)dpi, (void)out;
    return cr_canvas_need_cairo(err);
}
#endif
