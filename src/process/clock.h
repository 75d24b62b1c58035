/* The clocks of the process: wall clock for people who wait, processor time for budgets. */
#ifndef CR_PROCESS_CLOCK_H
#define CR_PROCESS_CLOCK_H

/* Seconds from some moment on; they only go forward, also when somebody sets the time of day. */
double cr_clock_wall(void);

/* Seconds of processor time that the calling thread has used, which do not grow while other
 * programs have the processor. */
double cr_clock_thread(void);

#endif
