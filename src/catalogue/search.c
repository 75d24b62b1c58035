/* Finds cars by words: which cars the words fit, which one is meant, and which words could come
 * next. */
#include "catalogue/catalogue_priv.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { WORD = 40, WORDS = 12 };

/* The letters of Latin-1 and Latin Extended-A without their accents, by code point from U+00C0. */
static const char bare[] = "aaaaaaaceeeeiiiidnooooo ouuuuytsaaaaaaaceeeeiiiidnooooo ouuuuyty"
                           "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"
                           "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";

/* Writes a text in lower case without accents; all but letters, digits and points become blanks. */
static void fold(const char *s, char *out, size_t size) {
    size_t n = 0;
    for (; *s != '\0' && n + 1 < size; s++) {
        unsigned char c = (unsigned char)*s;
        if (c >= 0xc3 && c <= 0xc5 && (s[1] & 0xc0) == 0x80) {
            unsigned code = (c & 0x1fU) << 6 | ((unsigned char)s[1] & 0x3fU);
            out[n++] = code - 0xc0 < sizeof bare - 1 ? bare[code - 0xc0] : ' ';
            s++;
        } else {
            out[n++] = (char)(isalnum(c) || c == '.' ? tolower(c) : ' ');
        }
    }
    out[n] = '\0';
}

struct words {
    int n;
    char word[WORDS][WORD];
};

static void split(const char *text, struct words *out) {
    char folded[256];
    fold(text, folded, sizeof folded);
    out->n = 0;
    for (char *save = NULL, *w = strtok_r(folded, " ", &save); w != NULL && out->n < WORDS;
         w = strtok_r(NULL, " ", &save)) {
        snprintf(out->word[out->n++], WORD, "%s", w);
    }
}

/* A text as one word: f150 of "F-150". */
static void joined(const char *text, char out[WORD]) {
    char folded[WORD];
    size_t n = 0;
    fold(text, folded, sizeof folded);
    for (const char *p = folded; *p != '\0'; p++) {
        if (*p != ' ' && *p != '.') {
            out[n++] = *p;
        }
    }
    out[n] = '\0';
}

/* The make of a usual short name. */
static const char *make_of(const char *word) {
    static const char *const other[][2] = {{"vw", "volkswagen"},
                                           {"chevy", "chevrolet"},
                                           {"benz", "mercedes"},
                                           {"datsun", "nissan"},
                                           {"landrover", "land"}};
    for (size_t i = 0; i < sizeof other / sizeof other[0]; i++) {
        if (strcmp(word, other[i][0]) == 0) {
            return other[i][1];
        }
    }
    return word;
}

static bool is_year(const char *word, int *year) {
    char *end;
    long x = strtol(word, &end, 10);
    *year = (int)x;
    return strlen(word) == 4 && *end == '\0' && x >= 1900 && x < 2100;
}

/* Whether a word is a length in m, "4.25m" or "4.25". */
static bool is_length(const char *word, double *length) {
    char *end;
    if (strchr(word, '.') == NULL || !isdigit((unsigned char)word[0])) {
        return false;
    }
    *length = strtod(word, &end);
    return *end == '\0' || strcmp(end, "m") == 0;
}

/* How well a word fits a text: 2 if it is one of its words, 1 if three letters or more begin
 * one. */
static int fits_text(const char *word, const char *text) {
    struct words part;
    char whole[WORD];
    int best = 0;
    joined(text, whole);
    if (whole[0] != '\0' && strcmp(word, whole) == 0) {
        return 2;
    }
    split(text, &part);
    for (int i = 0; i < part.n; i++) {
        bool same = strcmp(part.word[i], word) == 0;
        bool begins = strlen(word) >= 3 && strncmp(part.word[i], word, strlen(word)) == 0;
        best = same ? 2 : begins && best < 1 ? 1 : best;
    }
    return best;
}

/* Whether a word is one of a car's model years. */
static bool is_its_year(const struct cr_car *car, const char *word, int *year) {
    return is_year(word, year) && car->from <= *year && *year <= car->to;
}

static bool fits(const struct cr_car *car, const char *word) {
    int year;
    double length;
    if (is_length(word, &length)) {
        return fabs(car->length - length) < 0.006;
    }
    if (is_its_year(car, word, &year)) {
        return true;
    }
    return fits_text(make_of(word), car->make) > 0 || fits_text(word, car->model) > 0 ||
           fits_text(word, car->body) > 0;
}

