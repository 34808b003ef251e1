/* A crew of threads behind one mutex: a round number tells that there is work, a count of the busy
 * tells that it is done. */
#define _POSIX_C_SOURCE 200809L

#include "render/pool.h"

#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct member {
    glint_pool *pool;
    pthread_t thread;
    int worker;
} member;

struct glint_pool {
    pthread_mutex_t mutex;
    pthread_cond_t work, done;
    uint64_t round; /* of work given out so far */
    int busy;       /* members that have not finished this round */
    bool closing;
    glint_pool_task *task;
    void *context;
    int member_count; /* threads started: the workers less the caller */
    member members[];
};

static void *serve(void *argument)
{
    const member *self = argument;
    glint_pool *pool = self->pool;
    uint64_t served = 0;
    pthread_mutex_lock(&pool->mutex);
    for (;;) {
        while (pool->round == served && !pool->closing)
            pthread_cond_wait(&pool->work, &pool->mutex);
        if (pool->closing)
            break;
        served = pool->round;
        pthread_mutex_unlock(&pool->mutex);
        pool->task(pool->context, self->worker);
        pthread_mutex_lock(&pool->mutex);
        if (--pool->busy == 0)
            pthread_cond_signal(&pool->done);
    }
    pthread_mutex_unlock(&pool->mutex);
    return NULL;
}

/* Starts one more member with all signals blocked: they are the main thread's to handle. */
static int start_member(glint_pool *pool)
{
    sigset_t all, before;
    member *m = &pool->members[pool->member_count];
    m->pool = pool;
    m->worker = pool->member_count + 1;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const int error = pthread_create(&m->thread, NULL, serve, m);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (error == 0)
        pool->member_count++;
    return error;
}

static void do_nothing(void *context, int worker)
{
    (void)context;
    (void)worker;
}

glint_status glint_pool_create(int threads, glint_pool **pool, glint_error *err)
{
    const size_t members = (size_t)threads - 1;
    glint_pool *p = calloc(1, sizeof *p + members * sizeof p->members[0]);
    if (p == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for %d threads", threads);
    pthread_mutex_init(&p->mutex, NULL);
    pthread_cond_init(&p->work, NULL);
    pthread_cond_init(&p->done, NULL);
    for (int i = 1; i < threads; i++) {
        const int error = start_member(p);
        if (error != 0) {
            glint_pool_destroy(p);
            return glint_fail(err, GLINT_IO_ERROR, "cannot start thread %d of %d: %s", i + 1,
                              threads, strerror(error));
        }
    }
    glint_pool_run(p, do_nothing, NULL); /* back when all members are past their start */
    *pool = p;
    return GLINT_OK;
}

void glint_pool_destroy(glint_pool *pool)
{
    if (pool == NULL)
        return;
    pthread_mutex_lock(&pool->mutex);
    pool->closing = true;
    pthread_cond_broadcast(&pool->work);
    pthread_mutex_unlock(&pool->mutex);
    for (int i = 0; i < pool->member_count; i++)
        pthread_join(pool->members[i].thread, NULL);
    pthread_cond_destroy(&pool->done);
    pthread_cond_destroy(&pool->work);
    pthread_mutex_destroy(&pool->mutex);
    free(pool);
}

void glint_pool_run(glint_pool *pool, glint_pool_task *task, void *context)
{
    pthread_mutex_lock(&pool->mutex);
    pool->task = task;
    pool->context = context;
    pool->busy = pool->member_count;
    pool->round++;
    pthread_cond_broadcast(&pool->work);
    pthread_mutex_unlock(&pool->mutex);

    task(context, 0);

    pthread_mutex_lock(&pool->mutex);
    while (pool->busy > 0)
        pthread_cond_wait(&pool->done, &pool->mutex);
    pthread_mutex_unlock(&pool->mutex);
}
