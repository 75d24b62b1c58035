/* The full screen (screen.md): curses, panes, keys, mouse; every action is a command line. */
#ifndef CR_TUI_TUI_H
#define CR_TUI_TUI_H

#endif
