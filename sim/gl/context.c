/* Opens libEGL and makes a context; see context.h. Nothing is linked: every function, EGL's own
 * too, is asked of eglGetProcAddress(). */
#define _POSIX_C_SOURCE 200809L
#define EGL_NO_PLATFORM_SPECIFIC_TYPES

#include "gl/context.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#define INSTALL "install libegl1 and libgl1-mesa-dri"

/* X(NAME in the name of the type, Name) */
#define EGL_FUNCTIONS(X)                                                                           \
    X(BINDAPI, BindAPI)                                                                            \
    X(CREATECONTEXT, CreateContext)                                                                \
    X(DESTROYCONTEXT, DestroyContext)                                                              \
    X(INITIALIZE, Initialize)                                                                      \
    X(MAKECURRENT, MakeCurrent)                                                                    \
    X(TERMINATE, Terminate)                                                                        \
    X(GETPLATFORMDISPLAYEXT, GetPlatformDisplayEXT)

struct glint_gl_context {
    void *library;
#define FUNCTION(NAME, Name) PFNEGL##NAME##PROC Name;
    EGL_FUNCTIONS(FUNCTION)
#undef FUNCTION
    EGLDisplay display;
    EGLContext context;
    glint_gl gl;
};

/* Of a leak checker, where the program is built with one. What Mesa and LLVM keep until the process
 * ends is allocated in between, by code that is unloaded before the checker looks, so that no list
 * of exceptions could name it. */
extern void __lsan_disable(void) __attribute__((weak));
extern void __lsan_enable(void) __attribute__((weak));

static void check_leaks(bool on)
{
    if (on && __lsan_enable != NULL)
        __lsan_enable();
    else if (!on && __lsan_disable != NULL)
        __lsan_disable();
}

static glint_status missing(const char *what, glint_error *err)
{
    return glint_fail(err, GLINT_IO_ERROR, "backend gl: %s: " INSTALL, what);
}

/* Of Mesa, which reads them when the display is opened; what is set already stays. */
static void set_environment(int threads)
{
    char count[16]; /* 0: no thread but the caller's */
    (void)snprintf(count, sizeof count, "%d", threads > 1 ? threads : 0);
    (void)setenv("LIBGL_ALWAYS_SOFTWARE", "true", 0);
    (void)setenv("LP_NUM_THREADS", count, 0);
    (void)setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
    (void)setenv("EGL_LOG_LEVEL", "fatal", 0); /* what fails is said by us */
}

static PFNEGLGETPROCADDRESSPROC load(glint_gl_context *c)
{
    PFNEGLGETPROCADDRESSPROC find = NULL;
    c->library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    void *symbol = c->library != NULL ? dlsym(c->library, "eglGetProcAddress") : NULL;
    /* ISO C has no conversion from an object's address to a function's. */
    _Static_assert(sizeof symbol == sizeof find, "as POSIX requires");
    memcpy(&find, &symbol, sizeof find);
    return find;
}

static bool find_egl(glint_gl_context *c, PFNEGLGETPROCADDRESSPROC find)
{
#define FIND(NAME, Name) c->Name = (PFNEGL##NAME##PROC)find("egl" #Name);
    EGL_FUNCTIONS(FIND)
#undef FIND
#define IS_THERE(NAME, Name) &&c->Name != NULL
    return true EGL_FUNCTIONS(IS_THERE);
#undef IS_THERE
}

static bool find_gl(glint_gl *gl, PFNEGLGETPROCADDRESSPROC find)
{
#define FIND(NAME, Name) gl->Name = (PFNGL##NAME##PROC)find("gl" #Name);
    GLINT_GL_FUNCTIONS(FIND)
#undef FIND
#define IS_THERE(NAME, Name) &&gl->Name != NULL
    return true GLINT_GL_FUNCTIONS(IS_THERE);
#undef IS_THERE
}

static glint_status make_current(glint_gl_context *c, glint_error *err)
{
    static const EGLint wanted[] = {
        EGL_CONTEXT_MAJOR_VERSION,
        3,
        EGL_CONTEXT_MINOR_VERSION,
        3,
        EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
        EGL_NONE,
    };
    EGLint major, minor;
    c->display = c->GetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
    if (c->display == EGL_NO_DISPLAY || !c->Initialize(c->display, &major, &minor)) {
        c->display = EGL_NO_DISPLAY;
        return missing("EGL finds no driver that renders without a display", err);
    }
    if (c->BindAPI(EGL_OPENGL_API))
        c->context = c->CreateContext(c->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (c->context == EGL_NO_CONTEXT ||
        !c->MakeCurrent(c->display, EGL_NO_SURFACE, EGL_NO_SURFACE, c->context))
        return missing("EGL gives no context of OpenGL 3.3", err);
    return GLINT_OK;
}

static glint_status open_context(glint_gl_context *c, glint_error *err)
{
    const PFNEGLGETPROCADDRESSPROC find = load(c);
    if (find == NULL)
        return missing("libEGL.so.1 is missing", err);
    if (!find_egl(c, find))
        return missing("libEGL.so.1 lacks a function", err);
    const glint_status status = make_current(c, err);
    if (status != GLINT_OK)
        return status;
    return find_gl(&c->gl, find) ? GLINT_OK : missing("OpenGL lacks a function", err);
}

glint_status glint_gl_context_create(int threads, glint_gl_context **context, glint_error *err)
{
    glint_gl_context *c = calloc(1, sizeof *c);
    if (c == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a context of OpenGL");
    check_leaks(false);
    set_environment(threads);
    const glint_status status = open_context(c, err);
    if (status != GLINT_OK) {
        glint_gl_context_destroy(c);
        return status;
    }
    *context = c;
    return GLINT_OK;
}

/* The library stays loaded: what it leaves behind at exit refers to it. */
void glint_gl_context_destroy(glint_gl_context *context)
{
    if (context == NULL)
        return;
    if (context->display != EGL_NO_DISPLAY) {
        (void)context->MakeCurrent(context->display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                   EGL_NO_CONTEXT);
        if (context->context != EGL_NO_CONTEXT)
            (void)context->DestroyContext(context->display, context->context);
        (void)context->Terminate(context->display);
    }
    check_leaks(true);
    free(context);
}

const glint_gl *glint_gl_of(const glint_gl_context *context)
{
    return &context->gl;
}
