/* Several circuits at a time, for who needs many. */
#define _POSIX_C_SOURCE 200809L

#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "rtl/build.h"

enum { THREADS_MAX = 64, MANY = 6 };

typedef struct crew {
    const glint_setting *const *missing;
    int count;
    glint_rtl_kind kind;
    const glint_rtl_build_control *control;
    pthread_mutex_t mutex; /* what follows */
    int next;
    glint_status status; /* of the first that failed */
    glint_error error;
} crew;

static bool is_stopped(const crew *c)
{
    return c->control->stop != NULL && *c->control->stop;
}

static void fail(crew *c, glint_status status, const char *text)
{
    if (c->status != GLINT_OK)
        return;
    c->status = status;
    (void)glint_fail(&c->error, status, "%s", text);
}

/* The next one to build; NULL: no more. */
static const glint_setting *take(crew *c)
{
    const glint_setting *taken = NULL;
    pthread_mutex_lock(&c->mutex);
    if (is_stopped(c))
        fail(c, GLINT_INTERRUPTED, "interrupted");
    if (c->status == GLINT_OK && c->next < c->count) {
        taken = c->missing[c->next++];
        if (c->control->show != NULL)
            c->control->show(c->control->context, c->next, c->count, taken);
    }
    pthread_mutex_unlock(&c->mutex);
    return taken;
}

static void *work(void *argument)
{
    crew *c = argument;
    const glint_setting *setting;
    while ((setting = take(c)) != NULL) {
        char *path;
        glint_error error = {""};
        const glint_status status = glint_rtl_build(setting, c->kind, &path, &error);
        free(path);
        if (status != GLINT_OK) {
            pthread_mutex_lock(&c->mutex);
            fail(c, status, error.text);
            pthread_mutex_unlock(&c->mutex);
        }
    }
    return NULL;
}

/* As many as are asked for, or there is work for; this thread is one of them. */
static int threads_of(const crew *c)
{
    long threads = c->control->threads > 0 ? c->control->threads : sysconf(_SC_NPROCESSORS_ONLN);
    if (threads > c->count)
        threads = c->count;
    return threads < 1 ? 1 : threads > THREADS_MAX ? THREADS_MAX : (int)threads;
}

/* With many to build, one thread precompiles the headers first; that this fails is no matter. */
static void build_missing(crew *c)
{
    pthread_t helper[THREADS_MAX];
    int helpers = 0;
    while (helpers < threads_of(c) - 1 && pthread_create(&helper[helpers], NULL, work, c) == 0)
        helpers++;
    if (c->count >= MANY && !is_stopped(c))
        (void)glint_rtl_precompile(c->kind, NULL);
    (void)work(c);
    for (int i = 0; i < helpers; i++)
        pthread_join(helper[i], NULL);
}

static glint_status find_missing(const glint_setting *settings, int count, glint_rtl_kind kind,
                                 const glint_setting **missing, int *missing_count,
                                 glint_error *err)
{
    glint_status status = GLINT_OK;
    *missing_count = 0;
    for (int i = 0; status == GLINT_OK && i < count; i++) {
        bool built;
        status = glint_rtl_is_built(&settings[i], kind, &built, err);
        if (status == GLINT_OK && !built)
            missing[(*missing_count)++] = &settings[i];
    }
    return status;
}

glint_status glint_rtl_build_all(const glint_setting *settings, int count, glint_rtl_kind kind,
                                 const glint_rtl_build_control *control, glint_error *err)
{
    const glint_setting **missing = calloc((size_t)count + 1, sizeof(const glint_setting *));
    if (missing == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a list of circuits");
    crew c = {.missing = missing, .kind = kind, .control = control, .status = GLINT_OK};
    glint_status status = find_missing(settings, count, kind, missing, &c.count, err);
    if (status == GLINT_OK) {
        pthread_mutex_init(&c.mutex, NULL);
        build_missing(&c);
        pthread_mutex_destroy(&c.mutex);
        if (c.status != GLINT_OK)
            status = glint_fail(err, c.status, "%s", c.error.text);
    }
    free(missing);
    return status;
}
