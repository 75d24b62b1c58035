/* Line sources for the command language: readline on a terminal, command files, pipes, -e. */
#ifndef CR_REPL_REPL_H
#define CR_REPL_REPL_H

#endif
