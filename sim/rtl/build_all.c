/* Builds several circuits in parallel. */
#define _POSIX_C_SOURCE 200809L

#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "rtl/build.h"
#include "thread/crew.h"

enum { THREADS_MAX = 64, MANY = 6 };

typedef struct order {
    const glint_setting *const *missing;
    int count;
    glint_rtl_kind kind;
    const glint_rtl_build_control *control;
    pthread_mutex_t mutex; /* what follows */
    int next;
    glint_status status; /* of the first that failed */
    glint_error error;
} order;

static bool is_stopped(const order *o)
{
    return o->control->stop != NULL && *o->control->stop;
}

static void fail(order *o, glint_status status, const char *text)
{
    if (o->status != GLINT_OK)
        return;
    o->status = status;
    (void)glint_fail(&o->error, status, "%s", text);
}

/* The next one to build; NULL: no more. */
static const glint_setting *take(order *o)
{
    const glint_setting *taken = NULL;
    pthread_mutex_lock(&o->mutex);
    if (is_stopped(o))
        fail(o, GLINT_INTERRUPTED, "interrupted");
    if (o->status == GLINT_OK && o->next < o->count) {
        taken = o->missing[o->next++];
        if (o->control->show != NULL)
            o->control->show(o->control->context, o->next, o->count, taken);
    }
    pthread_mutex_unlock(&o->mutex);
    return taken;
}

static void build_some(order *o)
{
    const glint_setting *setting;
    while ((setting = take(o)) != NULL) {
        char *path;
        glint_error error = {""};
        const glint_status status = glint_rtl_build(setting, o->kind, &path, &error);
        free(path);
        if (status != GLINT_OK) {
            pthread_mutex_lock(&o->mutex);
            fail(o, status, error.text);
            pthread_mutex_unlock(&o->mutex);
        }
    }
}

/* As many threads as requested or useful, including this one. */
static int threads_of(const order *o)
{
    long threads = o->control->threads > 0 ? o->control->threads : sysconf(_SC_NPROCESSORS_ONLN);
    if (threads > o->count)
        threads = o->count;
    return threads < 1 ? 1 : threads > THREADS_MAX ? THREADS_MAX : (int)threads;
}

/* With many to build, one thread precompiles the headers first; failure does not matter. */
static void work(void *context, int worker)
{
    order *o = context;
    if (worker == 0 && o->count >= MANY && !is_stopped(o))
        (void)glint_rtl_precompile(o->kind, NULL);
    build_some(o);
}

static glint_status build_missing(order *o, glint_error *err)
{
    pthread_mutex_init(&o->mutex, NULL);
    const glint_status status = glint_crew_once(threads_of(o), work, o, err);
    pthread_mutex_destroy(&o->mutex);
    if (status == GLINT_OK && o->status != GLINT_OK)
        return glint_fail(err, o->status, "%s", o->error.text);
    return status;
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
    order o = {.missing = missing, .kind = kind, .control = control, .status = GLINT_OK};
    glint_status status = find_missing(settings, count, kind, missing, &o.count, err);
    if (status == GLINT_OK)
        status = build_missing(&o, err);
    free(missing);
    return status;
}
