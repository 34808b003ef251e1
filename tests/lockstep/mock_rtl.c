/* The wrapped functions; see mock_rtl.h. */
#include "mock_rtl.h"

#include <pthread.h>
#include <string.h>

const char mock_verilog[] = "a circuit of the test's own";
mock_rtl mock;

enum { CIRCUITS = 256 };
static const glint_rtl *mocked[CIRCUITS];
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

/* Replaces a circuit with `with`; NULL is a free slot. */
static bool replace(const glint_rtl *rtl, const glint_rtl *with)
{
    bool found = false;
    pthread_mutex_lock(&lock);
    for (int i = 0; i < CIRCUITS && !found; i++) {
        found = mocked[i] == rtl;
        if (found)
            mocked[i] = with;
    }
    pthread_mutex_unlock(&lock);
    return found;
}

static bool is_mocked(const glint_rtl *rtl)
{
    return rtl != NULL && replace(rtl, rtl);
}

glint_status __real_glint_rtl_open(const glint_setting *setting, glint_rtl_kind kind,
                                   glint_rtl **rtl, glint_error *err);
void __real_glint_rtl_destroy(glint_rtl *rtl);

glint_status __wrap_glint_rtl_open(const glint_setting *setting, glint_rtl_kind kind,
                                   glint_rtl **rtl, glint_error *err);
glint_status __wrap_glint_rtl_open(const glint_setting *setting, glint_rtl_kind kind,
                                   glint_rtl **rtl, glint_error *err)
{
    glint_setting real = *setting;
    const bool is_mock = real.verilog != NULL && strcmp(real.verilog, mock_verilog) == 0;
    if (is_mock)
        real.verilog = NULL;
    const glint_status status = __real_glint_rtl_open(&real, kind, rtl, err);
    if (status == GLINT_OK && is_mock) {
        if (!replace(NULL, *rtl))
            return glint_fail(err, GLINT_NO_MEMORY, "more circuits than the test has room for");
        if (mock.opened != NULL)
            mock.opened();
    }
    return status;
}

void __wrap_glint_rtl_destroy(glint_rtl *rtl);
void __wrap_glint_rtl_destroy(glint_rtl *rtl)
{
    if (rtl != NULL)
        (void)replace(rtl, NULL);
    __real_glint_rtl_destroy(rtl);
}

void __wrap_glint_rtl_clock(glint_rtl *rtl, const void *pins);
void __wrap_glint_rtl_clock(glint_rtl *rtl, const void *pins)
{
    (mock.clock != NULL && is_mocked(rtl) ? mock.clock : __real_glint_rtl_clock)(rtl, pins);
}

void __wrap_glint_rtl_read(const glint_rtl *rtl, uint64_t *words);
void __wrap_glint_rtl_read(const glint_rtl *rtl, uint64_t *words)
{
    (mock.read != NULL && is_mocked(rtl) ? mock.read : __real_glint_rtl_read)(rtl, words);
}

glint_status __wrap_glint_rtl_shade(glint_rtl *rtl, const glint_material *material,
                                    const glint_points *points, glint_error *err);
glint_status __wrap_glint_rtl_shade(glint_rtl *rtl, const glint_material *material,
                                    const glint_points *points, glint_error *err)
{
    return (mock.shade != NULL && is_mocked(rtl) ? mock.shade : __real_glint_rtl_shade)(
        rtl, material, points, err);
}
