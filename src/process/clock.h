/* The clocks of the process: wall clock for people who wait, processor time for budgets. */
#ifndef CR_PROCESS_CLOCK_H
#define CR_PROCESS_CLOCK_H

/* s from some moment on; it only goes forward, whoever sets the time of day. */
double cr_clock_wall(void);

/* s of processor time that the calling thread has used: a loaded machine takes nobody's away. */
double cr_clock_thread(void);

#endif
