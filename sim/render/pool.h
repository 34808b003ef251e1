/* A fixed crew of threads that is called to work again and again: starting threads anew for each
 * frame would cost more than many a frame does. */
#ifndef GLINT_SIM_RENDER_POOL_H
#define GLINT_SIM_RENDER_POOL_H

#include "glint_status.h"

typedef struct glint_pool glint_pool;

/* What a worker is called for. worker: 0 … threads − 1. */
typedef void glint_pool_task(void *context, int worker);

/* A pool of `threads` workers (at least 1). The caller of glint_pool_run() is worker 0. Between
 * runs, from here on, the others sleep and hold no lock, so that the process may fork(): a thread
 * that is still starting may hold one of the allocator's (AddressSanitizer's, say), and the child
 * would wait for it for ever. */
glint_status glint_pool_create(int threads, glint_pool **pool, glint_error *err);
void glint_pool_destroy(glint_pool *pool); /* NULL is allowed */

/* Calls task(context, worker) once on every worker and returns when all have come back; whatever
 * they wrote is then visible to the caller. */
void glint_pool_run(glint_pool *pool, glint_pool_task *task, void *context);

#endif
