/* A crew of threads: whatever several threads do here, they do as a crew. It can be called to work
 * again and again: starting threads anew for each frame would cost more than many a frame does.
 *
 * Each worker takes its next piece of the work itself, from a counter they share. So all of it gets
 * done even where fewer threads can be had than were asked for, if need be by the caller alone. */
#ifndef GLINT_SIM_THREAD_CREW_H
#define GLINT_SIM_THREAD_CREW_H

#include "glint_status.h"

typedef struct glint_crew glint_crew;

/* What a worker is called for. worker: 0 … size − 1. */
typedef void glint_crew_task(void *context, int worker);

/* A crew of `threads` workers (at least 1), or of as many as can be had. The caller of
 * glint_crew_run() is worker 0. The others have all signals blocked. Between runs, from here on,
 * they sleep and hold no lock, so that the process may fork(): a thread that is still starting may
 * hold one of the allocator's (AddressSanitizer's, say), and the child would wait for it for ever.
 * GLINT_NO_MEMORY. */
glint_status glint_crew_create(int threads, glint_crew **crew, glint_error *err);
void glint_crew_destroy(glint_crew *crew); /* NULL is allowed */

int glint_crew_size(const glint_crew *crew);

/* Calls task(context, worker) once on every worker and returns when all have come back; whatever
 * they wrote is then visible to the caller. */
void glint_crew_run(glint_crew *crew, glint_crew_task *task, void *context);

/* The three together: a crew that works once. */
glint_status glint_crew_once(int threads, glint_crew_task *task, void *context, glint_error *err);

#endif
