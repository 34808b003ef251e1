/* A terminal of a test's own, for what a program shows only to people. Include it after cmocka.h,
 * scratch.h and child.h; the file that does defines _XOPEN_SOURCE 700 first. */
#ifndef GLINT_TESTS_TERMINAL_H
#define GLINT_TESTS_TERMINAL_H

#include <poll.h>

typedef struct terminal {
    int master;
    int held;       /* the other end, so that it stays while the program starts and ends */
    char name[128]; /* what the program opens */
} terminal;

static inline terminal terminal_open(void)
{
    terminal made;
    made.master = posix_openpt(O_RDWR | O_NOCTTY);
    assert_true(made.master >= 0);
    assert_int_equal(grantpt(made.master), 0);
    assert_int_equal(unlockpt(made.master), 0);
    (void)snprintf(made.name, sizeof made.name, "%s", ptsname(made.master));
    made.held = open(made.name, O_RDWR | O_NOCTTY);
    assert_true(made.held >= 0);
    return made;
}

/* Reads what is shown into `shown` until `text` is among it; fails the test when it does not come
 * within so many seconds, or not within `size` bytes. */
static inline void terminal_wait_for(const terminal *terminal, const char *text, double seconds,
                                     char *shown, size_t size)
{
    const double limit = child_seconds() + seconds;
    size_t count = 0;
    shown[0] = '\0';
    while (strstr(shown, text) == NULL) {
        struct pollfd wanted = {.fd = terminal->master, .events = POLLIN};
        if (child_seconds() > limit || count + 1 >= size) {
            fail_msg("the terminal shows \"%s\", not \"%s\"", shown, text);
        }
        if (poll(&wanted, 1, 100) == 1) {
            const ssize_t got = read(terminal->master, shown + count, size - 1 - count);
            assert_true(got > 0);
            count += (size_t)got;
            shown[count] = '\0';
        }
    }
}

static inline void terminal_close(terminal *terminal)
{
    close(terminal->held);
    close(terminal->master);
}

#endif
