/* Sections 12 and 13: how to repeat the computation; the scene as given and resolved, the motion in
 * about 100 rows. */
#include "report/sections.h"

#include "base/json.h"
#include "base/vec.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <string.h>

enum { TRACE_ROWS = 100 };

static void trace_row(struct cr_paper *p, int sample, int body) {
    static const enum cr_quantity shown[] = {
        CR_QUANTITY_X,  CR_QUANTITY_Y,        CR_QUANTITY_HEADING, CR_QUANTITY_VX,
        CR_QUANTITY_VY, CR_QUANTITY_YAW_RATE, CR_QUANTITY_FORCE,   CR_QUANTITY_ENERGY};
    const struct cr_solution *sol = p->r->solution;
    const char *cell[CR_COLUMNS] = {
        cr_doc_text(p->doc, "%.1f", 1e3 * (sol->t[sample] - sol->t_contact)),
        p->r->resolved.part[body].id};
    for (int i = 0; i < 8; i++) {
        cell[2 + i] = cr_paper_number(p, 2, cr_result_quantity(sol, sample, body, shown[i]));
    }
    cr_doc_row(p->doc, cell);
}

static void trace(struct cr_paper *p) {
    const struct cr_solution *sol = p->r->solution;
    int bodies = 0;
    for (int i = 0; i < sol->bodies; i++) {
        bodies += cr_result_moves(p->r, i);
    }
    int rows = bodies > 0 ? TRACE_ROWS / bodies : 0;
    int every = rows > 0 ? (sol->samples + rows - 1) / rows : 1;
    every = every > 0 ? every : 1;
    cr_doc_addf(p->doc, CR_BLOCK_MINOR, W(p, "Motion, every %d. time slice"), every);
    cr_doc_table(p->doc, 10);
    HEAD(p, "t, ms", "", "x, m", "y, m", W(p, "heading, deg"), "vx, m/s", "vy, m/s",
         W(p, "yaw rate, deg/s"), W(p, "force, kN"), W(p, "energy, kJ"));
    for (int k = every - 1; k < sol->samples; k += every) {
        for (int i = 0; i < sol->bodies; i++) {
            if (cr_result_moves(p->r, i)) {
                trace_row(p, k, i);
            }
        }
    }
}

void cr_section_annex(struct cr_paper *p) {
    struct cr_str resolved = {0};
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "12 How to repeat it"));
    cr_doc_addf(p->doc, CR_BLOCK_TEXT,
                W(p, "With %s and the scene of section 13 in a file the following line makes this "
                     "report again; the result then has the SHA-256 of section 1."),
                p->s->program);
    cr_doc_add(p->doc, CR_BLOCK_CODE, p->s->command);
    if (p->s->commit != NULL && p->s->commit[0] != '\0') {
        cr_doc_addf(p->doc, CR_BLOCK_TEXT, W(p, "The program was built from commit %s."),
                    p->s->commit);
    }
    cr_doc_addf(p->doc, CR_BLOCK_TEXT, W(p, "Its data have the SHA-256 %s."), p->s->data_hash);
    cr_doc_add(p->doc, CR_BLOCK_HEADING, W(p, "13 Annex"));
    cr_doc_add(p->doc, CR_BLOCK_MINOR, W(p, "The scene as it was given"));
    cr_doc_add(p->doc, CR_BLOCK_CODE, p->s->scene_text);
    cr_doc_add(p->doc, CR_BLOCK_MINOR, W(p, "The scene with every value"));
    if (cr_json_add(cr_scene_to_json(&p->r->resolved, true), true, &resolved)) {
        cr_doc_add(p->doc, CR_BLOCK_CODE, cr_str_get(&resolved));
    } else {
        p->doc->failed = true;
    }
    cr_str_fini(&resolved);
    trace(p);
}
