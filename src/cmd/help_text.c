/* Text of the help: folded, and searched. */
#include "cmd/cmd_priv.h"

#include <string.h>
#include <strings.h>

enum { CR_HELP_WIDTH = 78 };

void cr_help_fold(struct cr_str *out, const char *text, int first, int indent) {
    int col = first;
    bool begun = false;
    while (*text != '\0') {
        int n = (int)strcspn(text, " ");
        if (begun && col + 1 + n > CR_HELP_WIDTH) {
            cr_str_add(out, "\n");
            cr_str_fill(out, ' ', indent);
            col = indent;
        } else if (begun) {
            cr_str_add(out, " ");
            col++;
        }
        cr_str_addn(out, text, (size_t)n);
        col += n;
        begun = true;
        text += n;
        text += strspn(text, " ");
    }
    cr_str_add(out, "\n");
}

bool cr_help_contains(const char *text, const char *word) {
    for (; text != NULL && *text != '\0'; text++) {
        if (strncasecmp(text, word, strlen(word)) == 0) {
            return true;
        }
    }
    return false;
}
