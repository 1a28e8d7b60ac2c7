// SPDX-License-Identifier: MIT
// Threads for the library's parallel_for hook.
//
// Workers sleep until a round begins, then take indices one by one under a lock. The pieces that
// libsf hands out are slabs and slices, thousands of times longer than the lock is held, so there
// is nothing to gain from anything cleverer.

#include "pool.h"

#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

enum { THREADS_MAX = 256 };

struct pool {
    pthread_mutex_t lock;
    pthread_cond_t wake, done;
    sf_task_body body; // NULL between rounds
    void *context;
    size_t next, count, under_way;
    int ending, worker_count;
    pthread_t workers[THREADS_MAX];
};

// Work on the round as long as there is something to take. The lock is held on entry and on exit.
static void take_part(pool *p)
{
    while (p->next < p->count) {
        size_t index = p->next++;
        sf_task_body body = p->body;
        void *context = p->context;
        p->under_way++;
        pthread_mutex_unlock(&p->lock);
        body(context, index);
        pthread_mutex_lock(&p->lock);
        p->under_way--;
        if (p->under_way == 0 && p->next == p->count) {
            pthread_cond_broadcast(&p->done);
        }
    }
}

static void *work(void *user)
{
    pool *p = user;
    pthread_mutex_lock(&p->lock);
    while (!p->ending) {
        take_part(p);
        if (!p->ending) {
            pthread_cond_wait(&p->wake, &p->lock);
        }
    }
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

static int processors(void)
{
#ifdef _SC_NPROCESSORS_ONLN
    long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count < 1 ? 1 : (int)(count > THREADS_MAX ? THREADS_MAX : count);
#else
    return 1;
#endif
}

pool *pool_create(int threads)
{
    int wanted = (threads > 0 ? threads : processors()) - 1;
    if (wanted < 1) {
        return NULL;
    }
    pool *p = calloc(1, sizeof *p);
    if (p == NULL) {
        return NULL;
    }
    pthread_mutex_init(&p->lock, NULL);
    pthread_cond_init(&p->wake, NULL);
    pthread_cond_init(&p->done, NULL);
    wanted = wanted < THREADS_MAX ? wanted : THREADS_MAX;
    while (p->worker_count < wanted &&
           pthread_create(&p->workers[p->worker_count], NULL, work, p) == 0) {
        p->worker_count++;
    }
    return p;
}

void pool_destroy(pool *p)
{
    if (p == NULL) {
        return;
    }
    pthread_mutex_lock(&p->lock);
    p->ending = 1;
    pthread_cond_broadcast(&p->wake);
    pthread_mutex_unlock(&p->lock);
    for (int i = 0; i < p->worker_count; i++) {
        pthread_join(p->workers[i], NULL);
    }
    pthread_cond_destroy(&p->done);
    pthread_cond_destroy(&p->wake);
    pthread_mutex_destroy(&p->lock);
    free(p);
}

void pool_for(pool *p, size_t count, sf_task_body body, void *context)
{
    pthread_mutex_lock(&p->lock);
    p->body = body;
    p->context = context;
    p->next = 0;
    p->count = count;
    pthread_cond_broadcast(&p->wake);
    take_part(p);
    while (p->under_way > 0) {
        pthread_cond_wait(&p->done, &p->lock);
    }
    p->next = p->count = 0;
    pthread_mutex_unlock(&p->lock);
}