int cr_car_year(const struct cr_car *car, const char *words) {
    struct words w;
    int said = 0, year;
    split(words, &w);
    for (int i = 0; i < w.n; i++) {
        bool its = is_its_year(car, w.word[i], &year);
        said = its && fits_text(w.word[i], car->model) == 0 ? year : said; /* not a Peugeot 2008 */
    }
    return said;
}

int cr_catalogue_search(const struct cr_catalogue *c, const char *words, int *found) {
    struct words w;
    int n = 0;
    split(words, &w);
    for (int i = 0; i < c->n; i++) {
        bool all = true;
        for (int k = 0; k < w.n && all; k++) {
            all = fits(&c->car[i], w.word[k]);
        }
        if (all) {
            found[n++] = i;
        }
    }
    return n;
}

/* Whether every word of the model was said. */
static bool model_is_whole(const struct cr_car *car, const struct words *w) {
    struct words part;
    char whole[WORD];
    split(car->model, &part);
    joined(car->model, whole);
    int said = 0;
    for (int i = 0; i < part.n; i++) {
        bool one = false;
        for (int k = 0; k < w->n && !one; k++) {
            one = strcmp(w->word[k], part.word[i]) == 0 || strcmp(w->word[k], whole) == 0;
        }
        said += one;
    }
    return said == part.n;
}

static bool is_own(const struct cr_car *car, const struct words *w) {
    (void)w;
    return car->own;
}

static bool is_usual(const struct cr_car *car, const struct words *w) {
    (void)w;
    static const char *const special[] = {"Coupe", "Convertible", "Wagon"};
    for (size_t i = 0; i < sizeof special / sizeof special[0]; i++) {
        if (strcmp(car->body, special[i]) == 0) {
            return false;
        }
    }
    return true;
}

/* Keeps the cars that pass, unless none does. */
static int prefer(const struct cr_catalogue *c, int *found, int n, const struct words *w,
                  bool (*pass)(const struct cr_car *car, const struct words *w)) {
    int kept = 0;
    for (int i = 0; i < n; i++) {
        kept += pass(&c->car[found[i]], w);
    }
    if (kept == 0) {
        return n;
    }
    kept = 0;
    for (int i = 0; i < n; i++) {
        if (pass(&c->car[found[i]], w)) {
            found[kept++] = found[i];
        }
    }
    return kept;
}

static void list_some(const struct cr_catalogue *c, const int *found, int n, struct cr_error *err) {
    struct cr_str list = {0};
    for (int i = 0; i < n && i < 3; i++) {
        const struct cr_car *car = &c->car[found[i]];
        cr_str_add(&list, i > 0 ? "; " : "");
        cr_car_name(car, &list);
        if (!isnan(car->length)) {
            cr_str_addf(&list, " %.3fm", car->length);
        }
    }
    cr_str_add(&list, n > 3 ? " ..." : "");
    cr_err_hint(err, "add year, body or length: %.150s", cr_str_get(&list));
    cr_str_fini(&list);
}

/* Refuses words that fit no car, with the nearest make or model to a word that fits nothing. */
static enum cr_err unknown(const struct cr_catalogue *c, const char *words, struct cr_error *err) {
    struct words w;
    split(words, &w);
    cr_err_set(err, CR_ERR_NAME, "no car of the catalogue is '%.80s'", words);
    const char **names = calloc(2 * (size_t)c->n + 1, sizeof *names);
    char(*lower)[WORD] = calloc(2 * (size_t)c->n + 1, sizeof *lower);
    const char *near = NULL;
    for (int i = 0; names != NULL && lower != NULL && i < c->n; i++) {
        joined(c->car[i].make, lower[2 * i]);
        joined(c->car[i].model, lower[2 * i + 1]);
        names[2 * i] = lower[2 * i];
        names[2 * i + 1] = lower[2 * i + 1];
    }
    for (int k = 0; names != NULL && lower != NULL && k < w.n && near == NULL; k++) {
        bool known = false;
        for (int i = 0; i < c->n && !known; i++) {
            known = fits(&c->car[i], w.word[k]);
        }
        near = known ? NULL : cr_str_nearest(w.word[k], names, 2 * c->n);
    }
    if (near != NULL) {
        cr_err_hint(err, "did you mean '%s'? crumple catalogue lists them", near);
    } else {
        cr_err_hint(err, "crumple catalogue WORDS lists what there is; or give type and mass");
    }
    free(names);
    free(lower);
    return CR_ERR_NAME;
}

