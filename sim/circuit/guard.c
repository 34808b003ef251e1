/* A circuit of one's own that crashes, exits or never comes back; see guard.h. A watching thread
 * looks once a second for a thread that is in the same call of the model as the second before. */
#define _GNU_SOURCE /* sigaltstack */

#include "circuit/guard.h"

#include <pthread.h>
#include <signal.h>
#include <stdalign.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define THREADS_MAX  64 /* that are watched at once */
#define CACHE_LINE   64
#define MESSAGE      1024
#define SIGNAL_STACK 16384
#define BUSY_SECONDS 0.2 /* of processor time in a second: it does not wait */

/* Of a thread, in cache lines of its own. */
typedef struct place {
    alignas(CACHE_LINE) atomic_uint count; /* odd: it is in the model */
    atomic_bool is_taken;
    alignas(CACHE_LINE) unsigned char stack[SIGNAL_STACK]; /* of handlers: the crash may be that of
                                                            * its own */
} place;

static const struct {
    int number;
    const char *name;
} crashes[] = {
    {SIGSEGV, "segmentation fault"},
    {SIGBUS, "bus error"},
    {SIGFPE, "arithmetic error, such as a division by 0"},
    {SIGILL, "illegal instruction"},
    {SIGABRT, "abort()"},
};
#define CRASHES (sizeof crashes / sizeof crashes[0])

/* Of the process, as signal handlers are. The messages are written beforehand: a handler may not
 * format. */
static bool watching;
static atomic_bool over;
static place places[THREADS_MAX];
static pthread_key_t place_of_thread; /* given back when the thread ends */
static _Thread_local place *mine;
static char in_model[CRASHES][MESSAGE], elsewhere[CRASHES][MESSAGE], exited[MESSAGE],
    stuck[MESSAGE];

static _Noreturn void give_up(const char *message)
{
    const ssize_t written = write(STDERR_FILENO, message, strlen(message));
    (void)written;
    _exit(GLINT_GUARD_EXIT_STATUS);
}

static bool is_inside(void)
{
    return mine != NULL && atomic_load_explicit(&mine->count, memory_order_relaxed) % 2 == 1;
}

static void on_crash(int number)
{
    for (size_t i = 0; i < CRASHES; i++)
        if (crashes[i].number == number)
            give_up(is_inside() ? in_model[i] : elsewhere[i]);
}

static void on_exit_of_process(void)
{
    if (!atomic_load(&over))
        give_up(exited);
}

static double processor_seconds(void)
{
    struct timespec now = {0};
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void *watch(void *unused)
{
    unsigned last[THREADS_MAX] = {0};
    int seconds[THREADS_MAX] = {0};
    double before = processor_seconds();
    (void)unused;
    while (nanosleep(&(struct timespec){.tv_sec = 1}, NULL) == 0) {
        const double now = processor_seconds();
        const bool busy = now - before >= BUSY_SECONDS;
        before = now;
        for (int i = 0; i < THREADS_MAX; i++) {
            const unsigned count = atomic_load_explicit(&places[i].count, memory_order_relaxed);
            const bool same = count % 2 == 1 && count == last[i];
            seconds[i] = !same ? 0 : seconds[i] + busy;
            last[i] = count;
            if (seconds[i] >= GLINT_GUARD_SECONDS)
                give_up(stuck);
        }
    }
    return NULL;
}

static void write_messages(const char *directory)
{
    static const char hint[] = "gdb --args glint ... shows the line";
    for (size_t i = 0; i < CRASHES; i++) {
        (void)snprintf(in_model[i], MESSAGE, "glint: %.400s: the C model crashed: %s; %s\n",
                       directory, crashes[i].name, hint);
        (void)snprintf(elsewhere[i], MESSAGE,
                       "glint: %.400s: crashed in the description or in Glint itself: %s; %s\n",
                       directory, crashes[i].name, hint);
    }
    (void)snprintf(exited, MESSAGE,
                   "glint: %.400s: the C code called exit(), so there is no verdict\n", directory);
    (void)snprintf(stuck, MESSAGE,
                   "glint: %.400s: a call of the C model has not returned for %d s: it has an "
                   "endless loop\n",
                   directory, GLINT_GUARD_SECONDS);
}

/* A handler that is there already, as a sanitizer's, tells more. */
static void catch_crashes(void)
{
    struct sigaction action, present;
    memset(&action, 0, sizeof action);
    sigemptyset(&action.sa_mask);
    action.sa_handler = on_crash;
    action.sa_flags = SA_ONSTACK;
    for (size_t i = 0; i < CRASHES; i++)
        if (sigaction(crashes[i].number, NULL, &present) == 0 && present.sa_handler == SIG_DFL)
            (void)sigaction(crashes[i].number, &action, NULL);
}

/* Signals are for the other threads. */
static void start_watching(void)
{
    pthread_t thread;
    sigset_t all, before;
    sigfillset(&all);
    (void)pthread_sigmask(SIG_SETMASK, &all, &before);
    if (pthread_create(&thread, NULL, watch, NULL) == 0)
        (void)pthread_detach(thread);
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
}

/* A run starts threads anew for each setting; those that are gone must not keep the places. */
static void give_back(void *taken)
{
    place *const place = taken;
    stack_t present;
    if (sigaltstack(NULL, &present) == 0 && present.ss_sp == place->stack)
        (void)sigaltstack(&(stack_t){.ss_flags = SS_DISABLE}, NULL);
    atomic_store(&place->is_taken, false);
}

void glint_guard_begin(const char *directory)
{
    if (watching || pthread_key_create(&place_of_thread, give_back) != 0)
        return;
    write_messages(directory);
    catch_crashes();
    (void)atexit(on_exit_of_process);
    watching = true;
    start_watching();
}

void glint_guard_end(void)
{
    atomic_store(&over, true);
}

/* A thread that leaves signals to others would be ended by these without a handler. */
static void unblock_crashes(void)
{
    sigset_t all;
    sigemptyset(&all);
    for (size_t i = 0; i < CRASHES; i++)
        sigaddset(&all, crashes[i].number);
    (void)pthread_sigmask(SIG_UNBLOCK, &all, NULL);
}

/* A sanitizer's stack stays, as it wants to take it down itself. */
static void use_stack(place *place)
{
    const stack_t stack = {.ss_sp = place->stack, .ss_size = SIGNAL_STACK};
    stack_t present;
    if (sigaltstack(NULL, &present) == 0 && (present.ss_flags & SS_DISABLE) != 0)
        (void)sigaltstack(&stack, NULL);
}

static place *take_place(void)
{
    static place unwatched;
    int index = 0;
    unblock_crashes();
    while (index < THREADS_MAX && atomic_exchange(&places[index].is_taken, true))
        index++;
    if (index == THREADS_MAX)
        return &unwatched;
    use_stack(&places[index]);
    (void)pthread_setspecific(place_of_thread, &places[index]);
    return &places[index];
}

static void step(void)
{
    const unsigned count = atomic_load_explicit(&mine->count, memory_order_relaxed);
    atomic_store_explicit(&mine->count, count + 1, memory_order_relaxed);
}

void glint_guard_enter(void)
{
    if (!watching)
        return;
    if (mine == NULL)
        mine = take_place();
    step();
}

void glint_guard_leave(void)
{
    if (watching)
        step();
}
