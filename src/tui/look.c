/* How the session looks now: colours, glyphs and theme as the terminal and the view have them. */
#include "tui/tui_priv.h"

#include "render/theme.h"

#include <string.h>

struct cr_look cr_tui_look(const struct cr_tui *t) {
    const struct cr_view *view = cr_session_view(t->session);
    struct cr_look look = *cr_session_look(t->session);
    const char *theme = look.color == CR_COLOR_NONE ? "mono" : view->theme;
    if (strcmp(theme, "auto") == 0) {
        static const char *const on[] = {"auto", "dark", "light"};
        theme = on[cr_term_ground()];
    }
    look.theme = cr_theme_find(theme);
    for (int i = 0; i < CR_COLORMAPS; i++) {
        if (strcmp(cr_colormap_word((enum cr_colormap)i), view->colormap) == 0) {
            look.map = (enum cr_colormap)i;
        }
    }
    return look;
}
