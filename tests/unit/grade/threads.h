// SPDX-License-Identifier: MIT
// A host's parallel_for with as many threads as asked, that take pieces as they come.

#ifndef SF_TEST_GRADE_THREADS_H
#define SF_TEST_GRADE_THREADS_H

#include <sf/base.h>

#include <stddef.h>

enum { THREADS_MAX = 16 };

typedef struct crowd {
    int threads;
    size_t count, next;
    sf_task_body body;
    void *context;
} crowd;

static inline void *crowd_work(void *user)
{
    crowd *c = user;
    for (;;) {
        size_t i = __atomic_fetch_add(&c->next, 1, __ATOMIC_RELAXED);
        if (i >= c->count) {
            return NULL;
        }
        c->body(c->context, i);
    }
}

#if defined(__unix__)
#include <pthread.h>

static inline void crowd_for(void *user, size_t count, sf_task_body body, void *context)
{
    crowd c = {*(const int *)user, count, 0, body, context};
    pthread_t threads[THREADS_MAX];
    int started = 0;
    while (started < c.threads - 1 && started < THREADS_MAX &&
           pthread_create(&threads[started], NULL, crowd_work, &c) == 0) {
        started++;
    }
    crowd_work(&c);
    while (started > 0) {
        pthread_join(threads[--started], NULL);
    }
}
#else
static inline void crowd_for(void *user, size_t count, sf_task_body body, void *context)
{
    crowd c = {*(const int *)user, count, 0, body, context};
    crowd_work(&c);
}
#endif

// A task whose pieces run on `threads` threads; the number must outlive it.
static inline sf_task crowd_task(int *threads)
{
    sf_task task = sf_task_default();
    task.parallel_for = crowd_for;
    task.user = threads;
    return task;
}

#endif
