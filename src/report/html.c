/* Writes a paper as one HTML file with its pictures inside, without scripts, ready for print. */
#include "report/document.h"

#include <stdio.h>
#include <string.h>

static const char style[] =
    "@page{margin:18mm 16mm}"
    "body{font:10.5pt/1.4 Helvetica,Arial,\"Liberation Sans\",sans-serif;color:#1a1a1a;"
    "max-width:176mm;margin:12mm auto;padding:0 4mm}"
    "h1{font-size:19pt;margin:0 0 4mm}h2{font-size:13.5pt;margin:8mm 0 2mm;"
    "border-bottom:1px solid #808080;break-after:avoid}"
    "h3{font-size:11pt;margin:4mm 0 1mm;break-after:avoid}"
    "p{margin:1.5mm 0;hyphens:auto}"
    "table{border-collapse:collapse;margin:2mm 0 4mm;font-size:9pt;"
    "font-variant-numeric:tabular-nums}"
    "th,td{text-align:left;vertical-align:top;padding:.7mm 3mm .7mm 1mm;"
    "border-bottom:1px solid #dedede}"
    "td:last-child{overflow-wrap:anywhere}" /* it may hold hashes and paths */
    "th{border-bottom:1px solid #808080}thead{display:table-header-group}"
    "tr{break-inside:avoid}"
    "tr.assumed td:first-child{border-left:3px solid #d55e00;padding-left:2mm}"
    ".warning{border-left:3px solid #b00000;padding-left:3mm}"
    "figure{margin:3mm 0;break-inside:avoid}figure svg{width:100%;height:auto}"
    "figcaption{font-size:9pt;color:#5a5a5a}"
    "pre{font:7.5pt/1.3 Courier,\"Liberation Mono\",monospace;white-space:pre-wrap;"
    "overflow-wrap:anywhere;background:#f6f6f6;padding:2mm}"
    "@media print{body{margin:0;max-width:none;padding:0}}";

/* Adds a text with blanks for control characters, which have no place in a page. */
static void escape(struct cr_str *out, const char *s) {
    for (; *s != '\0'; s++) {
        bool control = (unsigned char)*s < 32 && *s != '\n' && *s != '\t';
        cr_str_xml(out, control ? " " : s, 1);
    }
}

static void element(struct cr_str *out, const char *tag, const char *class, const char *text) {
    cr_str_addf(out, "<%s%s%s%s>", tag, class != NULL ? " class=\"" : "",
                class != NULL ? class : "", class != NULL ? "\"" : "");
    escape(out, text);
    cr_str_addf(out, "</%s>\n", tag);
}

static void table(struct cr_str *out, const struct cr_block *b) {
    cr_str_add(out, "<table>\n");
    for (int i = 0; i < b->rows; i++) {
        const struct cr_doc_row *r = &b->row[i];
        const char *tag = r->head ? "th" : "td";
        cr_str_add(out, r->head ? "<thead>" : "");
        cr_str_addf(out, "<tr%s>", r->marked ? " class=\"assumed\"" : "");
        for (int k = 0; k < b->columns; k++) {
            cr_str_addf(out, "<%s>", tag);
            escape(out, r->cell[k]);
            cr_str_addf(out, "</%s>", tag);
        }
        cr_str_add(out, r->head ? "</tr></thead>\n" : "</tr>\n");
    }
    cr_str_add(out, "</table>\n");
}

static enum cr_err figure(struct cr_str *out, const struct cr_block *b, struct cr_error *err) {
    cr_str_add(out, "<figure>\n");
    enum cr_err code = cr_canvas_svg(b->figure, b->text, false, out, err);
    element(out, "figcaption", NULL, b->text);
    cr_str_add(out, "</figure>\n");
    return code;
}

enum cr_err cr_document_html(const struct cr_document *doc, struct cr_str *out,
                             struct cr_error *err) {
    static const char *const tags[] = {"h1", "h2", "h3", "p", "p", NULL, NULL, "pre"};
    enum cr_err code = CR_ERR_OK;
    cr_str_addf(out, "<!DOCTYPE html>\n<html lang=\"%s\">\n<head>\n<meta charset=\"utf-8\">\n",
                doc->language);
    element(out, "title", NULL, doc->title);
    if (doc->author != NULL) {
        cr_str_add(out, "<meta name=\"author\" content=\"");
        escape(out, doc->author);
        cr_str_add(out, "\">\n");
    }
    cr_str_addf(out,
                "<meta name=\"viewport\" content=\"width=device-width\">\n<style>%s</style>\n"
                "</head>\n<body>\n",
                style);
    for (int i = 0; i < doc->blocks && code == CR_ERR_OK; i++) {
        const struct cr_block *b = &doc->block[i];
        if (b->kind == CR_BLOCK_TABLE) {
            table(out, b);
        } else if (b->kind == CR_BLOCK_FIGURE) {
            code = figure(out, b, err);
        } else {
            element(out, tags[b->kind], b->kind == CR_BLOCK_WARNING ? "warning" : NULL, b->text);
        }
    }
    cr_str_add(out, "</body>\n</html>\n");
    if (code == CR_ERR_OK && (doc->failed || out->failed)) {
        code = cr_err_set(err, CR_ERR_MEMORY, "no memory for the report");
    }
    return code;
}
