/* A tool that is started by a thread of a crew, which blocks all signals, can be ended all the
 * same: by Ctrl-C in the terminal, and by whoever waits for it. */
#define _POSIX_C_SOURCE 200809L

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "rtl/command.h"
#include "thread/crew.h"

enum { WORKERS = 2 };

static void run_tool(void *context, int worker)
{
    static const char *const tool[] = {"sh", "-c", "kill -INT $$; exit 3", NULL};
    glint_status *ended = context;
    bool success;
    ended[worker] = glint_command_run(tool, NULL, &success, NULL, NULL);
}

static void a_tool_obeys_signals_whoever_starts_it(void **state)
{
    (void)state;
    glint_status ended[WORKERS] = {GLINT_OK, GLINT_OK};
    glint_error err = {""};
    (void)signal(SIGINT, SIG_DFL); /* a shell's background job begins with it ignored */
    assert_int_equal(glint_crew_once(WORKERS, run_tool, ended, &err), GLINT_OK);
    for (int i = 0; i < WORKERS; i++)
        assert_int_equal(ended[i], GLINT_INTERRUPTED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_tool_obeys_signals_whoever_starts_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
