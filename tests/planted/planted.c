/* The wrapped functions, and what the environment plants; see planted.h. */
#include "planted.h"

#include <pthread.h>
#include <stdlib.h>

#include "circuit/words.h"
#include "rtl/batch.h"

static uint64_t nothing(uint64_t clock)
{
    (void)clock;
    return 0;
}

planted plant = {
    .signal = PLANTED_NOWHERE, .inverted = nothing, .answer = PLANTED_NOWHERE, .asked = 0};

/* ld's names for the functions that are called, and for those that would have been. */
glint_status __real_glint_rtl_open(const glint_setting *setting, glint_rtl_kind kind,
                                   glint_rtl **rtl, glint_error *err);
glint_status __wrap_glint_rtl_open(const glint_setting *setting, glint_rtl_kind kind,
                                   glint_rtl **rtl, glint_error *err);
void __real_glint_rtl_destroy(glint_rtl *rtl);
void __wrap_glint_rtl_destroy(glint_rtl *rtl);
void __real_glint_rtl_read(const glint_rtl *rtl, uint64_t *words);
void __wrap_glint_rtl_read(const glint_rtl *rtl, uint64_t *words);
glint_status __real_glint_rtl_shade(glint_rtl *rtl, const glint_material *material,
                                    const glint_points *points, glint_error *err);
glint_status __wrap_glint_rtl_shade(glint_rtl *rtl, const glint_material *material,
                                    const glint_points *points, glint_error *err);
glint_status __real_glint_rtl_divide(glint_rtl *rtl, const glint_division *divisions, size_t count,
                                     glint_quotients *quotients, glint_error *err);
glint_status __wrap_glint_rtl_divide(glint_rtl *rtl, const glint_division *divisions, size_t count,
                                     glint_quotients *quotients, glint_error *err);

/* ---- Clock by clock -----------------------------------------------------------------------------
 */

/* Where the signals of each circuit that is open have their words: those of the whole process, from
 * whatever thread. */
typedef struct layout {
    const glint_rtl *rtl;
    int signals;
    int place[GLINT_SIGNAL_WORDS_MAX + 1];
    struct layout *next;
} layout;

static layout *layouts;
static pthread_mutex_t layouts_lock = PTHREAD_MUTEX_INITIALIZER;

glint_status __wrap_glint_rtl_open(const glint_setting *setting, glint_rtl_kind kind,
                                   glint_rtl **rtl, glint_error *err)
{
    const glint_status status = __real_glint_rtl_open(setting, kind, rtl, err);
    layout *new = status == GLINT_OK ? malloc(sizeof *new) : NULL;
    if (status != GLINT_OK)
        return status;
    if (new == NULL || !glint_signal_places(setting, new->place))
        abort();
    new->rtl = *rtl;
    new->signals = setting->circuit->signal_count(setting->values);
    (void)pthread_mutex_lock(&layouts_lock);
    new->next = layouts;
    layouts = new;
    (void)pthread_mutex_unlock(&layouts_lock);
    return status;
}

void __wrap_glint_rtl_destroy(glint_rtl *rtl)
{
    (void)pthread_mutex_lock(&layouts_lock);
    layout **at = &layouts;
    while (*at != NULL && (*at)->rtl != rtl)
        at = &(*at)->next;
    layout *gone = *at;
    if (gone != NULL)
        *at = gone->next;
    (void)pthread_mutex_unlock(&layouts_lock);
    free(gone);
    __real_glint_rtl_destroy(rtl);
}

/* A circuit stays open while it is read, and so does its layout stay. */
static const layout *layout_of(const glint_rtl *rtl)
{
    (void)pthread_mutex_lock(&layouts_lock);
    const layout *at = layouts;
    while (at != NULL && at->rtl != rtl)
        at = at->next;
    (void)pthread_mutex_unlock(&layouts_lock);
    if (at == NULL)
        abort();
    return at;
}

/* The clocks of a circuit count the reset of creation as well. */
void __wrap_glint_rtl_read(const glint_rtl *rtl, uint64_t *words)
{
    __real_glint_rtl_read(rtl, words);
    if (plant.signal == PLANTED_NOWHERE)
        return;
    const layout *layout = layout_of(rtl);
    const uint64_t inverted = plant.inverted(glint_rtl_clocks(rtl) - 1);
    for (int i = 0; i < layout->signals; i++)
        if (i == plant.signal || plant.signal == PLANTED_EVERYWHERE)
            words[layout->place[i]] ^= inverted;
}

/* ---- By runs ------------------------------------------------------------------------------------
 */

/* Where in a run of `count` the planted one is; −1: not in it. */
static long place_in(size_t count)
{
    const long first = plant.asked;
    plant.asked += (long)count;
    return plant.answer >= first && plant.answer < plant.asked ? plant.answer - first : -1;
}

glint_status __wrap_glint_rtl_shade(glint_rtl *rtl, const glint_material *material,
                                    const glint_points *points, glint_error *err)
{
    uint8_t *const colors[] = {
        [GLINT_ANSWER_R] = points->r, [GLINT_ANSWER_G] = points->g, [GLINT_ANSWER_B] = points->b};
    const glint_status status = __real_glint_rtl_shade(rtl, material, points, err);
    const long at = place_in(points->count);
    if (at >= 0 && plant.value != GLINT_ANSWER_W)
        colors[plant.value][at] ^= 1;
    else if (at >= 0 && points->w != NULL)
        points->w[at] ^= 1;
    return status;
}

glint_status __wrap_glint_rtl_divide(glint_rtl *rtl, const glint_division *divisions, size_t count,
                                     glint_quotients *quotients, glint_error *err)
{
    const glint_status status = __real_glint_rtl_divide(rtl, divisions, count, quotients, err);
    const long at = place_in(count);
    if (at >= 0)
        quotients[at].code[plant.value - GLINT_ANSWER_R] ^= 1;
    return status;
}

/* ---- In the command -----------------------------------------------------------------------------
 */

static uint64_t clock_named;

static uint64_t lowest_bit_once(uint64_t clock)
{
    return clock == clock_named;
}

static long named(const char *name)
{
    const char *given = getenv(name);
    return given != NULL ? strtol(given, NULL, 10) : PLANTED_NOWHERE;
}

__attribute__((constructor)) static void plant_what_is_named(void)
{
    clock_named = (uint64_t)named("GLINT_PLANTED_CLOCK");
    if (getenv("GLINT_PLANTED_SIGNAL") != NULL) {
        plant.signal = (int)named("GLINT_PLANTED_SIGNAL");
        plant.inverted = lowest_bit_once;
    }
    if (getenv("GLINT_PLANTED_ANSWER") != NULL) {
        plant.answer = named("GLINT_PLANTED_ANSWER");
        plant.value = (glint_answer_value)named("GLINT_PLANTED_VALUE");
    }
}
