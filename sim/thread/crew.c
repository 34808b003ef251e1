/* A crew of threads behind one mutex: a round number tells that there is work, a count of the busy
 * tells that it is done. */
#define _POSIX_C_SOURCE 200809L

#include "thread/crew.h"

#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

typedef struct member {
    glint_crew *crew;
    pthread_t thread;
    int worker;
} member;

struct glint_crew {
    pthread_mutex_t mutex;
    pthread_cond_t work, done;
    uint64_t round; /* of work given out so far */
    int busy;       /* members that have not finished this round */
    bool closing;
    glint_crew_task *task;
    void *context;
    int member_count; /* threads started: the workers less the caller */
    member members[];
};

static void *serve(void *argument)
{
    const member *self = argument;
    glint_crew *crew = self->crew;
    uint64_t served = 0;
    pthread_mutex_lock(&crew->mutex);
    for (;;) {
        while (crew->round == served && !crew->closing)
            pthread_cond_wait(&crew->work, &crew->mutex);
        if (crew->closing)
            break;
        served = crew->round;
        pthread_mutex_unlock(&crew->mutex);
        crew->task(crew->context, self->worker);
        pthread_mutex_lock(&crew->mutex);
        if (--crew->busy == 0)
            pthread_cond_signal(&crew->done);
    }
    pthread_mutex_unlock(&crew->mutex);
    return NULL;
}

/* Starts one more member with all signals blocked: they are the main thread's to handle. */
static bool start_member(glint_crew *crew)
{
    sigset_t all, before;
    member *m = &crew->members[crew->member_count];
    m->crew = crew;
    m->worker = crew->member_count + 1;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const int error = pthread_create(&m->thread, NULL, serve, m);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return error == 0;
}

static void do_nothing(void *context, int worker)
{
    (void)context;
    (void)worker;
}

glint_status glint_crew_create(int threads, glint_crew **crew, glint_error *err)
{
    const size_t members = (size_t)threads - 1;
    glint_crew *c = calloc(1, sizeof *c + members * sizeof c->members[0]);
    if (c == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for %d threads", threads);
    pthread_mutex_init(&c->mutex, NULL);
    pthread_cond_init(&c->work, NULL);
    pthread_cond_init(&c->done, NULL);
    while (c->member_count < threads - 1 && start_member(c))
        c->member_count++;
    glint_crew_run(c, do_nothing, NULL); /* back when all members are past their start */
    *crew = c;
    return GLINT_OK;
}

void glint_crew_destroy(glint_crew *crew)
{
    if (crew == NULL)
        return;
    pthread_mutex_lock(&crew->mutex);
    crew->closing = true;
    pthread_cond_broadcast(&crew->work);
    pthread_mutex_unlock(&crew->mutex);
    for (int i = 0; i < crew->member_count; i++)
        pthread_join(crew->members[i].thread, NULL);
    pthread_cond_destroy(&crew->done);
    pthread_cond_destroy(&crew->work);
    pthread_mutex_destroy(&crew->mutex);
    free(crew);
}

void glint_crew_run(glint_crew *crew, glint_crew_task *task, void *context)
{
    pthread_mutex_lock(&crew->mutex);
    crew->task = task;
    crew->context = context;
    crew->busy = crew->member_count;
    crew->round++;
    pthread_cond_broadcast(&crew->work);
    pthread_mutex_unlock(&crew->mutex);

    task(context, 0);

    pthread_mutex_lock(&crew->mutex);
    while (crew->busy > 0)
        pthread_cond_wait(&crew->done, &crew->mutex);
    pthread_mutex_unlock(&crew->mutex);
}

int glint_crew_size(const glint_crew *crew)
{
    return crew->member_count + 1;
}

glint_status glint_crew_once(int threads, glint_crew_task *task, void *context, glint_error *err)
{
    glint_crew *crew;
    const glint_status status = glint_crew_create(threads, &crew, err);
    if (status != GLINT_OK)
        return status;
    glint_crew_run(crew, task, context);
    glint_crew_destroy(crew);
    return GLINT_OK;
}