enum cr_err cr_catalogue_find(const struct cr_catalogue *c, const char *words,
                              const struct cr_car **out, struct cr_error *err) {
    struct words w;
    int *found = calloc((size_t)c->n + 1, sizeof *found);
    if (found == NULL) {
        return cr_err_set(err, CR_ERR_MEMORY, "no memory to look for a car");
    }
    split(words, &w);
    enum cr_err code = CR_ERR_OK;
    int n = w.n > 0 ? cr_catalogue_search(c, words, found) : 0;
    if (n == 0) {
        code = unknown(c, words, err);
    }
    n = n > 1 ? prefer(c, found, n, &w, model_is_whole) : n;
    n = n > 1 ? prefer(c, found, n, &w, is_own) : n;
    n = n > 1 ? prefer(c, found, n, &w, is_usual) : n;
    if (n == 1) {
        *out = &c->car[found[0]];
    } else if (n > 1) {
        code = cr_err_set(err, CR_ERR_NAME, "%d cars are '%.80s'", n, words);
        list_some(c, found, n, err);
    }
    free(found);
    return code;
}

/* ---- completion ---- */

/* The words that could come next, while they are told. */
struct next {
    const char *begin;
    void (*tell)(void *user, const char *word, bool year);
    void *user;
    char (*told)[WORD];
    int n, room;
};

static void tell(struct next *next, const char *word, bool year) {
    bool fits = word[0] != '\0' && strncasecmp(word, next->begin, strlen(next->begin)) == 0;
    for (int i = 0; i < next->n && fits; i++) {
        fits = strcmp(next->told[i], word) != 0;
    }
    if (fits && next->n < next->room) {
        snprintf(next->told[next->n++], WORD, "%s", word);
        next->tell(next->user, word, year);
    }
}

/* What follows the words of a name that were said: "Cruiser" of "Land Cruiser" after "land", ""
 * where all of it was said. */
static const char *unsaid(const char *name, const struct words *w) {
    const char *rest = name;
    char one[WORD], whole[WORD];
    joined(name, whole);
    for (bool said = true; said && *rest != '\0';) {
        size_t n = strcspn(rest, " -/");
        char part[WORD];
        snprintf(one, sizeof one, "%.*s", (int)n, rest);
        joined(one, part);
        said = false;
        for (int k = 0; k < w->n && !said; k++) {
            const char *word = make_of(w->word[k]);
            said = strcmp(word, part) == 0 || strcmp(word, whole) == 0;
        }
        rest += said ? n + strspn(rest + n, " -/") : 0;
    }
    return rest;
}

static void tell_words(struct next *next, const struct cr_car *car, const struct words *w) {
    const char *make = unsaid(car->make, w), *model = unsaid(car->model, w);
    if (model[0] != '\0') {
        tell(next, make, false);
    }
    if (make[0] == '\0' || next->begin[0] != '\0') {
        tell(next, model, false);
    }
}

/* Tells the years of the cars whose model was said. */
static void tell_years(struct next *next, const struct cr_catalogue *c, const int *found, int n,
                       const struct words *w) {
    for (int year = 1900; year < 2100; year++) {
        char word[16];
        bool built = false;
        for (int i = 0; i < n && !built; i++) {
            const struct cr_car *car = &c->car[found[i]];
            built = car->from <= year && year <= car->to && unsaid(car->model, w)[0] == '\0';
        }
        snprintf(word, sizeof word, "%d", year);
        tell(next, built ? word : "", true);
    }
}

void cr_catalogue_complete(const struct cr_catalogue *c, const char *words, const char *begin,
                           void (*next)(void *user, const char *word, bool year), void *user) {
    struct words w;
    struct next to = {.begin = begin, .tell = next, .user = user, .room = 200 + 2 * c->n};
    int *found = calloc((size_t)c->n + 1, sizeof *found);
    to.told = calloc((size_t)to.room, sizeof *to.told);
    split(words, &w);
    int n = found != NULL && to.told != NULL ? cr_catalogue_search(c, words, found) : 0;
    for (int i = 0; i < n; i++) {
        tell_words(&to, &c->car[found[i]], &w);
    }
    tell_years(&to, c, found, n, &w);
    free(found);
    free(to.told);
}
