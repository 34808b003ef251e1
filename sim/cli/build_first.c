/* Builds a command's circuits up front and shows progress; see build_first.h. */
#include "cli/build_first.h"

#include "cli/output.h"
#include "rtl/build.h"

static void show(void *context, int index, int count, const glint_setting *setting)
{
    (void)setting;
    glint_progress_update(context, (uint64_t)index, (uint64_t)count);
}

glint_status glint_build_first(const char *command, const glint_setting *settings, int count,
                               glint_rtl_kind kind, int threads, glint_error *err)
{
    glint_progress progress;
    glint_error built;
    const glint_rtl_build_control control = {
        .threads = threads, .stop = glint_stop_flag(), .show = show, .context = &progress};
    glint_progress_begin(&progress, command, "circuits to build");
    const glint_status status = glint_rtl_build_all(settings, count, kind, &control, &built);
    glint_progress_end(&progress);
    return status == GLINT_INTERRUPTED ? glint_fail(err, GLINT_INTERRUPTED, "interrupted")
                                       : GLINT_OK;
}
