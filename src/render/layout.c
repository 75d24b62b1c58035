/* Divides a terminal of any size into the rectangles of the full screen. */
#include "render/layout.h"

enum {
    PROMPT_W = 40,
    PROMPT_H = 12, /* a smaller terminal shows prompt and log only */
    ONE_W = 80,
    ONE_H = 24, /* from this size on there is a results pane */
    TWO_W = 120,
    TWO_H = 36,
    ALL_W = 160,
    ALL_H = 44,
    RESULTS_W = 30,
    PANE_H = 10, /* a picture with its frame needs so many rows */
    SIDE_W = 76  /* right-hand column with table, sweep and log */
};

static const char *const area_titles[CR_AREAS] = {
#define X(name, title, word) title,
    CR_AREA_LIST(X)
#undef X
};
static const char *const area_words[CR_AREAS] = {
#define X(name, title, word) word,
    CR_AREA_LIST(X)
#undef X
};

const char *cr_area_title(enum cr_area pane) {
    return area_titles[pane];
}

const char *cr_area_word(enum cr_area pane) {
    return area_words[pane];
}

/* Cut n rows or columns off one side of the rest. */
static struct cr_rect top(struct cr_rect *rest, int n) {
    n = n > rest->h ? rest->h : n;
    struct cr_rect r = {rest->x, rest->y, rest->w, n};
    rest->y += n;
    rest->h -= n;
    return r;
}

static struct cr_rect bottom(struct cr_rect *rest, int n) {
    n = n > rest->h ? rest->h : n;
    rest->h -= n;
    return (struct cr_rect){rest->x, rest->y + rest->h, rest->w, n};
}

static struct cr_rect left(struct cr_rect *rest, int n) {
    n = n > rest->w ? rest->w : n;
    struct cr_rect r = {rest->x, rest->y, n, rest->h};
    rest->x += n;
    rest->w -= n;
    return r;
}

static struct cr_rect right(struct cr_rect *rest, int n) {
    n = n > rest->w ? rest->w : n;
    rest->w -= n;
    return (struct cr_rect){rest->x + rest->w, rest->y, n, rest->h};
}

static void prompt_only(struct cr_layout *l, struct cr_rect rest) {
    l->prompt = bottom(&rest, 1);
    if (rest.h > 1) {
        l->notice = top(&rest, 1);
    }
    l->pane[CR_AREA_LOG] = rest;
}

/* The rows of dialogue: the usual number, or more if the panes above keep what they need. */
static int dialogue_rows(const struct cr_rect *rest, int panes, int usual, int talk) {
    int most = rest->h - panes * PANE_H;
    talk = talk < most ? talk : most;
    return talk > usual ? talk : usual;
}

static void narrow(struct cr_layout *l, struct cr_rect rest, enum cr_area view, int talk) {
    if (rest.h >= 16) {
        l->keys = bottom(&rest, 1);
    }
    l->prompt = bottom(&rest, 1);
    l->dialogue = bottom(&rest, dialogue_rows(&rest, 1, 2, talk));
    l->pane[view] = rest;
}

static void one(struct cr_layout *l, struct cr_rect rest, enum cr_area view, int talk) {
    l->keys = bottom(&rest, 1);
    if (rest.h >= 30) {
        l->hint = bottom(&rest, 1);
    }
    l->prompt = bottom(&rest, 1);
    l->dialogue = bottom(&rest, dialogue_rows(&rest, 1, rest.h >= 32 ? 4 : 2, talk));
    if (talk == 0) {
        l->spark = bottom(&rest, 2);
    }
    /* Results stand beside a picture or a curve; texts take the whole width. */
    if (view <= CR_AREA_ENERGY) {
        l->results = right(&rest, RESULTS_W);
    }
    l->pane[view] = rest;
}

/* Scene and results stand above, the chosen view (or the pulse) below. */
static void two(struct cr_layout *l, struct cr_rect rest, enum cr_area view, int talk) {
    l->keys = bottom(&rest, 1);
    l->hint = bottom(&rest, 1);
    l->prompt = bottom(&rest, 1);
    l->dialogue = bottom(&rest, dialogue_rows(&rest, 2, 3, talk));
    l->pane[view == CR_AREA_SCENE ? CR_AREA_PULSE : view] = bottom(&rest, rest.h * 3 / 8);
    l->results = right(&rest, RESULTS_W);
    l->pane[CR_AREA_SCENE] = rest;
}

static void all(struct cr_layout *l, struct cr_rect rest, int talk) {
    l->keys = bottom(&rest, 1);
    l->hint = bottom(&rest, 1);
    l->prompt = bottom(&rest, 1);
    struct cr_rect side = right(&rest, rest.w >= 200 ? SIDE_W : 66);
    struct cr_rect plots = bottom(&rest, rest.h * 2 / 5);
    l->pane[CR_AREA_SCENE] = rest;
    l->pane[CR_AREA_PULSE] = left(&plots, (plots.w + 1) / 2);
    l->pane[CR_AREA_ENERGY] = plots;
    int table = side.h * 46 / 100, sweep = (side.h - table) * 45 / 100;
    int log = dialogue_rows(&side, 2, side.h - table - sweep, talk > 0 ? talk + 2 : 0);
    if (log > side.h - table - sweep) { /* the log comes forward, the others share the rest */
        table = (side.h - log + 1) / 2;
        sweep = side.h - log - table;
    }
    l->pane[CR_AREA_TABLE] = top(&side, table);
    l->pane[CR_AREA_SWEEP] = top(&side, sweep);
    l->pane[CR_AREA_LOG] = side;
}

struct cr_layout cr_layout_of(int w, int h, enum cr_area view, bool zoomed, int talk) {
    struct cr_layout l = {.kind = CR_LAYOUT_PROMPT};
    struct cr_rect rest = {0, 0, w < 1 ? 1 : w, h < 1 ? 1 : h};
    if (w < PROMPT_W || h < PROMPT_H) {
        prompt_only(&l, rest);
        return l;
    }
    l.title = top(&rest, 1);
    if (zoomed || w < ONE_W || h < ONE_H) {
        l.kind = CR_LAYOUT_NARROW;
        narrow(&l, rest, view, talk);
    } else if (w >= ALL_W && h >= ALL_H) {
        l.kind = CR_LAYOUT_ALL;
        all(&l, rest, talk);
    } else if (w >= TWO_W && h >= TWO_H) {
        l.kind = CR_LAYOUT_TWO;
        two(&l, rest, view, talk);
    } else {
        l.kind = CR_LAYOUT_ONE;
        one(&l, rest, view, talk);
    }
    return l;
}
