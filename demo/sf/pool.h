// SPDX-License-Identifier: MIT
// Threads for the library's parallel_for hook.

#ifndef DEMO_SF_POOL_H
#define DEMO_SF_POOL_H

#include <sf/base.h>

typedef struct pool pool;

// A pool that works with `threads` threads, the caller's among them; 0 takes one for each
// processor. NULL when there would be no second one, which is no failure.
pool *pool_create(int threads);
void pool_destroy(pool *p);

// body(context, i) for each i below count; returns when all are done. Not to be called from a body.
void pool_for(pool *p, size_t count, sf_task_body body, void *context);

#endif
