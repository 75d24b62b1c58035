/* The layout function over all sizes of terminals. */
#include "test.h"

#include "render/layout.h"

#include <string.h>

enum { W = 300, H = 100, RECTS = CR_AREAS + 8 };

static int rects(const struct cr_layout *l, struct cr_rect out[RECTS]) {
    int n = 0;
    for (int i = 0; i < CR_AREAS; i++) {
        out[n++] = l->pane[i];
    }
    const struct cr_rect others[] = {l->title,    l->notice, l->results, l->spark,
                                     l->dialogue, l->prompt, l->hint,    l->keys};
    memcpy(out + n, others, sizeof others);
    return n + 8;
}

/* every cell of the screen belongs to exactly one rectangle */
static void check_tiles(const struct cr_layout *l, int w, int h) {
    static unsigned char seen[W * H];
    struct cr_rect r[RECTS];
    int n = rects(l, r);
    memset(seen, 0, sizeof seen);
    for (int i = 0; i < n; i++) {
        if (r[i].w == 0 || r[i].h == 0) {
            continue;
        }
        if (r[i].x < 0 || r[i].y < 0 || r[i].x + r[i].w > w || r[i].y + r[i].h > h) {
            fail_msg("%dx%d: rectangle %d leaves the screen: %d %d %d %d", w, h, i, r[i].x, r[i].y,
                     r[i].w, r[i].h);
        }
        for (int y = r[i].y; y < r[i].y + r[i].h; y++) {
            for (int x = r[i].x; x < r[i].x + r[i].w; x++) {
                if (seen[y * W + x]++ != 0) {
                    fail_msg("%dx%d: rectangle %d overlaps another at %d %d", w, h, i, x, y);
                }
            }
        }
    }
    for (int y = 0; y < h; y++) {
        for (int x = 0; x < w; x++) {
            if (seen[y * W + x] == 0) {
                fail_msg("%dx%d: nothing at %d %d", w, h, x, y);
            }
        }
    }
}

static int shown(const struct cr_layout *l) {
    int n = 0;
    for (int i = 0; i < CR_AREAS; i++) {
        n += l->pane[i].w > 0;
    }
    return n;
}

/* the words of a lesson are in view as far as the panes can spare the rows */
static void check_talk(const struct cr_layout *l, int talk) {
    int rows = l->kind == CR_LAYOUT_ALL ? l->pane[CR_AREA_LOG].h - 2 : l->dialogue.h;
    bool least = false;
    for (int i = 0; i < CR_AREAS; i++) {
        least = least || (l->pane[i].w > 0 && l->pane[i].h <= 13);
    }
    if (talk > 0 && l->kind != CR_LAYOUT_PROMPT) {
        assert_true(rows >= talk || least);
    }
}

static void check_sizes(const struct cr_layout *l, int w, int h, enum cr_area view, bool zoomed,
                        int talk) {
    assert_int_equal(l->prompt.w, w);
    assert_int_equal(l->prompt.h, 1);
    if (w < 40 || h < 12) {
        assert_int_equal(l->kind, CR_LAYOUT_PROMPT);
        return;
    }
    const struct cr_rect *p = &l->pane[view];
    if (p->w < 40 || p->h < 7) {
        fail_msg("%dx%d: view %d has only %dx%d", w, h, (int)view, p->w, p->h);
    }
    assert_int_equal(l->title.h, 1);
    if (l->kind == CR_LAYOUT_ONE && view > CR_AREA_ENERGY) {
        assert_int_equal(p->w, w); /* texts take the whole width */
    } else if (w >= 80 && h >= 24 && !zoomed && l->kind != CR_LAYOUT_ALL) {
        assert_int_equal(l->results.w, 30);
        assert_true(l->results.h >= (talk > 0 ? 10 : 12));
    }
    assert_int_equal(shown(l), zoomed || l->kind < CR_LAYOUT_TWO ? 1
                               : l->kind == CR_LAYOUT_TWO        ? 2
                                                                 : CR_AREAS);
}

static void test_all_sizes(void **state) {
    (void)state;
    for (int h = 5; h <= H; h++) {
        for (int w = 20; w <= W; w++) {
            enum cr_area view = (enum cr_area)((w + h) % CR_AREAS);
            for (int zoomed = 0; zoomed < 2; zoomed++) {
                int talk = (w + 2 * h) % 3 * 9; /* 0, 9, 18 rows */
                struct cr_layout l = cr_layout_of(w, h, view, zoomed, talk);
                check_tiles(&l, w, h);
                check_sizes(&l, w, h, view, zoomed, talk);
                check_talk(&l, talk);
            }
        }
    }
}

static void test_kinds(void **state) {
    (void)state;
    assert_int_equal(cr_layout_of(39, 50, CR_AREA_SCENE, false, 0).kind, CR_LAYOUT_PROMPT);
    assert_int_equal(cr_layout_of(79, 24, CR_AREA_SCENE, false, 0).kind, CR_LAYOUT_NARROW);
    assert_int_equal(cr_layout_of(80, 24, CR_AREA_SCENE, false, 0).kind, CR_LAYOUT_ONE);
    assert_int_equal(cr_layout_of(120, 36, CR_AREA_SCENE, false, 0).kind, CR_LAYOUT_TWO);
    assert_int_equal(cr_layout_of(160, 44, CR_AREA_SCENE, false, 0).kind, CR_LAYOUT_ALL);
    assert_int_equal(cr_layout_of(160, 43, CR_AREA_SCENE, false, 0).kind, CR_LAYOUT_TWO);
    /* nothing is too small to answer */
    struct cr_layout tiny = cr_layout_of(1, 1, CR_AREA_SCENE, false, 0);
    assert_int_equal(tiny.prompt.h, 1);
    check_tiles(&tiny, 1, 1);
}

static void test_words(void **state) {
    (void)state;
    assert_string_equal(cr_area_word(CR_AREA_SWEEP), "sweep");
    assert_string_equal(cr_area_title(CR_AREA_SWEEP), "Sweep");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_sizes),
        cmocka_unit_test(test_kinds),
        cmocka_unit_test(test_words),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
