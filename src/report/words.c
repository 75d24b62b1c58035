/* Finds the words of the report's languages: English stands in the code, the others in one
 * table. */
#include "report/german.h"
#include "report/report.h"

#include <stdlib.h>
#include <string.h>

static int compare(const void *key, const void *row) {
    const char *const *english = row;
    return strcmp(key, *english);
}

const char *cr_words(enum cr_lang lang, const char *english) {
    if (lang == CR_LANG_EN) {
        return english;
    }
    const char *const *found =
        bsearch(english, german_words, sizeof german_words / sizeof german_words[0],
                sizeof german_words[0], compare);
    return found != NULL ? found[1] : english;
}
