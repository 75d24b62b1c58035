/* The command language (screen.md, Grammar and Commands): tokens, the command table, the session
 * that commands work on, and completion. Output goes through struct cr_out alone. */
#ifndef CR_CMD_CMD_H
#define CR_CMD_CMD_H

#endif
