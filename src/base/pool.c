/* Threads that work on items in any order while items are taken and given out in order. */
#include "base/pool.h"

#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

enum { ALIVE = 4 }; /* items per thread between taking and giving */

struct pool {
    const struct cr_pool_work *work;
    pthread_mutex_t taking; /* held while an item is read, so that items keep their order */
    pthread_mutex_t lock;   /* of all below */
    pthread_cond_t space, ready;
    void **ring; /* items done, by number; NULL: not yet */
    int window;
    long taken, given;
    int running;
    bool over;
};

/* next item with its number, NULL when there is none; waits for room in the ring */
static void *take(struct pool *p, long *number) {
    void *item = NULL;
    pthread_mutex_lock(&p->taking);
    pthread_mutex_lock(&p->lock);
    while (!p->over && p->taken - p->given >= p->window) {
        pthread_cond_wait(&p->space, &p->lock);
    }
    bool over = p->over;
    pthread_mutex_unlock(&p->lock);
    /* The input may be a slow pipe: results must come out while this thread waits for input. */
    if (!over) {
        item = p->work->take(p->work->user);
    }
    pthread_mutex_lock(&p->lock);
    if (item != NULL) {
        *number = p->taken++;
    } else {
        p->over = true;
    }
    pthread_mutex_unlock(&p->lock);
    pthread_mutex_unlock(&p->taking);
    return item;
}

static void *worker(void *arg) {
    struct pool *p = arg;
    long number = 0;
    for (void *item; (item = take(p, &number)) != NULL;) {
        p->work->work(p->work->user, item);
        pthread_mutex_lock(&p->lock);
        p->ring[number % p->window] = item;
        pthread_cond_signal(&p->ready);
        pthread_mutex_unlock(&p->lock);
    }
    pthread_mutex_lock(&p->lock);
    p->running--;
    pthread_cond_signal(&p->ready);
    pthread_cond_broadcast(&p->space);
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

/* Hands out finished results in order until all workers have ended. */
static void give_all(struct pool *p) {
    pthread_mutex_lock(&p->lock);
    for (;;) {
        void **slot = &p->ring[p->given % p->window], *item = *slot;
        if (item != NULL) {
            *slot = NULL;
            pthread_mutex_unlock(&p->lock);
            bool go_on = p->work->give(p->work->user, item);
            pthread_mutex_lock(&p->lock);
            p->given++;
            p->over = p->over || !go_on;
            pthread_cond_broadcast(&p->space);
        } else if (p->running == 0) {
            break;
        } else if (p->work->idle != NULL) {
            pthread_mutex_unlock(&p->lock);
            p->work->idle(p->work->user);
            pthread_mutex_lock(&p->lock);
        } else {
            pthread_cond_wait(&p->ready, &p->lock);
        }
    }
    pthread_mutex_unlock(&p->lock);
}

/* threads that do not take the signals meant for the calling one; number that could be started */
static int start(struct pool *p, pthread_t *thread, int jobs) {
    sigset_t all, old;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &old);
    int n = 0;
    pthread_mutex_lock(&p->lock);
    while (n < jobs && pthread_create(&thread[n], NULL, worker, p) == 0) {
        n++;
        p->running++;
    }
    pthread_mutex_unlock(&p->lock);
    pthread_sigmask(SIG_SETMASK, &old, NULL);
    return n;
}

enum cr_err cr_pool_run(const struct cr_pool_work *work, int jobs, struct cr_error *err) {
    if (jobs <= 0) {
        long n = sysconf(_SC_NPROCESSORS_ONLN);
        jobs = n < 1 ? 1 : n > CR_POOL_JOBS_MAX ? CR_POOL_JOBS_MAX : (int)n;
    }
    struct pool p = {.work = work, .window = ALIVE * jobs};
    pthread_t *thread = calloc((size_t)jobs, sizeof *thread);
    p.ring = calloc((size_t)p.window, sizeof *p.ring);
    enum cr_err code = CR_ERR_OK;
    int n = 0;
    pthread_mutex_init(&p.taking, NULL);
    pthread_mutex_init(&p.lock, NULL);
    pthread_cond_init(&p.space, NULL);
    pthread_cond_init(&p.ready, NULL);
    if (thread != NULL && p.ring != NULL) {
        n = start(&p, thread, jobs);
    }
    if (n == 0) {
        code = cr_err_set(err, CR_ERR_MEMORY, "cannot start a thread to work on");
        cr_err_hint(err, "raise the limits of processes and memory");
    } else {
        give_all(&p);
    }
    for (int i = 0; i < n; i++) {
        pthread_join(thread[i], NULL);
    }
    pthread_cond_destroy(&p.ready);
    pthread_cond_destroy(&p.space);
    pthread_mutex_destroy(&p.lock);
    pthread_mutex_destroy(&p.taking);
    free(p.ring);
    free(thread);
    return code;
}
