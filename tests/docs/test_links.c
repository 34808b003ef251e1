/* Each link of README.md and docs/ leads to a file, and to a heading of it where it names one. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include <ctype.h>

#include "pages.h"

/* The anchor of a heading, as GitHub makes it: letters in lower case, digits, - and _; a blank is
 * a hyphen, and all else is left out. */
static void anchor_of(const char *heading, char *anchor, size_t size)
{
    size_t length = 0;
    for (; *heading != '\0' && *heading != '\n' && length + 1 < size; heading++) {
        const unsigned char c = (unsigned char)*heading;
        if (isalnum(c) || c >= 0x80 || c == '-' || c == '_')
            anchor[length++] = (char)tolower(c);
        else if (c == ' ')
            anchor[length++] = '-';
    }
    anchor[length] = '\0';
}

static bool has_heading(const char *path, const char *wanted)
{
    char anchor[256];
    bool found = false;
    char *text = scratch_read(path, NULL);
    for (const char *line = text; line != NULL && !found;) {
        if (*line == '#') {
            anchor_of(line + strspn(line, "# "), anchor, sizeof anchor);
            found = strcmp(anchor, wanted) == 0;
        }
        line = strchr(line, '\n');
        line = line != NULL ? line + 1 : NULL;
    }
    free(text);
    return found;
}

/* target: what stands between the parentheses of a link on the page. */
static bool leads_somewhere(const char *page, const char *target)
{
    char path[512];
    const char *slash = strrchr(page, '/');
    const char *hash = strchr(target, '#');
    const int file = hash != NULL ? (int)(hash - target) : (int)strlen(target);
    const int folder = slash != NULL ? (int)(slash - page) + 1 : 0;
    if (file > 0)
        (void)snprintf(path, sizeof path, "%.*s%.*s", folder, page, file, target);
    else
        (void)snprintf(path, sizeof path, "%s", page);
    return access(path, F_OK) == 0 && (hash == NULL || has_heading(path, hash + 1));
}

static int links_of(const char *page, char *text)
{
    int faults = 0;
    for (const char *at = strstr(text, "]("); at != NULL; at = strstr(at + 1, "](")) {
        char target[256];
        (void)snprintf(target, sizeof target, "%.*s", (int)strcspn(at + 2, ") \n"), at + 2);
        if (strncmp(target, "http", 4) != 0 && !leads_somewhere(page, target)) {
            print_message("%s: %s leads nowhere\n", page, target);
            faults++;
        }
    }
    return faults;
}

static void every_link_leads_somewhere(void **state)
{
    (void)state;
    assert_int_equal(on_every_page(links_of), 0);
}

static void broken_links_are_seen(void **state)
{
    (void)state;
    char text[] =
        "[a](absent.md) [b](README.md#absent) [c](README.md#two-commands) [d](#two-commands)";
    assert_int_equal(links_of("README.md", text), 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_link_leads_somewhere),
        cmocka_unit_test(broken_links_are_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
