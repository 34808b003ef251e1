/* A test's own terminal, for output that a program shows only to people. Include it after cmocka.h,
 * scratch.h and child.h; the file that does defines _XOPEN_SOURCE 700 first. */
#ifndef GLINT_TESTS_TERMINAL_H
#define GLINT_TESTS_TERMINAL_H

#include <poll.h>

typedef struct terminal {
    int master;
    int held;       /* the other end, so that it stays while the program starts and ends */
    char name[128]; /* what the program opens */
} terminal;

/* Skips the test if no terminal can be created, as in a container without /dev/pts. */
static inline terminal terminal_open(void)
{
    terminal made;
    made.master = posix_openpt(O_RDWR | O_NOCTTY);
    const char *name = made.master >= 0 && grantpt(made.master) == 0 && unlockpt(made.master) == 0
                           ? ptsname(made.master)
                           : NULL;
    made.held = name != NULL ? open(name, O_RDWR | O_NOCTTY) : -1;
    if (made.held < 0) {
        print_message("no terminal can be made here: %s\n", strerror(errno));
        skip();
    }
    (void)snprintf(made.name, sizeof made.name, "%s", name);
    return made;
}

/* Reads what `child` shows into `shown` until `text` is among it; fails the test when it ends
 * without, or shows more than `size` bytes. */
static inline void terminal_wait_for(const terminal *terminal, pid_t child, const char *text,
                                     char *shown, size_t size)
{
    const double start = child_seconds();
    size_t count = 0;
    shown[0] = '\0';
    while (strstr(shown, text) == NULL) {
        struct pollfd wanted = {.fd = terminal->master, .events = POLLIN};
        const bool ended = child_has_ended(child);
        const bool more = poll(&wanted, 1, ended ? 0 : 100) == 1;
        if ((ended && !more) || child_seconds() - start > child_patience || count + 1 >= size)
            fail_msg("the terminal shows \"%s\", not \"%s\"", shown, text);
        if (more) {
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
