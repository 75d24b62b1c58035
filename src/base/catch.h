/* Handlers of signals. */
#ifndef CR_BASE_CATCH_H
#define CR_BASE_CATCH_H

/* From now on a signal calls the handler (or SIG_IGN, SIG_DFL). flags: those of sigaction, mostly
 * 0: a call that waits is then interrupted, so that who waits looks at the handler's flag. */
void cr_catch(int sig, void (*handler)(int), int flags);

#endif
